"""What the Help menu tells: short texts in boxes that do not stop the work."""

from __future__ import annotations

import sys
from html import escape

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QMessageBox,
    QTextBrowser,
    QVBoxLayout,
    QWidget,
)

from app import __version__

PLAY_KEY, FULL_SCREEN_KEY = (
    ("Ctrl+Shift+Space", "Ctrl+Meta+F")  # where Ctrl is ⌘, and the system has taken ⌘Space and F11
    if sys.platform == "darwin"
    else ("Ctrl+Space", "F11")
)


def _key(keys: str) -> str:
    """A shortcut as this system writes it."""
    return QKeySequence(keys).toString(QKeySequence.SequenceFormat.NativeText)


class Help(QObject):
    """Shows the help texts for one window.

    Parameters
    ----------
    window : QWidget
        Parent of the boxes.
    """

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window

    def show_keys(self) -> None:
        """Say what keys and mouse do, in a table that scrolls where the screen is low."""
        tr = self.tr
        one, two, three, back = (_key(f"Ctrl+{number}") for number in "1230")
        groups = {
            tr("Everywhere"): (
                (_key("Ctrl+Z"), tr("Undo; a drag is one step")),
                (_key("Ctrl+R"), tr("Reset all to how the scene opens")),
                (_key(PLAY_KEY), tr("Play or pause the camera's walk")),
                (_key("Ctrl+E"), tr("Export the panes as a picture")),
                (_key("Ctrl+F") + tr(" or /"), tr("Find a control by its name")),
                (_key("F4"), tr("Hide the controls, or show them")),
                (tr("Esc"), tr("Leave what is on top; put back what is being dragged")),
                (
                    tr("Drop a file"),
                    tr("Open a document, a mesh (OBJ, STL, PLY, glTF) or an exported picture"),
                ),
            ),
            tr("Where the panes stand"): (
                (f"{one}, {two}, {three}", tr("World, NDC cube, image into the large slot")),
                (tr("again, or double-click a title"), tr("The whole window for that pane")),
                (back, tr("All panes, as the scene has them")),
            ),
            tr("A pane's own view (the model is not touched)"): (
                (tr("Drag"), tr("Turn it")),
                (tr("Shift-drag"), tr("Move it")),
                (tr("Wheel"), tr("Nearer, farther")),
                (tr("Double-click"), tr("Back to how it was")),
                (
                    tr("Tab, then arrows"),
                    tr("Turn; with Shift move; + and − nearer, farther; Home"),
                ),
            ),
            tr("Marks in the world pane (these move the model)"): (
                (tr("Eye, target"), tr("In the plane that faces you; with Shift up and down")),
                (tr("Near, far"), tr("Along the view direction")),
                (
                    tr("A corner"),
                    tr(
                        "The field of view, or that corner of a lens with a window; with Shift"
                        " both sides"
                    ),
                ),
                (tr("A lamp, a point"), tr("What the scene has it for; with Shift up and down")),
            ),
            tr("The picture in the image pane"): (
                (tr("Drag, or arrows"), tr("Move the camera in its plane")),
                (tr("Wheel, or + and −"), tr("Go nearer to the target, or back")),
            ),
            tr("Points to follow"): (
                (tr("Click"), tr("Follow the point through all panes")),
                (tr("Drag its mark in the image"), tr("In its plane; with Shift along its ray")),
                (tr("Esc"), tr("Remove it")),
            ),
            tr("Without a mouse, in a pane that Tab has reached"): (
                (
                    tr("Page Down, Page Up"),
                    tr("From vertex to vertex; with Shift from mark to mark"),
                ),
                (tr("Space"), tr("Follow the vertex")),
                (
                    tr("Enter"),
                    tr("Take hold, and let go; with Shift it holds as a Shift-drag does"),
                ),
                (tr("Arrows, while held"), tr("Drag by a pixel; with Shift by ten; Esc puts back")),
            ),
            tr("Controls"): (
                (tr("Slider"), tr("Drag it; with Shift ten times finer")),
                (tr("Wheel"), tr("With Ctrl, or once it has the focus")),
                (
                    tr("Field"),
                    tr(
                        "Type a number, also beyond the slider's ends, and Enter; Esc takes back"
                        " what was typed"
                    ),
                ),
                (tr("Double-click its name"), tr("Reset it")),
                (tr("The triangle"), tr("Let it run to and fro")),
            ),
            tr("The strip of stages"): (
                (tr("← →"), tr("From stop to stop")),
                (tr("Page Up, Page Down"), tr("A small step; Home and End go to its ends")),
            ),
            tr("Matrices"): (
                (
                    tr("Double-click, F2 or Enter"),
                    tr("Type another number into view ← world or clip ← view"),
                ),
                (tr("Tab"), tr("The next number; Esc leaves it")),
            ),
            tr("Presenting"): (
                (
                    _key("F5"),
                    tr("The panes fill the screen, in letters for the back row; again: end"),
                ),
                (_key("B"), tr("A black screen, and back")),
                (_key("P"), tr("Mark in all panes what the mouse is over")),
                (tr("Mouse at the top"), tr("The tool bar comes")),
            ),
            tr("Pointing"): (
                (
                    tr("Rest on anything"),
                    tr(
                        "The same plane, edge, corner, axis, word, control or matrix cell is marked"
                        " wherever it is; so does the keyboard's focus"
                    ),
                ),
            ),
        }
        rows = "".join(
            f"<tr><td colspan=2><h4>{escape(title)}</h4></td></tr>"
            + "".join(
                f"<tr><td><b>{escape(keys)}</b></td><td>{escape(does)}</td></tr>"
                for keys, does in lines
            )
            for title, lines in groups.items()
        )
        page = QTextBrowser()
        page.setHtml(f"<table cellpadding=3>{rows}</table>")
        dialog = QDialog(self._window)
        dialog.setWindowTitle(tr("Keys and mouse"))
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(dialog.close)
        layout = QVBoxLayout(dialog)
        layout.addWidget(page)
        layout.addWidget(buttons)
        em = page.fontMetrics().height()
        dialog.resize(
            QSize(42 * em, 48 * em).boundedTo(self._window.screen().availableSize() * 0.9)
        )
        dialog.show()

    def show_conventions(self) -> None:
        """Say which way axes, depths and pixels run."""
        self._tell(
            self.tr("Conventions"),
            self.tr(
                "<p>Column vectors, <i>p' = M p</i>. World and view are right-handed with y up;"
                " the camera looks along −z of view space.</p>"
                "<p>Camera frame: <i>n</i> = (eye − target)/|·|, <i>u</i> = up × n/|·|,"
                " <i>v</i> = n × u.</p>"
                "<p>NDC is the OpenGL cube [−1, 1]³, near at −1 and far at +1; Direct3D has z in"
                " [0, 1], reversed in [1, 0]. It is drawn with z mirrored so that the near face is"
                " towards you.</p>"
                "<p>Image: origin top left, x right, y down, in pixels; the first pixel's centre"
                " is at 0.5.</p>"
            ),
        )

    def show_about(self) -> None:
        """Say what this program is, and its version."""
        self._tell(
            self.tr("About Frustum Lab"),
            self.tr(
                "<p><b>Frustum Lab {0}</b></p><p>How a camera turns a 3-D scene into a picture:"
                " the world, the NDC cube and the image, from one model.</p><p>MIT licence.</p>"
            ).format(__version__),
        )

    def _tell(self, title: str, text: str) -> None:
        box = QMessageBox(QMessageBox.Icon.NoIcon, title, text, parent=self._window)
        box.setModal(False)
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        box.show()
