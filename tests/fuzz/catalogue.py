"""One catalogue of random documents, states and points for all tests that draw at random."""

import dataclasses
import json
import math
import random
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from app.document.codec import parse, to_tree
from app.document.document import Document
from app.document.view import FIXED, LAYERS, LAYOUTS, MOST_PROBES, PANELS, PANES, STAGES, View
from app.lecture.camera_frame import STEPS
from app.lecture.letters import LETTERS
from app.model.chain import Chain
from app.model.parameter import Parameter
from app.model.projection import DEPTH_RANGES, LENSES, Array, Camera
from app.model.refusal import Refusal
from app.picking.picking import Probe
from app.scenes.phenomena import PHENOMENA

ENDS = (0.0, -0.0, 5e-324, 1e-300, 1e-205, 1e-200, 1e-100, 1e-9, 0.5, 1.0, 90.0, 180.0, 1e9, 1e90,
        1e100, 1e101, 1e308)  # fmt: skip
ODDITIES = (None, True, "inf", "nan", "1", "", [], {}, [1, 2, 3], 10**400, -1, 0, 7)
PLAIN_SCENES = ("letter-f", "cube", "posts")
"""Scenes without settings, which bear every camera."""


# --------------------------------------------------------------------------- documents


def a_size(rng: random.Random) -> float:
    """A number anywhere in the range of float64, mostly an ordinary one."""
    if rng.random() < 0.1:
        return rng.choice(ENDS)
    if rng.random() < 0.05:
        return rng.choice((1e-204, 1.1e-200, 1e-193, 1e99, 9.9e99))  # just allowed
    reach = rng.choice((1.0, 1.0, 3.0, 12.0, 100.0, 210.0))
    return float(10.0 ** rng.uniform(-reach, min(reach, 100.0)))


def a_number(rng: random.Random) -> float:
    return rng.choice((-1.0, 1.0)) * a_size(rng)


def an_interval(rng: random.Random, low: float) -> tuple[float, object]:
    kind = rng.random()
    if kind < 0.05:
        return low, rng.choice((low, -low, math.nextafter(low, math.inf), a_number(rng)))
    if kind < 0.5:
        return low, low + abs(low) * 10.0 ** rng.uniform(-16.0, 3.0)
    return low, low + a_size(rng)


def at_the_ends(rng: random.Random) -> dict[str, Any]:
    """A lens whose numbers are all among the smallest or largest allowed."""
    kind = rng.choice(("frustum", "orthographic", "oblique"))
    small = {"frustum": (1e-290, 1e-204), "orthographic": (1.1e-200,), "oblique": (1.1e-194,)}
    lens: dict[str, Any] = {"kind": kind, "keep": rng.choice(("stretch", "x", "y"))}
    lens["near"] = rng.choice((1e-205, 1e-90, 1e90)) if kind == "frustum" else -1e100
    lens["far"] = rng.choice((1e100, lens["near"] + 2e-205, lens["near"] * 1.5))
    for low, high in (("left", "right"), ("bottom", "top")):
        lens[high] = rng.choice((1e-190, 1e-105, 1e-5, 1e90, 1e100, *small[kind]))
        lens[low] = rng.choice((-lens[high], 0.0, lens[high] * (1.0 - 1e-15)))
    if kind == "oblique":
        lens["alpha_deg"], lens["beta_deg"] = rng.choice((1e-4, 90.0, 179.9999)), 6e-5
    return lens


def a_matrix(rng: random.Random) -> list[list[float]]:
    """Any cells, or a projection with one cell changed; a few are singular."""
    cells = np.array([1.5, 0, 0.1, 0, 0, 2, 0, 0, 0, 0, -1.1, -2.1, 0, 0, -1, 0]).reshape(4, 4)
    if rng.random() < 0.5:
        cells[rng.randrange(4), rng.randrange(4)] += rng.choice((0.5, -0.25, 1.0))
    else:
        cells = np.array([[round(rng.gauss(0, 1), 2) for _ in range(4)] for _ in range(4)])
    if rng.random() < 0.1:
        cells[2] = cells[3]
    return cells.tolist()  # type: ignore[no-any-return]


