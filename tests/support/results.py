"""What a measurement may bring."""

import math

from app.measure.results import ChartPoint, ErrorCurve, Measurements, Sweep, Trade


def choice(name: str, cost: float | None, error: float | None, note: str = "") -> ChartPoint:
    return ChartPoint(name, cost, cost, error, note=note, use={"rung": name})


TRADE = Trade(
    "arithmetic", "ns", "px",
    (
        choice("fast", 1.0, 1.0), choice("bad", 5.0, 2.0), choice("good", 10.0, 1e-6),
        choice("right", 100.0, 0.0), choice("endless", 2.0, math.inf),
        choice("absent", None, None, "not installed"),
    ),
    5,
)  # fmt: skip


def sweep(parameter: str, values: tuple[float, ...], curves: dict[str, ErrorCurve]) -> Sweep:
    return Sweep(parameter, "", values, curves)


def curve(errors: tuple[float | None, ...], notes: tuple[str, ...]) -> ErrorCurve:
    return ErrorCurve(errors, errors, errors, errors, notes)


SWEEP = sweep(
    "near", (0.01, 0.1, 1.0, 10.0),
    {
        "float32": curve((None, None, 1e-3, 1e-4), ("returns NaN", "returns NaN", "", "")),
        "VTK": curve((1e-9, 1e-9, 1e-9, 1e-2), ("", "", "", "clamps")),
    },
)  # fmt: skip
RESULTS = Measurements(
    "2026-11-21T08:46:06+00:00", {"system": "Box 7", "cores": "2", "opengl": "softpipe"},
    {"frustum-lab": "1"},
    {
        "scene": "letter-f", "camera": {"eye": [6, 5, 9], "target": [0, 2.25, 0]},
        "lens": {"kind": "perspective", "fov_y_deg": 45},
    },
    (TRADE,), (SWEEP,),
)  # fmt: skip
