"""VTK actors whose place is one 4x4 matrix, for all drawings.

A slider step reaches the screen without any work per vertex::

    Space.set(matrix)  writes 16 numbers into a vtkMatrix4x4 that all its actors hold
                       as their user matrix; the GPU divides by w

(`precision` has the other way, for pictures that float32 cannot draw.)

Such a matrix is projective, and everything that VTK computes from bounds is useless then. The
actors give no bounds, the renderer has no cullers, and the drawings set the clipping ranges.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers what renders, on import
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkActor2D,
    vtkCamera,
    vtkPolyDataMapper,
    vtkPolyDataMapper2D,
)

from app.drawings.style import QUIET, Style, rgb
from app.model.projection import Array, Projection
from app.scenes.poly_mesh import PolyMesh, cells_from
from app.scenes.scene import Scene

CUBE_CORNERS = np.array(
    [(x, y, z) for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))], dtype=np.float64
)
"""The corners of [-1, 1]^3: left-bottom, right-bottom, right-top, left-top at -1, then at +1."""
CUBE_EDGES = (
    (0, 1, 2, 3, 0), (4, 5, 6, 7, 4), (0, 4), (1, 5), (2, 6), (3, 7),
)  # fmt: skip
"""The cube's edges as polylines over `CUBE_CORNERS`: the face at -1, the one at +1, between."""

_NO_LINES = vtkPolyData()
_KEEP_OFF_ZERO = """
  float least = 1e-9 * (abs(gl_Position.x) + abs(gl_Position.y));
  if (abs(gl_Position.w) < least) gl_Position.w = gl_Position.w < 0.0 ? -least : least;"""
# By less than lines are lifted from faces; nothing leaves what is seen.
_GROUND_END = "groundEnd"
_BEFORE_GROUND = f"""
  if (gl_VertexID >= {_GROUND_END})
    gl_Position.z -= 1e-4 * max(0.0, gl_Position.w - abs(gl_Position.z));"""
# VTK's wide lines divide by the w of both ends: a line that ends exactly beside the eye is lost.
_IN_FRONT = """
vec4 inFront(vec4 end, vec4 other)
{
  float least = 1e-5 * max(abs(end.w), abs(other.w));
  if (end.w >= least || other.w < least) return end;
  return mix(end, other, (least - end.w) / (other.w - end.w));
}"""
# A wide line has one depth from side to side. On a plane that is seen askew, faces would eat it.
_ABOVE_PLANE = """
  abovePlaneVSOutput = gl_Position.z - dot(slope, gl_Position.xy);"""
_IN_PLANE = """
  gl_FragDepth = 0.5 + 0.5 * (abovePlaneVSOutput * gl_FragCoord.w
    + dot(slope, 2.0 * gl_FragCoord.xy / windowSize - 1.0));"""
_ROUND = "if (distance(gl_PointCoord, vec2(0.5)) > 0.5) discard;"
PAPER = 0.7  # share of the paper's colour in a pale silhouette
_DOTS_PER = 100.0  # the diameter of a dot in widths of a line, times the root of their number
_ROUND_PX = 1.5  # a smaller dot is a square, which takes half the time
_LIFT = 2e-3  # of the distance
_LIFT_FREE = 2e-4  # of NDC's depth, under a free matrix
_LIFT_STEP = 6e-4  # in NDC of the pane's own camera
_AT_THE_END = 0.99999  # of the same
_MOST_SHARED = 64  # points of a mesh that is made once for all drawings


class Space:
    """One 4x4, projective or not, of several actors; setting it moves them all."""

    def __init__(self) -> None:
        self.matrix = vtkMatrix4x4()
        self.unit = 1.0

    def add(self, *actors: vtkActor) -> None:
        for actor in actors:
            actor.SetUserMatrix(self.matrix)

    def set(self, matrix: Array) -> None:
        """Write another matrix, (4, 4) for column vectors, in place."""
        self.matrix.DeepCopy(matrix.ravel().tolist())

    def place(self, scale: float, position: Array) -> None:
        """Scale by a factor, then move the origin to a position, (3,)."""
        x, y, z = position.tolist()
        self.matrix.DeepCopy(
            (scale, 0.0, 0.0, x, 0.0, scale, 0.0, y, 0.0, 0.0, scale, z, 0.0, 0.0, 0.0, 1.0)
        )

    def set_projective(self, matrix: Array) -> None:
        """Write a matrix of homogeneous coordinates, scaled into the range of float32."""
        exponent = math.frexp(float(np.abs(matrix).max()))[1]
        self.unit = 2.0 ** min(exponent, 1023)
        self.set(matrix * 2.0**-exponent)


