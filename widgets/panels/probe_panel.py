"""The probes: points that are followed through every stage, and their numbers.

The numbers are those that the command `project` prints for the same points, computed by the same
precision; four digits of them are read, and all are copied. They belong to how the document is
looked at: a probe is a question, not a part of the scene. A panel that is folded fills no table.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeAlias

from PySide6.QtCore import (
    QAbstractTableModel,
    QEvent,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QRectF,
    Qt,
    Signal,
)
from PySide6.QtGui import (
    QAction,
    QBrush,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QPainter,
    QPalette,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)

from app.document.view import MOST_PROBES
from app.lecture.highlight import NOTHING, Highlight, made_of
from app.lecture.notation import clip_signs, steps_of_a_point
from app.model.formula import stacked_fraction
from app.model.infinity import homogeneous
from app.model.limits import finite
from app.model.projection import PLANES, Projection, Trace, Vector
from app.model.refusal import Refusal
from app.picking.picking import Probe, projector
from app.precision.levels import precision_for_reading, predict, trace_homogeneous
from widgets.parts.buttons import push_button
from widgets.parts.combo import Combo
from widgets.parts.highlight import faded
from widgets.parts.icons import RefusalLabel, icon
from widgets.parts.layouts import in_column, in_row
from widgets.parts.messages import number_text, plane_name, read_text, sentence
from widgets.parts.number_field import ShortField, refusal
from widgets.parts.panel import PROJECTION, Changed, Shown
from widgets.parts.plain import Label, set_tip
from widgets.parts.readable import ReadablePanel
from widgets.parts.typeset import in_line, typeset
from widgets.parts.writing import all_digits, lettering

_PIN_SHEET = """
QPushButton:checked {
    background: palette(highlight); color: palette(highlighted-text);
    border: 1px solid palette(mid); border-radius: 3px;
}
"""
"""Fusion hardly shows whether a dark button is down."""

_PARTS = 4  # columns of a probe: x, y, z, w
_DIVIDE = 4  # the line in which what is divided by stands behind its sign
_ROOT = QModelIndex()
FORMULA = Qt.ItemDataRole.UserRole
"""Of a line's first cell: its formula, as of `widgets.parts.typeset`."""
EXACT = Qt.ItemDataRole.UserRole + 1
"""Of a cell: what is copied."""


