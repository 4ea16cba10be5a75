"""Hidden widgets keep their style when letters change their size, until they are shown.

Qt styles every widget of the program anew when the style sheet changes, also hidden ones. A class
sees a pane, and perhaps a row of controls; the rest comes back as it was.
"""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtGui import QFont
from PySide6.QtWidgets import QWidget

from widgets.parts import icons

_IS_STYLED, _HAS_OWN = Qt.WidgetAttribute.WA_WState_Polished, Qt.WidgetAttribute.WA_SetStyle


class KeptStyle(QObject):
    """Knows which widgets inside some parts of a window wear an older style than the application.

    Nothing measures what is hidden in these parts.
    """

    def __init__(self, parts: Sequence[QWidget]) -> None:
        super().__init__()
        self._parts = parts
        self._kept: dict[QWidget, tuple[str, QFont]] = {}
        """The style sheet that such a widget wears, and its font."""

    @contextmanager
    def skipped(self, before: str, after: str) -> Iterator[None]:
        """Let the application take another style sheet without the hidden widgets."""
        kept: dict[QWidget, tuple[str, QFont]] = {}
        for each in (widget for part in self._parts for widget in _within(part)):
            if not each.isVisible() and each.testAttribute(_IS_STYLED):
                worn = self._kept.get(each, (before, each.font()))
                if each.font() == worn[1] and not each.styleSheet():  # or it was styled by itself
                    kept[each] = worn
        _mark(kept, True)
        yield
        _mark(kept, False)
        self._kept = {each: worn for each, worn in kept.items() if worn[0] != after}
        for each in kept:
            if each.isWindow() or each.parentWidget() not in kept:
                (each.installEventFilter if each in self._kept else each.removeEventFilter)(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Show and isinstance(watched, QWidget):
            watched.removeEventFilter(self)
            widgets = [each for each in _within(watched) if self._kept.pop(each, None)]
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


def _mark(widgets: Iterable[QWidget], skips: bool) -> None:
    """Set or remove Qt's marks of widgets that do not wear the application's style."""
    for each in widgets:
        each.setAttribute(_HAS_OWN, skips)
        each.setAttribute(_IS_STYLED, not skips)
