"""The numbers of probes at every stage, as the command `project` prints them, with formulas."""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple, TypeAlias

from PySide6.QtCore import QObject

from app.lecture.highlight import NOTHING, Highlight
from app.lecture.notation import called, clip_signs, steps_of_a_point
from app.lecture.titles import stage_title
from app.model.chain import KINDS, Chain
from app.model.formula_text import stacked_fraction
from app.model.projection import PLANES, Projection, Trace
from app.model.refusal import Refusal
from app.picking.picking import Probe, projector
from app.precision.levels import precision_for_reading, predict, trace_homogeneous
from widgets.parts.messages import lettering, plane_name

Cells: TypeAlias = list[str | float]  # a probe's line: its numbers, or one text across all columns
DIVIDE = -5  # the line that shows the divisor, after its sign


class ProbeRows(NamedTuple):
    """The content of the table."""

    probes: Sequence[int] = ()
    lines: Sequence[tuple[str, str]] = ()
    """Name and formula of each line; the formula is for `widgets.parts.typeset`."""
    blocks: Sequence[Sequence[Cells]] = ()  # the lines of each probe
    outside: Sequence[Highlight] = ()  # the planes that each probe lies beyond


_Move: TypeAlias = tuple[str, str, Chain]  # name, formula of the point after it, moves still to do


def _moves(chain: Chain) -> Iterator[_Move]:
    """Yield the moves that change something, except the last one, which leads to the world."""
    tiles = [tile for tile in chain.on if not Chain((tile,)).is_identity]
    letters = [called(tile.kind) for tile in tiles]
    for at in range(len(tiles) - 1, 0, -1):
        name = stage_title(KINDS[tiles[at].kind].factor)
        yield name, f"{' '.join(letters[at:])} p", Chain(tuple(tiles[:at]))


class ProbeNumbers(QObject):
    """Computes the table, and says why a number is missing."""

    _moves: Sequence[_Move] = ()  # those of the object

    def numbers(self, projection: Projection, probes: Sequence[Probe]) -> ProbeRows:
        """Follow probes through all stages."""
        self._moves = [*_moves(projection.placement)]
        rows = [probe.row for probe in probes if probe.row is not None]
        traced: Trace | None = None
        if rows:
            points = [probe.point for probe in probes if probe.point is not None]
            bounds = predict(projection, points) if points else None
            traced = trace_homogeneous(projection, rows, precision_for_reading(bounds))
        blocks: list[list[Cells]] = []
        outside, row = [], 0
        for probe in probes:
            if probe.row is None or traced is None:
                blocks.append(self._of_ray(projection, probe))
                outside.append(NOTHING)
            else:
                point = Trace(*(part[row] for part in traced))
                blocks.append(self._of_point(projection, point))
                outside.append(frozenset(_outside_of(point)))
                row += 1
        lines = self._lines(projection, directions=any(probe.direction for probe in probes))
        return ProbeRows([probe.number for probe in probes], lines, blocks, outside)

    def _lines(self, projection: Projection, *, directions: bool) -> list[tuple[str, str]]:
        steps = steps_of_a_point(projection, lettering.now, directions=directions)
        inside = steps["between"]
        if projection.lens.planes is None:
            low = "0" if min(projection.depth_range) == 0.0 else "−w"
            inside = f"{low} ≤ z ≤ w"
        depth = stacked_fraction(steps["depth"], "2") if projection.depth == "opengl" else "z"
        w = "w" if clip_signs(projection, lettering.now)[3] > 0 else "|w|"
        image = f"(x + 1) {stacked_fraction('W', '2')},  (1 − y) {stacked_fraction('H', '2')}"
        return [
            (self.tr("object"), "p"),
            *((name, formula) for name, formula, _ in self._moves),
            (self.tr("world"), steps["world"]),
            (self.tr("view"), steps["view"]),
            (self.tr("clip"), f"{steps['clip']};  w = {steps['w']}"),
            (self.tr("divide"), "÷ w"),
            (self.tr("NDC"), ",  ".join(stacked_fraction(part, "w") for part in "xyz")),
            (self.tr("image px"), image),
            (self.tr("depth"), depth),
            (self.tr("inside"), f"|x|, |y| ≤ {w};  {inside}"),
        ]

    def _of_point(self, projection: Projection, point: Trace) -> list[Cells]:
        signs = clip_signs(projection, lettering.now)
        clip = _cells(point.clip * signs)
        outside_of = ", ".join(map(plane_name, _outside_of(point)))
        outside = self.tr("outside of: {0}").format(outside_of)
        inside = outside if outside_of else self.tr("inside")
        lines = list[Cells]()
        for left in (projection.placement, *(left for *_, left in self._moves)):
            try:
                lines.append(list(left.object_from_world(point.world.tolist())))
            except Refusal:
                lines.append([self.tr("none: a scale of 0 has flattened the object")])
        lines += [_cells(point.world), _cells(point.view), clip]
        if not point.in_front:
            return [*lines, *self._no_picture(projection, point), [], [], [inside]]
        if point.world[3] == 0.0:
            inside = self.tr("the vanishing point; {0}").format(inside)
        ndc = _cells(point.ndc * signs[:3] * signs[3])
        return [*lines, clip[3:] * 3, ndc, _cells(point.image), _cells(point.depth), [inside]]

    def _no_picture(self, projection: Projection, point: Trace) -> tuple[Cells, Cells]:
        """Say why a point has no picture, in two lines."""
        w = float(point.clip[3])
        if point.world[3] != 0.0:
            if w < 0.0:
                return [self.tr("behind the eye")], []
            if w == 0.0:
                return [self.tr("in the eye plane (w = 0)")], []
        elif w < 0.0:
            opposite = self.tr("the opposite direction has a picture")
            return [self.tr("behind the eye: no picture")], [opposite]
        else:
            parallel_projectors = not projection.clip_from_view[3, :3].any()  # w is that of p
            if parallel_projectors or w == 0.0:
                more = self.tr("parallel to the image: lines stay parallel")
                if parallel_projectors:
                    more = self.tr("parallel projectors: lines stay parallel")
                return [self.tr("w = 0: its picture is at infinity too")], [more]
        return [self.tr("beside the eye: no number is large enough")], []

    def _of_ray(self, projection: Projection, probe: Probe) -> list[Cells]:
        """Return a ray's lines: only x and y, from its pixel."""
        assert probe.pixel is not None
        (x, y), (width, height) = probe.pixel, projection.image_size
        ndc: Cells = [2.0 * x / width - 1.0, 1.0 - 2.0 * y / height]
        ray: Cells = [self._ray(projection, probe)]
        return [ray, *[[]] * (4 + len(self._moves)), ndc, [x, y], [], []]

    def _ray(self, projection: Projection, probe: Probe) -> str:
        """Say which part of a pixel's ray is drawn in the world, or why there is none."""
        if projection.frustum_sign:
            return self.tr("the pixel's ray, from near to far")
        if projector(projection, probe, [0.0]) is not None:
            return self.tr("the pixel's ray, as far as it is in front of the eye")
        try:
            projection.world_from_clip_at(projection.camera.eye)
        except Refusal:
            return self.tr("no ray in the world: the matrix has no inverse")
        return self.tr("no ray in the world: all of it is behind the eye")


def _outside_of(point: Trace) -> list[str]:
    return [plane for plane, is_out in zip(PLANES, point.outside.tolist(), strict=True) if is_out]


def _cells(values: Any) -> Cells:
    """Write numbers as `project` prints them, without minus zeros."""
    return list((values + 0.0).reshape(-1).tolist())
