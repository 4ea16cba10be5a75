"""The labels of a pane: every layer asks the `Board` for places, which are then found together."""

import math
import weakref
from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import cached_property, partial
from typing import Any, TypeAlias

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor2D

from app.drawings.actors import ScreenCells
from app.drawings.label import SceneLabel
from app.drawings.label_placement import (
    NOWHERE,
    Ground,
    KeptSpot,
    PlacedLabel,
    Places,
    Wish,
    along,
    around,
    beyond,
    clipped,
    joined,
    on,
    place,
)
from app.drawings.pane_view import Spot
from app.drawings.prop_group import PropGroup
from app.drawings.style import rgb
from app.model.formula import ARROW
from app.model.projection import Array
from app.scenes.phenomena.words import FEW

# Which label has a place first.
PROBE, LENGTH, SCENE, AXIS, EYE, SIDE, PLANE, TARGET, NUMBER = map(float, range(9))
DOT_EM = 0.4  # half the width of the square at a point that labels keep free
PATIENCE_S, FADE_S = 0.3, 0.12
"""How long a label keeps a place that is not free, and how long it then takes to another one."""
_AWAY_PX = -1e4
Standing: TypeAlias = Mapping[Hashable, tuple[KeptSpot, float]]
"""Where labels stand in a frame of a film, with the part of their opacity that is shown."""
Director: TypeAlias = Callable[[Sequence[Wish], Ground], Standing]
_MOST_INSIDE = 6  # places on a plane that are tried