class ProbePanel(ReadablePanel):
    """The probes, what can be done to them, and the table of their numbers.

    Attributes
    ----------
    probes : tuple of Probe
        Those that are marked in the panes, in the order of the table.
    """

    concerns = PROJECTION
    changed = Signal()
    """There are other probes now."""

    def __init__(self) -> None:
        super().__init__()
        self.probes: tuple[Probe, ...] = ()
        self._pinned: set[int] = set()
        self._chosen = 0  # number of the probe that is edited; 0 for none
        self._projection: Projection | None = None
        self._spans: list[tuple[int, int]] = []
        self._is_new = False

        self.choice = Combo()
        self.choice.setSizeAdjustPolicy(Combo.SizeAdjustPolicy.AdjustToContents)
        self.choice.setAccessibleName(self.tr("Probe"))
        set_tip(self.choice, self.tr("Which probe the fields and buttons are about"))
        self.choice.activated.connect(lambda index: self.choose(self.choice.itemData(index)))
        self.fields = tuple(ShortField(name) for name in "xyzw")
        self.pin = push_button(
            self.tr("Pin"),
            self.tr("Keep this probe: the next click makes another one"),
            self._pin_clicked,
        )
        self.pin.setCheckable(True)
        self.pin.setStyleSheet(_PIN_SHEET)
        self._remove = push_button(
            self.tr("Remove"), self.tr("Remove this probe (Esc)"), self.remove
        )
        self._clear = push_button(self.tr("Clear"), self.tr("Remove all probes"), self.clear)
        self.error = RefusalLabel()
        self._hint = Label(
            self.tr(
                "Click a point in any pane to follow it from the world to its pixel; "
                "click beside everything in the image for that pixel's ray."
            ),
            wordWrap=True,
        )

        self._model = _Table(self)
        self.table = _TableView(self._model)
        self.table.setMouseTracking(True)
        self.table.entered.connect(
            lambda index: self.highlighted.emit(self._model.highlight_at(index))
        )
        self.table.viewportEntered.connect(lambda: self.highlighted.emit(NOTHING))
        self.table.viewport().installEventFilter(self)
        self.table.setAccessibleName(self.tr("The probes' numbers at every stage"))
        self.table.setTabKeyNavigation(False)  # or the keyboard never leaves it
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
        self.table.setWordWrap(False)
        self.table.setAlternatingRowColors(True)
        self.table.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.table.horizontalHeader().setHighlightSections(False)
        rows = self.table.verticalHeader()
        rows.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        rows.setMinimumSectionSize(0)
        all_digits.changed.connect(self._turn)
        lettering.changed.connect(self._turn)
        self._lay_out()
        self._fit_rows()
        self._show_choice()

    def _lay_out(self) -> None:
        line = in_row(self.choice)
        for name, field in zip("xyzw", self.fields, strict=True):
            field.setAccessibleName(self.tr("Probe, world {0}").format(name))
            set_tip(field, self.tr("World {0} of the probe; type a number").format(name))
            field.editingFinished.connect(self._typed)
            label = Label(name)
            label.setBuddy(field)
            line.addWidget(label)
            line.addWidget(field, 1)
        set_tip(
            self.fields[3],
            self.tr(
                "w of the probe: 1 for a point; 0 for the point at infinity in the direction"
                " x, y, z; with any other w the point is (x/w, y/w, z/w)"
            ),
        )
        for button in (self.pin, self._remove, self._clear):
            line.addWidget(button)
        parts = (line, self.error, self._hint, (self.table, 1))
        in_column(*parts, on=self, margins=(4, 0, 4, 2), gap=2)

    def hasHeightForWidth(self) -> bool:
        return False  # the sentences wrap, but it is the table that wants height

    # -- the probes

    @property
    def chosen(self) -> Probe | None:
        """The probe that the fields and the buttons are about."""
        return next((probe for probe in self.probes if probe.number == self._chosen), None)

    def follow(
        self,
        *,
        point: Vector | None = None,
        pixel: tuple[float, float] | None = None,
        direction: Vector | None = None,
    ) -> None:
        """Follow a point, or a pixel's ray: with the chosen probe, unless it is pinned.

        Parameters
        ----------
        point : Vector, optional
            World coordinates.
        pixel : (float, float), optional
            Of the image.
        direction : Vector, optional
            A point at infinity, in world coordinates.
        """
        number = self._chosen
        if not number or number in self._pinned:
            # One that nobody pinned is in use; only where all are kept is there need of another.
            loose = [p.number for p in self.probes if p.number not in self._pinned]
            taken = {probe.number for probe in self.probes}
            free = [n for n in range(1, MOST_PROBES + 1) if n not in taken]
            if not loose and not free:
                text = self.tr("Probes = {0}: at most {1} can be pinned; remove one first.")
                self.refused.emit(text.format(len(self.probes) + 1, MOST_PROBES))
                return
            number = (loose or free)[0]
        self._chosen = number
        self._put(Probe(number, point, pixel, direction))

    @property
    def pinned(self) -> frozenset[int]:
        """Numbers of the probes that the next click leaves alone."""
        return frozenset(self._pinned)

    def restore(
        self, probes: tuple[Probe, ...], chosen: int, pinned: frozenset[int] | None = None
    ) -> None:
        """Go back to earlier probes.

        Parameters
        ----------
        probes : tuple of Probe
        chosen : int
            Number of the chosen one; 0 for none.
        pinned : frozenset of int, optional
            Numbers of those that are kept by the next click; as they are now if not given.
        """
        self._chosen = chosen
        if pinned is not None:
            self._pinned = set(pinned)
        self._set(probes)

    def put(self, number: int, point: Vector) -> None:
        """Put a probe elsewhere, pinned or not."""
        self._put(Probe(number, point))

    def choose(self, number: int) -> None:
        """Let the fields and buttons be about another probe."""
        self._chosen = number
        self._show_choice()

    def remove(self) -> None:
        """Remove the chosen probe; the last one left is chosen then."""
        probes = tuple(probe for probe in self.probes if probe.number != self._chosen)
        self._pinned.discard(self._chosen)
        self._chosen = probes[-1].number if probes else 0
        self._set(probes)

    def clear(self) -> None:
        """Remove them all."""
        self._pinned.clear()
        self._chosen = 0
        self._set(())

    def _put(self, new: Probe) -> None:
        others = [probe for probe in self.probes if probe.number != new.number]
        self._set(tuple(sorted([*others, new], key=lambda probe: probe.number)))

    def _set(self, probes: tuple[Probe, ...]) -> None:
        if probes != self.probes:
            self.probes = probes
            self.changed.emit()
            self._readable.changed()
        self._show_choice()

    def _pin_clicked(self, pinned: bool) -> None:
        if pinned:
            self._pinned.add(self._chosen)
        else:
            self._pinned.discard(self._chosen)
        self._show_choice()

    # -- the fields

    def _typed(self) -> None:
        """Take the three fields over, or say what is wrong with one of them."""
        if not any(field.isModified() for field in self.fields):
            return
        probe = self.chosen
        row: list[object] = list((probe and probe.row) or (0.0, 0.0, 0.0, 1.0))
        field = self.fields[3]
        try:
            for axis, (name, field) in enumerate(zip("xyzw", self.fields, strict=True)):
                if field.isModified():
                    row[axis] = finite(name, field.read())
            found = Probe.of(self._chosen, homogeneous(*row))
        except Refusal as error:
            self.error.say(refusal(sentence(error)))
            field.setAccessibleDescription(self.error.text())
            return
        if not self._chosen:
            self.follow(point=found.point, direction=found.direction)
        else:
            self._put(found)
        self._show_choice()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and any(field.isModified() for field in self.fields):
            self._show_choice()  # takes back what was typed
        else:
            super().keyPressEvent(event)

    def _show_choice(self) -> None:
        probe = self.chosen
        self.choice.clear()
        for other in self.probes:
            name = self._name(other)
            self.choice.addItem(name, other.number)
            if other.number in self._pinned:
                place, role = self.choice.count() - 1, Qt.ItemDataRole.AccessibleTextRole
                self.choice.setItemIcon(place, icon("pin"))
                self.choice.setItemData(place, self.tr("{0}, pinned").format(name), role)
        self.choice.setCurrentIndex(self.choice.findData(self._chosen))
        self.choice.setEnabled(bool(self.probes))
        row = None if probe is None else probe.row
        for axis, field in enumerate(self.fields):
            field.show_number(None if row is None else row[axis])
            field.take_back()
            field.setAccessibleDescription("")
        self.error.say("")
        self.pin.setChecked(self._chosen in self._pinned)
        for button in (self.pin, self._remove):
            button.setEnabled(probe is not None)
        self._clear.setEnabled(bool(self.probes))
        self._hint.setVisible(not self.probes)
        self.table.setVisible(bool(self.probes))

    def _name(self, probe: Probe) -> str:
        text = self.tr("Ray {0}") if probe.pixel is not None else self.tr("Point {0}")
        if probe.direction is not None:
            text = self.tr("Direction {0}")
        return text.format(probe.number)

    # -- the table

    def _fit_rows(self) -> None:
        rows = self.table.verticalHeader()
        rows.setDefaultSectionSize(self.fontMetrics().height() + 4)
        for row, line in enumerate(self._model.lines):
            rows.resizeSection(row, self._height_of(line))

    def _height_of(self, line: tuple[str, str]) -> int:
        """Of a line of the table, by its name and formula: a fraction needs more."""
        formula = math.ceil(typeset(line[1], self.font()).height)
        return max(self.fontMetrics().height(), formula) + 4

    def _turn(self) -> None:
        self._is_new = True
        self._readable.changed()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:  # projector mode
            self._fit_rows()
            self._turn()

    def take(self, shown: Shown, changed: Changed) -> None:
        self._projection = shown.projection
        self._readable.changed()

    def show_highlight(self, highlighted: Highlight) -> None:
        """Mark the words that are about what is highlighted."""
        self._model.show_highlight(made_of(highlighted))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Leave:
            self.highlighted.emit(NOTHING)
        return super().eventFilter(watched, event)

    def _fill(self) -> None:
        if self._projection is None:
            return
        projection = self._projection
        rows = [probe.row for probe in self.probes if probe.row is not None]
        followed: Trace | None = None
        if rows:
            points = [probe.point for probe in self.probes if probe.point is not None]
            bounds = predict(projection, points) if points else None
            followed = trace_homogeneous(projection, rows, precision_for_reading(bounds))
        formulas = self._formulas(projection)
        columns: list[_Block] = []
        outside, row = [], 0
        for probe in self.probes:
            if probe.row is None or followed is None:
                columns.append(self._of_ray(projection, probe))
                outside.append(NOTHING)
            else:
                point = Trace(*(part[row] for part in followed))
                columns.append(self._of_point(projection, point))
                outside.append(frozenset(_outside_of(point)))
                row += 1
        numbers = [probe.number for probe in self.probes]
        anew = self._model.show(numbers, formulas, columns, outside)
        if anew:
            self._spans = []
            self._fit_rows()
        self._widen(columns, anew or self._is_new)
        self._is_new = False

    def _widen(self, columns: list[_Block], anew: bool) -> None:
        """Let every number be seen whole: one without its last digits would be another."""
        metrics = self.fontMetrics()  # a change of font may reach the table after its panel
        digit = metrics.horizontalAdvance("0")
        if anew:
            longest = max(typeset(text, self.font()).width for _, text in self._model.lines)
            self.table.setColumnWidth(0, math.ceil(longest) + 2 * digit)
        # Words, where there are no numbers, are said across all four columns.
        spans = [
            (row, 1 + _PARTS * i)
            for i, lines in enumerate(columns)
            for row, line in enumerate(lines)
            if len(line) == 1 and isinstance(line[0], str)
        ]
        if spans != self._spans:
            self.table.clearSpans()
            for row, column in spans:
                self.table.setSpan(row, column, 1, _PARTS)
            self._spans = spans
        for i, lines in enumerate(columns):
            numbers = [
                [_text(row, cell, read_text) for cell in line]
                for row, line in enumerate(lines)
                if (row, 1 + _PARTS * i) not in spans
            ]
            for part in range(_PARTS):
                longest = max([len(line[part]) for line in numbers if part < len(line)], default=4)
                column = 1 + _PARTS * i + part
                width = digit * (longest + 2)
                if anew or width > self.table.columnWidth(column):
                    self.table.setColumnWidth(column, width)
            words = [line[0] for line in lines if len(line) == 1 and isinstance(line[0], str)]
            longest = max(map(metrics.horizontalAdvance, words), default=0) + 2 * digit
            block = range(1 + _PARTS * i, 1 + _PARTS * (i + 1))
            missing = longest - sum(map(self.table.columnWidth, block))
            for column in block if missing > 0 else ():
                width = self.table.columnWidth(column) + math.ceil(missing / _PARTS)
                self.table.setColumnWidth(column, width)

    def _formulas(self, projection: Projection) -> list[tuple[str, str]]:
        """Name and formula of every line, as of `widgets.parts.typeset`."""
        directions = any(probe.direction for probe in self.probes)
        steps = steps_of_a_point(projection, lettering.now, directions=directions)
        inside = steps["between"]
        if projection.lens.planes is None:
            low = "0" if min(projection.depth_range) == 0.0 else "−w"
            inside = f"{low} ≤ z ≤ w"
        depth = stacked_fraction(steps["depth"], "2") if projection.depth == "opengl" else "z"
        w = "w" if clip_signs(projection, lettering.now)[3] > 0 else "|w|"
        image = f"(x + 1) {stacked_fraction('W', '2')},  (1 − y) {stacked_fraction('H', '2')}"
        return [
            (self.tr("object"), "p"),
            (self.tr("world"), steps["world"]),
            (self.tr("view"), steps["view"]),
            (self.tr("clip"), f"{steps['clip']};  w = {steps['w']}"),
            (self.tr("divide"), "÷ w"),
            (self.tr("NDC"), ",  ".join(stacked_fraction(part, "w") for part in "xyz")),
            (self.tr("image px"), image),
            (self.tr("depth"), depth),
            (self.tr("inside"), f"|x|, |y| ≤ {w};  {inside}"),
        ]

    def _of_point(self, projection: Projection, point: Trace) -> _Block:
        """What is in a point's lines."""
        signs = clip_signs(projection, lettering.now)
        world, view = _cells(point.world), _cells(point.view)
        clip = _cells(point.clip * signs)
        at_infinity = point.world[3] == 0.0
        outside_of = _outside_of(point)
        if outside_of:
            names = ", ".join(map(plane_name, outside_of))
            inside = self.tr("outside of: {0}").format(names)
        else:
            inside = self.tr("inside")
        lines: _Block = [self._of_object(projection, point), world, view, clip]
        if point.in_front:
            ndc = _cells(point.ndc * signs[:3] * signs[3])
            lines += [clip[3:] * 3, ndc, _cells(point.image), _cells(point.depth)]
            if at_infinity:
                inside = self.tr("the vanishing point; {0}").format(inside)
        else:
            w, more = float(point.clip[3]), list[str | float]()
            if at_infinity and w < 0.0:
                why = self.tr("behind the eye: no picture")
                more = [self.tr("the opposite direction has one")]
            elif at_infinity and not projection.clip_from_view[3, :3].any():  # w is that of p
                why = self.tr("w = 0: its picture is at infinity too")
                more = [self.tr("parallel projectors: lines stay parallel")]
            elif at_infinity and w == 0.0:
                why = self.tr("w = 0: its picture is at infinity too")
                more = [self.tr("parallel to the image: lines stay parallel")]
            elif w < 0.0:
                why = self.tr("behind the eye")
            elif w == 0.0:
                why = self.tr("in the eye plane (w = 0)")
            else:
                why = self.tr("beside the eye: no number is large enough")
            lines += [[why], more, [], []]
        return [*lines, [inside]]

    def _of_object(self, projection: Projection, point: Trace) -> _Line:
        """Where a point of the world is on the object, wherever that stands."""
        try:
            return list(projection.placement.object_from_world(point.world.tolist()))
        except Refusal:
            return [self.tr("none: a scale of 0 has flattened the object")]

    def _of_ray(self, projection: Projection, probe: Probe) -> _Block:
        """What is in a ray's lines: it has x and y only, and these from the pixel."""
        assert probe.pixel is not None
        (x, y), (width, height) = probe.pixel, projection.image_size
        ndc: _Line = [2.0 * x / width - 1.0, 1.0 - 2.0 * y / height]
        image: _Line = [x, y]
        return [[self._ray(projection, probe)], [], [], [], [], ndc, image, [], []]

    def _ray(self, projection: Projection, probe: Probe) -> str:
        """What of a pixel's ray is drawn in the world, or why there is none."""
        if projection.frustum_sign:
            return self.tr("the pixel's ray, from near to far")
        if projector(projection, probe, [0.0]) is not None:
            return self.tr("the pixel's ray, as far as it is in front of the eye")
        try:
            projection.world_from_clip_at(projection.camera.eye)
        except Refusal:
            return self.tr("no ray in the world: the matrix has no inverse")
        return self.tr("no ray in the world: all of it is behind the eye")


