"""The file of a lesson: what is read, and what is refused, with its line."""

import re
from pathlib import Path
from typing import Any

import pytest

from app import languages
from app.bootstrap import ROOT
from app.lessons.checking import CheckReport
from app.lessons.lesson import MOST_STEPS, Lesson, head_of, is_lesson, parse_lesson, read
from app.lessons.text import formulas_in, markdown, spoken_tex, spoken_text
from app.model.refusal import Refusal

TOP = "---\ntitle: T\n---\n"
STEP = TOP + "# One {#one}\n"


def parsed(text: str) -> Lesson:
    return parse_lesson(text, Path("lesson.md"))


def asked(*blocks: str) -> Any:
    """What a step with these blocks asks: of the only block, or of all."""
    found = parsed(STEP + "".join(map(block, blocks))).steps[0].asked
    return found[0] if len(found) == 1 else found


def block(lines: str) -> str:
    return f"```{lines}\n```\n"


def refused(text: str) -> str:
    with pytest.raises(Refusal) as caught:
        parsed(text)
    return str(caught.value)


def page_lesson() -> str:
    """The complete small lesson that `docs/lessons.md` shows a teacher."""
    page = (ROOT / "docs" / "lessons.md").read_text(encoding="utf-8")
    return page.partition("````markdown\n")[2].partition("````")[0]


def test_the_lesson_on_the_teachers_page_is_complete_and_right(tmp_path: Path) -> None:
    path = tmp_path / "small.md"
    path.write_text(page_lesson(), encoding="utf-8")
    report = CheckReport()
    report.take(read(path))
    assert (str(report), report.wrong) == ("1 lesson, 0 talks, 6 checks, 0 wrong", [])


def test_a_step_with_a_prediction_and_an_answer_takes_at_most_15_lines() -> None:
    step = """---
# How wide? {#wide}
```state
lens.fov_y_deg=60
```
```predict
60° high, 16:9: how wide?
- [x] 91.5° := fov_x
- [ ] 106.7° := aspect*fov {angle-linear}
```
```answer
And 90° high?
value: 2*atan(aspect*tan(45))
```
"""
    assert len(step.splitlines()) <= 15
    report = CheckReport()
    report.take(parsed(STEP + "Hello.\n\n" + step))
    assert (report.checks, report.wrong) == (2, [])


def test_what_is_read_is_what_was_written() -> None:
    lesson = parsed(page_lesson())
    assert (lesson.title, lesson.lecture) == ("How wide is 60 degrees?", "003")
    assert (lesson.letters, lesson.is_talk) == ("003", False)
    first, second = lesson.steps
    assert (first.name, first.title, first.line) == ("typed", "The angle that you type", 6)
    assert first.state is not None
    assert first.state.values == ((10, "scene=letter-f"), (11, "lens.fov_y_deg=60"))
    assert formulas_in(first.words[0].text) == ["a = 9/16"]
    predict: Any = first.parts[1]
    assert predict.holds
    assert [(c.text, c.right, c.idea) for c in predict.replies] == [
        ("106.7°", False, "angle-linear"), ("91.5°", True, ""),
    ]  # fmt: skip
    task, answer = parts = second.asked
    assert [part.name for part in parts] == ["square", "answer"]
    assert task.hints == ("What decides how wide the picture is?",)
    assert (answer.unit, answer.replies[0].idea) == ("°", "angle-linear")  # type: ignore[attr-defined]
    assert [sample.verdict for sample in second.samples] == ["done", "right", "angle-linear"]


def test_a_value_goes_on_in_indented_lines_and_says_has_its_own() -> None:
    question = asked(
        "answer x\nHow much?\nvalue: 1 +\n  2\nwrong mine: 4\n  says: No,\n    not so.\n"
        "  state: lens.near=2; lens.far=9\nhint: First\n  line.\nhint: Second."
    )
    assert question.right[0].text == "1 + 2"
    (wrong,) = question.replies
    assert (wrong.idea, wrong.says) == ("mine", "No, not so.")
    assert [text for _, text in wrong.state.values] == ["lens.near=2", "lens.far=9"]
    assert question.hints == ("First line.", "Second.")


