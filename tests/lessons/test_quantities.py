"""The names of formulas: each against the model, mpmath or a number by hand."""

import math

import pytest
from mpmath import atan, mp, mpf, pi, tan

from app.document.document import Document
from app.document.settings import set_values
from app.lessons.course import scene_of
from app.lessons.quantities import Condition, NotThere, Quantities, reading_name
from app.model.formula import parse
from app.model.refusal import Refusal
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import load


def known(*values: str, scene: str = "letter-f", before: Quantities | None = None) -> Quantities:
    opened = load(scene)
    document = set_values(Document(scene, opened.start), values)
    return Quantities(document, lambda: scene_of(document), before=before)


def value(text: str, of: Quantities) -> float:
    return of.value(parse(text))


def test_the_point_that_the_teaching_notes_reckon_with() -> None:
    """TEACHING section 2, P: (1, 1, -5) in view space, n 1, f 9, fov 60, 16:9, d 2."""
    of = known(
        "camera.eye=0,0,0", "camera.target=0,0,-1", "lens.fov_y_deg=60", "lens.near=1",
        "lens.far=9", "view.probes=1,1,-5,3,0,-4", "image.width=1280", "image.height=720",
    )  # fmt: skip
    assert value("clip_from_view(2,2)", of) == -1.25
    assert value("clip_from_view(2,3)", of) == -2.25
    assert value("clip_from_view(3,2)", of) == -1.0
    mp.dps = 30
    assert value("clip_from_view(0,0)", of) == pytest.approx(
        float(1 / tan(pi / 6) / (mpf(16) / 9)), rel=1e-15
    )
    assert value("fov_x", of) == pytest.approx(
        float(2 * atan(mpf(16) / 9 * tan(pi / 6)) * 180 / pi), rel=1e-14
    )
    assert value("ndc_z", of) == pytest.approx(0.8, rel=1e-15)
    assert value("ndc_y", of) == pytest.approx(math.sqrt(3.0) / 5.0, rel=1e-15)
    assert value("image_y", of) == pytest.approx(360.0 * (1.0 - math.sqrt(3.0) / 5.0), rel=1e-14)
    assert (value("view_x", of), value("view_z", of), value("clip_w", of)) == (1.0, -5.0, 5.0)
    assert value("clip_w(2)", of) == 4.0
    assert value("world_x(2)", of) == 3.0
    assert value("image_depth", of) == pytest.approx(0.9, rel=1e-15)
    assert (value("near", of), value("far", of), value("aspect", of)) == (1.0, 9.0, 16 / 9)
    assert value("focal_e", of) == pytest.approx(float(1 / (mpf(16) / 9 * tan(pi / 6))), rel=1e-14)


def test_the_camera_frame_of_the_teaching_notes() -> None:
    """TEACHING section 2, C: eye (1, 2, 2), target 0, up y."""
    of = known("camera.eye=1,2,2", "camera.target=0,0,0", "lens.near=1")
    assert value("n_y", of) == pytest.approx(2 / 3)
    assert value("v_y", of) == pytest.approx(math.sqrt(5.0) / 3.0)
    assert value("u_x", of) == pytest.approx(2.0 / math.sqrt(5.0))
    assert value("view_from_world(2,3)", of) == -3.0
    assert (value("distance", of), value("eye_z", of), value("target_y", of)) == (3.0, 2.0, 0.0)
    assert value("elevation", of) == pytest.approx(math.degrees(math.asin(2 / 3)))


def test_the_object_its_matrix_and_its_coordinates() -> None:
    of = known("object.translate=3,0,0", "object.rotate_deg=0,0,90", "view.probes=3,1,0")
    assert value("world_from_object(1,0)", of) == 1.0
    assert (value("move_x", of), value("turn_z", of), value("size_y", of)) == (3.0, 90.0, 1.0)
    assert value("object_x", of) == pytest.approx(1.0)
    assert value("object_y", of) == pytest.approx(0.0, abs=1e-15)


