"""The layout of the panes: one large and two small, side by side, or one alone.

::

    "pictures"                     "columns"
    +---------------+---------+    +------+------+------+
    |               | small   |    |      |      |      |
    |  large        +---------+    |      |      |      |
    |               | small   |    |      |      |      |
    +---------------+---------+    +------+------+------+

A class sees a slide: one pane alone, or two side by side.
"""

from collections.abc import Mapping
from functools import partial

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QApplication, QSplitter

from app.document.view import LAYOUTS, PANES
from widgets.panes.pane import Pane
from widgets.panes.stage_strip import StageStrip
from widgets.parts.panel import Changed, ShownData

COLUMN_WIDTHS = [400, 305, 330]
LARGE_AND_SMALL = [584, 486]
IMAGE_AND_SMALL = [640, 430]
UPPER_AND_LOWER = [318, 378]  # in pixels of a window of 1366x768; the splitters keep the proportion
LEAST_PANE_PX = (190, 150)
SMALL = {"world": ("image", "ndc"), "image": ("world", "ndc"), "ndc": ("world", "image")}
"""The small panes for each large one, from top to bottom."""


def panes_of_slide(asked: tuple[str, ...], large: str) -> tuple[str, ...]:
    """Return the panes of a slide; by default the large one, or the world beside an equation."""
    panes = tuple(name for name in asked if name in PANES)
    return panes or (("world",) if "equation" in asked else (large,))


