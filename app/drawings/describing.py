"""A document in words: what each pane shows, what is cut off, and what is risky."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from app.document.document import Document
from app.document.naming import seen_from
from app.document.view import PANES
from app.drawings.scene_place import place_of, predictions
from app.languages import translate, with_comma
from app.lecture.letters import in_letters
from app.lecture.stages import CANONICAL_PERSPECTIVE, NDC, VIEW
from app.model.infinity import trace_at_infinity
from app.model.limits import PLANES
from app.model.projection import Projection, Vector
from app.model.refusal import DESCRIPTION, HEALTH, SENTENCES
from app.precision.levels import DRAWING_TOLERANCE_PX, Precision
from app.precision.risks import risks
from app.scenes.phenomena.words import digits_apart, figure
from app.scenes.scene import Scene

WORLDS = SENTENCES["Description/worlds"]
STAGES = tuple(SENTENCES["Description/stages"].values())


class Description(NamedTuple):
    """Sentences about a document.

    - `general`, `cut`, `risky`: about scene, camera, lens and marked points; about what lies
      outside of the view volume; and about what is at risk.
    """

    title: str  # the scene's
    general: tuple[str, ...]
    panes: dict[str, str]  # about each pane, by its name
    cut: tuple[str, ...]
    risky: tuple[str, ...]

    def of_pane(self, pane: str) -> str:
        """Return all that concerns one pane."""
        return " ".join((self.panes[pane], *self.general, *self.cut, *self.risky))

    @property
    def text(self) -> str:
        return " ".join((*self.general, *self.panes.values(), *self.cut, *self.risky))


def describe(document: Document, scene: Scene, panes: Sequence[str] = PANES) -> Description:
    projection, letters = document.projection, document.view.letters
    illustration = scene.illustration(projection, document.settings)
    title, general = translate(scene.title, "phenomena"), list[str]()
    if scene.phenomenon is not None:
        explanation = translate(scene.phenomenon.words.explanation, "phenomena")
        general.append(in_letters(explanation, letters))
    own = int(scene.own_lines.sum()), scene.dot_count
    if any(own):
        general.append(_said(DESCRIPTION["content"], scene.triangles, *own))
    general += [*_camera(projection), *_points(document)]
    risky = []
    if scene.has_vertices:
        drawing_px = max(place_of(scene, projection).bounds_px)
        tolerance_px = document.quality.tolerance_px(DRAWING_TOLERANCE_PX)
        drawn: Precision = "float32" if drawing_px <= tolerance_px else "float64"
        risky = risks(
            projection, scene.lower, scene.upper, drawn, drawing_px, predictions(projection, scene)
        )
    said = [
        _said(risk.template, *(translate(f, "Plane") for f in risk.figures), context="Health")
        for risk in risky
    ]
    if illustration is not None and illustration.warning is not None:
        warning = illustration.warning.sentence(lambda text: translate(text, "phenomena"))
        said.append(with_comma(in_letters(warning, letters)))
    cut = list(_cut(projection, scene))
    if any(risk.template == HEALTH["no-picture"] for risk in risky):  # which says more
        cut = [each for each in cut if each[0] != DESCRIPTION["beyond"]]
    return Description(
        title,
        tuple(general),
        {pane: _pane(pane, document, scene) for pane in panes},
        tuple(
            _said(each, ", ".join(translate(p, "Plane") for p in planes)) for each, planes in cut
        ),
        tuple(f"{sentence}." for sentence in said),
    )


def _said(template: str, *values: object, context: str = "Description") -> str:
    return with_comma(translate(template, context).format(*values))


def _camera(projection: Projection) -> Iterator[str]:
    camera, lens = projection.camera, projection.lens
    if projection.has_camera:
        yield _said(DESCRIPTION["camera"], *_rows(camera.eye, camera.target))
    title = translate(lens.title, "Lens")
    if lens.planes is None:
        yield _said(DESCRIPTION["no-planes"], title)
        return
    digits = digits_apart(lens.near, lens.far)
    far = "∞" if lens.far == np.inf else figure(lens.far, digits)
    yield _said(DESCRIPTION["lens"], title, figure(lens.near, digits), far)
    if lens.fov_y_deg is not None:
        angle = figure(lens.fov_y_deg, digits_apart(lens.fov_y_deg, 180.0))
        yield _said(DESCRIPTION["angle"], angle)


def _points(document: Document) -> Iterator[str]:
    """Say where the marked points are; omit the rays of pixels."""
    probes = [probe for probe in document.view.probes if probe.row is not None]
    places, pixels = list[Vector](), list[list[float]]()
    for probe in probes:
        if probe.direction is not None:
            places.append(probe.direction)
            trace = trace_at_infinity(document.projection, probe.direction)
        else:
            assert probe.point is not None
            places.append(probe.point)
            trace = document.projection.trace(probe.point)
        pixels.append(trace.image.tolist())
    for probe, place, pixel in zip(probes, _rows(*places), _rows(*pixels), strict=True):
        template = DESCRIPTION["point"] if probe.direction is None else DESCRIPTION["direction"]
        template = DESCRIPTION["nowhere"] if "nan" in pixel else template
        yield _said(template, probe.number, place, pixel)


def _pane(pane: str, document: Document, scene: Scene) -> str:
    view, projection = document.view, document.projection
    if pane == "world":
        said = _said(WORLDS[seen_from(view, scene) or "free"])
    elif pane == "equation":
        said = _said(DESCRIPTION["equation"], view.equation)
    elif pane == "ndc":
        said = _stage(view.stage, projection)
    else:
        said = _said(DESCRIPTION["image"], *projection.image_size)
    if view.compare and view.compares_in == pane:
        said += " " + _said(DESCRIPTION["compared"], len(view.compare))
    return said


def _stage(at: float, projection: Projection) -> str:
    before, after = int(max(at, 0.0)), int(np.ceil(max(at, 0.0)))
    lens = projection.lens
    if not lens.has_steps:  # a typed matrix leads from view to NDC at once
        before = VIEW if VIEW < at < NDC else before
        after = NDC if VIEW < at < NDC else after
    stops = [
        stop + (stop == CANONICAL_PERSPECTIVE and not lens.central) for stop in (before, after)
    ]
    template = DESCRIPTION["at-a-stage"] if stops[0] == stops[1] else DESCRIPTION["between-stages"]
    return _said(template, *(_said(STAGES[stop]) for stop in stops))


def _cut(projection: Projection, scene: Scene) -> Iterator[tuple[str, list[str]]]:
    """Yield what is true of the objects' places, and the planes in the sentence.

    Behind the eye and before the near plane the other planes have no meaning.
    """
    points = scene.subject.points
    if not len(points):
        return
    traced = projection.trace(points, "object")
    is_behind = traced.clip[:, 3] < 0.0
    beyond = traced.outside.copy()
    beyond[beyond[:, 0] | is_behind, 1:] = False
    planes = [plane for plane, outside in zip(PLANES, beyond.T, strict=True) if outside.any()]
    if planes:
        yield DESCRIPTION["beyond"], planes
    if is_behind.any():
        yield DESCRIPTION["behind"], []
    if not projection.trace(scene.objects_box, "object").outside.any():
        yield DESCRIPTION["all-inside"], []


def _rows(*points: Sequence[float]) -> list[str]:
    """Write points with as many digits as tell different ones apart."""
    digits = [digits_apart(*column) for column in zip(*points, strict=True)]
    return [", ".join(map(figure, point, digits)) for point in points]