class FlatActor(vtkActor):
    """An actor in flat colours, and what its shaders do, for figures without pixels.

    - `lift`: how much nearer its vertices are, in NDC of the pane's own camera.
    - `depth`: the depth in NDC at which all of it is drawn.
    - `paper`: the colour of which `PAPER` is mixed into its own.
    - `is_shaded`: whether shaders decide more than that: its picture is known only in pixels.
    - `is_drawing`: whether it is a drawing on a plane, of which nothing is hidden.
    """

    lift = 0.0
    depth: float | None = None
    paper: tuple[float, float, float] | None = None
    is_shaded = False
    is_drawing = False


def identity_camera() -> vtkCamera:
    """Return a camera that takes clip coordinates as they are."""
    camera = vtkCamera()
    camera.SetPosition(0.0, 0.0, 0.0)
    camera.SetFocalPoint(0.0, 0.0, -1.0)
    camera.SetExplicitProjectionTransformMatrix(vtkMatrix4x4())
    camera.UseExplicitProjectionTransformMatrixOn()
    return camera


def unlit_actor(mesh: PolyMesh) -> FlatActor:
    """Return an actor in flat colours, without bounds and light.

    ``cell_data["rgb"]``, uint8 (n, 3), colours the mesh if present. The mesh is not copied, so that
    two actors of one window share what is on the GPU.
    """
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    # The points are relative to the scene's origin already, and VTK's own shift drops what is
    # near the eye in a scene 1e7 times as large.
    mapper.SetVBOShiftScaleMethod(0)
    mapper.StaticOn()  # the mesh does not change: do not walk the pipeline at every rendering
    if "rgb" in mesh.cell_data:
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray("rgb")
        mapper.SetColorModeToDirectScalars()
        mapper.ScalarVisibilityOn()
    else:
        mapper.ScalarVisibilityOff()
    actor = FlatActor()
    actor.SetMapper(mapper)
    actor.UseBoundsOff()
    actor.PickableOff()
    actor.GetProperty().LightingOff()
    return actor


def flat(actor: vtkActor) -> FlatActor:
    """Return an actor of `unlit_actor` with its own type."""
    assert isinstance(actor, FlatActor)
    return actor


def colour_by_points(actor: vtkActor, name: str) -> None:
    mapper = actor.GetMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    mapper.SetColorModeToDirectScalars()
    mapper.ScalarVisibilityOn()


def actor_2d(mesh: vtkPolyData, actor: vtkActor2D | None = None) -> vtkActor2D:
    """Return an actor in the plane of the screen, in pixels from the renderer's left and bottom."""
    mapper = vtkPolyDataMapper2D()
    mapper.SetInputData(mesh)
    actor = vtkActor2D() if actor is None else actor
    actor.SetMapper(mapper)
    return actor


@lru_cache(maxsize=64)
def _cells_in_order(cells: int, points: int) -> vtkCellArray:
    return cells_from(np.arange(0, cells * points + 1, points), np.arange(cells * points))


class ScreenCells:
    """Cells in the plane of the screen, in one array of pixels that a step writes.

    Write `px`, (cells, points, 3), from the renderer's left and bottom; then call `changed`.
    """

    def __init__(self, cells: int, points: int, actor: vtkActor2D | None = None) -> None:
        self.px = np.zeros((cells, points, 3), dtype=np.float32)
        self._points = vtkPoints()
        data: Any = vtkFloatArray()  # numpy_to_vtk takes twice as long
        data.SetNumberOfComponents(3)
        data.SetVoidArray(self.px, self.px.size, 1)
        data.drawn = self.px  # which has to live as long
        self._points.SetData(data)
        self.mesh = vtkPolyData()
        self.mesh.SetPoints(self._points)
        (self.mesh.SetLines if points == 2 else self.mesh.SetPolys)(_cells_in_order(cells, points))
        self.actor = actor_2d(self.mesh, actor)

    def changed(self) -> None:
        self._points.Modified()


