"""Colours of printed figures: nothing is told apart by hue alone."""

import colorsys
from itertools import combinations
from typing import Any

import numpy as np

from app.drawings.shades import LEAST_STEP, printed, with_lightness
from app.drawings.style import CONTRAST, LIGHT, PALETTES, PRINT, contrast, rgb
from app.drawings.vectors import LineShape, TextShape
from app.scenes.scene import BUILT_IN, load
from tests.support.drawings import figure_of


def lightness(colour: Any) -> float:
    """CIE L* of red, green and blue, 0 to 255."""
    parts = [c / 255.0 / 12.92 if c <= 10 else ((c / 255.0 + 0.055) / 1.055) ** 2.4 for c in colour]
    luminance = sum(w * c for w, c in zip((0.2126, 0.7152, 0.0722), parts, strict=True))
    return float(116.0 * luminance ** (1 / 3) - 16.0 if luminance > 0.0089 else 903.3 * luminance)


def differ_in_hue(one: Any, other: Any) -> bool:
    (h, s, _), (k, t, _) = (colorsys.rgb_to_hsv(*np.divide(each, 255.0)) for each in (one, other))
    return min(s, t) > 0.1 and min(abs(h - k), 1.0 - abs(h - k)) > 0.03


def test_faces_that_meet_differ_in_grey_in_every_scene() -> None:
    pairs = 0
    for name in BUILT_IN:
        scene = load(name)
        before, after = scene.surface, printed(scene, PRINT).surface
        assert before is not None and after is not None
        assert printed(scene, LIGHT) is scene
        points = [tuple(point) for point in np.round(before.points, 5).tolist()]
        at_edge: dict[frozenset[Any], list[int]] = {}
        for number, corners in enumerate(before.regular_faces.tolist()):
            for one, other in zip(corners, [*corners[1:], corners[0]], strict=True):
                at_edge.setdefault(frozenset((points[one], points[other])), []).append(number)
        old, new = (mesh.cell_data["rgb"].tolist() for mesh in (before, after))
        hues = {
            (*map(tuple, sorted((old[i], old[j]))), lightness(new[i]) - lightness(new[j]))
            for faces in at_edge.values()
            for i, j in combinations(faces, 2)
            if old[i] != old[j]
        }
        apart = [abs(step) for one, other, step in hues if differ_in_hue(one, other)]
        assert min(apart, default=LEAST_STEP) >= LEAST_STEP, name
        pairs += len(apart)
    assert pairs > 100


def test_a_colour_gets_the_lightness_asked_for_and_keeps_its_hue() -> None:
    colours = np.array([(0, 114, 178), (230, 159, 0), (128, 207, 185), (20, 20, 20)], np.uint8)
    for asked in (36.0, 66.0, 94.0):
        for colour, old in zip(with_lightness(colours, asked).tolist(), colours, strict=True):
            assert abs(lightness(colour) - asked) < 0.5
            assert not differ_in_hue(colour, old.tolist()) or asked > 90.0


def test_on_paper_labels_are_black_and_far_is_dashed() -> None:
    scene = load("letter-f")
    strokes = {}
    for style in (PRINT, CONTRAST):
        near, far = (
            lightness(np.multiply(255.0, [1.0 - tint * (1.0 - part) for part in rgb(colour)]))
            for colour, tint in zip((style.near, style.far), style.tints, strict=True)
        )
        assert 97.0 > far > near + LEAST_STEP > 90.0, "apart from each other and from paper"
    for name in ("screen", "print"):
        style = PALETTES[name]
        _, found = figure_of(scene, scene.start, ("ndc",), (250, 250), palette=name).shapes()
        inks = {shape.written.colour for shape in found if isinstance(shape, TextShape)}
        assert (inks == {"#000000"}) == (name == "print") and len(inks) >= 1
        far = [s for s in found if isinstance(s, LineShape) and s.colour == rgb(style.far)]
        strokes[name] = len(far)
    assert strokes["print"] > 2 * strokes["screen"] > 0
    head = load("field-of-view")
    _, found = figure_of(head, head.start, ("image",), (120, 90), palette="print").shapes()
    near, far = (
        max(s.width for s in found if isinstance(s, LineShape) and s.colour == rgb(colour))
        for colour in (PRINT.near, PRINT.far)
    )
    assert near > 1.5 * far
    hues = ("ink", "muted", "near", "far", "u", "v", "n", "eye", "target", "frustum", "accent")
    assert all(contrast(getattr(CONTRAST, each), CONTRAST.background) >= 7.0 for each in hues)
