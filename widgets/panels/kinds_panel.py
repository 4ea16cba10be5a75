"""The tree of planar projections: a click sets a kind; the current kind is highlighted.

The model (`app.lecture.kinds`) finds the kind of any picture, and projects the small cubes.
"""

from dataclasses import replace
from functools import lru_cache, partial

import numpy as np
from PySide6 import QtGui
from PySide6.QtCore import QCoreApplication, QEvent, QPointF, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtWidgets import QAbstractButton, QSizePolicy, QWidget

from app.drawings.style import LIGHT, Style
from app.lecture.kinds import KINDS, ProjectionKind, kind_of, path, scale_factors, with_kind
from app.model.projection import Array, Camera, Perspective, Projection
from app.model.refusal import Refusal
from app.scenes.shapes import box_faces
from widgets.parts.layouts import RING_PX, FittedWidget, LetteredWidget, in_column
from widgets.parts.messages import of_phenomena, read_text, sentence
from widgets.parts.panel import PROJECTION, Changed, ReadablePanel, ShownData, faded
from widgets.parts.plain import PlainLabel

_OF_CUBE = Projection(
    Camera((0.0, 0.0, 2.6), (0.0, 0.0, 0.0)), Perspective(60.0, 0.5, 10.0), (640, 640)
)
_CUBE = box_faces((-1.4, -1.5, -0.5), (-0.4, -0.5, 0.5))
"""Position of the cube, off the axis so that a perspective from the front shows three faces."""
_TINT = 0.45
_LEAST_ICON, _GAP_PX, _PAD_PX = 18, 7, 4
_SMALLEST = 0.72  # least text scale of the leaves, in a narrow panel with large letters


def _text(text: str) -> str:
    return QCoreApplication.translate("Kind", text)


@lru_cache(maxsize=len(KINDS))
def _cube(kind: str) -> list[tuple[int, Array]]:
    """Return the visible faces of a cube: number, and corners in pixels of a picture."""
    projection = with_kind(_OF_CUBE, kind)
    faces = []
    for number, corners in enumerate(_CUBE):
        x, y = projection.trace(corners).image.T
        area = float(x @ np.roll(y, -1) - y @ np.roll(x, -1))
        if area < -1.0:  # y runs down, so that visible faces run clockwise
            faces.append((number, np.column_stack([x, y])))
    return faces


_ACROSS = tuple(int(np.ptp(corners, axis=0).argmin()) for corners in _CUBE)
"""The axis at right angles to each face."""


