"""The control column: every value of the projection, as a slider and as a number.

    user -> row.edited(value) -> write(current, value) -> a new Projection -> controls.edited
                                 Refusal       -> a sentence at the row, nothing else

Each row is bound to the model by a `Binding` of its section. What is folded is neither read nor
written until it is opened.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import replace
from functools import partial
from typing import Any

from PySide6.QtCore import QEvent, QObject, QPoint, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QGridLayout,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from app.lecture.highlight import NOTHING, Highlight, made_of
from app.model.projection import FINITE_NUMBER, LARGEST, Camera, Orbit, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import is_free
from widgets.controls.animation import AnimationBar
from widgets.controls.lens_controls import LensControls
from widgets.parts.fields import (
    ROW_GAP_PX,
    Choice,
    ChoiceRow,
    Linear,
    Log,
    NumberRow,
    Row,
    Scale,
    align,
    short_text,
)
from widgets.parts.focus import FocusRing
from widgets.parts.messages import field_name, seen_from, sentence, translated
from widgets.parts.panel import EVERYTHING, Changed, Shown
from widgets.parts.section import PARTS, Binding, Section, Typed

RIGHT_MARGIN_PX = 4
_ABOUT: dict[str, tuple[str, ...]] = {
    **dict.fromkeys(("azimuth_deg", "elevation_deg", "distance"), ("eye",)),
    **dict.fromkeys(("roll_deg", "up"), ("up", "u", "v")),
    **dict.fromkeys(("fov_y_deg", "fov_x_deg", "focal_length_mm", "e", "fx", "fy"), ("fov",)),
    "window_right": ("left", "right"),
    "window_top": ("bottom", "top"),
    **dict.fromkeys(("receding", "receding_deg"), ("alpha_deg", "beta_deg")),
    **dict.fromkeys(("width", "height", "aspect"), ("image",)),
    "kind": (),
    "preset": (),
}
"""What a row is about, by `app.lecture.highlight`'s names, if its field's name is not all of it."""
_MAKES: dict[str, tuple[str, ...]] = {
    **dict.fromkeys(("eye", "target", "azimuth_deg", "elevation_deg"), ("u", "v", "n")),
    "fov_y_deg": ("bottom", "top"),
    "fov_x_deg": ("left", "right"),
    **dict.fromkeys(("focal_length_mm", "e"), ("left", "right", "bottom", "top")),
}
"""What is made of a row's value besides; pointing at that points at the row as well."""

ASPECTS = {"1:1": (1, 1), "4:3": (4, 3), "16:9": (16, 9)}


