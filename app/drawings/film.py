"""A film of figures: where its world stands, its labels and values, and its file."""

import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import reduce
from typing import Any

from app.document.compare import DifferenceWriter, names_in, values_in
from app.document.document import Document
from app.document.files import LARGEST_PICTURE, blamed_on, content_of, write_bytes_atomically
from app.document.naming import seen_from
from app.document.settings import set_values
from app.document.sweeping import checked_speed, order, parse_sweeps, swept
from app.drawings.figure import Figure
from app.lecture.dependence import FIELDS as LETTERS
from app.lecture.letters import in_letters
from app.lessons.text import in_line
from app.model.parameters import TITLES
from app.model.projection import Camera
from app.model.refusal import REFUSALS, Refusal
from app.scenes.phenomena.words import digits_apart, figure
from app.scenes.scene import Scene

_MOST_MOMENTS = 9  # of the states that a view of the world shows
FILMS = (".gif", ".apng", ".webp", ".mp4")


def is_fixed(shown: Figure) -> bool:
    """Whether the world is seen from a viewpoint that moves with the camera."""
    return bool(seen_from(shown.document.view, shown.scene))


def seen_by(shown: Figure, view: Camera) -> Figure:
    """Return a figure whose world is seen from a place."""
    state = shown.document
    panes = state.view.panes | {"world": view}
    return replace(shown, document=replace(state, view=replace(state.view, fixed="", panes=panes)))


def still(figures: Sequence[Figure]) -> list[Figure]:
    """Return figures whose world is seen from one place, as in the window while a value changes."""
    first = figures[0]
    if "world" in first.document.view.panes or "world" not in first.panes or is_fixed(first):
        return list(figures)
    (view,) = standing(first, [each.document for each in figures], [0.0])
    return [seen_by(each, view) for each in figures]


def standing(
    figure: Figure, states: Sequence[Document], turns_deg: Sequence[float]
) -> list[Camera]:
    """Return the views of the world that show all of the states, one for each turn.

    The free view of a figure depends on what it shows, and would jump about. The panes are those of
    the figure, which shows the first state.
    """
    cameras, last = list[list[Camera]](), len(states) - 1
    chosen = sorted({round(last * part / (_MOST_MOMENTS - 1)) for part in range(_MOST_MOMENTS)})
    moments = [
        (state.projection, figure.scene.illustration(state.projection, state.settings))
        for state in map(states.__getitem__, chosen)
    ]

    def seen(drawing: Any, _factor: int) -> None:
        if drawing.pane == "world":
            cameras.append(drawing.views(moments, turns_deg))

    figure.pixels(seen=seen)
    # Compared pictures have a world each.
    return max(cameras, key=lambda views: views[0].distance)