def test_a_choice_has_its_formula_and_its_idea_in_either_order() -> None:
    question = asked(
        "predict\nQ?\n- [x] $\\frac{1}{2}$ := near\n- [ ] 1: up {up-v} := 1\n"
        "- [ ] 2 := far {order}\n- [ ] none {look-n}"
    )
    assert [(c.text, [f.text for f in c.formulas], c.idea) for c in question.replies] == [
        ("$\\frac{1}{2}$", ["near"], ""), ("1: up", ["1"], "up-v"), ("2", ["far"], "order"),
        ("none", [], "look-n"),
    ]  # fmt: skip


@pytest.mark.parametrize(
    "lines",
    [
        "predict\nQ?\n\n- [x] a\n\n- [ ] b\n\nshow: lens.near=2\n",
        "answer\nQ?\n\nvalue: 2\n\nunit: m\n  \nwrong half: 1\n  says: No.\n\nwhy: So.\n",
        "task\nDo it.\n\nuntil: near = 2\n\nhint: Near.\n",
    ],
)
def test_a_block_may_have_empty_lines_between_its_lines(lines: str) -> None:
    dense = "\n".join(line for line in lines.splitlines() if line.strip())
    numbers = re.compile(r"line=\d+|(?<=\()\d+(?=, )")
    assert numbers.sub("", repr(asked(lines))) == numbers.sub("", repr(asked(dense)))


def test_steps_and_blocks_without_a_name_get_one_of_their_own() -> None:
    task = block("task\nDo.\nuntil: near > 1")
    lesson = parsed(TOP + "# Größe & Form\n" + task + task + "---\n# Two\n" + task)
    assert [step.name for step in lesson.steps] == ["größe-form", "two"]
    assert [part.name for part in lesson.steps[0].asked] == ["task", "task-2"]


def test_a_rule_ends_a_step_also_below_a_text_but_not_in_a_block() -> None:
    lesson = parsed(STEP + "Some text\n---\n# Two\n```note\nminutes: 2.5\n---\nSpeak.\n```\n")
    assert [step.title for step in lesson.steps] == ["One", "Two"]
    note = lesson.steps[1].note
    assert lesson.is_talk and note is not None
    assert (note.minutes, note.text) == (2.5, "---\nSpeak.")


def test_code_can_show_a_block_between_longer_fences() -> None:
    code = "````\n---\n# Two\n```state\nlens.near=2\n```\n````\n\n```\n---\n```\n\n## Below\n"
    (step,) = parsed(STEP + code).steps
    (words,) = step.parts
    assert words.text == code.rstrip("\n")


def test_html_scripts_links_and_pictures_are_text() -> None:
    shown = markdown().render(
        "<script>alert(1)</script> <b>x</b> [a](http://b) ![c](file:///etc/passwd) <http://d>\n\n"
        "<div>block</div>\n"
    )
    assert not re.search("<(script|b|div|a|img)[ >]", shown)
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in shown


def test_markdown_leaves_formulas_alone_and_dollars_can_be_prices() -> None:
    assert formulas_in(r"$a_1 * b_2 * \frac{x}{y}$ and $$\cot\alpha$$") == [
        r"a_1 * b_2 * \frac{x}{y}", r"\cot\alpha",
    ]  # fmt: skip
    assert formulas_in("5 $ and 6 $") == []


@pytest.mark.parametrize(
    ("tex", "words"),
    [
        ("M_{pp} M_{persp}", "M pp times M persp"),
        (r"P_{obl} = P_{ort}\,H, \quad B = A", "P obl equals P ort times H, B equals A"),
        (r"x' = -\frac{2}{f-n}\,x_p", "x prime equals minus 2 over (f minus n) x p"),
        (r"\dfrac{F^2}{\frac{a}{b}}", "(F to the power 2) over (a over b)"),
        (r"\vec{n} = \vec U \leq \sqrt{2}", "vector n equals vector U at most root of (2)"),
        (r"\frac{1$ \\ ^{", "frac {1$ \\ ^{"),
    ],
)  # fmt: skip
def test_a_formula_is_heard_in_words(tex: str, words: str) -> None:
    assert spoken_tex(tex) == words