def axes_of(camera: vtkCamera) -> Array:
    """Return right, up and the direction of view of a pane's camera, the rows of a (3, 3)."""
    toward = np.array(camera.GetDirectionOfProjection())
    right = np.cross(toward, camera.GetViewUp())
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(right, toward), toward])


class SceneActors:
    """The scene's faces, dots and lines, in scene-local coordinates (origin taken off).

    The ground's lines belong to the lines until the objects move (`is_moved`). Then they are an
    actor of their own, which stays. Each of the four actors, None if it has nothing, has its own
    4x4 in `spaces`. `clip` are planes in the pane's own world, behind which nothing is drawn.
    Objects' edges cover the ground's lines in the same place. If all lies almost in one plane
    (`in_plane`), they cannot; instead call `show_slope`.
    """

    def __init__(
        self, scene: Scene, style: Style, clip: Iterable[vtkPlane] = (), *, in_plane: bool = False
    ) -> None:
        self._scene, self._has_grid, self._is_pale, self.is_moved = scene, True, False, False
        self.surface = None if scene.surface is None else _faces_actor(scene, scene.surface)
        self.dots = None if scene.dots is None else _dots_actor(scene, style)
        self.lines = None if scene.lines is None else unlit_actor(scene.lines)
        self.ground = None if scene.lines is None else unlit_actor(scene.lines)
        self.spaces = Space(), Space(), Space(), Space()
        for actor, space in self.placed:
            space.add(actor)
        planes = list(clip)
        for lines in (self.lines, self.ground):
            if lines is not None:
                lines.GetProperty().SetLineWidth(style.line_width / 2.0)
                if in_plane:
                    _tilt_lines(lines)
                elif lines is self.lines:
                    _uniforms(lines).SetUniformi(_GROUND_END, 0)
                _after_position(lines, _KEEP_OFF_ZERO + (_ABOVE_PLANE if in_plane else ""))
                if not planes:  # a clipped line would need another cut
                    _cut_behind(lines)
        self._share_out()
        for actor in self:
            for plane in planes:
                actor.GetMapper().AddClippingPlane(plane)

    def __iter__(self) -> Iterator[vtkActor]:
        return iter([actor for actor, _ in self.placed])

    @property
    def placed(self) -> list[tuple[vtkActor, Space]]:
        """The existing actors, each with its `Space`."""
        pairs = zip(self.all, self.spaces, strict=True)
        return [(actor, space) for actor, space in pairs if actor is not None]

    @property
    def all(self) -> tuple[vtkActor | None, ...]:
        """The actors of surface, dots, lines and ground."""
        return self.surface, self.dots, self.lines, self.ground

    def place(self, matrices: Sequence[Array]) -> None:
        """Put surface, dots, lines and ground, those there are, under projective matrices."""
        for actor, space, matrix in zip(self.all, self.spaces, matrices, strict=True):
            if actor is not None:
                space.set_projective(matrix)

    def show_grid(self, shown: bool, pale: bool = False) -> None:
        """Show the ground's lines, `pale` where arrows on it matter more, or hide them."""
        if (shown, pale) != (self._has_grid, self._is_pale):
            self._has_grid, self._is_pale = shown, pale
            self._share_out()

    def show_lines(self, scene: Scene) -> None:
        """Show the lines of another scene, with more or less of the ground."""
        self._scene = scene
        self._share_out()

    def show_moved(self, moved: bool) -> None:
        """Let the ground stay behind while the objects move, or join them again."""
        if moved != self.is_moved:
            self.is_moved = moved
            self._share_out()

    def show_slope(self, slope: tuple[float, float], size_px: tuple[int, int]) -> None:
        """Set how depth changes along x and y in NDC of the pane's camera, and the pane's size."""
        for lines in (self.lines, self.ground):
            if lines is not None:
                properties: Any = lines.GetShaderProperty()
                properties.GetVertexCustomUniforms().SetUniform2f("slope", slope)
                properties.GetFragmentCustomUniforms().SetUniform2f("slope", slope)
                properties.GetFragmentCustomUniforms().SetUniform2f("windowSize", size_px)

    def _share_out(self) -> None:
        if self.lines is None or self.ground is None:
            return
        kept, left = self._scene.lines, None
        self.ground.GetProperty().SetOpacity(1.0 - QUIET if self._is_pale else 1.0)
        if self.is_moved or self._is_pale or not self._has_grid:
            objects, ground = self._scene.apart
            kept, left = objects.lines, ground.lines if self._has_grid else None
        for actor, mesh in ((self.lines, kept), (self.ground, left)):
            mapper: Any = actor.GetMapper()
            mapper.SetInputData(_NO_LINES if mesh is None else mesh)
        if _uniforms(self.lines).GetNumberOfUniforms():
            ends = 2 * self._scene.ground_lines if kept is self._scene.lines else 0
            _uniforms(self.lines).SetUniformi(_GROUND_END, ends)


