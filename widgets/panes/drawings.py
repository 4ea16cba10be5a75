"""The maker of each pane's drawing, which imports VTK when it is called."""

from collections.abc import Callable
from typing import Any


def _world(*args: Any) -> Any:
    from app.drawings.world import WorldDrawing

    return WorldDrawing(*args, live=True)


def _stage(*args: Any) -> Any:
    from app.drawings.stage import StageDrawing

    return StageDrawing(*args, live=True)


def _image(*args: Any) -> Any:
    from app.drawings.image import ImageDrawing
    from app.drawings.picture_frame import PictureOptions

    screen, scene, words, style, tolerance_px, quality = args
    options = PictureOptions(quality=quality)
    return ImageDrawing(screen, scene, words, style, tolerance_px, options, live=True)


DRAWINGS: dict[str, Callable[..., Any]] = {"world": _world, "ndc": _stage, "image": _image}
