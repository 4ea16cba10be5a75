"""Films: labels that keep their places, values that are shown, and how values change."""

import math
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.document.document import Document
from app.document.settings import set_values
from app.document.sweeping import order, parse_sweeps, swept
from app.drawings.figure import Figure
from app.drawings.film import shown_values, steady, still
from app.drawings.film_labels import Wanted, placed_in_film
from app.drawings.label import LabelActor
from app.drawings.label_placement import Ground, Wish, around
from app.drawings.style import LIGHT
from app.drawings.vectors import TextShape, box_of
from app.model.refusal import Refusal
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import load

EM, SIZE = 10.0, (20.0, 10.0)


def frame(x: float, *taken: tuple[float, float, float, float]) -> Wanted:
    """One label at a point that moves, and boxes that it must not hide."""
    ground = Ground((0.0, 0.0, 400.0, 200.0), EM)
    ground.taken += taken
    spot = (x, 100.0)
    return Wanted([(Wish("P", SIZE, [spot], lambda: around(spot, SIZE, EM)),
                    around(spot, SIZE, EM))], ground)  # fmt: skip


def test_a_label_has_a_side_that_stays_free_and_fades_where_it_has_to_leave() -> None:
    """A wall covers what is right of the point, which at last comes to the wall."""
    wall = (200.0, 0.0, 240.0, 200.0)
    frames = [frame(100.0 + 2.0 * k, *([wall] if k >= 20 else [])) for k in range(60)]
    stands = placed_in_film(frames, is_round=False, fades=True)
    spots, lights = zip(*(stand["P"] for stand in stands), strict=True)
    for k, spot in enumerate(spots):
        right = 100.0 + 2.0 * k + spot.offset[0] + SIZE[0] / 2.0
        assert k < 20 or right <= wall[0], "never on the wall"
    assert len({spot.offset for spot in spots[:50]}) == 1, "from the beginning on this side"
    (change,) = (k for k in range(1, 60) if math.dist(spots[k].offset, spots[k - 1].offset) > 4.0)
    assert lights[change - 2 : change + 2] == pytest.approx((2 / 3, 1 / 3, 1 / 3, 2 / 3))
    assert lights.count(1.0) == 56
    assert all(s["P"][1] == 1.0 for s in placed_in_film(frames, is_round=False, fades=False))


def test_of_a_round_film_the_first_frame_follows_the_last() -> None:
    """The side that is free at the end costs more at the beginning, and is kept all the same."""
    wall = (110.0, 0.0, 400.0, 200.0)
    frames = [frame(100.0, *([wall] if k >= 20 else [])) for k in range(24)]
    (first, *_, last) = placed_in_film(frames, is_round=True, fades=True)
    assert first["P"][0] == last["P"][0]


def test_a_label_stands_still_beside_a_point_that_jumps_to_and_fro() -> None:
    places = [100.0 + 16.0 * (k % 2) for k in range(12)]
    stands = placed_in_film([frame(x) for x in places], is_round=False, fades=True)
    assert (
        np.ptp([x + stand["P"][0].offset[0] for x, stand in zip(places, stands, strict=True)])
        < 1e-9
    )


def test_where_words_would_cover_something_in_many_frames_their_letter_stands_alone() -> None:
    figures = [
        Figure(state, load("letter-f"), ("world", "image"), width=330.0, text_pt=8.0 / 3.0)
        for state in (
            set_values(Document(), values)
            for values in swept(parse_sweeps(["lens.fov_y_deg=20:60"]), Document(), 6)
        )
    ]
    film = steady(still(figures))
    for each in film:
        spot, light = each.labels[0]["near"]
        assert spot.brief and light == 1.0
    texts = [shape.written.text for shape in film[0].shapes()[1] if isinstance(shape, TextShape)]
    assert "n" in texts and "near n = 5" not in texts and "far f = 12.5" in texts


def test_a_letter_alone_has_its_own_size_also_beside_words_of_whole_pixels() -> None:
    spot, letter = (100.0, 100.0), (7.5, 9.5)
    wish = Wish("n", (40, 10), [spot], lambda: around(spot, (40, 10), EM), 0.0,
                (letter, lambda: around(spot, letter, EM)))  # fmt: skip
    wish, places = wish.choices(Ground((0.0, 0.0, 400.0, 200.0), EM))
    assert places.brief is not None
    sizes = wish.sizes(places)
    assert {tuple(size) for size in sizes.tolist()} == {(40.0, 10.0), letter}
    ground = Ground((80.0, 80.0, 115.0, 120.0), EM)  # words have no room
    (stand, _) = placed_in_film([Wanted([(wish, places)], ground)] * 2, is_round=False, fades=True)
    kept, _ = stand["n"]
    assert kept.brief and kept.offset[0] == pytest.approx(
        places.centres[places.brief][0][0] - 100.0
    )


