"""What the Help menu tells: short texts in boxes that do not stop the work."""

from __future__ import annotations

import sys

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QMessageBox, QWidget

from app import __version__

PLAY_KEY, FULL_SCREEN_KEY = (
    ("Ctrl+Shift+Space", "Ctrl+Meta+F")  # where Ctrl is ⌘, and the system has taken ⌘Space and F11
    if sys.platform == "darwin"
    else ("Ctrl+Space", "F11")
)


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
        """Say what keys and mouse do."""
        self._tell(
            self.tr("Keys and mouse"),
            self.tr(
                "<p>Drag in the world or the NDC pane to turn that pane's own view, Shift-drag to"
                " move it, wheel to zoom, double-click to put it back. By keys: Tab to the pane,"
                " arrows, Shift and arrows, + and −, Home. The model is not touched.</p>"
                "<p>Drag a mark in the world pane to move the model itself: the eye and the target"
                " in the plane that faces you (Shift: up and down), the near and the far plane"
                " along the view direction, a corner to change the field of view or, of a lens"
                " with a window, that corner (Shift: both sides). Drag the picture to move the"
                " camera in its plane, wheel there to go nearer to the target. Esc puts back what"
                " you are dragging.</p>"
                "<p>Click a point in any pane to follow it through all of them; drag its mark in"
                " the image to move it in its plane, Shift-drag along its ray; Esc removes it.</p>"
                "<p>All of this without a mouse: Tab to a pane, where Page Down and Page Up go from"
                " vertex to vertex, with Shift from mark to mark. Space follows the vertex. Enter"
                " takes hold and lets go; between, arrows drag by a pixel, with Shift by ten, and"
                " Esc puts back. Shift and Enter take hold as a Shift-drag does. In the image pane"
                " arrows move the camera in its plane, + and − go nearer and back.</p>"
                "<p>Point at a plane, an edge, a corner, an axis, a word, a control or a matrix"
                " cell: the same thing is marked wherever it is. The keyboard's focus in a control"
                " or a cell does the same.</p>"
                "<p>The scene stands at the top of the controls: what to try, what matters for it,"
                " its numbers. The triangle beside a setting lets it run to and fro; one that is a"
                " point, such as a lamp, has a mark in the world pane to be dragged (Shift: up"
                " and down). The context menu of a diagram copies or exports it.</p>"
                "<p>The strip below the NDC pane: drag it, or press ← → (or ↑ ↓) to go from stop to"
                " stop, PageUp and PageDown for a small step, Home and End for its ends; a click"
                " on a name goes there, the triangle plays.</p>"
                "<p>Double-click a pane's title to make it large; again, as large as the window,"
                " and back. {4}, {5} and {6} do the same for world, NDC cube and image; {7} goes"
                " back to all panes. Esc leaves what is on top.</p>"
                "<p>F5 presents: the panes fill the screen, in letters for the back row. The tool"
                " bar comes when the mouse is at the top of the screen. B blanks the screen, P"
                " marks in all panes what the mouse is over.</p>"
                "<p>Each control: drag the slider (Shift: ten times finer), turn the wheel on it"
                " with Ctrl or once it has the focus, or type a number, also beyond the slider's"
                " ends, and press Enter; Esc takes back what you typed; double-click the name to"
                " reset it. Ctrl+F or / finds a control by its name.</p>"
                "<p>Matrices: double-click a number of view ← world or clip ← view (F2 or Enter)"
                " to type another; Tab goes on to the next, Esc leaves it.</p>"
                "<p>{0} plays the orbit, {1} undoes (a drag is one step), {2} resets all, {3}"
                " exports, F4 hides the controls.</p>"
                "<p>Drop a document, a mesh (OBJ, STL, PLY, glTF) or an exported picture on the"
                " window to open it.</p>"
            ).format(
                *(
                    QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)
                    for key in (
                        PLAY_KEY,
                        "Ctrl+Z",
                        "Ctrl+R",
                        "Ctrl+E",
                        "Ctrl+1",
                        "Ctrl+2",
                        "Ctrl+3",
                        "Ctrl+0",
                    )
                )
            ),
        )

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