def _outside_of(point: Trace) -> list[str]:
    """The planes of the view volume that a point is outside of."""
    return [plane for plane, is_out in zip(PLANES, point.outside.tolist(), strict=True) if is_out]


_Line: TypeAlias = list[str | float]
_Block: TypeAlias = list[_Line]
"""Of a probe, line by line: its numbers, or one text across them."""


def _cells(values: Any) -> _Line:
    """Numbers as `project` has them, without a minus zero."""
    return list((values + 0.0).reshape(-1).tolist())


def _text(row: int, cell: str | float, write: Callable[[float], str]) -> str:
    """What stands in a cell of a row."""
    if isinstance(cell, str):
        return cell
    return f"÷ {write(cell)}" if row == _DIVIDE else write(cell)


class _Table(QAbstractTableModel):
    """Cells in blocks of four columns, one block for each probe; asked only for what is seen."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._numbers: list[int] = []
        self.lines: list[tuple[str, str]] = []
        """Name and formula of each."""
        self._columns: list[_Block] = []
        self._outside: list[Highlight] = []
        self._highlighted = NOTHING

    def highlight_at(self, index: QModelIndex) -> Highlight:
        """What a cell is about: the last line is about planes."""
        if index.column() == 0 or index.row() != self.rowCount() - 1:
            return NOTHING
        return self._outside[(index.column() - 1) // _PARTS]

    def show_highlight(self, highlighted: Highlight) -> None:
        """Mark the cells that are about what is highlighted."""
        if highlighted != self._highlighted:
            self._highlighted = highlighted
            if self._numbers:
                row = self.rowCount() - 1
                first, last = self.index(row, 1), self.index(row, self.columnCount() - 1)
                self.dataChanged.emit(first, last, [Qt.ItemDataRole.BackgroundRole])

    def show(
        self,
        numbers: list[int],
        formulas: list[tuple[str, str]],
        columns: list[_Block],
        outside: list[Highlight],
    ) -> bool:
        """Show other cells; tell whether there are other columns."""
        anew = numbers != self._numbers or formulas != self.lines
        if anew:
            self.beginResetModel()
        self._numbers, self.lines, self._columns = numbers, formulas, columns
        self._outside = outside
        if anew:
            self.endResetModel()
        else:
            last = self.index(self.rowCount() - 1, self.columnCount() - 1)
            self.dataChanged.emit(self.index(0, 1), last, [Qt.ItemDataRole.DisplayRole])
        return anew

    def rowCount(self, parent: QModelIndex | QPersistentModelIndex = _ROOT) -> int:
        return 0 if parent.isValid() else len(self.lines)

    def columnCount(self, parent: QModelIndex | QPersistentModelIndex = _ROOT) -> int:
        return 0 if parent.isValid() else 1 + _PARTS * len(self._numbers)

    def data(
        self, index: QModelIndex | QPersistentModelIndex, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        row, column = index.row(), index.column()
        if role == Qt.ItemDataRole.BackgroundRole:
            marked = self.highlight_at(self.index(row, column)) & self._highlighted
            highlight = QGuiApplication.palette().highlight().color()
            return QBrush(faded(highlight, 0.35)) if marked else None
        roles = Qt.ItemDataRole
        if role not in (roles.DisplayRole, roles.ToolTipRole, FORMULA, EXACT):
            return None
        if column == 0:
            formula = self.lines[row][1]
            return formula if role == FORMULA else in_line(formula)
        probe, part = divmod(column - 1, _PARTS)
        cells = self._columns[probe][row]
        if part >= len(cells) or role == FORMULA:
            return None
        write = read_text if role == roles.DisplayRole else number_text
        return _text(row, cells[part], write)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        if orientation == Qt.Orientation.Vertical:
            return self.lines[section][0]
        if section == 0:
            return "="
        probe, part = divmod(section - 1, _PARTS)
        return f"{self._numbers[probe]}: {'xyzw'[part]}"


class _TableView(QTableView):
    """The table; what is copied of it has all the digits."""

    def __init__(self, model: _Table) -> None:
        super().__init__()
        self.setModel(model)
        self.setItemDelegateForColumn(0, _FormulaDelegate(self))
        copy = QAction(self.tr("Copy with all digits"), self)
        copy.triggered.connect(self._copy)
        self.addAction(copy)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)

    def _copy(self) -> None:
        """What is selected, its columns with tabs between them."""
        rows: dict[int, list[str]] = {}
        for index in sorted(self.selectedIndexes(), key=lambda at: (at.row(), at.column())):
            rows.setdefault(index.row(), []).append(index.data(EXACT) or "")
        QGuiApplication.clipboard().setText("\n".join(map("\t".join, rows.values())))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Copy):
            self._copy()
        else:
            super().keyPressEvent(event)


class _FormulaDelegate(QStyledItemDelegate):
    """Paints the formulas of the lines."""

    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().initStyleOption(option, index)
        option.text = ""  # its ground and its selection are painted as ever

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        super().paint(painter, option, index)
        own = QStyleOptionViewItem(option)
        self.initStyleOption(own, index)
        formula = typeset(index.data(FORMULA), own.font)
        roles = QPalette.ColorRole
        is_selected = bool(own.state & QStyle.StateFlag.State_Selected)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(own.palette.color(roles.HighlightedText if is_selected else roles.Text))
        base = QRectF(own.rect).center().y() + formula.below_middle
        formula.paint(painter, own.rect.left() + 3.0, base)
        painter.restore()