def labels_of(figure: Figure) -> dict[Any, tuple[float, float, float]]:
    """Where the labels of a figure stand, in ems, and how visible they are."""
    places: dict[Any, tuple[float, float, float]] = {}

    def seen(drawing: Any, _factor: int) -> None:
        for renderer in drawing.state.canvas.window.GetRenderers():
            for actor in renderer.GetViewProps():
                if isinstance(actor, LabelActor) and actor.GetVisibility():
                    label: Any = actor.label()
                    left, right, low, high = (side / drawing.board.em for side in label.box_px)
                    light = label.written.opacity
                    middle = (left + right) / 2.0, (low + high) / 2.0
                    name = label.text.partition(" =")[0]  # without its value
                    places[drawing.pane, name] = *middle, light

    figure.pixels(seen=seen)
    return places


@pytest.mark.parametrize(
    ("scene", "sweep", "ease"),
    [("letter-f", "lens.near=0.5:8", "log"), ("jitter", "settings.frame=1:24", "linear")],
)
def test_no_label_jumps_in_a_film(scene: str, sweep: str, ease: str) -> None:
    """Without fading, by less than an em between two frames; what it names moves by less, too."""
    start = PHENOMENA[scene].start if scene in PHENOMENA else load(scene).start
    document = Document(scene, start)
    states = [
        set_values(document, values) for values in swept(parse_sweeps([sweep]), document, 24, ease)
    ]
    figures = [Figure(state, load(scene), ("world", "image"), (480, 240)) for state in states]
    places = [labels_of(figure) for figure in steady(still(figures))]
    assert any(places)
    for one, other in pairwise(places):
        for key in one.keys() & other.keys():
            if min(one[key][2], other[key][2]) == 1.0:
                assert math.dist(one[key][:2], other[key][:2]) < 1.0, key
        for key in one.keys() ^ other.keys():
            assert (one | other)[key][2] < 1.0, "what comes or goes fades"


def test_frames_of_a_width_are_as_wide_as_asked_and_keep_their_labels() -> None:
    """Each is cropped by itself, so numbered files have such a width; a film has none."""
    document, scene = Document("jitter", PHENOMENA["jitter"].start), load("jitter")
    values = swept(parse_sweeps(["settings.frame=1:24"]), document, 6)
    states = [set_values(document, each) for each in values]
    figures = [Figure(state, scene, ("world",), width=300.0, text_pt=4.0) for state in states]
    placed = steady(still(figures))
    assert all(each.labels for each in placed)
    offsets = [{name: spot.offset for name, (spot, _) in each.labels[0].items()} for each in placed]
    for one, other in pairwise(offsets):
        for name in one.keys() & other.keys():
            assert math.dist(one[name], other[name]) < 3.0 * 4.0 * 300.0 / 72.0, name
    for each in placed[::5]:
        assert each.pixels().shape[1] == 300
        (width, height), shapes = replace(each, note="near n = 1").shapes()
        box = box_of(shapes, LIGHT.background)
        assert width == 300.0 and box is not None
        assert box[0] >= -0.5 and box[2] <= 300.5 and box[3] == pytest.approx(height, abs=0.5)


def test_frames_of_a_width_have_one_scale() -> None:
    """Though their labels reach farther out in some, nothing grows or shrinks with them."""
    values = swept(parse_sweeps(["lens.near=1:2.5"]), Document(), 4)
    states = [set_values(Document(), each) for each in values]
    figures = [Figure(state, load("letter-f"), ("world",), width=330.0, text_pt=8.0 / 3.0)
               for state in states]  # fmt: skip
    placed = steady(still(figures))
    assert len({each.full_size for each in placed}) == 1
    places = [labels_of(each)["world", "near n"] for each in placed]
    steps = [math.dist(one[:2], other[:2]) for one, other in pairwise(places)]
    assert max(steps) < 1.2 * min(steps), "as the plane moves"
    boxes = [box_of(each.shapes()[1], LIGHT.background) for each in placed]
    widths = [box[2] - box[0] for box in boxes if box is not None]
    assert len(widths) == 4 and min(widths) > 300.0 and max(widths) == pytest.approx(330.0, abs=1.0)


