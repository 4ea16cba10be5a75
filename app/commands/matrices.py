"""The command ``matrices``: every stage's matrix as text, JSON or LaTeX."""

import argparse
import itertools
import json
from collections.abc import Mapping, Sequence

import numpy as np

from app.commands.aligned import lengths, lens_line, plain, widths
from app.commands.arguments import document_of, set_letters, set_texts
from app.commands.options import Parser
from app.commands.terminal import CliError, write_out
from app.document.document import CAMERA_P
from app.languages import said, translate
from app.lecture.conventions import CONVENTIONS, in_convention, world_planes
from app.lecture.copying import latex_called
from app.lecture.letters import Letters
from app.lecture.notation import WrittenMatrix, clip_signs, matrices
from app.lecture.paper import TEXT_WIDTH_PT, displayed
from app.lecture.typed_matrix import properties
from app.model.camera import taken_apart
from app.model.chain import FROM_OBJECT
from app.model.matrix_text import read_matrix
from app.model.projection import Array, Projection, Stage
from app.model.refusal import format_value
from app.model.tables import rounded

_DIGITS = 4
NOTICED_PX = 1e-9  # least skew that is no rounding of float64


def run(arguments: Sequence[str]) -> int:
    """Print every stage's matrix; return the exit status."""
    options, words = Parser("matrices").read(arguments)
    if options.format != "latex":
        for option in ("digits", "letters", "symbols", "numbers", "width"):
            if getattr(options, option):
                raise CliError("--{0}: needs --format latex.", option)
    if options.vectors and not options.convention:
        raise CliError("--vectors: needs --convention.")
    alone = [option for option in ("planes", "convention", "chain") if getattr(options, option)]
    if len(alone) + (options.format == "latex" and not options.chain) > 1 and alone:
        raise CliError("--{0}: stands alone, and needs --format text or json.", alone[0])
    set_letters(options)
    document = document_of(words[0] if words else None, options.set)
    projection = document.projection
    if options.convention:
        write_out([_in_convention(projection, options)])
    elif options.planes:
        write_out([_planes(projection, options.format)])
    elif options.format == "latex":
        write_out([_latex(projection, options, document.view.letters)])
    elif options.chain:
        write_out([_chain(projection, options)])
    else:
        is_text = options.format == "text"
        write_out([_text(projection), _of_p(options.set)] if is_text else [_json(projection)])
    return 0


def _of_p(assignments: Sequence[str]) -> str:
    """Return the parts of a camera matrix that was set, and what it does not say."""
    if (text := set_texts(assignments).get(CAMERA_P.path)) is None:
        return ""
    scale, k, rotation, translation = taken_apart(read_matrix(text))
    notes = [
        said("for x right, y down, z forward; pixels from the centre of the first one"),
        said("scale = {0} is free, and so is its sign", format_value(scale)),
        said("P has w > 0 behind the camera: perhaps y points up in its image") * (scale < 0.0),
        said("skew", k[0, 1]) * bool(abs(k[0, 1]) > NOTICED_PX),
        said("P does not say near, far and the size of the image"),
    ]
    lines = "".join(f"  ({note})\n" for note in filter(None, notes))
    parts = {"K": k, "R": rotation, "t": translation[:, None]}
    blocks = (f"  {name}\n{_rows(values)}" for name, values in parts.items())
    return "\n".join([f"\nP = scale K [R | t]\n{lines}{next(blocks)}", *blocks])


def _text(projection: Projection) -> str:
    blocks = [f"{lens_line(projection)}\n"]
    for stage in projection.all_stages:
        product = f" = {' '.join(name for name, _ in stage.factors)}" if stage.factors else ""
        note = _notes("  ({0})\n", projection, stage)
        blocks.append(f"{stage.name}{product}\n{note}{_rows(stage.matrix)}")
        factors = [each for each in stage.factors if "_from_" not in each[0]]  # no stages
        if len(factors) > 1:
            blocks += [f"  {name}\n{_rows(values)}" for name, values in factors]
        if stage.name == "clip_from_world":
            blocks.append(f"ndc_from_clip: {said('x, y and z divided by w')}\n")
    return "\n".join(blocks)


def _notes(line: str, projection: Projection, matrix: Stage | WrittenMatrix) -> str:
    """Return the note and the properties of a matrix, each in a line of this form."""
    own = translate(matrix.note, "Stage") if matrix.note else ""
    notes = [own, *map(str, properties(projection, matrix.name))]
    return "".join(map(line.format, filter(None, notes)))


