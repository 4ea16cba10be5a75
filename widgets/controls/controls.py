"""The dock: the scene, then every value of the projection, as a slider and as a number.

    user -> row.edited(value) -> write(current, value) -> a new Projection -> controls.edited
                                 Refusal       -> a sentence at the row, nothing else

Each row is bound to the model by a `Binding` of its part. What is folded is neither read nor
written until it is opened. A control stands once: the scene's card borrows the rows that matter
for the scene, and what is looked for is shown where it is.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import replace
from functools import partial
from typing import Any

from PySide6.QtCore import QEvent, QObject, QPoint, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QFontInfo, QPalette, QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QWidget

from app.drawings.style import Style
from app.lecture.highlight import NOTHING, Highlight, made_of
from app.model.projection import FINITE_NUMBER, LARGEST, LENSES, Camera, Orbit, Projection
from app.model.refusal import Refusal
from widgets.controls.animation import AnimationBar
from widgets.controls.finder import Known, SearchBox, find, known
from widgets.controls.lens_controls import LensControls
from widgets.controls.scene_card import SceneCard
from widgets.parts.fields import Choice, Linear, Log, NumberRow, Row, RowHolder, Scale, short_text
from widgets.parts.focus import FocusRing, lay_out
from widgets.parts.layouts import FREE, in_column
from widgets.parts.messages import field_name, seen_from, sentence, translated
from widgets.parts.panel import EVERYTHING, Changed, Shown
from widgets.parts.plain import Label, set_tip
from widgets.parts.section import GAP_PX, PARTS, Binding, Of, Part, Rows, Section, Typed

WIDTH_PX, LEAST_PX = 285, 270
"""How wide the dock is where nobody has chosen, and how narrow it becomes at the ordinary font."""
PRESENTED_EM = 17.6
"""How wide it is for a class, whatever the screen: in heights of its letters."""
LEFT_MARGIN_PX, RIGHT_MARGIN_PX = 8, 4
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
    **dict.fromkeys(("fov_y_deg", "fy"), ("bottom", "top")),
    **dict.fromkeys(("fov_x_deg", "fx"), ("left", "right")),
    **dict.fromkeys(("focal_length_mm", "e"), ("left", "right", "bottom", "top")),
}
"""What is made of a row's value besides; pointing at that points at the row as well."""

ASPECTS = {"1:1": (1, 1), "4:3": (4, 3), "16:9": (16, 9)}


