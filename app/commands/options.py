"""The commands, their options, and the messages for wrong ones.

The page ``content/options.md`` says what each is: a heading of a command and its words, a summary,
what the words are, and a line for each option; ``a|b`` there are the only values. How the others
are read is said here. This module needs only the standard library: help and the refusal of misspelt
options work before the set-up.
"""

import argparse
import difflib
import os
import re
from collections.abc import Callable, Sequence
from functools import cache, partial
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from app import __version__, bootstrap, languages
from app.commands.terminal import CliError, write_out
from app.document.lengths import PX_PER, parse_length, parse_points, parse_size
from app.languages import said
from app.lessons.contents import file_of
from app.model.numerals import number
from app.model.refusal import counted, nearest

FULL_TURN = 360.0  # of an orbit, in degrees
TEX_PT_PER = {"mm": 72.27 / 25.4, "cm": 72.27 / 2.54, "in": 72.27, "pt": 1.0}
WIDTHS_PT = 200.0, 1500.0  # of a text or a column, for LaTeX; 72.27 of its points are an inch
SWEEPS = ("near", "far", "fov", "distance", "up", "aspect", "gap")


class Page(NamedTuple):
    words: str  # the names of its words
    summary: str
    about: str  # what its words are
    options: Sequence[Sequence[str]]  # name, value or "", text

    @property
    def texts(self) -> tuple[str, ...]:
        return (self.summary, self.about, *(text for _, _, text in self.options))


@cache
def pages() -> dict[str, Page]:
    """Return what the page says, by the names of the commands."""
    text = (Path(__file__).parent / "content" / "options.md").read_text("utf-8")
    pages = {}
    for section in text.split("\n## ")[1:]:
        prose = re.split("\n+", re.sub("(?m)^- .*", "", section).strip())
        heading, summary, about = [*prose, argparse.SUPPRESS][:3]
        command, _, words = heading.partition(" ")
        options = re.findall("(?m)^- (--[a-z-]+)(?: (.+?))?: (.*)", section)
        pages[command] = Page(words, summary, about, options)
    return pages


_tr = partial(languages.translate, context="Options")
vars(argparse)["_"] = said  # which it calls for each text of its own
SETTABLE = pages()["--set"].summary.split(", ")
"""Every path that ``--set`` knows, for all lenses; each scene adds its own ``settings.NAME``.

The list, and `SWEEPS`, repeat names from modules with dependencies; a test compares them.
"""
SUMMARIES = {
    name: page.summary for name, page in pages().items() if name not in ("window", "--set")
}


def choices(command: str, option: str) -> list[str]:
    return next(value for name, value, _ in pages()[command].options if name == option).split("|")