def a_lens(rng: random.Random, kind: str) -> dict[str, Any]:
    """The fields of a lens of a kind: what the class declares decides which."""
    lens: dict[str, Any] = {"kind": kind}
    names = [field.name for field in dataclasses.fields(LENSES[kind])]
    if "clip_from_view" in names:
        return lens | {"clip_from_view": a_matrix(rng)}
    near = a_size(rng) if LENSES[kind].central else a_number(rng)
    lens["near"], lens["far"] = an_interval(rng, near)
    if rng.random() < 0.2:
        lens["far"] = "inf"
    if "left" in names:
        for low, high in (("left", "right"), ("bottom", "top")):
            if rng.random() < 0.5:  # about the axis, as most are
                lens[high] = a_size(rng)
                lens[low] = -lens[high] * rng.choice((1.0, rng.random()))
            else:
                lens[low], lens[high] = an_interval(rng, a_number(rng))
        lens["keep"] = rng.choice(("stretch", "x", "y"))
    for name in sorted(set(names) - set(lens)):
        angles = rng.uniform(0, 180), a_size(rng), 180.0 - a_size(rng), 90.0
        lens[name] = rng.choice(angles) if name.endswith("_deg") else a_number(rng)
    return lens


def a_tree(rng: random.Random) -> dict[str, Any]:
    """A document with any lens: often valid, sometimes at the limits, sometimes damaged."""
    lens = a_lens(rng, rng.choice(list(LENSES)))
    if rng.random() < 0.2:
        lens = at_the_ends(rng)
    vectors = {key: [a_number(rng) for _ in range(3)] for key in ("eye", "target", "up")}
    if rng.random() < 0.1:
        vectors["eye"] = [rng.choice((-1e100, 1e100)) for _ in range(3)]
    elif rng.random() < 0.3:
        vectors["eye"] = [0.0, 0.0, a_size(rng)]
    if rng.random() < 0.7:
        vectors["up"] = [rng.uniform(-1.0, 1.0) for _ in range(3)]
    elif rng.random() < 0.3:  # up near the view direction
        turn = a_size(rng)
        vectors["up"] = [
            e - t + turn for e, t in zip(vectors["eye"], vectors["target"], strict=True)
        ]
    tree = {
        "format": "frustum-lab", "version": 1, "scene": "letter-f", "camera": vectors,
        "lens": lens, "depth": rng.choice(list(DEPTH_RANGES)),
        "image": {k: rng.choice((1, 640, 1080, 16384)) for k in ("width", "height")},
    }  # fmt: skip
    if rng.random() < 0.1:
        section: dict[str, Any] = rng.choice((tree, vectors, lens, tree["image"]))
        key = rng.choice(list(section))
        section[key] = rng.choice((*ODDITIES, math.nan, math.inf, a_number(rng)))
    return tree


def a_valid_tree(rng: random.Random) -> dict[str, Any]:
    """A document that opens."""
    while True:
        tree = a_tree(rng)
        try:
            parse(json.dumps(tree))
        except Refusal:
            continue
        return tree


def some_points(rng: random.Random, view_from_world: Array | None) -> list[list[float]]:
    """Points in the scene and far away; in front of, at, beside and behind the eye."""
    world = [[rng.uniform(-9, 9) for _ in range(3)] for _ in range(3)]
    world += [[0.0, 0.0, 0.0], [rng.choice((-1, 1)) * 1e12, 3.0, -1e9]]
    if view_from_world is not None and np.linalg.det(view_from_world[:3, :3]):
        unit = float(np.linalg.norm(view_from_world[:3, 3])) or 1.0
        seen = [(0, 0, 0), (0.3, 0.2, 0), (0.1, 0.2, 0.7), (0, 0, -1), (0.2, -0.1, -1),
                (0.05, 0.3, -1e-7), (3, 4, -5e6), (0.1, 0.1, -3)]  # fmt: skip
        ahead = np.array(seen, float) * unit - view_from_world[:3, 3]
        world += np.linalg.solve(view_from_world[:3, :3], ahead.T).T.tolist()
    return [point for point in world if np.isfinite(point).all()]


# --------------------------------------------------------------------------- states


def a_setting(rng: random.Random, setting: Parameter) -> Any:
    """A value that a setting can have."""
    if isinstance(setting.default, bool):
        return rng.random() < 0.5
    if isinstance(setting.default, str):
        return rng.choice(setting.choices)[0]
    if isinstance(setting.default, tuple):
        return tuple(rng.uniform(-5.0, 5.0) for _ in range(3))
    low, high = setting.span or (setting.low, setting.high)
    number = rng.uniform(low, high)
    return float(round(number)) if setting.whole else number


