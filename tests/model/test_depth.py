"""Depth buffers against an 80-digit oracle, their own definitions, and Reed's figures."""

import itertools
import math
from dataclasses import FrozenInstanceError, replace

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.model.depth import FORMATS, MAPPINGS, DepthBuffer
from app.model.limits import Cells
from app.model.projection import (
    DEPTH_RANGES,
    Array,
    Camera,
    FreeMatrix,
    Orthographic,
    Perspective,
    Projection,
)
from app.model.refusal import Refusal
from tests.support.samples import pairwise

IDENTITY: Cells = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))
EPS = float(np.finfo(np.float64).eps)
FIXED = [name for name, kind in FORMATS.items() if kind.float_type is None]

# near, far: usual, absurdly near, infinite, far/near 1e12 and 1 + 1e-6, and the model's own limits
RANGES = [
    (1.0, 30.0),
    (0.1, 1e4),
    (1e-6, 1e6),
    (1e-6, math.inf),
    (1e3, math.inf),
    (3.0, 3.000003),
    (1e-205, 1e100),
    (3e99, 1e100),
]
PARALLEL = [(1.0, 30.0), (-7.0, 5.0), (0.0, 1e-6), (-1e100, 1e100)]


def buffer_of(
    name: str = "fixed24",
    mapping: str = "opengl",
    near: float = 1.0,
    far: float = 30.0,
    parallel: bool = False,
) -> DepthBuffer:
    """A buffer in front of a lens between two planes."""
    lens = Orthographic(near=near, far=far) if parallel else Perspective(near=near, far=far)
    return DepthBuffer(name, mapping, lens)


RANGES_OF = [(mapping, *ends, False) for mapping in MAPPINGS for ends in RANGES
             if mapping != "logarithmic" or ends[1] != math.inf]  # fmt: skip
RANGES_OF += [(mapping, *ends, True) for mapping in DEPTH_RANGES for ends in PARALLEL]
BUFFERS = [buffer_of(name, *rest) for name in FORMATS for rest in RANGES_OF]
"""Every format, mapping and range that there is."""
SAMPLE = [
    buffer_of(name, mapping, *ends)
    for name, mapping, ends in pairwise(
        (f, m, tuple(ends)) for f in FORMATS for m, *ends in RANGES_OF
    )
]
"""Each format and each mapping with each range, and each format with each mapping."""


def label(buffer: DepthBuffer) -> str:
    kind = "parallel" if buffer.lens.parallel else "perspective"
    return f"{buffer.format}-{buffer.mapping}-{kind}-{buffer.near:g}-{buffer.far:g}"


def distances(buffer: DepthBuffer, count: int, seed: int = 0) -> Array:
    """Distances between near and far: the ends, close to either, evenly and by magnitude."""
    rng = np.random.default_rng(seed)
    near, far = buffer.near, buffer.far
    if buffer.lens.parallel:
        found = near + rng.uniform(0.0, 1.0, count) * (far - near)
    else:
        top = far if far != math.inf else near * 1e40
        found = np.exp(rng.uniform(math.log(near), math.log(top), count))
        found[::2] = near + rng.uniform(0.0, 1.0, len(found[::2])) * (top - near)
    ends = [near, near + (abs(near) or 1.0) * EPS, far]
    if far != math.inf:
        ends.append(far - abs(far) * EPS)
    return np.clip(np.concatenate([found, ends]), near, far)


# --------------------------------------------------------------------------- the 80-digit oracle


def true_depth(buffer: DepthBuffer, distance: float) -> mpmath.mpf:
    """The table of `app.model.depth` written as A + B/w (lecture 000), at 400 digits.

    Enough for the cancellation of near 1e-205 against far 1e100.
    """
    near, far, w = (mpmath.mpf(number) for number in (buffer.near, buffer.far, distance))
    if buffer.mapping == "logarithmic":
        return mpmath.log(w / near) / mpmath.log(far / near)
    if buffer.lens.parallel:
        standard = (w - near) / (far - near)
    elif buffer.far == math.inf:
        standard = mpmath.mpf(1) - (near / w if distance != math.inf else 0)
    else:
        standard = far / (far - near) - near * far / ((far - near) * w)
    depth = 1 - standard if buffer.mapping == "reversed" else standard
    return depth if abs(depth) > mpmath.mpf(10) ** -350 else mpmath.mpf(0)


