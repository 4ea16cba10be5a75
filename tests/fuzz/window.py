"""A fixed script of user actions in the window, and what is seen after each step."""

import json
import os
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from PySide6 import QtCore, QtGui, QtWidgets
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.commands.cli import main as run_command

LEFT = Qt.MouseButton.LeftButton
DOCUMENT: dict[str, Any] = {
    "format": "frustum-lab", "version": 1, "scene": "letter-f",
    "camera": {"eye": [6, 5, 9], "target": [0, 2.2, 0], "up": [0, 1, 0]},
    "lens": {"kind": "perspective", "fov_y_deg": 45, "near": 1, "far": 30},
    "depth": "opengl", "image": {"width": 1280, "height": 720},
}  # fmt: skip
"""What the window opens."""


class Window:
    """The window as a user has it: widgets are found by the text on them."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self.window = next(
            widget
            for widget in QtWidgets.QApplication.topLevelWidgets()
            if isinstance(widget, QtWidgets.QMainWindow)
        )
        self.repaints: dict[str, int] = {}
        for name in ("World", "NDC cube", "Image"):
            self.repaints[name] = 0
            drawn = self.canvas(name).render_window
            drawn.AddObserver("EndEvent", lambda *_, name=name: self._drawn(name))

    def canvas(self, name: str) -> Any:
        """The widget that draws a pane: it has the pane's name and VTK's window."""
        until = time.monotonic() + 60.0
        while time.monotonic() < until:  # the window is seen before its panes are filled
            for widget in self.window.findChildren(QtWidgets.QWidget):
                if widget.accessibleName() == name and hasattr(widget, "render_window"):
                    return widget
            QtWidgets.QApplication.processEvents()
        raise AssertionError(name)

    def _drawn(self, name: str) -> None:
        self.repaints[name] += 1

    def named(self, widget: Any) -> set[str]:
        """All names that a user may give a widget."""
        names = {widget.accessibleName()}
        if isinstance(widget, (QtWidgets.QAbstractButton, QtWidgets.QLabel)):
            names.add(widget.text().replace("&", ""))
        return names

    def find(self, kind: str, name: str) -> Any:
        """The visible widget of a kind of Qt's with a name."""
        found = [
            widget
            for widget in self.window.findChildren(getattr(QtWidgets, kind))
            if name in self.named(widget) and widget.isVisible()
        ]
        if not found:
            raise LookupError(f"no {kind} named {name!r} is to be seen")
        widget = found[0]
        parent = widget.parentWidget()
        while parent is not None:  # it may have to be scrolled to
            if isinstance(parent, QtWidgets.QScrollArea):
                parent.ensureWidgetVisible(widget)
            parent = parent.parentWidget()
        self.wait(0)
        return widget

    def wait(self, ms: int) -> None:
        for _ in range(5):
            QtWidgets.QApplication.processEvents()
        if ms:
            QTest.qWait(ms)

    # -- what a hand does

    def drag(self, name: str, *steps_px: int) -> None:
        """Drag a slider's handle by so many pixels, step by step."""
        slider = self.find("QSlider", f"{name}, slider")
        option = QtWidgets.QStyleOptionSlider()
        slider.initStyleOption(option)
        style = QtWidgets.QStyle
        handle = slider.style().subControlRect(
            style.ComplexControl.CC_Slider, option, style.SubControl.SC_SliderHandle, slider
        )
        place = handle.center()
        QTest.mousePress(slider, LEFT, pos=place)
        self.wait(0)
        for step in steps_px:
            place = place + QtCore.QPoint(step, 0)
            self.move(slider, place, held=True)
        QTest.mouseRelease(slider, LEFT, pos=place)

    def move(self, widget: Any, place: Any, held: bool = False) -> None:
        """Move the mouse, at once, and with a button held if asked."""
        event = QtGui.QMouseEvent(
            QtCore.QEvent.Type.MouseMove,
            QtCore.QPointF(place),
            QtCore.QPointF(widget.mapToGlobal(place)),
            Qt.MouseButton.NoButton,
            LEFT if held else Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
        )
        QtWidgets.QApplication.sendEvent(widget, event)
        self.wait(0)

    def type(self, name: str, text: str) -> None:
        """Type a number into a field, and Enter."""
        field = self.find("QLineEdit", name)
        field.setFocus()
        field.selectAll()
        QTest.keyClicks(field, text)
        QTest.keyClick(field, Qt.Key.Key_Return)

    def choose(self, name: str, text: str) -> None:
        """Choose from a list."""
        box = self.find("QComboBox", name)
        index = box.findText(text)
        if index < 0:
            raise LookupError(f"{name} offers no {text!r}")
        box.setCurrentIndex(index)
        box.activated.emit(index)

    def press(self, name: str) -> None:
        QTest.mouseClick(self.find("QAbstractButton", name), LEFT)

    def act(self, text: str) -> None:
        """Choose an action of the menus."""
        actions = self.window.findChildren(QtGui.QAction)
        found = [action for action in actions if action.text().replace("&", "") == text]
        if not found:
            raise LookupError(f"there is no action {text!r}")
        found[0].trigger()

    def place(self, widget: Any, across: float, down: float) -> Any:
        return QtCore.QPoint(round(across * widget.width()), round(down * widget.height()))

    def click(self, pane: str, across: float, down: float) -> None:
        canvas = self.canvas(pane)
        QTest.mouseClick(canvas, LEFT, pos=self.place(canvas, across, down))

    def swing(
        self, pane: str, x_px: int, y_px: int, start: tuple[float, float] = (0.03, 0.03)
    ) -> None:
        """Drag in a pane, from a place that is given in its width and height."""
        canvas = self.canvas(pane)
        begin = self.place(canvas, *start)
        QTest.mousePress(canvas, LEFT, pos=begin)
        for part in (0.5, 1.0):
            place = begin + QtCore.QPoint(round(part * x_px), round(part * y_px))
            self.move(canvas, place, held=True)
        QTest.mouseRelease(canvas, LEFT, pos=place)

    def hover(self, pane: str, across: float, down: float) -> None:
        canvas = self.canvas(pane)
        self.move(canvas, self.place(canvas, across, down))

    def point_at(self, name: str) -> None:
        """Move the mouse onto the row of a name, as Qt tells it."""
        row = self.find("QLabel", name).parentWidget()
        middle = QtCore.QPointF(row.rect().center())
        everywhere = QtCore.QPointF(row.mapToGlobal(row.rect().center()))
        QtWidgets.QApplication.sendEvent(row, QtGui.QEnterEvent(middle, middle, everywhere))

    def leave(self, name: str) -> None:
        row = self.find("QLabel", name).parentWidget()
        QtWidgets.QApplication.sendEvent(row, QtCore.QEvent(QtCore.QEvent.Type.Leave))

    def set_first(self) -> None:
        """Move the first slider of the scene's own settings, and step through its first list."""
        region = next(w for w in self._visible(self.window) if type(w).__name__ == "SceneCard")
        for slider in region.findChildren(QtWidgets.QSlider):
            if slider.isVisible() and slider.isEnabled():
                self.drag(slider.accessibleName().removesuffix(", slider"), 4, 3)
                break
        for box in region.findChildren(QtWidgets.QComboBox):
            if box.isVisible() and box.isEnabled():
                self.key("QComboBox", box.accessibleName(), "Down")
                break

    def key(self, kind: str, name: str, key: str) -> None:
        widget = self.find(kind, name)
        widget.setFocus()
        QTest.keyClick(widget, getattr(Qt.Key, f"Key_{key}"))

    def stage(self, value: int) -> None:
        """Move the strip's slider, as a screen reader does."""
        self.find("QSlider", "Stage").setValue(value)

    # -- what is seen

    def seen(self) -> dict[str, Any]:
        """The document, all text in the window, and the repaints since the last time."""
        status = self.window.status
        lines = sorted(self._texts(set(status.findChildren(QtWidgets.QWidget))))
        line = [text for w in self._visible(status) for text in self._said(w)]
        actions = {
            action.text().replace("&", "")
            for action in self.window.findChildren(QtGui.QAction)
            if action.isEnabled() and action.text() and not action.menu()
        }
        repaints = dict(self.repaints)
        title = self.window.windowTitle(), self.window.isWindowModified()
        self.act("Save")
        self.wait(0)
        found = {
            "document": self.file.read_text(encoding="utf-8"),
            "status line": line,
            "texts": lines,
            "actions": sorted(text.replace(str(self.file.parent), "HOME") for text in actions),
            "title": list(title),
            "repaints": repaints,
            "repaints of saving": {n: self.repaints[n] - repaints[n] for n in self.repaints},
        }
        self.repaints |= dict.fromkeys(self.repaints, 0)
        return found

    def _visible(self, inside: Any) -> list[Any]:
        return [w for w in inside.findChildren(QtWidgets.QWidget) if w.isVisible()]

    def _texts(self, but: set[Any]) -> Iterator[str]:
        for widget in self._visible(self.window):
            if widget not in but:
                yield from self._said(widget)

    def _said(self, widget: Any) -> Iterator[str]:
        """The text of a widget with its name, line by line."""
        name = widget.accessibleName()
        if isinstance(widget, QtWidgets.QAbstractItemView):
            model, root = widget.model(), QtCore.QModelIndex()
            is_list = isinstance(widget, QtWidgets.QListView)
            columns = range(1 if is_list else model.columnCount(root))
            for row in range(model.rowCount(root)):
                cells = [str(model.index(row, column).data() or "") for column in columns]
                yield f"{name}: {' | '.join(cells)}"
        elif isinstance(widget, QtWidgets.QComboBox):
            yield f"{name}: {widget.currentText()}"
        elif isinstance(widget, QtWidgets.QAbstractSlider):
            if name:  # no scroll bars
                yield f"{name}: {widget.value()}"
        elif isinstance(widget, QtWidgets.QAbstractButton):
            text = widget.text().replace("&", "")
            if text or name:
                marks = " checked" * widget.isChecked() + " disabled" * (not widget.isEnabled())
                yield f"[{name or text}]{marks} {text}"
        elif isinstance(widget, (QtWidgets.QLabel, QtWidgets.QLineEdit)):
            if widget.text():
                yield f"{name}: {widget.text()}" if name else widget.text()
        elif name and widget.accessibleDescription():  # such as a matrix: the cell under the cursor
            yield f"{name}: {widget.accessibleDescription()}"

    def matrices(self) -> str:
        """All that the Matrices panel shows, as its own button copies it."""
        button = self.find("QToolButton", "Copy all matrices")
        button.menu().actions()[0].trigger()
        return str(QtWidgets.QApplication.clipboard().text())


