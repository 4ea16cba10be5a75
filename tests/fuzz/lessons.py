"""Hostile lessons, talks, results, records, strokes and lists: made here, and read and drawn.

A lesson or a talk is a step of one of the program's own, with numbers of up to 400 digits,
formulas, lists and lines in the places of its own ones. What else a student or a lecturer
has on disk begins as the program writes it. `DONE` does with each file what a person would: draws
every picture, answers every question, opens the hints and the solution, sums up the record, paints
the strokes.
"""

import contextlib
import json
import random
import re
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from app.commands.options import SETTABLE, Parser
from app.lecture.typesetting import outline
from app.lessons import record as records
from app.lessons import results
from app.lessons.blocks import exercise
from app.lessons.blocks.block import ReadBlock
from app.lessons.blocks.exercise import Exercise
from app.lessons.blocks.question import MarkedQuestion, Question
from app.lessons.blocks.task import Task
from app.lessons.contents import CONTENT
from app.lessons.course import Course, ideas
from app.lessons.lesson import read
from app.lessons.practice import find_waiting, to_review, topics
from app.lessons.quantities import FUNCTIONS
from app.lessons.strokes import COLOURS, path_beside, read_strokes
from app.lessons.text import html_of, spoken_text
from app.model.refusal import Refusal
from app.scenes.phenomena import PHENOMENA
from tests.fuzz.files import DAMAGE, NUMBERS, WORDS, structure

FEW_SEEDS = 24
"""Variants that the check of an exercise draws: the others only take longer."""
MOST_DIGITS = 400
_NAMES = (
    "near", "far", "fov", "fov_x", "aspect", "width", "eye_x", "infinity", "pi", "a", "was_near",
    "clip_w", "ndc_z(2)", "world_from_object", "settings_distance", "reading_x", "alpha", "stage",
)  # fmt: skip
_VALUE = re.compile(
    r"(value|wrong [\w-]+|wrong|until|where|check|vary \w+|at|within|first|matrix|minutes|unit|hide"
    r"|state|right|show|click|hint|why|done|says)(: )(.*)"
)


# --------------------------------------------------------------------------- numbers and formulas


def a_number(rng: random.Random) -> str:
    """A number as a file has it, with up to `MOST_DIGITS` digits."""
    if rng.random() < 0.25:
        return rng.choice(NUMBERS)
    count = rng.choice((1, 2, 3, 17, 60, 99, 101, 300, 308, 309, 350, MOST_DIGITS))
    text = "".join(rng.choices("0123456789", k=count))
    if rng.random() < 0.4:
        at = rng.randrange(count + 1)
        text = f"{text[:at]}{rng.choice('.,')}{text[at:]}"
    if rng.random() < 0.3:
        text += (
            f"{rng.choice('eE')}{rng.choice(('', '-', '+'))}{rng.choice((1, 99, 100, 308, 4000))}"
        )
    return rng.choice(("", "", "-", "+", "−")) + text


def a_formula(rng: random.Random, depth: int = 3) -> str:
    """A formula; often one that has no value."""
    kind = rng.random()
    if depth == 0 or kind < 0.2:
        if rng.random() < 0.4:
            return rng.choice(_NAMES)
        return str(rng.choice((0, 1, 2, 10, 90, 180))) if rng.random() < 0.6 else a_number(rng)
    if kind < 0.4:
        arguments = [a_formula(rng, depth - 1) for _ in range(rng.choice((1, 1, 1, 2, 3)))]
        return f"{rng.choice([*FUNCTIONS, *_NAMES])}({', '.join(arguments)})"
    if kind < 0.5:
        power = rng.choice((0, 1, 2, 3, 50, 99, 100, 101, 9999))
        return f"({a_formula(rng, depth - 1)})^{rng.choice(('', '-'))}{power}"
    sign = rng.choice(("+", "-", "*", "/", "/"))
    return f"({a_formula(rng, depth - 1)} {sign} {a_formula(rng, depth - 1)})"


