"""Measures pictures by the rules of composition: their labels, and how well they fill their pane.

A picture is drawn as for a figure. Its labels say where they are; what lies under them, and what
fills the pane, is read off the pixels of the same picture without labels.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.document.document import Document
from app.document.settings import pictured
from app.drawings import DrawingWords
from app.drawings.drawing import Drawing
from app.drawings.image import ImageDrawing
from app.drawings.label import LabelActor
from app.drawings.off_screen import Pixels, pixels_of
from app.drawings.one_pane import PanePicture
from app.drawings.side_by_side import places_of
from app.drawings.stage import StageDrawing
from app.drawings.style import LIGHT, Style
from app.drawings.world import WorldDrawing
from app.lecture.typesetting import pieces_of
from app.model.projection import Array
from app.scenes.scene import Scene

MOST_LABELS = 7
LEAST_FILL = 0.6  # of a pane's width or height: what the box round everything named covers at least
LEAST_AREA, FULL = 0.35, 0.75
"""Of a pane's area, what that box covers at least, unless it has `FULL` of the width or height:
then it is as large as its shape allows, such as a low triangle in a high pane. It is not asked of
flat views, which leave room for rows of lengths, and of a construction that has only begun."""
LETTERS = 0.022, 0.03
"""Height of the capitals of words, relative to the height of a screen that a class looks at."""
CAPITAL = 0.729  # height of a capital of DejaVu Sans, in em
_INK = 60  # difference of a colour from the ground from which it is ink: a pale tint hides nothing
_LEAVES = frozenset({"grid", "frustum"})
"""Layers that decide only by what has to be inside whether they fill the pane."""


class PlacedText(NamedTuple):
    """A label in a picture: its text, and its letters in pixels from the left and the bottom."""

    text: str
    left: float
    low: float
    right: float
    high: float
    em: float

    def overlaps(self, other: "PlacedText") -> bool:
        return (
            self.left < other.right - 0.5
            and other.left < self.right - 0.5
            and self.low < other.high - 0.5
            and other.low < self.high - 0.5
        )


class ComposedPicture(NamedTuple):
    """One pane's picture: its labels, its points, and how well it fills the pane."""

    pane: str
    size_px: tuple[int, int]
    labels: tuple[PlacedText, ...]
    fill: tuple[float, float]
    """Of the pane's width and height: the box round what is drawn, without grid and frustum, and
    round the labels."""
    left_out: tuple[str, ...] = ()  # the labels that are wanted, and have no place
    points: tuple[tuple[str, tuple[float, float]], ...] = ()
    """The labels of points, with the points in pixels from the left and the bottom."""
    needs_area: bool = True  # whether `LEAST_AREA` holds for the picture
    outside: tuple[tuple[str, float], ...] = ()
    """What has to be inside the pane and is not, and by which part of the pane's height."""

    @property
    def covered(self) -> list[tuple[str, str]]:
        """The labels that lie on the point of another one, with that one."""
        return [
            (each.text, text)
            for each in self.labels
            for text, (x, y) in self.points
            if text != each.text and each.left < x < each.right and each.low < y < each.high
        ]

    @property
    def overlaps(self) -> list[tuple[str, str]]:
        pairs = combinations(self.labels, 2)
        return [(one.text, other.text) for one, other in pairs if one.overlaps(other)]

    @property
    def cut(self) -> list[str]:
        """The labels that are not whole in the pane."""
        width, height = self.size_px
        return [
            each.text
            for each in self.labels
            if each.left < 0 or each.low < 0 or each.right > width or each.high > height
        ]

    @property
    def raw(self) -> list[str]:
        """The labels with an underscore that is not typeset."""
        return [
            each.text
            for each in self.labels
            if any("_" in piece for piece, is_tex in pieces_of(each.text) if not is_tex)
        ]

    @property
    def is_empty(self) -> bool:
        longest, area = max(self.fill), self.fill[0] * self.fill[1]
        is_thin = self.needs_area and longest < FULL and area < LEAST_AREA
        return longest < LEAST_FILL or is_thin


def measured(
    document: Document,
    scene: Scene,
    pane: str,
    size_px: tuple[int, int],
    em_px: float,
    style: Style = LIGHT,
) -> list[ComposedPicture]:
    """Measure a pane's picture, or each of the pictures that are compared there."""
    style = style.enlarged(em_px / style.font_size)
    if pane != document.view.compares_in or not document.view.compare:
        return [_measured(document, document, scene, pane, size_px, style, bare=False)]
    shown = [pictured(document, picture) for picture in document.view.compare]
    aspects = [each.projection.aspect for each in shown]
    places = places_of(pane, *size_px, aspects, style.font_size)
    return [
        _measured(of, document, scene, pane, (wide, high), style, bare=True)
        for of, (_, _, wide, high) in zip(shown, places, strict=True)
    ]


