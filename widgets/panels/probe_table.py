"""The table of the probes' numbers: formulas in the first column, then four columns a probe."""

import math
from collections.abc import Callable
from typing import Any, TypeAlias

from PySide6 import QtGui, QtWidgets
from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, QRectF, Qt

from app.lecture.highlight import NOTHING, Highlight
from widgets.panels.probe_numbers import DIVIDE, ProbeRows
from widgets.parts.messages import number_text, read_text
from widgets.parts.panel import faded
from widgets.parts.plain import subscripts
from widgets.parts.typeset import in_line, typeset

_Index: TypeAlias = QModelIndex | QPersistentModelIndex
_Role = Qt.ItemDataRole
_PARTS = 4  # columns of a probe: x, y, z, w
_ROOT = QModelIndex()
FORMULA = Qt.ItemDataRole.UserRole  # role of a line's first cell: its formula as `Typeset`
EXACT = Qt.ItemDataRole.UserRole + 1  # role of a cell: the text with all digits, for copying


def _text(row: int, cell: str | float, write: Callable[[float], str]) -> str:
    """Write a cell of a row, which is counted from the end."""
    if isinstance(cell, str):
        return cell
    return f"÷ {write(cell)}" if row == DIVIDE else write(cell)


class _Model(QAbstractTableModel):
    """The model of the table: it writes only the visible cells."""

    def __init__(self) -> None:
        super().__init__()
        self.content = ProbeRows()
        self._highlighted = NOTHING

    def highlight_at(self, index: _Index) -> Highlight:
        """Return the planes named in a cell of the last line."""
        if index.column() == 0 or index.row() != self.rowCount() - 1:
            return NOTHING
        return self.content.outside[(index.column() - 1) // _PARTS]

    def show_highlight(self, highlighted: Highlight) -> None:
        if highlighted != self._highlighted:
            self._highlighted = highlighted
            if self.content.probes:
                row = self.rowCount() - 1
                first, last = self.index(row, 1), self.index(row, self.columnCount() - 1)
                self.dataChanged.emit(first, last, [_Role.BackgroundRole])

    def show(self, content: ProbeRows) -> bool:
        """Show other cells; return whether the lines or columns have changed."""
        anew = content[:2] != self.content[:2]
        if anew:
            self.beginResetModel()
        self.content = content
        if anew:
            self.endResetModel()
        else:
            last = self.index(self.rowCount() - 1, self.columnCount() - 1)
            self.dataChanged.emit(self.index(0, 1), last, [_Role.DisplayRole])
        return anew

    def rowCount(self, parent: _Index = _ROOT) -> int:
        return 0 if parent.isValid() else len(self.content.lines)

    def columnCount(self, parent: _Index = _ROOT) -> int:
        return 0 if parent.isValid() else 1 + _PARTS * len(self.content.probes)

    def data(self, index: _Index, role: int = _Role.DisplayRole) -> Any:
        row, column = index.row(), index.column()
        if role == _Role.BackgroundRole:
            marked = self.highlight_at(index) & self._highlighted
            highlight = QtGui.QGuiApplication.palette().highlight().color()
            return QtGui.QBrush(faded(highlight, 0.35)) if marked else None
        if role not in (_Role.DisplayRole, _Role.ToolTipRole, FORMULA, EXACT):
            return None
        if column == 0:
            formula = self.content.lines[row][1]
            if role == FORMULA:
                return formula
            line = in_line(formula)
            return subscripts(line) if role == _Role.ToolTipRole else line
        probe, part = divmod(column - 1, _PARTS)
        cells = self.content.blocks[probe][row]
        if part >= len(cells) or role == FORMULA:
            return None
        write = read_text if role == _Role.DisplayRole else number_text
        return _text(row - self.rowCount(), cells[part], write)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = _Role.DisplayRole
    ) -> Any:
        if role != _Role.DisplayRole:
            return None
        if orientation == Qt.Orientation.Vertical:
            return self.content.lines[section][0]
        if section == 0:
            return "="
        probe, part = divmod(section - 1, _PARTS)
        return f"{self.content.probes[probe]}: {'xyzw'[part]}"