def _a_value(rng: random.Random, key: str, text: str) -> str:
    """Something in the place of a value in a lesson."""
    if key.startswith("vary") and rng.random() < 0.6:
        one, other, step = (rng.choice((a_number, a_formula))(rng) for _ in range(3))
        ranges = f"{one}..{other} step {step}", f"{one}..{other}", f"1..{rng.randrange(90)}"
        many = ",".join([one] * rng.choice((2, 20, 1000, 200_000 if rng.random() < 0.02 else 1001)))
        return rng.choice((*ranges, many, ", ".join((one, other, step))))
    if key in ("state", "right", "show") and rng.random() < 0.7:
        return re.sub(r"(?<==)[^;]*", lambda found: _or(rng, found[0], a_number(rng)), text)
    if key in ("until", "where", "check") and rng.random() < 0.7:
        signs = rng.choice(("=", "!=", "<", ">", "<=", ">=", "≠", ""))
        return f"{a_formula(rng)} {signs} {a_formula(rng)}"
    if key in ("matrix", "at") and rng.random() < 0.7:
        cells = re.split(r"([,;])", text)
        cells[::2] = [_or(rng, cell, f" {a_formula(rng)}") for cell in cells[::2]]
        return "".join(cells)
    ways = a_formula(rng), a_number(rng), f"{text} + {a_formula(rng)}", f"{{={a_formula(rng)}}}"
    return rng.choice((*ways, f"{{~{a_formula(rng)}}}", rng.choice(WORDS), f"${a_formula(rng)}$"))


def _or(rng: random.Random, kept: str, other: str) -> str:
    return other if rng.random() < 0.4 else kept


# --------------------------------------------------------------------------- lessons and talks


@cache
def _parted() -> dict[bool, list[tuple[str, list[str]]]]:
    """Return the top and the steps of the program's own talks, and of its own lessons."""
    found: dict[bool, list[tuple[str, list[str]]]] = {True: [], False: []}
    for path in sorted(CONTENT.glob("*.md")):
        top, *steps = re.split(r"^---\n", path.read_text("utf-8"), flags=re.MULTILINE)[1:]
        found[path.stem.startswith("talk")].append((top, steps))
    return found


def a_lesson(rng: random.Random, *, talk: bool) -> str:
    """Some steps of one of the program's own files, changed in a few places."""
    top, steps = rng.choice(_parted()[talk])
    at = rng.randrange(len(steps))
    kept = [steps[at]]
    lines = "---\n".join(["", top, *kept]).split("\n")
    for _ in range(rng.choice((1, 1, 2, 3, 5))):
        _change(rng, lines)
    return "\n".join(lines)


def _change(rng: random.Random, lines: list[str]) -> None:
    """Change a line where a number, a formula, a sample or a value stands."""
    at = rng.randrange(len(lines))
    kind = rng.random()
    if kind < 0.45:  # a value
        places = [place for place, line in enumerate(lines) if _VALUE.match(line.strip())]
        at = rng.choice(places or [at])
        if found := _VALUE.match(lines[at].strip()):
            lines[at] = f"{found[1]}{found[2]}{_a_value(rng, found[1], found[3])}"
    elif kind < 0.55:  # a sample, or the formula of a choice
        places = [place for place, line in enumerate(lines) if " -> " in line or " := " in line]
        if places:
            at = rng.choice(places)
            head, sign, tail = re.split(r"( -> | := )", lines[at], maxsplit=1)
            name, colon, _ = head.partition(": ")
            is_sample = sign == " -> " and colon
            typed = rng.choice((a_number(rng), f"{rng.randrange(40)} {a_number(rng)}", tail))
            lines[at] = (
                f"{name}: {typed}{sign}{tail}" if is_sample else f"{head} := {a_formula(rng)}"
            )
    elif kind < 0.7:  # any number
        lines[at] = re.sub(
            r"\d+(\.\d+)?", lambda found: _or(rng, found[0], a_number(rng)), lines[at]
        )
    elif kind < 0.8:
        lines.insert(at, rng.choice(WORDS))
    elif kind < 0.88:
        lines[at] += rng.choice("[(`$*_ {}<0a-|\\") * rng.choice((10, 300, 3900, 4100, 300_000))
    elif kind < 0.94:
        del lines[at : at + rng.choice((1, 1, 2, 6))]
        lines.append("")
    else:
        piece = lines[at : at + rng.choice((1, 2, 6))]
        lines[at:at] = piece * rng.choice((1, 2, 40))


# --------------------------------------------------------------------------- what is on disk


@cache
def _questions() -> list[tuple[str, str, int, str]]:
    """Return questions of the program's own lessons: lesson, step and block, seed, an answer."""
    found = []
    for course in topics().values():
        for step in course.lesson.steps:
            for sample in step.samples:
                seed, _, typed = sample.text.partition(" ")
                is_drawn = seed.isdecimal() and bool(typed)
                name = f"{step.name}/{sample.block}"
                found.append(
                    (course.name, name, int(seed) if is_drawn else 0, typed or sample.text)
                )
    return found


