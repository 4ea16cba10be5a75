"""The dock: the scene, then every value of the projection as a slider and as a number.

    user -> row.edited(value) -> write(current, value) -> a new Projection -> controls.edited
                                 Refusal       -> a sentence at the row, nothing else

A `Binding` connects each row with the model. Folded rows are neither read nor written until they
are opened. There is one row for each value: the scene's card borrows those that matter for the
scene.
"""

from collections.abc import Collection, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from PySide6.QtCore import QPoint, Qt, QTimer, Signal
from PySide6.QtWidgets import QWidget

from app.languages import quoted
from app.lecture.highlight import Highlight, made_of
from app.model.lenses.perspective import FOV_Y
from app.model.parameter import PARTS, Computed
from app.model.parameters import DISTANCE, EYE, FOV_X, FX, KIND, TARGET, TILES, parameters
from app.model.projection import LARGEST, LENSES, Projection
from app.model.refusal import REFUSALS, Refusal
from widgets.controls.animation import AnimationBar
from widgets.controls.chain_editor import ChainEditor
from widgets.controls.dock import ControlTexts, Dock, find
from widgets.controls.lens_sliders import LensSliders
from widgets.controls.parameter_rows import Binding, TypedMemory, bindings_of
from widgets.controls.scene_card import SceneCard
from widgets.parts.fields import Row, RowHolder, report_highlight
from widgets.parts.layouts import lay_out
from widgets.parts.messages import parameter_text, seen_from, sentence, translated
from widgets.parts.number_rows import NumberRow
from widgets.parts.panel import EVERYTHING, Changed, ShownData
from widgets.parts.plain import PlainLabel, set_tip
from widgets.parts.scales import Linear, Log
from widgets.parts.section import QUIET, Rows, Section, TitledRows

_ALL = tuple(PARTS.values())


