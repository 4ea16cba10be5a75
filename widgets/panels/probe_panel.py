"""The probe panel: points that are followed through every stage, and their numbers.

A probe is not part of the scene: it is kept in the document's view. A folded panel computes no
numbers.
"""

from pathlib import Path

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent

from app.document.view import MOST_PROBES
from app.lecture.highlight import NOTHING, Highlight, made_of
from app.model.infinity import homogeneous
from app.model.limits import finite
from app.model.parameter import read_content
from app.model.projection import Projection, Vector
from app.model.refusal import Refusal
from app.picking.picking import Probe
from widgets.panels.probe_numbers import ProbeNumbers
from widgets.panels.probe_table import ProbeTable
from widgets.parts.icons import Combo, icon
from widgets.parts.labels import RefusalLabel
from widgets.parts.layouts import LetteredWidget, Part, in_column, in_row
from widgets.parts.messages import all_digits, lettering, sentence
from widgets.parts.number_field import ShortField, refusal
from widgets.parts.panel import PROJECTION, Changed, ReadablePanel, ShownData
from widgets.parts.plain import PlainLabel, set_tip
from widgets.parts.wording import Wording

WORDS = Wording(__file__)
_PIN_SHEET = read_content(Path(__file__).with_name("content") / "pin.qss")


