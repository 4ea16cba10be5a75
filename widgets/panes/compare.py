"""Pictures beside that of the image pane: held ones, or others that follow the document.

A class can see the worlds of those states instead. Each of the other pictures is a pane inside the
compared pane; it draws off the screen and keeps its pixels. The pictures are cut at dividers that
the user drags, or stand side by side, where the live picture becomes smaller. A held picture is not
drawn again. Mouse, handles and probes work in the live picture only.
"""

from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPalette, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.document.compare import ComparedPicture, DifferenceWriter, in_words, names_in
from app.document.settings import name_of, pictured
from app.drawings.side_by_side import places_of
from app.drawings.style import Style
from app.model.refusal import Refusal
from app.scenes.phenomena import PHENOMENA
from widgets.panes.canvas import ARROWS, RasterCanvas
from widgets.panes.pane import Pane
from widgets.parts.labels import Title
from widgets.parts.layouts import FittedWidget, FocusRing, in_row, tool_button
from widgets.parts.messages import field_name, of_phenomena, read_text, sentence
from widgets.parts.palette import LABEL_SHARE
from widgets.parts.panel import PROJECTION, ShownData
from widgets.parts.plain import PlainLabel, set_tip

GRASP_PX = 15  # width of a divider for the mouse; the painted line has a fifth of it
KEY_STEP = 0.02  # part of the picture's width for an arrow key; with Shift a tenth of it


class Divider(QWidget):
    """A line between two pictures that lie over each other."""

    moved = Signal(float)  # the mouse drags it to this place, in pixels from the surface's left
    stepped = Signal(float)  # a key moves it by this part of the picture's width; above 1 to an end
    left = Signal()  # Esc was pressed on it

    def __init__(self, surface: QWidget) -> None:
        super().__init__(surface)
        self.setAttribute(Qt.WidgetAttribute.WA_NoMousePropagation)  # it would enlarge the pane
        self.setCursor(Qt.CursorShape.SplitHCursor)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(self.tr("Divider between two pictures"))
        tip = self.tr(
            "Drag it, or press ← → (with Shift for finer steps), Home or End; Esc "
            "ends the comparison"
        )
        set_tip(self, tip)
        FocusRing(self)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self.moved.emit(self.mapToParent(event.position()).x())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = Qt.Key(event.key())
        finer = 0.1 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        if key in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            self.stepped.emit(ARROWS[key][0] * KEY_STEP * finer)
        elif key in (Qt.Key.Key_Home, Qt.Key.Key_End):
            self.stepped.emit(-2.0 if key == Qt.Key.Key_Home else 2.0)
        elif key == Qt.Key.Key_Escape:
            self.left.emit()  # works in the pane's own window too
        else:
            super().keyPressEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            colours, middle = self.palette(), self.width() / 2.0
            ink, plain = (colours.color(role) for role in (QPalette.ColorRole.WindowText,
                                                           QPalette.ColorRole.Base))  # fmt: skip
            painter.fillRect(QRectF(middle - 1.5, 0, 3, self.height()), plain)
            painter.fillRect(QRectF(middle - 0.5, 0, 1, self.height()), ink)
            knob = QRectF(0, 0, self.width() - 1, self.width() - 1)
            knob.moveCenter(QPointF(middle, self.height() / 2.0))
            painter.setPen(ink)
            painter.setBrush(plain)
            painter.drawEllipse(knob)
            painter.setBrush(ink)
            for side in (-1.0, 1.0):
                tip = knob.center() + QPointF(side * 0.33 * knob.width(), 0)
                back = QPointF(-side * 3, 0)
                painter.drawPolygon(
                    QPolygonF([tip, tip + back + QPointF(0, 3), tip + back - QPointF(0, 3)])
                )


