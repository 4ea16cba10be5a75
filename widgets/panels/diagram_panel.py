"""A panel with diagrams: their views, and a width that fits a small window too."""

from abc import abstractmethod
from collections.abc import Sequence

from PySide6.QtCore import QSize

from app.drawings.style import Style
from app.scenes.phenomena.words import Diagram
from widgets.parts.diagram import DiagramView
from widgets.parts.panel import ReadablePanel

LEAST_WINDOW_PX = 900  # the panel must fit into a window of this width


class DiagramPanel(ReadablePanel):
    """A panel with as many views as it ever showed diagrams at once; unused views are hidden."""

    def __init__(self) -> None:
        super().__init__()
        self.diagrams: list[DiagramView] = []

    def minimumSizeHint(self) -> QSize:
        return QSize(min(super().minimumSizeHint().width(), LEAST_WINDOW_PX), 80)

    def set_style(self, style: Style) -> None:
        self._style = style
        for diagram in self.diagrams:
            diagram.set_style(style)

    @abstractmethod
    def _place_diagrams(self) -> None:
        """Put all views into the layout; called when a view was added."""

    def _show_diagrams(self, diagrams: Sequence[Diagram], least: int = 0) -> None:
        """Show diagrams, and empty views up to a total of `least`."""
        count = max(least, len(diagrams))
        while len(self.diagrams) < count:
            view = DiagramView()
            view.set_style(self._style)
            view.copy_wanted.connect(self.copy_wanted)
            view.export_wanted.connect(self.export_wanted)
            self.diagrams.append(view)
            self._place_diagrams()
        for place, view in enumerate(self.diagrams):
            view.setVisible(place < count)
            view.show_diagram(diagrams[place] if place < len(diagrams) else None)
