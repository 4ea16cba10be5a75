"""The commands, their options, and the messages for wrong ones.

This module needs only the standard library: help and the refusal of misspelt options work before
the set-up.
"""

from __future__ import annotations

import argparse
import difflib
import os
import re
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NoReturn

from app import __version__, bootstrap
from app.commands.terminal import CliError, write_out
from app.document.lengths import PX_PER, parse_size
from app.model.numerals import number
from app.model.refusal import counted, nearest

SUMMARIES = {  # the commands and their summaries
    "export": "draw a figure as PNG, SVG, PDF, TikZ or HTML, without a window or display",
    "project": "follow points through every stage of the projection",
    "matrices": "print every stage's matrix",
    "measure": "measure, on this machine, what speed costs in accuracy",
    "lesson": "check or list lessons and talks, print tests of exercises, mark results",
    "talk": "draw every step of a talk, or print it with its notes",
    "bundle": "make a folder to carry to machines without a network or an administrator",
    "doctor": "report what this machine has, what is missing and how to get it",
}

THEMES = ("light", "dark")
HIDDEN = ("none", "dashed", "grey")
FITS = ("named", "frustum", "scene")
PALETTES = ("screen", "print", "dark", "contrast")
CANVASES = ("opengl", "raster")
PRECISIONS = ("float32", "float64", "exact")
SPACES = ("world", "object")
CONVENTIONS = ("opengl", "direct3d", "vulkan", "unity", "opencv")
MATRIX_FORMATS = ("text", "json", "latex")
LETTERS = ("own", "000", "001", "002", "003", "004")
WHEEL_PLATFORMS = ("linux-x86_64", "linux-arm64", "macos-x86_64", "macos-arm64", "windows-x86_64")
FULL_TURN = 360.0  # of an orbit, in degrees
TEX_PT_PER = {"mm": 72.27 / 25.4, "cm": 72.27 / 2.54, "in": 72.27, "pt": 1.0}
WIDTHS_PT = 200.0, 1500.0  # of a text or a column, for LaTeX; 72.27 of its points are an inch
LOOPS = ("repeat", "once", "back-and-forth")
FIGURE_FORMATS = ("png", "svg", "pdf", "tex")
PROJECT_FORMATS = ("table", "csv", "json")
TRADES = (
    "arithmetic", "interpolation", "depth", "smoothing", "detail", "drift", "vertex-depth",
    "cracks", "jitter", "unprojection",
)  # fmt: skip
COSTS = ("time", "bytes")
SWEEPS = ("near", "far", "fov", "distance", "up", "aspect", "gap")
SETTABLE = (
    "scene", "mesh", "depth", "camera.eye", "camera.target", "camera.up", "lens.kind",
    "lens.fov_y_deg", "lens.near", "lens.far", "lens.left", "lens.right", "lens.bottom",
    "lens.top", "lens.keep", "lens.alpha_deg", "lens.beta_deg", "lens.clip_from_view",
    "lens.view_from_world", "lens.fov_x_deg", "lens.focal_length_mm", "lens.K", "lens.fx",
    "lens.fy", "lens.cx", "lens.cy", "lens.focal_mm", "lens.sensor_width_mm",
    "lens.sensor_height_mm", "camera.P", "object.chain", "object.translate", "object.rotate_deg",
    "object.scale", "object.order", "image.width", "image.height", "quality.rung",
    "quality.smoothing", "quality.detail", "quality.depth_format", "quality.depth_mapping",
    "view.layout", "view.large", "view.stage", "view.frame_step", "view.panel", "view.letters",
    "view.layers", "view.fixed", "view.names", "view.slide", "view.controls", "view.equation",
    "view.probes", "view.compare", "view.dividers",
)  # fmt: skip
"""Every path that ``--set`` knows, for all lenses; each scene adds its own ``settings.NAME``.

These lists repeat names from modules with dependencies; a test compares them.
"""


# --------------------------------------------------------------------------- options


