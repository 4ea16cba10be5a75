"""A lesson's text: formulas stand on the line of the words, and nothing in it leads anywhere."""

import re
from typing import Any

import numpy as np
import pytest
import shiboken6
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import (
    QColor,
    QDrag,
    QFont,
    QImage,
    QPainter,
    QPalette,
    QPyTextObject,
    QRegion,
    QTextDocument,
)
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

from app import languages
from app.lecture.typesetting import outline
from app.lessons.text import DISPLAYED, FORMULA, escaped, html_of, in_line, plain_of, readable
from tests.support.window import LEFT, NO_KEY, rgb_of
from widgets.parts import lesson_text
from widgets.parts.lesson_text import MAY_BREAK, NO_BREAK, SPACIOUS, LessonText, set_text


def drawn(text: str, width: int = 900, *, is_spacious: bool = False) -> np.ndarray:
    """Where there is ink of a text in letters of 60 pixels, (height, width) of bool."""
    document = QTextDocument()
    document.setProperty(SPACIOUS, is_spacious)
    font = QFont("DejaVu Sans")
    font.setPixelSize(60)
    document.setDefaultFont(font)
    set_text(document, text)
    document.setTextWidth(width)
    image = QImage(width, 400, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    document.drawContents(painter)
    painter.end()
    return rgb_of(image).mean(axis=2) < 128


def pieces(ink: np.ndarray) -> list[tuple[int, int]]:
    """Top and bottom of what stands apart from what is beside it, from the left."""
    columns = np.flatnonzero(ink.any(axis=0))
    parts = np.split(columns, np.flatnonzero(np.diff(columns) > 2) + 1)
    rows = [np.flatnonzero(ink[:, part].any(axis=1)) for part in parts]
    return [(int(found[0]), int(found[-1])) for found in rows]


@pytest.mark.parametrize("text", ["H $H$ H", r"H $H\,\frac{a}{b}$ H", "H $H$, H"])
def test_a_formula_stands_on_the_line_of_the_words(qapp: Any, text: str) -> None:
    found = pieces(drawn(text))
    word, letter, last = found[0], found[1], found[-1]
    assert abs(letter[1] - word[1]) <= 1 and last[1] == word[1]
    assert 0.85 < (letter[1] - letter[0]) / (word[1] - word[0]) < 1.15, "letters of one size"


def test_lines_make_room_for_fractions(qapp: Any) -> None:
    """Nothing of a high formula reaches into the lines above and below it."""
    ink = drawn("HHH\\\nHHH $\\dfrac{M}{M}$\\\nHHH")
    words = np.flatnonzero(ink[:, :135].any(axis=1))
    above, beside, below = np.split(words, np.flatnonzero(np.diff(words) > 2) + 1)
    formula = np.flatnonzero(ink[:, 150:].any(axis=1))
    assert above[-1] + 2 < formula[0] < beside[0] < beside[-1] < formula[-1] < below[0] - 2


def test_fractions_are_readable_and_displayed_formulas_are_large(qapp: Any) -> None:
    """As in the card: a letter of a fraction has at least 80 % of the height of the text's."""

    def height(text: str) -> int:
        """Height of the first letter from the left."""
        top, bottom = pieces(drawn(text, is_spacious=True))[0]
        return bottom - top + 1

    def in_fraction(text: str) -> int:
        """Height of what is above the line of a fraction."""
        rows = np.flatnonzero(drawn(text, is_spacious=True).any(axis=1))
        return len(np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1)[0])

    letter = height("x")
    assert in_fraction(r"$\frac{x}{x}$") >= 0.8 * letter
    assert height("$$x$$") >= 1.2 * height("$x$")
    assert in_fraction(r"$$\frac{x}{x}$$") >= 1.2 * in_fraction(r"$\frac{x}{x}$")
    assert readable(r"\frac{\frac{a}{b}}{c} e^{\frac{1}{2}} x_{\frac{1}{2}}") == (
        r"\dfrac{\dfrac{a}{b}}{c} e^{\frac{1}{2}} x_{\frac{1}{2}}"
    )