def _attempts(rng: random.Random) -> Iterator[dict[str, Any]]:
    for number in range(rng.choice((1, 3, 20))):
        lesson, name, seed, typed = rng.choice(_questions())
        if rng.random() < 0.4:
            typed = rng.choice(
                (a_number(rng), a_formula(rng), " | ".join([a_number(rng)] * 3), "2")
            )
        tree: dict[str, Any] = {
            "when": 1_700_000_000 + 86_400 * number, "lesson": lesson, "exercise": name,
            "seed": seed, "typed": typed[: rng.choice((60, 2000))], "hints": rng.randrange(3),
            "verdict": rng.choice((records.RIGHT, records.WRONG, records.SHOWN)),
        }  # fmt: skip
        if rng.random() < 0.3:
            tree["idea"] = rng.choice(("order", "mirror", "nobody", "right"))
        yield tree


def _as_json(rng: random.Random, tree: Any) -> str:
    """Write a tree as JSON, half of them damaged, with numbers of any size."""
    if rng.random() < 0.5:
        tree = structure(rng, tree)
    text = json.dumps(tree)
    if rng.random() < 0.4:
        text = re.sub(
            r"(?<=[ \[])-?\d+(\.\d+)?(?=[,\]}])",
            lambda found: a_number(rng) if rng.random() < 0.2 else found[0],
            text,
        )
    return text


def some_results(rng: random.Random) -> str:
    tree = {
        "format": results.FORMAT, "version": results.VERSION, "program": "1.0", "student": "Ada",
        "lessons": {"l05-similar-triangles": "0123456789abcdef"}, "answers": [*_attempts(rng)],
    }  # fmt: skip
    return _as_json(rng, tree)


def a_record(rng: random.Random) -> str:
    return "".join(f"\n{_as_json(rng, tree)}" for tree in _attempts(rng))


def some_strokes(rng: random.Random, steps: Sequence[str]) -> str:
    def a_place() -> list[float]:
        return [rng.random(), rng.random()]

    strokes = {
        step: [
            [rng.choice(COLOURS), *(a_place() for _ in range(rng.choice((1, 2, 30))))]
            for _ in range(rng.randrange(4))
        ]
        for step in [*steps, "gone"]
    }
    return _as_json(rng, {"strokes": strokes})


def a_list(rng: random.Random) -> str:
    """A list of figures, as CSV."""
    options = [action.option_strings[-1][2:] for action in Parser("export").options()]
    settings = [
        setting.path for phenomenon in PHENOMENA.values() for setting in phenomenon.settings
    ]
    known = [*SETTABLE, *rng.sample(settings, 6), *options, "step", "file", "set"]
    columns = ["out", *rng.sample(known, rng.choice((1, 2, 3, 5)))]
    if rng.random() < 0.05:
        columns[-1] = rng.choice(("", "x" * 5000, a_number(rng), columns[0], "a;b"))
    rows = [columns]
    for number in range(rng.choice((1, 1, 2))):
        ending = rng.choice(("svg", "svg", "svg", "png", "pdf", "tex", "html", "gif"))
        rows.append([f"{number}.{ending}", *(_a_cell(rng, column) for column in columns[1:])])
    return "\n".join(",".join(f'"{cell.replace(chr(34), "")}"' for cell in row) for row in rows)


def _a_cell(rng: random.Random, column: str) -> str:
    """A value for a column: one that it may have, or a number."""
    if rng.random() < 0.3:
        return a_number(rng)
    usual = {
        "file": ("L5", "cube", "nothing.json", "001", "x" * 300),
        "step": ("1", "2", "at", "9" * 400),
        "scene": (*PHENOMENA, "cube", "letter-f"), "depth": ("opengl", "reversed"),
        "lens.kind": ("frustum", "orthographic", "oblique", "perspective"), "size": ("40mmx30mm",),
        "set": ("lens.near=2", f"lens.near={a_number(rng)}", "near"), "dark": ("yes", "no"),
    }  # fmt: skip
    if column in usual:
        return rng.choice(usual[column])
    several = ",".join(rng.choice(("0", "1", "-2.5", a_number(rng))) for _ in range(3))
    return rng.choice((several, "1", "0.5", "90", "", "true", "yes", rng.choice(WORDS)))


def write(folder: Path, rng: random.Random, number: int, kind: str) -> Path:
    """Write a file of a kind of `DONE`."""
    path = folder / f"{number}.{kind}{ENDINGS[kind]}"
    talk = folder / f"{number}.md"
    if kind in ("lesson", "talk"):
        text = a_lesson(rng, talk=kind == "talk")
    elif kind == "strokes":
        path = path_beside(talk)
        text = some_strokes(rng, ["projection", "one", "two"])
    else:
        text = {"results": some_results, "record": a_record, "list": a_list}[kind](rng)
    data = text.encode(errors="surrogatepass")
    if rng.random() < 0.1:
        damage = rng.choice([*DAMAGE])
        data = DAMAGE[damage](rng, data or b"\n")
    path.write_bytes(data)
    return path