class Parser(argparse.ArgumentParser):
    """An argument parser that refuses in sentences and names the nearest option."""

    def __init__(self, command: str) -> None:
        names, summary, about, options = pages()[command or "window"]
        usage = " ".join(f"{bootstrap.PROGRAM} {command} [{said('options')}] {names}".split())
        lines = "\n".join(f"  {name:<10}{_tr(text)}" for name, text in SUMMARIES.items())
        super().__init__(
            usage=usage,
            description=_tr(summary),
            epilog="" if command else f"{said('of-commands')}\n{lines}",
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
        )
        self._command, self._names = command, names
        about = about if about == argparse.SUPPRESS else _tr(about).replace("%", "%%")
        self.add_argument("words", nargs="*", metavar=names, help=about)
        details = _DETAILS.get(command, {})
        for option, value, text in options:
            usual = re.search(r"\(default: (\w+)\)", text)
            more = {"default": usual[1]} if usual and usual[1] in value.split("|") else {}
            more |= {"action": "append"} if "may be repeated" in text else {}
            more |= details.get(option, {})
            self._add(option, value, _tr(text).replace("%", "%%"), **more)
        if command in _OF_A_DOCUMENT:
            more = {"action": "append", "default": []}
            self._add("--set", "NAME=VALUE", said("of-set", ", ".join(SETTABLE)), **more)
        self._add("--language", "|".join(languages.LANGUAGES), said("of-language"))

    def _print_message(self, message: str, _file: object = None) -> None:
        """Print the help or the version; argparse would ignore write errors."""
        write_out([message])

    def error(self, message: str) -> NoReturn:
        raise CliError(f"{message[0].upper()}{message[1:]}.")

    def read(self, arguments: Sequence[str]) -> tuple[argparse.Namespace, list[str]]:
        """Parse options and words in any order; refuse too few words and too many."""
        # After -- all words are names; argparse loses that when options and names are mixed.
        end = arguments.index("--") if "--" in arguments else len(arguments)
        options, extra = self.parse_known_intermixed_args(self._with_usual(arguments[:end]))
        for word in extra:
            option = word.partition("=")[0]
            names = [name for action in self._actions for name in action.option_strings]
            where, near = self._command or said("the window"), nearest(option.lower(), names)
            raise CliError("{0} is not an option of {1}; the nearest is {2}.", option, where, near)
        words: list[str] = [*options.words, *arguments[end + 1 :]]
        command = self._command or said("The window")
        if "" in words:
            raise CliError("{0} was given an empty name.", command)
        if not self._command and len(words) > 1:
            check_file(words[0])  # perhaps a command behind an option
        names = self._names.split()
        if len(words) < len(names):
            names = [name for name in names if not name.startswith("[")]
        elif self._names.endswith("...]"):
            names += names[-1:] * (len(words) - len(names))
        if len(words) != len(names):
            takes = self._names or said("no names")
            raise CliError("takes", command, takes, counted(len(words), "name"))
        named = zip(words, names, strict=True)
        return options, [file_of(word) if "FILE" in name else word for word, name in named]

    def _with_usual(self, arguments: Sequence[str]) -> list[str]:
        """Give options whose number may be left out their usual one, and not the next word."""
        usual = {action.option_strings[0]: action.const for action in self.options()
                 if action.nargs == "?"}  # fmt: skip
        words = list[str]()
        for word, after in zip(arguments, [*arguments, ""][1:], strict=True):
            is_bare = word in usual and not _is_number(after)
            words.append(f"{word}={usual[word]:g}" if is_bare else word)
        return words

    def options(self) -> list[argparse.Action]:
        """Return what begins with dashes."""
        return [action for action in self._actions if action.option_strings]

    def _add(self, option: str, value: str, text: str, **more: Any) -> None:
        if not value:
            self.add_argument(option, help=text, **{"action": "store_true", **more})
            return
        if "|" in value:
            values = value.split("|")
            more = {"type": lambda typed: one_of(option, typed, values), **more}
        self.add_argument(option, metavar=value, help=text, **more)


def one_of(option: str, value: str, values: Sequence[str]) -> str:
    # argparse does not catch a CliError, and so does not rephrase it.
    if value not in values:
        raise CliError("{0} = {1!r}: must be one of {2}.", option, value, ", ".join(values))
    return value


def parse_number(text: str) -> float:
    """Parse a number as `number` does, or what is not finite."""
    value = number(text)
    if value is None and "_" in text:
        raise ValueError(text)
    return float(text) if value is None else value


def _is_number(text: str) -> bool:
    try:
        parse_number(text)
    except ValueError:
        return False
    return True


def check_file(word: str) -> None:
    """Refuse a word that is no file, lesson or talk: a scene, or a misspelt command."""
    if os.path.lexists(file_of(word)) or not re.fullmatch(r"\w[\w-]*", word):
        return
    if os.path.exists(_SCENES / f"{word}.md"):
        raise CliError("{0} is a scene: write --set scene={0}.", word)
    if word in SUMMARIES:
        raise CliError("{0} is a command and must come first: {1} {0} ...", word, bootstrap.PROGRAM)
    near = difflib.get_close_matches(word.lower(), SUMMARIES, 1)
    known = said("commands are {0}", ", ".join(SUMMARIES))
    known = said("nearest command is {0}", near[0]) if near else known
    raise CliError("{0!r} is neither a file, a lesson nor a command; the {1}.", word, known)


def _size(value: str) -> tuple[int, int]:
    match = re.fullmatch(r"([0-9]{1,9})[xX×]([0-9]{1,9})", value)
    if match is None:
        raise CliError("--size = {0!r}: must be WIDTHxHEIGHT in pixels, such as 1800x600.", value)
    return int(match[1]), int(match[2])


