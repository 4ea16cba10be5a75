"""Trade 4, antialiasing and resolution: ms per frame against the visible error.

The image pane's drawing is rendered off screen with each smoothing, and compared with the same
picture at `REFERENCE` x `REFERENCE` samples per pixel.
"""

from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, contextmanager
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from app.drawings import WORDS
from app.drawings.actors import face_actor, identity_camera
from app.drawings.image import ImageDrawing
from app.drawings.off_screen import OffScreen, Pixels, off_screen, pixels_of
from app.drawings.picture_frame import UNFRAMED
from app.drawings.style import LIGHT, WHITE
from app.measure.results import ChartPoint, Trade
from app.measure.run import Watch, timed, unwatched
from app.model.projection import Projection
from app.scenes.scene import Scene

REFERENCE = 4  # sixteen samples per pixel, by far the finest picture here
LARGEST_PX = 640  # longer side of the timed picture, about that of a pane

OTHER_SAMPLES = "this OpenGL gives {0} samples"
SAME_PICTURE = "the same picture"  # follows the names of choices that draw the same picture


class Smoothing(NamedTuple):
    """One way of smoothing.

    - `scale`: drawn pixels per shown pixel, along each side; below 1 the picture is enlarged.
    - `samples`: OpenGL's multisamples; 0 for none.
    - `fxaa`: whether to blur along the edges found in the finished picture (Lottes, 2009).
    """

    name: str
    scale: float = 1.0
    samples: int = 0
    fxaa: bool = False


SMOOTHINGS = (
    Smoothing("none"),
    Smoothing("half resolution", scale=0.5),
    Smoothing("FXAA", fxaa=True),
    Smoothing("MSAA 2", samples=2),
    Smoothing("MSAA 4", samples=4),
    Smoothing("MSAA 8", samples=8),
    Smoothing("supersampling 2 x 2", scale=2.0),
    Smoothing("supersampling 3 x 3", scale=3.0),
)


def measure(
    scene: Scene, projection: Projection, seconds: float = 10.0, watch: Watch = unwatched
) -> Trade:
    """Measure trade 4.

    The cost is ms per frame, which every choice draws, reads back and scales to the screen. The
    error is the root mean square of the pixels' differences, in levels from 0 to 255.
    """
    size = picture_size(projection)
    with ExitStack() as stack:
        with pane(scene, projection, size, Smoothing("", scale=REFERENCE)) as (draw, read):
            reference = _seen(draw, read, REFERENCE, size)[..., :3].astype(np.float64)
        runs: dict[str, Callable[[], Any]] = {}
        choices = []
        for smoothing, note in pictures():
            draw, read = stack.enter_context(pane(scene, projection, size, smoothing))
            seen = partial(_seen, draw, read, smoothing.scale, size)
            runs[smoothing.name] = seen
            difference = seen()[..., :3] - reference
            error, name = float(np.sqrt((difference**2).mean())), smoothing.name
            use, paid = {"smoothing": name}, memory(smoothing)
            choices.append(ChartPoint(name, None, None, error, note=note, use=use, bytes=paid))
        trade = Trade("smoothing", "ms", "levels RMS", tuple(choices), 0)
        return timed(trade, runs, seconds, 1e3, watch)


def _seen(
    draw: Callable[[], None], read: Callable[[], Pixels], scale: float, size: tuple[int, int]
) -> Pixels:
    draw()
    return shown(read(), scale, size)


def pictures() -> list[tuple[Smoothing, str]]:
    """Return those of `SMOOTHINGS` that draw different pictures here, with a note on each.

    This OpenGL may draw several with the same number of samples. Of these, keep the one that
    requests this number, or else the first.
    """
    groups: dict[Smoothing, list[Smoothing]] = {}
    for smoothing in SMOOTHINGS:
        samples = samples_given(smoothing.samples) if smoothing.samples else 1
        drawn = smoothing._replace(name="", samples=0 if samples == 1 else samples)
        groups.setdefault(drawn, []).append(smoothing)
    kept = []
    for drawn, alike in groups.items():
        one = next((each for each in alike if each.samples == drawn.samples), alike[0])
        others = [each.name for each in alike if each is not one]
        as_asked = one.samples == drawn.samples
        notes = [] if as_asked else [OTHER_SAMPLES.format(drawn.samples)]
        kept.append((one, ", ".join(notes + (others and [*others, SAME_PICTURE]))))
    return kept