ENDINGS = {
    "lesson": ".md", "talk": ".md", "results": ".json", "record": ".jsonl", "strokes": ".json",
    "list": ".csv",
}  # fmt: skip


# --------------------------------------------------------------------------- read and drawn


def _try_lesson(path: Path) -> None:
    """Draw and answer what can be read of a lesson."""
    from app.commands.composed import Composed, measure, taken

    with contextlib.suppress(Refusal):
        faults = list[Refusal]()
        course = Course(read(path, faults.append))
        if faults:  # else the check has drawn it
            taken(Composed(), course, measure(), ())
        for place, step in enumerate(course.lesson.steps):
            here = course.at(place)
            for part in step.parts:
                with contextlib.suppress(Refusal):
                    _try_part(part, here)


def _try_part(part: ReadBlock, here: Any) -> None:
    """Read a part as the card, the handout and the speaker's window show it, and answer it."""
    if isinstance(part, Exercise):
        variant = part.variant(here, 1)
        part, here = variant.question, variant.here
    texts = [text for _, text in part.texts()]
    if isinstance(part, Question):
        texts += [part.posed(), part.with_answer(part.answer_text(here, "{:.4g}".format)), part.why]
        texts.append(part.solution(here))
    for text in texts:
        _, formulas = html_of(text)
        spoken_text(text)
        for tex in formulas:
            with contextlib.suppress(ValueError):  # then it is shown as it was typed
                outline(tex)
    if isinstance(part, MarkedQuestion):
        for typed in ("1", "-1e-99", "9" * 60, "1 1", "1 2 3", "1 | 2; 3 | 4", "x"):
            with contextlib.suppress(Refusal):
                part.mark(here, typed)
    if isinstance(part, Task):
        part.is_done(here, here.document)
        part.mistaken_in(here, here.document)


def _try_results(path: Path) -> None:
    """Mark results once more, and write and read them."""
    with contextlib.suppress(Refusal):
        found = results.read(path)
        path.write_text(results.to_json(found.student, found.attempts, "1.0"), "utf-8")
        results.read(path)


def _try_record(path: Path) -> None:
    """Sum up a record, and prepare a review."""
    record = records.Record(path)
    attempts = record.read()
    known = records.standings(attempts)
    to_review(find_waiting(attempts).due, known)
    records.ideas_met(attempts, known)
    str(record.problem)
    with contextlib.suppress(Refusal):
        record.add(records.Attempt(1, "l", "s/e", 1, "1", records.RIGHT))
    results.to_json("", attempts, "1.0")


def _try_strokes(path: Path) -> None:
    """Paint the strokes beside a talk."""
    from PySide6.QtCore import QRectF
    from PySide6.QtGui import QImage, QPainter

    from widgets.window.pen import paint_strokes

    image = QImage(640, 360, QImage.Format.Format_RGB32)
    with contextlib.suppress(Refusal):
        strokes = read_strokes(path.with_name(path.name.removesuffix(".strokes.json") + ".md"))
        painter = QPainter(image)
        for drawn in strokes.values():
            paint_strokes(painter, QRectF(image.rect()), drawn)
        painter.end()


DONE: dict[str, Callable[[Path], None]] = {
    "lesson": _try_lesson, "talk": _try_lesson, "results": _try_results, "record": _try_record,
    "strokes": _try_strokes, "list": lambda _: None,
}  # fmt: skip
"""What is done with each kind of file besides its command."""


def command(path: Path, kind: str) -> list[str]:
    """Return the words of the command that opens a file; none if no command does."""
    return {
        "lesson": ["lesson", "check", str(path)],
        "talk": ["talk", str(path), "--check"],
        "results": ["lesson", "results", str(path), "--csv", str(path.with_suffix(".csv"))],
        "list": ["export", "--batch", str(path), str(path.with_suffix(""))],
    }.get(kind, [])


def prepare() -> None:
    """Import and read what all files need, so that no file has to."""
    import pyvista.plotting  # noqa: F401

    import widgets.window.pen  # noqa: F401
    import widgets.window.talk_band  # noqa: F401

    exercise.SEEDS = FEW_SEEDS
    ideas()
    for course in topics().values():
        for place in range(len(course.lesson.steps)):
            course.shown(place)
    outline("x")
