"""The window's colours and sizes: light or dark, and larger for a class."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QFont, QFontInfo, QPalette
from PySide6.QtWidgets import QApplication

from app.drawings.style import DARK, LIGHT, Style
from app.model.parameters import FAR, NEAR
from widgets.parts.panel import faded

SHARE_OF_SCREEN = 0.0225
"""Height of letters that can be read from the back row, relative to the screen's height."""
LABEL_SHARE = 0.034
"""The same for the labels of a slide: their capitals are 2.2 to 3 % of the screen's height."""

_COLOURS = {  # role of the palette: light, dark
    "Window": ("#f4f4f2", "#222426"),
    "WindowText": ("#1a1a1a", "#ececec"),
    "Base": ("#ffffff", "#2c2f31"),
    "AlternateBase": ("#f0f0ee", "#26282a"),
    "Text": ("#1a1a1a", "#ececec"),
    "Button": ("#e9e9e6", "#34373a"),
    "ButtonText": ("#1a1a1a", "#ececec"),
    "BrightText": ("#ffffff", "#ffffff"),
    "Highlight": ("#0072b2", "#3a93cc"),
    "HighlightedText": ("#ffffff", "#101010"),
    "ToolTipBase": ("#ffffff", "#34373a"),
    "ToolTipText": ("#1a1a1a", "#ececec"),
    "PlaceholderText": ("#6a6a6a", "#9a9a9a"),
    "Link": ("#00609a", "#56b4e9"),
    "Mid": ("#c4c4c0", "#4a4d50"),
    "Dark": ("#a0a09c", "#17181a"),
    "Light": ("#ffffff", "#43474a"),
}
_OF_SHEET = {  # additional colours of the style sheet: light, dark
    "bar": ("#fff4d6", "#4a3c10"),
    "edge_of_bar": ("#d8b860", "#7a6420"),
    "frame": ("#888884", "#74777a"),
    "muted": ("#585858", "#b4b4b4"),
    NEAR.name: (LIGHT.near, DARK.near),
    FAR.name: (LIGHT.far, DARK.far),
}

_STYLE_SHEET = """
#paneTitle {{ font-weight: 600; }}
#paneTitle[reached="true"] {{ color: {HighlightedText}; background: {Highlight};
    border-radius: 3px; }}
#cardTitle {{ font-size: {large:.0f}px; font-weight: 600; }}
#cover {{ background: rgba(0, 0, 0, 110); }}
#card {{ background: {Window}; border: 1px solid {Mid}; border-radius: 6px; }}
#lesson {{ border: 1px solid {Mid}; border-radius: 4px; }}
#asked {{ background: {ToolTipBase}; border: 1px solid {Mid}; border-left: 3px solid {Highlight};
    border-radius: 4px; }}
#notice {{ background: {bar}; border: 1px solid {edge_of_bar}; border-radius: 4px; padding: 4px; }}
#stepMarks QToolButton {{ border: 1px solid {Mid}; border-radius: 4px; padding: 2px 6px; }}
#stepMarks QToolButton[practice="true"] {{ border: 2px dashed {frame}; padding: 1px 5px; }}
#stepMarks QToolButton:hover {{ background: {Mid}; }}
#stepMarks QToolButton:checked {{ color: {HighlightedText}; background: {Highlight}; }}
QPushButton#nextStep, #measureHere {{ font-weight: 600; }}
#measureHere {{ padding: 8px 16px; }}
#paneNote {{ color: {muted}; }}
#quietTitle {{ color: {muted}; font-weight: 600; }}
#messageBar {{ background: {bar}; border: 1px solid {edge_of_bar}; border-radius: 4px; }}
QDialogButtonBox {{ dialogbuttonbox-buttons-have-icons: 0; }}
QToolTip {{ color: {Text}; background: {ToolTipBase}; border: 1px solid {edge_of_bar}; }}
QToolBar {{ spacing: 2px; padding: 3px; }}
#stages QToolButton, #fixedViews QToolButton, #drawerNames QToolButton {{
    border: 0px; border-radius: 4px; padding: 4px 6px; }}
#stages QToolButton {{ padding: 4px 0px; }}
#fixedViews QToolButton {{ padding: 2px 6px; }}
#fixedViewsMenu::menu-indicator {{ image: none; }}
#stages QToolButton:hover, #fixedViews QToolButton:hover, #drawerNames QToolButton:hover {{
    background: {Mid}; }}
#stages QToolButton:checked, #fixedViews QToolButton:checked, #drawerNames QToolButton:checked {{
    color: {HighlightedText}; background: {Highlight}; }}
QToolBar QToolButton#presentButton {{ color: {HighlightedText}; background: {Highlight};
    border: 0px; border-radius: 4px; padding: 4px 8px; }}
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
    border: {edge:.0f}px solid {muted}; border-radius: {round:.0f}px;
    background: {ToolTipBase}; }}
QSlider::handle:horizontal:focus {{ border-color: {Highlight}; }}
QLineEdit, QComboBox {{ border: {edge:.0f}px solid {frame}; border-radius: {round:.0f}px;
    background: palette(base); padding: {edge:.0f}px;
    selection-color: {HighlightedText}; selection-background-color: {Highlight}; }}
QComboBox {{ padding: {edge:.0f}px {beside:.0f}px; }}
QLineEdit:focus, QComboBox:focus {{ border-color: {Highlight}; }}
QRadioButton::indicator {{ width: {dot:.0f}px; height: {dot:.0f}px;
    border: {edge:.0f}px solid {muted}; border-radius: {half_dot:.0f}px; background: {Base}; }}
QRadioButton::indicator:checked {{ background: qradialgradient(cx: 0.5, cy: 0.5, radius: 0.5,
    fx: 0.5, fy: 0.5, stop: 0 {Highlight}, stop: 0.5 {Highlight}, stop: 0.6 {Base}); }}
QRadioButton::indicator:focus {{ border-color: {Highlight}; }}
QCheckBox::indicator {{ width: {tick:.0f}px; height: {tick:.0f}px; padding: {edge:.0f}px;
    border: {edge:.0f}px solid {muted}; border-radius: {edge:.0f}px; background: {Base}; }}
QCheckBox::indicator:checked {{ background: {Highlight}; background-clip: content; }}
QCheckBox::indicator:disabled {{ border-color: {frame}; }}
QCheckBox::indicator:focus {{ border-color: {Highlight}; }}
QComboBox::drop-down {{ border: 0px; width: {arrow:.0f}px; }}
QComboBox::down-arrow {{ image: none; }}
"""
"""Parts that Qt's own style draws small at every text size, and frames that it draws darker than a
dark window."""