class Controls(QScrollArea, RowHolder):
    """The dock.

    Attributes
    ----------
    card : SceneCard
        The scene, with its own settings and numbers.
    rows : dict of str to Row
        Every row of the projection by the name of what it shows: ``"near"``, ``"fov_y_deg"``,
        ``"eye_x"``, ...
    sections : dict of str to Section
        What is folded: ``"more_lens"``, ``"more_camera"``, ``"image"``, ``"object"``,
        ``"animation"``.
    animation : AnimationBar
        Its cameras come out of `edited`; its gestures are its own.
    search : SearchBox
    """

    concerns = EVERYTHING
    edited = Signal(object)
    """The user made this `Projection`: once per action."""
    object_unfolded = Signal(bool)
    """Whether the object's own numbers are unfolded, of an object that can be moved."""
    highlighted = Signal(str, object)
    """The name of a row that the user is at, and the `Highlight` it draws; `NOTHING` after it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._projection = Projection()
        self._defaults = self._projection
        self._size = 10.0
        self._is_for_class = self._has_fixed_objects = False
        self._lifted: tuple[str, ...] = ()
        self._replaced: Collection[str] = ()
        self._found: set[QWidget] | None = None
        """What is looked for, and is all that is shown; None if nothing is."""
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setAccessibleName(self.tr("Controls"))
        FocusRing(self)
        self.search = SearchBox(self)
        self.search.textChanged.connect(self._look_for)
        self.search.taken.connect(self._take_found)
        self._not_here = Label(wordWrap=True)
        self._not_here.setObjectName("paneNote")
        self._not_here.hide()
        self.card = SceneCard()
        self.card.highlighted.connect(self.highlighted)
        self.pass_on(self.card)
        self._front = [Rows(), Part(self.tr("Camera"))]
        self.sections = {
            "more_lens": Section(self.tr("More of the lens")),
            "more_camera": Section(self.tr("More of the camera")),
            "image": Section(self.tr("Image and depth range")),
            "object": Section(self.tr("Object")),
            "animation": Section(self.tr("Animation")),
        }
        self._column = QWidget()
        self.setWidget(self._column)  # while it is empty: it would all be styled again
        self._layout = in_column(
            self._not_here, self.card, *self._parts, FREE, on=self._column, gap=2
        )
        self._lens = LensControls(self._front[0], self.sections["more_lens"])
        self._make_camera()
        self._make_image()
        self._make_depth()
        self._make_object()
        self._make_animation()
        self._bindings: dict[str, Binding] = {}
        for rows in self._parts:
            self._bindings |= rows.bindings
        for section in self.sections.values():
            section.toggled.connect(partial(self._folded, section))
        self.sections["object"].toggled.connect(self._tell_of_object)
        for key, binding in self._bindings.items():
            self._connect(binding)
            about = _about(binding)
            binding.row.highlighted.connect(partial(self._highlighted, key, about))
        self.rows = {name: each.row for name, each in self._bindings.items()}
        self._make_room()
        self._reserve_bar()
        self.set_scene(self._size, self._defaults)

    @property
    def _parts(self) -> tuple[Rows, ...]:
        return (*self._front, *self.sections.values())

    # -- the interface

    def take(self, shown: Shown, changed: Changed) -> None:
        """Show another projection, and fit the sliders to another scene; answered by no signal."""
        if changed & {"scene", "view"}:
            self._has_fixed_objects = shown.scene.phenomenon is not None
            self._fixed.setVisible(self._has_fixed_objects)
            self.set_scene(shown.scene.size, shown.scene.start)
            self._tell_of_object()
        self._show(shown.projection)
        if changed & {"illustration", "settings"}:
            self.card.take(shown, changed)

    def set_style(self, style: Style) -> None:
        """Give the planes' sliders the colours that the planes are drawn in."""
        for name, colour in (("near", style.near), ("far", style.far)):
            slider = self._number(name).slider
            slider.setObjectName(name)  # for the application's style sheet
            palette = slider.palette()
            palette.setColor(QPalette.ColorRole.Highlight, QColor(colour))
            slider.setPalette(palette)

    def _show(self, projection: Projection) -> None:
        before, changed = self._projection, set[str]()
        if projection is not before and projection != before:
            changed = {part for part in PARTS if getattr(projection, part) != getattr(before, part)}
        for binding in self._bindings.values():
            row = binding.row
            if row.error and (binding.part in changed or not row.in_hand):
                row.clear_error()
        if not changed:
            return
        self._projection = projection
        if "image_size" in changed:
            changed.add("lens")  # most measures of a field of view have the aspect in them
        if projection.lens.kind != before.lens.kind:
            self._lens.fit(projection, self._size, self._defaults)
            self._show_rows()
        elif "lens" in changed:
            self._lens.follow(projection)
        self._show_values(changed)
        if projection.has_camera != before.has_camera:
            self._disable_camera(not projection.has_camera)
        if "camera" in changed:
            self.animation.show_camera(projection.camera)

    def _disable_camera(self, disabled: bool) -> None:
        """No camera has a view matrix of its own: what moves one has nothing to move then."""
        why = self.tr("The view matrix was typed, and no camera has it: undo, or choose a lens.")
        for part in (
            *(each.row for each in self._bindings.values() if each.part == "camera"),
            self.animation,
        ):
            part.setDisabled(disabled)
            set_tip(part, why if disabled else "")
        if disabled:
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
            self._number(f"translate_{letter}").setScale(Linear.about(0.0, 2.0 * size))
        near, far = sorted((size, camera.distance))
        self._number("distance").setScale(Log(float(f"{near / 10.0:.2g}"), 10.0 * far))
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
        self.card.show_highlight(shown)

    def _highlighted(self, key: str, about: Highlight, is_highlighted: bool) -> None:
        self.highlighted.emit(key, about if is_highlighted else NOTHING)

    def bring_to_front(self, paths: Collection[str], replaced: Collection[str] = ()) -> None:
        """Show the controls that matter for the scene in its card, and no others.

        Parameters
        ----------
        paths : collection of str
            ``lens.near``, ``camera.distance``: what a row shows, of what part. Of another lens
            they come to be seen when that is chosen.
        replaced : collection of str
            Rows that the scene's own settings stand for.
        """
        lifted = tuple(path.rpartition(".")[2] for path in paths)
        if (lifted, replaced) == (self._lifted, self._replaced):
            return
        self._lifted, self._replaced = lifted, replaced
        for part in self._parts:
            part.bring_home()
        self.card.lift(self.rows[key] for key in lifted)
        self._show_found(self._found)

    def set_presenting(self, on: bool) -> None:
        """Show a class the controls that matter, and nothing else; or all of them again."""
        self._is_for_class = on
        self.search.clear()
        self.search.setVisible(not on)
        self.card.set_presenting(on)
        self._show_found(None)
        self._make_room()
        self.updateGeometry()

    # -- looking for a control

    def find_control(self) -> None:
        """Let the user say what control is looked for."""
        self.search.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.search.selectAll()

    def _look_for(self, text: str) -> None:
        if not text.strip():
            self._show_found(None)
            return
        here: dict[QWidget, Known] = {
            row: known("", (row.name,), row.tip) for row in self.card.rows.values()
        }
        elsewhere: dict[QWidget, Known] = {}
        for key, binding in self._bindings.items():
            if key in self._replaced:
                continue
            places = here if self._in_use(binding) else elsewhere
            places[binding.row] = known(key, (binding.row.name,), binding.row.tip)
        walk = self.animation
        here[walk] = known("animation", (row.name for row in walk.rows), "")
        found, others = find(text, here), find(text, elsewhere)
        self._not_here.setText(self._why_not_here(found, others))
        self._show_found(found)

    def _why_not_here(self, found: set[QWidget], others: set[QWidget]) -> str:
        """What is to be said of controls that other lenses have, if nothing else is found."""
        if found:
            return ""
        lines = [
            self.tr("{0}: only with the lens “{1}”.").format(
                each.row.name,
                "”, “".join(translated(LENSES[kind].title, "Lens") for kind in each.lenses),
            )
            for each in self._bindings.values()
            if each.row in others
        ]
        return "\n".join(lines) or self.tr("No control is called so.")

    def _show_found(self, found: set[QWidget] | None) -> None:
        self._found = found
        self._not_here.setVisible(found is not None and bool(self._not_here.text()))
        self.card.show_some(found)
        for part in self._parts:
            part.show_some(found)
        if self._is_for_class:
            for section in self.sections.values():
                section.hide()
            for part in self._front:
                part.setVisible(not self.card.has_controls)
        self._show_rows()
        if found is not None:
            self.verticalScrollBar().setValue(0)

    def _take_found(self) -> None:
        """Go to the first that was found, with everything round it as it is otherwise."""
        rows = [*self.card.rows.values(), *self.rows.values()]
        places = {row: row.mapTo(self._column, QPoint()).y() for row in rows if row.isVisible()}
        first = min(places, key=lambda row: places[row], default=None)
        if first is None:
            if self._found and self.animation in self._found:
                first = self.animation.speed
            else:
                return
        for section in self.sections.values():
            if section.isAncestorOf(first):
                section.set_open(True)
        self.search.clear()
        first.take_focus()
        QTimer.singleShot(0, self, partial(self._bring_into_view, first))

    # -- the sections

    def _make_camera(self) -> None:
        front, more = self._front[1], self.sections["more_camera"]
        degrees, lengths = self.tr("degrees"), (self.tr("units"), self.tr("world units"))
        round_deg = Linear(-180.0, 180.0, 1.0)
        orbit: tuple[tuple[Rows, str, Scale, str], ...] = (
            (front, "azimuth_deg", round_deg,
             self.tr("Walks round the target: 0 is on its +z side, 90 on its +x side.")),
            (front, "elevation_deg", Linear(-90.0, 90.0, 1.0),
             self.tr("Height above the target's horizon as an angle: 90 looks straight down.")),
            (front, "distance", Log(1.0, 10.0), self.tr("From the target to the eye.")),
            (more, "roll_deg", round_deg,
             self.tr("Turns the camera about its view direction; clockwise for who holds it.")),
        )  # fmt: skip
        typed = Typed(lambda p: p.camera, lambda p: p.camera.orbit, _with_orbit)
        for part, name, scale, tip in orbit:
            unit, unit_tip = ("°", degrees) if name.endswith("_deg") else lengths
            part.add_number(name, "camera", tip, scale, unit, unit_tip, *typed.access(name))
        vectors = {
            "eye": self.tr("The centre of projection, in world coordinates."),
            "target": self.tr("The point that the camera looks at, in world coordinates."),
            "up": self.tr("The direction that shall be vertical in the picture (the lectures'"
                          " view-up vector); its length does not matter."),
        }  # fmt: skip
        for vector, tip in vectors.items():
            scale = Linear(-1.0, 1.0, 0.01)  # of the others the scene is yet to scale it
            shown = ("", "") if vector == "up" else lengths
            self._add_vector(more, "camera", vector, tip, scale, shown)

    def _add_vector(
        self, rows: Rows, part: Of, vector: str, tip: str, scale: Scale, unit: tuple[str, str]
    ) -> None:
        """Add a row for each component of a vector, with its unit and what that is."""
        for axis, letter in enumerate("xyz"):
            rows.add_number(
                f"{vector}_{letter}", part, tip, scale, *unit,
                partial(_read_component, part, vector, axis),
                partial(_write_component, part, vector, axis),
                name=self.tr("{0} {1}").format(field_name(vector), letter), field=vector,
            )  # fmt: skip

    def _make_image(self) -> None:
        section = self.sections["image"]
        sides = {
            "width": self.tr("Width of the picture in pixels."),
            "height": self.tr("Height of the picture in pixels."),
        }
        for axis, (name, tip) in enumerate(sides.items()):
            section.add_number(
                name, "image_size", tip, Linear(10.0, 4000.0, 10.0),
                self.tr("px"), self.tr("pixels"),
                partial(_side, axis), partial(_with_side, axis),
            )  # fmt: skip
        tip = self.tr("Width becomes {0}/{1} of the height, in whole pixels.")
        choices = [Choice(text, text, tip.format(*ratio)) for text, ratio in ASPECTS.items()]
        section.add_choice(
            "aspect", "image_size",
            self.tr("Width over height. The height stays, and with it the vertical field of view:"
                    " the picture gains or loses at its sides."),
            choices, _aspect, _with_aspect, buttons=True, name=self.tr("Aspect"),
        )  # fmt: skip

    def _make_depth(self) -> None:
        section = self.sections["image"]
        choices = (
            Choice("opengl", self.tr("OpenGL: −1 to 1"), self.tr("Near goes to −1, far to 1.")),
            Choice("direct3d", self.tr("Direct3D: 0 to 1"), self.tr("Near goes to 0, far to 1.")),
            Choice("reversed", self.tr("reversed: 1 to 0"),
                   self.tr("Near goes to 1, far to 0: floats are densest where depth needs them.")),
        )  # fmt: skip
        section.add_choice(
            "depth", "depth",
            self.tr("Which z the near and the far plane have in the NDC cube."),
            choices, lambda p: p.depth, lambda p, depth: p.with_depth(depth),
            name=self.tr("NDC z"),
        )  # fmt: skip

    def _make_object(self) -> None:
        section = self.sections["object"]
        self._fixed = Label(
            self.tr(
                "The objects of this scene are fixed: what it shows is reckoned with them. Those of"
                " the letter F, the cube, the posts and of any mesh can be moved."
            ),
            wordWrap=True,
        )
        section.add(self._fixed)
        for vector, scale, unit, unit_tip, tip in (
            # The scene is yet to scale the first.
            ("translate", Linear(-1.0, 1.0, 0.01), self.tr("units"), self.tr("world units"),
             self.tr("Moves the object: the last column of world ← object.")),
            ("rotate_deg", Linear(-180.0, 180.0, 1.0), self.tr("°"), self.tr("degrees"),
             self.tr("Turns the object about the fixed axes: first x, then y, then z.")),
            ("scale", Linear(-3.0, 3.0, 0.01), self.tr("×"), self.tr("times"),
             self.tr("Stretches the object along its own axes: 0 flattens it, −1 mirrors it.")),
        ):  # fmt: skip
            self._add_vector(section, "placement", vector, tip, scale, (unit, unit_tip))
        choices = (
            Choice("trs", self.tr("T R S"), self.tr("Scaled and turned where it is, then moved.")),
            Choice("rts", self.tr("R T S"),
                   self.tr("Scaled and moved, then turned about the world's origin.")),
        )  # fmt: skip
        section.add_choice(
            "order", "placement",
            self.tr("Which factor comes first: of column vectors, the one on the right."),
            choices, lambda p: p.placement.order,
            lambda p, order: replace(p, placement=replace(p.placement, order=order)),
            buttons=True,
        )  # fmt: skip

    def _make_animation(self) -> None:
        self.animation = AnimationBar()
        self.animation.edited.connect(self._walked)
        self.sections["animation"].add(self.animation)

    def _tell_of_object(self) -> None:
        """Tell whether the object's numbers are unfolded, of one that can be moved."""
        if self._found is None:
            is_open = self.sections["object"].is_open
            self.object_unfolded.emit(is_open and not self._has_fixed_objects)

    def _folded(self, section: Section, is_open: bool) -> None:
        if is_open and self._found is None:
            self._show_rows()
            # After the layout has made room: what opens below the fold comes into view.
            QTimer.singleShot(0, self, partial(self._bring_into_view, section, section.heading))

    def _bring_into_view(self, *parts: QWidget) -> None:
        """Scroll so that the last of these is seen, and as much of the others as there is room."""
        if all(part.isVisible() for part in parts):
            lay_out()
            for part in parts:
                self.ensureWidgetVisible(part, 0, 0)

    def _connect(self, binding: Binding) -> None:
        row = binding.row
        if isinstance(row, NumberRow):
            row.limits = partial(self._limits, binding)
            row.accepts = partial(self._accepts, binding)
        row.edited.connect(partial(self._edit, binding))
        self._join(row)

    def _number(self, key: str) -> NumberRow:
        row = self._bindings[key].row
        assert isinstance(row, NumberRow)
        return row

    # -- edits

    def _edit(self, binding: Binding, value: Any) -> None:
        before = self._projection
        if not self._in_use(binding):  # a hidden row of another lens, which has no such value
            return
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
            lay_out()
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

    def _reveal(self, row: Row) -> None:
        if row.error and row.isVisible():
            self.ensureWidgetVisible(row, 0, 4)

    # -- shown

    def _in_use(self, binding: Binding) -> bool:
        """Whether a row belongs to lens and scene, and no setting of the scene's is the same."""
        if binding.part == "placement" and self._has_fixed_objects:
            return False
        of_lens = not binding.lenses or self._projection.lens.kind in binding.lenses
        return of_lens and binding.field not in self._replaced

    def _show_rows(self) -> None:
        """Show the rows that are in use, and that are looked for if any are, with their values."""
        found = self._found
        for binding in self._bindings.values():
            row = binding.row
            row.setVisible(self._in_use(binding) and (found is None or row in found))
        self._show_values(PARTS)

    def _show_values(self, parts: Collection[str]) -> None:
        """Show the values of these parts of the projection, where they are seen."""
        for rows in self._parts:
            is_open = rows.is_open
            for key, binding in rows.bindings.items():
                seen = (is_open or key in self._lifted) and not binding.row.isHidden()
                if seen and binding.part in parts:
                    binding.row.setValue(binding.read(self._projection))

    def _reserve_bar(self) -> None:
        """Keep the scroll bar's room free while there is none: nothing shifts under the hand."""
        shown = self.width() - self.viewport().width()
        free = max(0, self._bar_width() - shown)
        self._layout.setContentsMargins(LEFT_MARGIN_PX, 0, RIGHT_MARGIN_PX + free, 0)

    def _bar_width(self) -> int:
        return self.verticalScrollBar().sizeHint().width()

    def _make_room(self) -> None:
        """For the search box, above what scrolls."""
        search_px = 0 if self._is_for_class else self.search.sizeHint().height() + GAP_PX
        self.setViewportMargins(0, search_px, 0, 0)
        self._place_search()

    def _place_search(self) -> None:
        width = self.width() - LEFT_MARGIN_PX - RIGHT_MARGIN_PX - self._bar_width()
        self.search.setGeometry(LEFT_MARGIN_PX, 0, width, self.search.sizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._reserve_bar()  # first: the rows keep their width and wrap no text again
        super().resizeEvent(event)
        self._place_search()

    def minimumSizeHint(self) -> QSize:
        rows = self._column.minimumSizeHint().width() - self._layout.contentsMargins().right()
        em = QFontInfo(self.font()).pixelSize() if self._is_for_class else 0.0
        least = max(LEAST_PX, round(PRESENTED_EM * em))
        return QSize(max(least, rows + RIGHT_MARGIN_PX + self._bar_width()), 120)

    def sizeHint(self) -> QSize:
        return QSize(max(WIDTH_PX, self.minimumSizeHint().width()), 600)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()  # a scroll area does not pass its widget's least width on
        return super().eventFilter(watched, event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange) and self.widget():
            self._make_room()


# --------------------------------------------------------------------------- reading and writing


def _about(binding: Binding) -> Highlight:
    return frozenset(_ABOUT.get(binding.field, (binding.field,)))


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


def _read_component(part: Of, vector: str, axis: int, projection: Projection) -> float:
    return float(getattr(getattr(projection, part), vector)[axis])


def _write_component(
    part: Of, vector: str, axis: int, projection: Projection, value: float
) -> Projection:
    whole: Any = getattr(projection, part)
    components = list(getattr(whole, vector))
    components[axis] = value
    return replace(projection, **{part: replace(whole, **{vector: tuple(components)})})


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
