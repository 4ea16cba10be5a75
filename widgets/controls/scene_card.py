"""The scene at the top of the dock: what to try, its own settings, and the numbers it is about.

::

    user, Play -> settings_edited({name: value}) -> owner takes it, or calls refuse(error)
    owner -> take                                    never answered by a signal

Everything here is made from the data of a `Phenomenon`; no phenomenon has code of its own.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QHelpEvent, QHideEvent, QPalette, QShowEvent
from PySide6.QtWidgets import (
    QGridLayout,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.lecture.highlight import NOTHING, Highlight
from app.model.projection import Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import Illustration, Phenomenon
from app.scenes.phenomena.readout import Phrase, Reading
from app.scenes.phenomena.settings import Found, Setting, Settings, Value
from app.scenes.phenomena.words import Comparison
from widgets.parts.buttons import tool_button
from widgets.parts.clock import Clock, Playing
from widgets.parts.fields import (
    CheckRow,
    Choice,
    ChoiceRow,
    Doubling,
    Linear,
    Log,
    NumberRow,
    Row,
    RowHolder,
    Scale,
    VectorRow,
)
from widgets.parts.icons import RefusalLabel, show_icon
from widgets.parts.layouts import FREE, in_column, in_row
from widgets.parts.messages import (
    breakable,
    limits_text,
    number_text,
    of_phenomena,
    read_text,
    sentence,
)
from widgets.parts.note import Balanced
from widgets.parts.panel import Changed, Shown
from widgets.parts.plain import Label, set_tip, show_tip
from widgets.parts.readable import Readable
from widgets.parts.section import GAP_PX
from widgets.parts.typeset import TypesetLabel, in_line, matrix
from widgets.parts.writing import all_digits, lettering

WORD = 16
"""Characters of a file's name that find room in the narrowest dock."""
TITLE, LARGE = 1.25, 1.15
"""Size of the scene's name, and of a reading's number, against ordinary text."""
BESIDE, ON_A_LINE = 13, 30
"""Longest text of a value beside its label, and of numbers that is not broken in two."""
LABEL_EM, WORDS_EM = 6, 7
"""Widths in heights of a line, beyond which labels, and words as values, may wrap."""
BETWEEN_EM = 0.35
"""Between two readings, whose labels may have several lines."""
NONE = "–"
"""Stands for a reading that there is not."""


