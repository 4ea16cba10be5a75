"""Every regular expression of the program, on long texts of its own characters.

``python3 -m tests.fuzz regexes`` finds the expressions in the source, makes texts that each of them
matches in part, and measures it on them. An expression that takes more than three times as long for
twice the text is a finding, and so is one that takes more than `LONGEST_S` for `SIZE` characters.
Where the caller bounds its text (`BOUNDED`), it is measured on texts of that length.
"""

import ast
import collections
import itertools
import os
import re
import signal
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from tests.support.tools import ToolParser

parser = import_module("re._parser")  # the tree of an expression is not public
ROOT = Path(__file__).parents[2]
SIZE = 1_000_000
LONGEST_S = 5.0
SHORT, RATIO, NOTICED_S = 8_000, 3.0, 0.02
"""A shorter text, and what a text twice as long may cost, if that is noticed at all."""
METHODS = ("search", "match", "fullmatch", "split", "findall", "finditer", "sub", "subn")
MOST_TEXTS = 400
"""Most texts for one expression."""
BOUNDED = {"app/lessons/marking.py": 60}
"""Files whose expressions read short texts only, and the characters of the longest one."""
OF_THE_PROGRAM = {
    "app/languages.py": "translations",
    "app/lessons/translating.py": "lessons that come with the program",
    "app/drawings/page.py": "the SVG text that it has just drawn",
    "widgets/parts/chart_picture.py": "the PDF file that it has just drawn",
}
"""Files whose expressions read only what the program wrote itself."""
LOCAL = {
    "app/lecture/letters.py": [r"t\d*_"],
    "app/commands/options.py": ["[0-9]{1,9}", "[1-9]|1[0-7]"],
    "app/bootstrap.py": ["No space left", "Failed to build|Failed building"],
    "widgets/parts/messages.py": [r"(\S{40})(?=\S)"],
    "widgets/parts/typeset.py": [r"[−+·\s]"],
    "widgets/window/settings.py": ["([a-z]{2,3}([_-][A-Za-z]{2,4}){0,2})?"],
}
"""What an expression that is an argument or a local variable may be, by its file."""


class Used(NamedTuple):
    """An expression of the program, where it stands, and how it is used."""

    where: str
    pattern: re.Pattern[Any]
    methods: tuple[str, ...]


# --------------------------------------------------------------------------- finding them


def used() -> Iterator[Used]:
    """Yield every expression in ``app`` and ``widgets``."""
    sources = {
        path: ast.parse(path.read_text(encoding="utf-8"))
        for folder in ("app", "widgets")
        for path in sorted((ROOT / folder).rglob("*.py"))
        if path.name != "__main__.py"
    }
    everywhere = _methods_by_name(sources.values())
    for path, tree in sources.items():
        methods = everywhere | _methods_by_name([tree])
        parts = path.relative_to(ROOT).with_suffix("").parts
        names = vars(import_module(".".join(part for part in parts if part != "__init__")))
        owners = {
            id(call): target.id
            for node in ast.walk(tree)
            if isinstance(node, ast.Assign) and isinstance(target := node.targets[0], ast.Name)
            for call in ast.walk(node.value)
        }
        for call in ast.walk(tree):
            if not _is_of_re(call):
                continue
            assert isinstance(call, ast.Call) and isinstance(call.func, ast.Attribute)
            method = call.func.attr
            wanted = (method,) if method in METHODS else methods.get(owners.get(id(call), ""), ())
            file = path.relative_to(ROOT).as_posix()
            for text, flags in _values(call, names, LOCAL.get(file, ())):
                found = text if isinstance(text, re.Pattern) else re.compile(text, flags)
                yield Used(f"{file}:{call.lineno}", found, wanted or ("search", "fullmatch"))


def _is_of_re(node: ast.AST) -> bool:
    match node:
        case ast.Call(func=ast.Attribute(value=ast.Name(id="re"), attr=name)):
            return name == "compile" or name in METHODS
    return False


def _methods_by_name(trees: Any) -> dict[str, tuple[str, ...]]:
    """Return which methods are called of the expressions that have a name."""
    found: dict[str, set[str]] = {}
    for tree in trees:
        for node in ast.walk(tree):
            match node:
                case ast.Attribute(value=ast.Name(id=name), attr=method) if method in METHODS:
                    found.setdefault(name, set()).add(method)
    return {name: tuple(sorted(methods)) for name, methods in found.items()}


def _values(
    call: ast.Call, names: dict[str, Any], local: Sequence[str]
) -> Iterator[tuple[Any, int]]:
    """Yield the expressions of a call; those of a loop are in a table of the module."""
    flags = 0
    for node in (*call.args, *(each.value for each in call.keywords)):
        text = ast.unparse(node)
        flags |= eval(text) if re.fullmatch(r"re\.[A-Z]+( \| re\.[A-Z]+)*", text) else 0
    try:
        yield eval(ast.unparse(call.args[0]), dict(names)), flags
    except NameError:
        table = names.get("_OF_BRACES") if ast.unparse(call.args[0]) == "pattern" else None
        yield from ((text, flags) for text in ([row[0] for row in table] if table else local))
        if not (table or local):
            raise


# --------------------------------------------------------------------------- their texts


def _sample(parts: Any) -> str:
    """Return a short text that a part of an expression matches."""
    return "".join(_samples(node)[0] for node in parts)


