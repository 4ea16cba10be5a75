"""A chain of tiles that a student arranges in the lesson's card."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPushButton

from tests.support.window import activate, settle
from widgets.parts.lesson_text import LessonText
from widgets.parts.movable import MoveButton
from widgets.window.lesson_blocks.order import OrderView
from widgets.window.main_window import MainWindow

LESSON = """---
title: Orders
letters: 001
---
# Tiles
```state
scene=letter-f
object.chain=translate 3,0,0; rotate z 90
```

```answer tiles
Which product?
order object: translate 3,0,0; rotate z 90
tiles: rotate z 30; translate 3,0,0; mirror x
why: The move acts last.
```

---
# Matrices
```answer lens
Which product?
order: divide; M_z; M_pp; M_persp; view
```
"""


@pytest.fixture
def window(window: MainWindow, tmp_path: Path) -> MainWindow:
    path = tmp_path / "orders.md"
    path.write_text(LESSON, encoding="utf-8")
    assert window.lessons.open(path)
    settle()
    return window


def view_of(window: MainWindow) -> OrderView:
    views = window.lesson_card.page.findChildren(OrderView)
    return next(view for view in views if view.isVisible())


def arrange(view: OrderView, *heads: str) -> None:
    """Move the rows by the arrow keys until they begin like this, from the top."""
    for place, head in enumerate(heads):
        at = next(n for n, row in enumerate(view.rows) if row.text.startswith(head))
        for _ in range(at - place):
            QTest.keyClick(view.rows[at].findChild(MoveButton), Qt.Key.Key_Up)
            at -= 1
    assert all(row.text.startswith(head) for row, head in zip(view.rows, heads, strict=False))


def said(view: OrderView) -> str:
    return " ".join(each.toPlainText() for each in view.findChildren(LessonText))


@pytest.mark.undrawn
def test_tiles_are_arranged_switched_off_and_typed_into(window: MainWindow) -> None:
    view = view_of(window)
    arrange(view, "rotate", "translate", "mirror")
    view.rows[2].switch.click()
    view.rows[0].field.setText("90")
    assert [row.text for row in view.rows] == ["rotate z 90", "translate 3,0,0", "off mirror x"]
    QTest.keyClick(view.rows[0].field, Qt.Key.Key_Return)
    settle()
    assert "First the move, then the turn" in said(view) and "4.243" in said(view)
    names = {each.text().replace("&", "") for each in view.findChildren(QPushButton)}
    assert {"Show it", "Your idea beside the model", "Show the answer"} <= names
    view.rows[0].field.setText("nine")
    view.check()
    assert "numbers after rotate z, 1 in all" in said(view)
    view.rows[0].field.setText("90")
    arrange(view, "translate", "rotate")
    view.check()
    settle()
    assert "The move acts last." in said(view) and not view.rows[0].isEnabled()
    window.lessons.go(1)
    settle()
    window.lessons.go(0)
    settle()
    again = [row.text for row in view_of(window).rows]
    assert again == ["translate 3,0,0", "rotate z 90", "off mirror x"], "it is kept"


@pytest.mark.undrawn
@pytest.mark.parametrize("part", ["grip", "switch", "field"])
def test_enter_checks_anywhere_in_a_tile_and_the_focus_goes_on(
    window: MainWindow, part: str
) -> None:
    activate(window)
    view = view_of(window)
    arrange(view, "translate", "rotate", "mirror")
    row = view.rows[1]
    row.field.setText("90")
    focus = {"grip": row.findChild(MoveButton), "switch": row.switch, "field": row.field}[part]
    focus.setFocus()
    QTest.keyClick(focus, Qt.Key.Key_Return)
    settle()
    assert view.response, "it is checked, and wrong"
    view.rows[2].switch.setChecked(False)
    QTest.keyClick(focus, Qt.Key.Key_Return)
    settle()
    assert "The move acts last." in said(view)
    assert QApplication.focusWidget() is window.lesson_card.next


@pytest.mark.undrawn
def test_the_focus_goes_on_where_the_answer_is_shown(window: MainWindow) -> None:
    activate(window)
    view = view_of(window)
    view.rows[0].field.setFocus()
    view.reveal_answer()
    settle()
    assert QApplication.focusWidget() is window.lesson_card.next


@pytest.mark.undrawn
def test_factors_of_the_pipeline_have_names_and_no_numbers(window: MainWindow) -> None:
    window.lessons.go(1)
    settle()
    view = view_of(window)
    assert not any(row.field.isVisible() for row in view.rows)
    names = {row.switch.accessibleName() for row in view.rows}
    assert {"division by w", "view ← world"} <= names and len(names) == 5
    arrange(view, "divide", "M_z", "M_pp", "M_persp", "view")
    view.check()
    settle()
    assert "Right." in said(view)