class Parser(argparse.ArgumentParser):
    """An argument parser that refuses in sentences and names the nearest option."""

    def __init__(self, command: str, names: str, text: str, epilog: str = "") -> None:
        usage = " ".join(f"{bootstrap.PROGRAM} {command} [options] {names}".split())
        super().__init__(
            usage=usage,
            description=SUMMARIES.get(command, "How a camera turns a 3-D scene into a picture."),
            epilog=epilog,
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
        )
        self._command, self._names = command, names
        self.add_argument("words", nargs="*", metavar=names, help=text)

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
            where, near = self._command or "the window", nearest(option.lower(), names)
            raise CliError(f"{option} is not an option of {where}; the nearest is {near}.")
        words: list[str] = [*options.words, *arguments[end + 1 :]]
        command = self._command or "The window"
        if "" in words:
            raise CliError(f"{command} was given an empty name.")
        most = len(self._names.split())
        if self._names.endswith("...]"):
            most = max(most, len(words))
        if not len(self._names.split()) - self._names.count("[") <= len(words) <= most:
            takes = self._names or "no names"
            raise CliError(f"{command} takes {takes}, and was given {counted(len(words), 'name')}.")
        return options, words

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

    def add_set(self) -> None:
        self.add(
            "--set", "NAME=VALUE",
            "change a value of the document, such as lens.far=inf; may be repeated; "
            f"the names are {', '.join(SETTABLE)} and settings.NAME for a setting of the scene",
            action="append", default=[],
        )  # fmt: skip

    def add(
        self, option: str, value: str, text: str, read: Callable[[str], object] = str, **more: Any
    ) -> None:
        """Add an option that takes a value; `read` parses it, and `more` is for argparse."""
        self.add_argument(option, metavar=value, help=text, type=read, **more)

    def add_flag(self, option: str, text: str) -> None:
        self.add_argument(option, action="store_true", help=text)

    def add_choice(
        self, option: str, values: Sequence[str], text: str, default: str | None = None, **more: Any
    ) -> None:
        self.add(
            option, "|".join(values), text, lambda value: one_of(option, value, values),
            default=default, **more,
        )  # fmt: skip


def one_of(option: str, value: str, values: Sequence[str]) -> str:
    """Return an option's value, which must be one of several."""
    # argparse does not catch a CliError, and so does not rephrase it.
    if value not in values:
        raise CliError(f"{option} = {value!r}: must be one of {', '.join(values)}.")
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
    """Refuse a word that is not a file as a misspelt command, naming the nearest one."""
    if os.path.lexists(word) or not re.fullmatch(r"\w[\w-]*", word):
        return
    if word in SUMMARIES:
        raise CliError(f"{word} is a command and must come first: {bootstrap.PROGRAM} {word} ...")
    near = difflib.get_close_matches(word.lower(), SUMMARIES, 1)
    known = f"nearest command is {near[0]}" if near else f"commands are {', '.join(SUMMARIES)}"
    raise CliError(f"{word!r} is neither a file nor a command; the {known}.")


def _size(value: str) -> tuple[int, int]:
    match = re.fullmatch(r"([0-9]{1,9})[xX×]([0-9]{1,9})", value)
    if match is None:
        raise CliError(f"--size = {value!r}: must be WIDTHxHEIGHT in pixels, such as 1800x600.")
    return int(match[1]), int(match[2])


def _parsed(
    option: str, bound: str, parse: Callable[[str], object] = parse_number
) -> Callable[[str], object]:
    """Return a function that parses an option's value and refuses what raises a `ValueError`."""

    def read(value: str) -> object:
        try:
            return parse(value)
        except ValueError:
            raise CliError(f"{option} = {value!r}: must be {bound}.") from None

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
        raise CliError(
            f"--width = {value!r}: must be a length in {', '.join(TEX_PT_PER)} from {least}pt to "
            f"{most}pt, such as 84mm."
        )
    return pt


def _sweep(value: str) -> tuple[str, str]:
    """Split ``near`` or ``near=1e-3:10`` into the parameter and its ends."""
    name, equals, ends = value.partition("=")
    one_of("--sweep", name, SWEEPS)
    if equals and not ends:
        raise CliError(f"--sweep {name} = '': must be LOW:HIGH, such as 0.001:10.")
    return name, ends


# --------------------------------------------------------------------------- the commands