class SceneCard(QWidget, RowHolder):
    """Title, what to try, settings and readout of the scene at hand, one below the other.

    Attributes
    ----------
    rows : dict of str to Row
        Of the settings, by their names.
    players : dict of str to Player
        Of the settings that can be played, by their names.
    """

    settings_edited = Signal(object)
    """The user chose, or a player reached, these settings: a dict of values by name."""
    mesh_wanted = Signal()
    """The user wants to choose a mesh for the place of the scene's own objects."""
    mesh_removed = Signal()
    """The user wants the scene's own objects back."""
    comparison_wanted = Signal(str)
    """The user wants to see this one of the scene's own comparisons."""
    highlighted = Signal(str, object)
    """Which row or reading the user is at, and the `Highlight` it draws; `NOTHING` after it."""
    explanation_wanted = Signal()
    """The user wants to read more about the scene, and to see its diagrams."""

    def __init__(self) -> None:
        super().__init__()
        self.rows = {}  # first: a change of font comes with the first child
        self._phenomenon: Phenomenon | None = None
        self._settings: Settings = {}
        self._illustration: Illustration | None = None
        self._about = NOTHING
        self._counted: tuple[Illustration, float] | None = None
        self._problem: Phrase | None = None
        self._projection: Projection | None = None
        self._why_not: dict[QWidget, str] = {}
        self._without_effect: set[str] = set()
        self._found: set[QWidget] | None = None
        self._is_for_class = False
        self._edits = ""  # name of the setting that the user is changing
        self.players: dict[str, Player] = {}
        self._readable = Readable(self, self._fill)
        all_digits.changed.connect(self._readable.changed)

        self.title, self.tries = Balanced(), Balanced()
        self.warning = RefusalLabel()
        self.readout = Readout()
        self.readout.highlighted.connect(partial(self.highlighted.emit, "reading"))
        self.use_mesh = tool_button(
            self.tr("My mesh…"),
            self.tr("Put a mesh from a file into the place of the scene's own objects"),
            self.mesh_wanted, name=self.tr("My mesh"), by_click=True,
        )  # fmt: skip
        self.remove_mesh = tool_button(
            self.tr("Own objects"), self.tr("Put the scene's own objects back"),
            self.mesh_removed, name=self.tr("Own objects"), by_click=True,
        )  # fmt: skip
        self.explanation = tool_button(
            self.tr("Explanation…"),
            self.tr("What the scene shows, in which lectures, and its diagrams, below the panes"),
            self.explanation_wanted, name=self.tr("Explanation and diagrams"), by_click=True,
        )  # fmt: skip
        self.comparisons: list[QToolButton] = []
        self._offered: dict[QWidget, bool] = {}
        self._rows = in_column(gap=GAP_PX)
        self._compares = in_column()
        in_column(
            self.title, self.tries, self._rows, self.warning, self.readout, self._compares,
            in_row(self.explanation, self.use_mesh, FREE, gap=4), in_row(self.remove_mesh, FREE),
            on=self, margins=(0, 0, 0, GAP_PX), gap=GAP_PX,
        )  # fmt: skip
        self._dress()

    # -- what the owner says

    def show_scene(
        self, title: str, tries: Iterable[str], phenomenon: Phenomenon | None, mesh: str = ""
    ) -> None:
        """Show another scene, with rows for its settings.

        Parameters
        ----------
        title : str
            Translated.
        tries : iterable of str
            What to try with it, a line each; to be translated.
        phenomenon : Phenomenon or None
            None for a scene that has no settings and no numbers of its own.
        mesh : str
            Name of the user's mesh in the place of its objects, or nothing.
        """
        if phenomenon is not self._phenomenon:
            self.pause()
            for row in self.rows.values():  # which shows the last of the scene that is left
                row.finish_gesture()  # a burst of keys that has not gone quiet yet, and never would
            self._phenomenon, self._settings, self._illustration = phenomenon, {}, None
            self._problem = None
            self._make_rows(() if phenomenon is None else phenomenon.settings)
            self._be_about(())  # which marks these rows
            self._offer_comparisons(() if phenomenon is None else phenomenon.comparisons)
            self.readout.begin(0 if phenomenon is None else phenomenon.numbers)
            self.readout.show_readings(())
            self.warning.say("")
        self.title.setText(breakable(title, WORD))
        self.tries.setText("\n".join(map(of_phenomena, tries)))
        has_place = phenomenon is not None and phenomenon.own_mesh
        self._offered = {
            self.use_mesh: has_place,
            self.remove_mesh: has_place and bool(mesh),
            self.explanation: phenomenon is not None,
        }
        self.remove_mesh.setAccessibleDescription(mesh)
        self.show_some(self._found)

    def lift(self, rows: Iterable[Row]) -> None:
        """Show these rows of the projection below the scene's own."""
        for row in rows:
            self._rows.addWidget(row)

    def show_some(self, found: set[QWidget] | None) -> None:
        """Show only those of its rows that are among these; None shows the scene as it is."""
        self._found = found
        for name, row in self.rows.items():
            there = name not in self._without_effect if found is None else row in found
            row.setVisible(there)
        for part in (self.title, self.tries, self.readout):
            part.setVisible(found is None)
        self.warning.setVisible(found is None and bool(self.warning.text()))
        for button, offered in self._offered.items():
            button.setVisible(found is None and offered and not self._is_for_class)
        for button in self.comparisons:
            button.setVisible(found is None)

    def set_presenting(self, on: bool) -> None:
        """Show a class what to try, its controls and its numbers, and nothing else."""
        self._is_for_class = on
        self.show_some(self._found)

    @property
    def has_controls(self) -> bool:
        """Whether there is something in it to be set."""
        return self._rows.count() > 0

    def take(self, shown: Shown, changed: Changed) -> None:
        """Show settings, readout and warning; a setting in the hand follows it at once."""
        self.show_illustration(shown.illustration, shown.document.settings, shown.projection)

    def show_illustration(
        self, illustration: Illustration | None, settings: Settings, projection: Projection
    ) -> None:
        """Likewise, of an illustration.

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
        self._be_about(() if illustration is None else illustration.about)
        self._illustration, self._settings = illustration, settings
        self._projection = projection
        for name, player in self.players.items():
            player.show_value(float(settings[name]))  # type: ignore[arg-type]
        if self._edits in settings and self.isVisible():
            self.rows[self._edits].setValue(settings[self._edits])
        self._readable.changed()
        if anew:  # of the scene before, nothing is to be seen
            self._readable.settle()

    def _be_about(self, names: Iterable[str]) -> None:
        """Let what the scene is about just now stand out."""
        about = frozenset(names)
        if about != self._about:
            self._about = about
            self.highlighted.emit("scene", about)

    def begin_gesture(self) -> None:
        """Until `end_gesture`, values run: a control is dragged, or something plays."""
        self._readable.begin_gesture()

    def end_gesture(self) -> None:
        """End the gesture that `begin_gesture` began."""
        self._readable.end_gesture()

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
        _remove(self._rows, self.rows.values())
        self.rows = {}
        for setting in settings:
            row = make_row(setting, self.tr("none of these"))
            self.rows[setting.name] = row
            row.edited.connect(partial(self._edit, setting.name))
            self._join(row)
            row.highlighted.connect(partial(self._row_highlighted, setting.path))
            if setting.per_second and isinstance(row, NumberRow):
                self._add_player(setting, row)
            self._rows.addWidget(row)
            for part in (row, *row.findChildren(QWidget)):
                part.installEventFilter(self)
        self._why_not, self._without_effect = {}, set()

    def _offer_comparisons(self, comparisons: Iterable[Comparison]) -> None:
        _remove(self._compares, self.comparisons)
        self.comparisons = []
        for comparison in comparisons:
            names = " | ".join(of_phenomena(name) for name, _ in comparison.pictures)
            about = self.tr("Compare: {0}").format(names.replace(" | ", ", "))
            tip = self.tr("Show these pictures beside each other, in large")
            button = tool_button(
                names, f"{about}\n{tip}", partial(self.comparison_wanted.emit, comparison.name),
                icon="compare", name=about, by_click=True,
            )  # fmt: skip
            button.setMinimumWidth(1)  # it widens no dock
            self._compares.addWidget(button, 0, Qt.AlignmentFlag.AlignLeft)
            self.comparisons.append(button)

    def _row_highlighted(self, path: str, is_highlighted: bool) -> None:
        self.highlighted.emit(path, frozenset((path,)) if is_highlighted else NOTHING)

    def show_highlight(self, highlighted: Highlight) -> None:
        """Mark the rows and the readings that are about what is highlighted."""
        for setting in () if self._phenomenon is None else self._phenomenon.settings:
            if setting.name in self.rows:  # one that loses the focus goes before others come
                self.rows[setting.name].set_marked(setting.path in highlighted)
        self.readout.show_highlight(highlighted)

    def _add_player(self, setting: Setting, row: NumberRow) -> None:
        player = Player(setting, self)
        self.players[setting.name] = player
        player.stepped.connect(partial(self._played, setting.name))
        player.started.connect(partial(self._play_started, player))
        player.paused.connect(self.gesture_finished)
        row.put_beside(player.button)

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

    # -- shown

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._readable.settle()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        if not event.spontaneous():  # nobody sees it, and nobody could stop it
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
        has_diagrams = illustration is not None and bool(illustration.diagrams)
        self.explanation.setText(self.tr("Diagrams…") if has_diagrams else self.tr("Explanation…"))
        warning = self._problem if illustration is None else illustration.warning or self._problem
        why = "" if warning is None else full_sentence(warning.sentence(of_phenomena, read_text))
        self.warning.say(why)
        self._let_choose(found, why if illustration is not None and illustration.idle else "")

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
        without_effect = set()
        for setting in () if self._phenomenon is None else self._phenomenon.settings:
            name, row = setting.name, self.rows[setting.name]
            why = why_not
            if found and not why:
                why = self._without_another(setting, found)
                if why:
                    without_effect.add(name)
                elif found[name] is None and not isinstance(row, ChoiceRow):
                    why = self.tr("The lens has none: choose one of the above first.")
            if why != self._why_not.get(row, ""):
                for part in (row, *row.findChildren(QWidget)):
                    self._why_not[part] = why
                row.setEnabled(not why)
                if why and name in self.players:
                    self.players[name].pause()
        if without_effect != self._without_effect:
            self._without_effect = without_effect
            self.show_some(self._found)

    def _without_another(self, setting: Setting, found: Found) -> str:
        """With what value of another one alone a setting changes something, if it has another."""
        assert self._phenomenon is not None
        name, wanted = setting.only_with or ("", None)
        if not name or found[name] == wanted:
            return ""
        other = next(other for other in self._phenomenon.settings if other.name == name)
        label = of_phenomena(other.label)
        if isinstance(wanted, bool):
            return self.tr("Only with “{0}” switched on.").format(label)
        text = of_phenomena(dict(other.choices)[str(wanted)])
        return self.tr("Only with “{0}”: {1}.").format(label, text)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            why = self._why_not.get(watched) if isinstance(watched, QWidget) else None
            if why:
                show_tip(event.globalPos(), why)  # instead of what it would do
                return True
        return super().eventFilter(watched, event)

    def _dress(self) -> None:
        """Give the name its size; a font set by hand ends with the theme."""
        sheet = f"font-size: {TITLE * self.font().pointSizeF():g}pt; font-weight: 600;"
        if sheet != self.title.styleSheet():
            self.title.setStyleSheet(sheet)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and hasattr(self, "title"):
            self._dress()


def _remove(layout: QVBoxLayout, widgets: Iterable[QWidget]) -> None:
    """Take widgets out of a layout, for good."""
    for widget in widgets:
        layout.removeWidget(widget)
        widget.hide()
        widget.deleteLater()


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
        return Log(low, high)
    step = 1.0 if setting.whole else Linear.about((low + high) / 2.0, (high - low) / 2.0).step
    fraction = Fraction(repr(step))
    first, last = math.ceil(Fraction(low) / fraction), math.floor(Fraction(high) / fraction)
    parts = 1 if setting.whole else Linear.parts
    return Linear(float(first * fraction), float(last * fraction), step, parts)


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
        self.speed = setting.per_second
        self._at = self._low
        self._shown: float | None = None
        self._clock = Clock(self)
        self._clock.ticked.connect(self.advance)
        self.button = tool_button(act=self.toggle)
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
        if (self._at >= self._high and self.speed > 0.0) or (
            self._at <= self._low and self.speed < 0.0
        ):
            self.speed = -self.speed
        inside = self._low <= self._at <= self._high
        self._at += self.speed * seconds
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
        self._name_button(
            f"{{0}}: {of_phenomena(self._setting.label)}",
            self.tr("Let it run to and fro between the ends of its slider"),
            self.tr("Let it stand still; playing again goes on from here"),
        )


# --------------------------------------------------------------------------- readout


def full_sentence(sentence: str) -> str:
    """A clause as a sentence, from its first letter to its full stop."""
    sentence = sentence[:1].upper() + sentence[1:]
    return sentence if sentence.endswith((".", "!", "?")) else f"{sentence}."


def _side(value: Any) -> int:
    """How many rows a reading's matrix has; 0 for what is none."""
    side = math.isqrt(len(value)) if isinstance(value, tuple) else 0
    return side if side >= 3 and side * side == len(value) else 0


