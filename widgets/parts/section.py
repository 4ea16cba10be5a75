"""A part of the dock: rows with their bindings, optionally below a title or a folding heading.

A `Binding` connects a row with the model by two functions, `read` and `write`. Rows that show one
value in several ways (fov and focal length, orbit and vectors) are several bindings.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.model.projection import Projection
from widgets.parts.buttons import tool_button
from widgets.parts.fields import ChoiceRow, Option, Row
from widgets.parts.icons import show_icon
from widgets.parts.layouts import in_column
from widgets.parts.messages import field_name
from widgets.parts.number_rows import NumberRow
from widgets.parts.plain import PlainLabel, set_tip
from widgets.parts.scales import Log, Scale

Read: TypeAlias = Callable[[Projection], Any]
Write: TypeAlias = Callable[[Projection, Any], Projection]
Keep: TypeAlias = Callable[[Projection, Any, Projection], None]
Of: TypeAlias = Literal["lens", "camera", "image_size", "depth", "placement"]
PARTS: tuple[Of, ...] = ("lens", "camera", "image_size", "depth", "placement")


def tidy(number: float) -> float:
    """Round a computed number to 13 digits: 60 comes back as 60, not as 60.00000000000001."""
    return float(f"{number:.13g}")


class TypedMemory:
    """Keeps typed numbers that the model does not keep.

    Computed from the model, they would contain rounding errors, and some would be lost: the
    azimuth of a camera straight above its target, the direction of depth that recedes by 0.

    Parameters
    ----------
    source : callable
        Returns the part of a projection that the numbers are computed from.
    compute : callable
        Returns a named tuple of the numbers of a projection.
    apply : callable
        Returns a projection with other numbers.
    """

    def __init__(
        self,
        source: Callable[[Projection], Hashable],
        compute: Callable[[Projection], Any],
        apply: Callable[[Projection, Any], Projection],
    ) -> None:
        self._source, self._compute, self._apply = source, compute, apply
        self._kept: tuple[Hashable, Any] = (None, None)
        self._computed: tuple[Hashable, Any] = (None, None)

    def numbers(self, projection: Projection) -> Any:
        """Return the numbers; typed ones keep all their digits."""
        now = self._source(projection)
        for source, numbers in (self._kept, self._computed):
            if source == now:
                return numbers
        computed = self._compute(projection)
        self._computed = now, type(computed)(*map(tidy, computed))
        return self._computed[1]

    def access(self, name: str) -> tuple[Read, Write, Keep]:
        """Return the functions with which a `Binding` shows one of the numbers."""

        def read(projection: Projection) -> float:
            return float(getattr(self.numbers(projection), name))

        def changed(projection: Projection, value: float) -> Any:
            return self.numbers(projection)._replace(**{name: value})

        def write(projection: Projection, value: float) -> Projection:
            return self._apply(projection, changed(projection, value))

        def keep(before: Projection, value: float, after: Projection) -> None:
            self._kept = self._source(after), changed(before, value)

        return read, write, keep


@dataclass(frozen=True)
class Binding:
    """A row and the value of the model that it shows.

    Parameters
    ----------
    field : str
        The model's name of the value.
    part : str
        The field of `Projection` that the value belongs to; only a change there can remove an
        error.
    read, write : callable
        Return the value of a projection, and a projection with another value.
    keep : callable, optional
        Called after an accepted edit with the projection before, the value, the projection after.
    lenses : tuple of str
        The kinds of lens that have this value; empty if every lens has it.
    """

    row: Row
    field: str
    part: Of
    read: Read
    write: Write
    keep: Keep | None = None
    lenses: tuple[str, ...] = ()


GAP_PX = 6
"""Between the rows."""


class Rows(QWidget):
    """Rows, one below the other, with their bindings by key; `body` holds the rows."""

    def __init__(self) -> None:
        super().__init__()
        self.bindings: dict[str, Binding] = {}
        self._order: list[QWidget] = []
        self._titles: list[PlainLabel] = []
        self.body = QWidget()
        self._rows = in_column(on=self.body, margins=(0, 0, 0, GAP_PX), gap=GAP_PX)
        self._column = in_column(self.body, on=self, margins=(0, 0, 0, 0), gap=2)

    @property
    def is_open(self) -> bool:
        return True

    def show_some(self, matches: set[QWidget] | None) -> None:
        """Show the part if it has one of the found rows; None always shows it."""
        here = (row for row in self._order if row.parent() is self.body)
        self.setVisible(matches is None or any(row in matches for row in here))

    # -- rows

    def add_number(
        self, key: str, part: Of, tip: str, scale: Scale, unit: str, unit_tip: str,
        read: Read, write: Write, keep: Keep | None = None, *, name: str = "", field: str = "",
        lenses: tuple[str, ...] = (),
    ) -> NumberRow:  # fmt: skip
        """Add a number; without a name its row has the model's name for `key`."""
        row = NumberRow(name or field_name(key), tip, scale, unit, unit_tip)
        self._bind(key, Binding(row, field or key, part, read, write, keep, lenses))
        return row

    def add_length(
        self, key: str, tip: str, read: Read, write: Write, lenses: tuple[str, ...]
    ) -> NumberRow:
        """Add a lens's length in world units; the scene sets the slider's scale later."""
        return self.add_number(
            key, "lens", tip, Log(1.0, 10.0), self.tr("units"), self.tr("world units"),
            read, write, lenses=lenses,
        )  # fmt: skip

    def add_choice(
        self, key: str, part: Of, tip: str, choices: Sequence[Option], read: Read, write: Write,
        *, buttons: bool = False, none: str = "", name: str = "", lenses: tuple[str, ...] = (),
    ) -> ChoiceRow:  # fmt: skip
        """Add a choice; see `ChoiceRow`."""
        row = ChoiceRow(name or field_name(key), tip, choices, buttons=buttons, none=none)
        self._bind(key, Binding(row, key, part, read, write, None, lenses))
        return row

    def _bind(self, key: str, binding: Binding) -> None:
        self.bindings[key] = binding
        self.add(binding.row)

    def add(self, widget: QWidget) -> None:
        self._order.append(widget)
        self._rows.addWidget(widget)

    def add_title(self, text: str) -> None:
        """Add a quiet title of the rows that follow."""
        title = PlainLabel(text)
        quiet(title)
        self._titles.append(title)
        self.add(title)

    def show_titles(self) -> None:
        """Show the quiet titles that have a shown row below them."""
        for title in self._titles:
            rows = self._order[self._order.index(title) + 1 :]
            below = itertools.takewhile(lambda row: row not in self._titles, rows)
            title.setVisible(any(not row.isHidden() for row in below))

    def return_borrowed(self) -> None:
        """Return every borrowed row to its place."""
        for place, widget in enumerate(self._order):
            if widget.parent() is not self.body:
                self._rows.insertWidget(place, widget)