def _samples(node: Any) -> list[str]:
    """Return texts that one node of an expression matches; the first is typical."""
    kind, value = node
    name = str(kind)
    if name == "LITERAL":
        return [chr(value)]
    if name in ("NOT_LITERAL", "ANY"):
        return ["x" if name == "ANY" or value != ord("x") else "y"]
    if name == "IN":
        return _of_class(value)
    if name in ("MAX_REPEAT", "MIN_REPEAT", "POSSESSIVE_REPEAT"):
        least, _, inside = value
        one = _sample(inside)
        found = [one * max(1, least)]
        return [*found, *([""] if not least else [])]
    if name == "SUBPATTERN":
        return [_sample(value[-1])]
    if name == "ATOMIC_GROUP":
        return [_sample(value)]
    if name == "BRANCH":
        return [_sample(branch) for branch in value[1]]
    if name == "ASSERT":
        return ["", _sample(value[1])]
    return [""]  # a place, a reference or a negation


def _of_class(items: Any) -> list[str]:
    is_not = str(items[0][0]) == "NEGATE"
    found = list[str]()
    for kind, value in items[is_not:]:
        name = str(kind)
        if name == "LITERAL":
            found.append(chr(value))
        elif name == "RANGE":
            found.append(chr(value[0]))
        elif name == "CATEGORY":
            category = str(value)
            found.append(" " if "SPACE" in category else "1" if "DIGIT" in category else "a")
    if not is_not:
        return found
    others = [letter for letter in "ax1 -(\n" if letter not in found]
    return others or ["z"]


def _nodes(parts: Any) -> Iterator[Any]:
    """Yield the sequences of nodes in an expression, from the outside in."""
    yield list(parts)
    for kind, value in parts:
        name = str(kind)
        if name in ("MAX_REPEAT", "MIN_REPEAT", "POSSESSIVE_REPEAT"):
            yield from _nodes(value[2])
        elif name == "SUBPATTERN":
            yield from _nodes(value[-1])
        elif name == "ATOMIC_GROUP":
            yield from _nodes(value)
        elif name == "BRANCH":
            for branch in value[1]:
                yield from _nodes(branch)
        elif name in ("ASSERT", "ASSERT_NOT"):
            yield from _nodes(value[1])


def texts(pattern: re.Pattern[Any]) -> Sequence[Callable[[int], str]]:
    """Return what makes texts of any length of which an expression matches a part."""
    source = pattern.pattern
    tree = parser.parse(source if isinstance(source, str) else source.decode("latin-1"))
    units = dict[str, None]()
    heads = {"": None}
    for sequence in _nodes(tree):
        samples = [_samples(node) for node in sequence]
        for each in itertools.chain(*samples):
            units[each] = None
        for begin in range(len(sequence)):
            heads["".join(each[0] for each in samples[:begin])] = None
            for end in range(begin + 2, min(begin + 9, len(sequence)) + 1):
                units["".join(each[0] for each in samples[begin:end])] = None
    singles = [unit for unit in units if len(unit) == 1]
    units |= dict.fromkeys(a + b for a, b in itertools.permutations(singles[:9], 2))
    for more in (" ", "0", "a", "\n", "("):
        units[more] = None
    units.pop("", None)
    made = [*itertools.product([*heads][:6], [*units], ("", "\0", "z!"))]
    return [partial(_text, *parts) for parts in made[:: max(1, len(made) // MOST_TEXTS)]]


def _text(head: str, unit: str, tail: str, size: int) -> str:
    return head + unit * max(1, (size - len(head) - len(tail)) // len(unit)) + tail


# --------------------------------------------------------------------------- measuring


class TooSlow(Exception):
    """The limit of time is over."""


def _seconds(pattern: re.Pattern[Any], method: str, text: str) -> float:
    """Return how long an expression reads a text, at most `LONGEST_S`."""
    given: Any = text if isinstance(pattern.pattern, str) else text.encode("latin-1", "replace")
    words = [given[:0], given] if method.startswith("sub") else [given]

    def stop(*_: object) -> None:
        raise TooSlow

    former = signal.signal(signal.SIGALRM, stop)
    started = time.process_time()
    signal.setitimer(signal.ITIMER_REAL, LONGEST_S)
    try:
        found = getattr(pattern, method)(*words)
        collections.deque(found if method == "finditer" else (), maxlen=0)
    except TooSlow:
        return LONGEST_S
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, former)
    return time.process_time() - started


def finding(each: Used, size: int) -> str:
    """Return what is wrong with an expression; empty if nothing is."""
    short = BOUNDED.get(each.where.rpartition(":")[0], SHORT)
    worst = 0.0, "", ""
    for make, method in itertools.product(texts(each.pattern), each.methods):
        once, *more = (_seconds(each.pattern, method, make(n * short)) for n in (1, 2, 2))
        if min(more) > max(NOTICED_S, RATIO * once):
            return f"{method} of {make(12)!r}...: {once:.3f} s, twice as long {min(more):.3f} s"
        worst = max(worst, (min(more), method, make(size)))
    if short < SHORT:
        return ""
    _, method, text = worst
    taken_s = _seconds(each.pattern, method, text)
    return f"{method} of {text[:12]!r}...: {taken_s:.1f} s" if taken_s >= LONGEST_S else ""


def main(words: Sequence[str]) -> int:
    """Measure all expressions; 1 if there are findings."""
    parser = ToolParser("fuzz regexes", __doc__)
    parser.add_argument("--size", type=int, default=SIZE)
    parser.add_argument("--only", default="", help="a part of the path of the files")
    options = parser.parse_args(words)
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    count = findings = 0
    for each in used():
        if options.only not in each.where or each.where.rpartition(":")[0] in OF_THE_PROGRAM:
            continue
        count += 1
        if what := finding(each, options.size):
            findings += 1
            print(f"{each.where} {each.pattern.pattern!r}: {what}", flush=True)
    print(f"{count} expressions, {findings} findings")
    return 1 if findings else 0
