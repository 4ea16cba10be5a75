"""What of the drawings can be switched off."""

from __future__ import annotations

from typing import TypeAlias

Layers: TypeAlias = frozenset[str]
LAYERS = ("labels", "handles", "grid", "frustum", "camera", "near-picture")
"""Each drawing knows those that it has."""
