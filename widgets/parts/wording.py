"""The words of a module's controls, which its page in ``content`` has, in the window's language.

The page begins with the name of the class that is the context of their translations. A section is a
control: its name and its key, ``## Copy all {#copy}``; below it the tooltip, perhaps what a screen
reader says instead of the name, and as items the choices that it offers. The items of `SENTENCES`
are all else that the class says. `tests/texts.py` gives them to lupdate.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QCheckBox, QPushButton, QToolButton, QWidget

from app.model.parameter import read_sections, section_of
from widgets.parts.icons import Combo
from widgets.parts.layouts import push_button, tool_button
from widgets.parts.plain import set_tip

SENTENCES = "Sentences"


class Wording:
    """The words of the module with this ``__file__``."""

    def __init__(self, module: str) -> None:
        path = Path(module)
        self.sections = read_sections(path.parent / "content" / f"{path.stem}.md")
        self.context = next(iter(self.sections))

    def _translated(self, text: str) -> str:
        return QCoreApplication.translate(self.context, text)

    def __getitem__(self, key: str) -> list[str]:
        """The name of a control, and the lines below it."""
        name, section = section_of(key, self.sections)
        return [self._translated(text) for text in (name, *section.text)]

    def choices(self, key: str) -> list[list[str]]:
        """The key, the text and perhaps the explanation of each choice of a control."""
        items = section_of(key, self.sections)[1].named.items()
        return [[each, *map(self._translated, text.split(" | "))] for each, text in items]

    def say(self, key: str, *values: object) -> str:
        """A sentence, filled with values if there are any."""
        text = self._translated(self.sections[SENTENCES].named[key])
        return text.format(*values) if values else text

    def name(self, widget: QWidget, key: str) -> None:
        """Give a widget its name for a screen reader, and its tooltip."""
        name, tip = self[key]
        widget.setAccessibleName(name)
        set_tip(widget, tip)

    def push(self, key: str, act: object = None) -> QPushButton:
        text, tip, *name = self[key]
        return push_button(text, tip, act, name="".join(name))

    def tool(self, key: str, act: object = None, **how: Any) -> QToolButton:
        text, tip, *name = self[key]
        return tool_button(text, tip, act, name="".join(name), **how)

    def check(self, key: str, act: Any) -> QCheckBox:
        """A check box; `act` is called when it is switched."""
        text, tip = self[key]
        box = QCheckBox(text)
        set_tip(box, tip)
        box.toggled.connect(act)
        return box

    def combo(self, key: str, values: Mapping[str, object] | None = None) -> Combo:
        """A combo box, whose data are the keys of its choices, or other `values`."""
        choices = [(text, (values or {}).get(each, each)) for each, text in self.choices(key)]
        name, tip = self[key]
        return Combo(name, tip, choices)
