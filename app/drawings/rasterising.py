"""Changes to the rasterising of a scene's faces, for phenomena about the rasteriser itself.

The picture is still the graphics card's own: its triangles, its interpolation, its depth test. A
few lines of shader in VTK's template, once per scene, make the difference. A setting writes
uniforms, which costs neither a new shader nor any work per vertex.

============  ===============================================================================
depth         each fragment's depth is rounded to the code that a buffer would hold
texture       s and t as varyings, and s w, t w, w, whose quotients are linear on the screen
fog           a fragment's colour fades into the background with its distance w
levels        the vertices of all levels of detail are there; those of the wrong level for an
              object's distance are moved to where they are clipped
============  ===============================================================================

The depth that is rounded comes from w, ``1/gl_FragCoord.w``, not from z, which the lens has
squeezed by then. Formats differ near the far plane, and so the shader works with r, the depth from
there: ``r = n f/(f - n) (1 - w/f)/w``, which is small where digits matter. Fixed codes count
``round(r (2^bits - 1))``, the same for the standard and the reversed range. The shader writes
``1 - r``, rounded again, so that a buffer of 24 bits keeps all codes of up to 24 bits apart. VTK's
own has 32, of fixed point or of a float, of which a float32 shader fills 24: the codes of the
formats of 32 bits are spread over it by their logarithm, as many as there are.
"""

import math
import weakref
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings.actors import Space, colour_by_points, flat, identity_camera, unlit_actor
from app.drawings.moved_vertices import PLACE
from app.drawings.off_screen import pixels_of
from app.drawings.prop_group import PropGroup
from app.drawings.style import LIGHT, Style, rgb
from app.model.depth import FORMATS, DepthBuffer
from app.model.parameter import read_content
from app.model.projection import Array, Lens, Projection
from app.model.refusal import QT_TRANSLATE_NOOP
from app.scenes.phenomena.depth_buffer import FINEST
from app.scenes.phenomena.marks import DetailLevel, Fog, Rendering, Texture
from app.scenes.phenomena.words import Phrase
from app.scenes.poly_mesh import PolyMesh
from app.scenes.scene import Scene

REFUSED = QT_TRANSLATE_NOOP(
    "phenomena",
    "this computer's OpenGL rejects the shader that this scene needs: the picture is drawn without"
    " it, and only the computed numbers are right",
)
TOO_FINE = QT_TRANSLATE_NOOP(
    "phenomena",
    "{0} faces with {1} parts a side are too many triangles to draw: the picture has {2} parts",
)
MOST_TRIANGLES = 1_000_000
LEAST_COUNTED = 20  # the fewest pixels of which a share is counted: each is 5 points then

_Uniforms: TypeAlias = dict[str, float | int | tuple[float, ...]]
_RED, _BLUE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)

_POSITION, _VARYINGS = "//VTK::PositionVC::Impl", "//VTK::PositionVC::Dec"
_COLOUR = "//VTK::TCoord::Impl"
_DEPTH, _CHECKS, _FOG, _LEVEL = (
    read_content(Path(__file__).with_name("content") / f"{name}.glsl")
    for name in ("depth", "checks", "fog", "level")
)


