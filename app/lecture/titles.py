"""What stages and factors are called in words, translated: the page ``content/titles.md``."""

from pathlib import Path

from app.languages import translate
from app.model.chain import KINDS
from app.model.parameter import read_sections

_PAGE = read_sections(Path(__file__).with_name("content") / "titles.md")
SPACES, FACTORS = _PAGE["Space"].named, _PAGE["Factor"].named


def stage_title(name: str) -> str:
    """Return ``clip_from_view`` as “clip ← view”, and a factor by its name."""
    target, between, source = name.partition("_from_")
    if between:
        return " ← ".join(translate(SPACES[space], "Space") for space in (target, source))
    factor = name.rstrip("0123456789")
    number = f" {name[len(factor) :]}" if factor != name else ""
    if factor not in FACTORS:  # shear_xy, mirror_x
        factor, _, letters = factor.partition("_")
        number = f" {letters}{number}"
    return translate(FACTORS[factor], "Factor") + number if factor in FACTORS else name


def tile_title(kind: str, numbers: str) -> str:
    """Return a tile in words: ``rotation about z 90°``, ``translation (3, 0, 0)``."""
    groups = (group.split(",") for group in numbers.split())
    written = [part[0] if len(part) == 1 else f"({', '.join(part)})" for part in groups]
    degrees = "\N{DEGREE SIGN}" * (kind.startswith("rotate") and bool(written))
    return " ".join([stage_title(KINDS[kind].factor), *written]) + degrees