class Slots(QSplitter):
    """The panes, docked or floating, in the order of their columns and of their keys.

    `large` is the pane in the large slot, `leading` the pane that the scene is about, and `whole`
    the pane that fills the window, or "". A class sees the slide instead, by default that of
    `given`, the `app.document.view.SLIDES` that a document asks for.
    """

    concerns = frozenset({"scene"})
    rearranged = Signal()  # a pane has moved to another place

    def __init__(self, panes: Mapping[str, Pane], strip: StageStrip) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._panes, self._strip = panes, strip
        self.layout_name, self.large, self.whole = LAYOUTS[0], next(iter(panes)), ""
        self.leading = self.large
        self.is_for_class = self._is_by_hand = False
        self.given: tuple[str, ...] = ()
        self._chosen: tuple[str, ...] | None = None
        """The slide that the speaker has chosen instead; empty for all panes."""
        self._by_hand: tuple[list[int], list[int]] | None = None
        """The sizes that the user had chosen before presenting."""
        self._small = QSplitter(Qt.Orientation.Vertical)
        for splitter in (self, self._small):
            splitter.setChildrenCollapsible(False)
            splitter.splitterMoved.connect(self._dragged)
        for name, pane in panes.items():
            pane.setMinimumSize(*LEAST_PANE_PX)
            pane.enlarge_requested.connect(partial(self.make_large, name))
            pane.float_requested.connect(partial(self.toggle_float, name))

    def fill(self) -> None:
        """Take the panes, once the slots are in their window: Qt styles what moves with them."""
        for name in (self.large, *SMALL[self.large]):
            (self if name == self.large else self._small).addWidget(self._panes[name])
        self.addWidget(self._small)
        self.share()

    @property
    def floating(self) -> tuple[str, ...]:
        """The panes that have their own windows."""
        return tuple(name for name, pane in self._panes.items() if pane.isWindow())

    @property
    def slide(self) -> tuple[str, ...]:
        """The panes that a class sees alone; empty if it sees all of them."""
        if not self.is_for_class:
            return ()
        asked = panes_of_slide(self.given, self.large)
        wanted = asked if self._chosen is None else self._chosen
        return tuple(name for name in wanted if name not in self.floating)

    def shows(self, what: str) -> bool:
        """Whether a class sees the equation, alone or beside a pane, or the kinds."""
        return self.is_for_class and self._chosen is None and what in self.given

    def show_slide(self, asked: tuple[str, ...]) -> None:
        """Make these of `app.document.view.SLIDES` the slide; empty for the large pane."""
        if (asked, None) != (self.given, self._chosen):
            self.given, self._chosen = asked, None
            self._show_other_slide()

    def _show_other_slide(self) -> None:
        if self.is_for_class:
            self._put()
            self.share()
            self.rearranged.emit()

    def make_large(self, name: str) -> None:
        """Bring a docked pane into the large slot; the second time, into the whole window.

        A class sees the pane as the slide, the second time all panes.
        """
        if name in self.floating:
            return
        if self.is_for_class:
            is_slide = self.slide == (name,) and not (self.shows("equation") or self.shows("kinds"))
            self._chosen = () if is_slide else (name,)
            self._show_other_slide()
            return
        if self.whole:
            fills = name != self.whole
        else:
            fills = name == self.large or self.layout_name == "columns"
        self.arrange(self.layout_name, name, name if fills else "")

    def arrange(self, layout: str, large: str, whole: str = "") -> None:
        """Give every docked pane its place in a layout; `whole` fills the window, "" for none.

        `large` is the pane for the large slot; "" for the one that the scene is about.
        """
        large = large or self.leading
        if (layout, large, whole) == (self.layout_name, self.large, self.whole):
            return
        moved = (layout, large) != (self.layout_name, self.large)
        kept = self.sizes(), self._small.sizes()
        stays = self._is_by_hand and layout == self.layout_name and not self.whole and not whole
        self.layout_name, self.large, self.whole = layout, large, whole
        self.window().setUpdatesEnabled(False)  # no intermediate state may be visible
        try:
            self._put(moved)
            if moved and not (stays and self._resize(*kept)):
                self.share()
        finally:
            self.window().setUpdatesEnabled(True)
        self.rearranged.emit()

    def take(self, shown: ShownData, changed: Changed) -> None:
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
        """Dock and show every pane, the one that the scene is about in the large slot.

        A class sees the slide again.
        """
        for name in self.floating:
            self.toggle_float(name)
        if self.is_for_class:
            self._chosen = None
            self._show_other_slide()
            return
        self.arrange(self.layout_name, self.leading)
        self.share()

    def toggle_float(self, name: str) -> None:
        """Give a pane its own window, for a second screen, or dock it again."""
        pane, plays = self._panes[name], self._strip.playing
        if pane.isWindow():
            pane.move_to(None, self._place)
        else:
            size = pane.size()
            pane.setWindowTitle(f"{pane.accessibleName()} – Frustum Lab")
            pane.move_to(self.window(), lambda: pane.resize(size))
            if name == self.whole:
                self.whole = ""
        self._put()
        self.share()
        if plays:  # the strip was hidden on the way, which stops it
            self._strip.play()
        self.rearranged.emit()

    def reset_views(self) -> None:
        """Reset every pane's own camera; the model does not change."""
        for pane in self._panes.values():
            pane.reset_view()

    def _put(self, moved: bool = True) -> None:
        """Give the panes their places; the focus stays in its pane, or goes to one that is seen."""
        held = QApplication.focusWidget()
        if moved:
            self._place()
        self._reveal()
        if held and any(pane.isAncestorOf(held) for pane in self._panes.values()):
            alone = None if self.is_for_class else self._panes.get(self.whole)
            (held if held.isVisible() else alone.canvas if alone else self.window()).setFocus()

    def _place(self) -> None:
        """Put each docked pane into its slot."""
        docked = [name for name in self._panes if name not in self.floating]
        small: list[str] = []
        if self.slide:  # a hidden pane stays where it is: Qt styles what moves
            homeless = (n for n in docked if self._panes[n].parent() not in (self, self._small))
            large = list(dict.fromkeys((*self.slide, *homeless)))
        elif self.layout_name == "columns":
            large = docked
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
        docked = [name for name in self._panes if name not in self.floating]
        seen = self.slide or ((self.whole,) if self.whole else docked)
        for name in docked:
            self._panes[name].setVisible(name in seen)
        self._small.setVisible(any(self._small.indexOf(self._panes[name]) >= 0 for name in seen))

    def set_presenting(self, on: bool) -> None:
        """Show a class the slide, or all panes again with the previous sizes."""
        if on and self._is_by_hand and not self.whole:
            self._by_hand = self.sizes(), self._small.sizes()
        self.is_for_class = on
        self._chosen = (self.whole,) if on and self.whole else None
        self._put()
        self.share()
        if not on and self._by_hand is not None:
            by_hand, self._by_hand = self._by_hand, None
            self._is_by_hand = not self.whole and self._resize(*by_hand)
        self.rearranged.emit()

    def share(self) -> None:
        """Give the slots their default sizes."""
        self._is_by_hand = False
        if self.slide:
            sizes = [1000] * len(self.slide) + [0] * (self.count() - len(self.slide))
        elif self.layout_name == "columns":
            sizes = [*COLUMN_WIDTHS, 0]
        else:
            sizes = IMAGE_AND_SMALL if self.large == "image" else LARGE_AND_SMALL
        self.setSizes(sizes)
        self._small.setSizes(UPPER_AND_LOWER)

    def _dragged(self) -> None:
        self._is_by_hand = True
