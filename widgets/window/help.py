"""The Help menu: short texts in windows that do not block the main window."""

from __future__ import annotations

import sys

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QMessageBox, QTextEdit, QWidget

from app import __version__
from widgets.parts.layouts import in_column
from widgets.parts.plain import Markup, TextDocument, message_box

PLAY_KEY, FULL_SCREEN_KEY = (
    ("Ctrl+Shift+Space", "Ctrl+Meta+F")  # Ctrl is ⌘ there, and the system uses ⌘Space and F11
    if sys.platform == "darwin"
    else ("Ctrl+Space", "F11")
)


def _key(keys: str) -> str:
    """Write a shortcut in this system's form."""
    return QKeySequence(keys).toString(QKeySequence.SequenceFormat.NativeText)


class Help(QObject):
    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window

    def show_keys(self) -> None:
        """Show a table of keys and mouse actions, which scrolls on a low screen."""
        one, two, three, back = (_key(f"Ctrl+{number}") for number in "1230")
        groups = {
            self.tr("Everywhere"): (
                (_key("Ctrl+Z"), self.tr("Undo; a drag is one step")),
                (_key("Ctrl+R"), self.tr("Reset all to how the scene opens")),
                (_key(PLAY_KEY), self.tr("Play or pause the camera's walk")),
                (_key("Ctrl+E"), self.tr("Export the panes as a picture")),
                (_key("Ctrl+F") + self.tr(" or /"), self.tr("Find a control by its name")),
                (_key("F4"), self.tr("Hide the controls, or show them")),
                (self.tr("Esc"), self.tr("Leave what is on top; put back what is being dragged")),
                (self.tr("Drop a file"),
                 self.tr("Open a document, a lesson, a mesh (OBJ, STL, PLY, glTF) or an exported"
                         " picture")),
            ),
            self.tr("Where the panes stand"): (
                (f"{one}, {two}, {three}", self.tr("World, NDC cube, image into the large slot")),
                (self.tr("again, or double-click a title"),
                 self.tr("The whole window for that pane")),
                (back, self.tr("All panes, as the scene has them")),
            ),
            self.tr("A pane's own view (the model is not touched)"): (
                (self.tr("Drag"), self.tr("Turn it")),
                (self.tr("Shift-drag"), self.tr("Move it")),
                (self.tr("Wheel"), self.tr("Nearer, farther")),
                (self.tr("Double-click"), self.tr("Back to how it was")),
                (self.tr("Tab, then arrows"),
                 self.tr("Turn; with Shift move; + and − nearer, farther; Home")),
            ),
            self.tr("Marks in the world pane (these move the model)"): (
                (self.tr("Eye, target"),
                 self.tr("In the plane that faces you; with Shift up and down")),
                (self.tr("Near, far"), self.tr("Along the view direction")),
                (self.tr("A corner"),
                 self.tr("The field of view, or that corner of a lens with a window; with Shift"
                         " both sides")),
                (self.tr("A lamp, a point"),
                 self.tr("What the scene has it for; with Shift up and down")),
            ),
            self.tr("The picture in the image pane"): (
                (_key("F6"), self.tr("Hold it and compare it with what comes; again, end that")),
                (_key("Shift+F6"), self.tr("What is compared side by side, or over each other")),
                (self.tr("Tab to the divider, then arrows"),
                 self.tr("Move it; with Shift finer; Home and End; Esc ends the comparison")),
                (self.tr("Drag, or arrows"), self.tr("Move the camera in its plane")),
                (self.tr("Wheel, or + and −"), self.tr("Go nearer to the target, or back")),
            ),
            self.tr("Points to follow"): (
                (self.tr("Click"), self.tr("Follow the point through all panes")),
                (self.tr("Drag its mark in the image"),
                 self.tr("In its plane; with Shift along its ray")),
                (self.tr("Esc"), self.tr("Remove it")),
            ),
            self.tr("Without a mouse, in a pane that Tab has reached"): (
                (self.tr("Page Down, Page Up"),
                 self.tr("From vertex to vertex; with Shift from mark to mark")),
                (self.tr("Space"), self.tr("Follow the vertex")),
                (self.tr("Enter"),
                 self.tr("Take hold, and let go; with Shift it holds as a Shift-drag does")),
                (self.tr("Arrows, while held"),
                 self.tr("Drag by a pixel; with Shift by ten; Esc puts back")),
            ),
            self.tr("Controls"): (
                (self.tr("Slider"), self.tr("Drag it; with Shift ten times finer")),
                (self.tr("Wheel"), self.tr("With Ctrl, or once it has the focus")),
                (self.tr("Field"),
                 self.tr("Type a number, also beyond the slider's ends, and Enter; Esc takes back"
                         " what was typed")),
                (self.tr("Double-click its name"), self.tr("Reset it")),
                (self.tr("The triangle"), self.tr("Let it run to and fro")),
            ),
            self.tr("The strip of stages"): (
                (self.tr("← →"), self.tr("From stop to stop")),
                (self.tr("Page Up, Page Down"),
                 self.tr("A small step; Home and End go to its ends")),
            ),
            self.tr("Matrices"): (
                (self.tr("Double-click, F2 or Enter"),
                 self.tr("Type another number into view ← world or clip ← view")),
                (self.tr("Tab"), self.tr("The next number; Esc leaves it")),
            ),
            self.tr("Lessons"): (
                (_key("Alt+Right"),
                 self.tr("The next step; {0} the one before").format(_key("Alt+Left"))),
                (_key("F7"), self.tr("Show the step again, whatever was tried")),
                (_key("Alt+I"), self.tr("A hint; Alt+W shows what refutes a wrong answer")),
                (self.tr("Arrows, Enter"),
                 self.tr("Choose, and commit it; Enter checks what is typed as well")),
            ),
            self.tr("Presenting"): (
                (_key("F5"),
                 self.tr("The panes fill the screen, in letters for the back row; again: end")),
                (_key("B"), self.tr("A black screen, and back")),
                (_key("P"), self.tr("Mark in all panes what the mouse is over")),
                (self.tr("Mouse at the top"), self.tr("The tool bar comes")),
            ),
            self.tr("Presenting a talk, and in the speaker's window"): (
                (self.tr("Page Down, Page Up"),
                 self.tr("The answer to what is asked, then the next step; the step before")),
                (self.tr("Digits, then Enter"), self.tr("To the step of that number")),
                (_key("V"), self.tr("The answer to what the class has voted on")),
                (_key("F7"), self.tr("The step again, whatever was tried")),
                (_key("W"), self.tr("Class and notes change screens")),
                (self.tr(". or B"), self.tr("A black screen, and back")),
                (_key("Ctrl++") + ", " + _key("Ctrl+-"), self.tr("The speaker's notes larger")),
            ),
            self.tr("Pointing"): (
                (self.tr("Rest on anything"),
                 self.tr("The same plane, edge, corner, axis, word, control or matrix cell is"
                         " marked wherever it is; so does the keyboard's focus")),
            ),
        }  # fmt: skip
        rows = "".join(
            Markup.of("<tr><td colspan=2><h4>{}</h4></td></tr>", title)
            + "".join(Markup.of("<tr><td><b>{}</b></td><td>{}</td></tr>", *line) for line in lines)
            for title, lines in groups.items()
        )
        page = QTextEdit(readOnly=True)
        page.setDocument(TextDocument(page))
        page.setHtml(f"<table cellpadding=3>{rows}</table>")
        dialog = QDialog(self._window)
        dialog.setWindowTitle(self.tr("Keys and mouse"))
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(dialog.close)
        in_column(page, buttons, on=dialog)
        em = page.fontMetrics().height()
        dialog.resize(
            QSize(42 * em, 48 * em).boundedTo(self._window.screen().availableSize() * 0.9)
        )
        dialog.show()

    def show_conventions(self) -> None:
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
        self._tell(
            self.tr("About Frustum Lab"),
            self.tr(
                "<p><b>Frustum Lab {0}</b></p><p>How a camera turns a 3-D scene into a picture:"
                " the world, the NDC cube and the image, from one model.</p><p>MIT licence.</p>"
            ).format(__version__),
        )

    def _tell(self, title: str, text: str) -> None:
        box = message_box(self._window, Markup(text), icon=QMessageBox.Icon.NoIcon)
        box.setWindowTitle(title)
        box.setModal(False)
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        box.show()