def _parsed(
    option: str, bound: str, parse: Callable[[str], object] = parse_number
) -> Callable[[str], object]:
    """Return a function that parses an option's value and refuses what raises a `ValueError`."""

    def read(value: str) -> object:
        try:
            return parse(value)
        except ValueError:
            bounds = said(bound, ", ".join(PX_PER))
            raise CliError("{0} = {1!r}: must be {2}.", option, value, bounds) from None

    return read


def _whole(pattern: str, value: str) -> int:
    if not re.fullmatch(pattern, value):
        raise ValueError(value)
    return int(value)


def _width(value: str) -> float:
    match = re.fullmatch(r"([0-9]{1,6}(?:\.[0-9]{1,6})?)([a-z]{2})", value)
    pt = float(match[1]) * TEX_PT_PER.get(match[2], 0.0) if match else 0.0
    if not WIDTHS_PT[0] <= pt <= WIDTHS_PT[1]:
        least, most = map(round, WIDTHS_PT)
        raise CliError("width", value, ", ".join(TEX_PT_PER), least, most)
    return pt


def _sweep(value: str) -> tuple[str, str]:
    """Split ``near`` or ``near=1e-3:10`` into the parameter and its ends."""
    name, equals, ends = value.partition("=")
    one_of("--sweep", name, SWEEPS)
    if equals and not ends:
        raise CliError("--sweep {0} = '': must be LOW:HIGH, such as 0.001:10.", name)
    return name, ends


_COUNT, _DIGITS = partial(_whole, "[0-9]{1,9}"), partial(_whole, "[1-9]|1[0-7]")
_PAPER: dict[str, dict[str, Any]] = {  # of figures and charts
    "--size": {"type": _parsed("--size", "size", parse_size)},
    "--width": {"type": _parsed("--width", "a length in {0}, such as 84mm", parse_length)},
    "--text-size": {"type": _parsed("--text-size", "a number of points", parse_points)},
}
_ANGLE = _parsed("--orbit", "a number of degrees")
_DETAILS: dict[str, dict[str, dict[str, Any]]] = {
    "": {
        "--size": {"type": _size},
        "--version": {"action": "version", "version": f"Frustum Lab {__version__}"},
    },
    "export": {
        **_PAPER,
        "--scale": {"type": _parsed("--scale", "a finite number"), "default": 1.0},
        "--orbit": {"type": _ANGLE, "nargs": "?", "const": FULL_TURN},
        "--frames": {"type": _parsed("--frames", "a whole number", _COUNT)},
        "--fps": {"type": _parsed("--fps", "a finite number")},
        "--hidden": {"default": None}, "--format": {"default": None},  # seen to be given
    },
    "matrices": {
        "--digits": {"type": _parsed("--digits", "a whole number from 1 to 17", _DIGITS)},
        "--width": {"type": _width},
    },
    "measure": {
        **_PAPER, "--sweep": {"type": _sweep, "action": "append"}, "--cost": {"default": "time"},
    },
    "talk": {"--for": {"dest": "readers", "type": str}},
    "bundle": {"--python": {"action": "append", "default": []}},
}  # fmt: skip
"""How options are read that are not text, a choice or yes or no: arguments for argparse."""
_SCENES = Path(__file__).parents[1] / "scenes" / "phenomena" / "content"
_OF_A_DOCUMENT = ("", "export", "project", "matrices", "measure")  # commands with --set


def choose_language(arguments: Sequence[str]) -> None:
    """Speak the language of ``--language``, or of the system, before anything is said."""
    asked = ""
    for word, after in pairwise([*arguments, ""]):
        if word == "--":
            break
        name, equals, value = word.partition("=")
        if name == "--language":
            asked = value if equals else after
    languages.choose(asked if asked in languages.LANGUAGES else languages.of_system())


def check(arguments: Sequence[str]) -> None:
    """Refuse what is no command or option; print help or version, and raise `SystemExit`."""
    choose_language(arguments)
    if arguments and arguments[0] in SUMMARIES:
        Parser(arguments[0]).read(arguments[1:])
    else:
        if arguments:
            check_file(arguments[0])
        Parser("").read(arguments)