@pytest.mark.parametrize("before", ["", "- ", "- A\n  - "])
def test_no_formula_reaches_beyond_a_document_with_margins(qapp: Any, before: str) -> None:
    document = QTextDocument()
    set_text(document, f"{before}$a + b + c + d + e + f + g + h + i + j + k + l$")
    document.setDocumentMargin(8.0)  # as the speaker's notes have
    document.setTextWidth(150.0)
    assert document.size().width() <= 150.0


def test_a_formula_of_a_title_is_as_large_as_its_words(qapp: Any) -> None:
    widths = []
    for title in (True, False):
        document = QTextDocument()
        set_text(document, "$-A - B/z$", title=title)
        widths.append(document.idealWidth())
    assert widths[0] == pytest.approx(1.2 * widths[1], rel=0.05)


def test_a_displayed_formula_stands_on_a_line_of_its_own() -> None:
    html, found = html_of("Then $a$ and $$b = 2$$, so *c*:\n$$d$$\nend.\n\n- $$e$$")
    assert found == ("a", "b = 2", "d", "e")
    lines = re.findall(r"<p[^>]*>(.*?)</p>", html, re.DOTALL)
    assert lines == [
        f"Then {FORMULA} and", f"{DISPLAYED},", "so <em>c</em>:", DISPLAYED, "end."
    ]  # fmt: skip
    assert html.count('<p align="center">') == 2


def test_a_hyphen_before_a_number_is_a_minus() -> None:
    html, _ = html_of("[-1, 1], 15-20, x-1 & `-3`: **-0.5**")
    assert html == "<p>[−1, 1], 15-20, x-1 &amp; <code>-3</code>: <strong>−0.5</strong></p>"


def test_formulas_outlive_every_other_text_and_are_said_again(qapp: Any) -> None:
    """Whatever draws them is no document's own: PySide crashed now and then when one went."""
    document = QTextDocument()
    before = drawn("H $x$")
    for _ in range(3):
        set_text(document, "H $x$")
        assert not document.findChildren(QPyTextObject)
        shiboken6.delete(document)
        assert (drawn("H $x$") == before).all()
        document = QTextDocument()


def test_formulas_have_the_colour_of_the_text(qtbot: Any) -> None:
    text = LessonText("$xMx$")
    qtbot.addWidget(text)
    for colour in ("#ff0000", "#00ff00"):
        palette = QPalette(text.palette())
        palette.setColor(QPalette.ColorRole.Text, QColor(colour))
        palette.setColor(QPalette.ColorRole.Base, QColor("black"))
        text.setPalette(palette)
        text.resize(200, 40)
        image = QImage(200, 40, QImage.Format.Format_RGB32)
        image.fill(Qt.GlobalColor.black)
        text.viewport().render(
            image,
            QPoint(),
            QRegion(),
            QWidget.RenderFlag.DrawChildren,  # without what is behind
        )
        brightest = rgb_of(image).reshape(-1, 3).max(axis=0)
        wanted = QColor(colour)
        found = (wanted.red() > 0, wanted.green() > 0, False)
        assert tuple(brightest > 150) == found, colour


def test_nothing_in_it_leads_anywhere(qtbot: Any) -> None:
    source = (
        "<script>alert(1)</script> <img src=x> [a](http://x.y) ![b](file:///etc/passwd)"
        " <http://z.w> \ue000 & <b>c</b>"
    )
    text = LessonText(source)
    qtbot.addWidget(text)
    said = text.toPlainText()
    for part in ("<script>alert(1)</script>", "<img src=x>", "[a](http://x.y)", "<b>c</b>"):
        assert part in said
    formats = text.document().allFormats()
    assert not any(form.isImageFormat() for form in formats)
    assert not any(f.isCharFormat() and f.toCharFormat().isAnchor() for f in formats)
    for source in (r"as $\nosuch{x}$ and $\frac{1}$ typed", f"too deep: ${'{' * 60}x{'}' * 60}$"):
        broken = LessonText(source)
        qtbot.addWidget(broken)
        assert broken.toPlainText() == source
    signs = r"a\b `c` *d* _e_ {f} [g](h) <i> # $j$ | k"
    again = LessonText(escaped(signs))
    qtbot.addWidget(again)
    assert again.toPlainText() == signs


