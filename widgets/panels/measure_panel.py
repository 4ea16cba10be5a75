"""Measure: what speed costs in accuracy on this machine, for the present scene and camera.

::

    Measure here --> Measuring (another process) --> Measurements, one for each trade or sweep
    results that the program brings --------------> grey, until there are others
    a file of results ----------------------------> drawn thinner over those of this machine
    a click on a point or a row --> used({"rung": "float32"})
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from PySide6 import QtWidgets
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QFont, QGuiApplication, QIcon, QPalette

from app.document.document import Document
from app.document.files import write_bytes_atomically
from app.drawings.style import Style
from app.measure import chart, single
from app.measure.meaning import ANY_SCENE, bargain, boldest, meaning, shown_by
from app.measure.results import (
    SWEPT,
    ChartPoint,
    Measurements,
    Sweep,
    Trade,
    named,
    of_measure,
    table,
    to_csv,
    to_json,
)
from app.model.refusal import MEASURE, Refusal
from app.scenes.phenomena.words import Diagram
from widgets.panels.diagram_panel import DiagramPanel
from widgets.panels.measuring import Measuring
from widgets.parts.icons import icon
from widgets.parts.layouts import FREE, FittedWidget, FocusRing, in_column, in_row
from widgets.parts.messages import all_digits, sentence
from widgets.parts.panel import Changed, ShownData
from widgets.parts.plain import PlainLabel, set_tip
from widgets.parts.wording import Wording

WORDS = Wording(__file__)
ENDINGS = (".csv", ".json", *chart.ENDINGS)  # endings of the export formats
NOTE_LETTERS = 24  # least width of the column of notes, in letters, unless the notes are shorter
_HUES = ("ink", "near", "far", "u", "v", "n", "eye", "target", "frustum", "accent")
_NAME = Qt.ItemDataRole.UserRole


class _ResultsTable(FittedWidget, QtWidgets.QTableWidget):
    """A table of whole rows, whose last column, the notes, has the remaining width."""

    def __init__(self) -> None:
        super().__init__()
        self._least_notes = 0
        self.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectionBehavior.SelectRows)
        self.setTabKeyNavigation(False)  # the keyboard could not leave the table
        self.setSelectionMode(QtWidgets.QAbstractItemView.SelectionMode.SingleSelection)
        self.verticalHeader().hide()
        self.setMinimumSize(200, 40)
        self.horizontalHeader().sectionResized.connect(self._fit)

    def fit_columns(self) -> None:
        header = self.horizontalHeader()
        header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeMode.Interactive)
        self._least_notes = 0
        self.resizeColumnsToContents()
        if self.rowCount():
            words = self.fontMetrics().averageCharWidth() * NOTE_LETTERS
            self._least_notes = min(words, header.sectionSize(header.count() - 1))
            header.resizeSection(header.count() - 1, self._least_notes)
        self._fit()

    def _fit(self) -> None:
        header = self.horizontalHeader()
        last = header.count() - 1
        if self._least_notes and last >= 0:
            room = self.viewport().width() - header.sectionPosition(last)
            header.resizeSection(last, max(room, self._least_notes))
        self.resizeRowsToContents()


class MeasurePanel(DiagramPanel):
    """Runs measurements, and shows each as a chart, a table and a sentence.

    `document` returns the document to measure, `current` what is in use, as of `ChartPoint.use`.
    `smoothings` are those that the panes can draw with. The widget `precision` stands above the
    list.
    """

    used = Signal(object)  # the `use` of a choice that was clicked: a dict of str
    refusal_withdrawn = Signal(str)
    """The sentence of a refusal that no longer applies, because the panel was used again."""
    succeeded = Signal()  # a file was read or written

    def __init__(
        self,
        document: Callable[[], Document],
        current: Callable[[], Mapping[str, str]],
        smoothings: Sequence[str],
        precision: QtWidgets.QWidget,
    ) -> None:
        super().__init__()
        self._document, self._current, self._smoothings = document, current, smoothings
        self._gestures = 0
        self._picked = ""  # the choice that was clicked last, until the document changes
        self._refusal = ""  # the last refusal, until the panel is used again
        self._asked: list[str] = []  # the trades and sweeps that are being measured
        self.measured: dict[str, Measurements] = {}
        """The last results of every trade and sweep, by name; each holds only that one."""
        self.loaded: dict[str, Measurements] = {}  # the results from a file, by name
        self.words: dict[str, str] = {}  # why a trade or sweep has no results
        self.measuring = Measuring(self)
        self.measuring.progressed.connect(lambda part: self.progress.setValue(round(1000 * part)))
        self.measuring.finished.connect(self._finished)
        controls = self._make_controls()
        self._make_views()
        left = in_column(precision, (self.list, 1), controls, gap=3)
        below = in_row(FREE, self.cost, self.run_button, margins=(0, 0, 0, 0))
        middle = in_column((self._drawn, 1), below, gap=0)
        right = in_column(self.sentence, (self.table, 1), gap=3)
        in_row(left, (middle, 6), (right, 5), on=self, margins=(4, 0, 4, 2), gap=8)
        self._show_running()
        self._readable.changed()

    def _make_controls(self) -> QtWidgets.QGridLayout:
        self.list = QtWidgets.QListWidget()
        self.list.setSelectionMode(QtWidgets.QAbstractItemView.SelectionMode.ExtendedSelection)
        WORDS.name(self.list, "list")
        for name, title in chart.TITLES.items():
            QtWidgets.QListWidgetItem(of_measure(title), self.list).setData(_NAME, name)
        self.list.setCurrentRow(0)
        self.list.currentItemChanged.connect(self._withdraw_refusal)
        self.list.currentItemChanged.connect(self._readable.changed)
        self.list.setMinimumHeight(40)
        self.list.setSizePolicy(
            QtWidgets.QSizePolicy.Policy.Preferred, QtWidgets.QSizePolicy.Policy.Ignored
        )
        self.how = WORDS.combo("how", {"quick": True, "full": False})
        self.run_button = WORDS.push("run", self.run)
        self.run_button.setObjectName("measureHere")  # the style sheet makes it large
        self.cancel_button = WORDS.push("cancel", self.measuring.cancel)
        self.progress = QtWidgets.QProgressBar()
        self.progress.setRange(0, 1000)
        self.progress.setAccessibleName(WORDS.say("progress"))
        self.progress.setSizePolicy(
            QtWidgets.QSizePolicy.Policy.Ignored, QtWidgets.QSizePolicy.Policy.Preferred
        )
        self.progress.hide()
        self.export_button = WORDS.push("export", self.export_dialog)
        self.load_button = WORDS.push("load", self.load_dialog)
        self.forget_button = WORDS.push("forget", self.forget)
        self.cost = WORDS.combo("cost")
        self.cost.currentIndexChanged.connect(self._withdraw_refusal)
        self.cost.currentIndexChanged.connect(self._readable.changed)
        buttons = QtWidgets.QGridLayout()
        buttons.setSpacing(3)
        for row, widgets in (
            (0, (self.how, self.cancel_button, self.progress)),
            (1, (self.export_button, self.load_button, self.forget_button)),
        ):
            for column, widget in enumerate(widgets):
                buttons.addWidget(widget, row, column)
        for button in (self.cancel_button, self.export_button, self.load_button):
            button.setMinimumWidth(60)
        return buttons

    def _make_views(self) -> None:
        self._drawn = in_row(margins=(0, 0, 0, 0))
        selectable = Qt.TextInteractionFlag.TextSelectableByMouse
        self.sentence = PlainLabel(wordWrap=True, textInteractionFlags=selectable)
        self.table = _ResultsTable()
        self.table.setAccessibleName(WORDS.say("results"))
        for shown in (self.list, self.table):
            FocusRing(shown)
        self.table.cellClicked.connect(self._row_used)
        self.table.cellActivated.connect(self._row_used)

    def _place_diagrams(self) -> None:
        self.diagrams[-1].spot_clicked.connect(self._spot_used)
        self._drawn.addWidget(self.diagrams[-1], 1)

    def heightForWidth(self, _width: int) -> int:
        return self.minimumSizeHint().height()  # texts wrap, but chart, list and table give way

    # -- called by the owner

    def begin_gesture(self) -> None:
        """Pause the measurement while a control is dragged or something plays."""
        self._gestures += 1
        self._show_running()

    def end_gesture(self) -> None:
        """Resume the measurement when the last gesture has ended."""
        self._gestures = max(0, self._gestures - 1)
        self._show_running()

    def take(self, shown: ShownData, changed: Changed) -> None:
        self._picked = ""
        if "scene" in changed:
            here = shown.document.scene
            own = [name for name in chart.TITLES if shown_by(name).get("scene") == here]
            if own and self.name not in own:
                self.choose(*own)
        self._readable.changed()  # another choice may be in use

    def show_trade(self, name: str) -> None:
        """Show a trade with the choice that saves most, and the scene that shows what it costs."""
        self.used.emit({"scene": ANY_SCENE} | shown_by(name))
        self.choose(name)
        shown, _ = self._shown()
        part = single.only_part(shown) if shown is not None else None
        bold = boldest(part) if isinstance(part, Trade) else None
        if bold is not None:
            cost, choice = bold
            self.cost.setCurrentIndex(self.cost.findData(cost))
            self._picked = choice.name
        self._readable.changed()

    def set_style(self, style: Style) -> None:
        super().set_style(style)
        self._readable.changed()  # the style may have another font, which changes the columns

    def close_process(self) -> None:
        self.measuring.kill()
        self._show_running()

    # -- measuring

    @property
    def name(self) -> str:
        """The trade or sweep that is shown."""
        return str(self.list.currentItem().data(_NAME))

    @property
    def chosen(self) -> list[str]:
        """The trades and sweeps to measure."""
        items = self.list.selectedItems() or [self.list.currentItem()]
        return [str(item.data(_NAME)) for item in sorted(items, key=self.list.row)]

    def choose(self, *names: str) -> None:
        """Choose trades and sweeps, and show the last of them."""
        rows = [row for row, name in enumerate(chart.TITLES) if name in names]
        self.list.clearSelection()
        self.list.setCurrentRow(rows[-1])
        for row in range(self.list.count()):
            self.list.item(row).setSelected(row in rows)

    def run(self) -> None:
        if self.measuring.running:
            return
        self._withdraw_refusal()
        self._asked = self.chosen
        self.progress.setValue(0)
        trades = [name for name in self._asked if name not in SWEPT]
        sweeps = [name for name in self._asked if name in SWEPT]
        self.measuring.start(self._document(), trades, sweeps, quick=self.how.currentData())
        self._show_running()

    def _finished(self, results: Measurements | None, said: str) -> None:
        measured = {} if results is None else single.split(results)
        missing = [name for name in self._asked if name not in measured]
        cancelled = results is not None and not results.complete
        for name in self._asked:
            self.words.pop(name, None)
        self.measured |= measured
        if missing and not cancelled:  # after a cancellation, older or shipped results stay
            for name in missing:
                self.words[name] = said
                self.measured.pop(name, None)
            self._refuse(said)
        done = not cancelled and any(map(single.has_numbers, measured.values()))
        self.progress.setValue(1000 if done else 0)
        self._show_running()
        self._readable.changed()

    def _show_running(self) -> None:
        running = self.measuring.running
        self.run_button.setEnabled(not running)
        self.cancel_button.setEnabled(running)
        self.progress.setVisible(running)
        paused = self._gestures > 0
        self.measuring.set_paused(paused)
        self.progress.setFormat(WORDS.say("paused") if paused and running else "%p %")

    # -- files

    def export_dialog(self) -> None:
        title, kinds, kind = WORDS["export-as"]
        path, _ = QtWidgets.QFileDialog.getSaveFileName(
            self, title, f"{self.name}.pdf", kinds, kind
        )
        if path:
            self.export(Path(path))

    def export(self, path: Path) -> bool:
        """Save what is shown, in the format of the file's ending; return whether that worked."""
        shown, other = self._shown()
        ending = path.suffix.lower()
        if shown is None or self._is_shipped:
            self._refuse(WORDS.say("nothing"))
            return False
        if ending not in ENDINGS:
            self._refuse(WORDS.say("ending", path, ", ".join(ENDINGS)))
            return False
        QGuiApplication.setOverrideCursor(Qt.CursorShape.WaitCursor)
        try:
            if ending == ".csv":
                parts = [single.only_part(each) for each in (shown, other) if each]
                content = "\n".join(map(to_csv, parts)).encode()
            elif ending == ".json":
                content = to_json(shown).encode()
            else:
                priced = [each and each.by_cost(self.cost.currentData()) for each in (shown, other)]
                from widgets.parts.chart_picture import picture

                content = picture(priced[0] or shown, path.name, self._current(), priced[1])
            write_bytes_atomically(path, content)
        except Refusal as error:
            self._refuse(sentence(error))
            return False
        finally:
            QGuiApplication.restoreOverrideCursor()
        self.succeeded.emit()
        return True

    def load_dialog(self) -> None:
        """Ask for a file of results, and draw it over the measured ones."""
        title, kinds = WORDS["load-from"]
        path, _ = QtWidgets.QFileDialog.getOpenFileName(self, title, "", kinds)
        if path:
            self.load(Path(path))

    def load(self, path: Path) -> bool:
        """Draw the results of a file over the measured ones; return whether that worked."""
        try:
            results = single.read_results(path)
        except OSError as error:
            self._refuse(WORDS.say("unreadable", path.name, error.strerror or error))
            return False
        except Refusal as error:
            self._refuse(sentence(error))
            return False
        self.loaded = single.split(results)
        if self.name not in self.loaded and self.loaded:
            self.choose(next(iter(self.loaded)))
        self.succeeded.emit()
        self._readable.changed()
        return True

    def forget(self) -> None:
        """Remove the results of the file."""
        self.loaded = {}
        self._readable.changed()

    # -- showing

    def _shown(self) -> tuple[Measurements | None, Measurements | None]:
        """Return the results that are shown, and those drawn thinner over them."""
        measured, loaded = self.measured.get(self.name), self.loaded.get(self.name)
        if self._is_shipped:
            return single.shipped().get(self.name), None
        return (measured, loaded) if measured is not None else (loaded, None)

    @property
    def _is_shipped(self) -> bool:
        """Whether the results are those that the program brings."""
        return not any(self.name in own for own in (self.measured, self.loaded, self.words))

    def _fill(self) -> None:
        shown, other = self._shown()
        self.list.setIconSize(QSize(1, 1) * self.list.fontMetrics().height())
        for row, name in enumerate(chart.TITLES):
            both = (self.measured.get(name), self.loaded.get(name))
            has = any(each and single.has_numbers(each) for each in both)
            self.list.item(row).setIcon(icon("check") if has else QIcon())
        self.forget_button.setEnabled(bool(self.loaded))
        self.export_button.setEnabled(shown is not None and not self._is_shipped)
        self._show_chart(shown, other)
        self._show_table(shown, other)
        words = self.words.get(self.name, "")
        if shown is not None and self._is_shipped:
            words = WORDS.say("shipped", chart.machine(shown))
        elif shown is None and self._is_shipped:
            words = WORDS.say("none")
        if shown is None:
            said = words
        else:
            part = self._priced(shown)
            said = ""
            if isinstance(part, Trade):  # the clicked choice, or else the one in use
                picked = next((c for c in part.choices if c.name == self._picked), None)
                chosen = picked or chart.in_use(part, self._current())
                said = bargain(part, chosen) if chosen else ""
                said = f"{said} {meaning(part)}".strip()
            if not part.complete:
                said = f"{chart.title(part)}. {said}"
            said = f"{words} {said}" if words else said
            if not self._is_shipped:
                said = "\n".join(filter(None, (said, chart.where(shown), chart.seen(shown))))
        self.sentence.setText(said)
        self.sentence.setVisible(bool(said))

    def _priced(self, results: Measurements) -> Trade | Sweep:
        """Return the only part of split results, by the chosen cost."""
        return single.only_part(results.by_cost(self.cost.currentData()))

    def _show_chart(self, shown: Measurements | None, other: Measurements | None) -> None:
        diagrams: tuple[Diagram, ...] = ()
        if shown is not None:
            over = self._priced(other) if other is not None else None
            name = chart.machine(other) if other is not None else ""
            part, current = self._priced(shown), self._current()
            diagrams = chart.diagrams(part, current, over, name)
        self._show_diagrams(diagrams, least=1)
        style = self._style
        if self._is_shipped:
            style = replace(style, **dict.fromkeys(_HUES, style.muted))  # type: ignore[arg-type]
        for view in self.diagrams:
            view.set_style(style)

    def _show_table(self, shown: Measurements | None, other: Measurements | None) -> None:
        heads: list[str] = []
        rows: list[list[str]] = []
        if shown is not None:
            heads, *rows = table(single.only_part(shown), all_digits=all_digits.now)
            if other is not None:
                heads, rows = single.joined_tables(
                    heads, rows, *single.rows_of_other(other, all_digits.now)
                )
        elif self.name in self.words:
            heads, rows = ["", ""], [["", self.words[self.name]]]
        choices = self._choices()
        set_tip(self.table, WORDS.say("choices" if choices else "values"))
        self.table.setVisible(bool(rows))
        self.table.setRowCount(len(rows))
        self.table.setColumnCount(len(heads))
        self.table.setHorizontalHeaderLabels([named(head) for head in heads])
        for y, row in enumerate(rows):
            trade, choice = choices[y] if y < len(choices) else (None, None)
            self._show_row(y, row, trade, choice)
        self.table.fit_columns()

    def _show_row(
        self, y: int, row: Sequence[str], trade: Trade | None, choice: ChartPoint | None
    ) -> None:
        why = self._why_not(choice) if choice is not None else ""
        slanted = QFont(self.table.font())
        slanted.setItalic(True)
        for x, text in enumerate(row):
            cell = QtWidgets.QTableWidgetItem(named(text))
            if why:
                cell.setFont(slanted)
                if x == 0 and choice is not None and choice.cost is not None:
                    cell.setText(WORDS.say("measured-only", cell.text()))
            is_beaten = trade is not None and choice is not None and trade.is_beaten(choice)
            if is_beaten or self._is_shipped:
                cell.setForeground(self.palette().brush(QPalette.ColorRole.PlaceholderText))
            set_tip(cell, "\n".join(filter(None, (named(row[-1]), why))))
            if 0 < x < len(row) - 1:
                cell.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            self.table.setItem(y, x, cell)

    # -- using

    def _choices(self) -> list[tuple[Trade, ChartPoint]]:
        """Return the choices of the rows, in order, with their trades."""
        parts = [self._priced(each) for each in self._shown() if each is not None]
        return [(part, c) for part in parts if isinstance(part, Trade) for c in part.choices]

    def _refuse(self, text: str) -> None:
        self._refusal = text
        self.refused.emit(text)

    def _withdraw_refusal(self, *_: object) -> None:
        if self._refusal:
            said, self._refusal = self._refusal, ""
            self.refusal_withdrawn.emit(said)

    def _row_used(self, row: int, column: int = 0) -> None:
        self._withdraw_refusal()
        choices, (shown, _) = self._choices(), self._shown()
        if row >= len(choices):
            use = {}
            if shown is not None and shown.sweeps:
                use = shown.sweeps[0].use(row, column, shown.document.get("lens"))
            if use:
                self.used.emit(use)
            return
        choice = choices[row][1]
        why = self._why_not(choice)
        if not why:
            self.used.emit(dict(choice.use))
            return
        self._picked = choice.name
        self._readable.changed()
        self.table.clearSelection()  # a selected row would look as if it were in use
        if choice.name:
            self._refuse(why)

    def _spot_used(self, key: str) -> None:
        choices = self._choices()
        if choices:
            row = next(row for row, (_, choice) in enumerate(choices) if choice.name == key)
            self.table.selectRow(row)
            self._row_used(row)
        else:  # a point of a sweep's curve
            row, column = map(int, key.split(","))
            self.table.setCurrentCell(row, column)
            self._row_used(row, column)

    def _why_not(self, choice: ChartPoint) -> str:
        """Say why the panes cannot use a choice; empty if they can."""
        if choice.use and choice.use.get("smoothing", "none") in self._smoothings:
            return ""
        return of_measure(MEASURE["measured-only"]).format(named(choice.name))
