"""The window's colours and sizes: light or dark, and larger for a projector."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QFont, QPalette
from PySide6.QtWidgets import QApplication

from app.drawings.style import DARK, LIGHT, Style

PROJECTOR_FACTOR = 1.5
"""How much larger the drawings' text and lines are in projector mode, for the back row."""
PROJECTOR_FONT_FACTOR = 1.25
"""The same for the controls, which the lecturer reads: the panes need the room."""

_COLOURS = (  # role, light, dark
    (QPalette.ColorRole.Window, "#f4f4f2", "#222426"),
    (QPalette.ColorRole.WindowText, "#1a1a1a", "#ececec"),
    (QPalette.ColorRole.Base, "#ffffff", "#2c2f31"),
    (QPalette.ColorRole.AlternateBase, "#f0f0ee", "#26282a"),
    (QPalette.ColorRole.Text, "#1a1a1a", "#ececec"),
    (QPalette.ColorRole.Button, "#e9e9e6", "#34373a"),
    (QPalette.ColorRole.ButtonText, "#1a1a1a", "#ececec"),
    (QPalette.ColorRole.BrightText, "#ffffff", "#ffffff"),
    (QPalette.ColorRole.Highlight, "#0072b2", "#3a93cc"),
    (QPalette.ColorRole.HighlightedText, "#ffffff", "#101010"),
    (QPalette.ColorRole.ToolTipBase, "#ffffff", "#34373a"),
    (QPalette.ColorRole.ToolTipText, "#1a1a1a", "#ececec"),
    (QPalette.ColorRole.PlaceholderText, "#6a6a6a", "#9a9a9a"),
    (QPalette.ColorRole.Link, "#00609a", "#56b4e9"),
    (QPalette.ColorRole.Mid, "#c4c4c0", "#4a4d50"),
    (QPalette.ColorRole.Dark, "#a0a09c", "#17181a"),
    (QPalette.ColorRole.Light, "#ffffff", "#43474a"),
)

_STYLE_SHEET = """
#paneTitle {{ font-weight: 600; }}
#paneNote {{ color: {muted}; }}
#quietTitle {{ color: {muted}; font-weight: 600; }}
#messageBar {{ background: {bar}; border: 1px solid {edge}; border-radius: 4px; }}
QToolTip {{ color: {text}; background: {base}; border: 1px solid {edge}; }}
QToolBar {{ spacing: 2px; padding: 2px; }}
"""


def is_dark(theme: str) -> bool:
    """Whether a theme (``"light"``, ``"dark"`` or ``"system"``) is dark just now."""
    if theme == "system":
        scheme = QApplication.styleHints().colorScheme()
        return scheme == Qt.ColorScheme.Dark
    return theme == "dark"


def drawing_style(*, dark: bool, projector: bool, device_pixel_ratio: float) -> Style:
    """Colours and sizes for the drawings, in device pixels."""
    style = (DARK if dark else LIGHT).enlarged(device_pixel_ratio)
    return style.enlarged(PROJECTOR_FACTOR) if projector else style


def apply(application: QApplication, *, dark: bool, projector: bool) -> None:
    """Dress the whole application."""
    palette = QPalette()
    for role, light_colour, dark_colour in _COLOURS:
        colour = QColor(dark_colour if dark else light_colour)
        palette.setColor(role, colour)
        if role in (
            QPalette.ColorRole.WindowText,
            QPalette.ColorRole.Text,
            QPalette.ColorRole.ButtonText,
        ):
            faded = QColor(colour)
            faded.setAlphaF(0.45)
            palette.setColor(QPalette.ColorGroup.Disabled, role, faded)
    application.setPalette(palette)
    base_size = application.property("frustumLabFontSize")
    if base_size is None:
        base_size = application.font().pointSizeF()
        application.setProperty("frustumLabFontSize", base_size)
    font = QFont(application.font())
    font.setPointSizeF(base_size * (PROJECTOR_FONT_FACTOR if projector else 1.0))
    application.setFont(font)
    application.setStyleSheet(
        _STYLE_SHEET.format(
            muted="#b4b4b4" if dark else "#585858",
            bar="#4a3c10" if dark else "#fff4d6",
            edge="#7a6420" if dark else "#d8b860",
            text="#ececec" if dark else "#1a1a1a",
            base="#34373a" if dark else "#ffffff",
        )
    )
