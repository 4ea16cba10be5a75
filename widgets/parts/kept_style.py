"""Hidden parts of a window keep their style when letters change their size, until they are shown.

Qt styles every widget of the program anew when the style sheet changes, also hidden ones. A class
sees a pane, and perhaps a row of controls; the dock and the panels come back as they were.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtGui import QFont
from PySide6.QtWidgets import QWidget

from widgets.parts import icons

_SKIPPED = {  # Qt's marks of widgets that do not wear the application's style
    Qt.WidgetAttribute.WA_SetStyle: True,
    Qt.WidgetAttribute.WA_WState_Polished: False,
}


class KeptStyle(QObject):
    """Knows which parts of a window wear an older style than the application."""

    def __init__(self, parts: Sequence[QWidget]) -> None:
        super().__init__()
        self._parts = parts
        self._kept: dict[QWidget, tuple[str, dict[QWidget, QFont]]] = {}
        """The style sheet that such a part wears, and its widgets with their fonts."""

    @contextmanager
    def skipped(self, before: str, after: str) -> Iterator[None]:
        """Let the application take another style sheet without the hidden parts."""
        skipped: list[QWidget] = []
        for part in self._parts:
            if part.isVisible():
                continue
            widgets = _within(part)
            if part not in self._kept:
                self._kept[part] = before, {each: each.font() for each in widgets}
                part.installEventFilter(self)
            fonts = self._kept[part][1]
            for each in widgets:
                if each.font() == fonts.get(each) and not each.styleSheet():
                    skipped.append(each)
                else:  # it is new, or was styled by itself
                    fonts.pop(each, None)
        _mark(skipped, True)
        yield
        _mark(skipped, False)
        self._kept = {part: kept for part, kept in self._kept.items() if kept[0] != after}

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Show and watched in self._kept:
            del self._kept[watched]
            watched.removeEventFilter(self)
            widgets = _within(watched)
            for each in widgets:
                each.style().unpolish(each)
                each.style().polish(each)
            for each in widgets:
                QCoreApplication.sendEvent(each, QEvent(QEvent.Type.StyleChange))
            icons.fit(watched)
        return super().eventFilter(watched, event)


def _within(part: QWidget) -> list[QWidget]:
    """Return a part and all within it, the outer ones first."""
    return [part, *part.findChildren(QWidget)]


def _mark(widgets: Sequence[QWidget], on: bool) -> None:
    for each in widgets:
        for mark, skips in _SKIPPED.items():
            each.setAttribute(mark, skips == on)
