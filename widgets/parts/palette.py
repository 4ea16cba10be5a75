"""The window's colours and sizes: light or dark, and larger for a class."""

from contextlib import nullcontext
from pathlib import Path
from string import Template

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QFont, QFontInfo, QPalette
from PySide6.QtWidgets import QApplication

from app.drawings.style import DARK, LIGHT, Style
from app.model.parameter import read_content, read_sections
from app.model.parameters import FAR, NEAR
from widgets.parts.kept_style import KeptStyle
from widgets.parts.panel import faded

SHARE_OF_SCREEN = 0.0225
"""Height of letters that can be read from the back row, relative to the screen's height."""
LABEL_SHARE = 0.034
"""The same for the labels of a slide: their capitals are 2.2 to 3 % of the screen's height."""

_CONTENT = Path(__file__).with_name("content")


def _colours(heading: str) -> dict[str, list[str]]:
    """Return the names of some colours, and each for a light and a dark window."""
    sections = read_sections(_CONTENT / "colours.md")
    return {name: both.split() for name, both in sections[heading].named.items()}


_COLOURS = _colours("Palette")
_OF_SHEET = _colours("Style sheet") | {
    NEAR.name: [LIGHT.near, DARK.near],
    FAR.name: [LIGHT.far, DARK.far],
}
_SHEET = Template(read_content(_CONTENT / "window.qss"))


def _sheet(em: float, **colours: str) -> str:
    """Return the style sheet for letters of a size (`em`: pixels)."""
    groove, edge = max(4, round(0.22 * em)), max(1, round(0.06 * em))
    beside, half_dot = max(4, round(0.22 * em)), round(0.5 * em)
    sizes = {
        "groove": groove, "half_groove": groove // 2, "beside": beside, "edge": edge,
        "slider": groove + 2 * beside + 2, "thumb": groove + 2 * beside - 2 * edge,
        "round": max(2.0, 0.15 * em), "arrow": em, "half_dot": half_dot,
        "dot": 2 * (half_dot - edge), "tick": 2 * (half_dot - 2 * edge), "large": 1.5 * em,
    }  # fmt: skip
    return _SHEET.substitute(colours, **{name: f"{size:.0f}" for name, size in sizes.items()})


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


def apply(
    application: QApplication, *, dark: bool, screen_px: float, kept: KeptStyle | None = None
) -> None:
    """Set colours, font and style sheet of the application.

    The text is scaled to `screen_px`, the height of the screen that a class looks at; 0 for the
    desktop's own size. `kept`: hidden parts that are styled when they are shown.
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
    sheet = _sheet(QFontInfo(font).pixelSize(), **colours)
    # Changing one style sheet into another styles hidden widgets too, which takes several times as
    # long as these two; hidden ones get their style when they are shown.
    skips = kept.skipped(application.styleSheet(), sheet) if kept is not None else nullcontext()
    with skips:
        application.setStyleSheet("")
        application.setStyleSheet(sheet)
    worn = [dark, screen_px, application.font().toString(), application.styleSheet()]
    application.setProperty("frustumLabDress", worn)