def script(user: Window) -> Iterator[tuple[str, Callable[[], object]]]:
    """A quarter of an hour's work: each step's name and action, in order."""
    yield "opens", lambda: None
    yield "idle", lambda: user.wait(700)
    yield "drag fov", lambda: user.drag("Field of view", 3, 4, -2)
    yield "drag near", lambda: user.drag("Near", -5, -5)
    yield "drag far", lambda: user.drag("Far", -12, 4)
    yield "type fov", lambda: user.type("Field of view (degrees)", "60,5")
    yield "type near", lambda: user.type("Near (world units)", "0.25")
    yield "type near beyond far", lambda: user.type("Near (world units)", "1e9")
    yield "type near again", lambda: user.type("Near (world units)", "0.5")
    yield "type far inf", lambda: user.type("Far (world units)", "inf")
    yield "undo", lambda: user.act("Undo")
    yield "undo twice", lambda: (user.act("Undo"), user.act("Undo"))
    yield "redo", lambda: user.act("Redo")
    for section in ("Image and depth range", "More of the lens"):
        yield f"unfold {section}", lambda section=section: user.press(section)
    yield "direct3d", lambda: user.choose("NDC z", "Direct3D: 0 to 1")
    yield "reversed", lambda: user.choose("NDC z", "reversed: 1 to 0")
    yield "4:3", lambda: user.press("Aspect: 4:3")
    for panel in ("Matrices", "Camera frame", "Probe", "Explanation and diagrams", "Precision"):
        yield f"open {panel}", lambda panel=panel: user.press(panel)
    yield "fold Precision", lambda: user.press("Precision")
    yield "open Matrices again", lambda: user.press("Matrices")
    yield "drag fov with matrices", lambda: user.drag("Field of view", -6, 2)
    yield "formulas", lambda: user.choose("Cells", "Formulas")
    yield "row vectors", lambda: user.choose("Vectors", "Row vectors")
    for lens in (OFF_AXIS, "orthographic", "oblique", "perspective"):
        yield f"lens {lens}", lambda lens=lens: user.choose("Lens", lens)
    yield "lens frustum again", lambda: user.choose("Lens", OFF_AXIS)
    yield "type left", lambda: user.type("Left (world units)", "-0.2")
    yield "keep x", lambda: user.key("QComboBox", "Proportions", "Down")
    yield "drag right", lambda: user.drag("Right", 4)
    yield "undo the drag", lambda: user.act("Undo")
    yield "perspective again", lambda: user.choose("Lens", "perspective")
    yield "open the frame", lambda: user.press("Camera frame")
    yield "next step", lambda: user.press("The next step")
    yield "and next", lambda: user.press("The next step")
    yield "nudge up", lambda: user.find("QPushButton", "Nudge up by 0.1° to the side").click()
    yield "all steps", lambda: user.press("All steps at once")
    yield "open the probe", lambda: user.press("Probe")
    yield "pick in the image", lambda: user.click("Image", 0.5, 0.5)
    yield "pick in the world", lambda: user.click("World", 0.45, 0.55)
    yield "pin", lambda: user.find("QPushButton", "Pin").click()
    yield "pick in the cube", lambda: user.click("NDC cube", 0.5, 0.5)
    yield "type x", lambda: user.type("Probe, world x", "0.75")
    yield "drag fov with probes", lambda: user.drag("Field of view", 3)
    yield "azimuth", lambda: user.drag("Azimuth", 5)
    yield "distance", lambda: user.type("Distance (world units)", "14")
    yield "stage: view", lambda: user.stage(240)
    yield "stage: between", lambda: user.stage(400)
    yield "drag near between stages", lambda: user.drag("Near", 3)
    yield "stage: image", lambda: user.stage(1200)
    yield "stage: NDC", lambda: user.stage(960)
    yield "point at near", lambda: user.point_at("Near")
    yield "leave near", lambda: user.leave("Near")
    yield "hover in the world", lambda: user.hover("World", 0.5, 0.5)
    yield "hover in the cube", lambda: user.hover("NDC cube", 0.5, 0.5)
    yield "hover in the image", lambda: user.hover("Image", 0.5, 0.5)
    yield "turn the world", lambda: user.swing("World", 60, 20)
    yield "turn the cube", lambda: user.swing("NDC cube", -40, 15)
    yield "move in the image", lambda: user.swing("Image", 30, 10, (0.4, 0.4))
    yield "drag in the world", lambda: user.swing("World", 25, 5, (0.5, 0.5))
    yield "views back", lambda: user.act("Reset the panes' own views")
    yield "enlarge the image", lambda: user.act("Image in large")
    yield "drag fov in a hidden row", lambda: user.drag("Field of view", 5)
    yield "all panes", lambda: user.act("Back to all panes")
    yield "present", lambda: user.act("Present")
    yield "present no more", lambda: user.act("Present")
    yield "dark", lambda: user.act("Dark")
    yield "light", lambda: user.act("Light")
    for scene in ("Unit cube", "Row of posts"):
        yield scene, lambda scene=scene: user.choose("Scene", scene)
    box = user.find("QComboBox", "Scene")
    titles = [box.itemText(i) for i in range(box.count()) if box.itemText(i)]
    for scene in titles[3:]:
        yield scene, lambda scene=scene: user.choose("Scene", scene)
        yield f"{scene}: settings", user.set_first
        yield f"{scene}: near", lambda: user.drag("Near", 4)
    yield "reset", lambda: user.act("Reset all")
    yield "undo the reset", lambda: user.act("Undo")


