"""The tiles of the object's transform in the dock, and their product.

::

    row, switch, menu, drag -> edited(chain) -> the model -> show(chain)

The tiles stand as in the product, the leftmost at the top: the one at the bottom acts first.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from textwrap import fill

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import QCheckBox, QMenu, QSizePolicy, QToolButton, QWidget

from app.languages import with_comma
from app.lecture.highlight import NOTHING, Highlight
from app.lecture.letters import written
from app.lecture.notation import names_of, object_product
from app.lecture.stages import IMAGE, NDC, REACHED_BY, VIEW
from app.lecture.titles import stage_title, tile_title
from app.lecture.wrong_chains import DIVIDE, difference, tiles_of, written_numbers
from app.model.chain import KINDS, MOST_TILES, Chain, FiveTiles, Tile, view_chain
from app.model.parameters import TILES
from app.model.projection import Projection
from app.model.refusal import Refusal
from app.model.tables import VIEWPORT
from widgets.controls.parameter_rows import make_row
from widgets.parts.fields import Row, RowHolder
from widgets.parts.labels import RefusalLabel
from widgets.parts.layouts import FREE, discard, in_column, in_row, tool_button
from widgets.parts.messages import FEW, figure_text, lettering, parameter_text, sentence
from widgets.parts.movable import MovableColumn, MoveButton
from widgets.parts.number_field import refusal
from widgets.parts.number_rows import NumberRow, VectorRow
from widgets.parts.plain import PlainLabel, set_tip, subscripts
from widgets.parts.scales import Linear
from widgets.parts.section import GAP_PX, Rows
from widgets.parts.typeset import TypesetLabel, matrix

_LINE_LETTERS = 26  # of a factor's name on one line of the narrowest dock


def _beyond(projection: Projection, undone: bool, from_left: bool) -> Iterator[tuple[str, float]]:
    """Yield the factors left of the object's, each with its stop in the strip."""
    turned, moved = (VIEW / 2.0, VIEW) if from_left else (VIEW, VIEW / 2.0)
    yield stage_title(VIEWPORT.name), IMAGE
    yield stage_title(DIVIDE), NDC
    names = names_of(projection, lettering.now)
    for step in [step.name for step in projection.lens.table.steps[::-1]] or ["clip_from_view"]:
        stop = next((at for at, reached in enumerate(REACHED_BY) if step in reached), NDC)
        yield subscripts(names.get(step) or stage_title(step)), stop
    camera = projection.camera
    if not projection.has_camera:
        yield stage_title("view_from_world"), VIEW
        return
    *turns, move = view_chain(camera.frame, camera.eye).tiles
    if not undone:
        yield stage_title("rotation"), turned
    for tile in (*(turns if undone else ()), move):
        numbers = ",".join(map(written_numbers, tile.numbers)).replace("-", "\N{MINUS SIGN}")
        yield with_comma(tile_title(tile.kind, numbers)), moved if tile is move else turned


class _TileCard(Rows):
    """One tile: its switch, its numbers, and the buttons that move and remove it."""

    def __init__(self, tile: Tile, reach: float, owner: "ChainEditor") -> None:
        super().__init__()
        self.kind = tile.kind
        self.field = ""  # what its numbers are called in highlights; empty while it is off
        title = stage_title(KINDS[tile.kind].factor)
        self.switch = QCheckBox(title)
        set_tip(self.switch, self.tr("Whether the product has this tile"))
        self._tile = tile
        self.switch.clicked.connect(lambda on: owner.put(self, replace(self._tile, is_off=not on)))
        tip = self.tr("Remove it")
        away = tool_button(
            icon="close", tip=tip, name=f"{title}: {tip}", act=lambda: owner.put(self), flat=True
        )
        head = QWidget()
        in_row(MoveButton(title), (self.switch, 1), away, on=head, margins=(0, 0, 0, 0), gap=0)
        self._column.insertWidget(0, head)
        self.rows = dict(self._made_rows(tile, title))
        self.set_reach(reach)
        for key, row in self.rows.items():
            self.add(row)
            owner.join(self, key, row)

    def _made_rows(self, tile: Tile, title: str) -> Iterator[tuple[str, Row]]:
        """Yield a row for each number, or for each column of a matrix and for an axis."""
        parameter = TILES.get(KINDS[tile.kind].field)
        if parameter is None:  # a mirror has no numbers
            return
        named = QCoreApplication.translate("Field", "{0} {1}")
        tip = parameter_text(parameter, parameter.tip)
        columns = {"matrix": ("x", "y", "z", self.tr("origin")), "rotate": (self.tr("axis"),)}
        for column in columns.get(tile.kind, ()):
            yield column, VectorRow(named.format(title, column), tip)
        letters = KINDS[tile.kind].letters[{"matrix": 12, "rotate": 3}.get(tile.kind, 0) :]
        for letter in letters:
            part = letter.rpartition("_")[2]
            name = named.format(title, part) if len(letters) > 1 else title
            row = make_row(replace(parameter, vector=False), name)
            row.setDefault(KINDS[tile.kind].neutral[-1])
            yield part, row

    def set_reach(self, reach: float) -> None:
        for row in self.rows.values():
            if self.kind == "translate" and isinstance(row, NumberRow):
                row.setScale(Linear.about(0.0, reach))

    def show_tile(self, tile: Tile, field: str) -> None:
        self._tile, self.field = tile, field
        kind = KINDS[tile.kind]  # a second one is numbered, as its factor in Matrices
        self.switch.setText(stage_title(kind.factor + field.removeprefix(kind.field)))
        self.switch.setChecked(not tile.is_off)
        for row, value in zip(self.rows.values(), self._values(tile), strict=True):
            row.setValue(value)

    def _values(self, tile: Tile) -> list[object]:
        numbers = tile.numbers
        if tile.kind == "matrix":
            return [numbers[column:12:4] for column in range(4)]
        return [numbers[:3], numbers[3]] if tile.kind == "rotate" else list(numbers)

    def typed(self, tile: Tile, key: str, value: object) -> tuple[float, ...]:
        """Return a tile's numbers after an edit of one of the rows."""
        values = self._values(tile)
        values[list(self.rows).index(key)] = value
        parts = [part if isinstance(part, tuple) else (part,) for part in values]
        if tile.kind == "matrix":
            return (*(part for row in zip(*parts, strict=True) for part in row), *tile.numbers[12:])
        return tuple(part for group in parts for part in group)


