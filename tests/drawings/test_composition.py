"""The measures of pictures: overlapping or too many labels, an empty picture, small letters."""

from dataclasses import replace

import pytest

from app.commands.composed import faults_in
from app.document.document import Document
from app.document.naming import nameable
from app.document.settings import set_values
from app.drawings.composition import CAPITAL, ComposedPicture, PlacedText, measured
from app.model.projection import Camera
from app.scenes.scene import load
from tests import composition

SIZE = 480, 360


def picture(pane: str, *values: str, scene: str = "letter-f", em: float = 14.0) -> ComposedPicture:
    """The measures of a pane in a state; of several pictures, the first."""
    found = load(scene)
    document = set_values(Document(scene, found.start), values)
    return measured(document, found, pane, SIZE, em)[0]


def kinds(found: ComposedPicture, screen_px: int | None = None) -> list[str]:
    return [kind for kind, _ in faults_in(found, screen_px)]


def test_the_labels_of_a_picture_are_those_that_its_view_names() -> None:
    found = picture("world", "view.names=eye,near")
    assert sorted(each.text for each in found.labels) == ["eye", "near n = 5"]
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
    thin = base._replace(fill=(0.3, 0.61))
    assert thin.is_empty and "35% of the area" in str([*faults_in(thin, None)])
    assert not thin._replace(needs_area=False).is_empty, "in a flat view its shape decides"
    assert (
        not base._replace(fill=(0.3, 0.76)).is_empty and not base._replace(fill=(0.6, 0.6)).is_empty
    )
    flat = picture("world", "view.names=eye", "view.fixed=side")
    assert base.needs_area and not flat.needs_area


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
    out = PlacedText("out_of", -3.0, 10.0, 20.0, 20.0, 14.0)
    raw = PlacedText("a _ b $x_1$ y_p", 20.0, 30.0, 30.0, 40.0, 14.0)
    found = base._replace(labels=(eye, beside, over, out, raw))
    assert found.overlaps == [("eye", "over"), ("beside", "over")]
    assert found.cut == ["out_of"]
    assert found.raw == ["a _ b $x_1$ y_p"]
    assert {"overlap", "cut", "raw"} <= set(kinds(found))
    assert not base.overlaps and not base.cut and not base.raw


def test_a_name_without_a_place_is_hidden() -> None:
    found = picture("world", "view.names=eye,near", em=110.0)
    assert "near n = 5" in found.left_out and "eye" not in found.left_out
    assert [each.text for each in found.labels] == ["eye"]
    assert "hidden" in kinds(found)
    for em in (70.0, 75.0, 85.0, 95.0):
        both = picture("world", "view.names=eye,near", em=em)
        assert len(both.labels) == 2 and not both.left_out
    assert [each.text for each in both.labels] == ["eye", "n"]
    assert not picture("world", "view.names=eye,near").left_out
    hidden = picture("world", "view.names=eye,near", "view.layers=labels", em=110.0)
    assert not hidden.left_out, "the view hides all labels"


def test_a_name_of_a_point_behind_the_panes_camera_is_hidden() -> None:
    found = load("letter-f")
    document = set_values(Document("letter-f", found.start), ["view.names=eye"])
    (x, y, z), target = document.projection.camera.eye, document.projection.camera.target
    before = Camera((x - 0.5, y - 0.5, z - 0.5), target)
    document = replace(document, view=replace(document.view, panes={"world": before}))
    (measures,) = measured(document, found, "world", SIZE, 14.0)
    assert measures.left_out == ("eye",)


def test_a_label_on_the_point_of_another_one_is_a_fault() -> None:
    base = picture("world", "view.names=eye")
    ((text, (x, y)),) = base.points
    assert text == "eye" and not base.covered
    near = PlacedText("near", x - 5.0, y - 5.0, x + 5.0, y + 5.0, 14.0)
    found = base._replace(labels=(*base.labels, near))
    assert found.covered == [("near", "eye")] and kinds(found) == ["hidden"]
    aside = near._replace(left=x + 1.0)
    assert not base._replace(labels=(*base.labels, aside)).covered