class Controls(Dock, RowHolder):
    """The dock.

    `rows` has every row of the projection by the name of its parameter, or of a component
    (``"eye_x"``); `sections` has the folding parts. `edited` also emits the cameras of `animation`,
    whose gestures are not passed on.
    """

    concerns = EVERYTHING
    edited = Signal(object)  # the user made this `Projection`; emitted once per action
    object_unfolded = Signal(bool)  # whether the numbers of a movable object are unfolded
    highlighted = Signal(str, object)
    """The key of the row under the mouse or the focus, and its `Highlight`; then `NOTHING`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._projection = Projection()
        self._defaults = self._projection
        self._size = 10.0
        self._has_fixed_objects = False
        self._lifted: tuple[str, ...] = ()
        self._replaced: Collection[str] = ()
        self._lent: list[str] = []  # the keys of the rows that are outside the dock
        self._lent_tiles: list[Row] = []  # and the rows of the object's tiles
        self._matches: set[QWidget] | None = None
        """The rows found by the search, the only ones shown; None without a search."""
        self.setAccessibleName(self.tr("Controls"))
        self.search.textChanged.connect(self._look_for)
        self.search.taken.connect(self._take_match)
        self._not_here = PlainLabel(wordWrap=True, objectName="paneNote", visible=False)
        self.card = SceneCard()
        self.card.highlighted.connect(self.highlighted)
        self.pass_on(self.card)
        self._front = [Rows(), TitledRows(self.tr("Camera"))]
        self.sections = {
            "more_lens": Section(self.tr("More of the lens")),
            "more_camera": Section(self.tr("More of the camera")),
            "image": Section(self.tr("Image and depth range")),
            "object": Section(self.tr("Chain")),
            "animation": Section(self.tr("Animation")),
        }
        for part in (self._not_here, self.card, *self._parts):
            self._layout.addWidget(part)
        self._layout.addStretch(1)
        named = self.sections
        text = self.tr(
            "The objects of this scene are fixed, because its numbers depend on them. You can"
            " move those of the letter F, the cube, the posts and any mesh."
        )
        self._fixed = PlainLabel(text, wordWrap=True)
        self.chain = ChainEditor()
        self.chain.edited.connect(
            lambda chain: self._adopt(replace(self._projection, placement=chain))
        )
        self.chain.highlighted.connect(self.highlighted)
        self.pass_on(self.chain)
        named["object"].add(self.chain)
        named["object"].add(self._fixed)
        self._bindings: dict[str, Binding] = {}
        self._make_rows({"lens": self._front[0], "camera": self._front[1], **named})
        self._lens = LensSliders(self._bindings, self)
        self.animation = AnimationBar()
        self.animation.edited.connect(
            lambda camera: self._adopt(replace(self._projection, camera=camera))
        )
        named["animation"].add(self.animation)
        for section in self.sections.values():
            section.toggled.connect(partial(self._folded, section))
        self.sections["object"].toggled.connect(self._emit_object_unfolded)
        for key, binding in self._bindings.items():
            self._connect(binding)
            report_highlight(binding.row, self.highlighted, key, binding.parameter.highlights)
        self.rows = {name: each.row for name, each in self._bindings.items()}
        self._make_room()
        self._reserve_bar()
        self.set_scene(self._size, self._defaults)

    @property
    def _parts(self) -> tuple[Rows, ...]:
        return (*self._front, *self.sections.values())

    def _make_rows(self, places: Mapping[str, Rows]) -> None:
        memories: dict[Computed, TypedMemory] = {}
        placed = (each for each in parameters() if each.place)
        ordered = sorted(placed, key=lambda each: [*places].index(each.place))
        for parameter in ordered:  # Tab follows the order in which rows are made
            rows, computed, memory = places[parameter.place], parameter.computed, None
            if computed is not None:
                memory = memories.setdefault(computed, TypedMemory(computed))
            if parameter is FX:
                rows.add_title(self.tr("Calibrated camera (OpenCV K)"))
            for binding in bindings_of(parameter, rows, memory):
                self._bindings[binding.parameter.name] = binding
                rows.add(binding.row)
        self._bindings[KIND.name].row.name_label.setObjectName(QUIET)
        for angle in (FOV_Y, FOV_X):
            self._number(angle.name).field.below = 180.0

    # -- the interface

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Show another projection, and fit the sliders to another scene, without a signal."""
        if changed & {"scene", "view"}:
            self._has_fixed_objects = shown.scene.phenomenon is not None
            self._fixed.setVisible(self._has_fixed_objects)
            self.chain.own.setHidden(self._has_fixed_objects)
            self.set_scene(shown.scene.size, shown.scene.start)
            self._emit_object_unfolded()
        self._show(shown.projection)
        if changed & {"illustration", "settings"}:
            self.card.take(shown, changed)
        if "scene" in changed:  # what to try, and its own controls, are at the top
            self.search.clear()
            self.verticalScrollBar().setValue(0)

    def _show(self, projection: Projection) -> None:
        before, changed = self._projection, set[str]()
        if projection is not before and projection != before:
            changed = {part for part in _ALL if getattr(projection, part) != getattr(before, part)}
        for binding in self._bindings.values():
            row = binding.row
            if row.error and (binding.part in changed or not row.in_hand):
                row.clear_error()
        if not changed:
            return
        self._projection = projection
        if "image_size" in changed:
            changed.add("lens")  # most measures of a field of view depend on the aspect
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
        """Disable or enable what moves the camera: a typed view matrix has no camera."""
        why = self.tr("No camera has the typed view matrix: undo, or choose a lens.")
        rows = [each.row for each in self._bindings.values() if each.part == "camera"]
        for part in (*rows, self.animation):
            part.setDisabled(disabled)
            set_tip(part, why if disabled else "")
        if disabled:
            self.animation.pause()

    def set_scene(self, size: float, defaults: Projection) -> None:
        """Fit the sliders to a scene, and set the defaults.

        `size` is the diagonal of the scene's bounds in world units. The scene opens with
        `defaults`.
        """
        self._size, self._defaults = size, defaults
        camera = defaults.camera
        reach = 2.0 * max(size, camera.distance)
        for axis, letter in enumerate("xyz"):
            about_target = Linear.about(camera.target[axis], reach)
            self._number(f"{EYE.name}_{letter}").setScale(about_target)
            self._number(f"{TARGET.name}_{letter}").setScale(about_target)
        self.chain.set_scene(size)
        near, far = sorted((size, camera.distance))
        self._number(DISTANCE.name).setScale(Log(float(f"{near / 10.0:.2g}"), 10.0 * far))
        self._lens.fit(self._projection, size, defaults)
        for binding in self._bindings.values():
            if not binding.lenses:
                binding.row.setDefault(binding.parameter.value(defaults))
        self.animation.set_scene(size, camera)
        self.animation.show_camera(self._projection.camera)
        self._show_rows()

    def show_highlight(self, highlighted: Highlight) -> None:
        """Mark the rows of what is highlighted, and the rows that it is computed from."""
        shown = made_of(highlighted)
        for binding in self._bindings.values():
            names = binding.parameter.highlights.union(binding.parameter.makes)
            binding.row.set_marked(bool(names & shown))
        self.chain.show_highlight(shown)
        self.card.show_highlight(shown)

    def bring_to_front(self, paths: Collection[str], replaced: Collection[str] = ()) -> None:
        """Show the controls that matter for the scene in its card.

        `paths` are part and key of each row, ``lens.near``; rows of another lens appear when it is
        chosen. The scene's own settings replace the rows in `replaced`.
        """
        lifted = tuple(path.rpartition(".")[2] for path in paths)
        if (lifted, replaced) == (self._lifted, self._replaced):
            return
        self._lifted, self._replaced = lifted, replaced
        held = self.window().focusWidget()
        for part in self._parts:
            part.return_borrowed()
        self.card.lift(self.rows[key] for key in lifted)
        self._show_matches(self._matches)
        if held is not None and held.isVisible():  # Qt took the focus from a row that has moved
            held.setFocus()

    def lend(self, paths: Collection[str]) -> list[Row]:
        """Return the rows of these values, by their paths in a document, to another place.

        A vector has a row for each component. Unknown values, and those of another lens, have none.
        """
        self.take_back()
        self._lent = self._keys_of(paths)
        of_scene = [path.removeprefix("settings.") for path in paths]
        self.chain.show_chain(self._projection.placement)
        names = (path.removeprefix("object.") for path in paths)
        self._lent_tiles = [row for name in names for row in self.chain.rows_of(name)]
        own = [self.rows[key] for key in self._lent]
        rows = [*own, *self._lent_tiles, *self.card.lend(of_scene)]
        self._show_values(_ALL)
        return rows

    def _keys_of(self, paths: Collection[str]) -> list[str]:
        """Return the keys of the rows of these values that are in use, without the scene's own."""
        return [
            key
            for path in paths
            for name in (path.rpartition(".")[2],)
            for key in (name, *(f"{name}_{axis}" for axis in "xyz"))
            if not path.startswith("settings.") and key in self._bindings
            if self._in_use(self._bindings[key])
        ]

    def reveal(self, paths: Collection[str]) -> None:
        """Scroll to the rows of these values, or to the top if there are none."""
        self.verticalScrollBar().setValue(0)
        of_scene = [row for name, row in self.card.rows.items() if f"settings.{name}" in paths]
        self.bring_into_view(*of_scene, *(self.rows[key] for key in self._keys_of(paths)))

    def show_tile(self, factor: str, takes_focus: bool) -> None:
        """Unfold the chain, and bring the tile of a factor into view."""
        section, card = self.sections["object"], None
        if section.isVisible():
            section.set_open(True)
            card = self.chain.card_of(factor)
        if card is not None:
            QTimer.singleShot(0, self, partial(self.bring_into_view, card))
            if takes_focus:
                first = next(iter(card.rows.values()), None)
                (card.switch.setFocus if first is None else first.take_focus)()

    def take_back(self) -> None:
        """Put every row that was lent back into the dock."""
        if not self._lent and not self._lent_tiles and not self.card.lent:
            return
        self._lent.clear()
        self._lent_tiles.clear()
        self.chain.return_borrowed()
        for part in self._parts:
            part.return_borrowed()
        self.card.take_back()
        self.card.lift(self.rows[key] for key in self._lifted)
        self._show_matches(self._matches)

    def set_presenting(self, on: bool) -> None:
        """Show only the controls that a class needs, or all of them again."""
        self._is_for_class = on
        self.search.clear()
        self.search.setVisible(not on)
        self.card.set_presenting(on)
        self._show_matches(None)
        self._make_room()
        self.updateGeometry()

    # -- looking for a control

    def find_control(self) -> None:
        self.search.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.search.selectAll()

    def _look_for(self, text: str) -> None:
        if not text.strip():
            self._show_matches(None)
            return
        here: dict[QWidget, ControlTexts] = {
            row: ControlTexts(row.name, row.tip) for row in self.card.rows.values()
        }
        elsewhere: dict[QWidget, ControlTexts] = {}
        for key, binding in self._bindings.items():
            if key in self._replaced:
                continue
            places = here if self._in_use(binding) else elsewhere
            also = parameter_text(binding.parameter, binding.parameter.also)
            places[binding.row] = ControlTexts(f"{binding.row.name} {key} {also}", binding.row.tip)
        walk = self.animation
        names = [*(row.name for row in walk.rows), self.tr("animation play walk turn")]
        here[walk] = ControlTexts(" ".join(names), "")
        if not self._has_fixed_objects:
            tiles = (parameter_text(each, f"{each.title} {each.also}") for each in TILES.values())
            names = [self.sections["object"].heading.text(), self.chain.add.text(), *tiles]
            here[self.chain] = ControlTexts(" ".join(names), "")
        matches, others = find(text, here), find(text, elsewhere)
        self._not_here.setText(self._why_not_here(matches, others))
        self._show_matches(matches)

    def _why_not_here(self, matches: set[QWidget], others: set[QWidget]) -> str:
        """Say which lenses have the found controls, if the current lens has none of them."""
        if matches:
            return ""
        opened, _, closed = quoted("|").partition("|")
        lines = [
            self.tr("{0}: only with the lens “{1}”.").format(
                each.row.name,
                f"{closed}, {opened}".join(
                    translated(LENSES[kind].title, "Lens") for kind in each.lenses
                ),
            )
            for each in self._bindings.values()
            if each.row in others
        ]
        return "\n".join(lines) or self.tr("No control has this name.")

    def _show_matches(self, matches: set[QWidget] | None) -> None:
        self._matches = matches
        self._not_here.setVisible(matches is not None and bool(self._not_here.text()))
        self.card.show_some(matches)
        for part in self._parts:
            part.show_some(matches)
        if self._is_for_class:
            for section in self.sections.values():
                section.hide()
            for part in self._front:
                part.setVisible(not self.card.has_controls)
        self._show_rows()
        if matches is not None:
            self.verticalScrollBar().setValue(0)

    def _take_match(self) -> None:
        """Go to the first result and end the search."""
        rows = [*self.card.rows.values(), *self.rows.values()]
        places = {row: row.mapTo(self._column, QPoint()).y() for row in rows if row.isVisible()}
        first: QWidget | None = min(places, key=lambda row: places[row], default=None)
        if first is None:
            others = {self.chain: self.chain.add, self.animation: self.animation.speed}
            first = next((others[part] for part in others if part in (self._matches or ())), None)
        if first is None:
            return
        for section in self.sections.values():
            if section.isAncestorOf(first):
                section.set_open(True)
        self.search.clear()
        reason = Qt.FocusReason.ShortcutFocusReason
        first.take_focus() if isinstance(first, Row) else first.setFocus(reason)
        QTimer.singleShot(0, self, partial(self.bring_into_view, first))

    # -- the sections

    def _emit_object_unfolded(self) -> None:
        if self._matches is None:
            is_open = self.sections["object"].is_open
            self.object_unfolded.emit(is_open and not self._has_fixed_objects)

    def _folded(self, section: Section, is_open: bool) -> None:
        if is_open and self._matches is None:
            self._show_rows()
            # Later, when the layout has made room.
            QTimer.singleShot(0, self, partial(self.bring_into_view, section, section.heading))

    def _connect(self, binding: Binding) -> None:
        row = binding.row
        if isinstance(row, NumberRow):
            row.limits = lambda: binding.limits(self._projection)
            row.accepts = lambda value: binding.accepts(self._projection, value)
        row.edited.connect(partial(self._edit, binding))
        self._join(row)

    def _number(self, key: str) -> NumberRow:
        row = self._bindings[key].row
        assert isinstance(row, NumberRow)
        return row

    # -- edits

    def _edit(self, binding: Binding, value: Any) -> None:
        before = self._projection
        if not self._in_use(binding):  # a hidden row of another lens
            return
        try:
            projection = binding.parameter.put(before, value)
        except Refusal as error:
            seen = seen_from(binding.field, binding.row.name, value, error)
            ends = (LARGEST,), (-LARGEST,)
            general = seen.bound == REFUSALS["finite-number"] or seen.limits in ends
            if isinstance(value, float) and abs(value) > LARGEST and general:
                seen = binding.limit(before, value) or seen
            binding.row.show_error(sentence(_as_shown(seen, value)))
            # Later, when the layout has made room, and if the error is still there.
            QTimer.singleShot(0, self, partial(self._reveal, binding.row))
        else:
            if binding.memory is not None:
                binding.memory.keep(binding.parameter, before, value, projection)
            if projection.lens.kind != before.lens.kind:
                place = binding.row.mapTo(self.viewport(), QPoint())
                QTimer.singleShot(0, self, partial(self._hold, binding.row, place))
            self._adopt(projection)

    def _hold(self, row: Row, place: QPoint) -> None:
        """Scroll a row back to its place after the rows of another lens have moved it."""
        if row.isVisible():
            lay_out()
            moved = row.mapTo(self.viewport(), QPoint()) - place
            bar = self.verticalScrollBar()
            bar.setValue(bar.value() + moved.y())

    def _adopt(self, projection: Projection) -> None:
        if projection != self._projection:
            self._show(projection)
            self.edited.emit(projection)

    def _reveal(self, row: Row) -> None:
        if row.error and row.isVisible():
            self.ensureWidgetVisible(row, 0, 4)

    # -- shown

    def _in_use(self, binding: Binding) -> bool:
        """Whether the row applies to lens and scene, and no setting of the scene replaces it."""
        return binding.belongs_to(self._projection.lens) and binding.field not in self._replaced

    def _show_rows(self) -> None:
        """Show the rows in use, or only the results of a search, with their values."""
        matches = self._matches
        self.chain.setVisible(matches is None or self.chain in matches)
        for binding in self._bindings.values():
            row = binding.row
            row.setVisible(self._in_use(binding) and (matches is None or row in matches))
        for rows in self._parts:
            rows.show_titles()
        self._show_values(_ALL)

    def _show_values(self, parts: Collection[str]) -> None:
        is_open = {rows: rows.is_open for rows in self._parts}
        if is_open[self.sections["object"]]:
            self.chain.show_pipeline(self._projection)
        if "placement" in parts and (is_open[self.sections["object"]] or self._lent_tiles):
            self.chain.show_chain(self._projection.placement)
        values = [
            (each.row, each.parameter.value(self._projection))
            for key, each in self._bindings.items()
            if (is_open[each.rows] or key in self._lifted or key in self._lent)
            and each.part in parts
            and not each.row.isHidden()
        ]
        for row, value in values:
            row.setValue(value)


def _as_shown(error: Refusal, value: Any) -> Refusal:
    """Shorten the components of a refused vector, except for the edited one."""
    if not isinstance(error.value, tuple):
        return error
    refused = tuple(part if part == value else float(f"{part:.6g}") for part in error.value)
    return Refusal(error.field, refused, error.bound, *error.limits)