class _Node(QAbstractButton):
    """A node of the tree; a click, Space or Enter chooses its kind."""

    pointed = Signal(str)  # the kind under the mouse or the focus; empty when it is left

    def __init__(self, kind: ProjectionKind, parent: QWidget) -> None:
        super().__init__(parent)
        self._kind = kind
        self.is_leaf = kind.name not in {each.parent for each in KINDS.values()}
        self._on_path = False
        self._style = LIGHT
        self.scale = 1.0  # scale of the letters
        self.setText(_text(kind.title))
        self.setAccessibleName(_text(kind.title))
        self.setCheckable(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def show_state(self, *, lit: bool, on_path: bool, style: Style) -> None:
        """Highlight the node if the picture is of this kind, or mark it if a kind below is."""
        self.setChecked(lit)
        self._on_path, self._style = on_path, style
        said = _text(self._kind.condition)
        if lit:
            said = self.tr("the picture is of this kind now: {0}").format(said)
        self.setAccessibleDescription(said)
        self.update()

    def nextCheckState(self) -> None:
        """Do nothing: a click changes the projection, which then highlights a node."""

    def font_of(self) -> QtGui.QFont:
        """Return a bold font on the path, because colour is never the only sign."""
        font = QtGui.QFont(self.font())
        font.setBold(self._on_path)
        font.setPointSizeF(self.scale * font.pointSizeF())
        return font

    def sizeHint(self) -> QSize:
        bold = QtGui.QFont(self.font())
        bold.setBold(True)
        metrics = QtGui.QFontMetrics(bold)
        high = metrics.height() + _PAD_PX + (_LEAST_ICON + _PAD_PX if self.is_leaf else 0)
        return QSize(metrics.horizontalAdvance(self.text()) + 3 * _PAD_PX, high)

    def paintEvent(self, event: QtGui.QPaintEvent) -> None:
        painter, roles = QtGui.QPainter(self), QtGui.QPalette.ColorRole
        painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        lit, colours = self.isChecked(), self.palette()
        edge = colours.color(roles.Highlight if self._on_path else roles.PlaceholderText)
        wide = 2.0 if self._on_path else 1.0
        box = QRectF(self.rect()).adjusted(1.5, 1.5, -1.5, -1.5)
        hovered = self.underMouse() or self.hasFocus()
        ground = roles.Highlight if lit else roles.Midlight if hovered else roles.Base
        painter.setPen(QtGui.QPen(edge, wide))
        painter.setBrush(colours.color(ground))
        painter.drawRoundedRect(box, 4.0, 4.0)
        painter.setFont(self.font_of())
        line = painter.fontMetrics().height()
        below = QRectF(self.rect())
        if self.is_leaf:
            below = QRectF(0.0, self.height() - line - _PAD_PX / 2, self.width(), line)
            room = QRectF(0.0, _PAD_PX, self.width(), below.top() - _PAD_PX)
            if lit:  # the cube has the panes' colours, with their background
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(colours.color(roles.Base))
                painter.drawRoundedRect(room.adjusted(4.0, 0.0, -4.0, 0.0), 3.0, 3.0)
            self._paint_cube(painter, room.adjusted(6.0, 2.0, -6.0, -2.0))
        painter.setPen(colours.color(roles.HighlightedText if lit else roles.Text))
        painter.drawText(below, Qt.AlignmentFlag.AlignCenter, self.text())
        if self.hasFocus():
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QtGui.QPen(colours.color(roles.Text), RING_PX))
            painter.drawRoundedRect(box.adjusted(1.0, 1.0, -1.0, -1.0), 3.0, 3.0)
        painter.end()

    def _paint_cube(self, painter: QtGui.QPainter, room: QRectF) -> None:
        faces = _cube(self._kind.name)
        corners = np.concatenate([face for _, face in faces])
        low, size = corners.min(axis=0), np.ptp(corners, axis=0)
        scale = min(room.width() / size[0], room.height() / size[1])
        middle = np.array([room.center().x(), room.center().y()])
        names = self._style.u, self._style.v, self._style.n
        painter.setPen(QtGui.QPen(self.palette().color(QtGui.QPalette.ColorRole.Text), 1.0))
        for number, face in faces:
            painter.setBrush(faded(names[_ACROSS[number]], _TINT))
            places = middle + scale * (face - low - size / 2.0)
            painter.drawPolygon(QtGui.QPolygonF([QPointF(x, y) for x, y in places.tolist()]))

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.click()
        else:
            super().keyPressEvent(event)

    def event(self, event: QEvent) -> bool:
        done, kinds = super().event(event), QEvent.Type
        if event.type() in (kinds.Enter, kinds.FocusIn):
            self.pointed.emit(self._kind.name)
        elif event.type() in (kinds.Leave, kinds.FocusOut):
            self.pointed.emit("")
        return done


class _Tree(FittedWidget, LetteredWidget, QWidget):
    """The nodes, level below level, and the lines between them; the leaves stand in one row."""

    def __init__(self) -> None:
        super().__init__()
        self.nodes = {name: _Node(kind, self) for name, kind in KINDS.items()}
        self.leaves = [name for name, node in self.nodes.items() if node.is_leaf]
        self.levels = 1 + max(len(path(name)) for name in KINDS if name not in self.leaves)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def minimumSizeHint(self) -> QSize:
        sizes = {name: node.sizeHint() for name, node in self.nodes.items()}
        inner = max(size.height() for name, size in sizes.items() if name not in self.leaves)
        leaf = max(sizes[name].height() for name in self.leaves)
        wide = max(sizes[name].width() for name in self.leaves) + 2
        high = (self.levels - 1) * (inner + _GAP_PX) + leaf
        return QSize(round(_SMALLEST * len(self.leaves) * wide), high)

    def sizeHint(self) -> QSize:
        return self.minimumSizeHint()

    def _fit(self) -> None:
        inner = max(
            node.sizeHint().height() for name, node in self.nodes.items() if name not in self.leaves
        )
        column = self.width() / len(self.leaves)
        widest = max(self.nodes[name].sizeHint().width() for name in self.leaves)
        for name in self.leaves:
            self.nodes[name].scale = min(1.0, max(_SMALLEST, (column - 2) / widest))
        middles = {name: (i + 0.5) * column for i, name in enumerate(self.leaves)}
        for name in reversed(self.nodes):  # children first
            if name not in middles:
                below = [middles[kind.name] for kind in KINDS.values() if kind.parent == name]
                middles[name] = (min(below) + max(below)) / 2.0
        for name, node in self.nodes.items():
            level = self.levels - 1 if name in self.leaves else len(path(name)) - 1
            top = level * (inner + _GAP_PX)
            size = QSize(node.sizeHint().width() + 8, inner)
            if name in self.leaves:
                size = QSize(int(column) - 2, self.height() - top)
            left = round(middles[name] - size.width() / 2.0)
            node.setGeometry(QRect(left, top, size.width(), size.height()))
        self.update()

    def paintEvent(self, event: QtGui.QPaintEvent) -> None:
        painter, roles = QtGui.QPainter(self), QtGui.QPalette.ColorRole
        branches = [(kind.parent, name) for name, kind in KINDS.items() if kind.parent]
        # The path to the picture's kind is drawn last, over the other lines.
        for parent, name in sorted(branches, key=lambda way: self.nodes[way[1]].font_of().bold()):
            on_path = self.nodes[name].font_of().bold()
            colour = self.palette().color(roles.Highlight if on_path else roles.PlaceholderText)
            painter.setPen(QtGui.QPen(colour, 2.0 if on_path else 1.0))
            above, below = self.nodes[parent].geometry(), self.nodes[name].geometry()
            start = QPointF(above.center().x(), above.bottom())
            end = QPointF(below.center().x(), below.top())
            bend = start.y() + _GAP_PX / 2.0
            corners = [start, QPointF(start.x(), bend), QPointF(end.x(), bend), end]
            painter.drawPolyline(QtGui.QPolygonF(corners))
        painter.end()