def _window() -> Parser:
    lines = "\n".join(f"  {name:<10}{text}" for name, text in SUMMARIES.items())
    parser = Parser(
        "",
        "[FILE]",
        "a document, an exported PNG picture, a mesh, a camera, a lesson or a talk (default: the "
        "letter F)",
        f"commands, each with its own --help:\n{lines}",
    )
    parser.add_set()
    parser.add_choice("--theme", THEMES, "colours, for this start only")
    text = "how panes draw (default: opengl with a graphics card, raster without)"
    parser.add_choice("--canvas", CANVASES, text)
    parser.add_flag("--reset", "delete the settings, then open the window")
    parser.add("--screenshot", "OUT", "save a picture of the window as PNG and quit")
    parser.add("--size", "WIDTHxHEIGHT", "size of the window", read=_size)
    parser.add_argument("--version", action="version", version=f"Frustum Lab {__version__}")
    return parser


def _export() -> Parser:
    text = (
        "the figure to write (.png; .svg, .pdf or TikZ's .tex for shapes and text; .html for a "
        "page that phones show), and the document, picture, mesh, camera, lesson or talk to draw "
        "(default: the letter F); with --batch, the folder of the figures; with --sweep, --orbit, "
        "--stages or --transition, a film (.gif, .apng, .webp, or .mp4 with ffmpeg), a page with a "
        "slider (.html), or a name with %%03d for a figure of each frame"
    )
    parser = Parser("export", "OUT [FILE]", text)
    parser.add(
        "--panes", "world,ndc,image",
        "the panes to draw, side by side, or below each other with / instead of commas "
        "(default: all, side by side; of a step, those of its slide); or equation, alone: that of "
        "view.equation, which is the default where --set asks for one",
    )  # fmt: skip
    parser.add(
        "--size", "WIDTHxHEIGHT",
        "size on paper, such as 120mmx80mm, in mm, cm or in; or in pixels at scale 1, 300 an "
        "inch (default: 640x640 for each pane, or its own size for the image alone); in .html, of "
        "each pane",
        read=_parsed(
            "--size", f"WIDTHxHEIGHT in {', '.join(PX_PER)}, such as 120mmx80mm or 1800x600",
            parse_size,
        ),
    )  # fmt: skip
    parser.add(
        "--width", "LENGTH",
        "instead of --size: how wide it is after it was cropped without a margin, such as 84mm; "
        "its height is free, and letters keep their size",
        read=_parsed(
            "--width", f"a length in {', '.join(PX_PER)}, such as 84mm",
            lambda text: parse_size(f"{text}x{text}").px[0],
        ),
    )  # fmt: skip
    parser.add_choice(
        "--fit", FITS, "what the world pane frames: what is named, with the whole frustum too, or "
        "the objects alone (default: named)", "named",
    )  # fmt: skip
    parser.add_flag("--crop", "leave out what is empty around the figure, but for a margin of 2 mm")
    parser.add(
        "--scale", "FACTOR", "draw the same figure with more pixels (default: 1)",
        read=_parsed("--scale", "a finite number"), default=1.0,
    )  # fmt: skip
    parser.add(
        "--text-size", "PT",
        "size of the words in points; 72 points are 300 pixels at scale 1 (default: 7 "
        "in a pane of 640 pixels, in proportion in others)",
        read=_parsed(
            "--text-size", "a number of points", lambda text: parse_number(text.removesuffix("pt"))
        ),
    )  # fmt: skip
    parser.add_choice(
        "--hidden", HIDDEN, "in all but .png, lines behind faces: left out, dashed as in "
        "ISO 128, or thin and grey (default: none)",
    )  # fmt: skip
    parser.add_flag("--transparent", "leave the background transparent")
    parser.add_choice(
        "--palette", PALETTES, "colours: as on a light or dark screen; for print, where faces and "
        "lines differ in grey, too; or with the most contrast (default: screen)", "screen",
    )  # fmt: skip
    parser.add(
        "--batch", "LIST",
        "draw many figures: a CSV file with a line for each, whose columns are out, file, the "
        "options without their dashes, and names of --set; each document, and each step of the "
        "lessons and talks, of a folder; or each step of one lesson",
    )  # fmt: skip
    parser.add_flag(
        "--resume", "of --batch: leave out figures that are newer than the list and their document",
    )  # fmt: skip
    text = "of --batch with a folder or a lesson: what to write (default: png)"
    parser.add_choice("--format", FIGURE_FORMATS, text)
    parser.add(
        "--sweep", "NAME=FIRST:LAST",
        "draw a moving picture: a value of --set changes from FIRST to LAST",
    )  # fmt: skip
    parser.add(
        "--orbit", "DEGREES",
        "draw a moving picture: the world is seen from all round, or as far round as DEGREES "
        "say, and back; the camera stays where it is",
        read=_parsed("--orbit", "a number of degrees"), nargs="?", const=FULL_TURN,
    )  # fmt: skip
    parser.add_flag(
        "--stages",
        "draw a moving picture: the ndc pane goes from the world through all stages to the "
        "image, and back",
    )  # fmt: skip
    parser.add(
        "--step", "STEP",
        "the step of a lesson or a talk to draw, its number or its name (default: the first)",
    )  # fmt: skip
    parser.add_flag(
        "--transition", "draw a moving picture: how --step follows from the step before",
    )  # fmt: skip
    parser.add(
        "--frames", "COUNT",
        "of a moving picture: how many frames (default: 48; of --stages 120, of --transition "
        "24; in .html 21)",
        read=_parsed("--frames", "a whole number", partial(_whole, "[0-9]{1,9}")),
    )  # fmt: skip
    parser.add(
        "--fps", "COUNT", "of a moving picture: how many frames a second (default: 12)",
        read=_parsed("--fps", "a finite number"),
    )  # fmt: skip
    parser.add_choice(
        "--loop", LOOPS, "of a moving picture: from the last frame to the first, not at all, or "
        "there and back in all frames together (default: repeat for --sweep and all round, once "
        "for --transition and numbered files, else back-and-forth)",
    )  # fmt: skip
    parser.add_set()
    return parser


