"""A cloud of one's own points in a figure: where it is seen, as circles and as pixels."""

import re
from typing import Any

import numpy as np
import pytest

from app import api
from app.document.document import Document
from app.drawings.vectors import MOST_DOTS, Disc, LineShape, PixelShape, TextShape
from app.model.refusal import Refusal

#: Of an image of 200 x 200 px, where (x, y, -2) lies at 100 + 50 x and 100 - 50 y.
PLAIN = api.Projection(
    api.Camera(eye=(0.0, 0.0, 0.0), target=(0.0, 0.0, -1.0)), api.Perspective(90.0, 1.0, 30.0),
    image_size=(200, 200),
)  # fmt: skip
#: Seen, on the axis; right and up; behind the eye; before near; beyond far; beside the window.
POINTS = [(0, 0, -2), (0.5, 1, -2), (0, 0, 2), (0, 0, -0.5), (0, 0, -40), (3, 0, -2)]
RED = (1.0, 0.0, 0.0)


def ball(count: int) -> Any:
    away = np.random.default_rng(1).normal(size=(count, 3))
    return away / np.linalg.norm(away, axis=1, keepdims=True) + (0.0, 0.0, -3.0)


def circles(figure: api.Figure) -> list[Disc]:
    return [each for each in figure.shapes()[1] if isinstance(each, Disc) and each.colour == RED]


def test_dots_are_where_the_points_are_projected() -> None:
    figure = api.figure(PLAIN, cloud=POINTS, colours="#ff0000", panes="image", size="600x600")
    found = sorted(disc.centre for disc in circles(figure))
    np.testing.assert_allclose(found, [(300.0, 300.0), (375.0, 150.0)], atol=0.02)
    assert len(circles(api.figure(PLAIN, cloud=POINTS, colours=RED, panes="world"))) >= 6
    many = np.random.default_rng(2).uniform(-4.0, 4.0, (2000, 3))
    document = api.load("letter-f", "lens.near=2", "lens.far=12", "image.width=800")
    seen = api.project(document, many)
    is_inside = ~seen.outside.any(axis=-1) & seen.in_front
    alone = api.figure(document.projection, cloud=many, colours="#ff0000", panes="image")
    found = np.array(sorted(disc.centre for disc in circles(alone)))
    scale = alone.full_size[0] / 800.0
    expected = np.array(sorted(map(tuple, scale * seen.image[is_inside])))
    np.testing.assert_allclose(found, expected, atol=0.02)
    beside = api.figure(document, cloud=many, colours="#ff0000", panes="image")
    assert len(found) > len(circles(beside)) > 100, "the letter F hides some"


def test_faces_hide_what_lies_behind_them() -> None:
    """The unit cube on the ground: a point in it, one between it and the eye, one behind it."""
    document = api.load("cube", "camera.eye=0,0.5,8", "camera.target=0,0.5,0", "lens.far=30")
    points = [(0.1, 0.6, 0.0), (0.3, 0.7, 3.0), (-0.2, 0.4, -4.0)]
    for rest in (0, MOST_DOTS + 1):  # far outside: then there are more dots than circles
        cloud = np.concatenate([points, np.full((rest, 3), (0.0, 1.0, 200.0))])
        figure = api.figure(document, cloud=cloud, colours="#ff0000", panes="image", dot_size=3.0)
        scale = figure.full_size[0] / document.projection.image_size[0]
        inside, before, behind = scale * api.project(document, points).image
        if not rest:
            (disc,) = circles(figure)
            np.testing.assert_allclose(disc.centre, before, atol=0.02)
            assert disc.radius == pytest.approx(1.5 * 300.0 / 72.0, rel=0.02)
            continue
        (shape,) = (each for each in figure.shapes()[1] if isinstance(each, PixelShape))
        left, top, wide, high = shape.place
        assert left < before[0] < left + wide and top < before[1] < top + high
        assert wide == pytest.approx(3.0 * 300.0 / 72.0, abs=2.0) and abs(wide - high) <= 1.0
        for place in (inside, behind):
            assert not (left < place[0] < left + wide and top < place[1] < top + high)