class _Other(QWidget):
    """A picture beside the live one: a pane without mouse and keys, cut to its place."""

    def __init__(self, pane: Pane, picture: ComparedPicture) -> None:
        super().__init__(pane.surface)
        self.setAttribute(Qt.WidgetAttribute.WA_NoMousePropagation)
        self.picture = picture
        self._of = pane
        name = f"{pane.accessibleName()}: {picture.name}"
        self.pane = Pane(name, pane.make_drawing, orbits=False, make_canvas=RasterCanvas)
        self.pane.setFrameShape(Pane.Shape.NoFrame)
        self.pane.header.set_presenting(True, named=False)
        self.pane.canvas.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        set_tip(self.pane.canvas, "")
        self.pane.canvas.setMinimumSize(1, 1)
        self.pane.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.pane.setParent(self)
        self.why = PlainLabel(
            parent=self, wordWrap=True, alignment=Qt.AlignmentFlag.AlignCenter,
            autoFillBackground=True, visible=False,
        )  # fmt: skip
        """Says why there is no such picture."""
        self.shown: ShownData | None = None

    def refresh(self, shown: ShownData, smoothing: str) -> None:
        """Draw the picture again if it has changed."""
        try:
            document = pictured(shown.document, self.picture)
        except Refusal as error:
            self.shown = None
            self.why.setText(sentence(error))
        else:
            before = self.shown
            if before is None or before.scene is not shown.scene or before.document != document:
                self.shown = ShownData.of(document, shown.scene)
            assert self.shown is not None
            if self._of.canvas.is_open and not self.pane.canvas.is_open:
                self.pane.open()
            self._draw(self.shown, smoothing)
        self.why.setVisible(self.shown is None)

    def _draw(self, shown: ShownData, smoothing: str) -> None:
        """Draw as the live picture is drawn; a held picture as it is at rest."""
        pane, of = self.pane, self._of
        if of.built_with is not None and of.built_with is not pane.built_with:
            pane.build(shown, None, *of.built_with)
            pane.built_with = of.built_with
        elif shown is not pane.shown:
            pane.take(shown, PROJECTION)
        wanted = {what: of.requested[what] for what in ("layers", "names", "fixed", "step")}
        wanted |= {what: of.requested[what] for what in ("bare", "grips", "smoothing", "detail")}
        wanted |= {"view": of.view, "probes": tuple(each for each in of.probes if each.number)}
        if self.picture.held is not None:
            wanted |= {"smoothing": smoothing, "detail": None}
        for what, value in wanted.items():
            pane.request(what, value)

    def place(self, cut: QRect, whole: QRect) -> None:
        """Show the part `cut` of a pane that would fill `whole`."""
        self.setGeometry(cut)
        self.pane.setGeometry(whole.translated(-cut.topLeft()))
        self.pane.surface.fit()
        self.why.setGeometry(self.rect())
        self.setVisible(not cut.isEmpty())


class _TwoLineLabel(FittedWidget, PlainLabel):
    """Two lines for as much text as fits; the tooltip has all of it."""

    def __init__(self) -> None:
        super().__init__(objectName="paneNote", wordWrap=True)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._parts: Sequence[str] = ("",)

    def show_parts(self, parts: Sequence[str]) -> None:
        """Show all parts, or as many of the first as fit."""
        if parts != self._parts:
            self._parts = parts
            set_tip(self, "".join(parts))
            self.setAccessibleDescription("".join(parts))
            self._fit()

    def sizeHint(self) -> QSize:
        """Always two lines high: the picture keeps its size."""
        return QSize(0, 2 * self.fontMetrics().lineSpacing() + 2)

    def heightForWidth(self, _width: int) -> int:
        """The same height, where Qt would take that of the text."""
        return self.sizeHint().height()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self.updateGeometry()

    def _fit(self) -> None:
        room = QRect(0, 0, max(1, self.width()), 1 << 20)
        for count in range(len(self._parts), 0, -1):
            text = "".join(self._parts[:count]) + " …" * (count < len(self._parts))
            used = self.fontMetrics().boundingRect(room, Qt.TextFlag.TextWordWrap, text)
            if used.height() <= self.height():
                break
        else:  # not even the first part has room
            text = self.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, self.width())
        self.setText(text)