def _project() -> Parser:
    text = (
        "a document, picture, mesh or camera file whose camera is used (default: the letter F), "
        "and the points: CSV with the columns x,y,z, or - for standard input; a fourth column, w, "
        "may be 0 for a point at infinity; any other w divides x, y and z"
    )
    parser = Parser("project", "[FILE] POINTS", text)
    parser.add_choice("--format", PROJECT_FORMATS, "output format (default: table)", "table")
    parser.add_choice(
        "--rung", PRECISIONS, "arithmetic (default: float64, or exact where that is needed)"
    )
    parser.add_choice("--space", SPACES, "space of the coordinates (default: world)", "world")
    parser.add_set()
    return parser


def _matrices() -> Parser:
    text = "a document, picture, mesh or camera file whose camera is used (default: the letter F)"
    parser = Parser("matrices", "[FILE]", text)
    parser.add_choice("--format", MATRIX_FORMATS, "output format (default: text)", "text")
    parser.add_choice("--convention", CONVENTIONS, "camera and lens as another program writes them")
    parser.add_choice(
        "--vectors", ("columns", "rows"), "after --convention (default: those of that program)"
    )
    parser.add_flag("--planes", "the six planes of the view volume in world space")
    parser.add_flag(
        "--chain", "every factor from the object to the picture, and the products so far"
    )
    parser.add(
        "--digits", "COUNT",
        "in LaTeX: significant digits of numbers, up to 17, which are all (default: 4)",
        read=_parsed("--digits", "a whole number from 1 to 17", partial(_whole, "[1-9]|1[0-7]")),
    )  # fmt: skip
    parser.add_choice(
        "--letters", LETTERS, "in LaTeX: the letters of a lecture (default: the document's)"
    )
    parser.add_flag("--symbols", "in LaTeX: formulas in the cells instead of numbers")
    parser.add_flag("--numbers", "in LaTeX: numbers, also after --symbols")
    parser.add(
        "--width", "LENGTH",
        "in LaTeX: the width of the text or the column, such as 84mm, in mm, cm, in or pt "
        "(default: 345pt, the text of an article)",
        read=_width,
    )  # fmt: skip
    parser.add_set()
    return parser


def _measure() -> Parser:
    text = "a document, picture or mesh to measure (default: the letter F)"
    parser = Parser("measure", "[FILE]", text)
    parser.add_choice(
        "--trade", TRADES,
        "measure this trade; may be repeated (default, without --sweep: all)", action="append",
    )  # fmt: skip
    parser.add(
        "--sweep", "NAME[=LOW:HIGH]",
        f"measure the errors over a parameter's range; NAME is one of {', '.join(SWEEPS)}",
        read=_sweep, action="append",
    )  # fmt: skip
    parser.add_choice(
        "--cost", COSTS,
        "draw errors over time, or over bytes, which are the same on every machine", "time",
    )  # fmt: skip
    parser.add("--scene", "NAME", "the same as --set scene=NAME")
    parser.add_flag("--quick", "measure for half a minute only, less exactly")
    parser.add("--json", "FILE", "write all results; FILE is overwritten, - is standard output")
    parser.add("--csv", "FILE", "write the tables, one after the other; FILE as for --json")
    parser.add(
        "--chart", "FILE",
        "draw all results; FILE as for --json, ending in .png, or in .pdf for vectors",
    )  # fmt: skip
    parser.add_flag(
        "--attended",
        "report the fraction done, one per line, and take the commands pause, resume and"
        " cancel from standard input",
    )  # fmt: skip
    parser.add_set()
    return parser


