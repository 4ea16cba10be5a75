"""The control column: every value of the projection, as a slider and as a number.

    user -> row.edited(value) -> write(current, value) -> a new Projection -> controls.edited
                                 ProjectionError       -> a sentence at the row, nothing else

Each row is bound to the model by two functions, `read` and `write`, in the tables of `Controls`;
rows that show one value in several ways (fov and focal length, orbit and vectors) are nothing
but several such pairs. What is folded is neither read nor written until it is opened.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Literal, TypeAlias

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QResizeEvent
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QScrollArea,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.projection import (
    BETWEEN,
    FINITE_NUMBER,
    LARGEST,
    Camera,
    Orbit,
    Orthographic,
    Perspective,
    Projection,
    ProjectionError,
    focal_length_35mm,
    fov_x_from_fov_y,
    fov_y_from_focal_length_35mm,
)
from widgets.animation import AnimationBar
from widgets.messages import field_name, seen_from, sentence
from widgets.rows import Choice, ChoiceRow, Linear, Log, NumberRow, Row, Scale, align, short_text

Read: TypeAlias = Callable[[Projection], Any]
Write: TypeAlias = Callable[[Projection, Any], Projection]
Part: TypeAlias = Literal["lens", "camera", "image_size", "depth"]
PARTS: tuple[Part, ...] = ("lens", "camera", "image_size", "depth")

RIGHT_MARGIN_PX = 4
ASPECTS = {"1:1": (1, 1), "4:3": (4, 3), "16:9": (16, 9)}


@dataclass(frozen=True)
class Binding:
    """A row and the value of the model that it shows.

    Parameters
    ----------
    row : Row
    field : str
        The model's name of the value.
    part : str
        The field of `Projection` that it belongs to: another one cannot cure its error.
    read, write : callable
        The value out of a projection, and a projection with another value.
    """

    row: Row
    field: str
    part: Part
    read: Read
    write: Write


class Section(QWidget):
    """A heading that folds what is below it: by a click, Space, Enter, or as in a tree, ← and →.
    """

    toggled = Signal(bool)

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.heading = QToolButton()
        self.heading.setText(title)
        self.heading.setAutoRaise(True)
        self.heading.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.heading.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.heading.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.heading.setAccessibleName(title)
        font = self.heading.font()
        font.setBold(True)
        self.heading.setFont(font)
        self.heading.installEventFilter(self)
        self.heading.clicked.connect(lambda: self.set_open(not self.is_open))
        self.body = QWidget()
        self.rows = QVBoxLayout(self.body)
        self.rows.setContentsMargins(6, 0, 2, 6)
        self.rows.setSpacing(3)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.heading)
        layout.addWidget(self.body)
        self.set_open(True)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Take the heading's keys before the button makes arrows move the focus."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            key, keys = event.key(), Qt.Key
            if key in (keys.Key_Return, keys.Key_Enter):
                self.set_open(not self.is_open)
                return True
            if key in (keys.Key_Left, keys.Key_Right):
                if self.is_open != (key == keys.Key_Right):
                    self.set_open(key == keys.Key_Right)
                return True
        return super().eventFilter(watched, event)

    @property
    def is_open(self) -> bool:
        """Whether the rows below the heading are shown."""
        return not self.body.isHidden()

    def set_open(self, is_open: bool) -> None:
        """Fold or unfold."""
        self.body.setVisible(is_open)
        self.heading.setArrowType(Qt.ArrowType.DownArrow if is_open else Qt.ArrowType.RightArrow)
        self.heading.setToolTip(self.tr("Fold") if is_open else self.tr("Unfold"))
        self.heading.setAccessibleDescription(self.tr("unfolded") if is_open else self.tr("folded"))
        self.toggled.emit(is_open)


class Controls(QScrollArea):
    """The column of controls.

    Attributes
    ----------
    rows : dict of str to Row
        Every row by the name of what it shows: ``"near"``, ``"fov_y_deg"``, ``"eye_x"``, ...
    sections : dict of str to Section
        ``"lens"``, ``"camera"``, ``"image"``, ``"depth"``, ``"animation"``.
    animation : AnimationBar
        Its cameras come out of `edited`; its gestures are its own.
    """

    edited = Signal(object)
    """The user made this `Projection`: once per action."""
    gesture_started = Signal()
    gesture_finished = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._projection = Projection()
        self._defaults = self._projection
        self._size = 10.0
        # The angles behind the camera: read back from it they would carry rounding noise, and
        # straight above the target azimuth and roll could no longer be told apart.
        self._orbit = (self._projection.camera, self._projection.camera.orbit)
        self._bindings: dict[str, Binding] = {}
        self.sections: dict[str, Section] = {}
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setAccessibleName(self.tr("Controls"))
        self._column = QWidget()
        self._layout = QVBoxLayout(self._column)
        self._layout.setSpacing(0)
        self._reserve_bar()
        self._make_lens()
        self._make_camera()
        self._make_image()
        self._make_depth()
        self._make_animation()
        self._layout.addStretch(1)
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

    def show_projection(self, projection: Projection) -> None:
        """Show a projection; never answered by a signal.

        Parameters
        ----------
        projection : Projection
        """
        before = self._projection
        if projection is before or projection == before:
            return
        self._projection = projection
        changed = {
            part for part in PARTS if getattr(projection, part) != getattr(before, part)
        }
        for binding in self._bindings.values():
            if binding.part in changed or (binding.row.error and binding.row.at_rest):
                binding.row.clear_error()
        if projection.lens.kind != before.lens.kind:
            self._fit_lens_rows()
        if "image_size" in changed:
            changed.add("lens")  # two of its three angles have the aspect in them
        self._show_rows(changed)
        self.animation.show_camera(projection.camera)

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
        for name in ("left", "right", "bottom", "top"):
            self._number(name).setScale(Linear.about(0.0, 2.0 * size))
        self._fit_lens_rows()
        for name, binding in self._bindings.items():
            binding.row.setDefault(binding.read(self._as_shown_by(name, defaults)))
        self.animation.set_scene(size, camera.target)
        self.animation.show_camera(self._projection.camera)
        self._show_rows()

    # -- the sections

    def _make_lens(self) -> None:
        section = self._section("lens", self.tr("Lens"))
        kinds = (
            Choice(
                "perspective",
                self.tr("perspective"),
                self.tr("Rays meet in the eye: what is farther looks smaller. A frustum."),
            ),
            Choice(
                "orthographic",
                self.tr("orthographic"),
                self.tr("Rays are parallel: distance does not change size. A box."),
            ),
        )
        self._choice(
            section, "kind", "lens",
            self.tr("Kind of projection. What lies at the target keeps its size when it changes."),
            kinds, lambda p: p.lens.kind, lambda p, kind: p.with_lens(kind),
        )  # fmt: skip
        degrees, fov = self.tr("degrees"), Linear(1.0, 179.0, 0.5)
        self._row(
            section, "fov_y_deg", "lens",
            self.tr("Angle between the bottom and the top of the frustum, as seen from the eye."),
            fov, "°", degrees, _lens_field("fov_y_deg"), _with_lens_field("fov_y_deg"),
        )  # fmt: skip
        self._row(
            section, "fov_x_deg", "lens",
            self.tr("Angle between the left and the right of the frustum, as seen from the eye:"
                    " the vertical field of view and the aspect in one number."),
            fov, "°", degrees, _fov_x, _with_fov_x,
        )  # fmt: skip
        self._number("fov_y_deg").below = self._number("fov_x_deg").below = 180.0
        self._row(
            section, "focal_length_mm", "lens",
            self.tr("Focal length of a 35 mm film camera (36 × 24 mm) with the same diagonal"
                    " field of view: below 35 is wide angle, above 70 telephoto."),
            Log(5.0, 2000.0), self.tr("mm"), self.tr("millimetres"),
            _focal_length, _with_focal_length,
        )  # fmt: skip
        sides = {
            "left": self.tr("Where the box begins in x of view space."),
            "right": self.tr("Where the box ends in x of view space."),
            "bottom": self.tr("Where the box begins in y of view space."),
            "top": self.tr("Where the box ends in y of view space."),
        }
        for side, tip in sides.items():
            self._length(
                section, side, "lens", tip, _lens_field(side), _with_lens_field(side)
            )  # fmt: skip
        keeps = (
            Choice(
                "stretch",
                self.tr("stretch"),
                self.tr("The window fills the image; circles may become ellipses."),
            ),
            Choice(
                "x",
                self.tr("keep x, fit y"),
                self.tr("The y range grows or shrinks about its centre (lecture 000, variant X)."),
            ),
            Choice(
                "y",
                self.tr("keep y, fit x"),
                self.tr("The x range grows or shrinks about its centre (lecture 000, variant Y)."),
            ),
        )
        self._choice(
            section, "keep", "lens",
            self.tr("How the window follows the aspect of the image."),
            keeps, _lens_field("keep"), _with_lens_field("keep"),
        )  # fmt: skip
        self._length(
            section, "near", "lens",
            self.tr("Distance from the eye to the near plane: nothing nearer is drawn. The closer"
                    " to 0, the coarser the depth buffer."),
            _lens_field("near"), _with_lens_field("near"),
        )  # fmt: skip
        self._length(
            section, "far", "lens",
            self.tr("Distance from the eye to the far plane: nothing farther is drawn. A"
                    " perspective lens also takes inf (∞), at the slider's end."),
            _lens_field("far"), _with_lens_field("far"),
        )  # fmt: skip

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
        degrees = self.tr("degrees")
        orbit = {
            "azimuth_deg": (
                self.tr("Walks round the target: 0 is on its +z side, 90 on its +x side."),
                Linear(-180.0, 180.0, 1.0),
            ),
            "elevation_deg": (
                self.tr("Height above the target's horizon as an angle: 90 looks straight down."),
                Linear(-90.0, 90.0, 1.0),
            ),
            "distance": (self.tr("From the target to the eye."), None),
            "roll_deg": (
                self.tr("Turns the camera about its view direction n, clockwise for who holds it."),
                Linear(-180.0, 180.0, 1.0),
            ),
        }
        for name, (tip, scale) in orbit.items():
            read = partial(self._read_orbit, name)
            write = partial(self._write_orbit, name)
            if scale is None:
                self._length(section, name, "camera", tip, read, write)
            else:
                self._row(section, name, "camera", tip, scale, "°", degrees, read, write)
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
                key = f"{vector}_{letter}"
                if vector == "up":
                    row = NumberRow(name, tip, Linear(-1.0, 1.0, 0.01))
                else:
                    row = self._length_row(name, tip)
                if axis == 0 and vector != "eye":
                    row.setContentsMargins(0, 4, 0, 0)
                self._bind(section, key, row, vector, "camera", read, write)

    def _make_image(self) -> None:
        section = self._section("image", self.tr("Image"))
        for axis, (name, tip) in enumerate(
            (
                ("width", self.tr("Width of the picture in pixels.")),
                ("height", self.tr("Height of the picture in pixels.")),
            )
        ):
            self._row(
                section, name, "image_size", tip, Linear(10.0, 4000.0, 10.0),
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
        self._choice(
            section, "aspect", "image_size",
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
        self._choice(
            section, "depth", "depth",
            self.tr("Which z the near and the far plane have in the NDC cube."),
            choices, lambda p: p.depth, lambda p, depth: replace(p, depth=depth),
            name=self.tr("NDC z"),
        )  # fmt: skip

    def _make_animation(self) -> None:
        section = self._section("animation", self.tr("Animation"))
        self.animation = AnimationBar()
        self.animation.edited.connect(self._walked)
        section.rows.addWidget(self.animation)

    def _section(self, key: str, title: str) -> Section:
        self.sections[key] = section = Section(title)
        section.toggled.connect(partial(self._folded, section))
        self._layout.addWidget(section)
        return section

    def _folded(self, section: Section, is_open: bool) -> None:
        if is_open:
            self._show_rows()
            # After the layout has made room: what opens below the fold comes into view.
            QTimer.singleShot(0, self, partial(self._bring_into_view, section))

    def _bring_into_view(self, section: Section) -> None:
        if section.is_open and section.isVisible():
            QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
            self.ensureWidgetVisible(section, 0, 0)
            self.ensureWidgetVisible(section.heading, 0, 0)

    def _row(
        self, section: Section, key: str, part: Part, tip: str, scale: Scale, unit: str,
        unit_tip: str, read: Read, write: Write,
    ) -> None:  # fmt: skip
        row = NumberRow(field_name(key), tip, scale, unit, unit_tip)
        self._bind(section, key, row, key, part, read, write)

    def _length_row(self, name: str, tip: str) -> NumberRow:
        unit, unit_tip = self.tr("units"), self.tr("world units")
        return NumberRow(name, tip, Log(1.0, 10.0), unit, unit_tip)  # set_scene scales it

    def _length(
        self, section: Section, key: str, part: Part, tip: str, read: Read, write: Write
    ) -> None:
        row = self._length_row(field_name(key), tip)
        self._bind(section, key, row, key, part, read, write)

    def _choice(
        self, section: Section, key: str, part: Part, tip: str, choices: Sequence[Choice],
        read: Read, write: Write, *, buttons: bool = False, name: str = "",
    ) -> None:  # fmt: skip
        row = ChoiceRow(name or field_name(key), tip, choices, buttons=buttons)
        self._bind(section, key, row, key, part, read, write)

    def _bind(
        self, section: Section, key: str, row: Row, field: str, part: Part, read: Read,
        write: Write,
    ) -> None:  # fmt: skip
        self._bindings[key] = binding = Binding(row, field, part, read, write)
        section.rows.addWidget(row)
        if isinstance(row, NumberRow):
            row.limits = partial(self._limits, binding)
        row.edited.connect(partial(self._edit, binding))
        row.gesture_started.connect(partial(self._gesture_started, row))
        row.gesture_finished.connect(self.gesture_finished)

    def _number(self, key: str) -> NumberRow:
        row = self._bindings[key].row
        assert isinstance(row, NumberRow)
        return row

    # -- edits

    def _edit(self, binding: Binding, value: Any) -> None:
        try:
            projection = binding.write(self._projection, value)
        except ProjectionError as error:
            seen = seen_from(binding.field, binding.row.name, value, error)
            if isinstance(value, float) and math.isinf(value) and seen.bound == FINITE_NUMBER:
                seen = self._limit(binding, value) or seen
            binding.row.show_error(sentence(_as_shown(seen, value)))
            # After the layout has made room for it, and only if it is still there.
            QTimer.singleShot(0, self, partial(self._reveal, binding.row))
        else:
            self._adopt(projection)

    def _limit(self, binding: Binding, value: float) -> ProjectionError | None:
        """The model's own limit on the side of an infinite value, if it has one there."""
        probe, orbit = math.copysign(LARGEST, value), self._orbit
        try:
            binding.write(self._projection, probe)
        except ProjectionError as error:
            seen = seen_from(binding.field, binding.row.name, probe, error)
            if seen.field == binding.field and seen.value == probe:
                return ProjectionError(seen.field, value, seen.bound, *seen.limits)
        finally:
            self._orbit = orbit
        return None

    def _limits(self, binding: Binding) -> str:
        """What the model asks of a number in this row."""
        clauses = []
        for value in (-math.inf, math.inf):
            error = self._limit(binding, value)
            if error is not None:
                bound = QCoreApplication.translate("ProjectionError", error.bound)
                clauses.append(bound.format(*_as_shown(error, value).limits))
        return "; ".join(dict.fromkeys(clauses))

    def _adopt(self, projection: Projection) -> None:
        if projection != self._projection:
            self.show_projection(projection)
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

    def _read_orbit(self, name: str, projection: Projection) -> float:
        camera, orbit = self._orbit
        if projection.camera == camera:
            return float(getattr(orbit, name))
        return _tidy(getattr(projection.camera.orbit, name))

    def _write_orbit(self, name: str, projection: Projection, value: float) -> Projection:
        orbit = self._orbit_of(projection.camera)._replace(**{name: value})
        camera = Camera.from_orbit(projection.camera.target, orbit)
        self._orbit = camera, orbit
        return replace(projection, camera=camera)

    def _orbit_of(self, camera: Camera) -> Orbit:
        return self._orbit[1] if camera == self._orbit[0] else camera.orbit

    # -- shown

    def _in_use(self, key: str) -> bool:
        """Whether a row belongs to the lens and the camera mode at hand."""
        lens = self._projection.lens
        if key in ("fov_y_deg", "fov_x_deg", "focal_length_mm"):
            return isinstance(lens, Perspective)
        if key in ("left", "right", "bottom", "top", "keep"):
            return isinstance(lens, Orthographic)
        if self._bindings[key].part == "camera":
            orbits: bool = self.camera_mode.value() == "orbit"
            return (key in Orbit._fields) == orbits
        return True

    def _show_rows(self, parts: Collection[str] = PARTS) -> None:
        """Show the rows of these parts of the projection, of those that are in use and unfolded."""
        sections = {"image_size": "image"}
        for key, binding in self._bindings.items():
            if binding.part not in parts:
                continue
            in_use = self._in_use(key)
            if binding.row.isHidden() == in_use:
                binding.row.setVisible(in_use)
            if in_use and self.sections[sections.get(binding.part, binding.part)].is_open:
                binding.row.setValue(binding.read(self._projection))

    def _fit_lens_rows(self) -> None:
        """Near and far are even on a slider for a box, logarithmic for a frustum."""
        size = self._size
        defaults = self._as_shown_by("near", self._defaults).lens
        for name in ("near", "far"):
            row = self._number(name)
            if isinstance(self._projection.lens, Orthographic):
                row.setScale(Linear.about(0.0, 10.0 * size))
            else:
                row.setScale(Log(1e-6 * size, 1e9 * size, infinite=name == "far"))
            row.setDefault(getattr(defaults, name))

    def _as_shown_by(self, key: str, projection: Projection) -> Projection:
        """The projection with a lens that has the value of this row."""
        if key in ("fov_y_deg", "fov_x_deg", "focal_length_mm"):
            return projection.with_lens("perspective")
        if key in ("left", "right", "bottom", "top", "keep"):
            return projection.with_lens("orthographic")
        if key in ("near", "far"):
            return projection.with_lens(self._projection.lens.kind)
        return projection

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