def test_it_is_as_high_as_what_it_holds(qtbot: Any) -> None:
    wide = r"$$x_{ndc} = 2\,\frac{x_p - l}{r - l} - 1 = \frac{2n\,x}{r-l} + \frac{r+l}{r-l}\,z$$"
    text = LessonText(f"Some words that are wrapped in a column that is narrow. {wide}")
    qtbot.addWidget(text)
    assert text.heightForWidth(160) > text.heightForWidth(600) > 0
    text.resize(160, text.heightForWidth(160))
    text.show()
    QApplication.processEvents()
    document = text.document()
    assert document.size().height() <= text.height() and document.idealWidth() <= 160
    low = text.heightForWidth(160)
    text.show_text("Short.")
    assert text.heightForWidth(160) < low


def test_no_line_begins_with_the_punctuation_behind_a_formula(qapp: Any) -> None:
    document = QTextDocument()
    set_text(document, "Seen ($x_p = 1.5$), from $y_p$: the $n$-axis, and $z$/$w$'s sum $s$.")
    begins = set()
    for wide in range(60, 300, 3):
        document.setTextWidth(wide)
        layout = document.begin().layout()
        lines = [layout.lineAt(at) for at in range(layout.lineCount())]
        text = document.begin().text()
        begins |= {text[line.textStart() :].lstrip(f"{MAY_BREAK}{NO_BREAK}")[0] for line in lines}
    assert begins >= {"S", "f", "t"} and not begins & set("),:-'./")


def test_formulas_are_copied_as_tex_and_read_out_in_words(qtbot: Any) -> None:
    text = LessonText(r"See $x_p$ $y$, *and* $\frac{1}{2}$.")
    qtbot.addWidget(text)
    text.selectAll()
    assert text.createMimeDataFromSelection().text() == r"See $x_p$ $y$, and $\frac{1}{2}$."
    assert text.accessibleName() == "See x p y, and 1 over 2."
    text.show_text("| $a$ | $b$, |\n|---|---|\n| $c$ | 2 |")
    text.selectAll()
    assert text.createMimeDataFromSelection().text().split() == ["$a$", "$b$,", "$c$", "2"]
    assert plain_of("- a\n- b\n\n| c | d |\n|---|---|\n| e | $f$ |") == "a b c d e f"


def test_selected_text_is_selected_anew_and_not_dragged_away(qtbot: Any) -> None:
    text, begun = LessonText("Some words of a lesson, all of which are selected."), list[int]()
    qtbot.addWidget(text)
    with qtbot.waitExposed(text):
        text.show()

    def end() -> None:
        begun.append(len(text.findChildren(QDrag)))
        QDrag.cancel()

    ends = QTimer(interval=0)  # Qt deletes the text even while it waits in a drag, and crashes
    ends.timeout.connect(end)
    ends.start()
    text.selectAll()
    line, handle = text.cursorRect(text.textCursor()).center().y(), text.windowHandle()
    QTest.mousePress(handle, LEFT, NO_KEY, QPoint(20, line))
    for x in (60, 100, 140):
        QTest.mouseMove(handle, QPoint(x, line))
    QTest.mouseRelease(handle, LEFT, NO_KEY, QPoint(140, line))
    assert not any(begun)
    assert 0 < len(text.textCursor().selectedText()) < len("Some words of a lesson")