def true_distance(buffer: DepthBuffer, depth: mpmath.mpf) -> mpmath.mpf:
    """The inverse of `true_depth`."""
    near, far = mpmath.mpf(buffer.near), mpmath.mpf(buffer.far)
    if buffer.mapping == "logarithmic":
        return near * (far / near) ** depth
    standard = 1 - depth if buffer.mapping == "reversed" else depth
    if buffer.lens.parallel:
        return near + standard * (far - near)
    if buffer.far == math.inf:
        return near / (1 - standard) if standard != 1 else mpmath.inf
    return near * far / (far - standard * (far - near))


def value_of(buffer: DepthBuffer, code: int) -> mpmath.mpf:
    """The depth that a code is, from its definition."""
    kind = FORMATS[buffer.format]
    if kind.float_type is None:
        return mpmath.mpf(code) / kind.largest
    return mpmath.mpf(float(np.array(code, kind.code_type).view(kind.float_type)))


@pytest.fixture(autouse=True)
def many_digits() -> object:
    with mpmath.workdps(400):
        yield


@pytest.mark.parametrize("buffer", BUFFERS[: len(RANGES_OF)], ids=label)
def test_depth_is_right_at_the_extremes(buffer: DepthBuffer) -> None:
    """4 ulp relative, whatever the digits that A + B/w would lose."""
    for distance in distances(buffer, 30):
        true = true_depth(buffer, distance)
        error = abs(mpmath.mpf(float(buffer.depth(distance))) - true)
        assert error <= 4 * EPS * true + mpmath.mpf(5e-324), distance


@pytest.mark.parametrize("mapping", DEPTH_RANGES)
@pytest.mark.parametrize("far", [30.0, math.inf])
def test_depth_is_the_projections_own(mapping: str, far: float) -> None:
    """What `project` prints as depth is what this buffer is given."""
    rng = np.random.default_rng(1)
    w = rng.uniform(1.0, 30.0, 50)
    points = np.column_stack([np.zeros((50, 2)), -w])
    camera = Camera((0, 0, 0), (0, 0, -1))
    for lens in (Perspective(45.0, 1.0, far), Orthographic(near=1.0, far=30.0)):
        trace = Projection(camera, lens, depth=mapping).trace(points)  # type: ignore[arg-type]
        buffer = DepthBuffer("fixed24", mapping, lens)
        assert np.allclose(buffer.depth(w), trace.depth, rtol=4 * EPS, atol=0.0)


@pytest.mark.parametrize("buffer", SAMPLE, ids=label)
def test_the_nearest_code_is_stored(buffer: DepthBuffer) -> None:
    """No neighbour of the code is nearer to the true depth by more than float64 can see."""
    kind = FORMATS[buffer.format]
    for distance in distances(buffer, 12):
        true = true_depth(buffer, distance)
        code = int(buffer.encode(distance))
        assert 0 <= code <= kind.largest
        error = abs(value_of(buffer, code) - true)
        slack = 8 * EPS * true
        if buffer.mapping == "opengl" and kind.float_type is not None:
            slack += mpmath.mpf(2) ** -26  # by way of NDC in float32: half a step of its own
        for other in (code - 1, code + 1):
            if 0 <= other <= kind.largest:
                assert error <= abs(value_of(buffer, other) - true) + 2 * slack


