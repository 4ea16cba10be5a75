"""What a lecturer does to the document by hand, at random: for what must bear anything."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

from app.document.document import Document
from app.document.view import FIXED, LAYERS, PANES, STAGES, View
from app.model.projection import DEPTH_RANGES, LENSES
from app.model.refusal import Refusal
from app.picking.picking import Probe
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.settings import Setting


def a_setting(rng: random.Random, setting: Setting) -> Any:
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
            placement = replace(projection.placement, rotate_deg=(0.0, turn, 0.0))
            return replace(document, projection=replace(projection, placement=placement))
        depth = rng.choice(list(DEPTH_RANGES))
        return replace(document, projection=replace(projection, depth=depth))
    except Refusal:
        return document


def a_view(rng: random.Random, *, probes: bool = True) -> View:
    """How a document may be looked at, as far as a state can say it."""
    points = [tuple(rng.uniform(-3.0, 3.0) for _ in range(3)) for _ in range(rng.randrange(3))]
    return View(
        layout=rng.choice(("pictures", "columns")),
        large=rng.choice(("", *PANES)),
        stage=rng.choice((float(rng.randrange(len(STAGES))), rng.uniform(0.0, 5.0))),
        panel=rng.choice((None, "", "matrices", "frame")),
        layers=frozenset(rng.sample(LAYERS, rng.randrange(3))),
        fixed=rng.choice(("", *FIXED)),
        probes=tuple(Probe(n, point=p) for n, p in enumerate(points, 1)) if probes else (),  # type: ignore[arg-type]
    )
