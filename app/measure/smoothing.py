"""Trade 4, antialiasing and resolution: ms a frame against what the eye would see of it.

The image pane's own drawing is rendered off screen, each time with everything alike but the
smoothing, and held against the same picture with `REFERENCE` x `REFERENCE` samples a pixel.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, contextmanager
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.drawings import WORDS
from app.drawings.actors import face_actor, identity_camera
from app.drawings.image import ImageDrawing
from app.drawings.off_screen import OffScreen, Pixels, off_screen, pixels_of
from app.drawings.style import LIGHT, WHITE
from app.measure.results import Choice, Trade
from app.measure.run import Watch, timed, unwatched
from app.model.projection import Projection
from app.scenes.scene import Scene

REFERENCE = 4
"""Sixteen samples a pixel, by far the finest that is compared."""
LARGEST_PX = 640
"""Longer side of the picture that is timed: about that of a pane."""

OTHER_SAMPLES = "this OpenGL gives {0} samples"
SAME_PICTURE = "the same picture"
"""What is said of other names for a choice, which stand before it."""


class Smoothing(NamedTuple):
    """One way of smoothing.

    Attributes
    ----------
    name : str
    scale : float
        Pixels that are drawn for one that is shown, along each side; below 1 they are enlarged.
    samples : int
        Of OpenGL's multisampling; 0 for none.
    fxaa : bool
        Whether edges are found in the finished picture and blurred along (Lottes, 2009).
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

    Parameters
    ----------
    scene : Scene
    projection : Projection
    seconds : float
        For the timing.
    watch : Watch

    Returns
    -------
    Trade
        Cost is ms a frame, error the root mean square of the pixels' differences, in levels of
        0 to 255.

    Raises
    ------
    Cancelled
        By `watch`; with the pictures' errors, and the times so far.
    """
    size = picture_size(projection)
    with ExitStack() as stack:
        finest = Smoothing("", scale=REFERENCE)
        with pane(scene, projection, size, finest) as (draw, read):
            draw()
            reference = shown(read(), REFERENCE, size)
        runs: dict[str, Callable[[], Any]] = {}
        choices = []
        for smoothing, note in pictures():
            draw, read = stack.enter_context(pane(scene, projection, size, smoothing))
            draw()

            def frame(
                draw: Callable[[], None] = draw,
                read: Callable[[], Pixels] = read,
                scale: float = smoothing.scale,
            ) -> None:
                draw()
                if scale != 1.0:  # the way to the screen belongs to it
                    shown(read(), scale, size)

            runs[smoothing.name] = frame
            difference = shown(read(), smoothing.scale, size) - reference
            error, name = float(np.sqrt((difference**2).mean())), smoothing.name
            choices.append(Choice(name, None, None, error, note=note, use={"smoothing": name}))
        trade = Trade("smoothing", "ms", "levels RMS", tuple(choices), 0)
        return timed(trade, runs, seconds, 1e3, watch)


def pictures() -> list[tuple[Smoothing, str]]:
    """Those of `SMOOTHINGS` that are different pictures here, and what is to be said of each.

    Of several that this OpenGL draws with as many samples one is kept: the one that asks for so
    many, or else the first.
    """
    found: dict[Smoothing, list[Smoothing]] = {}
    for smoothing in SMOOTHINGS:
        samples = samples_given(smoothing.samples) if smoothing.samples else 1
        drawn = smoothing._replace(name="", samples=0 if samples == 1 else samples)
        found.setdefault(drawn, []).append(smoothing)
    kept = []
    for drawn, alike in found.items():
        one = next((each for each in alike if each.samples == drawn.samples), alike[0])
        others = [each.name for each in alike if each is not one]
        as_asked = one.samples == drawn.samples
        notes = [] if as_asked else [OTHER_SAMPLES.format(drawn.samples)]
        kept.append((one, ", ".join(notes + (others and [*others, SAME_PICTURE]))))
    return kept


def picture_size(projection: Projection) -> tuple[int, int]:
    """The image's proportions, no larger than a pane, and even: (width, height) in pixels."""
    width, height = projection.image_size
    scale = LARGEST_PX / max(width, height)
    return max(2, 2 * round(width * scale / 2)), max(2, 2 * round(height * scale / 2))


