"""The window's colours and sizes: light or dark, and larger for a class."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QFont, QFontInfo, QPalette
from PySide6.QtWidgets import QApplication

from app.drawings.style import DARK, LIGHT, Style

SHARE_OF_SCREEN = 0.0225
"""Of a screen's height, for an em of what a class shall read from the back row."""

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
#paneTitle[reached="true"] {{ color: {on_accent}; background: {accent}; border-radius: 3px; }}
#cardTitle {{ font-size: {large:.0f}px; font-weight: 600; }}
#startCard {{ background: {veil}; }}
#card {{ background: {window}; border: 1px solid {line}; border-radius: 6px; }}
#lesson {{ border: 1px solid {line}; border-radius: 4px; }}
#asked {{ background: {base}; border: 1px solid {line}; border-left: 3px solid {accent};
    border-radius: 4px; }}
#notice {{ background: {bar}; border: 1px solid {edge}; border-radius: 4px; padding: 4px; }}
#stepMarks QToolButton {{ border: 1px solid {line}; border-radius: 4px; padding: 2px 6px; }}
#stepMarks QToolButton:hover {{ background: {line}; }}
#stepMarks QToolButton:checked {{ color: {on_accent}; background: {accent}; }}
QPushButton#nextStep {{ font-weight: 600; }}
#paneNote {{ color: {muted}; }}
#quietTitle {{ color: {muted}; font-weight: 600; }}
#messageBar {{ background: {bar}; border: 1px solid {edge}; border-radius: 4px; }}
QDialogButtonBox {{ dialogbuttonbox-buttons-have-icons: 0; }}
QToolTip {{ color: {text}; background: {base}; border: 1px solid {edge}; }}
QToolBar {{ spacing: 2px; padding: 3px; }}
#stages QToolButton, #fixedViews QToolButton, #drawerNames QToolButton {{
    border: 0px; border-radius: 4px; padding: 4px 6px; }}
#stages QToolButton {{ padding: 4px 0px; }}
#fixedViews QToolButton {{ padding: 2px 6px; }}
#fixedViewsMenu::menu-indicator {{ image: none; }}
#stages QToolButton:hover, #fixedViews QToolButton:hover, #drawerNames QToolButton:hover {{
    background: {line}; }}
#stages QToolButton:checked, #fixedViews QToolButton:checked, #drawerNames QToolButton:checked {{
    color: {on_accent}; background: {accent}; }}
QToolBar QToolButton#presentButton {{ color: {on_accent}; background: {accent}; border: 0px;
    border-radius: 4px; padding: 4px 8px; }}
"""


_GROWING = """
QSlider:horizontal {{ min-height: {slider:.0f}px; }}
QSlider::groove:horizontal {{ height: {groove:.0f}px; border-radius: {half_groove:.0f}px;
    background: {frame}; }}
QSlider::sub-page:horizontal {{ height: {groove:.0f}px; border-radius: {half_groove:.0f}px;
    background: palette(highlight); }}
#near::sub-page:horizontal {{ background: {near}; }}
#far::sub-page:horizontal {{ background: {far}; }}
QSlider::handle:horizontal {{ width: {thumb:.0f}px; margin: -{beside:.0f}px 0px;
    border: {edge:.0f}px solid {edge_of_thumb}; border-radius: {round:.0f}px;
    background: {base_of_thumb}; }}
QSlider::handle:horizontal:focus {{ border-color: {accent}; }}
QLineEdit, QComboBox {{ border: {edge:.0f}px solid {frame}; border-radius: {round:.0f}px;
    background: palette(base); padding: {edge:.0f}px; }}
QComboBox {{ padding: {edge:.0f}px {beside:.0f}px; }}
QLineEdit:focus, QComboBox:focus {{ border-color: {accent}; }}
QComboBox::drop-down {{ border: 0px; width: {arrow:.0f}px; }}
QComboBox::down-arrow {{ image: none; }}
"""
"""What Qt's own style draws as small on every screen, however large the letters are, and frames
that it draws darker than a window that is dark."""

_FOR_A_CLASS = """
QCheckBox::indicator {{ width: {box:.0f}px; height: {box:.0f}px; }}
"""


def _growing(em: float, *, presenting: bool, **colours: str) -> str:
    """The part of the style sheet that grows with the letters, whose height in pixels is `em`."""
    groove, edge = max(4, round(0.22 * em)), max(1, round(0.06 * em))
    beside = max(4, round(0.22 * em))
    return (_GROWING + _FOR_A_CLASS * presenting).format(
        groove=groove, half_groove=groove // 2, beside=beside, slider=groove + 2 * beside + 2,
        thumb=groove + 2 * beside - 2 * edge, edge=edge, round=max(2.0, 0.15 * em), box=0.9 * em,
        arrow=em, **colours,
    )  # fmt: skip


def is_dark(theme: str) -> bool:
    """Whether a theme (``"light"``, ``"dark"`` or ``"system"``) is dark just now."""
    if theme == "system":
        scheme = QApplication.styleHints().colorScheme()
        return scheme == Qt.ColorScheme.Dark
    return theme == "dark"


def drawing_style(*, dark: bool, screen_px: float, device_pixel_ratio: float) -> Style:
    """Colours and sizes for the drawings, in device pixels; `screen_px` as of `apply`."""
    style = DARK if dark else LIGHT
    larger = max(1.0, SHARE_OF_SCREEN * screen_px / style.font_size)
    return style.enlarged(device_pixel_ratio * larger)


def apply(application: QApplication, *, dark: bool, screen_px: float) -> None:
    """Dress the whole application.

    Parameters
    ----------
    application : QApplication
    dark : bool
    screen_px : float
        Height of the screen that a class looks at, of whose height text is a share; 0 for text as
        on every desktop.
    """
    worn = application.property("frustumLabDress")
    if worn == [dark, screen_px, application.font().toString(), application.styleSheet()]:
        return  # Qt would style every widget there is anew
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
    font.setPointSizeF(base_size)
    larger = max(1.0, SHARE_OF_SCREEN * screen_px / QFontInfo(font).pixelSize())
    font.setPointSizeF(base_size * larger)
    application.setFont(font)
    accent, line = ("#3a93cc", "#4a4d50") if dark else ("#0072b2", "#c4c4c0")
    growing = _growing(
        QFontInfo(font).pixelSize(),
        presenting=screen_px > 0.0,
        near=(DARK if dark else LIGHT).near,
        far=(DARK if dark else LIGHT).far,
        accent=accent,
        frame="#74777a" if dark else "#888884",
        edge_of_thumb="#b4b4b4" if dark else "#585858",
        base_of_thumb="#34373a" if dark else "#ffffff",
    )
    application.setStyleSheet(
        growing
        + _STYLE_SHEET.format(
            muted="#b4b4b4" if dark else "#585858",
            bar="#4a3c10" if dark else "#fff4d6",
            edge="#7a6420" if dark else "#d8b860",
            text="#ececec" if dark else "#1a1a1a",
            large=1.5 * QFontInfo(font).pixelSize(),
            veil="rgba(0, 0, 0, 110)",
            window="#222426" if dark else "#f4f4f2",
            line=line,
            base="#34373a" if dark else "#ffffff",
            accent=accent,
            on_accent="#101010" if dark else "#ffffff",
        )
    )
    worn = [dark, screen_px, application.font().toString(), application.styleSheet()]
    application.setProperty("frustumLabDress", worn)
