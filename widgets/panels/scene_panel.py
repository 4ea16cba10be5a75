"""About the scene: what it teaches, its own settings, and the numbers it is about.

::

    user, Play -> edited({name: value}) -> owner takes it, or calls refuse(error)
    owner -> show_illustration                    never answered by a signal

Everything here is made from the data of a `Phenomenon`; no phenomenon has code of its own. A panel
that is folded fills nothing in.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

from PySide6.QtCore import QEvent, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QHelpEvent, QHideEvent, QPalette
from PySide6.QtWidgets import (
    QBoxLayout,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLayout,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QToolButton,
    QToolTip,
    QVBoxLayout,
    QWidget,
)

from app.drawings.style import LIGHT, Style
from app.model.projection import Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import (
    Diagram,
    Found,
    Illustration,
    Phenomenon,
    Phrase,
    Reading,
    Setting,
    Settings,
    Value,
)
from widgets.parts.clock import Clock, Playing
from widgets.parts.diagram import DiagramView
from widgets.parts.fields import (
    CheckRow,
    Choice,
    ChoiceRow,
    Doubling,
    Linear,
    Log,
    NumberRow,
    Row,
    Scale,
    VectorRow,
    align,
)
from widgets.parts.focus import FocusRing
from widgets.parts.messages import (
    breakable,
    figure_text,
    limits_text,
    number_text,
    of_phenomena,
    sentence,
)
from widgets.parts.panel import Changed, Shown
from widgets.parts.readable import ReadablePanel

HEIGHT_PX = 225
"""Of the panel where it opens, at the ordinary font; what is higher scrolls, or it is dragged."""
PART = 0.28
"""Of a large window's height, for the panel."""
LARGEST_PART = 0.36
"""So much of it at most, where text and readout need it."""
LEAST_WINDOW_PX = 900
"""In a window that is so wide it must find room."""
WORD = 16
"""Characters of a file's name that find room in the narrowest column."""
COLUMN_PX = 200
"""Least width of what can scroll to and fro."""
PICTURE = 16.0 / 9.0
"""Width of a picture that is compared with others, over its height."""
MOST_ABREAST = 2
"""So many diagrams stand beside the settings; for more of them there is more room."""
NAME_CHARACTERS = 24
"""Longest name of a setting that is written in one line."""
LARGE, LARGER = 1.5, 1.15
"""A reading's number, and its words, against ordinary text: they are read from the back row."""
ON_A_LINE = 30
"""Longest text of several numbers that is not broken in two."""
LARGE_CHARACTERS = 20
"""Longest text of numbers that is written so large."""
LABEL_EM, WORDS_EM = 14, 8
"""Widths in heights of a line, beyond which labels, and words as values, may wrap."""
NONE = "–"
"""Stands for a reading that there is not."""