def _growing(em: float, **colours: str) -> str:
    """Return the part of the style sheet that grows with the letters (`em`: pixels)."""
    groove, edge = max(4, round(0.22 * em)), max(1, round(0.06 * em))
    beside, half_dot = max(4, round(0.22 * em)), round(0.5 * em)
    return _GROWING.format(
        groove=groove, half_groove=groove // 2, beside=beside, slider=groove + 2 * beside + 2,
        thumb=groove + 2 * beside - 2 * edge, edge=edge, round=max(2.0, 0.15 * em),
        arrow=em, dot=2 * (half_dot - edge), half_dot=half_dot,
        tick=2 * (half_dot - 2 * edge), **colours,
    )  # fmt: skip


def is_dark(theme: str) -> bool:
    """Whether a theme (``"light"``, ``"dark"`` or ``"system"``) is dark now."""
    if theme == "system":
        return QApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark
    return theme == "dark"


def drawing_style(*, dark: bool, screen_px: float, device_pixel_ratio: float) -> Style:
    """Return colours and sizes for the drawings in device pixels; for `screen_px` see `apply`."""
    style = DARK if dark else LIGHT
    larger = max(1.0, LABEL_SHARE * screen_px / style.font_size)
    return style.enlarged(device_pixel_ratio * larger)


def apply(application: QApplication, *, dark: bool, screen_px: float) -> None:
    """Set colours, font and style sheet of the application.

    The text is scaled to `screen_px`, the height of the screen that a class looks at; 0 for the
    desktop's own size.
    """
    worn = application.property("frustumLabDress")
    if worn == [dark, screen_px, application.font().toString(), application.styleSheet()]:
        return  # Qt would style every widget again
    colours = {name: both[dark] for name, both in (_COLOURS | _OF_SHEET).items()}
    palette = QPalette()
    for name in _COLOURS:
        role = QPalette.ColorRole[name]
        palette.setColor(role, QColor(colours[name]))
        if name in ("WindowText", "Text", "ButtonText"):
            palette.setColor(QPalette.ColorGroup.Disabled, role, faded(colours[name], 0.45))
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
    em = QFontInfo(font).pixelSize()
    growing = _growing(em, **colours)
    # Changing one style sheet into another styles hidden widgets too, which takes several times as
    # long as these two; hidden ones get their style when they are shown.
    application.setStyleSheet("")
    application.setStyleSheet(growing + _STYLE_SHEET.format(large=1.5 * em, **colours))
    worn = [dark, screen_px, application.font().toString(), application.styleSheet()]
    application.setProperty("frustumLabDress", worn)