def test_functions_take_degrees_and_are_exact_where_it_matters() -> None:
    of = known()
    for text, exact in (
        ("sin(180)", 0.0), ("cos(90)", 0.0), ("cos(270)", 0.0), ("sin(90)", 1.0), ("tan(45)", 1.0),
        ("cot(45)", 1.0), ("atan(1)", 45.0), ("cos(180)", -1.0), ("sin(-90)", -1.0),
        ("acos(0)", 90.0), ("sqrt(9)", 3.0), ("abs(-2)", 2.0), ("min(3, 1, 2)", 1.0),
        ("max(1, 2)", 2.0), ("-2^2", -4.0),
    ):  # fmt: skip
        assert value(text, of) == pytest.approx(exact, abs=1e-300, rel=3e-16), text
    for angle in (-725.0, -91.0, -30.0, 1e-9, 17.0, 123.0, 300.0):
        assert value(f"sin({angle:f})", of) == pytest.approx(
            math.sin(math.radians(float(f"{angle:f}"))), rel=1e-9, abs=1e-12
        )
        assert value(f"cos({angle:f})", of) == pytest.approx(
            math.cos(math.radians(float(f"{angle:f}"))), rel=1e-9, abs=1e-12
        )


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("nearr", "uses an unknown name, nearr; the nearest is near"),
        ("eval(1)", "uses an unknown function or matrix, eval"),
        ("__class__", "which no formula may contain"),
        ("1/0", "divides by zero"),
        ("1/(near - near)", "divides by zero"),
        ("tan(90)", "divides by zero"),
        ("sqrt(0 - 1)", "not defined for its argument"),
        ("acos(2)", "not defined for its argument"),
        ("sin(1, 2)", "not defined for its argument"),
        ("9999999999^99", "too large"),
        ("clip_from_view(4, 0)", "asks for a part that clip_from_view does not have"),
        ("clip_from_view(0.5, 0)", "asks for a part that clip_from_view does not have"),
        ("clip_from_view(1)", "asks for a part that clip_from_view does not have"),
        ("clip_from_view", "asks for a part that clip_from_view does not have"),
        ("near(1)", "asks for a part that near does not have"),
        ("reading_nothing", "uses an unknown name, nothing"),
        ("settings_distance", "uses an unknown name, settings_distance"),
        ("was_near", "uses an unknown name, was_near"),
    ],
)
def test_what_a_formula_may_not_name_gets_one_sentence(text: str, said: str) -> None:
    with pytest.raises(Refusal) as caught:
        value(text, known())
    assert said in str(caught.value)


def test_what_is_not_there_just_now_is_told_from_what_there_is_not() -> None:
    for text, values in (
        ("view_x", ()),
        ("ndc_x(2)", ("view.probes=0,0,0",)),
        ("ndc_x", ("view.probes=12,10,18",)),  # behind the eye
        ("alpha", ()),
        ("fov", ("lens.kind=orthographic",)),
    ):
        with pytest.raises(NotThere):
            value(text, known(*values))
    with pytest.raises(NotThere):
        value("reading_the_same_counted_in_the_picture", known(scene="depth-buffer"))


def test_every_number_of_a_readout_has_its_name() -> None:
    """By their labels; two of one scene never share one."""
    named = 0
    for scene, phenomenon in PHENOMENA.items():
        of = known(scene=scene)
        shown = phenomenon.illustration(
            of.projection, of.document.settings, scene_of(of.document).subject
        )
        names = [reading_name(reading.label) for reading in shown.readings]
        assert len(set(names)) == len(names), scene
        for name, reading in zip(names, shown.readings, strict=True):
            assert name, reading.label
            if isinstance(reading.value, tuple):
                last = len(reading.value) - 1
                assert value(f"reading_{name}({last})", of) == reading.value[last]
            elif isinstance(reading.value, float):
                assert value(f"reading_{name}", of) == reading.value
                named += 1
    assert named > 40
    of = known(scene="similar-triangles")
    assert value("reading_projection_with_1_d(3, 2)", of) == -0.25
    assert value("settings_point_y", of) == 5.0
    assert value("settings_clip", known(scene="planar-shadow")) == 1.0


def test_conditions() -> None:
    of = known("lens.near=2", "view.probes=1,2,3", before=known("lens.near=1"))

    def holds(text: str) -> bool:
        return Condition.read(text).holds(of)

    for text in (
        "near = 2*was_near", "near = 2.019", "near - 2 = 0.009", "near > was_near", "1 <= 1",
        "infinity = infinity", "lens.kind = perspective", "scene = letter-f", "depth = opengl",
        "view.stage = 4.0", "mesh = ", "settings.none = ", "camera.eye = ", "near != 2.05",
        "near ≠ 3", "lens.kind != frustum", "infinity != 1",
    ):  # fmt: skip
        assert holds(text), text
    for text in (
        "near = 2.05", "near - 2 = 0.02", "near ≥ 3", "lens.kind = frustum", "depth = direct3d",
        "near != 2.019", "infinity = 1", "infinity != infinity", "lens.kind ≠ perspective",
        "view_x(2) > 0", "view_x(2) != 0",  # there is no second probe
    ):  # fmt: skip
        assert not holds(text), text
    shadow = known("settings.clip=false", scene="planar-shadow")
    assert Condition.read("settings.clip = false").holds(shadow)
    for text in ("near", "near = 1 = 2", "near == 2", "= 3", "near ! = 2", "near !== 2"):
        with pytest.raises(Refusal):
            Condition.read(text)
    with pytest.raises(Refusal, match="divides by zero"):
        holds("1/0 = 1")
