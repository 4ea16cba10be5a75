"""Read a matrix from the text that a program, a debugger or a person writes.

NumPy, JSON, MATLAB, LaTeX, C, GLSL, glm, Eigen and Unity write the same numbers between different
brackets, separators, labels and names. A text is read only if every part of it is understood: a
function such as ``cos(0.3)`` is refused, not taken for 0.3. The time is linear in the text.
"""

import math
import re
from collections.abc import Sequence

from app.model.refusal import REFUSALS, Refusal, shown_name

SIZES = (9, 12, 16)  # how many numbers a matrix may have: 3x3, 3x4 or 4x3, and 4x4

LONGEST = 20_000  # most characters of a text that may be a matrix


def read_matrix(
    text: str, field: str = "matrix", sizes: Sequence[int] = SIZES
) -> list[list[float]]:
    """Return 16, 12 or 9 numbers in rows for column vectors: (3, 3), (3, 4), (4, 3) or (4, 4).

    Notations that have columns first, such as those of glm and GLSL, are known. Raises a `Refusal`
    with the `field`'s name, for a count of numbers that is not one of `sizes`, for what is not
    finite, and for what is not understood.
    """
    try:
        if len(text) > LONGEST:
            raise _refused(REFUSALS["long"], LONGEST)
        lines = _lines(_without_dashes(text))
        if sum(map(len, lines)) not in sizes or _has_named_columns(text, lines):
            lines = _without_index(lines)
        count, with_commas = sum(map(len, lines)), _with_decimal_commas(text)
        if with_commas is not None:
            others = _lines(with_commas)
            other = sum(map(len, others))
            if other in sizes:
                if count in sizes and others != lines:
                    raise _refused(REFUSALS["commas"], other, count)
                lines, count = others, other
        if count not in sizes and len(sizes) > 1:
            raise _refused(REFUSALS["count"], count)
        if count not in sizes:
            raise _refused(REFUSALS["count-of"], *sizes, count)
    except Refusal as error:
        raise Refusal.in_document(error.bound, *error.limits, field=field, value=text) from None
    is_narrow = {len(line) for line in lines} == {3} or re.search(r"(?i)[a-z]4x3|\[4\]\[3\]", text)
    width = 3 if count == 9 or (count == 12 and is_narrow) else 4
    flat = [number for line in lines for number in line]
    rows = [flat[i : i + width] for i in range(0, count, width)]
    return list(map(list, zip(*rows, strict=True))) if is_by_columns(text) else rows


def _refused(bound: object, *limits: object) -> Refusal:
    return Refusal("", ..., bound, *limits)  # type: ignore[arg-type]


# --------------------------------------------------------------------------- what is left away

is_by_columns = re.compile(
    r"(?i)\b[df]?mat\d(?:x\d)?[fh]?(?:<[a-z0-9]{1,4}>)?(?:\.[a-z]{3,10}|\s\w{1,40}\s?=?)?\s?[({]"
    r"|\b(?:matrix3d|DOMMatrix|make(?:_mat[34]|Basis)|from(?:Array|_?col\w{0,20}|_vec)|setColumn"
    r"|ArrayStorage|simd_matrix)\s?\(|\b(?:simd|matrix)_[a-z]{4,6}[34]x[34]\s?\((?!rows)"
    r"|\bcolumns(?:\s?:\s?\(|\.[0-3])|\(\[?SIMD[34]|\[[0-3]\] ?= ?(?:\w{1,20}::)?[df]?vec[34]\("
    r"|\bnew\b[^(]{0,40}\(\s{0,40}new\b[^(]{0,20}(?:Vector|float)[34]|\bcolumn[- ]major\b"
    r"|\belements[\"']?\s?[=:]\s?\w{0,20}(?:\(\d{1,2}\))?\s?[\[{(]|\bx_axis\b"
    r"|\b(?:Basis|Projection|Transform3D)\(\s{0,40}Vector|Base<Eigen::Matrix<\w+, ?\d, ?\d, ?0\b"
).search
"""Whether GLSL, WGSL, glm, glMatrix, CSS, three.js, Rust, Metal, Unity, Godot or gdb wrote it."""

