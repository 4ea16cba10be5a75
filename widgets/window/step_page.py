"""The page of a lesson's step: its texts, and the views of its questions and tasks."""

from functools import partial
from typing import cast

from PySide6.QtCore import QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QApplication, QFrame, QPushButton, QScrollArea, QWidget

from app.document.document import Document
from app.lessons.player import Player
from widgets.parts.layouts import FREE, in_column, key_of, lay_out
from widgets.parts.lesson_text import LessonText
from widgets.window.hiding import IN_TEST
from widgets.window.lesson_blocks import view_of
from widgets.window.lesson_blocks.view import BlockView

MARGIN_PX = 4  # space that is kept above and below what is scrolled to


class StepPage(QScrollArea):
    """A step as far as it is shown; a response scrolls into view."""

    settled = Signal(object)  # the block with this `BlockView` was answered
    show_wanted = Signal(object)  # the user wants to see this `Document`, which explains an answer
    posed = Signal(object)  # an exercise is asked in this `Document`
    hidden = Signal(object)  # what must not be seen now: it would show the answer of an exercise
    aimed = Signal(object, object)
    """The `BlockView`s whose questions are to be answered in a picture, and the one that has just
    been answered so, or None."""
    room_wanted = Signal(int)
    """How many pixels of height a response lacks; 0 once the step is left, or has new numbers."""
    hinting_changed = Signal(bool)  # emits whether a block can give a hint

    def __init__(self) -> None:
        super().__init__(widgetResizable=True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setAccessibleName(self.tr("Step"))
        self.blocks: list[BlockView] = []
        self._player: Player | None = None
        self._current: BlockView | None = None  # the block that has the cursor, or had it last
        self._hides: frozenset[str] = frozenset()
        self._responding: BlockView | None = None  # the block whose response is not shown yet
        # Not `QTimer.singleShot`, which comes before Qt shows the widgets that are added meanwhile.
        self._response_timer = QTimer(self, singleShot=True, interval=0)
        self._response_timer.timeout.connect(self._reveal)
        cast(QApplication, QApplication.instance()).focusChanged.connect(self._follow)

    def make(self, player: Player) -> None:
        """Make the page: the step's title, then its text and blocks in order."""
        self._empty()
        self._player = player
        player.begin_page()
        page = QWidget()
        self._column = in_column(LessonText(player.step.title, title=True), gap=8)
        in_column(self._column, FREE, on=page, margins=(0, 0, 6, 4))
        self.unfold()
        self.setWidget(page)
        self.verticalScrollBar().setValue(0)

    def clear(self) -> None:
        self._empty()
        self.hide_answers()

    def _empty(self) -> None:
        for view in self.blocks:
            view.played.keep_draft(view.typed)
        self.blocks, self._current = [], None
        self.room_wanted.emit(0)
        page = self.takeWidget()
        if page is not None:
            page.deleteLater()

    def unfold(self) -> None:
        """Show the parts up to an open prediction."""
        assert self._player is not None
        for part, played in self._player.unfold():
            if played is None:
                self._column.addWidget(LessonText(part.text))
                continue
            view = view_of(played, played.block)
            (view.restore if played.answer else view.show_draft)()
            view.settled.connect(partial(self.settled.emit, view))
            view.show_wanted.connect(self._show_aside)
            view.posed.connect(self._pose)
            view.responded.connect(partial(self._await_response, view))
            self.blocks.append(view)
            self._column.addWidget(view)

    def open_up(self) -> None:
        """Begin with the first open block, or show the state of the last one beside its answer."""
        turn = next((view for view in self.blocks if view.played.is_open), None)
        if turn is None and self.blocks:
            turn = self.blocks[-1]
        if turn is not None:
            turn.open_up()
        self.hide_answers()  # once: what the step before has hidden may stay so

    def look(self, now: Document) -> None:
        """Check the tasks in the window's current state."""
        for view in [*self.blocks]:
            view.look(now)

    # -- the focus

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Scroll; at the end of the page the window turns it."""
        bar, keys = self.verticalScrollBar(), Qt.Key
        ends = {keys.Key_PageDown: bar.maximum(), keys.Key_PageUp: bar.minimum()}
        if ends.get(Qt.Key(event.key())) == bar.value():
            event.ignore()
        else:
            super().keyPressEvent(event)

    def go_to_prediction(self) -> None:
        """Give the focus to the prediction that must be made before the step continues."""
        held = next((view for view in self.blocks if view.played.holds), None)
        if held is not None and held.first is not None:
            held.first.setFocus(Qt.FocusReason.OtherFocusReason)
            self.ensureWidgetVisible(held)

    @property
    def first(self) -> QWidget | None:
        """The first widget of the first open block."""
        widgets = (view.first for view in self.blocks if view.played.is_open)
        return next((widget for widget in widgets if widget is not None), None)

    @property
    def hinting(self) -> BlockView | None:
        """The block that gives the next hint."""
        if self._player is None or not self.blocks:
            return None
        current = self._current.played if self._current is not None else None
        hinting = self._player.hinting(current)
        return next((view for view in self.blocks if view.played is hinting), None)

    def _follow(self, _left: QWidget | None, focus: QWidget | None) -> None:
        """Remember in which block the cursor is, or was last."""
        for view in self.blocks:
            if focus is not None and view.isAncestorOf(focus):
                self._current = view
                self.share_keys()

    def share_keys(self) -> None:
        """Give a key of several blocks to the one with the cursor, or to the first."""
        taken = set[QKeySequence]()
        for view in sorted(self.blocks, key=lambda view: view is not self._current):
            for button in view.findChildren(QPushButton):
                key = key_of(button.text())
                button.setShortcut(QKeySequence() if key in taken else key)
                if button.isVisibleTo(self):
                    taken.add(key)
        self.hinting_changed.emit(self.hinting is not None)

    # -- answers

    def _show_aside(self, document: Document) -> None:
        self.hide_answers()  # before it is seen
        self.show_wanted.emit(document)

    def _pose(self, document: Document) -> None:
        self.hide_answers()  # before it is seen
        self.room_wanted.emit(0)
        self.posed.emit(document)

    def hide_answers(self) -> None:
        """Hide what would show the answer of an open exercise; take clicks for a question."""
        aims = [aimed for aimed in (view.aims for view in self.blocks) if aimed is not None]
        asked, answered = ([v for v in aims if v.played.is_open == on] for on in (True, False))
        self.aimed.emit(asked, answered[-1] if answered else None)
        hides = frozenset[str]().union(*(view.played.hides for view in self.blocks))
        if any(view.played.is_test for view in self.blocks):
            hides |= {IN_TEST}
        if hides != self._hides:
            self._hides = hides
            self.hidden.emit(hides)

    # -- responses

    def _await_response(self, view: BlockView) -> None:
        """Remember which block responds; the rest of its response may follow."""
        self._responding = view
        self._response_timer.start()

    def _reveal(self) -> None:
        """Show a response: with its question if there is room, else all of it, or its beginning."""
        self.share_keys()
        view, self._responding = self._responding, None
        if view is None or view not in self.blocks or not view.response:
            return
        _settle_layout()
        missing = view.height() + 2 * MARGIN_PX - self.viewport().height()
        if missing > 0:
            self.room_wanted.emit(missing)
            _settle_layout()
        self._scroll_to(view)
        self._scroll_to(*view.response)

    def _scroll_to(self, *widgets: QWidget) -> None:
        """Scroll until widgets from the top one to the bottom one are seen, or as much as fits."""
        bar, port = self.verticalScrollBar(), self.viewport()
        begin, end = widgets[0].mapTo(port, QPoint()), widgets[-1].mapTo(port, QPoint())
        top, bottom = begin.y() - MARGIN_PX, end.y() + widgets[-1].height() + MARGIN_PX
        bar.setValue(bar.value() + min(max(0, bottom - port.height()), top))


def _settle_layout() -> None:
    lay_out()
    lay_out()  # again, because a scroll bar that appears makes the text narrower