def _uniforms(actor: vtkActor) -> Any:
    return actor.GetShaderProperty().GetVertexCustomUniforms()


def _faces_actor(scene: Scene, surface: Any) -> vtkActor:
    """Faces with one colour each, without VTK's cell colours.

    VTK looks cell colours up in a buffer for every fragment, which makes a repaint of 1e6 vertices
    1.4 times as long on a software renderer. Here each triangle's last corner carries the
    triangle's colour, and GL's ``flat`` takes it for all of it. The pixels are the same.
    """
    mesh = _provoking.get(scene)
    if mesh is None:
        mesh = _provoking[scene] = _with_provoking_corners(surface)
    actor = unlit_actor(mesh)
    if "rgb" in mesh.point_data:
        colour_by_points(actor, "rgb")
        shader = actor.GetShaderProperty()
        varying = "vec4 vertexColorVSOutput;"
        shader.AddVertexShaderReplacement(f"out {varying}", False, f"flat out {varying}", True)
        shader.AddFragmentShaderReplacement(f"in {varying}", False, f"flat in {varying}", True)
    return actor


def _dots_actor(scene: Scene, style: Style) -> vtkActor:
    """Round dots, smaller the more there are, so that a cloud shows its shape."""
    actor = _coloured_dots(scene.dots)
    usual = min(max(_DOTS_PER / math.sqrt(scene.dot_count), 0.5), 3.0)
    size = (scene.dot_widths or usual) * style.line_width
    actor.GetProperty().SetPointSize(size)
    if size > _ROUND_PX:
        # VTK's spheres come forward by a radius that is right under its own cameras only.
        place = "//VTK::Picking::Impl"  # unused, and in every shader
        actor.GetShaderProperty().AddFragmentShaderReplacement(place, True, _ROUND, False)
    return actor


def _coloured_dots(dots: Any) -> vtkActor:
    actor = unlit_actor(dots)
    colour_by_points(actor, "rgb")
    return actor


class Detail:
    """Replaces the faces and dots of one scene's actors by those of a scene with fewer."""

    def __init__(self, *actors: vtkActor | None) -> None:
        self._actors = [actor for actor in actors if actor is not None]
        self._whole = [actor.GetMapper() for actor in self._actors]
        self._fewer: WeakKeyDictionary[Scene, list[Any]] = WeakKeyDictionary()

    def show(self, fewer: Scene | None) -> None:
        """Show the faces and dots of a scene, or the actors' own for None.

        The graphics card keeps what was shown once, so that only the first time takes long.
        """
        mappers = self._whole if fewer is None else self._fewer.get(fewer)
        if mappers is None:
            assert fewer is not None
            mappers = []
            for whole in self._whole:
                if whole.GetInput().GetNumberOfVerts():
                    mapper = _coloured_dots(fewer.dots).GetMapper()
                else:
                    mapper = _faces_actor(fewer, fewer.surface).GetMapper()
                if whole.GetClippingPlanes() is not None:
                    mapper.SetClippingPlanes(whole.GetClippingPlanes())
                mappers.append(mapper)
            self._fewer[fewer] = mappers
        for actor, mapper in zip(self._actors, mappers, strict=True):
            former: Any = actor.GetMapper()
            if former is not mapper:
                mapper.SetScalarVisibility(former.GetScalarVisibility())
                actor.SetMapper(mapper)


