"""Presenting: the panes fill the screen, in letters for the back row, and leave no trace."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRect, QSize, Qt
from PySide6.QtGui import (
    QCursor,
    QEnterEvent,
    QFocusEvent,
    QFont,
    QFontInfo,
    QHelpEvent,
    QIcon,
    QImage,
    QPixmap,
)
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QToolButton,
    QToolTip,
    QWidget,
)

from app.document.settings import set_values
from app.drawings.style import LIGHT
from app.drawings.world import WorldDrawing
from app.lecture.highlight import NOTHING
from app.lessons.text import html_of
from tests.support.drawings import labels_of, lit_at
from tests.support.layout import cut
from tests.support.window import (
    LEFT,
    MakeWindow,
    activate,
    counted_repaints,
    drag,
    give_room,
    move_mouse,
    pixels,
    rgb_of,
    settle,
)
from tests.support.window import enter as enter_text
from widgets.parts import lesson_text
from widgets.window.main_window import MainWindow
from widgets.window.settings import Settings

ORDINARY = 20, 30, 1300, 750
"""Left, top, width and height of the window before and after."""
NO_BUTTON = Qt.MouseButton.NoButton


@pytest.fixture
def window(window: MainWindow) -> MainWindow:
    """With the keyboard, and in the size it opens in."""
    activate(window)
    settle()
    return window


def press(window: MainWindow, key: Qt.Key) -> None:
    QTest.keyClick(QApplication.focusWidget() or window, key)
    settle()


def begin(window: MainWindow) -> None:
    """Present, by F5."""
    press(window, Qt.Key.Key_F5)
    assert window.isFullScreen()
    give_room(window, window.screen().geometry())


def trace(window: MainWindow) -> list[Any]:
    """All that presenting might leave changed."""
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    return [
        window.geometry().getRect(),
        window.windowState(),
        application.font().toString(),
        application.styleSheet(),
        window.menus.pointer.isEnabled(),
        window.menus.blank.isEnabled(),
        window.menus.pointer.isChecked(),
        *(
            (widget.isVisible() and widget.geometry().getRect(), widget.font().toString())
            for widget in (
                window.menuBar(),
                window.menus.tools,
                window.controls,
                window.bottom,
                window.status,
                window.panels,
                *window.panes.values(),
                *(pane.title for pane in window.panes.values()),
            )
        ),
    ]


def is_presenting(window: MainWindow) -> bool:
    """Whether it does, in every respect."""
    found = {
        window.isFullScreen(),
        not window.menuBar().isVisible(),
        not window.bottom.isVisible(),
        window.menus.blank.isEnabled(),
        window.menus.pointer.isEnabled(),
        QFontInfo(window.slide.font()).pixelSize() > 20,
    }
    assert len(found) == 1
    return found.pop()


# -- what a class sees


@pytest.mark.undrawn
def test_one_picture_is_the_slide(window: MainWindow) -> None:
    for scene, leading in (("letter-f", "world"), ("clipping", "ndc"), ("depth-buffer", "image")):
        window.guide.choose(scene)
        begin(window)
        assert is_presenting(window) and not window.menus.tools.isVisible()
        screen = window.screen().size()
        assert [name for name, pane in window.panes.items() if pane.isVisible()] == [leading]
        assert window.panes[leading].canvas.size() == screen, scene
        assert not window.controls.isVisible() and not window.strip.isVisible()
        assert not window.panes[leading].header.isVisible()
        assert window.control_strip.isHidden()
        window.present.end()
        give_room(window, QRect(*ORDINARY))
        assert all(pane.isVisible() for pane in window.panes.values())
        assert window.panes[leading].header.isVisible() and window.strip.isVisible()


@pytest.mark.undrawn
def test_a_slide_of_two_pictures_has_them_side_by_side(window: MainWindow) -> None:
    window.store.set_view(slide=("image", "world"))
    begin(window)
    left, right = (window.panes[name].geometry() for name in ("image", "world"))
    assert not window.panes["ndc"].isVisible() and left.height() == right.height()
    assert abs(left.width() - right.width()) <= 2 and left.right() < right.left()
    assert all(window.panes[name].title.isVisible() for name in ("image", "world"))
    assert not window.panes["world"].header.findChild(QWidget, "fixedViews").isVisible()
    press(window, Qt.Key.Key_Escape)
    assert all(pane.isVisible() for pane in window.panes.values())


@pytest.mark.undrawn
def test_the_keys_of_the_panes_choose_another_slide(window: MainWindow) -> None:
    def seen() -> list[str]:
        return [name for name, pane in window.panes.items() if pane.isVisible()]

    begin(window)
    window.slots.make_large("image")
    assert seen() == ["image"]
    window.slots.make_large("image")
    assert seen() == ["world", "ndc", "image"]
    window.slots.make_large("ndc")
    assert seen() == ["ndc"]
    window.slots.go_back()
    assert seen() == ["world"]


@pytest.mark.undrawn
@pytest.mark.parametrize("slide", [("kinds",), ("equation", "image")], ids=lambda slide: slide[0])
def test_the_key_of_a_pane_leaves_a_slide_that_is_more_than_the_pane(
    window: MainWindow, slide: tuple[str, ...]
) -> None:
    window.store.set_view(slide=slide, large="image", equation="frustum")
    begin(window)
    other = window.kinds_panel if slide == ("kinds",) else window.slide.equation
    assert other.isVisible()
    for asked, seen in (("image", 1), ("image", 3), ("world", 1)):
        window.slots.make_large(asked)
        settle()
        assert sum(pane.isVisible() for pane in window.panes.values()) == seen
        assert not other.isVisible()
    window.slots.go_back()
    settle()
    assert other.isVisible()


@pytest.mark.undrawn
def test_no_key_opens_the_search_that_a_class_does_not_see(window: MainWindow) -> None:
    begin(window)
    press(window, Qt.Key.Key_Slash)
    assert not window.controls.isVisible()
    press(window, Qt.Key.Key_F5)
    assert QApplication.focusWidget() is not window.controls.search
    press(window, Qt.Key.Key_Slash)
    assert QApplication.focusWidget() is window.controls.search


@pytest.mark.undrawn
def test_a_panel_takes_nothing_from_the_slide(window: MainWindow) -> None:
    begin(window)
    before = window.panes["world"].geometry()
    window.panels.open(window.frame_panel)  # its step is drawn in the world
    settle()
    assert window.panes["world"].geometry() == before and window.panels.height() == 0
    window.panels.open(None)
    window.store.set_view(slide=("kinds",))
    settle()
    assert window.kinds_panel.isVisible() and not window.panes["world"].isVisible()
    assert window.panels.height() == window.height()
    window.store.set_view(slide=(), panel="")
    settle()
    assert window.panes["world"].geometry() == before


@pytest.mark.undrawn
def test_the_strip_has_the_controls_that_a_step_names(window: MainWindow) -> None:
    window.guide.choose("similar-triangles")
    begin(window)
    whole = window.panes["world"].height()
    window.store.set_view(controls=("lens.far",))
    settle()
    window.store.set_view(controls=("lens.near", "settings.distance"))
    strip, rows = window.control_strip, window.control_strip.rows
    assert all(row.isVisible() for row in rows), "the first picture leaves them room"
    settle()
    assert [row.name for row in rows] == ["Near", "Plane distance d"]
    assert strip.isVisible() and all(row.isVisible() for row in rows)
    assert window.panes["world"].height() >= 0.9 * whole
    enter_text(rows[0].field, "3")
    assert window.store.document.projection.lens.near == 3.0
    enter_text(rows[1].field, "5")
    assert window.store.document.settings["distance"] == 5.0
    window.store.undo()
    settle()
    assert rows[1].field.text() == "4"
    window.setFocus()
    press(window, Qt.Key.Key_C)
    assert strip.isHidden() and window.panes["world"].height() == whole
    window.store.set_view(controls=())
    press(window, Qt.Key.Key_C)  # those of the scene
    assert [row.name for row in strip.rows] == ["Plane distance d", "Point P"]
    window.present.end()
    settle()
    assert strip.isHidden() and strip.rows == []
    card = window.controls.card
    assert all(row.isVisible() for row in card.rows.values())
    assert window.controls.rows["near"].isVisible()
    order = [card.layout().indexOf(row) for row in card.rows.values()]
    assert order == sorted(order)


@pytest.mark.undrawn
def test_a_row_that_comes_into_the_strip_has_the_value_of_the_document(window: MainWindow) -> None:
    """The card of the scene is hidden then, and shows its values only while they can be seen."""
    begin(window)
    document = set_values(
        window.store.document,
        ["scene=view-volumes", "settings.volume=box", "view.controls=settings.volume"],
    )
    assert window.store.open(document, is_work=False)
    settle()
    (row,) = window.control_strip.rows
    assert row.isVisible() and row.value() == "box"


@pytest.mark.undrawn
def test_the_strip_of_stages_is_shown_to_a_class_only_if_it_is_asked_for(
    window: MainWindow,
) -> None:
    window.store.set_view(slide=("ndc",))
    begin(window)
    assert window.panes["ndc"].isVisible() and not window.strip.isVisible()
    window.store.set_view(controls=("stage",))
    settle()
    assert window.strip.isVisible() and window.control_strip.isHidden()


@pytest.mark.undrawn
def test_no_markdown_is_read_without_a_talk(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    read = list[str]()
    monkeypatch.setattr(lesson_text, "html_of", lambda text: read.append(text) or html_of(text))
    begin(window)
    press(window, Qt.Key.Key_Escape)
    assert not window.isFullScreen() and not read


def test_a_class_sees_no_tooltips(window: MainWindow) -> None:
    canvas = window.panes["world"].canvas

    def is_told() -> bool:
        place = canvas.rect().center()
        QApplication.sendEvent(
            canvas, QHelpEvent(QEvent.Type.ToolTip, place, canvas.mapToGlobal(place))
        )
        told = QToolTip.isVisible()
        QToolTip.hideText()
        settle()
        return told

    assert is_told()
    begin(window)
    assert not is_told()


def test_text_is_a_share_of_the_screens_height(window: MainWindow) -> None:
    before = LIGHT.font_size
    begin(window)
    least = 0.022 * window.screen().size().height()
    press(window, Qt.Key.Key_F4)
    for name in window.panes:
        window.slots.make_large(name)
        settle()
        assert cut(window) == []
        for widget in window.findChildren(QWidget):
            is_text = isinstance(widget, QLabel | QToolButton) and widget.text()
            if is_text and widget.isVisible():
                assert QFontInfo(widget.font()).pixelSize() >= least, widget.text()
        assert QFontInfo(window.controls.rows["near"].field.font()).pixelSize() >= least
        drawn = [label.em for label in labels_of(window.panes["world"].canvas.renderer).values()]
        assert drawn and min(drawn) >= least > before


@pytest.mark.undrawn
def test_what_a_class_does_not_see_is_styled_only_when_it_is_shown(
    window: MainWindow,
) -> None:
    """To style a hidden widget takes as long as to style a visible one."""

    class Counts(QObject):
        styled = 0

        def eventFilter(self, watched: QObject, event: QEvent) -> bool:
            self.styled += event.type() == QEvent.Type.StyleChange
            return False

    def sizes() -> list[tuple[str, QSize]]:
        return [(part.font().toString(), part.sizeHint()) for part in parts]

    counts = Counts()
    row, other = window.controls.rows["near"], window.controls.rows["fov_y_deg"]
    window.panels.open(window.matrices)
    settle()
    window.panels.open(None)
    parts = [row, *row.findChildren(QWidget), *window.matrices.findChildren(QComboBox)]
    before = sizes()
    for part in (*parts, *window.panes["image"].findChildren(QWidget)):
        part.installEventFilter(counts)
    for _ in range(2):
        begin(window)
        window.present.end()
        settle()
    assert not counts.styled and sizes() == before
    begin(window)
    window.control_strip.toggle()  # the strip borrows the row, and gives it back
    settle()
    lent = QFontInfo(other.font()).pixelSize()
    window.control_strip.toggle()
    press(window, Qt.Key.Key_F4)
    window.panels.open(window.matrices)
    settle()
    least = 0.022 * window.screen().size().height()
    ordinary = QFontInfo(window.status.font()).pixelSize()
    assert min(QFontInfo(part.font()).pixelSize() for part in parts) >= least > ordinary
    assert lent > ordinary
    window.panels.open(None)
    window.present.end()
    window.panels.open(window.matrices)
    settle()
    assert sizes() == before


@pytest.mark.undrawn
def test_a_class_sees_the_controls_that_matter_and_nothing_else(window: MainWindow) -> None:
    window.guide.choose("depth-buffer")
    window.panels.open(window.matrices)
    settle()
    card = window.controls.card
    beside = [card.use_mesh, card.explanation, window.controls.search, window.panels]
    beside += [section.heading for section in window.controls.sections.values()]
    beside += [window.controls.rows["fov_y_deg"], window.controls.rows["azimuth_deg"]]
    assert all(widget.isVisible() for widget in beside)
    begin(window)
    assert not window.controls.isVisible()
    press(window, Qt.Key.Key_F4)
    assert not any(widget.isVisible() for widget in beside)
    assert all(row.isVisible() for row in card.rows.values())
    assert window.controls.rows["near"].isVisible() and card.tries.isVisible()
    bar = window.controls.verticalScrollBar()
    assert bar.maximum() == bar.minimum()
    window.guide.choose("letter-f")  # which has no controls of its own
    settle()
    assert window.controls.rows["fov_y_deg"].isVisible()
    window.guide.choose("depth-buffer")
    window.present.end()
    settle()
    assert all(widget.isVisible() for widget in beside)


@pytest.mark.undrawn
def test_an_offer_waits_until_presenting_ends(window: MainWindow) -> None:
    taken: list[int] = []
    bar = window.messages
    bar.show_message("Work of yesterday was not saved.", ("Recover it", lambda: taken.append(1)))
    begin(window)
    assert not bar.isVisible()
    bar.show_message("near must be less than far.")  # what the speaker has just done
    assert bar.isVisible()
    bar.done()
    assert not bar.isVisible()
    window.present.end()
    settle()
    assert bar.isVisible() and bar.text == "Work of yesterday was not saved."
    [button] = bar.choices
    button.click()
    assert taken == [1] and not bar.isVisible()
    begin(window)
    bar.show_message("Begun again.", ("Undo", lambda: None))  # asked for by what was done now
    assert bar.isVisible()


@pytest.mark.undrawn
def test_no_last_word_stands_alone(window: MainWindow) -> None:
    """Of each thing to try, the last line is at least half as long as the longest."""
    window.guide.choose("off-axis-window")
    begin(window)
    press(window, Qt.Key.Key_F4)
    tries = window.controls.card.tries
    for text in tries.text().split("\n"):
        tries.setText(text)
        settle()
        image = rgb_of(tries.grab().toImage()).astype(int)
        inked = np.abs(image - image[0, -1]).max(axis=2) > 60
        line = tries.fontMetrics().height()
        ends = [
            int(np.nonzero(inked[top : top + line].any(axis=0))[0].max())
            for top in range(0, inked.shape[0] - line // 2, line)
            if inked[top : top + line].any()
        ]
        assert len(ends) > 1 and min(ends) > 0.5 * max(ends), (text, ends)


@pytest.mark.undrawn
@pytest.mark.parametrize(("theme", "lightness"), [("light", (0, 110)), ("dark", (140, 255))])
def test_icons_have_the_size_and_the_colour_of_their_text(
    window: MainWindow, theme: str, lightness: tuple[int, int]
) -> None:
    """So does a copy to which Qt has added a picture."""
    window.look.set_theme(theme)
    icons = [QIcon(a.icon()) for a in window.menus.tools.actions() if not a.icon().isNull()]
    assert len(icons) > 5
    for icon in icons:
        icon.addPixmap(QPixmap(1, 1))
        picture = icon.pixmap(QSize(20, 20), 2.0).toImage()
        inked = [
            colour.lightness()
            for x in range(picture.width())
            for y in range(picture.height())
            if (colour := picture.pixelColor(x, y)).alpha() == 255
        ]
        assert picture.width() == 40 and len(inked) > 20
        assert lightness[0] <= min(inked) and max(inked) <= lightness[1]
    window.store.set_view(slide=("ndc",), controls=("stage",))
    begin(window)
    window.present.show_tools(True)
    settle()
    for button in window.menus.tools.findChildren(QToolButton):
        if button.isVisible() and not button.icon().isNull():
            assert button.iconSize().height() >= 0.022 * window.height(), button.text()
    play = window.strip.button
    assert play.isVisible() and play.iconSize().height() == play.fontMetrics().height()
    window.look.set_theme("light")


@pytest.mark.undrawn
def test_the_tool_bar_comes_when_the_mouse_is_at_the_top_and_goes_with_it(
    window: MainWindow,
) -> None:
    begin(window)
    tools = window.menus.tools
    heights = {name: pane.height() for name, pane in window.panes.items()}
    middle = window.width() // 2
    enter(window, QPoint(middle, 100))
    assert not tools.isVisible()
    for _ in range(2):
        enter(window, QPoint(middle, 0))
        assert tools.isVisible() and not window.menuBar().isVisible()
        assert window.body.geometry() == window.rect() and tools.width() == window.width()
        leave(tools)
        assert not tools.isVisible()
        assert {name: pane.height() for name, pane in window.panes.items()} == heights
    enter(window, QPoint(middle, 0))
    (button,) = (b for b in tools.findChildren(QToolButton) if b.text() == "Present")
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    settle()
    assert not is_presenting(window) and tools.isVisible()
    leave(tools)
    assert tools.isVisible(), "on demand only while presenting"


def enter(window: MainWindow, place: QPoint) -> None:
    """Let the mouse come to a place of the window."""
    widget = window.childAt(place)
    at = QPointF(widget.mapFrom(window, place))
    everywhere = QPointF(widget.mapToGlobal(at))
    QApplication.sendEvent(widget, QEnterEvent(at, QPointF(place), everywhere))
    settle()


def leave(widget: QWidget) -> None:
    QApplication.sendEvent(widget, QEvent(QEvent.Type.Leave))
    settle()


def is_black(window: MainWindow) -> bool:
    return not rgb_of(window.grab().toImage()).any()


@pytest.mark.undrawn
@pytest.mark.undrawn
def test_icons_of_the_tool_bar_fit_a_large_font_of_the_system(
    make_window: MakeWindow, qapp: QApplication
) -> None:
    own = qapp.font()
    large = QFont(own)
    large.setPointSizeF(2.5 * own.pointSizeF())
    qapp.setFont(large)
    try:
        tools = make_window().menus.tools
        assert tools.iconSize().height() > QFontInfo(tools.font()).pixelSize()
    finally:
        qapp.setFont(own)


def test_b_blanks_the_screen_and_every_exit_restores_it(window: MainWindow) -> None:
    press(window, Qt.Key.Key_B)
    assert not is_black(window), "only while presenting"
    begin(window)
    ways: tuple[Callable[[], None], ...] = (
        lambda: press(window, Qt.Key.Key_B),
        lambda: press(window, Qt.Key.Key_Escape),
        lambda: QTest.mouseClick(window.childAt(300, 300), Qt.MouseButton.LeftButton),
    )
    for way in ways:
        press(window, Qt.Key.Key_B)
        assert is_black(window)
        way()
        settle()
        assert not is_black(window) and is_presenting(window)
    assert window.probe_panel.probes == (), "the click was for the screen"
    press(window, Qt.Key.Key_B)
    press(window, Qt.Key.Key_F5)
    assert not is_black(window) and not is_presenting(window)


def test_the_pointer_marks_in_all_panes_what_the_mouse_is_over(window: MainWindow) -> None:
    begin(window)
    window.slots.make_large("world")  # all panes
    settle()
    canvas = window.panes["image"].canvas
    ((x, y),) = window.panes["image"].drawing.sight.seen([[0.5, 4.5, 1.0]]).tolist()
    at = QPointF(x, y) / canvas.pixel_ratio
    move_mouse(canvas, at, NO_BUTTON)
    settle()
    before = {name: pixels(window, name) for name in window.panes}
    press(window, Qt.Key.Key_P)
    with counted_repaints(window) as counts:
        move_mouse(canvas, at + QPointF(1.0, 0.0), NO_BUTTON)
        settle()
    assert counts == dict.fromkeys(window.panes, 1)
    for name, pane in window.panes.items():
        assert (pixels(window, name) != before[name]).any(), name
        ((x, y),) = pane.drawing.sight.seen([[0.5, 4.5, 1.0]]).tolist()
        rows, columns = np.nonzero((pixels(window, name) != before[name]).any(axis=2))
        away = np.hypot(columns - x, rows - y)
        assert away.min() < 20.0, name
        least = 0.025 * window.screen().size().height()
        near = away < 2.0 * least  # beside its ray
        assert np.ptp(columns[near]) >= least and np.ptp(rows[near]) >= least, name
        assert pane.cursor().pixmap().height() >= least
    assert window.probe_panel.probes == () and not window.store.can_undo
    leave(canvas)
    assert all((pixels(window, name) == before[name]).all() for name in before)
    move_mouse(canvas, at, NO_BUTTON)
    settle()
    press(window, Qt.Key.Key_P)
    assert all((pixels(window, name) == before[name]).all() for name in before)


# -- leaving


def test_it_leaves_no_trace(window: MainWindow) -> None:
    window.setGeometry(*ORDINARY)
    window.panels.open(window.matrices)
    settle()
    before, pictures = trace(window), {name: pixels(window, name) for name in window.panes}
    for way in ("F5", "Escape", "system"):
        begin(window)
        assert is_presenting(window) and trace(window) != before
        window.present.show_tools(True)
        if way == "system":
            window.setWindowState(Qt.WindowState.WindowNoState)
        else:
            press(window, getattr(Qt.Key, f"Key_{way}"))
        assert not window.isFullScreen()
        give_room(window, QRect(*ORDINARY))
        assert not is_presenting(window)
        assert trace(window) == before, way
        assert all((pixels(window, name) == pictures[name]).all() for name in pictures), way
    assert not window.isWindowModified() and not window.store.can_undo


@pytest.mark.undrawn
def test_dragged_sizes_of_the_slots_come_back(window: MainWindow) -> None:
    window.setGeometry(*ORDINARY)
    settle()
    for splitter, by in ((window.slots, QPoint(90, 0)), (window.slots.widget(1), QPoint(0, 70))):
        drag(splitter, 1, by)
    before = trace(window)
    for _ in range(2):
        begin(window)
        window.slots.show_slide(("world", "image"))
        window.slots.show_slide(())
        press(window, Qt.Key.Key_F5)
        give_room(window, QRect(*ORDINARY))
        assert trace(window) == before
    across, small = window.slots.sizes(), window.slots.widget(1).sizes()
    window.slots.make_large("ndc")
    assert (window.slots.sizes(), window.slots.widget(1).sizes()) == (across, small)


@pytest.mark.undrawn
@pytest.mark.parametrize(
    "what",
    [
        "a comparison",
        "a message",
        "a whole pane",
        "a pane made whole",
        "a dock without its place",
        "a dock of another width",
    ],
)
def test_esc_leaves_presenting_at_once_and_all_stays(window: MainWindow, what: str) -> None:
    window.setGeometry(*ORDINARY)
    settle()
    if what == "a comparison":
        window.comparing.button.click()
    elif what == "a message":
        window.messages.show_message("Something to be read.")
    elif what == "a whole pane":
        window.slots.make_large("world")
        window.slots.make_large("world")
    elif what == "a dock without its place":
        window.menus.controls.trigger()
    elif what == "a dock of another width":
        window.split.setSizes([800, 500])
    settle()
    before, held = trace(window), window.comparing.pictures.pictures
    for key in (Qt.Key.Key_Escape, Qt.Key.Key_F5):
        begin(window)
        if what == "a pane made whole":
            window.slots.make_large(window.slots.large)
        elif what == "a dock without its place":
            window.menus.controls.trigger()
        settle()
        press(window, key)
        give_room(window, QRect(*ORDINARY))
        assert not is_presenting(window)
        assert trace(window) == before
        assert window.comparing.pictures.pictures == held
        assert (what == "a message") == bool(window.messages.text)


@pytest.mark.undrawn
def test_a_window_that_was_maximised_is_so_again(window: MainWindow) -> None:
    window.setWindowState(Qt.WindowState.WindowMaximized)
    settle()
    begin(window)
    press(window, Qt.Key.Key_F5)
    assert window.isMaximized() and not window.isFullScreen()


@pytest.mark.undrawn
def test_closed_while_presenting_it_opens_as_an_ordinary_window(
    make_window: MakeWindow, tmp_path: Path
) -> None:
    settings = Settings(tmp_path / "settings.ini")
    window = make_window(settings=settings)
    window.resize(1300, 750)
    activate(window)
    settle()
    font = QApplication.font().toString()
    begin(window)
    window.store.mark_saved()
    assert window.close()
    assert QApplication.font().toString() == font
    other = make_window(settings=settings)
    settle()
    assert other.size().toTuple() == (1300, 750) and not other.isFullScreen()
    assert other.menuBar().isVisible() and other.menus.tools.isVisible()


def test_a_flat_view_stays_flat_and_its_planes_can_be_dragged_anywhere(window: MainWindow) -> None:
    begin(window)
    pane = window.panes["world"]
    window.store.set_view(fixed="side", names=("eye", "near", "far"))
    settle()
    drawing = pane.drawing
    assert isinstance(drawing, WorldDrawing)
    corners = drawing.sight.seen(drawing.state.volume.corners + drawing.state.origin)
    upper, lower = sorted((corners[4:].min(axis=0), corners[4:].max(axis=0)), key=lambda at: at[1])
    on_far = QPoint(*(upper + 0.37 * (lower - upper)).astype(int).tolist())
    middle = QPoint(*corners.mean(axis=0).astype(int).tolist()) + QPoint(0, 35)
    move_mouse(pane.canvas, middle, NO_BUTTON)
    assert lit_at(drawing, middle.x(), middle.y()) == NOTHING, "it would be all of the slide"
    for start, moves in ((on_far, True), (middle, False)):
        before = window.store.document.projection.lens
        QTest.mousePress(pane.canvas, LEFT, pos=start)
        for step in (20, 40, 60):
            QTest.mouseMove(pane.canvas, start + QPoint(step, 5))
        QTest.mouseRelease(pane.canvas, LEFT, pos=start + QPoint(60, 5))
        settle()
        assert drawing.fixed == "side"
        assert (window.store.document.projection.lens.far != before.far) == moves


def is_red(image: QImage, place: QPoint) -> bool:
    """Whether the laser's dot is there."""
    seen = image.pixelColor(place)
    return seen.red() > 200 and seen.green() < 60