def test_no_label_jumps_in_frames_of_a_width_over_the_field_of_view() -> None:
    """Without fading, by less than an em, with letters as large as in a column of 84 mm."""
    values = swept(parse_sweeps(["lens.fov_y_deg=20:60"]), Document(), 24)
    states = [set_values(Document(), each) for each in values]
    figures = [Figure(state, load("letter-f"), ("world",), width=300.0, text_pt=2.42)
               for state in states]  # fmt: skip
    places: list[dict[Any, tuple[float, float, float]]] = []
    for each in steady(still(figures)):
        (part,) = each.pictures()
        wanted, here = part.wanted(), dict[Any, tuple[float, float, float]]()
        for wish, _ in wanted.wishes:
            if wish.key in part.labels:
                kept, light = part.labels[wish.key]
                x, y = np.add(wish.spots[kept.spot], kept.offset) / wanted.ground.em
                here[wish.key] = x, y, light
        places.append(here)
    assert all(place.keys() >= {"near", "far"} for place in places)
    for one, other in pairwise(places):
        for key in one.keys() & other.keys():
            if min(one[key][2], other[key][2]) == 1.0:
                assert math.dist(one[key][:2], other[key][:2]) < 1.0, key


def test_values_change_together_in_steps_ratios_or_slowly() -> None:
    document = Document()
    both = parse_sweeps(["lens.near=0.5:8", "camera.eye=6,5,9:-6,5,9"])
    assert swept(both, document, 3) == [
        ["lens.near=0.5", "camera.eye=6,5,9"], ["lens.near=4.25", "camera.eye=0,5,9"],
        ["lens.near=8", "camera.eye=-6,5,9"],
    ]  # fmt: skip
    (near,) = zip(*swept(both[:1], document, 5, "log"), strict=True)
    assert near == tuple(f"lens.near={n}" for n in (0.5, 1, 2, 4, 8))
    (near,) = zip(*swept(both[:1], document, 5, "smooth"), strict=True)
    numbers = [float(each.partition("=")[2]) for each in near]
    true = [0.5 + 7.5 * (1.0 - math.cos(math.pi * k / 4.0)) / 2.0 for k in range(5)]
    assert numbers == pytest.approx(true)
    assert order(4, "back-and-forth") == [0, 1, 2, 1] and order(3, "once") == [0, 1, 2]
    for texts, ease, words in (
        (["camera.eye=6,5,9:-6,5,9"], "log", "camera.eye has no equal ratios from 6 to -6"),
        (["lens.near=1:2"], "slow", "ease = 'slow': must be one of linear, log, smooth"),
        (["lens.near=1:2", "lens.near=1:3"], "linear", "lens.near is swept already"),
    ):
        with pytest.raises(Refusal, match=words):
            swept(parse_sweeps(texts), document, 3, ease)


def test_the_values_stand_below_the_panes_of_each_frame(tmp_path: Path) -> None:
    document = Document()
    states = [set_values(document, [f"lens.near={n}", f"lens.far={20 + n}"]) for n in (1, 2)]
    notes = shown_values(states, load("letter-f"), ["lens.near", "lens.far"])
    assert notes == ["near n = 1, far f = 21", "near n = 2, far f = 22"]
    sweep = parse_sweeps(["camera.eye=6,5,9:-6,5,9"])
    turned = [set_values(document, values) for values in swept(sweep, document, 40)]
    eyes = shown_values(turned, load("letter-f"), ["camera.eye"])
    assert eyes[11:14] == [f"eye e = ({x}, 5, 9)" for x in ("2.615", "2.308", "2")]
    two = load("two-eyes")
    apart = [
        set_values(Document("two-eyes", two.start), [f"settings.separation={s}"]) for s in (1, 2)
    ]
    shown = shown_values(apart, two, ["settings.separation"])
    assert shown == [f"eye separation s = {s}" for s in (1, 2)]
    figure = Figure(states[0], load("letter-f"), ("image",), (320, 240), text_pt=3.0)
    noted = replace(figure, note=notes[0])
    pixels, plain = noted.pixels(), figure.pixels()
    assert pixels.shape == plain.shape, "the figure keeps its size"
    line = round(1.5 * 3.0 * 300.0 / 72.0)
    assert (pixels[-line:] < 128).any() and not (pixels[-line : -line + 2] < 128).any()
    svg = noted.svg()
    assert all(f">{part}</tspan>" in svg for part in ("near", "n", "1", "far", "f", "2"))
    assert np.ptp(np.flatnonzero((pixels[-line:] < 128).any(axis=(0, 2)))) > 60