def test_a_vector_is_heard_once() -> None:
    assert spoken_text(r"Vector $\vec{u}$ is $\vec{n}$.") == "Vector u is vector n."


FILES = [
    ("", "line 1 = '': must begin the lesson"),
    ("# Hello\n", "line 1 = '# Hello': must begin the lesson"),
    ("---\ntitle: T\n", "line 3 must begin the lesson"),
    ("---\nlecture: 001\n---\n# A\n", "line 1 lacks a line “title: ...”"),
    ("---\ntitel: T\n---\n# A\n", "line 2 = 'titel: T': must be one of title,"),
    ("---\ntitle: T\nletters: 009\n---\n# A\n", "line 3 = '009': must be one of own, 000"),
    ("---\ntitle: T\nlanguage: de\n---\n# A\n", "line 3 = 'de': must be one of en, hr, sr, sr-L"),
    ("---\ntitle: T\nversion: 2\n---\n# A\n", "line 3 was written for a newer Frustum Lab"),
    ("---\ntitle: T\nminutes: many\n---\n# A\n", "line 3 = 'many': must be a number from 0"),
    ("---\ntitle: T\n\n# A\n", "line 4 = '# A': lacks a line --- above it, which ends"),
    ("---\ntitle: T\n```state\n---\n", "line 3 = '```state': lacks a line --- above it"),
    ("---\ntitle: T\nlecture: 1\ntitle: U\n---\n# A\n", "line 4 has title twice"),
    ("---\ntitle: T\ntopic: L2, L99\n---\n# A\n", "line 3 = 'L2, L99': must be topics from L1"),
    ("---\ntitle: T\ntopic: L0\n---\n# A\n", "line 3 = 'L0': must be topics from L1 to L27"),
    (TOP, "line 3 has no steps"),
    (TOP + "Text\n", "line 4 = 'Text': must begin a step with its title"),
    (TOP + "## Two\n", "line 4 = '## Two': must begin a step with its title"),
    (TOP + "# One {#a b}\n", "line 4 = 'a b': must be a name"),
]
#: After a line 4 with the title of a step.
STEPS = [
    ("---\n# Two {#one}\n", "line 6 = 'one': repeats the name of line 4"),
    ("Words.\n# Two {#two}\n", "line 6 = '# Two {#two}': has the title of a step, but no line ---"),
    ("```state\nlens.near=1\n", "line 5 begins a block that is not closed"),
    ("\t```state\n\tlens.near=2\n\t```\n", "line 5 begins a block, but is indented"),
    ("```note\nSay.\n---\n# Two\n```state\nlens.near=2\n```\n",
     "line 5 begins a block that is not closed: a line ``` must end it, above line 9"),
    ("```state\nlens.near=2\n```note\nSay.\n```\n",
     "line 5 begins a block that is not closed: a line ``` must end it, above line 7"),
    ("Say.\n```\n---\n# Two\n```state\nlens.near=2\n```\n",
     "line 6 begins code, not a block, and the block of line 9 is in it: there is one"),
    ("Say.\n```\n---\n# Two\n", "line 6 begins code that is not closed: there is one"),
    ("```note\nA\n```\n```note\nB\n```\n", "line 8 has note twice"),
]  # fmt: skip
#: In a block whose first line is line 5.
BLOCKS = [
    ("predct\nx", "line 5 has an unknown kind of block, predct; the nearest is"),
    ("state", "line 5 needs NAME=VALUE"),
    ("state\nnear 1", "line 6 = 'near 1': must be NAME=VALUE"),
    ("state\nscene=../x.obj", "line 6 = '../x.obj': must be a file beside"),
    ("state\nscene=/etc/x.obj", "line 6 = '/etc/x.obj': must be a file beside"),
    ("state\ndocument: C:\\x.json", "must be a file beside the lesson"),
    ("state\nlens.near=1\nlens.near = 2", "line 7 has lens.near twice"),
    ("state\ndocument: a.json\ndocument: b.json", "line 7 has document twice"),
    ("predict\nQ?\n- [x] a" + "\n- [ ] b" * 10, "line 5 needs 2 to 10 choices"),
    ("predict\nQ?\n- [x] a", "line 5 needs 2 to 10 choices"),
    ("predict\nQ?\n- [ ] a\n- [ ] b", "line 5 needs 2 to 10 choices"),
    ("predict\nQ?\nchoices:\n- a\n- b", "line 5 needs 2 to 10 choices"),
    ("predict\nQ?\n- [x] a\n- b", "line 8 = '- b': must begin with “- [x]”"),
    ("predict\nQ?\n- [x] a\n  say: Yes.\n- [ ] b",
     "line 8 = 'say: Yes.': must be one of says, state, title, a colon, and its value"),
    ("predict\nQ?\n- [x] a\n  why: So.\n- [ ] b", "line 8 = 'why: So.': must"),
    ("answer\nQ?\nvalue: 1\nright: 1", "one of value, count, matrix, click, order, at"),
    ("answer\nQ?", "line 5 needs “value:”, “count:”, “matrix:”,"),
    ("answer\nQ?\nvalue: 1\n- [x] a\n- [ ] b", "line 8 gives the answer in a second way: keep one"),
    ("answer\nQ?\nvalue: 1\nwithin: 9", "line 8 has “within:”, which belongs to click only"),
    ("answer\nQ?\ntiles: view\nvalue: 1", "line 7 has “tiles:”, which belongs to order only"),
    ("answer\nQ?\nmatrix: 1, 2\nnumber: near", "line 8 has “number:”, which belongs to value, c"),
    ("answer\nQ?\n- [x] a\n- [ ] b\nunit: m", "line 9 has “unit:”, which belongs to val"),
    ("answer\nQ?\norder: view; R\nwrong x: R", "line 8 has “wrong:”, which belongs to value"),
    ("answer\nQ?\n  value: 2", "line 7 = 'value: 2': is indented, but belongs to nothing"),
    ("task\nDo.\n\tuntil: near > 1", "line 7 = 'until: near > 1': is indented, but"),
    ("predict\nQ?\n- [x] a:=2*\n- [ ] b", "line 7, := = '2*': needs a number"),
    ("answer\nvalue: 2", "line 5 needs a question"),
    ("answer\nQ?\nvalue: 2*", "line 7, value = '2*': needs a number, a letter"),
    ("answer\nQ?\nvalue: 2\nvalue: 3", "line 8 has value twice"),
    ("answer\nQ?\nvalue: 2\nwrung: 3", "line 8 = 'wrung: 3': must be one of"),
    ("answer\nQ?\nvalue: 2\nwrong: 1\n  state: lens.near=1; lens.near=2",
     "line 9 has lens.near twice"),
    ("answer\nQ?\nvalue: 2\nwrong: 1\n  Says: No.", "line 9 = 'Says: No.': must"),
    ("answer\nQ?\nvalue: 2\n  says: No.", "line 8 = 'says: No.': is indented"),
    ("answer\nQ?\nunits: m\nvalue: 2", "line 7 = 'units: m': must be one of val"),
    ("answer\nQ?\nValue: 2\nvalue: 2", "line 7 = 'Value: 2': must be one of"),
    ("task\nDo.", "line 5 needs “until: CONDITION”"),
    ("task\nDo.\nuntil: near", "line 7, until = 'near': must be a condition"),
    ("task\nDo.\nuntill: near > 1", "line 7 = 'untill: near > 1': must be one"),
    ("test\nx -> right", "line 6 = 'x -> right': must be a sample"),
    ("test\nx: 1 -> right", "line 6 = 'x': must be one of none"),
    ("note\nminuten: 2", "line 6 = 'minuten: 2': must be one of minutes, a colon"),
    ("note\nSay.\nMinutes: 2", "line 7 = 'Minutes: 2': must be one of minutes"),
    ("note\nminutes: 0\nminutes: 2", "line 7 has minutes twice"),
]  # fmt: skip
MISTAKES = [
    *FILES,
    *((STEP + text, said) for text, said in STEPS),
    *((STEP + block(lines), said) for lines, said in BLOCKS),
]