class Board:
    """The labels of one pane with their leaders."""

    def __init__(self, canvas: PropGroup, renderer: Any = None) -> None:
        self._canvas, self.renderer = canvas, renderer or canvas.renderer
        self.em = canvas.style.font_size
        self._labels: dict[Hashable, tuple[SceneLabel, ScreenLines]] = {}
        self._wishes: list[Wish] = []
        self._kept: dict[Hashable, KeptSpot] = {}
        self.is_patient = False
        """Whether labels wait for `pass_time` before they leave a place that is not free."""
        self.director: Director | None = None
        """Who says where labels stand in a frame of a film, and how visible they are."""
        self._moves = 0  # how often labels were placed since they rested
        self.rests = False  # whether labels stand where they would afresh, and nothing has changed
        self._asked: tuple[list[Wish], Ground, int] | None = None
        """What was settled last, while time matters, and how many boxes were taken before."""
        self._waits: dict[Hashable, float] = {}  # seconds since a label's place was free
        self._fades: dict[Hashable, tuple[float, KeptSpot | None]] = {}
        """The labels on the way to other places, and for how many seconds."""
        self.is_restless = False  # whether `pass_time` has anything to do
        self.left_out: list[str] = []  # the texts of the labels that were wanted, and have no place
        self.points: list[tuple[str, tuple[float, float]]] = []
        """The texts of the labels of points, and the points."""

    @property
    def boxes(self) -> list[tuple[float, float, float, float]]:
        """What is named: the visible labels and their points, from the pane's left and bottom.

        Left, low, right and high, in pixels.
        """
        boxes, rim = [], DOT_EM * self.em
        for label, _ in self._labels.values():
            if label.actor.GetVisibility():
                left, right, low, high = label.box_px
                boxes.append((left, low, right, high))
        boxes += [(x - rim, y - rim, x + rim, y + rim) for _, (x, y) in self.points]
        return boxes

    @property
    def standing(self) -> Standing:
        """Where its labels stand, for another picture of the same scale."""
        return {key: (spot, 1.0) for key, spot in self._kept.items()}

    def name_at(self, x_px: float, y_px: float) -> str:
        """What the label at a pixel, from the left and the bottom, is the name of."""
        keys = (key for key, (label, _) in self._labels.items() if label.covers(x_px, y_px))
        key = next(keys, "")
        return str(key[1]) if isinstance(key, tuple) else str(key)

    def writes_value(self, key: Hashable) -> bool:
        """Whether a label of this key is visible, and says a value."""
        label = self._labels[key][0] if key in self._labels else None
        return label is not None and label.is_visible and "=" in label.text

    def label(self, key: Hashable, text: str = "", colour: str = "") -> SceneLabel:
        """Return the label of a key, which is created when it is first asked for."""
        if key not in self._labels:
            leader = ScreenLines(self._canvas, self._canvas.style.leader, 1, self.renderer)
            label = self._canvas.label(text, self.renderer, colour=colour, visible=False)
            self._labels[key] = label, leader
        return self._labels[key][0]

    def want(
        self,
        key: Hashable,
        spots: Sequence[tuple[float, float]],
        places: Callable[[], Places],
        rank: float,
        briefly: Callable[[tuple[float, float]], Places] | None = None,
    ) -> None:
        """Ask for one of these places, which name these spots, for the label of a key.

        `briefly` makes the places of its letter alone, whose size it is told.
        """
        label, short = self.label(key), None
        if briefly is not None and label.letter_px != label.size_px:
            short = label.letter_px, partial(briefly, label.letter_px)
        self._wishes.append(Wish(key, label.size_px, spots, places, rank, short))

    def want_beside(
        self, key: Hashable, spot: Spot, rank: float, way: tuple[float, float] | None = None
    ) -> None:
        """Ask for a place beside a point, towards `way` first; there is none behind the camera."""
        x, y, depth = spot
        if depth > 0.0 and math.isfinite(x + y):
            places = partial(around, (x, y), em=self.em, rim=DOT_EM * self.em, way=way)
            self.want(key, [(x, y)], partial(places, self.label(key).size_px), rank, places)
        else:
            self.want(key, [], lambda: NOWHERE, rank)

    def want_beyond(self, keys: Sequence[Hashable], ends: Sequence[Spot]) -> None:
        """Ask for places beyond the tips of arrows; `ends` are the start and the tip of each."""
        for key, start, tip in zip(keys, ends[::2], ends[1::2], strict=True):
            if tip[2] > 0.0:
                way, size = (tip[0] - start[0], tip[1] - start[1]), self.label(key).size_px
                self.want(key, [tip[:2]], partial(beyond, tip[:2], way, size, self.em), AXIS)

    def settle(self, ground: Ground, *, afresh: bool, at_rest: bool = False) -> bool:
        """Place the wanted labels, and hide the others; return whether one has changed its place.

        If not `afresh`, labels stay where they are as long as possible; `at_rest`, those that would
        stand elsewhere afresh begin to fade. After a single change they stand there at once.
        """
        self._wishes = [wish for wish in self._wishes if not _is_outside(wish, ground)]
        lights = dict[Hashable, float]()
        if self.director is not None:
            stands, afresh, at_rest = self.director(self._wishes, ground), False, False
            self.is_patient = True
            self._wishes = [wish for wish in self._wishes if wish.key in stands]
            self._kept = {key: spot for key, (spot, _) in stands.items()}
            lights = {key: light for key, (_, light) in stands.items()}
        self._asked = self._wishes, ground, len(ground.taken)
        best = self._place(None) if afresh or at_rest else {}
        afresh |= at_rest and (not self.is_patient or self._moves <= 1)
        self._moves = 0 if afresh or at_rest else self._moves + 1
        placed = best if afresh else self._place(self._kept)
        if afresh:
            for key in self._fades:
                self._fade(key, 1.0)
            self._fades = {}
        texts = [(self._labels[wish.key][0].text, wish) for wish in self._wishes]
        self.left_out = [text for text, wish in texts if wish.key not in placed]
        self.points = [(text, wish.spots[0]) for text, wish in texts if len(wish.spots) == 1]
        self._wishes = []
        before, self._kept = self._kept, {key: each.kept for key, each in placed.items()}
        for key, each in placed.items() if best else ():
            goal = best[key].kept if key in best else None
            faded = self._fades.get(key, (FADE_S, None))[0]
            leaves = faded < FADE_S / 2.0  # for where it stood best at the rest before
            if each.kept.is_elsewhere(goal):
                self._fades[key] = faded if leaves else 0.0, goal
            elif leaves:
                self._fade(key, 1.0)
                del self._fades[key]
        self._waits = {
            key: self._waits.get(key, 0.0)
            for key, each in placed.items()
            if not each.is_free and key not in self._fades
        }
        for key in self._fades.keys() - placed.keys():
            self._fade(key, 1.0)
            del self._fades[key]
        self._show(placed)
        for key, light in lights.items():
            self._fade(key, light)
        self._note_rest()
        self.rests = (afresh or at_rest) and not self.is_restless
        return self._kept != before

    def _note_rest(self) -> None:
        """At rest, drop the references that would keep the drawing alive."""
        self.is_restless = bool(self._waits or self._fades)
        if not self.is_restless:
            self._asked = None

    def _place(self, kept: Mapping[Hashable, KeptSpot] | None) -> dict[Hashable, PlacedLabel]:
        assert self._asked is not None
        wishes, ground, taken = self._asked
        del ground.taken[taken:]
        placer = partial(place, ground=ground, kept=kept, patient=self.is_patient)
        placed = placer(wishes)
        if any(wish.rank in (PLANE, TARGET) and wish.key not in placed for wish in wishes):
            # The window's sides stand back: the planes and the target are named before them.
            later = [wish._replace(rank=TARGET + 0.5) for wish in wishes if wish.rank == SIDE]
            if later:
                del ground.taken[taken:]
                first = [wish for wish in wishes if wish.rank != SIDE]
                placed = placer([*first, *later])
        return placed

    def _show(self, placed: Mapping[Hashable, PlacedLabel]) -> None:
        for key, (label, leader) in self._labels.items():
            spot = placed.get(key)
            label.set_visible(spot is not None)
            if spot is not None:
                label.shorten(spot.kept.brief)
                label.set_position(*spot.centre, spot.turn)
            joined_px = None if spot is None else spot.leader
            if joined_px is not None or leader.used:
                leader.begin()
                if joined_px is not None:
                    leader.add(*joined_px)
                leader.end()

    # -- in time

    def pass_time(self, seconds: float, *, is_soft: bool = False) -> bool:
        """Move or fade labels that have waited long enough; return whether that is seen."""
        self._waits = {key: waited + seconds for key, waited in self._waits.items()}
        late = {key for key, waited in self._waits.items() if waited >= PATIENCE_S}
        if late:
            placed = self._place({k: each for k, each in self._kept.items() if k not in late})
            for key in late:
                del self._waits[key]
                goal = placed[key].kept if key in placed else None
                if self._kept[key].is_elsewhere(goal):
                    self._fades[key] = -seconds, goal
        is_seen, arrived = bool(self._fades), False
        for key, (before, goal) in list(self._fades.items()):
            now = before + seconds if is_soft else FADE_S
            if before < FADE_S / 2.0 <= now:
                arrived = True
                self._kept.pop(key, None)
                if goal is not None:
                    self._kept[key] = goal
            self._fades[key] = now, goal
            self._fade(key, min(1.0, abs(2.0 * now / FADE_S - 1.0)))
            if now >= FADE_S:
                del self._fades[key]
        if arrived:
            placed = self._place(self._kept)
            self._kept = {key: each.kept for key, each in placed.items()}
            self._show(placed)
        self._note_rest()
        return is_seen

    def _fade(self, key: Hashable, light: float) -> None:
        label, leader = self._labels[key]
        light *= self._canvas.labels_light
        label.fade(light)
        leader.actor.GetProperty().SetOpacity(light)


