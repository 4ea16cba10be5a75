"""The speaker's window: this step's notes, what comes next, and the time."""

import time
from collections import OrderedDict
from collections.abc import Callable
from contextlib import suppress

from PySide6.QtCore import QSize, Qt, QTime, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QFont, QImage, QPixmap
from PySide6.QtWidgets import QGridLayout, QListWidget, QSizePolicy, QWidget

from app.document.document import Document
from app.drawings.figure import Figure
from app.languages import with_comma
from app.lessons.blocks.block import ReadBlock
from app.lessons.course import Course, scene_of
from app.lessons.lesson import Step
from app.lessons.player import Player
from app.lessons.text import in_line
from app.model.refusal import Refusal
from widgets.panes.canvas import release_context
from widgets.parts import palette
from widgets.parts.layouts import TOP, FittedWidget, FocusRing, in_column, in_row, push_button
from widgets.parts.lesson_text import answer_of, set_text
from widgets.parts.plain import PlainLabel, ReadText, set_tip
from widgets.window.pictures import image_of
from widgets.window.settings import LARGEST_NOTES_PX, LEAST_NOTES_PX, Settings
from widgets.window.slots import panes_of_slide

PICTURE_PX = (400, 250)  # size at which the next step's pane is drawn; it is scaled to its room
MOST_PICTURES = 12  # most cached pictures of steps
TEXT_PX = 15
NOTES_STEP_PX = 2  # step by which Ctrl and + or - change the text size of the notes


