"""Colours and sizes of the drawings: one colour per concept in all panes.

The hues are those of Okabe and Ito, which colour-blind readers can tell apart. On the light
background the pale ones are darkened until a line of them is visible (3:1). Text has its concept's
`tone`, with a contrast of at least 4.5:1; near and far never differ by colour alone.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

from app.model.parameter import read_sections

TITLE_EM = 1.5  # height of a pane's title, which lies on the picture, in ems
BLACK, WHITE = "#000000", "#ffffff"
QUIET = 0.6  # how much of the paper is mixed into the colour of a thing that is not named
QUIET_WIDTH = 0.5  # of the width of its lines


@dataclass(frozen=True)
class Style:
    """The colours, ``"#rrggbb"``, and the sizes, in device pixels."""

    background: str  # behind the scene, in every pane and in the picture
    margin: str  # around the picture in the image pane
    ink: str  # text and lines
    muted: str  # second-rank text and lines
    near: str
    far: str
    u: str  # the axes of the camera's frame; also x, y, z of the spaces after it
    v: str
    n: str
    eye: str
    target: str
    frustum: str
    accent: str  # highlights
    leader: str  # from a label to its mark: no concept's colour, or it would seem to be an axis
    shadow: str  # on the background or on a ground that is tinted with `muted`
    line_width: float = 2.0
    """Of ordinary lines; thin ones have half of it and thick ones one and a half. At a whole scale
    all are whole pixels: OpenGL would round others differently in each way of drawing."""
    font_size: float = 15.0  # height of an em
    one_size: bool = False  # of words and letters of formulas
    on_paper: bool = False
    """Whether faces that meet differ in lightness, and far is dashed: nothing by hue alone."""

    @property
    def tints(self) -> tuple[float, float]:
        """Opacities of the near and the far plane; on paper 15 apart in L* on white."""
        return (0.36, 0.08) if self.on_paper else (0.3, 0.16)

    def enlarged(self, factor: float) -> "Style":
        """Enlarge text and lines: for a projector's back row, or a finer screen."""
        return replace(self, line_width=self.line_width * factor, font_size=self.font_size * factor)

    def tone(self, colour: str) -> str:
        """The tone in which a concept's colour, or the ink, is written."""
        return BLACK if self.on_paper else tone(colour or self.ink, self.background)

    def text_on(self, colour: str) -> str:
        """Black or white, whichever has more contrast on a plate of that colour."""
        return max(BLACK, WHITE, key=lambda text: contrast(text, colour))


@cache
def rgb(colour: str) -> tuple[float, float, float]:
    """Red, green and blue in 0..1 of ``"#rrggbb"``, as VTK takes them."""
    red, green, blue = (int(colour[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    return red, green, blue


def hexadecimal(parts: Sequence[float]) -> str:
    """``"#rrggbb"`` of red, green and blue."""
    return "#" + "".join(f"{round(255.0 * min(1.0, max(0.0, part))):02x}" for part in parts)


def mixed(colour: str, other: str, part: float) -> str:
    """Return a colour with a part of another one mixed in, from 0 to 1."""
    pairs = zip(rgb(colour), rgb(other), strict=True)
    return hexadecimal([(1.0 - part) * a + part * b for a, b in pairs])


def contrast(one: str, other: str) -> float:
    """The contrast ratio of two colours, 1..21 (WCAG 2.2, relative luminance)."""
    lighter, darker = sorted((_luminance(one), _luminance(other)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


def _luminance(colour: str) -> float:
    linear = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in rgb(colour))
    return sum(weight * c for weight, c in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


_SECTIONS = read_sections(Path(__file__).with_name("content") / "palettes.md")
_COLOURS: dict[str, dict[str, Any]] = {name: each.named for name, each in _SECTIONS.items()}
LIGHT, DARK = Style(**_COLOURS["light"]), Style(**_COLOURS["dark"])
PRINT = replace(LIGHT, on_paper=True, **_COLOURS["print"])
CONTRAST = replace(PRINT, **_COLOURS["contrast"])
PALETTES = {"screen": LIGHT, "print": PRINT, "dark": DARK, "contrast": CONTRAST}
"""The colours of figures; text of `print` is black, and nothing of `contrast` is below 7:1."""

_TONES: dict[str, str] = {
    getattr(style, concept): tone
    for name, style in (("light", LIGHT), ("dark", DARK))
    for concept, tone in _COLOURS[f"tones of {name}"].items()
}


@cache
def tone(colour: str, background: str) -> str:
    """Return the tone in which a colour is written: at least 4.5:1 on the background."""
    if contrast(_TONES.get(colour, background), background) >= 4.5:
        return _TONES[colour]
    end = max(BLACK, WHITE, key=lambda limit: contrast(limit, background))
    part = next(
        i / 20.0 for i in range(21) if contrast(mixed(colour, end, i / 20.0), background) >= 4.5
    )
    return mixed(colour, end, part)