def test_a_large_cloud_is_pixels_among_lines_and_text() -> None:
    cloud = ball(50_000)

    figure = api.figure(PLAIN, cloud=cloud, colours=(1.0, 0.0, 0.0), panes="world,image")
    shapes = figure.shapes()[1]
    pictures = [each for each in shapes if isinstance(each, PixelShape)]
    assert len(pictures) == 2 and all(each.is_cloud for each in pictures)
    assert not any(isinstance(each, Disc) and each.colour == RED for each in shapes)
    assert any(isinstance(each, LineShape) for each in shapes)
    assert any(isinstance(each, TextShape) for each in shapes)
    picture = pictures[1]
    seen = picture.pixels[..., 3] > 0
    assert (picture.pixels[seen][:, :3] == (255, 0, 0)).all(), "no other colour is mixed in"
    # The ball of radius 1 at distance 3: its outline is a circle of tan(asin(1/3)) times 100 px.
    radius = np.tan(np.arcsin(1 / 3)) * figure.full_size[1] / 2.0 * 0.7
    assert picture.place[2] == pytest.approx(picture.place[3], abs=3.0)
    assert seen.mean() == pytest.approx(np.pi / 4.0, abs=0.06) and radius > 0.0
    svg = figure.svg()
    assert svg.count("<image") == 2 and "<text" in svg and len(svg) < 2_000_000


@pytest.mark.parametrize("count", [1, 300, MOST_DOTS + 1])
def test_every_format_takes_it(tmp_path: Any, count: int, monkeypatch: pytest.MonkeyPatch) -> None:
    figure = api.figure(PLAIN, cloud=ball(count), size="120mmx40mm")
    drawn = figure.shapes()  # once for all formats
    monkeypatch.setattr(api.Figure, "shapes", lambda _figure, _progress=None: drawn)
    for ending in ("svg", "pdf", "png", "tex"):
        figure.save(path := tmp_path / f"figure.{ending}")
        assert path.stat().st_size > 1_000
        assert len(list(tmp_path.glob("*-pixels*.png"))) == (
            3 if (ending, count > 300) == ("tex", True) else 0
        )


def test_it_is_told_in_words_and_by_colours_of_its_own() -> None:
    figure = api.figure(api.load("letter-f"), cloud=ball(10), panes="image")
    assert re.search(r"points: 10\b", figure.description.text)
    colours = np.arange(30).reshape(10, 3)
    figure = api.figure(PLAIN, cloud=ball(10), colours=colours, panes="world", palette="print")
    assert figure.scene.dots is not None
    np.testing.assert_array_equal(figure.scene.dots.point_data["rgb"], colours)


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"cloud": np.empty((0, 3))}, "cloud: must have 1 to 1000000 points, and 0 were given."),
        ({"cloud": np.zeros((1_000_001, 3))}, "cloud: must have 1 to 1000000 points, and 1000001"),
        ({"cloud": [(0.0, float("nan"), 1.0)]}, "nan"),
        ({"cloud": [(0.0, 1.0)]}, r"cloud\.shape = \(1, 2\): must end in 3"),
        ({"cloud": [(1e40, 0, 0), (0, 1, 0)]}, "cloud: the size"),
        ({"cloud": [(1e15, 0.0, 0.0)]}, "cloud: a vertex has the coordinate 1e\\+15"),
        ({"cloud": POINTS, "colours": "red"}, "colours = 'red': must be #rrggbb, or red, green"),
        ({"cloud": POINTS, "colours": [(1.0, 0.0, 0.0)] * 5}, "for all points or for each of 6"),
        ({"cloud": POINTS, "colours": (0.0, 0.0, 256)}, "must be #rrggbb"),
        ({"cloud": POINTS, "colours": [(1,), (1, 2)]}, "must be #rrggbb"),
        ({"cloud": POINTS, "dot_size": 0.0}, "dot_size = 0: must be from 0.1 to 72 points."),
        ({"cloud": POINTS, "dot_size": "2em"}, "dot_size = '2em': must be"),
        ({"cloud": POINTS, "dot_size": float("nan")}, "dot_size = nan: must be from 0.1"),
    ],
)
def test_what_cannot_be_is_refused(options: dict[str, Any], sentence: str) -> None:
    with pytest.raises(Refusal, match=sentence):
        api.figure(PLAIN, **options)
    assert isinstance(api.load("letter-f"), Document)