class Compare(QObject):
    """The pictures compared in a pane; `smoothing` returns the smoothing of a pane at rest."""

    changed = Signal()  # the pictures or the dividers have changed
    drawn = Signal()  # one of the other pictures is on the screen for the first time, by its name
    end_wanted = Signal()

    def __init__(self, pane: Pane, smoothing: Callable[[], str]) -> None:
        super().__init__(pane)
        self._pane, self._smoothing = pane, smoothing
        self.pictures: tuple[ComparedPicture, ...] = ()
        """From left to right or from the top; empty while there is only the document's own."""
        self.dividers: tuple[float, ...] = ()
        """Fractions of the picture's width; empty where the pictures are side by side."""
        self.others: list[_Other] = []
        self.handles: list[Divider] = []
        self.captions: list[Title] = []
        self._cuts: list[QRect] = []
        self._laid_out: list[tuple[int, int] | None] = []  # the images' sizes in this layout
        self._screen_px = 0.0  # the height of the screen that a class looks at; 0 for a window
        self.bar = QWidget()  # below the picture: says how the pictures differ
        self.words = _TwoLineLabel()
        self.words.setAccessibleName(self.tr("Differences between the pictures"))
        self.way = tool_button(act=self.toggle_way, flat=True, by_click=True)
        self.end = tool_button(
            "", self.tr("End the comparison (Esc)"), self.end_wanted,
            icon="close", name=self.tr("End the comparison"), flat=True, by_click=True,
        )  # fmt: skip
        self.bar.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        in_row((self.words, 1), self.way, self.end, on=self.bar, margins=(8, 2, 2, 2))
        self.bar.hide()
        self._name_way()
        pane.add_below(self.bar)
        self._known: set[Pane] = set()
        self._know(pane)

    def _know(self, pane: Pane) -> None:
        """Follow the probes of a pane, and from where it looks."""
        if pane not in self._known:
            self._known.add(pane)
            pane.marked.connect(self.refresh)
            pane.turned.connect(self.refresh)

    def move_to(self, pane: Pane) -> None:
        if pane is self._pane:
            return
        pictures, dividers = self.pictures, self.dividers
        self._show((), ())
        pane.surface.beside = self._pane.surface.beside
        self._pane = pane
        self._know(pane)
        self._show(pictures, dividers)
        self.refresh()

    def set_presenting(self, on: bool, screen_px: float) -> None:
        """Show a class the pictures and their names alone, the names as large as labels."""
        self._screen_px = screen_px if on else 0.0
        self.bar.setVisible(self.is_on and not on)
        for caption in self.captions:
            self._size(caption)
        self._lay_out()

    def _size(self, caption: Title) -> None:
        sheet = f"font-size: {round(LABEL_SHARE * self._screen_px)}px" if self._screen_px else ""
        caption.setStyleSheet(sheet)

    @property
    def is_on(self) -> bool:
        return bool(self.pictures)

    @property
    def is_divided(self) -> bool:
        """Whether the pictures lie over each other, which they never do with two shapes."""
        return bool(self.dividers) and not self._has_two_shapes and self._is_image

    @property
    def _is_image(self) -> bool:
        drawing = self._pane.drawing
        return drawing is None or drawing.pane == "image"

    @property
    def _has_two_shapes(self) -> bool:
        return len({each.projection.aspect for each in self._seen if each is not None}) > 1

    def show(self, pictures: Sequence[ComparedPicture], dividers: Sequence[float]) -> None:
        """Compare these pictures; `refresh` draws them."""
        if tuple(pictures) != self.pictures or tuple(dividers) != self.dividers:
            self._show(pictures, dividers)
            self.changed.emit()

    def _show(self, pictures: Sequence[ComparedPicture], dividers: Sequence[float]) -> None:
        if tuple(pictures) != self.pictures:
            self.close_canvases()
            for widget in (*self.others, *self.captions):
                widget.hide()
                widget.deleteLater()
            self.pictures = tuple(pictures)
            for watched in (self._pane.surface, self._pane.header):
                watched.installEventFilter(self)
            self._pane.canvas.shown.connect(self._open, Qt.ConnectionType.SingleShotConnection)
            self.others = [_Other(self._pane, each) for each in pictures if not each.live]
            for other in self.others:
                other.pane.canvas.shown.connect(self.drawn, Qt.ConnectionType.SingleShotConnection)
            self.captions = [Title("") for _ in pictures]
            for caption in self.captions:
                caption.setParent(self._pane.surface)
                self._size(caption)
                caption.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.dividers = tuple(dividers)
        while len(self.handles) < len(dividers):
            handle, number = Divider(self._pane.surface), len(self.handles)
            handle.moved.connect(partial(self._drag, number))
            handle.left.connect(self.end_wanted)
            handle.stepped.connect(lambda part, n=number: self._put(n, self.dividers[n] + part))
            self.handles.append(handle)
        self._pane.canvas.setMinimumSize(*((1, 1) if pictures else (120, 120)))
        self.bar.setVisible(self.is_on and not self._screen_px)
        self._name_way()
        self._laid_out = []
        self._lay_out()

    def toggle_way(self) -> None:
        """Change between side by side and over each other."""
        if self.is_on:
            count = len(self.pictures)
            even = tuple(number / count for number in range(1, count))
            self.show(self.pictures, () if self.dividers else even)
            self.refresh()

    def _name_way(self) -> None:
        text = self.tr("Over each other")
        tip = self.tr("Lay the pictures over each other, with a divider that you can drag")
        if self.dividers:
            text = self.tr("Side by side")
            tip = self.tr("Show every picture whole, beside the others")
        self.way.setText(text)
        set_tip(self.way, tip)

    def refresh(self) -> None:
        """Draw the pictures that have changed; held pictures stay."""
        shown = self._pane.shown
        if not self.is_on or shown is None or not self._pane.isVisible():
            return
        smoothing = self._smoothing()
        for other in self.others:
            other.refresh(shown, smoothing)
        seen = [None if each is None else each.projection.image_size for each in self._seen]
        if seen != self._laid_out:
            self._laid_out = seen
            self._lay_out()
        self._name_pictures(shown)

    @property
    def _seen(self) -> list[ShownData | None]:
        """What each picture shows, in their order; None for an impossible one."""
        return [self._pane.shown if each is None else each.shown for each in self._others]

    @property
    def _others(self) -> list[_Other | None]:
        """The widget of each picture, in their order; None for the live one."""
        others = iter(self.others)
        return [None if each.live else next(others) for each in self.pictures]

    def _open(self) -> None:
        """Draw the others after the live picture has reached the screen."""
        self._laid_out = []
        self.refresh()

    def set_style(self, style: Style) -> None:
        """Fill the free part of the surface with the colour of the pictures' margins."""
        self._pane.surface.beside = QColor(style.margin)
        self._pane.surface.update()

    def close_canvases(self) -> None:
        """Release VTK's objects of the other pictures, before the window closes."""
        for other in self.others:
            other.pane.close_canvas()

    # -- in words

    def _name_pictures(self, shown: ShownData) -> None:
        phenomenon = PHENOMENA.get(shown.document.scene)
        settings = () if phenomenon is None else phenomenon.settings
        written = DifferenceWriter(field_name, of_phenomena, read_text)
        names = [of_phenomena(name_of(shown.document, picture)) for picture in self.pictures]
        seen = [place for place, each in enumerate(self._seen) if each is not None]
        states = [each.document.state for each in self._seen if each is not None]
        captions = names_in([names[place] for place in seen], states, settings, written)
        for place, name in zip(seen, captions, strict=True):
            # A held picture that shows the same is known by being held.
            is_held = self.pictures[place].held is not None
            names[place] = name or (self.tr("held") if is_held else "")
        if names != [caption.text() for caption in self.captions]:
            for caption, name in zip(self.captions, names, strict=True):
                caption.setText(name)
            self._place_captions()
        texts = in_words(self.pictures, states, settings, written)
        texts = texts or [self.tr("no difference yet: change something")]
        if self.dividers and not self.is_divided:
            texts.append(self.tr("different shapes: side by side, at equal heights"))
        named = " | ".join(name for name in names if name)
        parts = [f"{named}:  " if named else "", *(f"{text}, " for text in texts[:-1]), texts[-1]]
        self.words.show_parts([parts[0] + parts[1], *parts[2:]])

    # -- where they are

    def _lay_out(self) -> None:
        """Place the live picture and the others."""
        surface = self._pane.surface
        whole, divided = surface.rect(), self.is_divided
        bare = self.is_on and not divided
        self._pane.request("bare", bare)
        self.way.setEnabled(not self._has_two_shapes)
        if not bare:
            surface.set_room(None)
        if divided:
            edges = [0, *self._edges_px(), whole.width()]
            cuts = [QRect(left, 0, right - left, whole.height()) for left, right in pairwise(edges)]
            wholes = [whole] * len(cuts)
        else:
            cuts = wholes = self._cells() if self.is_on else []
        for other, cut, own in zip(self._others, cuts, wholes, strict=True):
            if other is not None:
                other.pane.request("bare", bare)
                other.place(cut, own)
                other.raise_()
            elif bare:
                surface.set_room(cut)
        for handle, x in zip(self.handles, self._edges_px(), strict=False):
            handle.setGeometry(x - GRASP_PX // 2, 0, GRASP_PX, whole.height())
            handle.raise_()
        for number, handle in enumerate(self.handles):
            handle.setVisible(divided and number < len(self.dividers))
        self._cuts = cuts
        self._place_captions()

    def _place_captions(self) -> None:
        """Put each caption above its picture, where title and buttons leave room."""
        free_left, free_right = self._pane.header.room
        title = self._pane.title
        row = title.mapTo(self._pane, QPoint()).y() - self._pane.surface.y()
        below = row + title.height()
        for other, caption, cut in zip(self._others, self.captions, self._cuts, strict=False):
            pane = self._pane if other is None else other.pane
            height, y, middle = caption.sizeHint().height(), row, cut.center().x()
            if not self.is_divided:
                place = _picture_in(pane, cut)
                y = max(cut.top() + row, round(place.top()) - height - height // 8)
                middle = round(place.center().x())
            left, right = cut.left() + GRASP_PX, cut.right() - GRASP_PX
            if y < below:  # in the pane's own line, on its title's height
                y = row
                if not self._screen_px:  # a class sees larger letters than the title's
                    height = title.height()
                left, right = max(left, free_left + 4), min(right, free_right - 4)
            width = min(caption.sizeHint().width(), right - left)
            x = min(max(middle - width // 2, left), right - width)
            caption.setGeometry(x, y, max(0, width), height)
            caption.setVisible(width >= min(caption.sizeHint().width(), 2 * height))
            caption.raise_()

    def _edges_px(self) -> list[int]:
        place = _picture_in(self._pane, self._pane.surface.rect())
        return [round(place.left() + part * place.width()) for part in self.dividers]

    def _cells(self) -> list[QRect]:
        """Return the places in one row, or in several rows if that makes the images larger."""
        whole, em = self._pane.surface.rect(), float(self._pane.fontMetrics().height())
        em = max(em, LABEL_SHARE * self._screen_px)
        aspects = [1.0 if shown is None else shown.projection.aspect for shown in self._seen]
        pane = "image" if self._is_image else "world"
        rectangles = places_of(pane, whole.width(), whole.height(), aspects, em)
        return [QRect(*cell) for cell in rectangles]

    # -- dividers

    def _drag(self, number: int, x: float) -> None:
        place = _picture_in(self._pane, self._pane.surface.rect())
        self._put(number, (x - place.left()) / place.width())

    def _put(self, number: int, place: float) -> None:
        """Move a divider, at most to the next one or to an end."""
        bounds = (0.0, *self.dividers, 1.0)
        place = min(max(place, bounds[number]), bounds[number + 2])
        if place != self.dividers[number]:
            dividers = list(self.dividers)
            dividers[number] = place
            self.dividers = tuple(dividers)
            self._lay_out()
            self.changed.emit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if self.is_on and event.type() in (QEvent.Type.Resize, QEvent.Type.Show):
            if watched is self._pane.surface and event.type() == QEvent.Type.Show:
                self.refresh()
            self._lay_out()
        return super().eventFilter(watched, event)


def _picture_in(pane: Pane, room: QRect) -> QRectF:
    """Return the place of a pane's picture if its canvas filled a part of the surface."""
    if pane.drawing is None or room.isEmpty():
        return QRectF(room.x(), room.y(), max(1, room.width()), max(1, room.height()))
    ratio = pane.canvas.pixel_ratio
    size = (max(1, round(side * ratio)) for side in (room.width(), room.height()))
    left, top, width, height = (side / ratio for side in pane.drawing.rectangle_in(*size))
    return QRectF(room.x() + left, room.y() + top, width, height)