def _is_outside(wish: Wish, ground: Ground) -> bool:
    """Whether a wish is for a single point, and that lies beyond the pane's border."""
    left, low, right, high = ground.limits
    x, y = wish.spots[0] if len(wish.spots) == 1 else (left, low)
    return max(left - x, x - right, low - y, y - high) > ground.em


def want_plane(
    board: Board,
    ground: Ground,
    key: Hashable,
    corners: Sequence[Spot],
    body: Sequence[Spot],
    covered: Callable[[], Sequence[Spot]] = tuple,
) -> None:
    """Ask for a place for a plane's name: along its visible edges, else on it.

    `corners` are seen in the pane, as are those of the `body` that the plane bounds; `covered`
    returns the places of the pane that show the plane.
    """
    spots = [(x, y) if depth > 0.0 else (math.nan, math.nan) for x, y, depth in corners]

    def places(size: tuple[float, float]) -> Places:
        ends = np.array(spots)
        edges = np.stack([ends, np.roll(ends, -1, axis=0)], axis=1)
        seen = clipped(edges[np.isfinite(edges).all(axis=(1, 2))], ground.limits)
        possible = [on((x, y)) for x, y, _ in covered()[:_MOST_INSIDE]]
        if len(seen):
            x, y = seen.reshape(-1, 2).mean(axis=0).tolist()
            before = [each[:2] for each in body if each[2] > 0.0]
            possible.insert(0, along(seen, (x, y), size, board.em, before))
        return joined(*possible) if possible else NOWHERE

    board.want(key, spots, partial(places, board.label(key).size_px), PLANE, places)


class ScreenLines:
    """Thin lines of one colour in the plane of the screen, drawn anew by ``begin, add..., end``."""

    def __init__(self, canvas: PropGroup, colour: str, most: int, renderer: Any = None) -> None:
        self._canvas, self.used = weakref.proxy(canvas), 0
        self._colour, self._most = colour, most
        self.actor = vtkActor2D()
        canvas.add(self.actor, renderer=renderer, layer="labels")
        canvas.set_visible(False, self.actor)

    @cached_property
    def _cells(self) -> ScreenCells:
        """What is drawn, made at the first line: most labels have no leader."""
        cells = ScreenCells(self._most, 2, self.actor)
        cells.px[..., :2] = _AWAY_PX
        self.actor.GetProperty().SetColor(*rgb(self._colour))
        self.actor.GetProperty().SetLineWidth(self._canvas.style.line_width / 2.0)
        return cells

    @property
    def ends(self) -> Array:
        """The lines' ends in pixels, (n, 2, 2)."""
        return self._cells.px[: self.used, :, :2].astype(np.float64)

    def begin(self) -> None:
        if self.used:
            self._cells.px[: self.used, :, :2] = _AWAY_PX
            self.used = 0

    def add(self, start_px: tuple[float, float], end_px: tuple[float, float]) -> None:
        """Draw a line between two pixels, counted from the left and from the bottom."""
        if self.used < self._most:
            self._cells.px[self.used, :, :2] = start_px, end_px
            self.used += 1

    def end(self) -> None:
        if self.used:
            self._cells.changed()
        self._canvas.set_visible(self.used > 0, self.actor)


def vector(word: str) -> str:
    """The letter of a vector with its arrow; a word stays as it is."""
    return f"{word}{ARROW}" if len(word) == 1 else word


def written_distance(value: float, digits: int = FEW) -> str:
    """Write a distance as a label does: 1, 0.025, −10, 1e+06, the sign for infinity."""
    if math.isinf(value):
        return "\N{INFINITY}"
    is_whole = digits == FEW and 1e4 <= abs(value) < 1e6
    text = f"{value:.0f}" if is_whole else f"{value:.{digits}g}"
    return text.replace("-", "\N{MINUS SIGN}")