@pytest.mark.parametrize("buffer", SAMPLE, ids=label)
def test_a_code_stands_for_its_own_distance(buffer: DepthBuffer) -> None:
    """Right to 8 ulp of the distance, or of its logarithm's span, from the code's exact depth."""
    kind = FORMATS[buffer.format]
    rng = np.random.default_rng(2)
    codes = rng.integers(0, kind.largest, 12, endpoint=True).tolist()
    codes += [0, 1, 2, kind.largest // 2, kind.largest - 1, kind.largest]
    for code, got in zip(codes, buffer.decode(codes), strict=True):
        true = true_distance(buffer, value_of(buffer, code))
        if true == mpmath.inf:
            assert got == math.inf
            continue
        size = max(abs(buffer.near), abs(buffer.far)) if buffer.lens.parallel else true
        if buffer.mapping == "logarithmic":
            size *= max(1.0, math.log(buffer.far / buffer.near) / 4.0)
        assert abs(mpmath.mpf(float(got)) - true) <= 8 * EPS * size, code


@pytest.mark.parametrize("buffer", SAMPLE, ids=label)
def test_decoding_and_encoding_gives_the_code_back(buffer: DepthBuffer) -> None:
    """Wherever the codes lie farther apart than the distances that float64 has."""
    kind = FORMATS[buffer.format]
    codes = np.unique(np.random.default_rng(3).integers(1, kind.largest, 200))
    lower, middle, upper = (buffer.decode(codes + shift) for shift in (-1, 0, 1))
    with np.errstate(invalid="ignore"):
        apart = np.minimum(np.abs(upper - middle), np.abs(middle - lower))
        size = np.maximum(np.abs(middle), abs(buffer.near)) * (20 if buffer.near < 1e-200 else 1)
        told_apart = apart > 64 * EPS * size
    if buffer.mapping == "opengl" and kind.float_type is not None:
        # NDC's own steps: codes of finer depths are never stored.
        depth = codes.astype(kind.code_type).view(kind.float_type).astype(np.float64)
        told_apart &= np.float32(0.5) * (2.0 * depth - 1.0).astype(np.float32) + 0.5 == depth
    assert (buffer.encode(middle) == codes)[told_apart].all()
    if (buffer.near, buffer.far) == (0.1, 1e4) and buffer.mapping != "opengl":
        assert told_apart.any()


def test_the_ends_are_the_first_and_the_last_code() -> None:
    for buffer in BUFFERS:
        largest = FORMATS[buffer.format].largest
        ends = (largest, 0) if buffer.mapping == "reversed" else (0, largest)
        assert buffer.encode([buffer.near, buffer.far]).tolist() == list(ends), label(buffer)
        back = buffer.decode(list(ends))
        assert back.tolist() == pytest.approx([buffer.near, buffer.far], rel=4 * EPS)


@given(st.floats(1e-9, 1e9), st.floats(1.0 + 1e-12, 1e12), st.booleans())
def test_the_ends_stay_ends_whatever_they_are(near: float, ratio: float, parallel: bool) -> None:
    """No rounding takes a depth past 1, or a decoded distance past a plane."""
    for mapping in DEPTH_RANGES if parallel else MAPPINGS:
        for name, kind in FORMATS.items():
            buffer = buffer_of(name, mapping, near, near * ratio, parallel)
            low, high = sorted(buffer.depth([buffer.near, buffer.far]).tolist())
            assert low == 0.0 and 1.0 - 4 * EPS <= high <= 1.0
            back = buffer.decode([0, 1, kind.largest - 1, kind.largest])
            assert ((back >= buffer.near) & (back <= buffer.far)).all()


def test_codes_are_of_the_smallest_type_and_keep_the_shape() -> None:
    w = np.linspace(1.0, 30.0, 6).reshape(2, 3)
    for name, kind in FORMATS.items():
        codes = buffer_of(name, "direct3d").encode(w)
        assert codes.shape == (2, 3) and codes.dtype == kind.code_type
        assert codes.dtype.itemsize * 8 == {8: 8, 16: 16, 24: 32, 32: 32}[kind.bits]
    # 15 of 1..30: depth = 30/29 * 14/15 = 28/29; as float32 0x3F772C23, as 24 bits 16198690,
    # as 8 bits 246.2.
    at_15 = {name: int(buffer_of(name, "direct3d").encode(15.0)) for name in FORMATS}
    assert at_15["fixed24"] == round(28 / 29 * (2**24 - 1)) == 16198690
    assert at_15["float32"] == 0x3F772C23
    assert at_15["fixed8"] == 246


@given(
    st.sampled_from(sorted(FORMATS)),
    st.sampled_from(MAPPINGS),
    st.floats(1e-6, 1e6),
    st.floats(1.0 + 1e-6, 1e12),
    st.integers(0, 2**32 - 1),
)
def test_what_is_farther_is_never_stored_as_nearer(
    name: str, mapping: str, near: float, ratio: float, seed: int
) -> None:
    buffer = buffer_of(name, mapping, near, near * ratio)
    codes = buffer.encode(np.sort(distances(buffer, 100, seed))).astype(np.int64)
    steps = np.diff(codes)
    assert (steps <= 0).all() if mapping == "reversed" else (steps >= 0).all()


# --------------------------------------------------------------------------- the gap


@pytest.mark.parametrize("buffer", SAMPLE, ids=label)
def test_the_gap_is_one_step_of_the_depth(buffer: DepthBuffer) -> None:
    """Surfaces that far apart are a step of the format apart in depth, at 400 digits."""
    kind = FORMATS[buffer.format]
    w = distances(buffer, 12)
    for distance, gap in zip(w, buffer.gap(w), strict=True):
        here = true_depth(buffer, distance)
        if gap == math.inf:  # even the far plane is less than the largest step near it away
            least = abs(true_depth(buffer, buffer.far) - here)
        else:
            least = abs(true_depth(buffer, mpmath.mpf(distance) + mpmath.mpf(gap)) - here)
        if kind.float_type is None:
            low = high = mpmath.mpf(1) / kind.largest
        else:
            code = int(buffer.encode(distance))
            around = [
                value_of(buffer, min(max(code + shift, 0), kind.largest)) for shift in range(-2, 3)
            ]
            steps = [b - a for a, b in itertools.pairwise(around) if b != a]
            low, high = min(steps), 2 * max(steps)
            if buffer.mapping == "opengl":
                high += mpmath.mpf(2) ** -23
        if gap == math.inf:
            assert least <= high * (1 + 1e-6)
        else:
            assert low * (1 - 1e-6) <= least <= high * (1 + 1e-6)


@pytest.mark.parametrize(
    ("name", "mapping", "far"), pairwise(itertools.product(FORMATS, MAPPINGS, (1e4, math.inf)))
)
def test_pairs_farther_apart_than_the_gap_are_told_apart(
    name: str, mapping: str, far: float
) -> None:
    """All of them; of pairs half as far apart, some are not."""
    if mapping == "logarithmic" and far == math.inf:
        far = 1e7
    buffer = buffer_of(name, mapping, 0.1, far)
    w = np.exp(np.random.default_rng(5).uniform(math.log(0.1), math.log(9e3), 20_000))
    gap = buffer.gap(w)
    held = np.isfinite(gap) & (gap > 1e-9 * w)
    w, gap = w[held], gap[held]
    assert len(w) > 1000
    behind = np.minimum(w + gap * (1.0 + 1e-5), far)
    assert buffer.collapsed_share(w, behind) == 0.0
    half = np.minimum(w + gap * 0.5, far)
    assert 0.1 < buffer.collapsed_share(w, half) < 0.7


def test_the_gap_of_float32_reversed_is_a_share_of_the_distance() -> None:
    """2^-24 to 2^-23 of it, from near to 1e30 near, far plane at infinity (Reed)."""
    for near in (1e-6, 0.1, 1e3):
        buffer = buffer_of("float32", "reversed", near, math.inf)
        z = near * np.geomspace(1.0, 1e30, 500)
        share = buffer.gap(z) / z
        assert (share >= 2.0**-24 * (1 - 1e-9)).all() and (share <= 2.0**-23 * (1 + 1e-6)).all()
    # Just below a power of two what lies behind has the finer steps, and they are what counts.
    below_half = buffer_of("float32", "reversed", 1.0, math.inf).gap(2.0 * (1.0 + 2.0**-26))
    assert below_half == pytest.approx(2.0**-23, rel=1e-6)
    # Past float32's normal numbers the steps stay and the share grows, to nothing at all.
    z = 0.1 * np.array([1e40, 1e44, 1e46])
    beyond = buffer_of("float32", "reversed", 0.1, math.inf).gap(z)
    assert 2.0**-20 < beyond[0] / z[0] < 1e-3 and beyond[2] == math.inf


def test_the_gap_in_the_middle_of_a_linear_buffer() -> None:
    """16 bits over 1..30 in a parallel lens: 29/65535 everywhere; near the far plane none."""
    buffer = buffer_of("fixed16", "opengl", 1.0, 30.0, parallel=True)
    assert buffer.gap([1.0, 15.0, 29.9]).tolist() == pytest.approx([29 / 65535] * 3, rel=1e-15)
    assert buffer.gap([29.9999, 30.0]).tolist() == [math.inf, math.inf]


def test_the_gap_where_one_code_is_all_there_is() -> None:
    """16 bits, near 1e-6, infinite: beyond 65535 near nothing more is told apart."""
    buffer = buffer_of("fixed16", "direct3d", 1e-6, math.inf)
    assert buffer.gap(65534e-6) < math.inf == buffer.gap(65536e-6)
    assert buffer.gap(math.inf) == math.inf
    assert buffer_of("float32", "reversed", 1e-6, math.inf).gap(math.inf) == math.inf


# --------------------------------------------------------------------------- collapsing pairs

# Reed, "Depth Precision Visualized" (2015), and his simulator: near 0.1, far 1e4, 10 000 pairs of
# neighbours among 10 001 distances evenly spaced from near to far. His 77.2 % for the standard
# range count float32's rounding on the way as well; the reversed range has none that shows.
REED = np.linspace(0.1, 1e4, 10_001)


@pytest.mark.parametrize(
    ("name", "mapping", "percent"), [("fixed24", "reversed", 75.8), ("float32", "reversed", 0.0)]
)
def test_reeds_figures(name: str, mapping: str, percent: float) -> None:
    buffer = buffer_of(name, mapping, 0.1, 1e4)
    counted = 100.0 * buffer.collapsed_share(REED[:-1], REED[1:])
    assert counted == pytest.approx(percent, abs=0.05)


def test_reeds_figures_of_the_formats_alone() -> None:
    """What the formats alone cost, by hand 75.77 %.

    A pair is 1 apart and a step z^2/s wide, s = 0.1 * 2^24: the integral of 1 - s/z^2 from
    sqrt(s) = 1295 to 1e4, over 1e4, is 0.7577.
    """
    for name in ("fixed24", "float32"):
        buffer = buffer_of(name, "direct3d", 0.1, 1e4)
        for share in (buffer.collapsed_share, buffer.predicted_collapsed_share):
            assert share(REED[:-1], REED[1:]) == pytest.approx(0.7577, abs=2e-4)


@pytest.mark.parametrize(
    ("name", "mapping", "scale"), pairwise(itertools.product(FORMATS, MAPPINGS, (0.2, 0.7, 1.2)))
)
def test_the_predicted_share_is_the_counted_one(name: str, mapping: str, scale: float) -> None:
    """40 000 pairs, apart by about the gap: 1 point, 4 deviations of the count."""
    buffer = buffer_of(name, mapping, 0.5, 800.0)
    rng = np.random.default_rng(6)
    w = np.exp(rng.uniform(math.log(0.6), math.log(400.0), 40_000))
    gap = buffer.gap(w)
    w, gap = w[np.isfinite(gap)], gap[np.isfinite(gap)]
    other = np.minimum(w + gap * scale * rng.uniform(0.0, 2.0, len(w)), 800.0)
    counted = buffer.collapsed_share(w, other)
    predicted = buffer.predicted_collapsed_share(w, other)
    assert counted == pytest.approx(predicted, abs=0.01)
    assert 0.02 < counted < 0.98


def test_no_pairs_collapse_to_nothing() -> None:
    buffer = DepthBuffer()
    assert buffer.collapsed_share([], []) == buffer.predicted_collapsed_share([], []) == 0.0
    assert buffer.collapsed_share(5.0, 5.0) == buffer.predicted_collapsed_share(5.0, 5.0) == 1.0


def test_the_minus_1_to_1_range_loses_a_float_buffers_fine_steps() -> None:
    """At the near plane NDC is -1, whose neighbour is 2^-24 away: 2^-25 in depth."""
    opengl = buffer_of("float32", "opengl", 1.0, 30.0)
    direct3d = replace(opengl, mapping="direct3d")
    step = 2.0**-25 * 29 / 30
    assert opengl.gap(1.0) == pytest.approx(step, rel=1e-6)
    assert direct3d.gap(1.0) < 1e-40
    pair = 1.0 + np.array([0.1, 0.4]) * step
    assert opengl.collapsed_share(*pair) == 1.0 and direct3d.collapsed_share(*pair) == 0.0


# --------------------------------------------------------------------------- what is refused


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"format": "fixed12"}, "format"),
        ({"mapping": "vulkan"}, "mapping"),
        ({"mapping": ["opengl"]}, "mapping"),
        ({"lens": Perspective(far=math.inf), "mapping": "logarithmic"}, "far"),
        ({"lens": Orthographic(), "mapping": "logarithmic"}, "mapping"),
        ({"lens": FreeMatrix(IDENTITY)}, "lens.kind"),
    ],
)
def test_an_impossible_buffer_is_named(change: dict[str, object], field: str) -> None:
    with pytest.raises(Refusal) as error:
        replace(DepthBuffer(), **change)  # type: ignore[arg-type]
    assert error.value.field == field