class Rasteriser:
    """How a scene's actors are rasterised in one pane; for scenes that require it.

    `requires` are some of "depth", "texture", "fog" and "levels". `add` adds an actor to the pane,
    for levels of detail. `surface` are the scene's faces with their matrix; `others` are its lines
    and the faces of its copies, which take part in depth and fog. A pane that is not the `picture`
    of the model's own lens shows the texture alone.

    `refused` is True if this computer's OpenGL has rejected the shader. It is known after the first
    rendering, in which the faces are missing; from the next one on they are drawn the ordinary way.
    """

    def __init__(
        self,
        scene: Scene,
        style: Style,
        requires: Iterable[str],
        add: Callable[[vtkActor], object],
        surface: tuple[vtkActor, Space],
        others: Iterable[tuple[vtkActor, Space]] = (),
        *,
        picture: bool = True,
    ) -> None:
        self._scene = scene
        self._picture = picture
        self._requires = frozenset(requires) & ({*requires} if picture else {"texture"})
        self._background = rgb(style.background)
        self._add = add
        self._surface, space = surface
        self._mapper: Any = self._surface.GetMapper()  # of all triangles, whatever is shown now
        self._plain: Any = self._mapper.GetInput()
        self._divided: dict[int, PolyMesh] = {}
        self._parts = 1  # that each side of a triangle is divided into now
        self._note: Phrase | None = None
        self._shader_parts: list[tuple[vtkActor, Space, list[tuple[str, str, str]]]] = []
        self._levels: vtkActor | None = None
        self._levels_space = Space()
        self.refused = False
        self._prepare(self._surface, space, textured="texture" in self._requires)
        for actor, space in others:
            self._prepare(actor, space)
        self.show(Rendering(), scene.start)

    @property
    def problem(self) -> Phrase | None:
        return Phrase(REFUSED) if self.refused else self._note

    def show(self, rendering: Rendering, projection: Projection) -> None:
        """Rasterise like this from now on; call it after the actors' spaces have been set."""
        if not self._picture:
            plain = rendering.texture and replace(rendering.texture, affine=False, subdivision=1)
            rendering = Rendering(texture=plain)
        if "levels" in self._requires:
            if self._levels is None and rendering.levels:
                self._build_levels(rendering.levels)
            self._levels_space.set_projective(projection.clip_from_local(self._scene.origin))
            self._choose_faces(in_levels=bool(rendering.levels) and not self.refused)
        self._subdivide(rendering.texture)
        depth = self._depth_uniforms(rendering.buffer, projection)
        fog = self._fog_uniforms(rendering.fog, projection.lens)
        texture = self._texture_uniforms(rendering.texture)
        until = [min(level.until, 3e38) for level in rendering.levels[:2]]
        for actor, space, _ in self._shader_parts:
            shader = actor.GetShaderProperty()
            fragment = shader.GetFragmentCustomUniforms()
            if self._requires & {"depth", "fog"}:
                _set(fragment, "flUnit", space.unit)
            for name, value in (depth | fog).items():
                _set(fragment, name, value)
            if actor is self._levels and rendering.levels:
                vertex = shader.GetVertexCustomUniforms()
                _set(vertex, "flDistance", self._distance(projection))
                vertex.SetUniform2f("flUntil", until)
            if actor is self._surface and "texture" in self._requires:
                vertex = shader.GetVertexCustomUniforms()
                for name, value in texture.items():
                    where = vertex if name in ("flS", "flT") else fragment
                    _set(where, name, value)

    # -- the shaders, once

    def _prepare(self, actor: vtkActor, space: Space, *, textured: bool = False) -> None:
        parts: list[tuple[str, str, str]] = []
        colour = ""
        if "depth" in self._requires:
            parts.append(("Fragment", "//VTK::Depth::Impl", _DEPTH))
        if textured:
            # What GLSL calls noperspective, which Mesa's software rasteriser loses where a face is
            # cut at the picture's border: two thirds of a board were black.
            varyings = "{0} vec2 flSpaceST;\n{0} vec3 flScreenST;\n"
            place, given = "vertexMC", ""
            if "vertices" in self._scene.requires:
                place, given = "vec4(flPlace, 1.0)", "in vec3 flPlace;\n"
                self._mapper.MapDataArrayToVertexAttribute(
                    "flPlace", PLACE, vtkDataObject.FIELD_ASSOCIATION_POINTS, -1
                )
            there = f"vec2(dot(flS, {place}), dot(flT, {place}))"
            both = f"flSpaceST = {there};\n  flScreenST = vec3(flSpaceST, 1.0) * gl_Position.w;"
            parts.append(("Vertex", _VARYINGS, given + varyings.format("out")))
            parts.append(("Fragment", _VARYINGS, varyings.format("in")))
            parts.append(("Vertex", _POSITION, f"  {both}\n"))
            colour += _CHECKS
        if actor is self._levels:
            parts.append(("Vertex", _VARYINGS, "in vec4 flObject;\n"))
            parts.append(("Vertex", _POSITION, _LEVEL))
        if "fog" in self._requires:
            colour += _FOG
        if colour:
            parts.append(("Fragment", _COLOUR, colour))
        shader = actor.GetShaderProperty()
        for kind, place, text in parts:
            getattr(shader, f"Add{kind}ShaderReplacement")(place, True, f"{place}\n{text}", False)
        flat(actor).is_shaded = True
        self._shader_parts.append((actor, space, parts))
        itself = weakref.ref(self)  # or mapper and rasteriser would keep each other alive

        def fail(_mapper: object, _event: str) -> None:
            rasteriser = itself()
            if rasteriser is not None:
                rasteriser._refuse()

        mapper: Any = actor.GetMapper()
        mapper.AddObserver("ErrorEvent", fail)

    def _refuse(self) -> None:
        """Go back to VTK's own shaders: one of ours was not compiled."""
        if self.refused:
            return
        self.refused = True
        for actor, _, parts in self._shader_parts:
            flat(actor).is_shaded = False
            shader = actor.GetShaderProperty()
            for kind, place, _ in parts:
                getattr(shader, f"Clear{kind}ShaderReplacement")(place, True)
        self._choose_faces(in_levels=False)

    def _choose_faces(self, *, in_levels: bool) -> None:
        if self._levels is not None:
            self._levels.SetVisibility(in_levels)
            self._surface.SetVisibility(not in_levels)

    def _build_levels(self, levels: tuple[DetailLevel, ...]) -> None:
        self._levels = unlit_actor(_mesh_of_levels(levels, self._scene.origin))
        colour_by_points(self._levels, "rgb")
        mapper: Any = self._levels.GetMapper()
        mapper.MapDataArrayToVertexAttribute(
            "flObject", "object", vtkDataObject.FIELD_ASSOCIATION_POINTS, -1
        )
        self._levels_space.add(self._levels)
        self._prepare(self._levels, self._levels_space)
        self._add(self._levels)

    # -- what they are told

    def _depth_uniforms(self, buffer: DepthBuffer | None, projection: Projection) -> _Uniforms:
        if "depth" not in self._requires:
            return {}
        plain = dict.fromkeys(("flA", "flInverseFar", "flLog", "flByNdc"), 0.0)
        plain |= dict.fromkeys(("flSteps", "flScale"), 1.0)
        uniforms: _Uniforms = {"flBuffer": 0, "flMapping": 0, **plain}
        if buffer is None:
            return uniforms
        near, far, kind = buffer.near, buffer.far, FORMATS[buffer.format]
        a = buffer.lens.depth_slope
        mapping = 1 if a else 0
        if buffer.mapping == "logarithmic":
            mapping, a = 2, 1.0 / math.log2(far / near)
        reversed_ = buffer.mapping == "reversed"
        scale, log = 1.0, 0.0
        if kind.float_type is None:
            which, steps = 1, float(kind.largest)
            scale = 1.0 / steps
        else:
            which = 3 if reversed_ else 2
            steps = 2.0 ** (kind.digits - 1) if kind.bits < 32 else 0.0  # a float32 already
        if kind.bits == 32 and which != 2:
            # More codes than a depth buffer has: as many as there are, evenly over the scene.
            depths = -projection.trace(self._scene.corners).view[:, 2]
            ends = np.clip([depths.min(), depths.max()], near, far)
            rest = buffer.depth(ends) if reversed_ else 1.0 - buffer.depth(ends)
            largest, smallest = (max(float(part), 1e-30) for part in rest)
            scale, log = scale / largest, 1.0 / (math.log2(largest / smallest) + 1.0)
        uniforms |= {"flBuffer": which, "flMapping": mapping, "flA": a}
        uniforms |= {"flInverseFar": 1.0 / far if mapping else 0.0, "flSteps": steps}
        # A half, for z in [-1, 1], which costs a float32 a bit; from here, or a compiler would see
        # that it is for nothing.
        by_ndc = 0.5 if buffer.mapping == "opengl" else 0.0
        return uniforms | {"flScale": scale, "flLog": log, "flByNdc": by_ndc}

    def _texture_uniforms(self, texture: Texture | None) -> _Uniforms:
        s, t = [(0.0, 0.0, 0.0, 0.0)] * 2
        checks, affine, coordinates = 0.0, False, False
        if texture is not None:
            # vertexMC is scene-local, and in float32: the origin is taken off here, in float64.
            local = texture.texture_from_world.copy()
            local[:, 3] += local[:, :3] @ np.array(self._scene.origin)
            s, t = (tuple(row) for row in local.tolist())
            checks, affine = float(texture.checks), texture.affine
            coordinates = texture.coordinates
        return {
            "flS": s, "flT": t, "flChecks": checks,
            "flAffine": int(affine), "flCoordinates": int(coordinates),
        }  # fmt: skip

    def _fog_uniforms(self, fog: Fog | None, lens: Lens) -> _Uniforms:
        if "fog" not in self._requires:
            return {}
        which, end, slope = 0, 0.0, 0.0
        if fog is not None and fog.density > 0.0:
            which, slope = 2, fog.density
        elif fog is not None:
            which, end, slope = 1, fog.end, 1.0 / (fog.end - fog.start)
        span = lens.even_extent
        return {
            "flFog": which, "flFogEnd": end, "flFogSlope": slope, "flBackground": self._background,
            "flNear": lens.near if span else 0.0, "flSpan": span,
        }  # fmt: skip

    def _distance(self, projection: Projection) -> tuple[float, ...]:
        """The vector whose product with scene-local x, y, z, 1 is w."""
        n = projection.camera.frame[2]
        eye = np.array(projection.camera.eye) - np.array(self._scene.origin)
        return (*(-n).tolist(), float(n @ eye))

    def _subdivide(self, texture: Texture | None) -> None:
        """Give the faces actor the mesh with so many triangles; built on first use."""
        parts = 1 if texture is None else texture.subdivision
        self._note = None
        if "texture" not in self._requires:
            return
        faces = self._plain.GetNumberOfPolys()
        possible = max(1, math.isqrt(MOST_TRIANGLES // max(1, faces)))
        if parts > possible:
            self._note = Phrase(TOO_FINE, (str(faces), str(parts), str(possible)))
            parts = possible
        if parts == self._parts:
            return
        self._parts = parts
        if parts not in self._divided:
            whole = PolyMesh.sharing(self._plain)
            self._divided[parts] = whole if parts == 1 else subdivided(whole, parts)
        self._mapper.SetInputData(self._divided[parts])


def textured(
    scene: Scene, canvas: PropGroup, *faces: tuple[vtkActor | None, Space]
) -> list[Rasteriser]:
    """Return rasterisers for a scene's texture in a pane that is not the picture."""
    if "texture" not in scene.requires:
        return []
    return [
        Rasteriser(scene, canvas.style, {"texture"}, canvas.add, (actor, space), picture=False)
        for actor, space in faces
        if actor is not None
    ]


def _set(uniforms: Any, name: str, value: float | int | tuple[float, ...]) -> None:
    if isinstance(value, int):
        uniforms.SetUniformi(name, value)
    elif isinstance(value, float):
        uniforms.SetUniformf(name, min(max(value, -3e38), 3e38))  # a float32, as all it meets
    elif len(value) == 4:
        uniforms.SetUniform4f(name, list(value))
    else:
        uniforms.SetUniform3f(name, list(value))


def subdivided(mesh: PolyMesh, parts: int) -> PolyMesh:
    """Divide each triangle into ``parts**2`` similar ones, in its own colour.

    A triangle's last corner carries its colour in ``point_data["rgb"]``. Neighbours get the same
    points on a common side: no pixel between them is lost.
    """
    column, row = np.meshgrid(np.arange(parts), np.arange(parts))
    start = np.stack([column, row], axis=-1)[column + row < parts]
    upper = start[start.sum(axis=1) < parts - 1]
    corners = np.concatenate(
        [start[:, None] + ((0, 0), (1, 0), (0, 1)), upper[:, None] + ((1, 0), (1, 1), (0, 1))]
    ).astype(np.float64)
    b, c = corners[None, ..., :1], corners[None, ..., 1:]
    a = parts - b - c
    triangles = mesh.regular_faces
    first, second, third = np.asarray(mesh.points, dtype=np.float64)[triangles].swapaxes(0, 1)
    sums = a * first[:, None, None] + b * second[:, None, None] + c * third[:, None, None]
    points = (sums / parts).reshape(-1, 3).astype(np.float32)
    made = PolyMesh.of(points, faces=np.arange(len(points)).reshape(-1, 3))
    if "rgb" in mesh.point_data:
        colours = np.asarray(mesh.point_data["rgb"])[triangles[:, 2]]
        made.point_data["rgb"] = np.repeat(colours, 3 * len(corners), axis=0)
    return made


def _mesh_of_levels(levels: tuple[DetailLevel, ...], origin: tuple[float, ...]) -> PolyMesh:
    """All levels' faces, each vertex with its object's place and its level."""
    quads = np.concatenate([level.faces[0] for level in levels])
    colours = np.concatenate([level.faces[1] for level in levels])
    objects = np.empty((len(quads), 4))
    objects[:, :3] = np.concatenate([level.objects for level in levels]) - np.array(origin)
    objects[:, 3] = np.repeat(np.arange(len(levels)), [len(level.objects) for level in levels])
    points = (quads.reshape(-1, 3) - np.array(origin)).astype(np.float32)
    first = 4 * np.arange(len(quads))[:, None, None]
    triangles = (first + np.array([[0, 1, 2], [0, 2, 3]])).reshape(-1, 3)
    mesh = PolyMesh.of(points, faces=triangles)
    mesh.point_data["rgb"] = np.repeat(colours, 4, axis=0)
    mesh.point_data["object"] = np.repeat(objects, 4, axis=0).astype(np.float32)
    return mesh


def counted_wrong_share(
    screen: Any, scene: Scene, projection: Projection, buffer: DepthBuffer, behind: Array
) -> float | None:
    """Count the share of pixels in which a surface behind is drawn over the one in front.

    The picture is as large as the empty `screen`. `behind`, (4, 4), is world from world: the
    scene's faces again, behind. The share, 0..1, is of the pixels that both surfaces cover, NaN if
    they are fewer than `LEAST_COUNTED`; None where this computer's OpenGL rejects the shader.
    """
    if scene.surface is None:
        return None
    window, renderer = screen.render_window, screen.renderer
    PropGroup.make_ready(renderer)
    renderer.SetActiveCamera(identity_camera())
    renderer.SetBackground(0.0, 0.0, 0.0)
    actors: list[tuple[vtkActor, Space]] = []
    origin = np.array(scene.origin)
    shift, back = np.eye(4), np.eye(4)
    shift[:3, 3], back[:3, 3] = origin, -origin
    even = projection.lens.even_extent > 0.0  # a float's digits stand where depth is near 0
    seen = projection.with_depth("opengl")
    clip_from_local = seen.clip_from_local(scene.origin)
    plain = PolyMesh.sharing(scene.surface)
    plain.GetCellData().Initialize()
    for matrix, colour in zip((np.eye(4), back @ behind @ shift), (_RED, _BLUE), strict=True):
        face, space = unlit_actor(plain), Space()
        face.GetProperty().SetColor(*colour)
        space.add(face)
        space.set_projective(clip_from_local @ matrix)
        renderer.AddViewProp(face)
        actors.append((face, space))
    rasteriser = Rasteriser(scene, LIGHT, {"depth"}, renderer.AddViewProp, actors[0], actors[1:])
    rasteriser.show(Rendering(buffer=buffer), seen)

    def drawn(*visible: bool) -> NDArray[np.bool_]:
        for (actor, _), shown in zip(actors, visible, strict=True):
            actor.SetVisibility(shown)
        window.Render()
        return pixels_of(window)[..., [0, 2]] > 127

    both = drawn(True, False)[..., 0] & drawn(False, True)[..., 1]
    picture = drawn(True, True)[..., 1]
    # A gap that is too fine for this buffer is replaced by a larger one, in a finer buffer.
    if even:
        rasteriser.show(Rendering(), seen)
        reach = math.dist(*scene.corners[[0, -1]].tolist())
    else:
        true = DepthBuffer("float32", "reversed", buffer.lens)
        rasteriser.show(Rendering(buffer=true), seen)
        reach = max(math.dist(corner, projection.camera.eye) for corner in scene.corners.tolist())
    apart, away = behind.copy(), -projection.camera.frame[2]
    gap = float(behind[:3, 3] @ away)
    apart[:3, 3] += (max(1.0, FINEST * reach / gap) - 1.0) * gap * away
    apart = back @ apart @ shift
    if even:
        clip_from_local = _over_the_scene(clip_from_local, scene.corners - origin, apart)
    actors[0][1].set_projective(clip_from_local)
    actors[1][1].set_projective(clip_from_local @ apart)
    wrong = picture != drawn(True, True)[..., 1]
    for actor, _ in actors:
        renderer.RemoveViewProp(actor)
    if rasteriser.refused:
        return None
    return float(np.mean(wrong[both])) if both.sum() >= LEAST_COUNTED else math.nan


def _over_the_scene(clip_from_local: Array, corners: Array, apart: Array) -> Array:
    """A parallel lens's matrix with depths that extend only over the scene and its copy.

    A float32 would otherwise spend its digits on the space before and behind the scene. `corners`,
    (8, 3), are a box round the scene; `apart` is the copy's matrix, local from local.
    """
    points = np.concatenate([corners, corners @ apart[:3, :3].T + apart[:3, 3]])
    z = points @ clip_from_local[2, :3] + clip_from_local[2, 3]
    margin = 0.01 * (z.max() - z.min())  # or a face across the view would be cut off
    low, high = np.clip([z.min() - margin, z.max() + margin], -1.0, 1.0)
    if low < high:
        clip_from_local = clip_from_local.copy()
        clip_from_local[2, 3] -= (low + high) / 2.0
        clip_from_local[2] *= 2.0 / (high - low)
    return clip_from_local