def test_the_laser_lies_over_everything_and_repaints_no_picture(window: MainWindow) -> None:
    begin(window)
    handle = window.windowHandle()
    pane = window.panes["world"].canvas
    middle = pane.mapTo(window, pane.rect().center())
    QCursor.setPos(window.mapToGlobal(middle))  # where other tests have left it, Qt sees no move
    QTest.mouseMove(handle, middle)
    settle()
    spots = dict(window.panes["world"].drawing.handles.shown)
    near = next(spot for mark, spot in spots.items() if mark.name == "near")
    window.panes["world"].hand.hovered.emit(QPointF(*near))
    assert window.panes["world"].drawing.handles.held is not None
    QTest.keyPress(handle, Qt.Key.Key_L)
    settle()
    assert window.panes["world"].drawing.handles.held is None, "the dot will go elsewhere"
    with counted_repaints(window) as counts:
        for place in (middle, middle + QPoint(150, 60), QPoint(400, 15), QPoint(300, 700)):
            if place != middle:  # there it appears without a move
                QTest.mouseMove(handle, place)
            settle()
            seen = window.grab().toImage()
            assert is_red(seen, place)
            assert not is_red(seen, place + QPoint(0, 30)), "it is small"
        assert QApplication.overrideCursor().shape() == Qt.CursorShape.BlankCursor
        QTest.keyRelease(handle, Qt.Key.Key_L)
        settle()
        assert not is_red(window.grab().toImage(), QPoint(300, 700))
        assert QApplication.overrideCursor() is None
    assert sum(counts.values()) == 0
    QTest.keyPress(handle, Qt.Key.Key_L)
    press(window, Qt.Key.Key_Escape)
    assert not window.present.is_on and window.laser.isHidden()
    QTest.keyRelease(handle, Qt.Key.Key_L)
    QTest.keyPress(handle, Qt.Key.Key_L)
    assert window.laser.isHidden(), "only a class needs it"
    QTest.keyRelease(handle, Qt.Key.Key_L)


@pytest.mark.undrawn
def test_the_laser_leaves_typed_letters_and_drags_alone(window: MainWindow) -> None:
    begin(window)
    press(window, Qt.Key.Key_F4)
    field = window.controls.findChildren(QLineEdit)[0]
    field.setFocus()
    handle = window.windowHandle()
    QTest.keyClick(handle, Qt.Key.Key_L)
    assert window.laser.isHidden() and field.text().startswith("l")
    field.undo()
    window.setFocus()
    window.slide.pen.switch(True)
    QTest.keyPress(handle, Qt.Key.Key_L)
    place = QPoint(300, 400)
    QTest.mousePress(handle, LEFT, pos=place)
    QTest.mouseMove(handle, place + QPoint(80, 20))
    QTest.mouseRelease(handle, LEFT, pos=place + QPoint(80, 20))
    assert len(window.slide.pen.here) == 1 and len(window.slide.pen.here[0].points) > 1
    assert window.laser.geometry().contains(place + QPoint(80, 20))
    QApplication.sendEvent(handle, QFocusEvent(QEvent.Type.FocusOut))
    assert window.laser.isHidden(), "the key may be released in another window"
    QTest.keyRelease(handle, Qt.Key.Key_L)
