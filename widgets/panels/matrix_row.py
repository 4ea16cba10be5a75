"""The matrices side by side: boxes in a row that scrolls, with an arrow at each end."""

import textwrap
from collections.abc import Callable, Sequence

from PySide6.QtCore import QCoreApplication, QEvent, QPoint, Qt, Signal
from PySide6.QtWidgets import QSizePolicy, QSpacerItem, QWidget

from app.lecture.highlight import Highlight
from app.lecture.notation import WrittenMatrix
from app.lecture.titles import stage_title
from widgets.panels.matrix_view import MatrixNotation, MatrixView
from widgets.parts.icons import show_icon
from widgets.parts.layouts import FREE, Part, in_column, in_row, scrolled, tool_button
from widgets.parts.plain import PlainLabel, set_tip, subscripts

_NOTE_CHARACTERS = 40  # characters in a line of a note under a narrow matrix


def _named(matrix: WrittenMatrix, title: str) -> str:
    """Add the lecture's name of a matrix, with its subscripts, to a title."""
    return subscripts(f"{title} = {matrix.called}" if matrix.called else title)


class MatrixBox(QWidget):
    """A matrix below its name; a button unfolds its factors beside it."""

    unfolded = Signal(bool)

    def __init__(
        self, matrix: WrittenMatrix, new_view: Callable[[str], MatrixView], *, unfolded: bool
    ) -> None:
        super().__init__()
        self.name = matrix.name
        self._title = PlainLabel(objectName="paneTitle")
        self._note = PlainLabel(objectName="paneNote", visible=False)
        fold = self.fold = tool_button(
            "", self.tr("Show the factors of this matrix"),
            name=self.tr("Factors of {0}").format(stage_title(matrix.name)),
            flat=True, checkable=True,
        )  # fmt: skip
        fold.setChecked(unfolded)
        fixed = fold.sizePolicy()
        fixed.setRetainSizeWhenHidden(True)  # titles without a button would stand higher
        fold.setSizePolicy(fixed)
        fold.setVisible(bool(matrix.factors))
        self.view = new_view(matrix.name)
        self.factor_views = [new_view(factor.name) for factor in matrix.factors]
        self._factor_names = [PlainLabel() for _ in matrix.factors]
        self._factors = QWidget()
        inner: list[Part] = []
        for view, name in zip(self.factor_views, self._factor_names, strict=True):
            inner += PlainLabel("·" if inner else "="), in_column(view, name, FREE, gap=1)
        in_row(*inner, on=self._factors, margins=(0, 0, 0, 0), gap=4)
        both = in_row((self.view, Qt.AlignmentFlag.AlignTop), self._factors, FREE, gap=4)
        title = in_row(self._title, fold, FREE, gap=4)
        in_column(title, both, self._note, FREE, on=self, margins=(0, 0, 6, 0), gap=1)
        self._unfold(unfolded)
        fold.toggled.connect(self._unfold)
        fold.toggled.connect(self.unfolded)

    @property
    def views(self) -> tuple[MatrixView, ...]:
        return (self.view, *self.factor_views)

    def _unfold(self, unfolded: bool) -> None:
        self._factors.setVisible(unfolded and bool(self.factor_views))
        show_icon(self.fold, "back" if unfolded else "unfold")

    def show_matrix(
        self,
        matrix: WrittenMatrix,
        before: WrittenMatrix | None,
        title: str,
        note: str,
        writing: MatrixNotation,
    ) -> None:
        self._title.setText(_named(matrix, title))
        tip = stage_title(matrix.name)
        if matrix.product:
            tip = f"{tip} = {' · '.join(f'({stage_title(name)})' for name in matrix.product)}"
        set_tip(self._title, tip)
        self.view.show_matrix(matrix, before, writing)
        fitting = self.view.width() // max(self._note.fontMetrics().averageCharWidth(), 1)
        wide = max(_NOTE_CHARACTERS, fitting - 2)
        lines = (textwrap.fill(each, wide, break_on_hyphens=False) for each in note.splitlines())
        self._note.setText(subscripts("\n".join(lines)))
        self._note.setVisible(bool(note))
        earlier: Sequence[WrittenMatrix | None] = before.factors if before else ()
        if len(earlier) != len(matrix.factors):
            earlier = [None] * len(matrix.factors)
        rows = zip(self.factor_views, self._factor_names, matrix.factors, earlier, strict=True)
        for view, name, factor, old in rows:
            name.setText(_named(factor, stage_title(factor.name)))
            view.show_matrix(factor, old, writing)

    def mark_reached(self, is_reached: bool) -> None:
        """Highlight the title of the matrix that leads to the stop of the stage strip."""
        title = self._title
        if bool(title.property("reached")) != is_reached:
            title.setProperty("reached", is_reached)
            title.setAccessibleDescription(self.tr("the stage strip is here") if is_reached else "")
            title.style().polish(title)