class ProbeTable(QtWidgets.QTableView):
    """A table that shows four digits of every number and copies all digits."""

    def __init__(self) -> None:
        super().__init__()
        self._model = _Model()
        self.setModel(self._model)
        self._spans: list[tuple[int, int]] = []
        self.highlight_at = self._model.highlight_at
        self.show_highlight = self._model.show_highlight
        self.setItemDelegateForColumn(0, _FormulaDelegate(self))
        copy = QtGui.QAction(self.tr("Copy, with all digits"), self)
        copy.triggered.connect(self._copy)
        self.addAction(copy)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.setMouseTracking(True)
        self.setTabKeyNavigation(False)  # the keyboard could not leave the table
        self.setSelectionMode(QtWidgets.QAbstractItemView.SelectionMode.ContiguousSelection)
        self.setWordWrap(False)
        self.setAlternatingRowColors(True)
        self.setHorizontalScrollMode(QtWidgets.QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.horizontalHeader().setHighlightSections(False)
        self.verticalHeader().setSectionResizeMode(QtWidgets.QHeaderView.ResizeMode.Fixed)
        self.verticalHeader().setMinimumSectionSize(0)

    def show_numbers(self, content: ProbeRows, font: QtGui.QFont, *, anew: bool) -> None:
        """Show the probes' numbers; columns may shrink if they are written `anew`.

        The font is the panel's: a change of font may reach this table too late.
        """
        if self._model.show(content):
            anew, self._spans = True, []
            self.fit_rows(font)
        self._widen(content, font, anew)

    def fit_rows(self, font: QtGui.QFont) -> None:
        """Make each row as high as its formula: a fraction needs more than a line."""
        rows, line = self.verticalHeader(), QtGui.QFontMetrics(font).height()
        rows.setDefaultSectionSize(line + 4)
        for row, (_, formula) in enumerate(self._model.content.lines):
            needed = math.ceil(typeset(formula, font).height)
            rows.resizeSection(row, max(line, needed) + 4)

    def _widen(self, content: ProbeRows, font: QtGui.QFont, anew: bool) -> None:
        """Make every number fully visible: without its last digits it would be wrong."""
        metrics = QtGui.QFontMetrics(font)
        digit = metrics.horizontalAdvance("0")
        if anew:
            widest = max(typeset(formula, font).width for _, formula in content.lines)
            self.setColumnWidth(0, math.ceil(widest) + 2 * digit)
        spans: list[tuple[int, int]] = []
        for i, lines in enumerate(content.blocks):
            first = 1 + _PARTS * i
            lengths: list[list[int]] = [[] for _ in range(_PARTS)]
            words = 0
            for row, line in enumerate(lines):
                if len(line) == 1 and isinstance(line[0], str):  # a text across all four columns
                    spans.append((row, first))
                    words = max(words, metrics.horizontalAdvance(line[0]))
                    continue
                for part, cell in enumerate(line):
                    lengths[part].append(len(_text(row - len(lines), cell, read_text)))
            for column, column_lengths in enumerate(lengths, first):
                width = digit * (max(column_lengths, default=4) + 2)
                if anew or width > self.columnWidth(column):
                    self.setColumnWidth(column, width)
            block = range(first, first + _PARTS)
            missing = words + 2 * digit - sum(map(self.columnWidth, block))
            for column in block if missing > 0 else ():
                self.setColumnWidth(column, self.columnWidth(column) + math.ceil(missing / _PARTS))
        if spans != self._spans:
            self.clearSpans()
            for row, column in spans:
                self.setSpan(row, column, 1, _PARTS)
            self._spans = spans

    def _copy(self) -> None:
        """Copy the selected cells, with tabs between the columns."""
        rows: dict[int, list[str]] = {}
        for index in sorted(self.selectedIndexes(), key=lambda at: (at.row(), at.column())):
            rows.setdefault(index.row(), []).append(index.data(EXACT) or "")
        QtGui.QGuiApplication.clipboard().setText("\n".join(map("\t".join, rows.values())))

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        if event.matches(QtGui.QKeySequence.StandardKey.Copy):
            self._copy()
        else:
            super().keyPressEvent(event)


class _FormulaDelegate(QtWidgets.QStyledItemDelegate):
    """Paints the formulas of the lines."""

    def initStyleOption(self, option: QtWidgets.QStyleOptionViewItem, index: _Index) -> None:
        super().initStyleOption(option, index)
        option.text = ""  # the delegate paints only the background

    def paint(
        self, painter: QtGui.QPainter, option: QtWidgets.QStyleOptionViewItem, index: _Index
    ) -> None:
        super().paint(painter, option, index)
        own = QtWidgets.QStyleOptionViewItem(option)
        self.initStyleOption(own, index)
        formula = typeset(index.data(FORMULA), own.font)
        roles = QtGui.QPalette.ColorRole
        is_selected = bool(own.state & QtWidgets.QStyle.StateFlag.State_Selected)
        painter.save()
        painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        painter.setPen(own.palette.color(roles.HighlightedText if is_selected else roles.Text))
        base = QRectF(own.rect).center().y() + formula.below_middle
        formula.paint(painter, own.rect.left() + 3.0, base)
        painter.restore()
