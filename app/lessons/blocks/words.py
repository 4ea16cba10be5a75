"""Text between the blocks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from app.lessons.blocks.block import Part


@dataclass(frozen=True, kw_only=True)
class Words(Part):
    """Text between the blocks, as Markdown."""

    def texts(self) -> Iterator[tuple[int, str]]:
        yield self.line, self.text