class Controls(QScrollArea):
    """The column of controls.

    Attributes
    ----------
    rows : dict of str to Row
        Every row by the name of what it shows: ``"near"``, ``"fov_y_deg"``, ``"eye_x"``, ...
    sections : dict of str to Section
        ``"lens"``, ``"calibrated"``, ``"camera"``, ``"image"``, ``"depth"``, ``"animation"``.
    animation : AnimationBar
        Its cameras come out of `edited`; its gestures are its own.
    """

    concerns = EVERYTHING
    edited = Signal(object)
    """The user made this `Projection`: once per action."""
    gesture_started = Signal()
    gesture_finished = Signal()
    gesture_abandoned = Signal()
    highlighted = Signal(str, object)
    """The name of a row that the user is at, and the `Highlight` it draws; `NOTHING` after it."""

    def __init__(self) -> None:
        super().__init__()
        self._projection = Projection()
        self._defaults = self._projection
        self._size = 10.0
        self._mattering: set[str] = set()
        self.sections: dict[str, Section] = {}
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setAccessibleName(self.tr("Controls"))
        self._column = QWidget()
        self._layout = QVBoxLayout(self._column)
        self._layout.setSpacing(0)
        FocusRing(self)
        self._reserve_bar()
        self._lens = LensControls(
            self._section("lens", self.tr("Lens")),
            self._section("calibrated", self.tr("Calibrated camera (OpenCV K)")),
        )
        self.sections["calibrated"].set_open(False)
        self._make_camera()
        self._make_image()
        self._make_depth()
        self._make_animation()
        self._layout.addStretch(1)
        self._bindings: dict[str, Binding] = {}
        for section in self.sections.values():
            self._bindings |= section.bindings
            section.toggled.connect(partial(self._folded, section))
        for key, binding in self._bindings.items():
            self._connect(binding)
            about = _about(binding)
            binding.row.highlighted.connect(partial(self._highlighted, key, about))
        self.rows: dict[str, Row] = {
            "camera_mode": self.camera_mode,
            **{name: binding.row for name, binding in self._bindings.items()},
        }
        self.setWidget(self._column)
        self._align()
        self.set_scene(self._size, self._defaults)

    # -- the interface

    @property
    def projection(self) -> Projection:
        """What the column shows."""
        return self._projection

    def take(self, shown: Shown, changed: Changed) -> None:
        """Show another projection, and fit the sliders to another scene; answered by no signal."""
        if changed & {"scene", "view"}:
            self.set_scene(shown.scene.size, shown.scene.start)
        self._show(shown.projection)

    def _show(self, projection: Projection) -> None:
        before, changed = self._projection, set[str]()
        if projection is not before and projection != before:
            changed = {part for part in PARTS if getattr(projection, part) != getattr(before, part)}
        for binding in self._bindings.values():
            if binding.part in changed or (binding.row.error and not binding.row.in_hand):
                binding.row.clear_error()
        if not changed:
            return
        self._projection = projection
        if "image_size" in changed:
            changed.add("lens")  # most measures of a field of view have the aspect in them
        if projection.lens.kind != before.lens.kind:
            self._frame_rows()
            self._lens.fit(projection, self._size, self._defaults)
        elif "lens" in changed:
            self._lens.follow(projection)
        self._show_rows(changed)
        if changed & {"lens", "camera"}:
            self._enable_camera(projection)
        if "camera" in changed:
            self.animation.show_camera(projection.camera)

    def _enable_camera(self, projection: Projection) -> None:
        """No camera has a view matrix of its own: what moves one has nothing to move then."""
        lens = projection.lens
        free = lens.own_view is not None
        why = self.tr("The view matrix was typed, and no camera has it: undo, or choose a lens.")
        for key in ("camera", "animation"):
            self.sections[key].body.setEnabled(not free)
            self.sections[key].body.setToolTip(why if free else "")
        if free:
            self.animation.pause()

    def set_scene(self, size: float, defaults: Projection) -> None:
        """Fit the sliders to a scene, and say what a reset goes back to.

        Parameters
        ----------
        size : float
            Diagonal of the scene's bounds, world units.
        defaults : Projection
            The camera and lens with which the scene opens.
        """
        self._size, self._defaults = size, defaults
        camera = defaults.camera
        reach = 2.0 * max(size, camera.distance)
        for axis, letter in enumerate("xyz"):
            about_target = Linear.about(camera.target[axis], reach)
            self._number(f"eye_{letter}").setScale(about_target)
            self._number(f"target_{letter}").setScale(about_target)
        self._number("distance").setScale(Log(1e-2 * size, 1e3 * size))
        self._lens.fit(self._projection, size, defaults)
        for binding in self._bindings.values():
            if binding.part != "lens":
                binding.row.setDefault(binding.read(defaults))
        self.animation.set_scene(size, camera)
        self.animation.show_camera(self._projection.camera)
        self._show_rows()

    def show_highlight(self, highlighted: Highlight) -> None:
        """Mark the rows that are about what is highlighted, or that it is made of."""
        shown = made_of(highlighted)
        for binding in self._bindings.values():
            names = _about(binding).union(_MAKES.get(binding.field, ()))
            binding.row.set_marked(bool(names & shown))

    def _highlighted(self, key: str, about: Highlight, is_highlighted: bool) -> None:
        self.highlighted.emit(key, about if is_highlighted else NOTHING)

    def bring_to_front(self, paths: Collection[str]) -> None:
        """Point out the controls that matter for the scene, and no others.

        Parameters
        ----------
        paths : collection of str
            Of the document: ``lens.near``, ``camera.eye``. Their sections are opened, the first
            of them is scrolled to, and all are framed until the next call, while there is a lens.
        """
        self._mattering = {name for path in paths for name in _names(path)}
        marked = []
        for section in self.sections.values():
            for key, binding in section.bindings.items():
                if self._matters(key, binding):
                    marked.append(binding.row)
                    if not section.is_open:
                        section.set_open(True)
        self._frame_rows()
        if marked:
            # After the layout has made room; a row that is not in use now may have none.
            QTimer.singleShot(0, self, partial(self._scroll_to, marked))

    def _matters(self, key: str, binding: Binding) -> bool:
        return key in self._mattering or binding.field in self._mattering

    def _frame_rows(self) -> None:
        """Frame what matters for the scene; of a free matrix it shows nothing that could."""
        free = is_free(self._projection)
        for key, binding in self._bindings.items():
            _frame(binding.row, self._matters(key, binding) and not free)

    def _scroll_to(self, rows: list[Row]) -> None:
        _lay_out()
        for row in reversed([row for row in rows if row.isVisible()]):
            self.ensureWidgetVisible(row, 0, 4)

    # -- the sections

    def _make_camera(self) -> None:
        section = self._section("camera", self.tr("Camera"))
        self.camera_mode = ChoiceRow(
            self.tr("Set by"),
            self.tr("Two views of the same camera."),
            (
                Choice("orbit", self.tr("Orbit"), self.tr("Angles and distance about the target.")),
                Choice("vectors", self.tr("Vectors"), self.tr("Eye, target and up.")),
            ),
            buttons=True,
        )
        self.camera_mode.setDefault("orbit")
        self.camera_mode.edited.connect(lambda _mode: self._show_rows())
        section.rows.addWidget(self.camera_mode)
        degrees, lengths = self.tr("degrees"), (self.tr("units"), self.tr("world units"))
        orbit: dict[str, tuple[str, Scale]] = {
            "azimuth_deg": (
                self.tr("Walks round the target: 0 is on its +z side, 90 on its +x side."),
                Linear(-180.0, 180.0, 1.0),
            ),
            "elevation_deg": (
                self.tr("Height above the target's horizon as an angle: 90 looks straight down."),
                Linear(-90.0, 90.0, 1.0),
            ),
            "distance": (self.tr("From the target to the eye."), Log(1.0, 10.0)),
            "roll_deg": (
                self.tr(
                    "Turns the camera about −n, its view direction; clockwise for who holds it."
                ),
                Linear(-180.0, 180.0, 1.0),
            ),
        }
        typed = Typed(lambda p: p.camera, lambda p: p.camera.orbit, _with_orbit)
        for name, (tip, scale) in orbit.items():
            unit, unit_tip = ("°", degrees) if name.endswith("_deg") else lengths
            section.add_number(name, "camera", tip, scale, unit, unit_tip, *typed.access(name))
        vectors = {
            "eye": self.tr("The centre of projection, in world coordinates."),
            "target": self.tr("The point that the camera looks at, in world coordinates."),
            "up": self.tr("The direction that shall be vertical in the picture (the lectures'"
                          " view-up vector); its length does not matter."),
        }  # fmt: skip
        for vector, tip in vectors.items():
            for axis, letter in enumerate("xyz"):
                name = self.tr("{0} {1}").format(field_name(vector), letter)
                read = partial(_read_component, vector, axis)
                write = partial(_write_component, vector, axis)
                scale = Linear(-1.0, 1.0, 0.01)  # of the others the scene is yet to scale it
                unit, unit_tip = ("", "") if vector == "up" else lengths
                row = section.add_number(
                    f"{vector}_{letter}", "camera", tip, scale, unit, unit_tip, read, write,
                    name=name, field=vector,
                )  # fmt: skip
                if axis == 0 and vector != "eye":
                    row.setContentsMargins(0, 4, 0, 0)

    def _make_image(self) -> None:
        section = self._section("image", self.tr("Image"))
        for axis, (name, tip) in enumerate(
            (
                ("width", self.tr("Width of the picture in pixels.")),
                ("height", self.tr("Height of the picture in pixels.")),
            )
        ):
            section.add_number(
                name, "image_size", tip, Linear(10.0, 4000.0, 10.0),
                self.tr("px"), self.tr("pixels"),
                partial(_side, axis), partial(_with_side, axis),
            )  # fmt: skip
        choices = tuple(
            Choice(
                text,
                text,
                self.tr("Width becomes {0}/{1} of the height, in whole pixels.").format(*ratio),
            )
            for text, ratio in ASPECTS.items()
        )
        section.add_choice(
            "aspect", "image_size",
            self.tr("Width over height. The height stays, and with it the vertical field of view:"
                    " the picture gains or loses at its sides."),
            choices, _aspect, _with_aspect, buttons=True, name=self.tr("Aspect"),
        )  # fmt: skip

    def _make_depth(self) -> None:
        section = self._section("depth", self.tr("Depth range"))
        choices = (
            Choice("opengl", self.tr("OpenGL: −1 to 1"), self.tr("Near goes to −1, far to 1.")),
            Choice("direct3d", self.tr("Direct3D: 0 to 1"), self.tr("Near goes to 0, far to 1.")),
            Choice(
                "reversed",
                self.tr("reversed: 1 to 0"),
                self.tr("Near goes to 1, far to 0: floats are densest where depth needs them."),
            ),
        )
        section.add_choice(
            "depth", "depth",
            self.tr("Which z the near and the far plane have in the NDC cube."),
            choices, lambda p: p.depth, lambda p, depth: p.with_depth(depth),
            name=self.tr("NDC z"),
        )  # fmt: skip

    def _make_animation(self) -> None:
        section = self._section("animation", self.tr("Animation"))
        self.animation = AnimationBar()
        self.animation.edited.connect(self._walked)
        section.rows.addWidget(self.animation)

    def _section(self, key: str, title: str) -> Section:
        self.sections[key] = section = Section(title)
        self._layout.addWidget(section)
        return section

    def _folded(self, section: Section, is_open: bool) -> None:
        if is_open:
            self._show_rows()
            # After the layout has made room: what opens below the fold comes into view.
            QTimer.singleShot(0, self, partial(self._bring_into_view, section))

    def _bring_into_view(self, section: Section) -> None:
        if section.is_open and section.isVisible():
            _lay_out()
            self.ensureWidgetVisible(section, 0, 0)
            self.ensureWidgetVisible(section.heading, 0, 0)

    def _connect(self, binding: Binding) -> None:
        row = binding.row
        if isinstance(row, NumberRow):
            row.limits = partial(self._limits, binding)
            row.accepts = partial(self._accepts, binding)
        row.edited.connect(partial(self._edit, binding))
        row.gesture_started.connect(partial(self._gesture_started, row))
        row.gesture_finished.connect(self.gesture_finished)
        row.gesture_abandoned.connect(self.gesture_abandoned)

    def _number(self, key: str) -> NumberRow:
        row = self._bindings[key].row
        assert isinstance(row, NumberRow)
        return row

    # -- edits

    def _edit(self, binding: Binding, value: Any) -> None:
        before = self._projection
        try:
            projection = binding.write(before, value)
        except Refusal as error:
            seen = seen_from(binding.field, binding.row.name, value, error)
            general = seen.bound == FINITE_NUMBER or seen.limits in ((LARGEST,), (-LARGEST,))
            if isinstance(value, float) and abs(value) > LARGEST and general:
                seen = self._limit(binding, value) or seen
            binding.row.show_error(sentence(_as_shown(seen, value)))
            # After the layout has made room for it, and only if it is still there.
            QTimer.singleShot(0, self, partial(self._reveal, binding.row))
        else:
            if binding.keep is not None:
                binding.keep(before, value, projection)
            if projection.lens.kind != before.lens.kind:
                place = binding.row.mapTo(self.viewport(), QPoint())
                QTimer.singleShot(0, self, partial(self._hold, binding.row, place))
            self._adopt(projection)

    def _hold(self, row: Row, place: QPoint) -> None:
        """Scroll a row back to its place, after the rows of another lens have moved it."""
        if row.isVisible():
            _lay_out()
            moved = row.mapTo(self.viewport(), QPoint()) - place
            bar = self.verticalScrollBar()
            bar.setValue(bar.value() + moved.y())

    def _limit(self, binding: Binding, value: float) -> Refusal | None:
        """The model's own limit on the side of a value beyond all, if it has one there."""
        probe = math.copysign(LARGEST, value)
        try:
            binding.write(self._projection, probe)
        except Refusal as error:
            seen = seen_from(binding.field, binding.row.name, probe, error)
            if seen.field == binding.field and seen.value == probe:
                return Refusal(seen.field, value, seen.bound, *seen.limits)
        return None

    def _accepts(self, binding: Binding, value: float) -> bool:
        try:
            binding.write(self._projection, value)
        except Refusal:
            return False
        return True

    def _limits(self, binding: Binding) -> str:
        """What the model asks of a number in this row."""
        clauses = []
        for value in (-math.inf, math.inf):
            error = self._limit(binding, value)
            if error is not None:
                bound = translated(error.bound)
                clauses.append(bound.format(*_as_shown(error, value).limits))
        return "; ".join(dict.fromkeys(clauses))

    def _adopt(self, projection: Projection) -> None:
        if projection != self._projection:
            self._show(projection)
            self.edited.emit(projection)

    def _walked(self, camera: Camera) -> None:
        self._adopt(replace(self._projection, camera=camera))

    def _gesture_started(self, row: Row) -> None:
        for other in self.rows.values():
            if other is not row:
                other.finish_gesture()  # a burst of keys elsewhere that has not gone quiet yet
        self.gesture_started.emit()

    def _reveal(self, row: Row) -> None:
        if row.error and row.isVisible():
            self.ensureWidgetVisible(row, 0, 4)

    # -- shown

    def _in_use(self, key: str, binding: Binding) -> bool:
        """Whether a row belongs to the lens and the camera mode at hand."""
        if binding.lenses:
            return self._projection.lens.kind in binding.lenses
        if binding.part == "camera":
            orbits: bool = self.camera_mode.value() == "orbit"
            return (key in Orbit._fields) == orbits
        return True

    def _show_rows(self, parts: Collection[str] = PARTS) -> None:
        """Show the rows of these parts of the projection, of those that are in use and unfolded."""
        for section in self.sections.values():
            is_open = section.is_open
            for key, binding in section.bindings.items():
                if binding.part not in parts:
                    continue
                in_use = self._in_use(key, binding)
                if binding.row.isHidden() == in_use:
                    binding.row.setVisible(in_use)
                if in_use and is_open:
                    binding.row.setValue(binding.read(self._projection))

    def _align(self) -> None:
        align([*self.rows.values(), *self.animation.rows])

    def _reserve_bar(self) -> None:
        """Keep the scroll bar's room free while there is none: nothing shifts under the hand."""
        shown = self.width() - self.viewport().width()
        free = max(0, self._bar_width() - shown)
        self._layout.setContentsMargins(0, 0, RIGHT_MARGIN_PX + free, 0)

    def _bar_width(self) -> int:
        return self.verticalScrollBar().sizeHint().width()

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._reserve_bar()  # first: the rows keep their width and wrap no text again
        super().resizeEvent(event)

    def minimumSizeHint(self) -> QSize:
        rows = self._column.minimumSizeHint().width() - self._layout.contentsMargins().right()
        return QSize(rows + RIGHT_MARGIN_PX + self._bar_width(), 120)

    def sizeHint(self) -> QSize:
        return QSize(max(320, self.minimumSizeHint().width()), 600)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()  # a scroll area does not pass its widget's least width on
        return super().eventFilter(watched, event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange) and self.widget():
            self._align()


