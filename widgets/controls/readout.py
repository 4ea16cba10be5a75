"""The readout of a scene: its numbers, with labels and units."""

import math
from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QGridLayout, QSizePolicy, QWidget

from app.languages import listed
from app.lecture.highlight import NOTHING, Highlight
from app.scenes.phenomena.words import Reading
from widgets.parts.icons import show_icon
from widgets.parts.labels import Balanced
from widgets.parts.layouts import LetteredWidget, in_column, tool_button
from widgets.parts.messages import all_digits, lettering, number_text, of_phenomena, read_text
from widgets.parts.plain import PlainLabel, set_tip, subscripts
from widgets.parts.typeset import TypesetLabel, in_line, matrix

LARGE = 1.15  # size of a reading's number, relative to ordinary text
BESIDE, ON_A_LINE = 13, 30
"""Characters of the longest value beside its label, and of the longest list on one line."""
LABEL_EM, WORDS_EM = 6, 7  # widths in line heights beyond which labels, or words as values, wrap
BETWEEN_EM = 0.35  # gap between two readings
NONE = "–"  # shown for a missing reading


def full_sentence(sentence: str) -> str:
    """Turn a clause into a sentence, with a capital and a full stop."""
    sentence = sentence[:1].upper() + sentence[1:]
    return sentence if sentence.endswith((".", "!", "?")) else f"{sentence}."


def _side(value: Any) -> int:
    """Return the number of rows of a matrix; 0 for another value."""
    side = math.isqrt(len(value)) if isinstance(value, tuple) else 0
    return side if side >= 3 and side * side == len(value) else 0


def value_text(value: Any, write: Callable[[float], str]) -> str:
    """Write the value of a reading: a number, several, a matrix to typeset, or a word."""
    if value is None:
        return NONE
    if isinstance(value, str):
        return of_phenomena(value)
    if not isinstance(value, tuple):
        return write(value)
    side, parts = _side(value), [write(part) for part in value]
    if not side:
        text, half = f"({listed(parts)})", (len(parts) + 1) // 2
        if len(text) > ON_A_LINE:
            return f"({listed(parts[:half])}{listed(('', ''))[0]}\n{listed(parts[half:])})"
        return text
    return matrix(parts[first : first + side] for first in range(0, len(parts), side))


class _Value(TypesetLabel):
    """The value of a reading; copying it copies all digits."""

    def __init__(self) -> None:
        super().__init__()
        self.is_below = False  # whether the value is below its label
        self.shrinks = True
        self.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)


