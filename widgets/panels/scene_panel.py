"""About the scene: what it teaches, in which lectures, and its diagrams.

Its settings and its numbers are at the top of the dock, in the `SceneCard`.
"""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtWidgets import QFrame, QGridLayout, QLayout, QScrollArea, QWidget

from app.drawings.style import LIGHT, Style
from app.scenes.phenomena.diagram import Diagram
from app.scenes.phenomena.illustration import Illustration, Phenomenon
from widgets.parts.diagram import DiagramView
from widgets.parts.focus import FocusRing
from widgets.parts.layouts import FREE, in_column, in_row
from widgets.parts.messages import breakable, of_phenomena
from widgets.parts.panel import Changed, Shown
from widgets.parts.plain import Label
from widgets.parts.readable import ReadablePanel

LEAST_WINDOW_PX = 900
"""In a window that is so wide it must find room."""
WORD = 16
"""Characters of a file's name that find room in the narrowest column."""
COLUMN_PX = 200
"""Least width of what can scroll to and fro."""
PICTURE = 16.0 / 9.0
"""Width of a picture that is compared with others, over its height."""
MOST_ABREAST = 2
"""So many diagrams always stand side by side; more of them where they are larger so."""


class ScenePanel(ReadablePanel):
    """Explanation and diagrams of the scene at hand, side by side."""

    concerns = frozenset({"illustration"})

    def __init__(self) -> None:
        super().__init__()
        self._phenomenon: Phenomenon | None = None
        self._illustration: Illustration | None = None
        self._style = LIGHT
        self.title, self.lectures, self.explanation = (Label(wordWrap=True) for _ in range(3))
        self.title.setObjectName("paneTitle")
        self.lectures.setObjectName("paneNote")
        self.explanation.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.diagrams: list[DiagramView] = []
        self._lay_out()
        self.show_scene(self.tr("This scene"), None)

    def _lay_out(self) -> None:
        text = in_column(self.title, self.lectures, self.explanation, FREE, gap=2)
        self._drawn = QGridLayout()
        self._drawn.setSpacing(4)
        self._text_column = _Column(text, self.tr("What this scene shows"))
        self._diagram_column = _Column(self._drawn, self.tr("Diagrams"))
        self._columns_of_diagrams = 0
        self._diagram_column.installEventFilter(self)
        columns = ((self._text_column, 4), self._diagram_column)
        self._columns = in_row(*columns, on=self, margins=(4, 0, 4, 2), gap=12)

    def minimumSizeHint(self) -> QSize:
        """Not wider than a small window: rather are the columns scrolled."""
        return QSize(min(super().minimumSizeHint().width(), LEAST_WINDOW_PX), 80)

    # -- what the owner says

    def show_scene(self, title: str, phenomenon: Phenomenon | None) -> None:
        """Show another scene.

        Parameters
        ----------
        title : str
            Translated.
        phenomenon : Phenomenon or None
            None for a scene that shows nothing beyond the pipeline itself.
        """
        if phenomenon is not self._phenomenon or phenomenon is None:
            self._phenomenon, self._illustration = phenomenon, None
        self.title.setText(breakable(title, WORD))
        lectures = () if phenomenon is None else phenomenon.lectures
        self.lectures.setText(self.tr("Lectures: {0}").format(", ".join(lectures)))
        self.lectures.setVisible(bool(lectures))
        self.explanation.setText(
            self.tr("The panes show all that there is to this scene: it has no diagram.")
            if phenomenon is None
            else of_phenomena(phenomenon.explanation)
        )
        self._show_diagrams(())

    def take(self, shown: Shown, changed: Changed) -> None:
        self.show_illustration(shown.illustration)

    def show_illustration(self, illustration: Illustration | None) -> None:
        """Show the diagrams of an illustration."""
        if illustration is self._illustration:
            return
        anew = self._illustration is None
        self._illustration = illustration
        self._readable.changed()
        if anew:  # of the scene before, nothing is to be seen
            self._readable.settle()

    def set_style(self, style: Style) -> None:
        """Draw the diagrams in other colours and sizes; those of the panes."""
        self._style = style
        for diagram in self.diagrams:
            diagram.set_style(style)

    # -- shown

    def _fill(self) -> None:
        self._show_diagrams(() if self._illustration is None else self._illustration.diagrams)

    def _show_diagrams(self, diagrams: Sequence[Diagram]) -> None:
        while len(self.diagrams) < len(diagrams):
            view = DiagramView()
            view.set_style(self._style)
            view.copy_wanted.connect(self.copy_wanted)
            view.export_wanted.connect(self.export_wanted)
            self.diagrams.append(view)
            self._place_diagrams()
        for place, view in enumerate(self.diagrams):
            shown = place < len(diagrams)
            view.setVisible(shown)
            view.show_diagram(diagrams[place] if shown else None)
        self._diagram_column.setVisible(bool(diagrams))
        self._columns.setStretchFactor(self._diagram_column, 6 * len(diagrams))

    def _place_diagrams(self) -> None:
        """In one row, or in two where they are larger so: many are pictures to be compared."""
        count, size = len(self.diagrams), self._diagram_column.size()
        half = -(-count // 2)
        line = self.fontMetrics().height()
        abreast, above = (
            min(size.width() / columns / PICTURE, size.height() / rows - line)
            for columns, rows in ((max(1, count), 1), (max(1, half), 2))
        )
        columns = half if count > MOST_ABREAST and above > abreast else max(1, count)
        if self._drawn.count() == count and columns == self._columns_of_diagrams:
            return
        self._columns_of_diagrams = columns
        for place, view in enumerate(self.diagrams):
            self._drawn.addWidget(view, place // columns, place % columns)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize and watched is self._diagram_column:
            self._place_diagrams()
        return super().eventFilter(watched, event)


class _Column(QScrollArea):
    """A part of the panel that scrolls by itself.

    Parameters
    ----------
    layout : QLayout
        What is in it.
    name : str
        Translated, for screen readers.
    """

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