def _rows(matrix: Array) -> str:
    texts = [format_value(value) for value in (matrix + 0.0).ravel().tolist()]
    length, before = (part.reshape(1, *matrix.shape) for part in lengths(texts))
    cells = map(str.rjust, texts, widths(length, before))
    return "".join(f"  {''.join(row)}\n" for row in zip(*[cells] * matrix.shape[1], strict=True))


def _json(projection: Projection) -> str:
    return _object({stage.name: plain(stage.matrix) for stage in projection.all_stages})


def _object(values: Mapping[str, object]) -> str:
    lines = (
        f"  {json.dumps(name)}: {json.dumps(value, allow_nan=False)}"
        for name, value in values.items()
    )
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _in_convention(projection: Projection, options: argparse.Namespace) -> str:
    convention = CONVENTIONS[options.convention]
    rows = convention.rows if options.vectors is None else options.vectors == "rows"
    matrices = in_convention(projection, options.convention, rows=rows)
    if options.format == "json":
        return _object({name: plain(matrix) for name, matrix in matrices.items()})
    vectors = said("row vectors, p M") if rows else said("column vectors, M p")
    about = said(f"in-{options.convention}")
    blocks = [f"{options.convention}: {about}; {vectors}\n"]
    blocks += [f"{name}\n{_rows(matrix)}" for name, matrix in matrices.items()]
    return "\n".join(blocks)


def _chain(projection: Projection, options: argparse.Namespace) -> str:
    """Return every factor from the object to the picture, and the products so far."""
    links = projection.links
    names = [link.name for link in reversed(links)]
    if options.format == "json":
        steps = [
            {"name": name, "matrix": own and plain(rounded(own)), "so_far": plain(rounded(so_far))}
            for name, own, so_far in links
        ]
        return _object({"product": names, "steps": steps})
    blocks = [f"{' | '.join(names)}\n{said('the rightmost factor acts first')}\n"]
    for number, (name, exact, so_far) in enumerate(links, 1):
        own = _rows(rounded(exact)) if exact else f"  {said('x, y and z divided by w')}\n"
        blocks.append(f"{number}  {name}\n{own}  {said('so far')}\n{_rows(rounded(so_far))}")
    return "\n".join(blocks)


def _planes(projection: Projection, form: str) -> str:
    planes = world_planes(projection)
    if form == "json":
        return _object(planes)
    cells = _rows(np.array([plane or [0.0] * 4 for plane in planes.values()])).splitlines()
    infinite = f"  {said('at infinity')}"
    lines = [
        f"{name:6}{row if plane else infinite}\n"
        for row, (name, plane) in zip(cells, planes.items(), strict=True)
    ]
    about = said("a x + b y + c z + d >= 0 in the view volume, in world space")
    return "".join([f"{about}\n", *lines])


def _latex(projection: Projection, options: argparse.Namespace, letters: Letters) -> str:
    blocks = ["% needs \\usepackage{amsmath}\n"]
    numbers = options.numbers or not options.symbols
    digits, width = options.digits or _DIGITS, options.width or TEXT_WIDTH_PT
    whole = matrices(projection, letters)
    (clip,) = (each for each in whole if each.name == "clip_from_view")
    called = latex_called(clip.called.partition(" = ")[0] or clip.name)
    for matrix in (_product(projection, letters, whole),) if options.chain else whole:
        note = _notes("% {0}\n", projection, matrix)
        own = called if matrix.name == "clip_from_world" else ""
        tex = displayed(matrix, letters, options.symbols, numbers, digits, width, own)
        blocks.append(note + tex)
    return "\n".join(blocks)


def _product(
    projection: Projection, letters: Letters, whole: Sequence[WrittenMatrix]
) -> WrittenMatrix:
    """Return the product of all factors from the object to clip space, in a lecture's letters."""
    stages = {each.name: each for each in whole}
    from_world, names = stages["clip_from_world"], [*stages["clip_from_world"].product]
    called = [*from_world.chain]
    if not projection.placement.is_identity:
        names.append(FROM_OBJECT)
        called.append(stages[FROM_OBJECT].called.partition(" = ")[0] or FROM_OBJECT)
    factors = (
        (name in ("view_from_world", FROM_OBJECT) and stages[name].factors) or (stages[name],)
        for name in names
    )
    signs = np.reshape(clip_signs(projection, letters), (4, 1))
    values = tuple(map(tuple, (signs * rounded(projection.links[-3].so_far) + 0.0).tolist()))
    every = tuple(itertools.chain(*factors))
    return WrittenMatrix("clip_from_object", values, (), (), every, chain=tuple(called))