class ProbePanel(LetteredWidget, ReadablePanel):
    """The probes, the buttons that change them, and the table of their numbers."""

    concerns = PROJECTION
    changed = Signal()  # the probes have changed
    refusal_withdrawn = Signal(str)  # a sentence that was refused is not true any more

    def __init__(self) -> None:
        super().__init__()
        self.probes: tuple[Probe, ...] = ()  # the probes that the panes mark, in the table's order
        self.pinned = frozenset[int]()  # numbers of the probes that the next click does not move
        self._chosen = 0  # number of the probe that is edited; 0 for none
        self._projection: Projection | None = None
        self._is_new = False
        self._numbers = ProbeNumbers(self)
        self.table = ProbeTable()
        self.table.setAccessibleName(WORDS.say("table"))
        self.table.entered.connect(lambda at: self.highlighted.emit(self.table.highlight_at(at)))
        self.table.viewportEntered.connect(lambda: self.highlighted.emit(NOTHING))
        self.table.viewport().installEventFilter(self)
        self._lay_out()
        all_digits.changed.connect(self._turn)
        lettering.changed.connect(self._turn)
        self.table.fit_rows(self.font())
        self._show_choice()

    def _lay_out(self) -> None:
        self.choice = WORDS.combo("choice")
        self.choice.setSizeAdjustPolicy(Combo.SizeAdjustPolicy.AdjustToContents)
        self.choice.activated.connect(lambda index: self.choose(self.choice.itemData(index)))
        self.fields = tuple(ShortField(name) for name in "xyzw")
        parts: list[Part] = [self.choice]
        for name, field in zip("xyzw", self.fields, strict=True):
            field.setAccessibleName(WORDS.say("field", name))
            set_tip(field, WORDS.say("field-tip", name))
            field.editingFinished.connect(self._typed)
            label = PlainLabel(name)
            label.setBuddy(field)
            parts += label, (field, 1)
        set_tip(self.fields[3], WORDS.say("w"))
        self.pin = WORDS.push("pin", self._pin_clicked)
        self.pin.setCheckable(True)
        self.pin.setStyleSheet(_PIN_SHEET)
        self._remove = WORDS.push("remove", self.remove)
        self._clear = WORDS.push("clear", self.clear)
        line = in_row(*parts, self.pin, self._remove, self._clear)
        self.error = RefusalLabel()
        self._hint = PlainLabel(WORDS.say("hint"), wordWrap=True)
        column = (line, self.error, self._hint, (self.table, 1))
        in_column(*column, on=self, margins=(4, 0, 4, 2), gap=2)

    def hasHeightForWidth(self) -> bool:
        return False  # the sentences wrap, but the table takes the height

    # -- the probes

    @property
    def chosen(self) -> Probe | None:
        """The probe that the fields and the buttons change."""
        return next((probe for probe in self.probes if probe.number == self._chosen), None)

    def follow(
        self,
        *,
        point: Vector | None = None,
        pixel: tuple[float, float] | None = None,
        direction: Vector | None = None,
    ) -> None:
        """Move an unpinned probe to a point, a pixel's ray or a point at infinity."""
        number = self._chosen
        if not number or number in self.pinned:
            # A new probe is made only if all probes are pinned.
            loose = [p.number for p in self.probes if p.number not in self.pinned]
            taken = {probe.number for probe in self.probes}
            free = [n for n in range(1, MOST_PROBES + 1) if n not in taken]
            if not loose and not free:
                self.refused.emit(WORDS.say("most", len(self.probes) + 1, MOST_PROBES))
                return
            number = (loose or free)[0]
        self._chosen = number
        self._put(Probe(number, point, pixel, direction))

    def restore(
        self, probes: tuple[Probe, ...], chosen: int, pinned: frozenset[int] | None = None
    ) -> None:
        """Go back to earlier probes, with the numbers of the chosen one (or 0) and the pinned ones.

        Without `pinned`, the pinned probes stay the same.
        """
        self._chosen = chosen
        if pinned is not None:
            self.pinned = pinned
        self._set(probes)

    def put(self, number: int, point: Vector) -> None:
        """Move a probe, pinned or not."""
        self._put(Probe(number, point))

    def choose(self, number: int) -> None:
        self._chosen = number
        self._show_choice()

    def remove(self) -> None:
        """Remove the chosen probe, and choose the last of the others."""
        probes = tuple(probe for probe in self.probes if probe.number != self._chosen)
        self.restore(probes, probes[-1].number if probes else 0, self.pinned - {self._chosen})

    def clear(self) -> None:
        self.restore((), 0, frozenset())

    def _put(self, new: Probe) -> None:
        others = [probe for probe in self.probes if probe.number != new.number]
        self._set(tuple(sorted([*others, new], key=lambda probe: probe.number)))

    def _set(self, probes: tuple[Probe, ...]) -> None:
        if probes != self.probes:
            self.probes = probes
            self.changed.emit()
            self.refusal_withdrawn.emit(WORDS.say("most", MOST_PROBES + 1, MOST_PROBES))
            self._readable.changed()
        self._show_choice()

    def _pin_clicked(self, pinned: bool) -> None:
        chosen = {self._chosen}
        self.pinned = self.pinned | chosen if pinned else self.pinned - chosen
        self._show_choice()

    # -- the fields

    def _typed(self) -> None:
        """Move the probe to the typed coordinates, or say which one is refused."""
        if not any(field.isModified() for field in self.fields):
            return
        probe = self.chosen
        row: list[object] = list((probe and probe.row) or (0.0, 0.0, 0.0, 1.0))
        field = self.fields[3]
        try:
            for axis, (name, field) in enumerate(zip("xyzw", self.fields, strict=True)):
                if field.isModified():
                    row[axis] = finite(name, field.read())
            moved = Probe.of(self._chosen, homogeneous(*row))
        except Refusal as error:
            self.error.show_text(refusal(sentence(error)))
            field.setAccessibleDescription(self.error.text())
            return
        if self._chosen:
            self._put(moved)
        else:
            self.follow(point=moved.point, direction=moved.direction)
        self._show_choice()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and any(field.isModified() for field in self.fields):
            self._show_choice()  # discards the typed text
        else:
            super().keyPressEvent(event)

    def _show_choice(self) -> None:
        probe = self.chosen
        self.choice.clear()
        for other in self.probes:
            name = self._name(other)
            self.choice.addItem(name, other.number)
            if other.number in self.pinned:
                place, role = self.choice.count() - 1, Qt.ItemDataRole.AccessibleTextRole
                self.choice.setItemIcon(place, icon("pin"))
                self.choice.setItemData(place, WORDS.say("pinned", name), role)
        self.choice.setCurrentIndex(self.choice.findData(self._chosen))
        row = None if probe is None else probe.row
        for axis, field in enumerate(self.fields):
            field.show_number(None if row is None else row[axis])
            field.take_back()
            field.setAccessibleDescription("")
        self.error.show_text("")
        self.pin.setChecked(self._chosen in self.pinned)
        for button in (self.pin, self._remove):
            button.setEnabled(probe is not None)
        for needs_probes in (self.choice, self._clear):
            needs_probes.setEnabled(bool(self.probes))
        self._hint.setVisible(not self.probes)
        self.table.setVisible(bool(self.probes))

    def _name(self, probe: Probe) -> str:
        kind = "point" if probe.pixel is None else "pixel"
        return WORDS.say("direction" if probe.direction is not None else kind, probe.number)

    # -- the table

    def _turn(self) -> None:
        """Let columns shrink after a change of letters or digits."""
        self._is_new = True
        self._readable.changed()

    def _fit(self) -> None:
        self.table.fit_rows(self.font())
        self._turn()

    def take(self, shown: ShownData, changed: Changed) -> None:
        self._projection = shown.projection
        self._readable.changed()

    def _fill(self) -> None:
        if self._projection is not None:
            numbers = self._numbers.numbers(self._projection, self.probes)
            self.table.show_numbers(numbers, self.font(), anew=self._is_new)
            self._is_new = False

    def show_highlight(self, highlighted: Highlight) -> None:
        self.table.show_highlight(made_of(highlighted))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Leave:
            self.highlighted.emit(NOTHING)
        return super().eventFilter(watched, event)