@pytest.mark.parametrize(
    ("tex", "names"),
    [
        (r"y_p = \frac{d}{w}\,y", "y_p d w y"),
        (r"\frac{z_f + z_{min}}{2n} P' n^2", "z_f z_min n P' n"),
        (r"-\vec n \cdot T_0 + \vec{u}", "n\u20d7 T_0 u\u20d7"),
        (r"\vec{up} \times \vec v", "u p v\u20d7"),
        (r"\tan(\theta_h/2) \mathrm{near}", "\u03b8_h"),
    ],
)
def test_the_letters_of_a_formula_are_known(tex: str, names: str) -> None:
    found = outline(tex)
    assert [name for name, _, _ in found.letters] == names.split()
    for _, begin, end in found.letters:  # whole outlines
        assert found.codes[begin] == 1 and (end == len(found.codes) or found.codes[end] == 1)


def test_formulas_break_at_wide_spaces_and_tables_may_lack_headings() -> None:
    html, found = html_of(r"$$a = \frac{1}{2}, \qquad \text{so \quad b} = {c \quad d}$$")
    assert found == (r"a = \dfrac{1}{2},", r"\text{so \quad b} = {c \quad d}")
    assert html.count(DISPLAYED) == 2 and "center" in html
    rows = "|{}|{}|\n|-|-|\n| 1 | $x$ |\n"
    html, found = html_of(rows.format(" ", ""))
    assert "<th" not in html and html.count("<tr>") == 1 and found == ("x",)
    html, _ = html_of(rows.format("a", ""))
    assert html.count("<th") >= 2 and html.count("<tr>") == 2


def test_a_function_stands_clear_of_the_letter_before_it() -> None:
    def width(tex: str) -> float:
        return outline(tex).width

    for before in ("f", r"\alpha", "(x)", r"\frac{1}{2}"):
        assert width(rf"{before} \tan x") > width(before) + width(r"\tan x") + 0.1
    assert width(r"-\tan x") == pytest.approx(width("-") + width(r"\tan x"), abs=0.05)
    assert width(r"a \cdot \tan x") == pytest.approx(width(r"a \cdot{\tan x}"), abs=0.05)


def test_a_minus_after_a_comma_is_a_sign() -> None:
    minus = outline("(-2)").width - outline("(2)").width
    for comma in (", ", r",\ "):
        width = outline(f"(1{comma}-2)").width
        assert width == pytest.approx(outline(f"(1{comma}2)").width + minus, abs=0.01)


def test_a_button_has_signs_for_the_letters_of_formulas() -> None:
    assert in_line(r"Where $\beta = 40°$ is $y_p \cdot 2$") == "Where β = 40° is yₚ · 2"
    languages.choose("hr")
    try:
        assert in_line(r"0.5 i $(-6,\ 3.5)$, $z = -1.5$") == "0,5 i (−6; 3,5), z = −1,5"
    finally:
        languages.choose(languages.ENGLISH)


def test_what_follows_a_formula_is_no_larger_on_paper(qapp: object) -> None:
    """A printer has many dots per inch, and its painter is scaled."""
    inks = []
    for dots in (96, 1200):
        image = QImage(200, 60, QImage.Format.Format_RGB32)
        image.setDotsPerMeterX(round(dots / 0.0254))
        image.setDotsPerMeterY(round(dots / 0.0254))
        image.fill(Qt.GlobalColor.white)
        document = QTextDocument()
        document.setDefaultFont(QFont("DejaVu Sans", 20))
        set_text(document, "Is $x$?")
        painter = QPainter(image)
        document.drawContents(painter)
        painter.end()
        inks.append(rgb_of(image).mean(axis=2) < 128)
    assert inks[0].any() and np.array_equal(*inks)


def test_a_text_is_laid_out_once_for_all_its_formulas(
    qapp: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = list[str]()
    monkeypatch.setattr(lesson_text, "outline", lambda tex: asked.append(tex) or outline(tex))
    text = LessonText(" and ".join(f"$a_{number}$" for number in range(8)))
    assert len(asked) == 2 * 8, "whether it can be set, and its size; not again for each of them"
    assert text.heightForWidth(300) and len(asked) == 4 * 8, "for this width, and back"