class TitledRows(Rows):
    """Rows below a quiet title."""

    def __init__(self, title: str) -> None:
        super().__init__()
        self.title = PlainLabel(title)
        quiet(self.title)
        self._column.insertWidget(0, self.title)


def quiet(label: PlainLabel) -> None:
    """Make a label a quiet title."""
    label.setObjectName("quietTitle")  # for the application's style sheet


class Section(Rows):
    """Rows below a heading that folds them by a click, Space, Enter, ← or →."""

    toggled = Signal(bool)

    def __init__(self, title: str) -> None:
        super().__init__()
        self.heading = tool_button(
            title, act=self._turn, icon="unfold", name=title, flat=True, by_click=True
        )
        self.heading.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.heading.installEventFilter(self)
        self._column.setSpacing(0)
        self._column.insertWidget(0, self.heading)
        self._is_open = False
        self._matches: set[QWidget] | None = None
        self._why_closed = ""
        self.set_open(False)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Handle the heading's keys before the button moves the focus by arrows."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            key, keys = event.key(), Qt.Key
            if key in (keys.Key_Return, keys.Key_Enter):
                self._turn()
                return True
            if key in (keys.Key_Left, keys.Key_Right):
                if self.is_open != (key == keys.Key_Right):
                    self.set_open(key == keys.Key_Right)
                return True
        return super().eventFilter(watched, event)

    @property
    def is_open(self) -> bool:
        """Whether the rows below the heading are shown."""
        return not self._why_closed and (self._is_open or self._matches is not None)

    def close_for(self, why: str) -> None:
        """Keep the rows folded for a reason; without one, show them as they were before."""
        if why != self._why_closed:
            self._why_closed = why
            self.heading.setEnabled(not why)
            self._show()

    def _turn(self) -> None:
        self.set_open(not self.is_open)

    def set_open(self, is_open: bool) -> None:
        """Fold or unfold."""
        self._is_open = is_open
        self._show()

    def show_some(self, matches: set[QWidget] | None) -> None:
        """Unfold while the part has one of the found rows; None restores the state before."""
        super().show_some(matches)
        if matches is None or not self.isHidden():
            self._matches = matches
            self._show()

    def _show(self) -> None:
        is_open = self.is_open
        self.body.setVisible(is_open)
        show_icon(self.heading, "choose" if is_open else "unfold")
        turn = self.tr("Fold") if is_open else self.tr("Unfold")
        set_tip(self.heading, self._why_closed or turn)
        self.heading.setAccessibleDescription(self.tr("unfolded") if is_open else self.tr("folded"))
        self.toggled.emit(is_open)