# --------------------------------------------------------------------------- pointing out

_BY_ORBIT = {
    "eye": ("azimuth_deg", "elevation_deg", "distance"),
    "up": ("roll_deg",),
}
"""How else the camera's vectors are set."""


def _names(path: str) -> tuple[str, ...]:
    """What the rows of a document's path are called, or the fields that they belong to."""
    name = path.rpartition(".")[2]
    return (name, *_BY_ORBIT.get(name, ()))


def _frame(row: Row, framed: bool) -> None:
    """Put a frame in the accent colour round a row, or take it away."""
    if bool(row.property("framed")) != framed:
        row.setProperty("framed", framed)
        row.setAttribute(Qt.WidgetAttribute.WA_StyledBackground, framed)
        kind = type(row).__name__
        sheet = f"{kind} {{ border: 2px solid palette(highlight); border-radius: 4px; }}"
        row.setStyleSheet(sheet if framed else "")
        grid = row.layout()
        assert isinstance(grid, QGridLayout)
        if framed:  # what the frame takes at both sides, the gaps give: the column stays as wide
            grid.setContentsMargins(3, 2, 3, 2)
            grid.setHorizontalSpacing(ROW_GAP_PX - 2)
        else:
            grid.setContentsMargins(0, 0, 0, 0)
            grid.setHorizontalSpacing(ROW_GAP_PX)