class KindsPanel(LetteredWidget, ReadablePanel):
    """The tree, and below it the condition and the scale factors of a kind."""

    concerns = PROJECTION | {"scene", "settings"}

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Kinds of projection"))
        self._shown: ShownData | None = None
        self._pointed = ""
        self._tree = _Tree()
        self.nodes = self._tree.nodes
        for name, node in self.nodes.items():
            node.clicked.connect(partial(self._set, name))
            node.pointed.connect(self._point)
        self.condition = PlainLabel(wordWrap=True, alignment=Qt.AlignmentFlag.AlignTop)
        in_column((self._tree, 1), self.condition, on=self, margins=(4, 0, 4, 2), gap=4)
        self._fit()

    def _fit(self) -> None:
        """Reserve two lines under the tree, so that it does not jump."""
        self.condition.setFixedHeight(2 * self.fontMetrics().lineSpacing() + 2)

    def take(self, shown: ShownData, changed: Changed) -> None:
        self._shown = shown
        self._readable.changed()

    def _set(self, kind: str) -> None:
        if self._shown is None:
            return
        try:
            projection = with_kind(self._shown.projection, kind)
        except Refusal as error:
            self.refused.emit(sentence(error))
        else:
            self.edited.emit(projection)

    def _point(self, kind: str) -> None:
        focused = next((name for name, node in self.nodes.items() if node.hasFocus()), "")
        self._pointed = kind or focused
        self._fill()

    def _fill(self) -> None:
        if self._shown is None:
            return
        now = kind_of(self._shown.projection)
        way = () if now is None else path(now)
        for name, node in self.nodes.items():
            node.show_state(lit=name == now, on_path=name in way, style=self._style)
        self._tree.update()
        self.condition.setText(self._description(now))

    def _description(self, now: str | None) -> str:
        """Describe the kind under the pointer, or else the current one, with scale factors."""
        assert self._shown is not None
        about = self._pointed or now
        if about is None:
            return self.tr(
                "A free matrix belongs to no kind. Choose a kind, and its lens replaces the matrix."
            )
        kind = KINDS[about]
        text = self.tr("{0}: {1}.").format(_text(kind.title), _text(kind.condition))
        is_so = now is not None and about in path(now)
        projection = self._shown.projection
        try:
            projection = projection if is_so else with_kind(projection, about)
        except Refusal as error:
            return self.tr("{0} Not possible here: {1}").format(text, sentence(error))
        return f"{text} {self._drawn(projection, is_so)}"

    def _drawn(self, projection: Projection, is_so: bool) -> str:
        assert self._shown is not None
        factors = scale_factors(projection)
        if factors is None:
            text = self.tr("No scale factors: things farther away are drawn smaller.")
        else:
            text = self.tr("A unit would be drawn {0} long along x, {1} along y, {2} along z.")
            if is_so:
                text = self.tr("A unit is drawn {0} long along x, {1} along y, {2} along z.")
            text = text.format(*map(read_text, factors))
        document = replace(self._shown.document, projection=projection)
        illustration = ShownData.of(document, self._shown.scene).illustration
        if illustration is not None and illustration.warning is not None:
            why = illustration.warning.sentence(of_phenomena, read_text)
            text = self.tr("{0} This scene: {1}.").format(text, why)
        return text