class MatrixRow(QWidget):
    """A row of boxes that scrolls; an arrow appears at each end beyond which there is more."""

    def __init__(self) -> None:
        super().__init__()
        self.boxes: list[MatrixBox] = []
        self._gap: QSpacerItem | None = None  # keeps a matrix in place if its neighbours disappear
        self._content = QWidget()
        self._row = in_row(FREE, on=self._content, margins=(2, 0, 2, 0), gap=6)
        self._scroll = scrolled(self._content, self.tr("Matrices"))
        self._bar = self._scroll.horizontalScrollBar()
        tip = self.tr("More matrices: show the next one that is cut off or hidden")
        left, right = self.tr("Matrices to the left"), self.tr("Matrices to the right")
        self._to_left = tool_button("", tip, self._go_left, icon="back", name=left, flat=True)
        self._to_right = tool_button("", tip, self._go_right, icon="unfold", name=right, flat=True)
        policy = QSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Ignored)
        policy.setRetainSizeWhenHidden(True)  # or the matrices would move while they are read
        for end in (self._to_left, self._to_right):
            end.setSizePolicy(policy)
        self._bar.valueChanged.connect(self._show_ends)
        self._bar.rangeChanged.connect(self._show_ends)
        self._show_ends()
        parts = (self._to_left, (self._scroll, 1), self._to_right)
        in_row(*parts, on=self, margins=(0, 0, 0, 0), gap=0)

    def fill(self, boxes: list[MatrixBox]) -> None:
        self.close_gap()
        for box in self.boxes:
            for view in box.views:
                view.abandon()  # hiding the field would commit its text
            self._row.removeWidget(box)
            box.hide()
            for view in box.views:
                view.pointed.disconnect()  # a mouse button held on it still sends it moves
                view.highlighted.disconnect()
            box.deleteLater()
        self.boxes = boxes
        for place, box in enumerate(boxes):
            self._row.insertWidget(place, box, 0, Qt.AlignmentFlag.AlignTop)
            box.show()

    # -- scrolling

    def _show_ends(self) -> None:
        self._to_left.setVisible(self._bar.value() > self._bar.minimum())
        self._to_right.setVisible(self._bar.value() < self._bar.maximum())

    def _go_left(self) -> None:
        """Scroll so that the last matrix cut off at the left moves to the right end."""
        page, now = self._bar.pageStep(), self._bar.value()
        ends = [box.geometry().right() + 1 - page for box in self.boxes if box.x() < now]
        if ends:  # a matrix wider than the page scrolls by a page
            self._bar.setValue(ends[-1] if ends[-1] < now else now - page)

    def _go_right(self) -> None:
        """Scroll so that the first matrix cut off at the right moves to the left end."""
        page, now = self._bar.pageStep(), self._bar.value()
        starts = [box.x() for box in self.boxes if box.geometry().right() >= now + page]
        if starts:
            self._bar.setValue(starts[0] if starts[0] > now else now + page)

    def scroll_to(self, box: MatrixBox) -> None:
        """Scroll so that a box is fully visible and none is cut off at the left."""
        margin = self.boxes[0].x()
        least = box.geometry().right() + 1 - self._bar.pageStep()
        wanted = min(max(self._bar.value(), least), box.x() - margin)
        starts = (each.x() - margin for each in self.boxes)
        self._bar.setValue(min(start for start in starts if start >= wanted))

    def show_rows(self, highlighted: Highlight) -> None:
        """Scroll to the matrix whose rows are highlighted as coordinates of clip space."""
        if any(name.startswith("clip_") for name in highlighted):
            for box in self.boxes:
                if box.name == "clip_from_view":
                    self._scroll.ensureWidgetVisible(box.view, 8, 0)

    def left_of(self, view: MatrixView) -> int:
        """Return the left edge of a view in the visible part of the row, in px."""
        return view.mapTo(self._scroll.viewport(), QPoint()).x()

    def keep_in_place(self, view: MatrixView, left_px: int) -> None:
        """Move a view back to its place after neighbours have appeared or disappeared."""

        def scroll() -> int:
            """Scroll as far as possible; return how far the view still has to move, in px."""
            QCoreApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest.value)
            # The gap posts no layout request while one of a matrix is pending.
            QCoreApplication.sendEvent(self._content, QEvent(QEvent.Type.LayoutRequest))
            self._bar.setValue(self._bar.value() + self.left_of(view) - left_px)
            return left_px - self.left_of(view)

        away = scroll()
        if away:  # the end of the scroll bar is reached
            self._gap = QSpacerItem(abs(away), 0)
            before = next(i for i, box in enumerate(self.boxes) if view in box.views)
            self._row.insertItem(before if away > 0 else len(self.boxes), self._gap)
            scroll()

    def close_gap(self) -> None:
        """Remove the gap that `keep_in_place` has made."""
        if self._gap is not None:
            self._row.removeItem(self._gap)
            self._gap = None