_CHARACTERS = str.maketrans(
    {
        **dict.fromkeys("\u2212\u2013\u2010\u2011\ufe63\uff0d", "-"),
        **dict.fromkeys("\ufeff\u200b\u00a0\u2007\u2009\u202f\t\r\f\v~`⎡⎢⎣⎤⎥⎦⎛⎜⎝⎞⎟⎠│┃┌┐└┘", " "),
        **dict.fromkeys("\u2028\u2029\x85", "\n"),
    }
)
_RAISED = str.maketrans("⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "+-0123456789")

# Every repetition is bounded where it could be tried from many places.
_LEFT_AWAY = re.compile(
    r"(?://|(?<!\.)#|%)[^\n]*"  # comments
    r"|\\(?:begin|end) ?\{[a-zA-Z]{1,12}\*?\}(?:\[[clr]\])?(?:\{[clr| ]{1,12}\})?"
    r"|\\phantom ?\{[^{}\n]{0,20}\}|\\[,;:!> \[\]()]|\[[0-9.]{1,8} ?[a-z]{2}\]"
    r"|\\(?:left|right|[bB]igg?[lr]?|text|math(?:rm|bf|sf)|boldsymbol|q?quad|hline|displaystyle"
    r"|leftarrow|rightarrow|to|ldots)(?![a-zA-Z])"
    r"|\b(?:shape|size|rows|cols) ?[=:] ?(?:[(\[{][0-9, x]{0,20}[)\]}]|[0-9]{1,3})"
    r"|\b[0-9]{1,2} ?[x×] ?[0-9]{1,2}\b(?! ?[.,0-9])"  # 4x4
    r"|\((?:16|12|9)\) ?(?=\[)|\([34][,.] ?[34]\) ?(?==)"  # sizes of arrays: JavaScript, OpenCV
    # Headings of R and lldb, and MATLAB's continued line:
    r"|\[[0-9]{1,2}, ?\]|\[ ?,[0-9]{1,2}\]|(?<![\w\]])\[[0-9]{1,2}\] ?=|\.\.\.+"
    r"|\[[34]\]\[[34]\]|\[\[f(?:32|64); ?[0-9]\]; ?[0-9]\]|[<>]|---"  # types of C and Rust
    r"|(?m:^ {0,12}- (?=\[))|\bnew\b"  # the lists of YAML, and Java
)
_TEMPLATE = re.compile(r"<[^<>\n]{0,120}>")
_FRACTION = re.compile(r"\\[dt]?frac ?\{([^{}\n]{1,40})\} ?\{([^{}\n]{1,40})\}")
_POWER = re.compile(r" {0,2}(?:\\cdot|\\times|[·×*]) {0,2}10 ?\^ ?\{?([+-]?[0-9]{1,4})\}?")
_UNSIGNED = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:(?:[eEdD]|\*\^)[+-]?[0-9]+)?"
_TOKEN = re.compile(
    rf"(?P<not_finite>[+-]?1\.\#[A-Z]+|[+-]?\b(?:nan|inf|infinity)\b(?:\([a-z]+\))?|[+-]?∞)"
    r"|(?P<word>\"[^\"\n]{0,80}\"|'[^'\n]{0,80}'|@?0x[0-9a-fA-F]+|[!&*]{0,3}[^\W\d]"
    r"[\w$.-]*(?:::[\w$]+)*(?:\[[0-9]{1,2}\])*|\$[0-9]+)"
    rf"|(?P<number>[+-]?{_UNSIGNED}(?:_?f(?:16|32|64)|[fFlLhHdD])?(?: ?/ ?{_UNSIGNED})?)"
    r"|(?P<ends>\\cr|[\n;])"
    r"|(?P<open>[(\[{])|(?P<close>[)\]}])|(?P<blank> +)|(?P<between>[,&|])|(?P<names>[=:])"
    r"|(?P<sign>[+-])|(?P<times>\*)|(?P<other>\.\w*|.)",
    re.IGNORECASE,
)
_FUNCTION = re.compile(
    r"(?i)(?:^|\W|XMMatrix)(?:p?inv|inver\w{1,20}|transpose|(?:h|column_?)stack|c_|dot)$"
)
_NAMES = re.compile(r"[^\W\d]\w*").fullmatch
_ITEM = re.compile(r"- (- )?(\S+)")
_QUOTED = re.compile(rf".[+-]?{_UNSIGNED}.")
_NUMBER_TYPE = re.compile(r"float|double|half|single|real|scalar|mpf|int|f(?:16|32|64)$", re.I)
_COLUMNS = re.compile(r"\bColumns? {1,4}[0-9]{1,2}(?: {1,4}(?:through|and|to) {1,4}[0-9]{1,2})?:?")
_DECIMAL_COMMA = re.compile(r"(?<=[0-9]),(?=[0-9])")