class ScenePanel(ReadablePanel):
    """Explanation, settings, readout and diagrams of the scene at hand, side by side.

    Attributes
    ----------
    rows : dict of str to Row
        Of the settings, by their names.
    players : dict of str to Player
        Of the settings that can be played, by their names.
    """

    concerns = frozenset({"illustration", "settings"})
    settings_edited = Signal(object)
    """The user chose, or a player reached, these settings: a dict of values by name."""
    mesh_wanted = Signal()
    """The user wants to choose a mesh for the place of the scene's own objects."""
    mesh_removed = Signal()
    """The user wants the scene's own objects back."""

    def __init__(self) -> None:
        super().__init__()
        self.rows: dict[str, Row] = {}  # first: a change of font comes with the first child
        self._phenomenon: Phenomenon | None = None
        self._settings: Settings = {}
        self._illustration: Illustration | None = None
        self._counted: tuple[Illustration, float] | None = None
        self._problem: Phrase | None = None
        self._style = LIGHT
        self._projection: Projection | None = None
        self._why_not: dict[QWidget, str] = {}
        self._lines: dict[str, QWidget] = {}
        self._edits = ""  # name of the setting that the user is changing
        self.players: dict[str, Player] = {}

        self.title = QLabel()
        self.title.setObjectName("paneTitle")
        self.lectures = QLabel()
        self.lectures.setObjectName("paneNote")
        self.explanation = QLabel()
        for label in (self.title, self.lectures, self.explanation):
            label.setWordWrap(True)
            label.setTextFormat(Qt.TextFormat.PlainText)
        self.explanation.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.warning = _Sentence("rowError")
        self.readout = Readout()
        self.diagrams: list[DiagramView] = []
        self.use_mesh = QPushButton(self.tr("Use my mesh…"))
        self.use_mesh.setToolTip(
            self.tr("Put a mesh from a file into the place of the scene's own objects")
        )
        self.use_mesh.clicked.connect(self.mesh_wanted)
        self.remove_mesh = QPushButton(self.tr("Own objects"))
        self.remove_mesh.setToolTip(self.tr("Put the scene's own objects back"))
        self.remove_mesh.clicked.connect(self.mesh_removed)
        self._lay_out()
        self.show_scene(self.tr("This scene"), None)

    def _lay_out(self) -> None:
        text = QVBoxLayout()
        text.setSpacing(2)
        for label in (self.title, self.lectures, self.explanation):
            text.addWidget(label)
        text.addStretch(1)
        self._rows = QVBoxLayout()
        self._rows.setSpacing(3)
        buttons = QHBoxLayout()
        buttons.addWidget(self.use_mesh)
        buttons.addWidget(self.remove_mesh)
        buttons.addStretch(1)
        chosen = QVBoxLayout()
        chosen.addLayout(self._rows)
        chosen.addLayout(buttons)
        chosen.addStretch(1)
        read = QVBoxLayout()
        read.setSpacing(2)
        read.addWidget(self.warning)
        read.addWidget(self.readout)
        read.addStretch(1)
        self._drawn = QGridLayout()
        self._drawn.setSpacing(4)
        self._text_column = _Column(text, self.tr("What this scene shows"))
        self._settings_column = _Column(chosen, self.tr("Settings of this scene"), 540)
        self._readout_column = _Column(read, self.tr("Readout"), 590)
        self._diagram_column = _Column(self._drawn, self.tr("Diagrams"))
        self._columns_of_diagrams = 0
        self._diagram_column.installEventFilter(self)
        self._outgrowing = QTimer(self)  # asks when all is laid out, not on the way there
        self._outgrowing.setSingleShot(True)
        self._outgrowing.setInterval(0)
        self._outgrowing.timeout.connect(self._tell_outgrown)
        for column in (self._text_column, self._readout_column):
            column.overfull.connect(self._outgrowing.start)
        self._columns = QHBoxLayout(self)
        self._columns.setContentsMargins(4, 0, 4, 2)
        self._columns.setSpacing(12)
        self._said = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        self._said.setSpacing(self._columns.spacing())
        self._said.addWidget(self._text_column, 4)
        self._said.addWidget(self._settings_column, 5)
        self._columns.addLayout(self._said, 9)
        self._columns.addWidget(self._readout_column, 4)
        self._columns.addWidget(self._diagram_column)

    def sizeHint(self) -> QSize:
        """Low: the panes above need the height; but few lines are to be cut.

        A scene that is no phenomenon has but its name here.
        """
        lines = 13.0 * self.fontMetrics().height()
        window = self.window().height()
        said = self._text_column.height_inside
        if self._said.direction() == QBoxLayout.Direction.TopToBottom:
            said += self._said.spacing() + self._settings_column.height_inside
        whole = max(said, self._readout_column.height_inside)
        needed = min(LARGEST_PART * window, whole + self._columns.contentsMargins().bottom())
        usual = 0.0 if self._phenomenon is None else max(HEIGHT_PX, lines, PART * window)
        height = max(usual, needed)
        return QSize(super().sizeHint().width(), round(height))

    def minimumSizeHint(self) -> QSize:
        """Not wider than a small window: rather are the columns scrolled."""
        return QSize(min(super().minimumSizeHint().width(), LEAST_WINDOW_PX), 80)

    def _tell_outgrown(self) -> None:
        if self.sizeHint().height() > self.height():
            self.outgrown.emit()

    # -- what the owner says

    def show_scene(self, title: str, phenomenon: Phenomenon | None, mesh: str = "") -> None:
        """Show another scene, with rows for its settings.

        Parameters
        ----------
        title : str
            Translated.
        phenomenon : Phenomenon or None
            None for a scene that is none, and has no settings.
        mesh : str
            Name of the user's mesh in the place of its objects, or nothing.
        """
        if phenomenon is not self._phenomenon or phenomenon is None:
            self.pause()
            for row in self.rows.values():  # which shows the last of the scene that is left
                row.finish_gesture()  # a burst of keys that has not gone quiet yet, and never would
            self._phenomenon, self._settings, self._illustration = phenomenon, {}, None
            self._problem = None
            self._make_rows(() if phenomenon is None else phenomenon.settings)
        self.title.setText(breakable(title, WORD))
        lectures = () if phenomenon is None else phenomenon.lectures
        self.lectures.setText(self.tr("Lectures: {0}").format(", ".join(lectures)))
        self.lectures.setVisible(bool(lectures))
        self.explanation.setText(
            self.tr("This scene has no settings of its own.")
            if phenomenon is None
            else of_phenomena(phenomenon.explanation)
        )
        has_place = phenomenon is not None and phenomenon.own_mesh
        self.use_mesh.setVisible(has_place)
        self.remove_mesh.setVisible(has_place and bool(mesh))
        self.remove_mesh.setAccessibleDescription(mesh)
        self._settings_column.setVisible(bool(self.rows) or has_place)
        self._readout_column.setVisible(phenomenon is not None)
        self._show_diagrams(())

    def take(self, shown: Shown, changed: Changed) -> None:
        self.show_illustration(shown.illustration, shown.document.settings, shown.projection)

    def show_illustration(
        self, illustration: Illustration | None, settings: Settings, projection: Projection
    ) -> None:
        """Show settings, readout, warning and diagrams; a setting in the hand follows it at once.

        Parameters
        ----------
        illustration : Illustration or None
        settings : mapping of str to value
            As they were chosen last.
        projection : Projection
            That the illustration is of: it may be moved so that they hold no more.
        """
        if illustration is self._illustration and settings == self._settings:
            return
        anew = self._illustration is None
        self._illustration, self._settings = illustration, settings
        self._projection = projection
        for name, player in self.players.items():
            player.show_value(float(settings[name]))  # type: ignore[arg-type]
        if self._edits in settings and self.isVisible():
            self.rows[self._edits].setValue(settings[self._edits])
        self._readable.changed()
        if anew:  # of the scene before, nothing is to be seen
            self._readable.settle()

    def show_count(self, illustration: Illustration, share: float) -> None:
        """Show what was counted in the picture of an illustration, as long as that is shown."""
        self._counted = illustration, 100.0 * share
        if illustration is self._illustration:
            self._readable.changed()

    def show_problem(self, problem: Phrase | None) -> bool:
        """Say why the picture is not drawn as the scene asks, if so; tell whether that is new."""
        if problem == self._problem:
            return False
        self._problem = problem
        self._readable.changed()
        return True

    def set_style(self, style: Style) -> None:
        """Draw the diagrams in other colours and sizes; those of the panes."""
        self._style = style
        for diagram in self.diagrams:
            diagram.set_style(style)

    def refuse(self, error: Refusal) -> None:
        """Say at the row that was just edited why that cannot be; the last value stays."""
        row = self.rows[self._edits or next(iter(self.rows))]
        self._readable.settle()  # or what was accepted before would take the sentence back
        row.show_error(sentence(self.named(error)))

    def named(self, error: Refusal) -> Refusal:
        """A refusal under the label of the setting that it is about."""
        assert self._phenomenon is not None
        labels = {setting.path: setting.label for setting in self._phenomenon.settings}
        if error.field not in labels:
            return error
        name = of_phenomena(labels[error.field])
        return Refusal(name, error.value, error.bound, *error.limits)

    def pause(self) -> None:
        """Let all that is played stand still."""
        for player in self.players.values():
            player.pause()

    # -- rows

    def _make_rows(self, settings: Iterable[Setting]) -> None:
        self.players.clear()
        for line in self._lines.values():
            self._rows.removeWidget(line)
            line.hide()
            line.deleteLater()
        self._lines = {}
        self.rows = {}
        for setting in settings:
            row = make_row(setting, self.tr("none of these"))
            self.rows[setting.name] = row
            row.edited.connect(partial(self._edit, setting.name))
            row.gesture_started.connect(partial(self._gesture_started, row))
            row.gesture_finished.connect(self.gesture_finished)
            row.gesture_abandoned.connect(self.gesture_abandoned)
            line = row
            if setting.per_second and isinstance(row, NumberRow):
                line = self._with_player(setting, row)
            self._rows.addWidget(line)
            self._lines[setting.name] = line
            for part in (line, *line.findChildren(QWidget)):
                part.installEventFilter(self)
        self._why_not = {}
        self._align()

    def _with_player(self, setting: Setting, row: NumberRow) -> QWidget:
        player = Player(setting, self)
        self.players[setting.name] = player
        player.stepped.connect(partial(self._played, setting.name))
        player.started.connect(partial(self._play_started, player))
        player.paused.connect(self.gesture_finished)
        line = QWidget()
        layout = QHBoxLayout(line)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(row, 1)
        layout.addWidget(player.button, 0, Qt.AlignmentFlag.AlignTop)
        return line

    def _play_started(self, player: Player) -> None:
        for other in self.players.values():
            if other is not player:
                other.pause()
        self.gesture_started.emit()

    def _played(self, name: str, value: float) -> None:
        self.rows[name].clear_error()
        self._edit(name, value)

    def _edit(self, name: str, value: Value) -> None:
        self._edits = name
        self.settings_edited.emit({name: value})
        self._edits = ""

    def _gesture_started(self, row: Row) -> None:
        for other in self.rows.values():
            if other is not row:
                other.finish_gesture()  # a burst of keys elsewhere that has not gone quiet yet
        self.gesture_started.emit()

    # -- shown

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        if not event.spontaneous():  # folded: nobody sees it, and nobody could stop it
            self.pause()

    def _fill(self) -> None:
        found: Found = self._settings
        if self._phenomenon is not None and self._projection is not None and found:
            found = self._phenomenon.at_hand(self._projection, self._settings)
        for name, value in found.items():
            row = self.rows[name]
            if row.error and not row.in_hand and name != self._edits:
                row.clear_error()  # what another value has cured
            is_choice = isinstance(row, ChoiceRow)
            row.setValue(self._settings[name] if value is None and not is_choice else value)
            if name in self.players and isinstance(value, float):
                self.players[name].show_value(value)
        illustration = self._illustration
        readings = () if illustration is None else illustration.readings
        self.readout.show_readings([self._with_count(r) if r.counted else r for r in readings])
        warning = self._problem if illustration is None else illustration.warning or self._problem
        why = "" if warning is None else _full(warning.sentence(of_phenomena))
        self.warning.say(why and f"⚠ {why}")
        self._let_choose(found, why if illustration is not None and illustration.idle else "")
        self._show_diagrams(() if illustration is None else illustration.diagrams)

    def _with_count(self, reading: Reading) -> Reading:
        """A counted reading with its value, or with its note if there was nothing to count."""
        share = None
        if self._counted is not None and self._counted[0] is self._illustration:
            share = self._counted[1]
        if share is not None and math.isnan(share):
            return reading
        return replace(reading, value=share, note=None)

    def _let_choose(self, found: Found, why_not: str) -> None:
        """Let the settings be changed, unless a sentence says why that would change nothing."""
        for setting in () if self._phenomenon is None else self._phenomenon.settings:
            name, line = setting.name, self._lines[setting.name]
            why = why_not or (self._why_without_effect(setting, found) if found else "")
            if why != self._why_not.get(line, ""):
                for part in (line, *line.findChildren(QWidget)):
                    self._why_not[part] = why
                line.setEnabled(not why)
                if why and name in self.players:
                    self.players[name].pause()

    def _why_without_effect(self, setting: Setting, found: Found) -> str:
        """Why a setting would change nothing as the others, camera and lens are; or nothing."""
        assert self._phenomenon is not None
        name, wanted = setting.only_with or ("", None)
        if name and found[name] != wanted:
            other = next(other for other in self._phenomenon.settings if other.name == name)
            label = of_phenomena(other.label)
            if isinstance(wanted, bool):
                return self.tr("Only with “{0}” switched on.").format(label)
            text = of_phenomena(dict(other.choices)[str(wanted)])
            return self.tr("Only with “{0}”: {1}.").format(label, text)
        if found[setting.name] is None and not isinstance(self.rows[setting.name], ChoiceRow):
            return self.tr("The lens has none: choose one of the above first.")
        return ""

    def _show_diagrams(self, diagrams: Sequence[Diagram]) -> None:
        while len(self.diagrams) < len(diagrams):
            view = DiagramView()
            view.set_style(self._style)
            view.copy_wanted.connect(self.copy_wanted)
            view.export_wanted.connect(self.export_wanted)
            self.diagrams.append(view)
            self._place_diagrams()
        for place, view in enumerate(self.diagrams):
            shown = place < len(diagrams)
            if view.isHidden() == shown:
                view.setVisible(shown)
            view.show_diagram(diagrams[place] if shown else None)
        if self._diagram_column.isHidden() == bool(diagrams):
            self._diagram_column.setVisible(bool(diagrams))
        self._share_room(len(diagrams))

    def _place_diagrams(self) -> None:
        """In one row, or in two where they are larger so: many are pictures to be compared."""
        count, size = len(self.diagrams), self._diagram_column.size()
        half = -(-count // 2)
        abreast, above = (
            min(size.width() / columns / PICTURE, size.height() / rows - self._line)
            for columns, rows in ((max(1, count), 1), (max(1, half), 2))
        )
        columns = half if count > MOST_ABREAST and above > abreast else max(1, count)
        if self._drawn.count() == count and columns == self._columns_of_diagrams:
            return
        self._columns_of_diagrams = columns
        for place, view in enumerate(self.diagrams):
            self._drawn.addWidget(view, place // columns, place % columns)

    def _share_room(self, diagrams: int) -> None:
        """Many diagrams are what the scene is about: the settings then stand under the text."""
        many = diagrams > MOST_ABREAST
        direction = QBoxLayout.Direction.TopToBottom if many else QBoxLayout.Direction.LeftToRight
        self._said.setDirection(direction)
        self._said.setStretch(1, 0 if many else 5)
        said = 4 if many or self._settings_column.isHidden() else 9
        self._columns.setStretch(0, said)
        self._columns.setStretchFactor(self._diagram_column, 16 if many else 4 * diagrams)

    @property
    def _line(self) -> int:
        return self.fontMetrics().height()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            why = self._why_not.get(watched) if isinstance(watched, QWidget) else None
            if why:
                QToolTip.showText(event.globalPos(), why)  # instead of what it would do
                return True
        if event.type() == QEvent.Type.Resize and watched is self._diagram_column:
            self._place_diagrams()
        return super().eventFilter(watched, event)

    def _align(self) -> None:
        """Give the names one width: the longest one's, up to a limit."""
        if not self.rows:
            return
        align(self.rows.values())
        metrics = self.fontMetrics()
        longest = max(metrics.horizontalAdvance(row.name) for row in self.rows.values()) + 2
        for row in self.rows.values():
            row.name_label.setFixedWidth(min(longest, NAME_CHARACTERS * metrics.averageCharWidth()))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:  # projector mode
            self._align()


class _Column(QScrollArea):
    """A part of the panel that scrolls by itself.

    Parameters
    ----------
    layout : QLayout
        What is in it.
    name : str
        Translated, for screen readers.
    whole_px : int
        Up to this it is at least as wide as what is in it; beyond, it gives way and scrolls.
    """

    overfull = Signal()
    """What is in it has changed, and is higher than what is seen of it."""

    def __init__(self, layout: QLayout, name: str, whole_px: int = COLUMN_PX) -> None:
        super().__init__()
        self._whole_px = whole_px
        self._asked_px = 0
        self._inside = QWidget()
        layout.setContentsMargins(0, 0, 4, 0)
        self._inside.setLayout(layout)
        self.setWidget(self._inside)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setAccessibleName(name)
        FocusRing(self)
        self._inside.installEventFilter(self)

    @property
    def height_inside(self) -> int:
        """Of what is in it, in the width that it has."""
        height = self._inside.heightForWidth(self.viewport().width())
        return height if height >= 0 else self._inside.sizeHint().height()

    def minimumSizeHint(self) -> QSize:
        bar = self.verticalScrollBar().sizeHint().width()
        width = self._inside.minimumSizeHint().width() + bar
        return QSize(max(COLUMN_PX, min(width, self._whole_px)), 60)

    def sizeHint(self) -> QSize:
        inside = self._inside.sizeHint().height()
        return QSize(self.minimumSizeHint().width(), min(HEIGHT_PX, inside))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:
            width = self.minimumSizeHint().width()
            if width != self._asked_px:  # a scroll area does not pass its widget's least width on
                self._asked_px = width
                self.updateGeometry()
        if event.type() in (QEvent.Type.LayoutRequest, QEvent.Type.Resize) and (
            self.height_inside > self.viewport().height()
        ):
            self.overfull.emit()
        return super().eventFilter(watched, event)


class _Sentence(QLabel):
    """A line that is there when there is something to say."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setStyleSheet(
            "#rowError { border: 0px; border-left: 3px solid #d55e00; padding: 1px 0 2px 5px; }"
        )
        self.hide()

    def say(self, text: str) -> None:
        """Say this, or nothing."""
        if text != self.text():
            self.setText(text)
            self.setVisible(bool(text))


# --------------------------------------------------------------------------- settings


def make_row(setting: Setting, none: str = "") -> Row:
    """A row of the kind that a setting's default asks for, with its reset.

    `none` is what a choice says while what it is about is none of what can be chosen.
    """
    name, tip = of_phenomena(setting.label), of_phenomena(setting.tip)
    tip = tip if tip.endswith(".") else f"{tip}."
    row: Row
    if isinstance(setting.default, bool):
        row = CheckRow(name, tip)
    elif isinstance(setting.default, str):
        choices = [Choice(key, of_phenomena(text)) for key, text in setting.choices]
        row = ChoiceRow(name, tip, choices, none=none)
    elif isinstance(setting.default, tuple):
        row = VectorRow(name, tip)
    else:
        number = NumberRow(name, tip, scale_of(setting), of_phenomena(setting.unit))
        number.limits = partial(limits_text, setting.low, setting.high)
        number.accepts = setting.can_be
        row = number
    default: Any = setting.default
    row.setValue(default)
    row.setDefault(default)
    return row


def ends_of(setting: Setting) -> tuple[float, float]:
    """From where to where a number's slider goes."""
    low, high = setting.span or (setting.low, setting.high)
    default = setting.default
    assert isinstance(default, float | int)
    reach = 10.0 * max(1.0, abs(default))  # where there are no ends
    return max(low, default - reach) if math.isinf(low) else low, (
        min(high, default + reach) if math.isinf(high) else high
    )


def scale_of(setting: Setting) -> Scale:
    """The slider's scale: within the bounds, to the last position."""
    low, high = ends_of(setting)
    if setting.logarithmic and setting.whole:
        return Doubling(low, high)
    if setting.logarithmic and high >= 2.0 * low:
        scale, position = Log(low, high), 10.0 ** (1 / Log.per_decade)
        low *= position if scale.value_at(0) < setting.low else 1.0
        high /= position if scale.value_at(scale.last) > setting.high else 1.0
        return Log(low, high)
    step = 1.0 if setting.whole else Linear.about((low + high) / 2.0, (high - low) / 2.0).step
    fraction = Fraction(repr(step))
    first, last = math.ceil(Fraction(low) / fraction), math.floor(Fraction(high) / fraction)
    return Linear(float(first * fraction), float(last * fraction), step)


# --------------------------------------------------------------------------- playing


class Player(QObject, Playing):
    """Lets a number run to and fro between the ends of its slider, until it is paused.

    A frame is asked for only when the one before has been handled, so that frames never queue up
    behind a slow renderer. Whatever else changes the number meanwhile is gone on from.

    Parameters
    ----------
    setting : Setting
        One with `per_second`: in its unit, or in powers of ten if it is logarithmic.
    """

    stepped = Signal(float)
    """The number's next value, once per frame."""
    started = Signal()
    paused = Signal()

    def __init__(self, setting: Setting, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._setting = setting
        self._low, self._high = map(self._place, ends_of(setting))
        self._speed = setting.per_second
        self._at = self._low
        self._shown: float | None = None
        self._clock = Clock(self)
        self._clock.ticked.connect(self.advance)
        self.button = QToolButton()
        self.button.clicked.connect(self.toggle)
        self._show_state()

    def play(self) -> None:
        """Run on from where the number is."""
        if not self.playing:
            self._clock.start()
            self._show_state()
            self.started.emit()

    def pause(self) -> None:
        """Stand still."""
        if self.playing:
            self._clock.stop()
            self._show_state()
            self.paused.emit()

    def show_value(self, value: float) -> None:
        """Note the number; one that is not the last frame's is where to go on from."""
        if value != self._shown:
            self._shown, self._at = value, self._place(value)

    def advance(self, seconds: float) -> None:
        """Run for some seconds and emit the number; without effect while paused."""
        if not self.playing:
            return
        if (self._at >= self._high and self._speed > 0.0) or (
            self._at <= self._low and self._speed < 0.0
        ):
            self._speed = -self._speed
        inside = self._low <= self._at <= self._high
        self._at += self._speed * seconds
        if inside:  # both ends are shown, for a frame
            self._at = min(max(self._at, self._low), self._high)
        value = 10.0**self._at if self._setting.logarithmic else self._at
        value = float(round(value)) if self._setting.whole else float(f"{value:.7g}")
        if value != self._shown:
            self._shown = value
            self.stepped.emit(value)

    def _place(self, value: float) -> float:
        return math.log10(value) if self._setting.logarithmic else value

    def _show_state(self) -> None:
        sign, word = ("❚❚", self.tr("Pause")) if self.playing else ("▶", self.tr("Play"))
        label = of_phenomena(self._setting.label)
        self.button.setText(sign)
        self.button.setAccessibleName(f"{word}: {label}")
        self.button.setToolTip(
            self.tr("Let it stand still; playing again goes on from here")
            if self.playing
            else self.tr("Let it run to and fro between the ends of its slider")
        )


# --------------------------------------------------------------------------- readout


def _full(sentence: str) -> str:
    """A clause as a sentence."""
    sentence = sentence[:1].upper() + sentence[1:]
    return sentence if sentence.endswith((".", "!", "?")) else f"{sentence}."


def value_text(value: Any, write: Callable[[float], str] = figure_text) -> str:
    """A reading's value: a number, several, a matrix as a table, or a translated word."""
    if value is None:
        return NONE
    if isinstance(value, str):
        return of_phenomena(value)
    if not isinstance(value, tuple):
        return write(value)
    side = math.isqrt(len(value))
    if len(value) > 2 and write is figure_text:
        write = partial(figure_text, digits=4)
    parts = [write(part) for part in value]
    if side < 3 or side * side != len(parts):
        text, half = f"({', '.join(parts)})", (len(parts) + 1) // 2
        if write is not number_text and len(text) > ON_A_LINE:
            return f"({', '.join(parts[:half])},\n{', '.join(parts[half:])})"
        return text
    rows = [parts[first : first + side] for first in range(0, len(parts), side)]
    cells = ("".join(f"<td align='right'>{part}</td>" for part in row) for row in rows)
    return f"<table cellpadding='2'>{''.join(f'<tr>{row}</tr>' for row in cells)}</table>"


class Readout(QWidget):
    """The numbers that the scene is about, large: label, value and unit of each reading.

    What has no value shows why in a sentence below, once for all that have the same reason.
    """

    def __init__(self) -> None:
        super().__init__()
        self.lines: list[tuple[QLabel, QLabel, QLabel]] = []
        self._dress()
        self._grid = QGridLayout()
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(8)
        self._grid.setVerticalSpacing(1)
        self._grid.setColumnStretch(0, 1)
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.setTextFormat(Qt.TextFormat.PlainText)
        self.note.hide()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addLayout(self._grid)
        column.addWidget(self.note)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

    def show_readings(self, readings: Sequence[Reading]) -> None:
        """Show these readings and no others."""
        while len(self.lines) < len(readings):
            self._add_line()
        labels = [of_phenomena(reading.label) for reading in readings]
        anew = labels != [label.text() for label, _, _ in self.lines if not label.isHidden()]
        for place, line in enumerate(self.lines):
            if anew:
                for widget in line:
                    widget.setVisible(place < len(readings))
                line[1].setMinimumWidth(0)
            if place < len(readings):
                self._write(line, readings[place], labels[place])
        reasons = [
            _full(reading.note.sentence(of_phenomena))
            for reading in readings
            if reading.note is not None
        ]
        text = "\n".join(dict.fromkeys(reasons))
        if text != self.note.text():
            self.note.setText(text)
            self.note.setVisible(bool(text))

    def _add_line(self) -> None:
        label, value, unit = QLabel(), QLabel(), QLabel()
        for part in (label, value, unit):
            part.setTextFormat(Qt.TextFormat.PlainText)
        label.setWordWrap(True)
        value.setTextFormat(Qt.TextFormat.AutoText)
        value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        unit.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        row = len(self.lines)
        for column, part in enumerate((label, value, unit)):
            part.setObjectName("number" if part is value else "reading")
            part.hide()
            self._grid.addWidget(part, row, column)
        self.lines.append((label, value, unit))

    def _write(self, line: tuple[QLabel, QLabel, QLabel], reading: Reading, name: str) -> None:
        label, value, unit = line
        text = value_text(reading.value)
        # What takes more room than a number or two is written smaller, so that it is seen whole.
        is_word = isinstance(reading.value, str)
        kind = "number" if not is_word and len(text) <= LARGE_CHARACTERS else "words"
        if kind != value.objectName() or is_word != value.wordWrap():
            value.setWordWrap(is_word)
            value.setMinimumWidth(WORDS_EM * self.fontMetrics().height() if is_word else 0)
            value.setObjectName(kind)
            value.style().unpolish(value)
            value.style().polish(value)
        if text != value.text():
            value.setText(text)
            if not is_word:
                # It only grows: a number with a digit less does not shift the others.
                value.setMinimumWidth(max(value.minimumWidth(), value.sizeHint().width()))
        exact = value_text(reading.value, number_text)
        tip = exact if exact != text else ""
        if value.toolTip() != tip:
            value.setToolTip(tip)
        if label.text() != name:
            label.setText(name)
            value.setAccessibleDescription(name)  # a name would be read instead of the number
            self._widen(label)
        unit_text = "" if reading.value is None else of_phenomena(reading.unit)
        if unit.text() != unit_text:
            unit.setText(unit_text)

    def _widen(self, label: QLabel) -> None:
        """Let a label wrap only if it is long."""
        natural = label.fontMetrics().horizontalAdvance(label.text()) + 4
        label.setMinimumWidth(min(natural, LABEL_EM * self.fontMetrics().height()))

    def _dress(self) -> None:
        """Give numbers and words their sizes; a font set by hand ends with the theme."""
        size = self.font().pointSizeF()
        sheet = (
            f"#number {{ font-size: {LARGE * size:g}pt; font-weight: 600; }}"
            f"#words {{ font-size: {LARGER * size:g}pt; font-weight: 600; }}"
            f"#reading {{ font-size: {LARGER * size:g}pt; }}"
        )
        if sheet != self.styleSheet():
            self.setStyleSheet(sheet)
            for label, value, _ in self.lines:
                value.setMinimumWidth(0)
                self._widen(label)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:  # projector mode
            self._dress()