def _lesson() -> Parser:
    text = (
        "check: try every state, answer key and sample of lessons and talks, and measure their "
        "pictures (default: those that come with the program); list: list them; names: "
        "print every name that their files may use; print: print tests, see below; results: mark "
        "files of results again from what was typed, count the wrong ideas, and list what no idea "
        "explains. FILE may also be a name such as L5 or 001"
    )
    parser = Parser("lesson", "check|list|names|print|results [FILE...]", text)
    parser.add(
        "--topics", "L3,L5,...",
        "of print: the topics, or files of lessons, whose exercises make the test",
    )  # fmt: skip
    parser.add(
        "--seeds", "FIRST:LAST",
        "of print: the variants, one file for each; a variant has the same numbers everywhere",
    )  # fmt: skip
    parser.add(
        "--out", "FOLDER", "of print: where the PDF files go; existing files are overwritten",
    )  # fmt: skip
    parser.add_flag(
        "--key", "of print: write one more file, with the answers of all variants and their ways",
    )  # fmt: skip
    parser.add(
        "--csv", "FILE",
        "of results: write a table, a row for each answer; an existing file is overwritten",
    )  # fmt: skip
    return parser


def _talk() -> Parser:
    parser = Parser(
        "talk",
        "FILE",
        "a talk or a lesson, or the name of one that comes with the program, such as 001 or L5",
    )
    parser.add_flag(
        "--check",
        "draw every step without a display, run lesson check, measure the pictures, and "
        "report each mistake with file and line",
    )  # fmt: skip
    parser.add(
        "--handout", "OUT",
        "write the figures, text and notes of every step on A4 pages (.pdf) or as a page that "
        "phones show (.html); an existing file is overwritten",
    )  # fmt: skip
    parser.add(
        "--for", "teacher|students",
        "of the handout: teacher has answers and notes, students room to write instead",
        dest="readers",
    )  # fmt: skip
    return parser


def _bundle() -> Parser:
    text = (
        "where to put the folder frustum-lab, with the program and all that it needs, for machines "
        "like this one without Python; and an archive of it"
    )
    parser = Parser("bundle", "OUT", text)
    parser.add_flag("--wheels", "instead: the code and its packages, for machines with Python")
    parser.add_choice(
        "--platform", WHEEL_PLATFORMS, "of --wheels; may be repeated (default: all of them)",
        action="append",
    )  # fmt: skip
    parser.add(
        "--python", "VERSION", "of --wheels, such as 3.12; may be repeated (default: this one's)",
        action="append", default=[],
    )  # fmt: skip
    return parser


_PARSERS: dict[str, Callable[[], Parser]] = {
    "": _window,
    "export": _export,
    "project": _project,
    "matrices": _matrices,
    "measure": _measure,
    "lesson": _lesson,
    "talk": _talk,
    "bundle": _bundle,
    "doctor": partial(Parser, "doctor", "", argparse.SUPPRESS),
}


def parser_of(command: str) -> Parser:
    """Return the parser of a command; an empty name means the window."""
    return _PARSERS[command]()


def answer(arguments: Sequence[str]) -> None:
    """Print the help or the version and raise `SystemExit`, if requested; otherwise return."""
    end = arguments.index("--") if "--" in arguments else len(arguments)
    if {"-h", "--help", "--version"}.isdisjoint(arguments[:end]):
        return
    check(arguments)


def check(arguments: Sequence[str]) -> None:
    """Refuse a command line that has no such command or options."""
    if arguments and arguments[0] in SUMMARIES:
        parser_of(arguments[0]).read(arguments[1:])
    else:
        if arguments:
            check_file(arguments[0])
        parser_of("").read(arguments)