def steady(
    film: Sequence[Figure], noted: Sequence[str] = (), *, is_round: bool = False, fades: bool = True
) -> list[Figure]:
    """Place labels on all figures together; see `film_labels`. The values of `noted` are below."""
    from app.drawings.film_labels import placed_in_film

    if noted:
        notes = shown_values([each.document for each in film], film[0].scene, noted)
        film = [replace(each, note=note) for each, note in zip(film, notes, strict=True)]
    if len(film) < 2 or film[0].panes == ("equation",):
        return list(film)
    if film[0].width is not None:
        film = _in_one_box(film, max(1, len(film) // _MOST_MOMENTS))
    frames = [[part.wanted() for part in each.pictures()] for each in film]
    ems = {part.ground.em for frame in frames for part in frame}
    if len(ems) > 1 or len({each.size_px for each in film}) > 1:
        return list(film)  # some are drawn finer, or larger, than others
    panes = [
        placed_in_film(frame, is_round=is_round, fades=fades) for frame in zip(*frames, strict=True)
    ]
    stands = zip(*panes, strict=True)
    placed = [replace(each, labels=here) for each, here in zip(film, stands, strict=True)]
    return placed if film[0].width is None else _in_one_box(placed)


def _in_one_box(figures: Sequence[Figure], every: int = 1) -> list[Figure]:
    """Return frames of a width in the smallest box of `every` so many: nothing grows or shrinks."""
    first, *others = [*figures[:: len(figures) - 1], *figures[1:-1:every]]  # the ends are widest
    least = reduce(lambda box, each: each.boxed(box), others, first.boxed())
    return [replace(each, size=least.size, text_pt=least.text_pt) for each in figures]


def shown_values(states: Sequence[Document], scene: Scene, paths: Sequence[str]) -> list[str]:
    """Return the values of some paths in each state: ``near n = 4``."""
    letters = states[0].view.letters

    def named(field: str) -> str:
        letter = next((name for name, fields in LETTERS.items() if fields == (field,)), "")
        symbol = in_line(in_letters(f"{{{letter}}}", letters)) if letter else ""
        return f"{TITLES.get(field, field)} {symbol}".strip() + " ="

    settings = () if scene.phenomenon is None else scene.phenomenon.settings
    titles = {each.title for each in settings if not each.choices}

    def said_in(text: str) -> str:
        return in_letters(text, letters) + " =" * (text in titles)

    written = DifferenceWriter(named, said_in, figure)
    held = [each.state for each in states]
    said = [values_in(path, held, settings, written) for path in paths]
    if not said or not all(map(all, said)):
        said = [names_in([""] * len(states), held, settings, written)]
    if len(states) > 1 and not all(said[0]):  # nothing that a picture compares, such as a stage
        numbers: list[Any] = [reduce(getattr, paths[0].split("."), each) for each in states]
        digits = digits_apart(*numbers)
        said = [[f"{paths[0].rpartition('.')[2]} = {number:.{digits}g}" for number in numbers]]
    return [", ".join(parts) for parts in zip(*said, strict=True)]


def sweep_film(
    shown: Figure,
    path: str,
    sweeps: Sequence[str],
    frames: int,
    fps: float,
    ease: str,
    loop: str,
    show_value: bool,
) -> None:
    """Write a film of a figure in which values change; a `Refusal` for what is not possible."""
    if os.path.splitext(path)[1].lower() not in FILMS:
        raise Refusal.saying(REFUSALS["a-film"], path, ", ".join(FILMS))
    if shown.crop or shown.width is not None:
        raise Refusal.saying(REFUSALS["one-size"])
    sequence, speed = order(frames, loop), checked_speed(fps)
    parsed = parse_sweeps([*map(str, sweeps)] or [""])
    values = swept(parsed, shown.document, max(sequence) + 1, ease)
    states = [set_values(shown.document, each) for each in values]
    figures = still([replace(shown, document=state) for state in states])
    noted = [sweep.path for sweep in parsed if show_value]
    with blamed_on(path, REFUSALS["unwritable"]):
        write_film(path, steady(figures, noted), sequence, speed, loop == "once")


def write_film(
    path: str,
    figures: Sequence[Figure],
    order: Sequence[int],
    fps: float,
    once: bool,
    reported: Callable[[Sequence[int]], Iterable[int]] = iter,
) -> None:
    """Write a film whole or not at all; `reported` yields `order` and reports the progress."""
    from app.drawings.moving import encoded, moving

    ending = os.path.splitext(path)[1].lower()
    done: dict[int, bytes] = {}  # there and back, a state is drawn once
    for number in reported(order):
        if number not in done:
            done[number] = encoded(figures[number], ending)
    parts = [done[number] for number in order]
    write_bytes_atomically(path, moving(parts, ending, figures[0].size_px, fps, once))


def write_frames(
    paths: Sequence[str],
    figures: Sequence[Figure],
    order: Sequence[int],
    reported: Callable[[Sequence[int]], Iterable[int]] = iter,
) -> None:
    first: dict[int, str] = {}
    for path, number in zip(paths, reported(order), strict=True):
        if number in first:
            write_bytes_atomically(path, content_of(first[number], LARGEST_PICTURE))
        else:
            first[number] = path
            figures[number].save(path)
