"""The things that a picture names: which a view asks for, and which a scene can show.

A name is a plain id: ``eye``, ``near``, ``P'``, ``y_p``. A view has a list of its own
(`View.names`) or uses the list of its scene.
"""

from app.document.document import Document
from app.document.view import EVERYTHING, View
from app.lecture.camera_frame import STEPS
from app.lecture.highlight import AXES, ENDS, WINDOW
from app.lecture.letters import in_letters
from app.lecture.stages import IMAGE, NDC, VIEW
from app.model.formula import ARROW
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import Scene

FRAMES = {"frame-o": "O", "frame-w": "W", "frame-e": "E"}
"""The frames of the object, the world and the eye, which a world picture shows if it names them,
and their letters."""
PROBE_LETTER = "probe-"
"""Before a letter: ``probe-A`` gives the first probe the letter A in place of its number."""
_CUBE = frozenset(ENDS)  # what the cube beside a scene's own picture is named by


def named_in(
    pane: str, scene: Scene, names: tuple[str, ...] | None = None
) -> frozenset[str] | None:
    """Return the ids that a pane names under a view's `names`; None for everything."""
    if names == EVERYTHING:
        return None
    if names is not None:
        return frozenset(names)
    own = frozenset(scene.names)
    return own | _CUBE if pane == "ndc" and scene.leading != "ndc" else own


def inks(document: Document, scene: Scene, shown: Illustration | None) -> dict[str, str]:
    """Return the colours, fields of `Style`, of the letters that the pictures name in one.

    The keys are letters in the document's lettering, as a formula has them: ``z_min``, ``y_p``.
    """
    letters = document.view.letters
    letter_of = {name: in_letters(f"{{{name}_distance}}", letters).strip("−") for name in _CUBE}
    letter_of |= {axis: in_letters(f"{{axis_{axis}}}", letters) + ARROW for axis in AXES}
    named = scene.names if document.view.names is None else document.view.names
    colours = {letter_of[name]: name for name in named if name in letter_of}
    colours |= {name: scene.inks[name] for name in named if name in scene.inks}
    for marks in (shown.world, shown.ndc, shown.image) if shown is not None else ():
        colours |= {text.name: text.colour for text in marks.texts if text.name in named}
    return {name: colour for name, colour in colours.items() if colour}


def seen_from(view: View, scene: Scene) -> str:
    """Return the viewpoint of the world under a view, one of `FIXED` or empty."""
    return scene.fixed if view.fixed is None else view.fixed


def nameable(pane: str, document: Document, scene: Scene) -> frozenset[str]:
    view, projection = document.view, document.projection
    shown = scene.illustration(projection, document.settings) or Illustration(())
    planes = frozenset(ENDS if projection.lens.planes is not None else ())
    probes = frozenset(f"{PROBE_LETTER}{letter}" for letter in "ABCDEFGH"[: len(view.probes)])
    if pane == "image":
        return probes.union({"pixels"}, (text.name for text in shown.image.texts))
    if pane == "ndc":
        axes = (*"xyz", *(AXES if view.stage <= VIEW else ()))
        stop = planes if view.stage != IMAGE else frozenset[str]()
        numbers = ("numbers",) if view.stage > VIEW else ()
        texts = shown.ndc.texts if view.stage == NDC else ()
        return stop.union(axes, numbers, probes, (text.name for text in texts))
    names = planes.union(AXES, FRAMES, probes, ("eye", "target"))
    names |= {text.name for text in shown.world.texts}
    if planes:
        names |= WINDOW.keys()
    if view.step is not None:
        names |= frozenset(STEPS) & {"look", "up"}
    if not projection.placement.is_identity or FRAMES.keys() & set(view.names or ()):
        names |= {"x", "y", "z"}
    fixed = seen_from(view, scene)
    if fixed in ("side", "top"):
        names |= {"d", "e", "height", "angle", "degrees", *(name for name, _ in shown.measured)}
        names |= {length.name for length in shown.lengths if length.view == fixed}
    if fixed == "axis":
        names |= {"height", "width", *(("interval",) if planes else ())}
    return names