def test_the_points_of_labels_are_where_the_picture_shows_them() -> None:
    """The picture lies in the middle of a high pane."""
    found = load("interpolation")
    document = Document("interpolation", found.start)
    (high,) = measured(document, found, "image", (360, 900), 14.0)
    assert len(high.points) == len(high.labels) == 2
    for label in high.labels:
        x, y = dict(high.points)[label.text]
        to_right = max(label.left - x, 0.0, x - label.right)
        up = max(label.low - y, 0.0, y - label.high)
        assert 0.0 < to_right + up < 6.0 * label.em


def test_the_named_planes_of_a_flat_view_fill_it() -> None:
    values = "view.fixed=side", "lens.fov_y_deg=90", "lens.far=60", "view.names=eye,near,far"
    assert max(picture("world", *values).fill) > 0.75


@pytest.mark.parametrize(("em", "is_fault"), [(20.0, True), (36.7, False), (50.0, True)])
def test_a_class_reads_capitals_of_2_2_to_3_percent_of_the_screen(
    em: float, is_fault: bool
) -> None:
    base = picture("world", "view.names=eye")
    (eye,) = base.labels
    found = base._replace(labels=(replace_em(eye, em),))
    assert ("letters" in kinds(found, 1080)) == is_fault
    assert "letters" not in kinds(found)


def replace_em(label: PlacedText, em: float) -> PlacedText:
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


@pytest.mark.undrawn
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
def test_the_sides_of_the_window_are_named_with_their_numbers(kind: str, values: set[str]) -> None:
    window = "lens.left=-1", "lens.right=3", "lens.bottom=-1.125", "lens.top=1.125"
    state = f"lens.kind={kind}", *window, "view.names=l,r,b,t"
    found = picture("world", *state)
    assert {each.text for each in found.labels} == values and not found.cut
    in_000 = picture("world", *state, "view.letters=000")
    assert "x_max = 3" in {each.text for each in in_000.labels}
    assert {"l", "t"} <= nameable("world", state_of(*state), load("letter-f"))
    free = state_of("lens.kind=matrix")
    assert not {"l", "t"} & nameable("world", free, load("letter-f"))


def test_a_side_that_proportions_move_is_named_with_both_numbers() -> None:
    """With the number of the control too; k = (h/w (r - l) - (t - b))/2 = 1 in a square picture."""
    window = "lens.left=-2", "lens.right=2", "lens.bottom=-1", "lens.top=1", "lens.keep=x"
    state = "lens.kind=frustum", *window, "image.width=720", "image.height=720"
    found = picture("world", *state, "view.names=l,r,b,t")
    sides = {"l = −2", "r = 2", "b = −1 → −2", "t = 1 → 2"}
    assert {each.text for each in found.labels} == sides and not found.cut
    in_000 = picture("world", *state, "view.names=b,t", "view.letters=000")
    sides = {"y_min = −1, k = 1, y_1 = −2", "y_max = 1, k = 1, y_2 = 2"}
    assert {each.text for each in in_000.labels} == sides and not in_000.cut


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


def test_the_named_axes_of_a_moved_object_are_in_the_picture() -> None:
    turned = "object.translate=6,0,0", "object.rotate_deg=0,0,90"
    found = picture("world", *turned, "view.names=x,y,z", "view.layers=camera,frustum,near-picture")
    assert {each.text for each in found.labels} == {"x", "y", "z"} and not found.left_out


def test_the_view_frames_nothing_that_it_hides() -> None:
    """The scene names the eye and both planes."""
    wide, high = picture("world", "view.layers=camera,frustum,near-picture").fill
    assert max(wide, high) > 0.75 and not picture("world").is_empty


@pytest.mark.parametrize("stage", ["world", "view"])
@pytest.mark.parametrize("lens", ["lens.far=7", "lens.far=60"])
def test_the_first_stages_fill_their_pane(stage: str, lens: str) -> None:
    found = picture("ndc", f"view.stage={stage}", "view.names=near,far", lens)
    assert max(found.fill) > 0.75 and not found.left_out and not found.cut