_provoking: WeakKeyDictionary[Scene, PolyMesh] = WeakKeyDictionary()
"""`_with_provoking_corners` of each scene, so that all drawings of it share one."""


def _with_provoking_corners(surface: PolyMesh) -> PolyMesh:
    """The surface's triangles, with a last corner that is no other triangle's last corner."""
    if not surface.is_all_triangles:
        surface = surface.triangulate()
    triangles = surface.regular_faces.copy()
    count, last = surface.n_points, triangles[:, 2]
    owner = np.empty(count, dtype=triangles.dtype)
    owner[last] = np.arange(len(triangles))
    shared = np.flatnonzero(owner[last] != np.arange(len(triangles)))
    points = np.concatenate([surface.points, surface.points[last[shared]]])
    triangles[shared, 2] = count + np.arange(len(shared))
    mesh = PolyMesh.of(points, faces=triangles)
    if "rgb" in surface.cell_data:
        colours = np.zeros((len(points), 3), dtype=np.uint8)
        colours[triangles[:, 2]] = surface.cell_data["rgb"]
        mesh.point_data["rgb"] = colours
    return mesh


def line_actor(
    points: ArrayLike, lines: Sequence[Sequence[int]], colour: str, width: float
) -> vtkActor:
    """Polylines in one colour: points (n, 3), each line's indices, and the width in pixels."""
    actor = _coloured(points, colour, "lines", lines)
    actor.GetProperty().SetLineWidth(width)
    _after_position(actor, _KEEP_OFF_ZERO)
    _cut_behind(actor)
    return actor


def face_actor(
    points: ArrayLike, faces: Sequence[Sequence[int]], colour: str, opacity: float = 1.0
) -> vtkActor:
    """Polygons in one colour, seen from both sides: points (n, 3) and each face's indices."""
    actor = _coloured(points, colour, "faces", faces)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def point_actor(points: ArrayLike, colour: str, size: float) -> vtkActor:
    """Round points, (n, 3), in one colour, with a diameter in pixels."""
    actor = _coloured(points, colour)
    actor.GetProperty().SetPointSize(size)
    actor.GetProperty().RenderPointsAsSpheresOn()
    return actor


def _coloured(
    points: ArrayLike, colour: str, kind: str = "", cells: Sequence[Sequence[int]] = ()
) -> vtkActor:
    array = np.array(points, dtype=np.float64)
    make = _mesh_of if len(array) <= _MOST_SHARED else _mesh_of.__wrapped__
    actor = unlit_actor(make(array.tobytes(), kind, tuple(map(tuple, cells))))
    actor.GetProperty().SetColor(*rgb(colour))
    return actor


@lru_cache(maxsize=512)
def _mesh_of(points: bytes, kind: str, cells: Sequence[Sequence[int]]) -> PolyMesh:
    """Return the one mesh of these points: to make a mesh takes longer than to make its actor."""
    array = np.frombuffer(points).reshape(-1, 3).copy()
    return PolyMesh.of(array, **({kind: cells} if kind else {}))


def make_pale(actors: Iterable[vtkActor], style: Style) -> None:
    """Mix the colours of actors with much of the paper's: a silhouette beside what matters."""
    red, green, blue = rgb(style.background)
    place = "//VTK::TCoord::Impl"
    mixed = f"mix(gl_FragData[0].rgb, vec3({red}, {green}, {blue}), {PAPER})"
    for actor in actors:
        actor.GetShaderProperty().AddFragmentShaderReplacement(
            place, True, f"{place}\n  gl_FragData[0].rgb = {mixed};\n", False
        )
        flat(actor).paper = red, green, blue


def lift_lines(actor: vtkActor, steps: float = 1) -> None:
    """Draw lines a little nearer to the pane's camera, so that faces do not hide them.

    Lines lifted by more steps cover lines in the same place. A step is constant in the depth
    buffer, which suits a pane's camera with a tight clipping range; under the model's camera use
    `lifted`. Moving vertices costs nothing; VTK's own offset writes every fragment's depth.
    """
    flat(actor).lift = _LIFT_STEP * steps
    _after_position(
        actor, f"{_KEEP_OFF_ZERO}\n  gl_Position.z -= {_LIFT_STEP * steps} * gl_Position.w;"
    )