def value_text(value: Any, write: Callable[[float], str]) -> str:
    """A reading's value: a number, several, a matrix to be typeset, or a translated word."""
    if value is None:
        return NONE
    if isinstance(value, str):
        return of_phenomena(value)
    if not isinstance(value, tuple):
        return write(value)
    side, parts = _side(value), [write(part) for part in value]
    if not side:
        text, half = f"({', '.join(parts)})", (len(parts) + 1) // 2
        if len(text) > ON_A_LINE:
            return f"({', '.join(parts[:half])},\n{', '.join(parts[half:])})"
        return text
    return matrix(parts[first : first + side] for first in range(0, len(parts), side))


class _Value(TypesetLabel):
    """What is read of a reading; what is copied has all the digits.

    Attributes
    ----------
    is_below : bool
        Whether it stands below its label.
    """

    def __init__(self) -> None:
        super().__init__()
        self.is_below, self.shrinks = False, True
        self.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)


class Readout(QWidget):
    """The numbers that the scene is about: label, value and unit of each reading.

    The first of them are seen; the others are folded, and not written until they are unfolded.
    What has no value shows why in a sentence below, once for all that have the same reason.
    """

    highlighted = Signal(object)
    """The `Highlight` that the mouse draws to what a reading is about."""

    def __init__(self) -> None:
        super().__init__()
        self._highlight = NOTHING
        self.lines: list[tuple[Label, _Value, Label]] = []
        self._readings: Sequence[Reading] = ()
        self._first = 0
        self._grid = QGridLayout()
        self._dress()
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(4)
        self._grid.setColumnStretch(0, 1)
        self.more = tool_button(
            self.tr("More numbers"), self.tr("Show the other numbers of this scene, or fold them"),
            icon="unfold", name=self.tr("More numbers"), flat=True, checkable=True, by_click=True,
        )  # fmt: skip
        self.more.toggled.connect(self._show)
        self.more.hide()
        self.note = Label(wordWrap=True)
        self.note.hide()
        in_column(self._grid, self.note, self.more, on=self, margins=(0, 0, 0, 0), gap=2)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        all_digits.changed.connect(self._show)
        lettering.changed.connect(self._show)

    def begin(self, first: int) -> None:
        """Be the readout of another scene: so many of its readings are always seen."""
        self._first = first
        self.more.setChecked(False)

    def show_readings(self, readings: Sequence[Reading]) -> None:
        """Show these readings and no others."""
        self._readings = readings
        self._show()

    def _show(self) -> None:
        many = len(self._readings) > self._first + 1  # a fold of one would take as much room
        unfolded = not many or self.more.isChecked()
        readings = self._readings if unfolded else self._readings[: self._first]
        self.more.setVisible(many)
        show_icon(self.more, "choose" if unfolded else "unfold")
        while len(self.lines) < len(readings):
            self._add_line()
        labels = [of_phenomena(reading.label) for reading in readings]
        anew = labels != [label.text() for label, _, _ in self.lines if not label.isHidden()]
        self._mark()
        for place, line in enumerate(self.lines):
            if anew:
                for widget in line:
                    widget.setVisible(place < len(readings))
                line[1].setMinimumWidth(0)
            if place < len(readings):
                self._write(line, readings[place], labels[place])
        reasons = [
            full_sentence(reading.note.sentence(of_phenomena, read_text))
            for reading in readings
            if reading.note is not None
        ]
        self.note.setText("\n".join(dict.fromkeys(reasons)))
        self.note.setVisible(bool(reasons))

    def show_highlight(self, highlighted: Highlight) -> None:
        """Mark the numbers that speak of what is highlighted."""
        self._highlight = highlighted
        self._mark()

    def _mark(self) -> None:
        for reading, (_, value, _) in zip(self._readings, self.lines, strict=False):
            value.set_marked(bool(self._highlight.intersection(reading.about)))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Enter, QEvent.Type.Leave):
            about: Highlight = NOTHING
            for reading, line in zip(self._readings, self.lines, strict=False):
                if watched in line and event.type() == QEvent.Type.Enter:
                    about = frozenset(reading.about)
            self.highlighted.emit(about)
        return super().eventFilter(watched, event)

    def _add_line(self) -> None:
        label, value, unit = Balanced(), _Value(), Label()
        unit.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        row = 2 * len(self.lines)
        for column, part in enumerate((label, value, unit)):
            part.hide()
            part.installEventFilter(self)
            self._grid.addWidget(part, row, column)
        value.setObjectName("number")
        self.lines.append((label, value, unit))

    def _write(self, line: tuple[Label, _Value, Label], reading: Reading, name: str) -> None:
        label, value, unit = line
        value.cell = reading.cell
        exact = in_line(value_text(reading.value, number_text))
        text = value_text(reading.value, read_text)
        is_word = isinstance(reading.value, str)
        if is_word != value.wordWrap():
            value.setWordWrap(is_word)
            value.setMinimumWidth(WORDS_EM * self.fontMetrics().height() if is_word else 0)
        if text != (value.formula or value.text()):
            (value.set_formula if _side(reading.value) else value.set_words)(text)
            self._place(value, max(map(len, text.split("\n"))) > BESIDE and not is_word)
            if not is_word and not _side(reading.value):
                # It only grows: a number with a digit less does not shift the others.
                value.setMinimumWidth(max(value.minimumWidth(), value.sizeHint().width()))
        if value.exact != exact:
            value.set_exact(exact)
            set_tip(value, exact)
        if label.text() != name:
            label.setText(name)
            value.setAccessibleDescription(name)  # a name would be read instead of the number
            self._widen(label)
        unit.setText("" if reading.value is None else of_phenomena(reading.unit))

    def _place(self, value: _Value, below: bool) -> None:
        """Put a value beside its label, or below it where it is too long for that."""
        row = 2 * [each[1] for each in self.lines].index(value)
        if below != value.is_below:
            value.is_below = below
            self._grid.addWidget(value, row + below, 0 if below else 1, 1, 3 if below else 1)

    def _widen(self, label: Label) -> None:
        """Let a label wrap only if it is long."""
        natural = label.fontMetrics().horizontalAdvance(label.text()) + 4
        label.setMinimumWidth(min(natural, LABEL_EM * self.fontMetrics().height()))

    def _dress(self) -> None:
        """Give numbers their size; a font set by hand ends with the theme."""
        size = self.font().pointSizeF()
        self._grid.setVerticalSpacing(round(BETWEEN_EM * self.fontMetrics().height()))
        sheet = f"#number {{ font-size: {LARGE * size:g}pt; font-weight: 600; }}"
        if sheet != self.styleSheet():
            self.setStyleSheet(sheet)
            for label, value, _ in self.lines:
                value.setMinimumWidth(0)
                self._widen(label)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._dress()
