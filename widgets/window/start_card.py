"""The start card: the scenes as pictures, the lessons, recent files, and a two-minute tour."""

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from textwrap import wrap

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QGridLayout, QMenu, QToolButton, QWidget

from app.lessons.lesson import head_of, is_lesson
from app.lessons.player import Progress
from app.model.refusal import Refusal
from app.scenes.scene import BUILT_IN
from widgets.parts.layouts import FREE, in_column, in_row, tool_button
from widgets.parts.messages import file_title
from widgets.parts.plain import PlainLabel
from widgets.parts.wording import Wording
from widgets.window.cover_card import CoverCard
from widgets.window.lesson_card import TOUR
from widgets.window.lesson_menu import fill

WORDS = Wording(__file__)
COLUMNS = 5
THUMBNAIL_PX = (144, 81)
MOST_RECENT = 6
LINE_LETTERS = 27  # in each of the two lines that a recent file's title has
TILES = Path(__file__).parent / "content"
"""The scenes' pictures, of two pixels a side for one; ``python3 -m tests.pictures --tiles``."""


def tile_path(name: str, *, dark: bool) -> Path:
    return TILES / f"{name}{'-dark' if dark else ''}.png"


class StartCard(CoverCard):
    """The scenes, the lessons, the trades of speed and the recent files, over the whole window.

    `titles` are those of the built-in scenes by name, `recent` the paths of files, and `progress`
    belongs to the lessons that were begun. `review` names the exercises that have come back, and
    `next_review` says when others will; they are empty if there are none.
    """

    scene_chosen = Signal(str)
    file_chosen = Signal(str)
    review_wanted = Signal()
    open_wanted = Signal()
    trades_wanted = Signal()
    always_set = Signal(bool)  # whether the card appears at every start

    def __init__(
        self,
        window: QWidget,
        titles: Mapping[str, str],
        recent: Sequence[str],
        progress: Mapping[str, Progress],
        *,
        review: str,
        next_review: str,
        at_every_start: bool,
        dark: bool,
    ) -> None:
        super().__init__(window, WORDS.say("start"))
        self.tiles = {name: self._tile(name, titles[name], dark=dark) for name in BUILT_IN}
        grid = QGridLayout()
        grid.setSpacing(2)
        for place, tile in enumerate(self.tiles.values()):
            row, column = divmod(place, COLUMNS)
            grid.addWidget(tile, row, column, Qt.AlignmentFlag.AlignTop)
        learn, files = (
            PlainLabel(WORDS.say(key), objectName="paneTitle") for key in ("learn", "files")
        )
        review_and_lessons = *self._lessons(progress), *self._review(review, next_review)
        beside = in_column(learn, *review_and_lessons, 12, files, *self._files(recent), FREE, gap=2)
        always = WORDS.check("always", self.always_set)
        always.setChecked(at_every_start)
        title, tip = WORDS["head"]
        head = self._head(title, tip)
        both = in_row(grid, beside, gap=16)
        in_column(head, both, always, on=self.card, margins=(16, 10, 16, 12), gap=6)

    def _tile(self, name: str, title: str, *, dark: bool) -> QToolButton:
        act = partial(self._leave_for, self.scene_chosen, name)
        tile = tool_button(title, title, act, flat=True)
        tile.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        tile.setIconSize(QSize(*THUMBNAIL_PX))
        tile.setIcon(QIcon(str(tile_path(name, dark=dark))))
        if tile.fontMetrics().horizontalAdvance(title) > 1.2 * THUMBNAIL_PX[0]:
            tile.setText(title.replace(" ", "\n", 1))  # its column would be wider than the others
        return tile

    def _lessons(self, progress: Mapping[str, Progress]) -> Iterator[QToolButton]:
        choose = partial(self._leave_for, self.file_chosen)
        yield WORDS.tool("tour", partial(choose, str(TOUR)), icon="play", flat=True)
        for key, are_talks in (("lesson", False), ("present", True)):
            button = WORDS.tool(key, icon=key, flat=True)
            menu = QMenu(button)
            menu.aboutToShow.connect(partial(fill, menu, progress, choose, talks=are_talks))
            button.setMenu(menu)
            button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
            yield button
        act = partial(self._leave_for, self.trades_wanted)
        yield WORDS.tool("speed", act, icon="speed", flat=True)

    def _review(self, text: str, following: str) -> Iterator[QWidget]:
        if text:
            act = partial(self._leave_for, self.review_wanted)
            yield tool_button(text, WORDS.say("review"), act, icon="reset", flat=True)
        if following:
            said = PlainLabel(following, objectName="paneNote")
            said.setIndent(round(1.3 * said.fontMetrics().height()))  # below the text
            yield said

    def _files(self, recent: Sequence[str]) -> Iterator[QToolButton]:
        act = partial(self._leave_for, self.open_wanted)
        yield WORDS.tool("open", act, icon="open", flat=True)
        for path in recent[:MOST_RECENT]:
            act = partial(self._leave_for, self.file_chosen, path)
            title, icon = _head_of(path)
            tip = path if title == file_title(path) else f"{title} – {path}"
            lines = wrap(title, LINE_LETTERS, max_lines=2, placeholder="…")
            text, name = "\n".join(lines).replace("&", "&&"), Path(path).name
            yield tool_button(text, tip, act, icon=icon, name=name, flat=True)


def _head_of(path: str) -> tuple[str, str]:
    """Return the title and the icon of a recent file: a lesson's own, if it can be read."""
    if is_lesson(path):
        try:
            head = head_of(Path(path))
            return head.title, "present" if head.is_talk else "lesson"
        except Refusal:  # opening the file reports the problem
            pass
    return file_title(path), "open"