class Readout(LetteredWidget, QWidget):
    """Label, value and unit of each reading of the scene.

    The first readings are always visible; the others are folded, and not written until they are
    unfolded. A sentence below says why values are missing.
    """

    highlighted = Signal(object)  # the `Highlight` of the reading under the mouse

    def __init__(self) -> None:
        super().__init__()
        self._highlight = NOTHING
        self.lines: list[tuple[PlainLabel, _Value, PlainLabel]] = []
        self._readings: Sequence[Reading] = ()
        self._first = 0
        self._why_closed = ""
        self._grid = QGridLayout()
        self._fit()
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(4)
        self._grid.setColumnStretch(0, 1)
        self.more = tool_button(
            self.tr("More numbers"), self.tr("Show or fold the other numbers of this scene"),
            icon="unfold", name=self.tr("More numbers"), flat=True, checkable=True, by_click=True,
        )  # fmt: skip
        self.more.toggled.connect(self._show)
        self.more.hide()
        self.note = PlainLabel(wordWrap=True, visible=False)
        in_column(self._grid, self.note, self.more, on=self, margins=(0, 0, 0, 0), gap=2)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        all_digits.changed.connect(self._show)
        lettering.changed.connect(self._show)

    def begin(self, first: int) -> None:
        """Begin with another scene, whose first readings (so many) are always visible."""
        self._first = first
        self.more.setChecked(False)

    def show_readings(self, readings: Sequence[Reading]) -> None:
        self._readings = readings
        self._show()

    def close_for(self, why: str) -> None:
        """Show a reason instead of the numbers; without one, show the numbers again."""
        if why != self._why_closed:
            self._why_closed = why
            self._show()

    def _show(self) -> None:
        shown = () if self._why_closed else self._readings
        many = len(shown) > self._first + 1  # folding a single reading would save no space
        unfolded = not many or self.more.isChecked()
        readings = shown if unfolded else shown[: self._first]
        self.more.setVisible(many)
        show_icon(self.more, "choose" if unfolded else "unfold")
        while len(self.lines) < len(readings):
            self._add_line()
        labels = [of_phenomena(reading.label) for reading in readings]
        anew = labels != [label.text() for label, _, _ in self.lines if not label.isHidden()]
        self._mark()
        for place, line in enumerate(self.lines):
            if anew:
                for widget in line:
                    widget.setVisible(place < len(readings))
                line[1].setMinimumWidth(0)
            if place < len(readings):
                self._write(line, readings[place], labels[place])
        reasons = [
            full_sentence(reading.note.sentence(of_phenomena, read_text))
            for reading in readings
            if reading.note is not None
        ]
        if self._why_closed and self._readings:
            reasons = [full_sentence(self._why_closed)]
        self.note.setText(subscripts("\n".join(dict.fromkeys(reasons))))
        self.note.setVisible(bool(reasons))

    def show_highlight(self, highlighted: Highlight) -> None:
        self._highlight = highlighted
        self._mark()

    def _mark(self) -> None:
        for reading, (_, value, _) in zip(self._readings, self.lines, strict=False):
            value.set_marked(bool(self._highlight.intersection(reading.about)))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Enter, QEvent.Type.Leave):
            about: Highlight = NOTHING
            for reading, line in zip(self._readings, self.lines, strict=False):
                if watched in line and event.type() == QEvent.Type.Enter:
                    about = frozenset(reading.about)
            self.highlighted.emit(about)
        return False

    def _add_line(self) -> None:
        label, value, unit = Balanced(), _Value(), PlainLabel()
        unit.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        row = 2 * len(self.lines)
        for column, part in enumerate((label, value, unit)):
            part.hide()
            part.installEventFilter(self)
            self._grid.addWidget(part, row, column)
        value.setObjectName("number")
        self.lines.append((label, value, unit))

    def _write(
        self, line: tuple[PlainLabel, _Value, PlainLabel], reading: Reading, name: str
    ) -> None:
        label, value, unit = line
        value.cell = reading.cell
        exact = in_line(value_text(reading.value, number_text))
        text = value_text(reading.value, read_text)
        is_word = isinstance(reading.value, str)
        if is_word != value.wordWrap():
            value.setWordWrap(is_word)
            value.setMinimumWidth(WORDS_EM * self.fontMetrics().height() if is_word else 0)
        if text != (value.formula or value.text()):
            (value.set_formula if _side(reading.value) else value.set_words)(text)
            self._place(value, max(map(len, text.split("\n"))) > BESIDE and not is_word)
            if not is_word and not _side(reading.value):
                # The width only grows: a shorter number does not shift the others.
                value.setMinimumWidth(max(value.minimumWidth(), value.sizeHint().width()))
        if value.exact != exact:
            value.set_exact(exact)
            set_tip(value, exact)
        if label.text() != name:
            label.setText(name)
            # A screen reader would read a name instead of the number.
            value.setAccessibleDescription(name)
            self._widen(label)
        unit.setText("" if reading.value is None else of_phenomena(reading.unit))

    def _place(self, value: _Value, below: bool) -> None:
        row = 2 * [each[1] for each in self.lines].index(value)
        if below != value.is_below:
            value.is_below = below
            self._grid.addWidget(value, row + below, 0 if below else 1, 1, 3 if below else 1)

    def _widen(self, label: PlainLabel) -> None:
        """Let only a long label wrap."""
        natural = label.fontMetrics().horizontalAdvance(label.text()) + 4
        label.setMinimumWidth(min(natural, LABEL_EM * self.fontMetrics().height()))

    def _fit(self) -> None:
        """Set the size of numbers with a style sheet, because a theme would reset a font."""
        size = self.font().pointSizeF()
        self._grid.setVerticalSpacing(round(BETWEEN_EM * self.fontMetrics().height()))
        sheet = f"#number {{ font-size: {LARGE * size:g}pt; font-weight: 600; }}"
        if sheet != self.styleSheet():
            self.setStyleSheet(sheet)
            for label, value, _ in self.lines:
                value.setMinimumWidth(0)
                self._widen(label)
