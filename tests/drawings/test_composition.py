"""The measures of pictures: overlapping or too many labels, an empty picture, small letters."""

from __future__ import annotations

from dataclasses import replace

import pytest

from app.commands.composed import faults_in
from app.document.document import Document
from app.document.naming import nameable
from app.document.settings import set_values
from app.drawings.composition import CAPITAL, Measured, Placed, measured
from app.scenes.scene import load
from tests import composition

SIZE = 480, 360


def picture(pane: str, *values: str, scene: str = "letter-f", em: float = 14.0) -> Measured:
    """The measures of a pane in a state; of several pictures, the first."""
    found = load(scene)
    document = set_values(Document(scene, found.start), values)
    return measured(document, found, pane, SIZE, em)[0]


def kinds(found: Measured, screen_px: int | None = None) -> list[str]:
    return [kind for kind, _ in faults_in(found, screen_px)]


def test_the_labels_of_a_picture_are_those_that_its_view_names() -> None:
    found = picture("world", "view.names=eye,near")
    assert sorted(each.text for each in found.labels) == ["eye", "near n = 4"]
    assert all(0.0 <= each.left < each.right <= SIZE[0] for each in found.labels)
    assert all(0.0 <= each.low < each.high <= SIZE[1] for each in found.labels)
    assert kinds(picture("world", "view.layers=labels")) == kinds(picture("world", "view.names="))


def test_a_label_lies_where_its_letters_are() -> None:
    (label,) = picture("world", "view.names=eye", em=14.0).labels
    (larger,) = picture("world", "view.names=eye", em=28.0).labels
    high = label.high - label.low
    assert larger.high - larger.low == pytest.approx(2.0 * high, abs=2.0)
    assert CAPITAL * 14.0 * 0.6 < high < 1.5 * 14.0


def test_everything_named_is_crowded() -> None:
    found = picture("world", "view.names=*", "view.fixed=side", scene="similar-triangles")
    assert len(found.labels) > 7 and "crowded" in kinds(found)
    assert any("at most 7" in text for kind, text in faults_in(found, None) if kind == "crowded")


def test_a_far_away_subject_leaves_its_cube_full_and_a_small_one_is_empty() -> None:
    assert "empty" not in kinds(picture("ndc", "view.names=near"))
    base = picture("world", "view.names=eye")
    tiny = base._replace(fill=(0.3, 0.59))
    assert tiny.is_empty and "30% of the width and 59% of the height" in str(
        [*faults_in(tiny, None)]
    )
    assert not base._replace(fill=(0.3, 0.61)).is_empty


def test_a_named_far_plane_fills_a_flat_view() -> None:
    """It is a part of what the view frames; where it is not named it may leave the pane."""
    named = picture("world", "view.fixed=side", "view.names=eye,far")
    assert max(named.fill) > 0.7
    far_away = picture("world", "view.fixed=side", "view.names=eye", "lens.far=100")
    assert far_away.fill[1] < named.fill[1]


def test_overlaps_cuts_and_underscores_are_found() -> None:
    base = picture("world", "view.names=eye")
    (eye,) = base.labels
    beside = eye._replace(text="beside", left=eye.right, right=eye.right + 20.0)
    over = eye._replace(text="over", left=eye.left + 3.0, right=eye.right + 3.0)
    out = Placed("out_of", -3.0, 10.0, 20.0, 20.0, 14.0)
    raw = Placed("a _ b $x_1$ y_p", 20.0, 30.0, 30.0, 40.0, 14.0)
    found = base._replace(labels=(eye, beside, over, out, raw))
    assert found.overlaps == [("eye", "over"), ("beside", "over")]
    assert found.cut == ["out_of"]
    assert found.raw == ["a _ b $x_1$ y_p"]
    assert {"overlap", "cut", "raw"} <= set(kinds(found))
    assert not base.overlaps and not base.cut and not base.raw


@pytest.mark.parametrize(("em", "is_fault"), [(20.0, True), (36.7, False), (50.0, True)])
def test_a_class_reads_capitals_of_2_2_to_3_percent_of_the_screen(
    em: float, is_fault: bool
) -> None:
    base = picture("world", "view.names=eye")
    (eye,) = base.labels
    found = base._replace(labels=(replace_em(eye, em),))
    assert ("letters" in kinds(found, 1080)) == is_fault
    assert "letters" not in kinds(found)


def replace_em(label: Placed, em: float) -> Placed:
    return label._replace(em=em)