@contextmanager
def pane(
    scene: Scene,
    projection: Projection,
    size: tuple[int, int],
    smoothing: Smoothing = SMOOTHINGS[0],
    background: bool = True,
) -> Iterator[tuple[Callable[[], None], Callable[[], Pixels]]]:
    """The image pane off screen: what draws it, and what reads it.

    Parameters
    ----------
    scene : Scene
    projection : Projection
    size : (int, int)
        Pixels that are shown.
    smoothing : Smoothing
    background : bool
        Whether there is one; without it the alpha that is read tells what is covered.

    Yields
    ------
    draw : callable
        Draws one frame and waits until it is there.
    read : callable
        Its pixels, (height, width, 4) uint8, before they are averaged.
    """
    width, height = (max(1, round(side * smoothing.scale)) for side in size)
    # A window of its own: one that was drawn in has its shaders, and its first frame is quicker.
    with closing(OffScreen(width, height)) as screen:
        window = screen.render_window
        window.SetAlphaBitPlanes(1)
        window.SetMultiSamples(smoothing.samples)
        style = LIGHT.enlarged(smoothing.scale)
        drawing = ImageDrawing(screen, scene, WORDS, style, framed=False)
        drawing.show_projection(projection)
        for renderer in window.GetRenderers():
            renderer.SetUseFXAA(smoothing.fxaa)
            if not background:
                renderer.SetBackground(0.0, 0.0, 0.0)
                renderer.SetBackgroundAlpha(0.0)

        def draw() -> None:
            window.Render()
            window.WaitForCompletion()

        window.Render()
        yield draw, lambda: pixels_of(window)
        drawing.remove()


def samples_given(asked: int) -> int:
    """How many samples a pixel this OpenGL takes when it is asked for so many.

    It may take more or fewer, and VTK does not ask which. So they are counted: an edge that crosses
    pixels everywhere leaves n + 1 shades where each has n samples.
    """
    with off_screen(64, 64) as screen:
        screen.render_window.SetMultiSamples(asked)
        half = face_actor(
            [(-9.0, -1.9, 0.0), (9.0, 1.9, 0.0), (9.0, -1.9, 0.0)], [(0, 1, 2)], WHITE
        )
        screen.renderer.AddViewProp(half)
        screen.renderer.SetActiveCamera(identity_camera())
        screen.render_window.Render()
        shades = len(np.unique(pixels_of(screen.render_window)[..., 0]))
    return shades - 1


def shown(pixels: Pixels, scale: float, size: tuple[int, int]) -> NDArray[np.float64]:
    """Colours as they reach the screen: averaged if there are more, repeated if there are fewer.

    Parameters
    ----------
    pixels : (height, width, 4) uint8 array
    scale : float
        Pixels drawn for one that is shown, along each side.
    size : (int, int)
        Pixels that are shown.

    Returns
    -------
    (height, width, 3) float64 array
        From 0 to 255.
    """
    colours = pixels[..., :3].astype(np.float64)
    width, height = size
    if scale > 1.0:
        factor = round(scale)
        means: NDArray[np.float64] = colours.reshape(height, factor, width, factor, 3).mean((1, 3))
        return means
    times = round(1.0 / scale)
    return colours.repeat(times, axis=0).repeat(times, axis=1)


def renderer_name() -> str:
    """What draws here: the graphics card, or a program in its place."""
    with off_screen(8, 8) as screen:
        screen.render_window.Render()
        lines = screen.render_window.ReportCapabilities().splitlines()
    names = [line.partition(":")[2].strip() for line in lines if "renderer string" in line]
    return names[0] if names else "unknown"