# --------------------------------------------------------------------------- reading and writing


def _as_shown(error: ProjectionError, value: Any) -> ProjectionError:
    """An error whose numbers are as short as the fields show them, but for the edited one."""
    refused = error.value
    if isinstance(refused, tuple):
        refused = tuple(part if part == value else float(f"{part:.6g}") for part in refused)
    limits = (_short_limit(limit, value) for limit in error.limits)
    return ProjectionError(error.field, refused, error.bound, *limits)


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


def _lens_field(field: str) -> Read:
    return lambda projection: getattr(projection.lens, field)


def _with_lens_field(field: str) -> Write:
    def write(projection: Projection, value: Any) -> Projection:
        return replace(projection, lens=replace(projection.lens, **{field: value}))

    return write


def _tidy(number: float) -> float:
    """A number that was computed from the one that is kept, without its rounding noise.

    What was typed as 60 comes back as 60, not as 60.00000000000001.
    """
    return float(f"{number:.13g}")


def _fov_x(projection: Projection) -> float:
    assert isinstance(projection.lens, Perspective)
    fov_x_deg = fov_x_from_fov_y(projection.lens.fov_y_deg, projection.aspect)
    tidy_deg = _tidy(fov_x_deg)
    return tidy_deg if tidy_deg < 180.0 else fov_x_deg


def _focal_length(projection: Projection) -> float:
    assert isinstance(projection.lens, Perspective)
    return _tidy(focal_length_35mm(projection.lens.fov_y_deg, projection.aspect))


def _with_fov_x(projection: Projection, fov_x_deg: float) -> Projection:
    if not math.isfinite(fov_x_deg):
        raise ProjectionError("fov_x_deg", fov_x_deg, FINITE_NUMBER)
    if not 0.0 < fov_x_deg < 180.0:
        raise ProjectionError("fov_x_deg", fov_x_deg, BETWEEN, 0, 180)
    fov_y_deg = fov_x_from_fov_y(fov_x_deg, 1.0 / projection.aspect)
    return _with_lens_field("fov_y_deg")(projection, fov_y_deg)


def _with_focal_length(projection: Projection, focal_length_mm: float) -> Projection:
    fov_y_deg = fov_y_from_focal_length_35mm(focal_length_mm, projection.aspect)
    return _with_lens_field("fov_y_deg")(projection, fov_y_deg)


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