@pytest.mark.parametrize(
    ("distance", "message"),
    [
        (0.999, r"distance = 0.999: must be at least 1"),
        (math.inf, r"distance = inf: must be at most 30"),
        (math.nan, r"distance = nan: must be a finite number"),
        ("far", r"distance = 'far': must be a finite number"),
        ([[1.0], [1.0, 2.0]], r"distance = .*: must be a finite number"),
    ],
)
def test_a_distance_that_no_buffer_holds_is_named(distance: object, message: str) -> None:
    buffer = DepthBuffer()
    for ask in (buffer.depth, buffer.encode, buffer.gap):
        with pytest.raises(Refusal, match=message):
            ask(distance)  # type: ignore[operator]
    with pytest.raises(Refusal, match=message):
        buffer.predicted_collapsed_share(2.0, distance)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", FORMATS)
def test_a_code_that_is_none_is_named(name: str) -> None:
    buffer = buffer_of(name)
    largest = FORMATS[name].largest
    for code in (-1, largest + 1, 0.5, True):
        with pytest.raises(Refusal, match=rf"one of the whole numbers from 0 to {largest}"):
            buffer.decode(code)


def test_a_buffer_is_a_value() -> None:
    buffer = DepthBuffer(lens=Perspective(near=np.float32(0.5), far=3))
    assert (buffer.near, buffer.far) == (0.5, 3.0) and type(buffer.far) is float
    assert buffer == buffer_of(near=0.5, far=3.0) and hash(buffer) == hash(replace(buffer))
    with pytest.raises(FrozenInstanceError):
        buffer.mapping = "reversed"  # type: ignore[misc]
