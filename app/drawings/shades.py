"""Colours that a photocopy keeps apart: faces that meet differ in lightness, not in hue alone."""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.drawings.style import Style
from app.model.projection import Array
from app.scenes.own_mesh import cells_of
from app.scenes.scene import Scene
from app.scenes.shapes import DRAWN_RGB, EDGE_RGB, OUTLINE_RGB, SIDE_RGB, distinct_rows

LEAST_STEP = 15.0  # difference in L* of two faces that meet and are not of one hue
_STEP = LEAST_STEP + 0.5  # colours are rounded to whole levels
_SIDES = 48.0, 36.0, 84.0, 94.0, 69.0, 63.0  # L* from +x to -z
_WANTED = dict(zip(map(tuple, SIDE_RGB.tolist()), _SIDES, strict=True))
_DARKEST, _PALEST = 36.0, 95.0
_SAME_HUE = 0.05  # of the direction of a colour
_MOST_COLOURS, _MOST_FACES = 200, 50_000
_XYZ = np.array([(0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505)])
_WHITE = _XYZ.sum(axis=1)


def lab(rgb: Any) -> Array:
    """Return L*, a* and b* (D65) of colours, (n, 3) of 0 to 255."""
    part = np.asarray(rgb, dtype=np.float64) / 255.0
    linear = np.where(part <= 0.04045, part / 12.92, ((part + 0.055) / 1.055) ** 2.4)
    t = linear @ _XYZ.T / _WHITE
    x, y, z = np.where(t > 216 / 24389, np.cbrt(t), (24389 / 27 * t + 16.0) / 116.0).T
    return np.stack([116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)], axis=-1)


def _of_lab(colours: Array) -> Array:
    """The inverse of `lab`; outside of 0 to 255 there is no such colour."""
    lightness, a, b = colours.T
    y = (lightness + 16.0) / 116.0
    f = np.stack([y + a / 500.0, y, y - b / 200.0], axis=-1)
    t = np.where(f > 6 / 29, f**3, (116.0 * f - 16.0) * 27 / 24389)
    linear = (t * _WHITE) @ np.linalg.inv(_XYZ).T
    part = np.where(
        linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 0.0) ** (1 / 2.4) - 0.055
    )
    return np.asarray(255.0 * part)


def with_lightness(rgb: Any, lightness: Any) -> NDArray[np.uint8]:
    """Return colours, (n, 3), of another L* and the same hue, as colourful as a screen can."""
    wanted = lab(rgb)
    wanted[:, 0] = lightness
    grey = wanted * (1.0, 0.0, 0.0)
    least, most = np.zeros((len(wanted), 1)), np.ones((len(wanted), 1))
    for _ in range(12):
        middle = (least + most) / 2.0
        colours = _of_lab(grey + middle * (wanted - grey))
        fits = ((colours > -0.5) & (colours < 255.5)).all(axis=1, keepdims=True)
        least, most = np.where(fits, middle, least), np.where(fits, most, middle)
    return np.clip(np.rint(_of_lab(grey + least * (wanted - grey))), 0, 255).astype(np.uint8)


def printed(scene: Scene, style: Style) -> Scene:
    """Return the scene in colours that a printer keeps apart, if the style is one for paper."""
    if not style.on_paper:
        return scene
    from app.scenes.poly_mesh import PolyMesh

    surface, lines = scene.surface, scene.lines
    if surface is not None and "rgb" in surface.cell_data:
        colours, kinds = distinct_rows(np.asarray(surface.cell_data["rgb"]))
        if 1 < len(colours) <= _MOST_COLOURS and surface.n_cells <= _MOST_FACES:
            surface = PolyMesh.sharing(surface)
            chosen = with_lightness(colours, _levels(colours, meeting(scene)))
            surface.cell_data["rgb"] = chosen[kinds]
    if lines is not None:
        lines = PolyMesh.sharing(lines)
        rgb = np.array(lines.cell_data["rgb"])
        for dark in (EDGE_RGB, OUTLINE_RGB, DRAWN_RGB):
            rgb[(rgb == dark).all(axis=1)] = 0
        lines.cell_data["rgb"] = rgb
    dots = scene.dots
    if dots is not None:
        dots = PolyMesh.sharing(dots)
        rgb = np.array(dots.point_data["rgb"])
        rgb[(rgb == DRAWN_RGB).all(axis=1)] = 0
        dots.point_data["rgb"] = rgb
    return replace(scene, surface=surface, lines=lines, dots=dots)


def meeting(scene: Scene) -> set[tuple[int, int]]:
    """Return the pairs of `distinct_rows` of the faces' colours that meet at an edge.

    Left out are pairs of one hue: a surface in light and shadow.
    """
    surface = scene.surface
    assert surface is not None
    colours, kinds = distinct_rows(np.asarray(surface.cell_data["rgb"]))
    hues = colours / np.maximum(np.linalg.norm(colours, axis=1, keepdims=True), 1.0)
    _, places = distinct_rows(np.round(np.asarray(surface.points, dtype=np.float64), 5))
    kinds_at: dict[tuple[int, int], set[int]] = {}
    begins, flat = cells_of(surface.GetPolys())
    for kind, face in zip(kinds.tolist(), np.split(places[flat], begins[1:-1]), strict=True):
        corners = face.tolist()
        for one, other in zip(corners, [*corners[1:], corners[0]], strict=True):
            kinds_at.setdefault((min(one, other), max(one, other)), set()).add(kind)
    return {
        (i, j)
        for together in kinds_at.values()
        for i in together
        for j in together
        if i < j and np.abs(hues[i] - hues[j]).max() > _SAME_HUE
    }


def _levels(colours: NDArray[np.uint8], meet: set[tuple[int, int]]) -> Array:
    """The L* of each colour: near its own, and apart from those that it meets."""
    own = [
        _WANTED.get((r, g, b), level)
        for (r, g, b), level in zip(colours.tolist(), lab(colours)[:, 0].tolist(), strict=True)
    ]
    beside: list[list[int]] = [[] for _ in own]
    for i, j in meet:
        beside[i].append(j)
        beside[j].append(i)
    levels: list[float | None] = [None] * len(own)
    for i in sorted(range(len(own)), key=lambda each: -len(beside[each])):
        taken = [level for j in beside[i] if (level := levels[j]) is not None]
        if not beside[i]:
            levels[i] = own[i]
            continue
        wanted = min(max(own[i], _DARKEST), _PALEST)
        ends = (end for level in taken for end in (level - _STEP, level + _STEP))
        possible = [end for end in (wanted, *ends) if _DARKEST <= end <= _PALEST]

        def rank(level: float, taken: list[float] = taken, wanted: float = wanted) -> Any:
            steps = [_STEP, *(round(abs(level - other), 6) for other in taken)]
            return min(steps), -abs(level - wanted)

        levels[i] = max(possible, key=rank)
    return np.array(levels, dtype=np.float64)
