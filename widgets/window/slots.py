"""The layout of the panes: one large and two small, side by side, or one alone.

::

    "pictures"                     "columns"
    +---------------+---------+    +------+------+------+
    |               | small   |    |      |      |      |
    |  large        +---------+    |      |      |      |
    |               | small   |    |      |      |      |
    +---------------+---------+    +------+------+------+

    "pictures" for a class, unless the large pane is the NDC cube, which is as wide as high
    +-------------------------+
    |          large          |
    +------------+------------+
    |   small    |   small    |
    +------------+------------+

    While a panel is open below, a class sees the large pane beside the small ones again.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QSplitter

from app.document.view import LAYOUTS
from widgets.panes.pane import Pane
from widgets.panes.stage_strip import StageStrip
from widgets.parts.panel import Changed, Shown

COLUMN_WIDTHS = [400, 305, 330]
LARGE_AND_SMALL = [584, 486]
IMAGE_AND_SMALL = [640, 430]
UPPER_AND_LOWER = [318, 378]
"""In pixels of a window of 1366x768; the splitters keep the proportion."""
TOP_AND_BOTTOM = {"world": [583, 493], "image": [566, 510]}
SIDE_BY_SIDE = [750, 734]
CUBE_AND_SMALL = [735, 790]
LOW_AND_SMALL = [850, 634]
"""For a class, in pixels of a screen of 1920x1080."""
LEAST_PANE_PX = (190, 150)
SMALL = {"world": ("image", "ndc"), "image": ("world", "ndc"), "ndc": ("world", "image")}
"""The small panes for each large one, from top to bottom."""


class Slots(QSplitter):
    """The panes, docked or floating, in the order of their columns and of their keys.

    Attributes
    ----------
    layout_name : str
        One of `LAYOUTS`.
    large : str
        The pane in the large slot.
    leading : str
        The pane that the scene is about.
    whole : str
        The pane that fills the window, or "".
    """

    concerns = frozenset({"scene"})
    rearranged = Signal()
    """A pane has moved to another place."""

    def __init__(self, panes: Mapping[str, Pane], strip: StageStrip) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._panes, self._strip = panes, strip
        self.layout_name, self.large, self.whole = LAYOUTS[0], next(iter(panes)), ""
        self.leading = self.large
        self._is_for_class = self._is_low = self._is_by_hand = False
        self._by_hand: tuple[list[int], list[int]] | None = None
        """The sizes that the user had chosen before presenting."""
        self._small = QSplitter(Qt.Orientation.Vertical)
        for splitter in (self, self._small):
            splitter.setChildrenCollapsible(False)
            splitter.splitterMoved.connect(self._dragged)
        for name, pane in panes.items():
            pane.setMinimumSize(*LEAST_PANE_PX)
            pane.enlarge_requested.connect(partial(self.bring, name))
            pane.float_requested.connect(partial(self.toggle_float, name))
        for name in (self.large, *SMALL[self.large]):
            (self if name == self.large else self._small).addWidget(panes[name])
        self.addWidget(self._small)
        self.share()

    @property
    def floating(self) -> tuple[str, ...]:
        """The panes that have their own windows."""
        return tuple(name for name, pane in self._panes.items() if pane.isWindow())

    def bring(self, name: str) -> None:
        """Bring a docked pane into the large slot; if it is there, let it fill the window."""
        if name in self.floating:
            return
        if self.whole:
            fills = name != self.whole
        else:
            fills = name == self.large or self.layout_name == "columns"
        self.arrange(self.layout_name, name, name if fills else "")

    def arrange(self, layout: str, large: str, whole: str = "") -> None:
        """Give every docked pane its place.

        Parameters
        ----------
        large : str
            The pane for the large slot; "" for the one that the scene is about.
        whole : str
            The pane that fills the window; "" for none.
        """
        large = large or self.leading
        if (layout, large, whole) == (self.layout_name, self.large, self.whole):
            return
        moved = (layout, large) != (self.layout_name, self.large)
        kept = self.sizes(), self._small.sizes()
        stays = self._is_by_hand and layout == self.layout_name and not self.whole and not whole
        was_wide = self._is_wide
        self.layout_name, self.large, self.whole = layout, large, whole
        stays = stays and self._is_wide == was_wide
        self.window().setUpdatesEnabled(False)  # no intermediate state may be visible
        try:
            if moved:
                self._place()
            self._reveal()
            if moved and not (stays and self._resize(*kept)):
                self.share()
        finally:
            self.window().setUpdatesEnabled(True)
        self.rearranged.emit()

    def take(self, shown: Shown, changed: Changed) -> None:
        """Bring the pane that another scene is about into the large slot."""
        if shown.scene.leading != self.leading:
            self.leading = name = shown.scene.leading
            if self.whole or "view" not in changed:  # otherwise `Arrangement` does it
                self.arrange(self.layout_name, name, name if self.whole else "")

    def _resize(self, across: list[int], small: list[int]) -> bool:
        """Restore sizes that the user had chosen; False if there are other slots now."""
        if len(across) != self.count():
            return False
        self.setSizes(across)
        self._small.setSizes(small)
        return True

    def go_back(self) -> None:
        """Dock and show every pane, the one that the scene is about in the large slot."""
        for name in self.floating:
            self.toggle_float(name)
        self.arrange(self.layout_name, self.leading)
        self.share()

    def toggle_float(self, name: str) -> None:
        """Give a pane its own window, for a second screen, or dock it again."""
        pane, plays = self._panes[name], self._strip.playing
        if pane.isWindow():
            pane.move_to(None, self._place)
        else:
            size = pane.size()
            pane.setWindowTitle(f"{pane.name} – Frustum Lab")
            pane.move_to(self.window(), lambda: pane.resize(size))
            if name == self.whole:
                self.whole = ""
            self._place()
        self._reveal()
        self.share()
        if plays:  # the strip was hidden on the way, which stops it
            self._strip.play()
        self.rearranged.emit()

    def reset_views(self) -> None:
        """Reset every pane's own camera; the model does not change."""
        for pane in self._panes.values():
            pane.reset_view()

    def _place(self) -> None:
        """Put each docked pane into its slot."""
        docked = [name for name in self._panes if name not in self.floating]
        if self.layout_name == "columns":
            large, small = docked, []
        else:
            order = [name for name in (self.large, *SMALL[self.large]) if name in docked]
            large, small = order[:1], order[1:]
        for splitter, names in ((self, large), (self._small, small)):
            for place, name in enumerate(names):
                if splitter.indexOf(self._panes[name]) != place:
                    splitter.insertWidget(place, self._panes[name])
        if self.indexOf(self._small) != self.count() - 1:
            self.insertWidget(self.count() - 1, self._small)

    def _reveal(self) -> None:
        """Show or hide the docked panes."""
        docked = [name for name in self._panes if name not in self.floating]
        for name in docked:
            self._panes[name].setVisible(self.whole in ("", name))
        beside = [name for name in docked if self._small.indexOf(self._panes[name]) >= 0]
        self._small.setVisible(any(self.whole in ("", name) for name in beside))

    def set_presenting(self, on: bool) -> None:
        """Use the sizes for a class, or the previous ones."""
        if on and self._is_by_hand and not self.whole:
            self._by_hand = self.sizes(), self._small.sizes()
        self._is_for_class = on
        self.share()
        if not on and self._by_hand is not None:
            by_hand, self._by_hand = self._by_hand, None
            self._is_by_hand = not self.whole and self._resize(*by_hand)

    def set_low(self, on: bool) -> None:
        """Store whether a panel is open below, which leaves the slots little height."""
        was_wide = self._is_wide
        self._is_low = on
        if self._is_wide != was_wide:
            self.share()

    def share(self) -> None:
        """Give the slots their default sizes."""
        self._is_by_hand = False
        across, down = Qt.Orientation.Horizontal, Qt.Orientation.Vertical
        self.setOrientation(down if self._is_wide else across)
        self._small.setOrientation(across if self._is_wide else down)
        if self.layout_name == "columns":
            sizes = [*COLUMN_WIDTHS, 0]
        elif self._is_wide:
            sizes = TOP_AND_BOTTOM[self.large]
        elif self._is_for_class:
            sizes = CUBE_AND_SMALL if self.large == "ndc" else LOW_AND_SMALL
        else:
            sizes = IMAGE_AND_SMALL if self.large == "image" else LARGE_AND_SMALL
        self.setSizes(sizes)
        self._small.setSizes(SIDE_BY_SIDE if self._is_wide else UPPER_AND_LOWER)

    @property
    def _is_wide(self) -> bool:
        """Whether the small slots stand below the large one."""
        is_high = self._is_for_class and not self._is_low
        return is_high and self.layout_name == "pictures" and self.large != "ndc"

    def _dragged(self) -> None:
        self._is_by_hand = True