class ChainEditor(QWidget, RowHolder):
    """The tiles of the object, a menu for more, and their product."""

    edited = Signal(object)  # the user made this `Chain`
    compared = Signal(object)  # the `Chain` before a tile was moved; None for none any more
    highlighted = Signal(str, object)  # the key of a row, and its `Highlight`
    factored = Signal()  # the user wants to see the factors of the product
    stood = Signal(float)  # the user went to the stop of this position behind a factor

    def __init__(self) -> None:
        super().__init__()
        self._chain, self._reach = Chain(), 10.0
        self._projection, self._from_left = Projection(), False
        self.beyond: list[QToolButton] = []  # the factors left of the tiles
        self._beyond, self._stops = in_column(gap=0), list[float]()  # and their stops in the strip
        self.undone = QCheckBox(self.tr("View: the camera's moves undone"))
        set_tip(self.undone, self.tr("The view as R T, or as the inverse of each move"))
        self.undone.toggled.connect(lambda: self.show_pipeline(self._projection))
        self.rows: dict[str, Row] = {}
        self.tiles = MovableColumn(GAP_PX)
        self.tiles.moved.connect(self._move)
        text, tip = self.tr("Add a tile"), self.tr("It acts last: left of the others")
        self.add = tool_button(text, tip, name=text)
        self.add.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self.add)
        menu.addAction("T Rz Ry Rx S", lambda: self._adopt(FiveTiles().chain))
        for kind in KINDS:
            title = stage_title(KINDS[kind].factor)
            menu.addAction(title, partial(self.put, None, Tile(kind, KINDS[kind].neutral)))
        self.add.setMenu(menu)
        self.letters = QCheckBox(self.tr("Letters"))
        self.vectors = QCheckBox(self.tr("Row vectors"))
        for box in (self.letters, self.vectors):
            box.toggled.connect(self._show_product)
        self.product = TypesetLabel()
        self.product.shrinks = True
        self.refusal = RefusalLabel()
        self.first = PlainLabel(objectName="paneNote", wordWrap=True)
        self.own = QWidget()  # what there is of the object, unless it is fixed
        tip = self.tr("Show its factors in Matrices")
        self.to_factors = tool_button(icon="unfold", tip=tip, act=self.factored, flat=True)
        bar = in_row(self.letters, self.vectors, FREE, self.to_factors)
        parts = (self.add, self.refusal, self.tiles, self.first, self.product, bar)
        in_column(*parts, on=self.own, margins=(0, 0, 0, 0))
        in_column(self._beyond, self.undone, self.own, on=self, margins=(0, 0, 0, 0))
        self._build()

    @property
    def cards(self) -> list[_TileCard]:
        """The tiles from the top, which is left in the product."""
        return [part for part in self.tiles.parts if isinstance(part, _TileCard)]

    # -- the interface

    def show_chain(self, chain: Chain) -> None:
        """Show another chain, without a signal."""
        if chain == self._chain:
            return
        self._chain = chain
        self.refusal.show_text("")
        self.compared.emit(None)
        self.first.setText(self.tr("The tile at the bottom acts first."))
        self._show_tiles()
        self._show_product()

    def show_pipeline(self, projection: Projection) -> None:
        """Show the factors from the picture to the camera, which act after the tiles."""
        self._projection = projection
        factors = [*_beyond(projection, self.undone.isChecked(), self._from_left)]
        if len(factors) != len(self.beyond):
            discard(self._beyond, self.beyond)
            tip = self.tr("Show the scene after this factor")
            self.beyond = [tool_button(tip=tip, flat=True) for _ in factors]
            for place, button in enumerate(self.beyond):
                button.clicked.connect(lambda _, at=place: self.stood.emit(self._stops[at]))
                button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
                self._beyond.addWidget(button)
        self._stops = [stop for _, stop in factors]
        for button, (name, _) in zip(self.beyond, factors, strict=True):
            button.setText(fill(name, _LINE_LETTERS))

    def turn(self, from_left: bool) -> None:
        """Read the camera's moves as the strip does."""
        self._from_left = from_left
        self.show_pipeline(self._projection)

    def set_scene(self, size: float) -> None:
        """Fit the sliders of translations to a scene."""
        self._reach = 2.0 * size
        for card in self.cards:
            card.set_reach(self._reach)

    def show_highlight(self, highlighted: Highlight) -> None:
        for card in self.cards:
            for row in card.rows.values():
                row.set_marked(card.field in highlighted)

    def rows_of(self, name: str) -> list[Row]:
        """Return the rows of the tiles of one kind: ``rotate_deg``."""
        return [row for key, row in self.rows.items() if key.rpartition("_")[0] == name]

    def card_of(self, factor: str) -> _TileCard | None:
        """Return the tile of a factor, as the Matrices panel names it."""
        step, cards = self._chain.step, [card for card in self.cards if card.field]
        names = [f"{step.name}/{name}" for name, _ in step.factors]
        return cards[names.index(factor)] if factor in names else None

    def return_borrowed(self) -> None:
        for card in self.cards:
            card.return_borrowed()

    # -- edits

    def put(self, card: _TileCard | None, *tiles: Tile) -> None:
        """Put tiles over that of a card, or at the left, which acts last."""
        place, over = (0, 0) if card is None else (self.cards.index(card), 1)
        self._attempt(lambda: self._chain.with_tile(place, *tiles, over=over), self._refuse)

    def _move(self, place: int, to: int) -> None:
        """Move a tile; show where the object was before, and say what differs."""
        before = self._chain
        self._attempt(lambda: before.moved(place, to), self._refuse)
        if self._chain != before:
            self.compared.emit(before)
            self.first.setText(sentence(difference(*map(tiles_of, (before, self._chain)))))

    def _refuse(self, said: str) -> None:
        """Refuse a change, and show the tiles as they were."""
        self._show_tiles()
        self.refusal.show_text(refusal(said))

    def type_in(self, card: _TileCard, key: str, value: object) -> None:
        if card not in self.cards:  # a field that is taken away gives up what is typed in it
            return
        place = self.cards.index(card)
        tile = self._chain.tiles[place]
        typed = partial(replace, tile, numbers=card.typed(tile, key, value))
        refuse = card.rows[key].show_error
        self._attempt(lambda: self._chain.with_tile(place, typed(), over=1), refuse)

    def join(self, card: _TileCard, key: str, row: Row) -> None:
        row.edited.connect(partial(self.type_in, card, key))
        row.highlighted.connect(partial(self._point_at, card, key))
        self._join(row)

    def _point_at(self, card: _TileCard, key: str, is_here: bool) -> None:
        about = frozenset({card.field}) if is_here and card.field else NOTHING
        self.highlighted.emit(f"{card.field}_{key}", about)

    def _attempt(self, make: Callable[[], Chain], refuse: Callable[[str], None]) -> None:
        try:
            self._adopt(make())
        except Refusal as error:
            refuse(sentence(error))

    def _adopt(self, chain: Chain) -> None:
        if chain != self._chain and not self.own.isHidden():  # a fixed object's is no one's to edit
            self.show_chain(chain)
            self.edited.emit(chain)

    # -- shown

    def _build(self) -> None:
        self.tiles.show_parts([_TileCard(tile, self._reach, self) for tile in self._chain.tiles])
        self.add.setEnabled(len(self.cards) < MOST_TILES)
        for part in (self.first, self.product, self.letters, self.vectors, self.to_factors):
            part.setVisible(bool(self.cards))

    def _show_tiles(self) -> None:
        if [card.kind for card in self.cards] != [tile.kind for tile in self._chain.tiles]:
            self._build()
        self.rows.clear()
        tiles = zip(self.cards, self._chain.tiles, self._chain.fields(), strict=True)
        for place, (card, tile, field) in enumerate(tiles):
            card.show_tile(tile, field)
            for part, row in card.rows.items():
                self.rows[f"{field or f'off{place}'}_{part}"] = row

    def _show_product(self) -> None:
        rows = self.vectors.isChecked()
        formulas, names = object_product(self._chain, rows=rows)
        cells = [[written(cell, "own") for cell in line] for line in formulas]
        if not self.letters.isChecked():
            product = self._chain.matrix.T if rows else self._chain.matrix
            cells = [[figure_text(x, FEW) for x in line] for line in product + 0.0]
        lead = " ".join(names) + (" =\n" if len(names) > 2 else " = ")  # many leave too little room
        self.product.set_formula(lead * bool(names) + matrix(cells))