@pytest.mark.parametrize(("text", "said"), MISTAKES)
def test_a_mistake_is_refused_with_its_line_and_what_was_expected(text: str, said: str) -> None:
    assert said in refused(text)


def test_sentences_with_a_colon_are_not_keys() -> None:
    predict, task = asked(
        "predict\nMind: it turns. What is it?\nOne: near.\n- [x] a\n  A choice: this.\n"
        "- [ ] b\n  says: It is so:\n    because: of far.",
        "task\nWhen: now.\nCheck this: near.\nuntil: near > 1\nhint: Look:\n  there.",
    )
    assert predict.text == "Mind: it turns. What is it?\nOne: near."
    assert [choice.text for choice in predict.replies] == ["a A choice: this.", "b"]
    assert predict.replies[1].says == "It is so: because: of far."
    assert task.text == "When: now.\nCheck this: near."
    assert task.hints == ("Look: there.",)
    note = parsed(STEP + block("note\nRemember: 2 of them.\nMinutes are short.")).steps[0].note
    assert note is not None and note.text == "Remember: 2 of them.\nMinutes are short."


def test_too_many_steps_and_too_large_a_file_are_refused_at_once(tmp_path: Path) -> None:
    many = TOP + "\n---\n".join(f"# Step {number}" for number in range(10_000))
    assert f"has more than {MOST_STEPS} steps" in refused(many)
    path = tmp_path / "large.md"
    path.write_text(STEP + "x" * 3_000_000, encoding="utf-8")
    with pytest.raises(Refusal, match=r"large\.md is larger than 2 MiB"):
        read(path)
    with pytest.raises(Refusal, match="does not exist"):
        read(tmp_path / "none.md")
    assert is_lesson("A.MD") and not is_lesson("a.json")


