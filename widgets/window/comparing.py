"""Start and end comparisons of pictures: from the image pane, the menu, F6 or a scene's card.

::

    button, F6 ---> hold ----.
    the scene's card --------+--> Compare (in the image pane), the pane into the large slot
    Arrangement (the view) --'
"""

from collections.abc import Mapping

from PySide6.QtCore import QObject

from app.document.compare import ComparedPicture
from app.document.document import Document
from app.document.settings import compared
from app.document.store import Store
from app.model.refusal import Refusal
from widgets.controls.scene_card import SceneCard
from widgets.panes.compare import Compare
from widgets.panes.pane import Pane
from widgets.parts.layouts import tool_button
from widgets.parts.messages import MessageBar, sentence
from widgets.parts.panel import EVERYTHING, Changed, ShownData
from widgets.window.actions import Actions
from widgets.window.look import Look
from widgets.window.slots import Slots


class Comparing(QObject):
    """Starts and ends comparisons; `button` is in the title row of the image pane."""

    concerns: Changed = frozenset()  # empty while nothing is compared

    def __init__(
        self,
        panes: Mapping[str, Pane],
        look: Look,
        store: Store,
        slots: Slots,
        card: SceneCard,
        menus: Actions,
        messages: MessageBar,
    ) -> None:
        image = panes["image"]
        super().__init__(image)
        self._panes = panes
        self._store, self._slots, self._menus, self._messages = store, slots, menus, messages
        self._was_large: str | None = None  # the pane that had the large slot before the comparison
        self._before: tuple[Document, Document] | None = None
        """The document before one of the scene's own comparisons, and with it."""
        self.pictures = Compare(image, lambda: look.adaptive.smoothing(True))
        self.button = tool_button(
            self.tr("Compare"), menus.compare.toolTip(), self.toggle,
            icon="compare", name=menus.compare.text().replace("&", ""), flat=True, checkable=True,
        )  # fmt: skip
        image.header.add_tool(self.button)
        menus.compare.triggered.connect(self.toggle)
        menus.compare_way.triggered.connect(self.pictures.toggle_way)
        card.comparison_wanted.connect(self.begin)
        look.built.connect(self.pictures.refresh)
        self.pictures.end_wanted.connect(self.end)
        self.pictures.changed.connect(self._mark)
        slots.rearranged.connect(self._choose_pane)

    def _choose_pane(self) -> None:
        """Compare in the world if that is the slide of a class, else in the image."""
        slide = self._slots.slide
        name = "world" if "world" in slide and "image" not in slide else "image"
        self.pictures.move_to(self._panes[name])

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Redraw the other pictures; the image pane must have been notified first."""
        self.pictures.refresh()

    def toggle(self) -> None:
        """Hold the current picture for comparison, or end the comparison."""
        if self.pictures.is_on:
            self.end()
        else:
            held = ComparedPicture(held=self._store.document.state)
            self._show((held, ComparedPicture(live=True)), (0.5,))
        self._mark()

    def begin(self, name: str) -> None:
        """Show one of the scene's own comparisons, with the document as one of its pictures."""
        try:
            document = compared(self._store.seen, name)
        except Refusal as error:
            self._messages.show_message(sentence(error))
            return
        self._before = self._store.document, document
        self._store.set_document(document)  # an undo step, if it differs
        self._show(document.view.compare, document.view.dividers)

    def end(self) -> None:
        """Show the document's own picture alone, as it was unless it was edited, in its slot."""
        self.pictures.show((), ())
        if self._before is not None and self._before[1] == self._store.document:
            self._store.set_document(self._before[0])
        self._before = None
        if self._was_large is not None and self._slots.large == "image" and not self._slots.whole:
            self._slots.arrange(self._slots.layout_name, self._was_large)
        self._was_large = None

    def _show(self, pictures: tuple[ComparedPicture, ...], dividers: tuple[float, ...]) -> None:
        """Compare pictures, in the large slot."""
        slots = self._slots
        if slots.layout_name == "pictures" and slots.large != "image" and not slots.whole:
            self._was_large = "" if slots.large == slots.leading else slots.large
            slots.arrange(slots.layout_name, "image")
        self.pictures.show(pictures, dividers)
        self.pictures.refresh()

    def _mark(self) -> None:
        is_on = self.pictures.is_on
        self.concerns = EVERYTHING if is_on else frozenset()
        self.button.setChecked(is_on)
        self._menus.compare.setChecked(is_on)
        self._menus.compare_way.setEnabled(is_on)