def edited(rng: random.Random, document: Document) -> Document:
    """A document with one thing changed; as it was, where it cannot be changed so."""
    projection = document.projection
    camera, lens = projection.camera, projection.lens
    phenomenon = PHENOMENA.get(document.scene)
    try:
        kind = rng.randrange(7)
        if kind == 0 and phenomenon is not None and phenomenon.settings:
            setting = rng.choice(phenomenon.settings)
            return document.with_settings({setting.name: a_setting(rng, setting)})
        if kind == 1:
            eye = tuple(x + rng.uniform(-2.0, 2.0) for x in camera.eye)
            return replace(
                document, projection=replace(projection, camera=replace(camera, eye=eye))
            )
        if kind == 2:
            near = lens.near * rng.uniform(0.5, 1.5)
            return replace(document, projection=replace(projection, lens=replace(lens, near=near)))
        if kind == 3:
            return replace(document, projection=projection.with_lens(rng.choice(list(LENSES))))
        if kind == 4:
            size = rng.choice((640, 801, 1280)), rng.choice((480, 720, 1000))
            return replace(document, projection=replace(projection, image_size=size))
        if kind == 5 and phenomenon is None:
            turn = rng.choice((0.0, -0.0, 30.0, rng.uniform(-180.0, 180.0)))
            text = rng.choice(
                ("rotate y {0}", "translate 1,0,0; rotate y {0}", "scale 2,1,1; rotate 1,1,0 {0}")
            )
            placement = Chain.read(text.format(repr(turn)))
            return replace(document, projection=replace(projection, placement=placement))
        depth = rng.choice(list(DEPTH_RANGES))
        return replace(document, projection=replace(projection, depth=depth))
    except Refusal:
        return document


def a_view(rng: random.Random, *, probes: bool = True) -> View:
    """How a document may be looked at, as far as a state can say it."""
    points = [tuple(rng.uniform(-3.0, 3.0) for _ in range(3)) for _ in range(rng.randrange(3))]
    return View(
        layout=rng.choice(LAYOUTS),
        large=rng.choice(("", *PANES)),
        stage=rng.choice((float(rng.randrange(len(STAGES))), rng.uniform(0.0, 5.0))),
        panel=rng.choice((None, "", "matrices", "frame")),
        layers=frozenset(rng.sample(LAYERS, rng.randrange(3))),
        fixed=rng.choice(("", *FIXED)),
        probes=tuple(Probe(n, point=p) for n, p in enumerate(points, 1)) if probes else (),  # type: ignore[arg-type]
    )


def settings_in_words(rng: random.Random, scene: str) -> list[str]:
    """``--set`` for every setting of a scene, with a random value."""
    words = []
    for setting in PHENOMENA[scene].settings if scene in PHENOMENA else ():
        value = a_setting(rng, setting)
        parts = value if isinstance(value, tuple) else (value,)
        text = ",".join(f"{p:.4g}" if isinstance(p, float) else str(p).lower() for p in parts)
        words += ["--set", f"{setting.path}={text}"]
    return words


def any_view(rng: random.Random, camera: Camera) -> View:
    """Any view, also what no state can say; its panes have the camera."""
    numbers = sorted(rng.sample(range(1, MOST_PROBES + 1), rng.randrange(MOST_PROBES + 1)))
    place = partial(rng.uniform, -1e100, 1e100)
    probes = [
        Probe(number, point=(place(), place(), place()))
        if rng.random() < 0.5
        else Probe(number, pixel=(rng.uniform(0.0, 16384.0), rng.choice((0.0, 16384.0))))
        for number in numbers
    ]
    return replace(
        a_view(rng), frame_step=rng.choice(STEPS), panel=rng.choice((None, "", *PANELS)),
        letters=rng.choice(LETTERS), probes=tuple(probes),
        names=rng.choice((None, (), ("*",), ("eye", "P'"), tuple("ABCDEFG"))),
        pinned=frozenset(number for number in numbers if rng.random() < 0.3),
        panes=dict.fromkeys(rng.sample((*PANES, "second-screen", ""), rng.randrange(3)), camera),
    )  # fmt: skip


def a_viewed_tree(rng: random.Random, document: Document) -> dict[str, Any]:
    """A document with a view, of version 2 or 1, as JSON has it."""
    tree = to_tree(replace(document, view=any_view(rng, document.projection.camera)))
    if rng.random() < 0.25:
        tree |= {"version": 1, "views": tree.get("view", {}).get("panes", {})}
    return tree