def test_a_lesson_is_read_in_every_encoding(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    path, text = tmp_path / "own.md", STEP.replace("title: T", "title: Žaba") + "Text\n"
    for encoding in ("utf-8", "utf-8-sig", "utf-16", "utf-16-be"):
        path.write_bytes(text.encode(encoding))
        assert read(path).title == head_of(path).title == "Žaba"
    assert not caplog.messages
    path.write_bytes(text.replace("Žaba", "café").encode("latin-1"))
    assert read(path).title == head_of(path).title == "café"
    assert caplog.messages == [f"{path} {languages.said('read-as-latin-1')}."]
    complaints: list[Refusal] = []
    assert read(path, complaints.append).title == "café"
    said = "is not UTF-8 text, some letters may be wrong: save the file in that encoding."
    assert [str(each) for each in complaints] == [f"{path} {said}"]


@pytest.mark.parametrize(("word", "wrong"), [("sun", 0), ("point", 1)])
def test_a_prediction_can_check_a_word_of_the_state_that_it_shows(word: str, wrong: int) -> None:
    text = STEP + block("state\nscene=planar-shadow") + block(
        "predict\nWhich?\n- [x] a\n- [ ] b\n  says: No.\nshow: settings.kind=sun\n"
        f"check: settings.kind = {word}"
    )  # fmt: skip
    report = CheckReport()
    report.take(parsed(text))
    assert [str(error) for error in report.wrong] == wrong * [
        "lesson.md: line 14 = 'settings.kind = point': does not hold."
    ]