def _measured(
    of: Document,
    document: Document,
    scene: Scene,
    pane: str,
    size_px: tuple[int, int],
    style: Style,
    bare: bool,
) -> ComposedPicture:
    illustration, view = scene.illustration(of.projection, of.settings), document.view
    state = replace(document, projection=of.projection, settings=of.settings)
    words = DrawingWords(view.letters)
    picture = PanePicture(pane, state, scene, illustration, size_px, style, words, bare=bare)
    with picture.drawn() as (window, drawing):
        labels, actors = [], list(_actors(window))
        for renderer, actor in actors:
            label = actor.label()
            if label is None:
                continue
            left, right, low, high = label.box_px
            x, y = renderer.GetOrigin()
            labels.append(PlacedText(label.text, x + left, y + low, x + right, y + high, label.em))
        board, are_drawn = drawing.board, "labels" not in view.layers
        left_out = tuple(board.left_out) if are_drawn else ()
        to_right, up = board.renderer.GetOrigin()
        points = tuple((text, (to_right + x, up + y)) for text, (x, y) in board.points if are_drawn)
        outside = tuple((name, px / size_px[1]) for name, px in drawing.cut().items())
        for _, actor in actors:
            actor.SetVisibility(False)
        if isinstance(drawing, ImageDrawing):
            place = drawing.picture_rectangle_px
            fill = place.width / size_px[0], place.height / size_px[1]
        else:
            spots = _inside(drawing)
            drawing.show_layers(view.layers | _LEAVES)
            drawing.show_projection(of.projection, illustration)
            window.Render()
            fill = _fill(_ink(pixels_of(window)), labels, spots)
        needs_area = not drawing.fixed and (pane != "world" or view.step is None)
    return ComposedPicture(
        pane, size_px, tuple(labels), fill, left_out, points, needs_area, outside
    )


def _actors(window: Any) -> Iterator[tuple[Any, LabelActor]]:
    for renderer in window.GetRenderers():
        for prop in renderer.GetViewProps():
            if isinstance(prop, LabelActor) and prop.GetVisibility():
                yield renderer, prop


def _ink(pixels: Pixels) -> NDArray[np.bool_]:
    """Where there is ink, (height, width), the first row at the top."""
    ink = np.zeros(pixels.shape[:2], dtype=np.bool_)
    for channel in np.moveaxis(pixels, 2, 0)[:3]:
        ground = float(np.median(channel.reshape(-1)[::7]))
        # Whole bounds, because bytes are compared ten times as fast as float64.
        ink |= (channel > math.floor(ground + _INK)) | (channel < math.ceil(ground - _INK))
    return ink


def _inside(drawing: Drawing) -> Array:
    """Where the pane shows what has to be inside it, (n, 2) from its top left."""
    if isinstance(drawing, StageDrawing) and (around := drawing.around) is not None:
        state = drawing.state
        spots: Array = state.spots(around + state.morph.origin_at(state.position))
    elif isinstance(drawing, WorldDrawing):
        spots = drawing.own.pane.spots(np.concatenate(list(drawing.layers.inside().values())))
    else:
        return np.empty((0, 2))
    spots = spots[np.isfinite(spots).all(axis=1)]
    return np.array([0.0, drawing.state.size_px[1]]) + spots * (1.0, -1.0)


def _fill(ink: NDArray[np.bool_], labels: list[PlacedText], spots: Array) -> tuple[float, float]:
    """Of the width and height: the box round ink, labels and spots, (n, 2) from the top left."""
    height, width = ink.shape
    rows, columns = np.flatnonzero(ink.any(axis=1)), np.flatnonzero(ink.any(axis=0))
    x = [*columns[[0, -1]].tolist()] if len(columns) else []
    y = [*rows[[0, -1]].tolist()] if len(rows) else []
    x += np.clip(spots[:, 0], 0, width).tolist()
    y += np.clip(spots[:, 1], 0, height).tolist()
    for each in labels:
        x += np.clip([each.left, each.right], 0, width).tolist()
        y += np.clip([height - each.high, height - each.low], 0, height).tolist()
    return ((max(x) - min(x)) / width, (max(y) - min(y)) / height) if x else (0.0, 0.0)