def put_in_front(actor: vtkActor) -> None:
    """Draw an actor before everything else; its own points no longer hide one another."""
    flat(actor).depth = -_AT_THE_END
    _after_position(actor, f"gl_Position.z = {-_AT_THE_END} * gl_Position.w;")


def put_behind(actor: vtkActor) -> None:
    """Draw an actor behind everything else: a tint that colours no face of the scene."""
    flat(actor).depth = _AT_THE_END
    _after_position(actor, f"gl_Position.z = {_AT_THE_END} * gl_Position.w;")


def _tilt_lines(actor: vtkActor) -> None:
    """Give wide lines the depth of a plane from side to side, whichever shader makes them wide."""
    properties, name = actor.GetShaderProperty(), "abovePlane"
    into, out = f"{name}VSOutput", f"{name}GSOutput"
    dec, impl = "//VTK::Picking::Dec", "//VTK::Picking::Impl"  # unused, and in every shader
    properties.AddVertexShaderReplacement(dec, True, f"out float {into};", False)
    both = f"in float {into}[]; out float {out};"
    properties.AddGeometryShaderReplacement(dec, True, both, False)
    properties.AddGeometryShaderReplacement(impl, True, f"{out} = {into}[i];", False)
    properties.AddFragmentShaderReplacement(dec, True, f"in float {into};", False)
    properties.AddFragmentShaderReplacement("//VTK::Depth::Impl", True, _IN_PLANE, False)


def _cut_behind(actor: vtkActor) -> None:
    """Cut wide lines where they run behind the eye, before they become ribbons.

    VTK makes two triangles of a line. If its second end is behind the eye, their common diagonal
    meets the ribbon's sides at infinity, and they fill a wedge that widens with the line's reach
    behind.
    """
    properties = actor.GetShaderProperty()
    start = "//VTK::System::Dec"  # VTK has it in every shader that uses the function
    properties.AddGeometryShaderReplacement(start, True, start + _IN_FRONT, True)
    for end, other in (("0", "1"), ("1", "0"), ("i", "1 - i")):
        # In brackets, so that one replacement does not match the next search.
        cut = f"inFront((gl_in[{end}]).gl_Position, (gl_in[{other}]).gl_Position)"
        properties.AddGeometryShaderReplacement(f"gl_in[{end}].gl_Position", True, cut, True)


def _after_position(actor: vtkActor, statement: str) -> None:
    """Append a statement to those of VTK's vertex shader that set `gl_Position`."""
    position = "//VTK::PositionVC::Impl"
    if _uniforms(actor).GetNumberOfUniforms():
        statement += _BEFORE_GROUND
    actor.GetShaderProperty().AddVertexShaderReplacement(
        position, True, f"{position}\n  {statement}\n", False
    )


def lifted(clip_from_local: Array, projection: Projection, scene: Scene) -> Array:
    """Return a `Projection.clip_from_local` for lines: the same pixels, a little nearer.

    Every point keeps its pixel and gets the depth of a point `_LIFT` of the way nearer to the eye
    (for a parallel lens, or an eye far away: of the scene's size). In proportion to the distance,
    it neither drowns in a depth buffer of extreme far/near nor shows what is hidden. Without faces
    nothing is lifted, so that near and far cut lines and dots exactly.
    """
    if scene.surface is None:
        return clip_from_local
    distance = math.dist(projection.camera.eye, scene.centre)
    share = _LIFT * (min(1.0, scene.size / distance) if distance > 0.0 else 1.0)
    constant, per_w = projection.passage.nearer(share, _LIFT * scene.size, _LIFT_FREE)
    matrix = clip_from_local.copy()
    matrix[2] += per_w * matrix[3]
    matrix[2, 3] += constant
    return matrix


def applied(matrix: Array, points: Array) -> Array:
    """Apply a projective matrix to points, (n, 3)."""
    homogeneous = np.column_stack([points, np.ones(len(points))]) @ matrix.T
    return np.asarray(homogeneous[:, :3] / homogeneous[:, 3:])


def fitting(matrix: Array) -> Array:
    """A homogeneous matrix without a common factor that could keep it from float32."""
    return np.asarray(matrix * 2.0 ** -math.frexp(float(np.abs(matrix).max()))[1])