def memory(smoothing: Smoothing) -> float:
    """Return the bytes a shown pixel: colour and depth of every sample, and the finished colour."""
    samples = smoothing.scale**2 * max(1, smoothing.samples)
    finished = 0.0 if smoothing == Smoothing(smoothing.name) else 4.0
    return 8.0 * samples + finished


def picture_size(projection: Projection) -> tuple[int, int]:
    """Return an even (width, height) in pixels in the image's proportions, as large as a pane."""
    width, height = projection.image_size
    scale = LARGEST_PX / max(width, height)
    return max(2, 2 * round(width * scale / 2)), max(2, 2 * round(height * scale / 2))


@contextmanager
def pane(
    scene: Scene,
    projection: Projection,
    size: tuple[int, int],
    smoothing: Smoothing = SMOOTHINGS[0],
) -> Iterator[tuple[Callable[[], None], Callable[[], Pixels]]]:
    """Yield two functions that draw and read the image pane off screen.

    The first draws one frame and waits for it. The second returns its pixels, (height, width, 4)
    uint8, before `shown` averages them. `size` is that of the shown picture.
    """
    width, height = (max(1, round(side * smoothing.scale)) for side in size)
    # A new window: the first frame is quicker in one that already has its shaders.
    with closing(OffScreen(width, height)) as screen:
        window = screen.render_window
        if smoothing.fxaa:
            screen.quicken_fxaa()
        window.SetMultiSamples(smoothing.samples)
        style = LIGHT.enlarged(smoothing.scale)
        drawing = ImageDrawing(screen, scene, WORDS, style, options=UNFRAMED)
        drawing.show_projection(projection)
        for renderer in window.GetRenderers():
            renderer.SetUseFXAA(smoothing.fxaa)

        def draw() -> None:
            window.Render()
            window.WaitForCompletion()

        window.Render()
        yield draw, lambda: pixels_of(window)
        drawing.remove()


def samples_given(asked: int) -> int:
    """Count the samples per pixel that this OpenGL takes for a requested number.

    VTK does not report it. A slanted edge leaves n + 1 shades if each pixel has n samples.
    """
    with off_screen(64, 64) as screen:
        screen.render_window.SetMultiSamples(asked)
        half = [(-9.0, -1.9, 0.0), (9.0, 1.9, 0.0), (9.0, -1.9, 0.0)]
        screen.renderer.AddViewProp(face_actor(half, [(0, 1, 2)], WHITE))
        screen.renderer.SetActiveCamera(identity_camera())
        screen.render_window.Render()
        shades = len(np.unique(pixels_of(screen.render_window)[..., 0]))
    return shades - 1


def shown(pixels: Pixels, scale: float, size: tuple[int, int]) -> Pixels:
    """Scale drawn pixels, (height, width, 4) uint8, to the screen: average or repeat them.

    `scale` is as in `Smoothing`; `size` is that of the result. Whole numbers are added and shifted
    to the mean, as a graphics card does: averages in float64 take longer than the drawing.
    """
    width, height = size
    if scale < 1.0:
        times, whole = round(1.0 / scale), pixels.view(np.uint32)[..., 0]
        whole = whole.repeat(times, axis=0).repeat(times, axis=1)
        return whole.view(np.uint8).reshape(height, width, 4)
    if scale == 1.0:
        return pixels
    factor = round(scale)
    rows = pixels.reshape(height, factor, width * factor * 4)
    across = rows.sum(axis=1, dtype=np.uint16).reshape(height, width, factor, 4)
    total = np.full((height, width, 4), factor * factor // 2, dtype=np.uint16)
    for column in range(factor):
        total += across[:, :, column]
    return np.asarray((total // (factor * factor)).astype(np.uint8))


def renderer_name() -> str:
    """Return the name of OpenGL's renderer: a graphics card or a program."""
    with off_screen(8, 8) as screen:
        screen.render_window.Render()
        lines = screen.render_window.ReportCapabilities().splitlines()
    names = [line.partition(":")[2].strip() for line in lines if "renderer string" in line]
    return names[0] if names else "unknown"
