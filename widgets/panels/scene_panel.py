"""The explanation panel: what the scene teaches, its lectures and its diagrams.

The scene's settings and numbers are in the `SceneCard` at the top of the dock.
"""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtWidgets import QFrame, QGridLayout, QLayout, QScrollArea, QWidget

from app.scenes.phenomena.illustration import Illustration, Phenomenon
from app.scenes.phenomena.words import Diagram
from widgets.panels.diagram_panel import DiagramPanel
from widgets.parts.layouts import FREE, FocusRing, in_column, in_row
from widgets.parts.messages import breakable, of_phenomena
from widgets.parts.panel import Changed, ShownData
from widgets.parts.plain import PlainLabel, subscripts

WORD = 16  # characters of a file's name that fit into the narrowest column
COLUMN_PX = 200  # least width of a scrolling column
PICTURE = 16.0 / 9.0  # aspect of a diagram that is a picture
MOST_ABREAST = 2  # most diagrams in one row; more of them use two rows if they are larger that way


class ScenePanel(DiagramPanel):
    concerns = frozenset({"illustration"})

    def __init__(self) -> None:
        super().__init__()
        self._phenomenon: Phenomenon | None = None
        self._illustration: Illustration | None = None
        self.title, self.lectures, self.explanation = (PlainLabel(wordWrap=True) for _ in range(3))
        self.title.setObjectName("paneTitle")
        self.lectures.setObjectName("paneNote")
        self.explanation.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        text = in_column(self.title, self.lectures, self.explanation, FREE, gap=2)
        self._drawn = QGridLayout()
        self._drawn.setSpacing(4)
        self._diagram_column = _Column(self._drawn, self.tr("Diagrams"))
        self._diagram_column.installEventFilter(self)
        self._columns_of_diagrams = 0
        columns = ((_Column(text, self.tr("What this scene shows")), 4), self._diagram_column)
        self._columns = in_row(*columns, on=self, margins=(4, 0, 4, 2), gap=12)
        self.show_scene("", None)

    def show_scene(self, title: str, phenomenon: Phenomenon | None) -> None:
        """Show another scene; one without a phenomenon has no explanation."""
        if phenomenon is not self._phenomenon or phenomenon is None:
            self._phenomenon, self._illustration = phenomenon, None
        self.title.setText(breakable(title, WORD))
        lectures = () if phenomenon is None else phenomenon.lectures
        self.lectures.setText(self.tr("Lectures: {0}").format(", ".join(lectures)))
        self.lectures.setVisible(bool(lectures))
        explained = "" if phenomenon is None else of_phenomena(phenomenon.words.explanation)
        self.explanation.setText(subscripts(explained))
        self._show_diagrams(())

    def take(self, shown: ShownData, changed: Changed) -> None:
        self.show_illustration(shown.illustration)

    def show_illustration(self, illustration: Illustration | None) -> None:
        if illustration is not self._illustration:
            anew = self._illustration is None
            self._illustration = illustration
            self._readable.changed()
            if anew:  # the diagrams of the previous scene are gone
                self._readable.settle()

    def _fill(self) -> None:
        self._show_diagrams(() if self._illustration is None else self._illustration.diagrams)

    def _show_diagrams(self, diagrams: Sequence[Diagram], least: int = 0) -> None:
        super()._show_diagrams(diagrams, least)
        self._diagram_column.setVisible(bool(diagrams))
        self._columns.setStretchFactor(self._diagram_column, 6 * len(diagrams))

    def _place_diagrams(self) -> None:
        """Place the diagrams in one row, or in two if they are larger that way."""
        count, size = len(self.diagrams), self._diagram_column.size()
        half = -(-count // 2)
        line = self.fontMetrics().height()
        abreast, above = (
            min(size.width() / columns / PICTURE, size.height() / rows - line)
            for columns, rows in ((max(1, count), 1), (max(1, half), 2))
        )
        columns = half if count > MOST_ABREAST and above > abreast else max(1, count)
        if self._drawn.count() != count or columns != self._columns_of_diagrams:
            self._columns_of_diagrams = columns
            for place, view in enumerate(self.diagrams):
                self._drawn.addWidget(view, place // columns, place % columns)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize and watched is self._diagram_column:
            self._place_diagrams()
        return super().eventFilter(watched, event)


class _Column(QScrollArea):
    """A part of the panel that scrolls independently; its name is for screen readers."""

    def __init__(self, layout: QLayout, name: str) -> None:
        super().__init__(widgetResizable=True)
        inside = QWidget()
        layout.setContentsMargins(0, 0, 4, 0)
        inside.setLayout(layout)
        self.setWidget(inside)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setAccessibleName(name)
        FocusRing(self)

    def minimumSizeHint(self) -> QSize:
        return QSize(COLUMN_PX, 60)

    def sizeHint(self) -> QSize:
        return self.minimumSizeHint()