def _with_decimal_commas(text: str) -> str | None:
    """Return the text with points for decimal commas, or None if its commas cannot be decimal."""
    if "." in text or re.search(r",[0-9]+,", text) or not _DECIMAL_COMMA.search(text):
        return None
    return _DECIMAL_COMMA.sub(".", text)


def _lines(text: str) -> list[list[float]]:
    """Return the numbers of each line or inner bracket."""
    text = text.translate(_CHARACTERS)
    head, *rest = text.split("/*")
    text = head + " ".join(part.partition("*/")[2] for part in rest)
    text = re.sub("[⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda raised: "^" + raised[0].translate(_RAISED), text)
    text = text.replace(r"\\", "\n").replace("<<", "=")  # LaTeX's rows, and Eigen's comma
    text = _POWER.sub(r"e\1", _FRACTION.sub(r"\1/\2", text))
    for _ in range(3):  # templates may be nested
        text = _TEMPLATE.sub(" ", text)
    blocks = [_MatrixTextReader().read(_LEFT_AWAY.sub(" ", part)) for part in _COLUMNS.split(text)]
    blocks = [lines for lines in blocks if lines]
    if len(blocks) < 2:
        return blocks[0] if blocks else []
    # MATLAB shows wide matrices some columns at a time.
    return [[number for line in lines for number in line] for lines in zip(*blocks, strict=False)]


def _without_dashes(text: str) -> str:
    """Return YAML's list of single numbers as rows, and any other text unchanged."""
    rows = list(filter(None, map(str.strip, text.splitlines())))
    items = [_ITEM.fullmatch(row) for row in rows if ":" not in row]
    if len(items) < min(SIZES) or not all(items):
        return text
    return " ".join("\n" * len(item[1] or "") + item[2] for item in items if item)


def _has_named_columns(text: str, lines: list[list[float]]) -> bool:
    """Whether the first line has a name for all but one of the numbers below it, as in pandas."""
    names = text.strip().partition("\n")[0].split()
    return bool(lines and names) and len(names) == len(lines[0]) - 1 and all(map(_NAMES, names))


def _without_index(lines: list[list[float]]) -> list[list[float]]:
    """Return the lines without the numbers of rows and columns that pandas prints."""
    rows = lines[lines[:1] == [list(range(len(lines[0])))] :] if lines else []
    is_numbered = [row[0] for row in rows] == list(range(len(rows)))
    return [row[1:] for row in rows] if is_numbered else lines


# --------------------------------------------------------------------------- what is read


class _MatrixTextReader:
    """Reads the tokens of a text; what it does not understand is refused."""

    def __init__(self) -> None:
        self.lines: list[list[float]] = [[]]
        self.count = 0
        self.places: list[str] = []  # the indices in the labels of numbers: ``00`` of ``m00 = 1``
        self.open: list[tuple[str, int]] = []
        """The name before each open bracket, and how many numbers were read before it."""

    def read(self, text: str) -> list[list[float]]:
        """Return the numbers of each line or inner bracket."""
        scale, sign, word, label, is_value = 1.0, "", "", "", False
        before = last = previous = ""
        for match in _TOKEN.finditer(text):
            kind, token = match.lastgroup or "", match[0]
            if kind == "word" and token[0] in "\"'" and _QUOTED.fullmatch(token):
                kind, token = "number", token[1:-1]
            if kind == "not_finite":
                raise _refused(REFUSALS["matrix-text-not-finite"], token)
            if sign and kind not in ("number", "blank"):
                raise _not_read(sign)
            if word and kind not in ("names", "open", "blank"):
                self._check_word(word, kind, is_value)
                word = ""
            if kind == "number":
                if before in ("number", "word", "other"):
                    raise _not_read(previous + token)
                self._add(sign + token, label)
                sign = label = ""
            elif kind == "word":
                if before in ("number", "word"):
                    raise _not_read(token)
                word, is_value = token, last == "names"
            elif kind == "names":
                label, word = word, ""
            elif kind == "open":
                if before == "word" and _FUNCTION.search(word):
                    raise _not_read(f"{word}(...)")
                self.open.append((word, self.count))
                word = ""
            elif kind == "close":
                self._close()
            elif kind == "ends":
                self.lines.append([])
            elif kind == "sign":
                if last == "number":
                    raise _not_read(token)
                sign = token
            elif kind == "times":  # MATLAB's common factor stands before all numbers
                if self.count != 1 or scale != 1.0:
                    raise _not_read(token)
                scale, self.count, self.lines, self.places = self.lines[-1][0], 0, [[]], []
            elif kind == "other" and self.count:
                raise _not_read(token)
            if kind != "blank":
                last = kind
            before, previous = kind, token
        if sign:
            raise _not_read(sign)
        if word:
            self._check_word(word, "", is_value)
        return [[scale * number for number in line] for line in self._placed() if line]

    def _check_word(self, word: str, following: str, is_value: bool) -> None:
        """Refuse a word that is no title, no type, and no value of a name: ``dtype=float32``."""
        is_title = not self.count and following != "number"
        if not (is_title or is_value or _NUMBER_TYPE.search(word)):
            raise _not_read(word)

    def _add(self, text: str, label: str) -> None:
        above, _, below = re.sub(r"_?f(?:16|32|64)|[fFlLhH ]|[dD]$", "", text).partition("/")
        above, below = (re.sub(r"[dD]|\*\^", "e", part) for part in (above, below or "1"))
        try:
            number = float(above) / float(below)
        except ZeroDivisionError:
            raise _not_read(text) from None
        if not math.isfinite(number):
            raise _refused(REFUSALS["matrix-text-not-finite"], text[:40])
        self.lines[-1].append(number)
        self.count += 1
        self.places.append("".join(re.findall("[0-9]", label[-8:])))

    def _close(self) -> None:
        name, count = self.open.pop() if self.open else ("", 0)
        if name and self.count - count == 1 and not _NUMBER_TYPE.search(name):
            raise _not_read(f"{name}(...)")
        self.lines.append([])

    def _placed(self) -> Sequence[Sequence[float]]:
        """Return the lines; numbers whose labels all have two indices go where these say."""
        places = set(self.places)
        if len(places) < self.count or not all(len(place) == 2 for place in places):
            return self.lines
        numbers = (number for line in self.lines for number in line)
        return [[number for _, number in sorted(zip(self.places, numbers, strict=True))]]


def _not_read(word: str) -> Refusal:
    return _refused(REFUSALS["not-read"], shown_name(word[:40]))
