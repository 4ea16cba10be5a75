"""Figures as an editor measures them: the size of each letter, and the width that a page scales."""

import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from matplotlib.path import Path as Polygon

from app.document.document import Document
from app.document.lengths import DPI, Size
from app.document.settings import compared, set_values
from app.drawings.figure import Figure
from app.drawings.label_placement import clipped
from app.drawings.one_pane import PanePicture
from app.drawings.style import PALETTES, rgb
from app.drawings.vectors import Area, Disc, LineShape, PixelShape, TextShape, box_of
from app.lessons.course import scene_of
from app.model.refusal import Refusal
from app.scenes.scene import load
from app.scenes.shapes import GRID_AXIS_RGB, GRID_RGB
from tests.drawings.test_vectors import streams_of

ASKED_PT = 8.0
CHAPTER = (
    ("letter-f", "world,image", ()), ("letter-f", "ndc", ("view.stage=2",)),
    ("similar-triangles", "world", ()), ("depth-buffer", "world,image", ()),
    ("clipping", "world,ndc", ("lens.kind=oblique",)), ("vanishing-points", "image", ()),
    ("focus", "world/image", ()), ("letter-f", "world", ("view.fixed=side",)),
)  # fmt: skip
"""The eight figures of a chapter."""
FAR_ON_PAPER, TOUCHING_PX = rgb(PALETTES["print"].far), 0.05
COMPARED = "view.compare=a: settings.interpolation=affine|c: settings.interpolation=correct"


def figure(scene: str, panes: str, values: tuple[str, ...], **options: object) -> Figure:
    document = set_values(Document(scene, load(scene).start), values)
    column = "/" in panes
    size = Size(84.0, 84.0, "mm") if column else Size(174.0, 60.0, "mm")
    options = {"size": size, "text_pt": ASKED_PT, "palette": "print"} | options
    return Figure(document, scene_of(document), re.split("[,/]", panes), column=column, **options)  # type: ignore[arg-type]


def letters_pt(path: Path) -> Iterator[float]:
    """The sizes of the letters in a file, without those that are subscripts, in points."""
    content = path.read_bytes()
    if path.suffix == ".pdf":
        drawn = b"".join(streams_of(content))
        yield from map(float, re.findall(rb"/F\d+ ([\d.]+) Tf", drawn))
    elif path.suffix == ".tex":  # 72.27 points of TeX are 72
        for size, scale in re.findall(rb"fontsize\{([\d.]+)\}.*?scale=([\d.]+)", content):
            yield float(size) * float(scale) * 72.0 / 72.27
    else:
        for px in re.findall(rb'font-size="([\d.]+)"', content):
            yield float(px) * 72.0 / DPI


