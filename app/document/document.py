"""The document: a scene with its settings, seen through a projection.

A document is a frozen value. `app.document.codec` turns it into text and back, `app.document.files`
keeps it in files, and `app.document.settings` sets its values by their paths.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

from app.document.compare import Held
from app.document.fields import Tree, unknown
from app.document.view import View
from app.model.projection import Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.precision.quality import AUTOMATIC, Quality
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.settings import Settings
from app.scenes.shapes import LETTER_F

MESH_ENDINGS = (".obj", ".stl", ".ply", ".gltf", ".glb")
"""A scene name with one of these endings is a mesh file; every other scene is built in."""

SCENE_NAME = QT_TRANSLATE_NOOP("Refusal", "must be the name of a scene or of a mesh file")
MESH_NAME = QT_TRANSLATE_NOOP("Refusal", "must be the path of a mesh file ({0}), or empty for none")
NO_MESH_HERE = QT_TRANSLATE_NOOP(
    "Refusal", "cannot be shown in the scene {0}, which needs its own objects"
)
FIXED = QT_TRANSLATE_NOOP("Refusal", "cannot be moved in the scene {0}, whose objects are fixed")


def is_mesh(scene: str) -> bool:
    """Whether a scene's name is the path of a mesh file."""
    return scene.lower().endswith(MESH_ENDINGS)


@dataclass(frozen=True)
class Document:
    """The content of a document file.

    Raises a `Refusal` if a value is not valid, the scene cannot have this mesh or these settings,
    or the projection moves objects that are fixed.

    - `scene`: name of a built-in scene, or path of a mesh file.
    - `extra`: keys that this program does not know, at their places in the file:
      ``{"author": "...", "lens": {"label": "..."}}``. Not to be changed in place.
    - `view`: how the document is looked at. It is saved, but not compared.
    - `settings`: the settings of the scene's phenomenon; missing ones get their defaults. Complete
      and read-only after construction, and empty for every other scene.
    - `mesh`: path of the user's mesh that replaces a phenomenon's own objects; empty for none.
    - `quality`: the precision and detail of the drawing.
    """

    scene: str = "letter-f"
    projection: Projection = LETTER_F
    extra: Tree = field(default_factory=dict)
    view: View = field(default_factory=View, compare=False)
    settings: Settings = field(default_factory=dict)
    mesh: str = ""
    quality: Quality = AUTOMATIC

    def __post_init__(self) -> None:
        if not isinstance(self.scene, str) or not self.scene or "\0" in self.scene:
            raise Refusal.in_document(SCENE_NAME, field="scene", value=self.scene)
        phenomenon = PHENOMENA.get(self.scene)
        settings = phenomenon.checked(self.settings) if phenomenon else MappingProxyType({})
        object.__setattr__(self, "settings", settings)
        if phenomenon is not None and not self.projection.placement.is_identity:
            raise Refusal.in_document(FIXED, self.scene, field="object")
        if self.mesh != "":
            if not isinstance(self.mesh, str) or "\0" in self.mesh or not is_mesh(self.mesh):
                bound = MESH_NAME, ", ".join(MESH_ENDINGS)
                raise Refusal.in_document(*bound, field="mesh", value=self.mesh)
            if phenomenon is None or not phenomenon.own_mesh:
                raise Refusal.in_document(NO_MESH_HERE, self.scene, field="mesh", value=self.mesh)
        if self.extra:  # a key unknown to the previous lens may be a field of the current one
            left = unknown(self.extra, self.scene, self.projection.lens.kind, self.view.panes)
            object.__setattr__(self, "extra", left)

    def __hash__(self) -> int:
        return hash(
            (self.scene, self.projection, tuple(self.settings.items()), self.mesh, self.quality)
        )

    def with_settings(self, settings: Mapping[str, Any]) -> Document:
        """Return the document with other settings, and the projection that they require.

        Raises a `Refusal` if the scene cannot have them, or no projection fits them.
        """
        phenomenon = PHENOMENA.get(self.scene)
        if phenomenon is None:
            return self
        projection, after = phenomenon.changed(self.projection, self.settings, settings)
        return replace(self, projection=projection, settings=after)

    @property
    def state(self) -> Held:
        """The part of the document that can be held and compared with later states."""
        return Held(self.projection, self.settings)