def test_compared_pictures_are_each_measured_as_they_are_drawn() -> None:
    found = load("letter-f")
    document = set_values(
        Document("letter-f", found.start), ["view.compare=lens.near=2|lens.fov_y_deg=60"]
    )
    pictures = measured(document, found, "image", SIZE, 14.0)
    assert len(pictures) == 3 and all(each.size_px[0] < SIZE[0] for each in pictures)
    worlds = replace(document, view=replace(document.view, slide=("world",)))
    assert len(measured(worlds, found, "world", SIZE, 14.0)) == 3
    assert len(measured(worlds, found, "image", SIZE, 14.0)) == 1
    alone = replace(document, view=replace(document.view, compare=()))
    assert len(measured(alone, found, "image", SIZE, 14.0)) == 1


@pytest.mark.parametrize(
    ("scene", "window", "style"),
    [
        ("letter-f", "1366x768", "light"),
        ("camera-obscura", "1920x1080", "light"),
        ("planar-shadow", "1366x768", "dark"),
        ("clipping", "1366x768", "light"),
        ("off-axis-window", "1920x1080", "dark"),
    ],
)
def test_scenes_are_composed_as_they_open(scene: str, window: str, style: str) -> None:
    """A sample of what `python3 -m tests.composition` measures."""
    found = list(composition.pictures(scene, window, style))
    assert [pane for pane, _ in found] == ["world", "ndc", "image"]
    assert any(each.labels for _, each in found)
    for pane, each in found:
        assert list(faults_in(each, None)) == [], pane


def test_the_axes_of_a_moved_object_are_named_if_the_view_says_so() -> None:
    moved = "object.translate=2,0,0"
    assert [each.text for each in picture("world", moved, "view.names=eye").labels] == ["eye"]
    found = {each.text for each in picture("world", moved, "view.names=eye,x,z").labels}
    assert found == {"eye", "x", "z"}


@pytest.mark.parametrize("fixed", ["", "top"])
def test_a_probe_behind_the_camera_is_in_the_picture(fixed: str) -> None:
    values = ("camera.eye=0,2.4,2", "camera.target=0,2.4,1", "view.names=eye")
    found = picture("world", *values, "view.probes=1,2.4,0,1,2.4,4", f"view.fixed={fixed}")
    assert {each.text for each in found.labels} == {"eye", "1", "2"} and not found.cut


@pytest.mark.parametrize("stage", ["world", "view"])
@pytest.mark.parametrize("names", ["x,y,z", "near,far"])
def test_the_stops_before_the_cube_fill_a_wide_pane(stage: str, names: str) -> None:
    """What is named has its room, and neither the ball round the grid nor a far plane takes it."""
    names = "u,v,n" if stage == "view" and names == "x,y,z" else names
    document = set_values(
        Document("letter-f", load("letter-f").start), (f"view.stage={stage}", f"view.names={names}")
    )
    (found,) = measured(document, load("letter-f"), "ndc", (960, 455), 18.0)
    assert not found.is_empty and not found.cut
    assert len(found.labels) == len(names.split(","))


@pytest.mark.parametrize(
    ("kind", "values"),
    [
        ("frustum", {"l = −1", "r = 3", "b = −1.125", "t = 1.125"}),
        ("orthographic", {"l = −1", "r = 3", "b = −1.125", "t = 1.125"}),
    ],
)
def test_the_sides_of_the_window_are_named_with_their_numbers(
    kind: str, values: set[str]
) -> None:
    window = "lens.left=-1", "lens.right=3", "lens.bottom=-1.125", "lens.top=1.125"
    state = f"lens.kind={kind}", *window, "view.names=l,r,b,t"
    found = picture("world", *state)
    assert {each.text for each in found.labels} == values and not found.cut
    in_000 = picture("world", *state, "view.letters=000")
    assert "x_max = 3" in {each.text for each in in_000.labels}
    assert {"l", "t"} <= nameable("world", state_of(*state), load("letter-f"))
    free = state_of("lens.kind=matrix")
    assert not {"l", "t"} & nameable("world", free, load("letter-f"))


def state_of(*values: str) -> Document:
    return set_values(Document("letter-f", load("letter-f").start), values)


def test_a_picture_shows_the_frames_that_it_names() -> None:
    """Each has one letter at its origin; x, y and z name the world's axes if its frame is there."""
    moved = "object.translate=2,0,0", "object.rotate_deg=0,-30,0"
    found = picture("world", *moved, "view.names=frame-o,frame-w,frame-e")
    assert {each.text for each in found.labels} == {"O", "W", "E"} and not found.cut
    still = picture("world", "view.names=frame-o,eye")
    assert {each.text for each in still.labels} == {"O", "eye"}
    lettered = picture("world", *moved, "view.names=frame-w,x,z,frame-e")
    assert {each.text for each in lettered.labels} == {"x", "z", "E"}
    assert {"frame-w", "x"} <= nameable("world", state_of("view.names=frame-w"), load("letter-f"))