@pytest.mark.parametrize(("scene", "panes", "values"), CHAPTER)
def test_every_letter_has_the_size_that_is_asked_for(
    scene: str, panes: str, values: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown = figure(scene, panes, values)
    drawn = shown.shapes()  # once for all formats
    monkeypatch.setattr(Figure, "shapes", lambda _figure, _progress: drawn)
    for ending in ("pdf", "tex", "svg"):
        path = tmp_path / f"figure.{ending}"
        shown.save(path)
        sizes = np.array([*letters_pt(path)])
        low = np.abs(sizes / ASKED_PT - 0.7) < 0.01  # a subscript
        assert len(sizes[~low]) and np.abs(sizes[~low] - ASKED_PT).max() < 0.1, ending


@pytest.mark.parametrize(
    ("scene", "panes", "values", "width_mm"),
    [
        (*CHAPTER[0], 84.0),
        (*CHAPTER[4], 84.0),
        (*CHAPTER[7], 120.0),
        ("clipping", "world,ndc", (), 84.0),
        ("off-axis-window", "world,ndc", (), 84.0),
        ("interpolation", "image", (COMPARED,), 84.0),
        ("interpolation", "world,ndc,image", (), 84.0),  # pixels, which are empty above
        ("cheap-arithmetic", "world,image", (), 84.0),
        ("similar-triangles", "world,image", (), 84.0),
    ],
)
def test_a_figure_is_as_wide_as_asked_after_it_was_cropped(
    scene: str, panes: str, values: tuple[str, ...], width_mm: float
) -> None:
    """The page and what is seen on it to a thousandth: nothing of a line at its side is cut."""
    shown = figure(scene, panes, values, size=None, width=width_mm / 25.4 * DPI)
    (width, height), shapes = shown.shapes()
    assert width / DPI * 25.4 == pytest.approx(width_mm, abs=1e-3)
    left, top, right, low = box_of(shapes, "#ffffff") or (0.0,) * 4
    assert (left, right) == pytest.approx((0.0, width), abs=0.01)
    assert (top, low) == pytest.approx((0.0, height), abs=1e-6)
    if scene in ("letter-f", "interpolation", "cheap-arithmetic") and width_mm == 84.0:
        high, wide = shown.pixels().shape[:2]
        assert wide == round(width) and high == pytest.approx(height, abs=2.0)


def test_a_width_that_is_small_on_paper_is_drawn_at_a_scale_that_has_room_for_it() -> None:
    narrow = {"size": None, "text_pt": None, "width": 5.0 / 25.4 * DPI}
    with pytest.raises(Refusal, match=r"^width = 5 mm: must be from 5.42 to 1387 mm"):
        figure(*CHAPTER[0], **narrow)
    pixels = figure(*CHAPTER[0], **narrow, scale=4.0).pixels()
    assert pixels.shape[1] == 236


EQUATIONS = (
    ("own", "frustum"), ("003", "view"), ("001", "M_z M_pp M_persp"), ("002", "P numbers"),
    ("own", "object, view"),
)  # fmt: skip


@pytest.mark.parametrize(("letters", "text"), EQUATIONS)
def test_an_equation_is_a_figure_that_a_column_can_hold(
    letters: str, text: str, tmp_path: Path
) -> None:
    shown = figure(
        "letter-f", "equation", (f"view.equation={text}", f"view.letters={letters}"), size=None,
        width=84.0 / 25.4 * DPI,
    )  # fmt: skip
    (width, height), shapes = shown.shapes()
    left, top, right, low = box_of(shapes, "#ffffff") or (0.0,) * 4
    assert 0.0 <= left < right <= width and -1.0 <= top < low <= height + 1.0
    assert shown.pixels().shape == (round(height), round(width), 3)
    natural = replace(shown, width=None).shapes()[0]
    assert natural[0] > 3.0 * (ASKED_PT / 72.0 * DPI) and natural[1] <= height + 1e-6
    for ending in ("pdf", "tex", "svg"):
        shown.save(tmp_path / f"e.{ending}")
    tex = (tmp_path / "e.tex").read_text(encoding="utf-8")
    assert "textbackslash" not in tex and "dfrac" not in tex
    sizes = np.array([*letters_pt(tmp_path / "e.pdf")])
    assert np.abs(sizes[:, None] - [ASKED_PT, 0.7 * ASKED_PT]).min(axis=1).max() < 0.1


def test_cells_of_an_equation_are_apart_also_in_letters_of_tex() -> None:
    """Computer Modern sets ``z_max + z_min`` a tenth wider than STIX."""
    shown = figure("letter-f", "equation", ("view.equation=frustum", "view.letters=004"), size=None)
    boxes = [box_of([shape], "") for shape in shown.shapes()[1] if isinstance(shape, TextShape)]
    cells = [(left, high, right) for left, high, right, _ in filter(None, boxes)]
    em, gaps = ASKED_PT / 72.0 * DPI, list[float]()
    for (_, one_high, right), (left, high, _) in pairwise(cells):
        if abs(one_high - high) < 0.5 * em and left > right:
            gaps.append((left - right) / em)
    assert len(gaps) >= 8 and min(gaps) > 1.2


def test_an_equation_that_its_column_cannot_hold_is_refused() -> None:
    with pytest.raises(Refusal, match=r"^width = 30 mm: a line of this equation needs \d+"):
        figure("letter-f", "equation", ("view.equation=frustum",), size=None, width=354.0)
    with pytest.raises(Refusal, match="must name 1 to 4 matrices"):
        figure("letter-f", "equation", ())


def test_a_world_frames_what_is_asked_for() -> None:
    values = ("view.names=eye,target",)
    corners = []
    for fit in ("named", "frustum", "scene"):
        shown = figure("letter-f", "world", values, size=Size(60.0, 60.0, "mm"), fit=fit)
        cameras = []
        shown.pixels(seen=lambda drawing, _finer, to=cameras: to.append(drawing.own.pose))
        corners.append(cameras[0])
    assert len({repr(each) for each in corners}) == 3


def test_the_frame_of_an_image_lies_over_its_pixels() -> None:
    document = compared(Document("interpolation", load("interpolation").start), "interpolation")
    _, shapes = Figure(document, scene_of(document), ["image"], (992, 500)).shapes()
    kinds = [type(shape) for shape in shapes]
    last = max(place for place, kind in enumerate(kinds) if kind is PixelShape)
    frames = [place for place, each in enumerate(shapes) if isinstance(each, LineShape)]
    assert kinds.count(PixelShape) == 2 and max(frames) > last


def test_the_dashes_of_far_are_apart_in_a_column() -> None:
    """The ends of vector lines are round: a gap that is not wider than its line is filled."""
    narrow = figure("letter-f", "world,image", ("lens.fov_y_deg=20",), size=Size(84.0, 34.0, "mm"))
    lines = [shape for shape in narrow.shapes()[1] if isinstance(shape, LineShape)]
    far = [line for line in lines if line.colour == pytest.approx(FAR_ON_PAPER)]
    begins, ends = np.array([line.points for line in far]).swapaxes(0, 1)
    apart = np.linalg.norm(begins - ends[:, None], axis=2)
    gaps = apart[apart > TOUCHING_PX]  # not the parts of a dash
    assert len(far) > 12 and gaps.min() > 1.25 * far[0].width


def places_mm(shown: Figure) -> tuple[tuple[float, float], dict[str, tuple[float, float]]]:
    """The size of a figure, and the middles of its labels by their texts."""
    (width, height), shapes = shown.shapes()
    boxes = {s.written.text: box_of([s], "") for s in shapes if isinstance(s, TextShape)}
    middles = {
        text: ((box[0] + box[2]) / 2.0 / DPI * 25.4, (box[1] + box[3]) / 2.0 / DPI * 25.4)
        for text, box in boxes.items()
        if box is not None
    }
    return (width / DPI * 25.4, height / DPI * 25.4), middles


@pytest.mark.parametrize("width_mm", [36.0, 84.0])
def test_both_pictures_of_two_eyes_have_their_titles_in_their_middles(width_mm: float) -> None:
    """36 mm is what the image has in three panes of a column."""
    shown = figure("two-eyes", "image", (), size=None, width=width_mm / 25.4 * DPI)
    _, at = places_mm(shown)
    for name, share in (("left eye", 0.25), ("right eye", 0.75)):
        assert at[name][0] == pytest.approx(share * width_mm, abs=0.3)
        assert at[name][1] < 4.0


@pytest.mark.parametrize("width_mm", [84.0, 174.0])
def test_the_names_of_both_eyes_stand_beside_all_rays(width_mm: float) -> None:
    shown = figure("two-eyes", "world,image", (), size=None, width=width_mm / 25.4 * DPI)
    _, shapes = shown.shapes()
    rays = [
        end
        for each in shapes
        if isinstance(each, LineShape) and np.ptp(each.colour) > 0.2
        for end in pairwise(each.points)
    ]
    names = {each.written.text: each for each in shapes[::-1] if isinstance(each, TextShape)}
    for name in ("left eye", "right eye"):
        box = box_of([names[name]], "")
        assert box is not None and not len(clipped(np.array(rays), box)), name


def test_the_letter_of_a_point_is_on_its_side_of_the_frustums_edge() -> None:
    shown = figure("view-volumes", "world", (), size=None, width=84.0 / 25.4 * DPI)
    _, shapes = shown.shapes()
    letter = next(
        each for each in shapes if isinstance(each, TextShape) and each.written.text == "E"
    )
    box = box_of([letter], "")
    assert box is not None
    centre = np.reshape(box, (2, 2)).mean(axis=0)
    dots = [each.centre for each in shapes if isinstance(each, Disc)]
    own = min(dots, key=lambda dot: float(np.hypot(*(dot - centre))))
    way = np.sort([centre, own], axis=0).ravel()  # between them
    edges = [
        end
        for each in shapes
        if isinstance(each, LineShape) and each.colour == rgb(PALETTES["print"].frustum)
        for end in pairwise(each.points)
    ]
    assert not len(clipped(np.array(edges), tuple(way)))


@pytest.mark.parametrize("scene", ["focus", "eye-plane", "vertex-depth"])
def test_near_is_named_below_its_plane_where_what_lay_before_it_was_cut_away(scene: str) -> None:
    (_, high), at = places_mm(
        figure(scene, "world,ndc,image", (), size=None, width=174 * DPI / 25.4)
    )
    texts = {name: y for name, (_, y) in at.items() if name.endswith("1")}
    near, far = (
        next(y for name, y in texts.items() if name.startswith(each)) for each in ("near", "far")
    )
    assert far < 0.2 * high and near > 0.8 * high


@pytest.mark.parametrize("scene", ["letter-f", "similar-triangles"])
def test_no_more_than_a_gap_is_empty_between_panes_of_a_column(scene: str) -> None:
    shown = figure(scene, "world/ndc/image", (), size=None, width=84.0 / 25.4 * DPI)
    (_, height), shapes = shown.shapes()
    assert scene != "letter-f" or height < 180.0 / 25.4 * DPI, "it goes into a page of a book"
    pixels = shown.pixels()
    ink = (pixels != 255).any(axis=(1, 2)).nonzero()[0]
    rows = np.zeros(len(pixels), dtype=np.bool_)
    for box in filter(None, (box_of([shape], "#ffffff") for shape in shapes)):
        rows[max(0, round(box[1])) : round(box[3])] = True
    for seen in (ink, rows.nonzero()[0]):
        assert np.diff(seen).max() == pytest.approx(2.0 * ASKED_PT / 72.0 * DPI, abs=2.0)
    assert len(pixels) == pytest.approx(height, abs=4.0)
    fixed = replace(shown, width=None, size=Size(84.0, 170.0, "mm"))
    assert len(fixed.pixels()) == fixed.size_px[1]


def ground_of(world: PanePicture) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """The ends of a ground's lines, (n, 2)."""
    colours = [tuple(level / 255.0 for level in each) for each in (GRID_RGB, GRID_AXIS_RGB)]
    lines = (s for s in world.shapes("none", lambda: None) if isinstance(s, LineShape))
    return np.array([point for line in lines if line.colour in colours for point in line.points])


@pytest.mark.parametrize("scene", ["focus", "camera-obscura", "cube"])
def test_the_ground_ends_at_lines_of_its_own_inside_the_pane(scene: str) -> None:
    world = next(figure(scene, "world,image", ()).pictures())
    ends, pixels = ground_of(world), world.pixels()
    assert len(ends) > 40 and ends.min() > 0.1 and (ends < np.array(world.size) - 0.1).all()
    border = np.concatenate([pixels[:, 0], pixels[:, -1], pixels[0], pixels[-1]])
    assert (border == 255).all()
    ends = ground_of(replace(world, style=PALETTES["screen"]))
    assert ends.min() < 0.1 or (ends > np.array(world.size) - 0.1).any()


def test_the_ground_stays_whole_where_objects_would_stand_beside_it() -> None:
    world = next(figure("view-volumes", "world,image", ()).pictures())
    ends = ground_of(world)
    assert ends.min() < 0.1 or (ends > np.array(world.size) - 0.1).any()


@pytest.mark.parametrize(("scene", "name"), [("planar-shadow", "P'"), ("camera-obscura", "h'")])
def test_no_letter_lies_on_a_shadow_or_on_what_a_film_shows(scene: str, name: str) -> None:
    shown = figure(scene, "world,ndc,image", (), size=None, width=174.0 / 25.4 * DPI)
    _, shapes = shown.shapes()
    white = rgb(PALETTES["print"].background)
    areas = [s for s in shapes if isinstance(s, Area) and s.colour != white and s.opacity == 1.0]
    boxes = [box_of([s], "") for s in shapes if isinstance(s, TextShape) and s.written.text == name]
    assert boxes
    for left, top, right, low in filter(None, boxes):
        middle = [((left + right) / 2.0, (top + low) / 2.0)]
        assert not any(Polygon(ring).contains_points(middle)[0] for s in areas for ring in s.rings)


def test_the_names_of_sharpness_stand_beside_the_posts_in_a_column() -> None:
    shown = figure("focus", "world,image", (), size=None, width=84.0 / 25.4 * DPI)
    _, shapes = shown.shapes()
    white = rgb(PALETTES["print"].background)
    posts = [s for s in shapes if isinstance(s, Area) and s.opacity == 1.0 and s.colour != white]
    written = [s for s in shapes if isinstance(s, TextShape)]
    assert {"sharp from", "in focus", "sharp to"} <= {s.written.text for s in written}
    for left, top, right, low in filter(None, (box_of([s], "") for s in written)):
        grid = np.mgrid[left:right:1.0, top:low:1.0].reshape(2, -1).T
        assert not any(Polygon(ring).contains_points(grid).any() for s in posts for ring in s.rings)