OFF_AXIS = "frustum (off-axis)"
LAID_OUT = ("enlarge the image", "all panes", "present", "present no more")
"""Steps at which Qt lays out the window as often as it can: only whether a pane repaints counts."""
REST_MS = 450
"""Time after which no timer is pending: the window counts pixels after 250 ms."""


def run_script() -> list[dict[str, Any]]:
    """Open the window by the command line, and run the script in it."""
    steps: list[dict[str, Any]] = []
    file = Path(os.environ["HOME"]) / "golden.json"
    file.write_text(json.dumps(DOCUMENT), encoding="utf-8")

    def work(*_: object) -> int:
        user = Window(file)
        user.wait(REST_MS)
        for name, act in script(user):
            step: dict[str, Any] = {"action": name}
            try:
                act()
            except LookupError as error:
                step["failed"] = str(error)
            user.wait(REST_MS)
            steps.append(step | user.seen())
            if name in LAID_OUT:
                found = steps[-1]["repaints"]
                steps[-1]["repaints"] = {pane: count > 0 for pane, count in found.items()}
            if name.startswith(("open Matrices", "formulas", "row", "lens", "type left", "keep")):
                steps[-1]["matrices"] = user.matrices()
        user.window.close()
        user.wait(0)
        return 0

    QtWidgets.QApplication.exec = staticmethod(work)  # type: ignore[method-assign]
    status = run_command([str(file), "--size", "1366x768", "--theme", "light"])
    if status != 0 or not steps:
        raise SystemExit(f"window: exit status {status}")
    return steps