class TalkClock:
    """The speaking time, from a monotonic clock; it can be paused and reset."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._before = 0.0
        self._since: float | None = None

    @property
    def is_running(self) -> bool:
        return self._since is not None

    @property
    def seconds(self) -> float:
        return self._before + (self._now() - self._since if self._since is not None else 0.0)

    def begin(self) -> None:
        """Start, unless it is already running or was paused."""
        if self._since is None and self._before == 0.0:
            self._since = self._now()

    def toggle(self) -> None:
        if self._since is None:
            self._since = self._now()
        else:
            self._before, self._since = self.seconds, None

    def reset(self) -> None:
        """Reset to 0; a running clock continues."""
        self._before = 0.0
        if self._since is not None:
            self._since = self._now()


class _PictureLabel(FittedWidget, PlainLabel):
    """A picture, as large as there is room for."""

    def __init__(self, name: str) -> None:
        super().__init__(accessibleName=name, alignment=Qt.AlignmentFlag.AlignCenter)
        self._image = QImage()
        self.setMinimumSize(160, 100)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Expanding)

    def show_image(self, image: QImage) -> None:
        """Show an image; an empty one hides it."""
        self._image = image
        self._fit()

    def _fit(self) -> None:
        if self._image.isNull():
            self.setPixmap(QPixmap())
            return
        ratio = self.devicePixelRatioF()
        keep, smooth = Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode
        image = self._image.scaled(self.size() * ratio, keep, smooth.SmoothTransformation)
        image.setDevicePixelRatio(ratio)
        self.setPixmap(QPixmap.fromImage(image))


class SpeakerWindow(QWidget):
    """The window that only the speaker sees; it closes with its parent, the main window."""

    left = Signal()
    jump_wanted = Signal(int)  # the number of a step, from 1

    def __init__(self, settings: Settings, parent: QWidget, clock: TalkClock) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setWindowTitle(self.tr("Speaker's window – Frustum Lab"))
        self.setObjectName("speaker")
        self._settings = settings
        self.clock = clock
        self._player: Player | None = None
        self._left_out = ""
        self._pictures: OrderedDict[tuple[Course, int], QImage] = OrderedDict()
        self._make()
        self._tick = QTimer(self, interval=500)
        self._tick.timeout.connect(self._show_time)
        self._tick.start()

    def _make(self) -> None:
        self._number, self._clock, self._elapsed, self._plan = (PlainLabel() for _ in range(4))
        wrapped = (PlainLabel(wordWrap=True) for _ in range(3))
        self._title, self._next_title, self.message = wrapped
        self.notes = ReadText()
        self.notes.setAccessibleName(self.tr("Notes"))
        FocusRing(self.notes)
        self.now, self.picture = _PictureLabel(self.tr("The slide")), _PictureLabel(self.tr("Next"))
        self.steps = QListWidget()
        self.steps.setAccessibleName(self.tr("Steps"))
        for chosen in (self.steps.itemActivated, self.steps.itemClicked):
            chosen.connect(lambda item: self.jump_wanted.emit(self.steps.row(item) + 1))
        self.pause = push_button("", act=self.clock.toggle)
        self.reset = push_button(self.tr("&Reset"), act=self.clock.reset)
        texts = self.tr("◀ &Back"), self.tr("&Next ▶"), self.tr("B&lank"), self.tr("S&wap screens")
        buttons = [push_button(text) for text in texts]
        self.back, self.next, self.blank, self.swap = buttons
        for button in (self.pause, self.reset, *buttons):
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            button.clicked.connect(self._show_time)
        tip = self.tr("Swap the screens of class and notes (W); the choice is remembered")
        set_tip(self.swap, tip)
        times = (
            PlainLabel(self.tr("Time")), 6, self._clock, 16,
            PlainLabel(self.tr("Elapsed")), 6, self._elapsed, 16,
            self.pause, 8, self.reset, 8, (self._plan, 1),
        )  # fmt: skip
        layout = QGridLayout()
        layout.addLayout(in_row(*times), 0, 0, 1, 2)
        layout.addLayout(in_row((self._title, 1), (self._number, TOP)), 1, 0)
        layout.addWidget(self.now, 2, 0)
        layout.addWidget(self.notes, 3, 0)
        beside = in_column(self._next_title, (self.picture, 3), (self.steps, 2))
        layout.addLayout(beside, 1, 1, 3, 1)
        layout.addLayout(in_row(*buttons, 8, (self.message, 1)), 4, 0, 1, 2)
        layout.setColumnStretch(0, 3)
        layout.setColumnStretch(1, 2)
        layout.setRowStretch(2, 4)
        layout.setRowStretch(3, 5)
        layout.setHorizontalSpacing(TEXT_PX)
        self.setLayout(layout)  # filled: see `layouts.in_row`
        large: dict[QWidget, float] = {self._title: 1.5, self._clock: 1.6, self._elapsed: 1.6}
        for child in self.findChildren(QWidget):  # independent of the class's letters
            font = QFont(self.font())
            font.setPixelSize(round(large.get(child, 1.0) * TEXT_PX))
            font.setBold(child is self._title)
            child.setFont(font)
        self._show_time()

    # -- the step

    def show_step(self, player: Player, left_out: str) -> None:
        """Show a step's notes, what the next key shows, and the title of the next step.

        `draw_next` draws its picture. `left_out` are the words of the step that are too long for
        the class's slide.
        """
        steps, place, left = player.lesson.steps, player.place, player.unrevealed
        if player is not self._player:
            self._pictures.clear()
            self.steps.clear()
            self.steps.addItems(
                [f"{number}  {in_line(step.title)}" for number, step in enumerate(steps, 1)]
            )
        self._player, self._left_out = player, left_out
        step = player.step
        self._title.setText(in_line(step.title))
        self._number.setText(self.tr("step {0} of {1}").format(place + 1, len(steps)))
        self._show_notes(step)
        self.steps.setCurrentRow(place)
        self.steps.scrollToItem(self.steps.item(place), QListWidget.ScrollHint.PositionAtCenter)
        following = None if player.is_last else steps[place + 1]
        if left:
            text = self.tr("Next: the answer") if left % 2 else self.tr("Next: the question")
            if following is not None:
                text = self.tr("{0}; later: {1}").format(text, in_line(following.title))
        elif following is not None:
            text = self.tr("Next: {0}").format(in_line(following.title))
        else:
            text = self.tr("This is the last step.")
        self._next_title.setText(text)
        self._show_picture()
        self._show_time()

    def _show_notes(self, step: Step) -> None:
        font = QFont(self.font())
        font.setPixelSize(self._settings.notes_px)
        document = self.notes.document()
        document.setDefaultFont(font)
        parts = [self._left_out] if self._left_out else []
        parts += [step.note.text] if step.note is not None else []
        parts += [self._with_right_answer(part) for part in step.asked]
        set_text(document, "\n\n".join(parts), palette=self.palette())
        document.setDocumentMargin(8.0)

    def _with_right_answer(self, part: ReadBlock) -> str:
        assert self._player is not None
        answer = ""
        with suppress(Refusal):  # the speaker learns of a mistake when the class would see it
            answer = answer_of(part, self._player.course.at(self._player.place))
        return part.explained(answer)

    def enlarge(self, by_px: int) -> None:
        """Make the letters of the notes larger, or smaller."""
        size = self._settings.notes_px + by_px
        self._settings.notes_px = max(LEAST_NOTES_PX, min(LARGEST_NOTES_PX, size))
        if self._player is not None:
            self._show_notes(self._player.step)

    # -- the next step's picture

    def draw_next(self) -> None:
        """Draw the next step, unless its picture is kept."""
        player = self._player
        if player is None or player.is_last:
            return
        course, place = player.course, player.place + 1
        if (course, place) not in self._pictures:
            try:
                image = _drawn(course.shown(place).document, self._settings.theme)
            except Refusal:  # the speaker learns of a mistake when the step would be shown
                image = QImage()
            self._pictures[course, place] = image
            while len(self._pictures) > MOST_PICTURES:
                self._pictures.popitem(last=False)
        self._show_picture()

    def _show_picture(self) -> None:
        image = QImage()
        if self._player is not None:
            image = self._pictures.get((self._player.course, self._player.place + 1), image)
        self.picture.show_image(image)

    # -- the time

    def _show_time(self) -> None:
        self._clock.setText(QTime.currentTime().toString("HH:mm"))
        seconds = int(self.clock.seconds)
        self._elapsed.setText(f"{seconds // 60}:{seconds % 60:02}")
        self._elapsed.setAccessibleName(self.tr("Elapsed"))
        set_tip(self._elapsed, self.tr("Elapsed"))
        self.pause.setText(self.tr("&Pause") if self.clock.is_running else self.tr("&Start"))
        if self._player is None:
            return
        (before, here), late = self._player.planned, self._player.minutes_late(seconds)
        text = ""
        if before + here > 0.0:
            text = self.tr("planned {0} to {1} min").format(f"{before:g}", f"{before + here:g}")
            if not here:
                text = self.tr("planned {0} min").format(f"{before:g}")
            if late:
                text += "  –  " + self.tr("{0} min late").format(late)
        self._plan.setText(with_comma(text))

    # -- events

    def sizeHint(self) -> QSize:
        return QSize(900, 600)

    def closeEvent(self, event: QCloseEvent) -> None:
        super().closeEvent(event)
        self.left.emit()


def _drawn(document: Document, theme: str) -> QImage:
    release_context()
    scene = scene_of(document)
    panes = panes_of_slide(document.view.slide, document.view.large or scene.leading)
    dark = "dark" if palette.is_dark(theme) else "screen"
    return image_of(Figure(document, scene, panes, PICTURE_PX, palette=dark).pixels())