# --------------------------------------------------------------------------- reading and writing


def _about(binding: Binding) -> Highlight:
    return frozenset(_ABOUT.get(binding.field, (binding.field,)))


def _lay_out() -> None:
    """Let all layouts take their new sizes now: rows, sections, column, scroll area."""
    for _ in range(4):  # each tells only the one around it
        QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)


def _as_shown(error: Refusal, value: Any) -> Refusal:
    """An error whose numbers are as short as the fields show them, but for the edited one."""
    refused = error.value
    if isinstance(refused, tuple):
        refused = tuple(part if part == value else float(f"{part:.6g}") for part in refused)
    limits = (_short_limit(limit, value) for limit in error.limits)
    return Refusal(error.field, refused, error.bound, *limits)


def _short_limit(limit: Any, value: Any) -> Any:
    """A limit as its field shows it, unless the value lies between that and the limit itself."""
    try:
        number = float(limit)
        shown = float(short_text(number))
    except ValueError:  # words, or infinity
        return limit
    if isinstance(value, str) or (value > number, value < number) != (value > shown, value < shown):
        return limit
    return short_text(number)


def _with_orbit(projection: Projection, orbit: Orbit) -> Projection:
    return replace(projection, camera=Camera.from_orbit(projection.camera.target, orbit))


def _read_component(vector: str, axis: int, projection: Projection) -> float:
    return float(getattr(projection.camera, vector)[axis])


def _write_component(vector: str, axis: int, projection: Projection, value: float) -> Projection:
    components = list(getattr(projection.camera, vector))
    components[axis] = value
    return replace(projection, camera=replace(projection.camera, **{vector: tuple(components)}))


def _side(axis: int, projection: Projection) -> int:
    return projection.image_size[axis]


def _with_side(axis: int, projection: Projection, side_px: float) -> Projection:
    size: list[Any] = list(projection.image_size)
    size[axis] = int(side_px) if float(side_px).is_integer() else side_px
    return replace(projection, image_size=tuple(size))


def _aspect(projection: Projection) -> str | None:
    width, height = projection.image_size
    for text, (across, down) in ASPECTS.items():
        if width == round(height * across / down):
            return text
    return None


def _with_aspect(projection: Projection, text: str) -> Projection:
    across, down = ASPECTS[text]
    height = projection.image_size[1]
    width = max(1, round(height * across / down))
    return replace(projection, image_size=(width, height))
