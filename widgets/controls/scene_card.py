"""The scene's card at the top of the dock: what to try, settings, and numbers.

::

    user, Play -> settings_edited({name: value}) -> owner accepts, or calls refuse(error)
    owner -> take                                    no signal follows

The card is built from the data of a `Phenomenon`; no phenomenon has code here.
"""

import math
from collections.abc import Iterable
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QHelpEvent, QHideEvent, QShowEvent
from PySide6.QtWidgets import QToolButton, QWidget

from app.lecture.highlight import NOTHING, Highlight
from app.model.parameter import ImpliedSettings, Parameter, Settings, Value
from app.model.projection import Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import Illustration, Phenomenon
from app.scenes.phenomena.words import Comparison, Phrase, Reading
from widgets.controls.parameter_rows import SettingMotion, make_row
from widgets.controls.readout import Readout, full_sentence
from widgets.parts.fields import ChoiceRow, Row, RowHolder, report_highlight
from widgets.parts.labels import Balanced, RefusalLabel
from widgets.parts.layouts import FREE, LetteredWidget, discard, in_column, in_row, tool_button
from widgets.parts.messages import all_digits, breakable, of_phenomena, read_text, sentence
from widgets.parts.number_rows import NumberRow
from widgets.parts.panel import Changed, Readable, ShownData
from widgets.parts.plain import show_tip
from widgets.parts.section import GAP_PX
from widgets.parts.wording import Wording

WORDS = Wording(__file__)
WORD = 16  # longest word that fits the narrowest dock
LONGEST_LINE = 32  # most letters of the names of compared pictures on one line of it
TITLE = 1.25  # size of the scene's name, relative to ordinary text


class SceneCard(LetteredWidget, QWidget, RowHolder):
    """Title, what to try, settings and readout of the scene, one below the other.

    `rows` and `motions` have the names of the settings as keys.
    """

    settings_edited = Signal(object)  # the user or a motion set these values, by settings' names
    comparison_wanted = Signal(str)  # the user wants to see this comparison of the scene
    highlighted = Signal(str, object)
    """The row or reading under the mouse or the focus, and its `Highlight`; then `NOTHING`."""

    def __init__(self) -> None:
        super().__init__()
        self.rows, self.title = {}, Balanced(name=True)  # first: a child already changes the font
        self._phenomenon: Phenomenon | None = None
        self._settings: Settings = {}
        self._illustration: Illustration | None = None
        self._about = NOTHING
        self._counted: tuple[Illustration, float] | None = None
        self._problem: Phrase | None = None
        self._projection: Projection | None = None
        self._why_not: dict[QWidget, str] = {}
        self._without_effect: set[str] = set()
        self._matches: set[QWidget] | None = None
        self._is_guided = False
        self._is_for_class = False
        self._edits = ""  # name of the setting that the user is changing
        self.motions: dict[str, SettingMotion] = {}
        self.lent: set[str] = set()  # names of the settings whose rows are elsewhere
        self.readable = Readable(self, self._fill, lambda: self._is_seen)
        all_digits.changed.connect(self.readable.changed)

        self.tries = Balanced()
        self.warning = RefusalLabel()
        self.readout = Readout()
        self.readout.highlighted.connect(partial(self.highlighted.emit, "reading"))
        buttons = (WORDS.tool(k, by_click=True) for k in ("use_mesh", "remove_mesh", "explanation"))
        self.use_mesh, self.remove_mesh, self.explanation = buttons
        self.comparisons: list[QToolButton] = []
        self._offered: dict[QWidget, bool] = {}
        self._rows = in_column(gap=GAP_PX)
        self._compares = in_column()
        in_column(
            self.title, self.tries, self._rows, self.warning, self.readout, self._compares,
            in_row(self.explanation, self.use_mesh, FREE, gap=4), in_row(self.remove_mesh, FREE),
            on=self, margins=(0, 0, 0, GAP_PX), gap=GAP_PX,
        )  # fmt: skip
        self._fit()

    # -- set by the owner

    def show_scene(
        self, title: str, tries: Iterable[str], phenomenon: Phenomenon | None, mesh: str = ""
    ) -> None:
        """Show another scene, with rows for its settings.

        `title` is translated, `tries` are not. A scene without settings and numbers has no
        phenomenon. `mesh` names the user's mesh in place of the objects, if there is one.
        """
        if phenomenon is not self._phenomenon:
            self.pause()
            for row in self.rows.values():  # this shows the last values of the previous scene
                row.finish_gesture()  # a burst of keys may not have ended yet
            self._phenomenon, self._settings, self._illustration = phenomenon, {}, None
            self._problem = None
            self._make_rows(() if phenomenon is None else phenomenon.settings)
            self._highlight_subject(())  # marks these rows
            self._offer_comparisons(() if phenomenon is None else phenomenon.words.comparisons)
            self.readout.begin(0 if phenomenon is None else phenomenon.numbers)
            self.readout.show_readings(())
            self.warning.show_text("")
        self.title.setText(breakable(title, WORD))
        self.tries.setText("\n".join(map(of_phenomena, tries)))
        has_place = phenomenon is not None and phenomenon.own_mesh
        self._offered = {
            self.use_mesh: has_place,
            self.remove_mesh: has_place and bool(mesh),
            self.explanation: phenomenon is not None,
        }
        self.remove_mesh.setAccessibleDescription(mesh)
        self.show_some(self._matches)

    def lift(self, rows: Iterable[Row]) -> None:
        """Show these rows of the projection below the scene's own."""
        for row in rows:
            self._rows.addWidget(row)

    def lend(self, names: Iterable[str]) -> list[Row]:
        """Return the rows of these settings to another place; `take_back` ends that."""
        self.lent = {name for name in names if name in self.rows}
        self.readable.changed()
        return [self.rows[name] for name in self.rows if name in self.lent]

    def take_back(self) -> None:
        """Put every row that was lent back into its place."""
        self.lent.clear()
        for place, row in enumerate(self.rows.values()):
            self._rows.insertWidget(place, row)

    @property
    def _is_seen(self) -> bool:
        return self.isVisible() or bool(self.lent)

    def set_guided(self, guided: bool) -> None:
        """Leave the scene's own questions out beside a lesson, which asks others."""
        self._is_guided = guided
        self.show_some(self._matches)

    def show_some(self, matches: set[QWidget] | None) -> None:
        """Show only the found rows; None shows the whole card."""
        self._matches = matches
        for name, row in self.rows.items():
            there = name not in self._without_effect if matches is None else row in matches
            row.setVisible(there)
        for part in (self.title, self.readout, *self.comparisons):
            part.setVisible(matches is None)
        self.tries.setVisible(matches is None and not self._is_guided)
        self.warning.setVisible(matches is None and bool(self.warning.text()))
        for button, offered in self._offered.items():
            button.setVisible(matches is None and offered and not self._is_for_class)

    def set_presenting(self, on: bool) -> None:
        """Hide the buttons that a class does not need."""
        self._is_for_class = on
        self.show_some(self._matches)

    @property
    def has_controls(self) -> bool:
        return self._rows.count() > 0

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Show settings, readout and warning; an edited setting follows at once."""
        self.show_illustration(shown.illustration, shown.document.settings, shown.projection)

    def show_illustration(
        self, illustration: Illustration | None, settings: Settings, projection: Projection
    ) -> None:
        """Show an illustration of a projection with the settings chosen last.

        The projection may have been moved since, so that the settings no longer hold.
        """
        if illustration is self._illustration and settings == self._settings:
            return
        anew = self._illustration is None
        self._highlight_subject(() if illustration is None else illustration.about)
        self._illustration, self._settings = illustration, settings
        self._projection = projection
        for name, motion in self.motions.items():
            motion.show_value(float(settings[name]))  # type: ignore[arg-type]
        if self._edits in settings and self._is_seen:
            self.rows[self._edits].setValue(settings[self._edits])
        self.readable.changed()
        if anew:  # values of the previous scene must not stay
            self.readable.settle()

    def _highlight_subject(self, names: Iterable[str]) -> None:
        about = frozenset(names)
        if about != self._about:
            self._about = about
            self.highlighted.emit("scene", about)

    def show_count(self, illustration: Illustration, share: float) -> None:
        """Show what was counted in the picture of an illustration, while it is shown."""
        self._counted = illustration, 100.0 * share
        if illustration is self._illustration:
            self.readable.changed()

    def show_problem(self, problem: Phrase | None) -> bool:
        """Say why the picture is not drawn as the scene requires; return whether that is new."""
        if problem == self._problem:
            return False
        self._problem = problem
        self.readable.changed()
        return True

    def refuse(self, error: Refusal) -> None:
        """Show a refusal at the row that was just edited; the last value stays."""
        row = self.rows[self._edits or next(iter(self.rows))]
        self.readable.settle()  # otherwise earlier accepted values would remove the sentence
        row.show_error(sentence(self.named(error)))

    def named(self, error: Refusal) -> Refusal:
        """Name a refusal by the label of its setting."""
        assert self._phenomenon is not None
        labels = {setting.path: setting.title for setting in self._phenomenon.settings}
        if error.field not in labels:
            return error
        return Refusal(of_phenomena(labels[error.field]), error.value, error.bound, *error.limits)

    def pause(self) -> None:
        for motion in self.motions.values():
            motion.pause()

    # -- rows

    def _make_rows(self, settings: Iterable[Parameter]) -> None:
        self.motions.clear()
        self.take_back()
        for row in self.rows.values():
            row.blockSignals(True)  # a number typed for the previous scene is not one of this one
        discard(self._rows, self.rows.values())
        self.rows = {}
        for setting in settings:
            row = make_row(setting, none=WORDS.say("none"))
            self.rows[setting.name] = row
            row.edited.connect(partial(self._edit, setting.name))
            self._join(row)
            report_highlight(row, self.highlighted, setting.path, frozenset((setting.path,)))
            if setting.per_second and isinstance(row, NumberRow):
                self._add_player(setting, row)
            self._rows.addWidget(row)
            for part in (row, *row.findChildren(QWidget)):
                part.installEventFilter(self)
        self._why_not, self._without_effect = {}, set()

    def _offer_comparisons(self, comparisons: Iterable[Comparison]) -> None:
        discard(self._compares, self.comparisons)
        self.comparisons = []
        for comparison in comparisons:
            names = [of_phenomena(name) for name, _ in comparison.pictures]
            about, tip = WORDS.say("compare", ", ".join(names)), WORDS.say("beside")
            is_short = sum(map(len, names)) <= LONGEST_LINE
            button = tool_button(
                (" | " if is_short else " |\n").join(names), f"{about}\n{tip}",
                partial(self.comparison_wanted.emit, comparison.name),
                icon="compare", name=about, by_click=True,
            )  # fmt: skip
            button.setMinimumWidth(1)  # it must not widen the dock
            self._compares.addWidget(button, 0, Qt.AlignmentFlag.AlignLeft)
            self.comparisons.append(button)

    def show_highlight(self, highlighted: Highlight) -> None:
        for setting in () if self._phenomenon is None else self._phenomenon.settings:
            if setting.name in self.rows:  # there are no rows while the scene changes
                self.rows[setting.name].set_marked(setting.path in highlighted)
        self.readout.show_highlight(highlighted)

    def _add_player(self, setting: Parameter, row: NumberRow) -> None:
        motion = SettingMotion(setting, self)
        self.motions[setting.name] = motion
        motion.stepped.connect(partial(self._played, setting.name))
        motion.gesture_started.connect(partial(self._play_started, motion))
        motion.gesture_finished.connect(self.gesture_finished)
        row.put_beside(motion.button)

    def _play_started(self, motion: SettingMotion) -> None:
        for other in self.motions.values():
            if other is not motion:
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
        self.readable.settle()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        if not event.spontaneous():  # nobody could stop a hidden motion
            self.pause()

    def _fill(self) -> None:
        values: ImpliedSettings = self._settings
        if self._phenomenon is not None and self._projection is not None and values:
            values = self._phenomenon.at_hand(self._projection, self._settings)
        for name, value in values.items():
            row = self.rows[name]
            if row.error and not row.in_hand and name != self._edits:
                row.clear_error()  # another value has made it possible
            is_choice = isinstance(row, ChoiceRow)
            row.setValue(self._settings[name] if value is None and not is_choice else value)
            if name in self.motions and isinstance(value, float):
                self.motions[name].show_value(value)
        illustration = self._illustration
        readings = () if illustration is None else illustration.readings
        self.readout.show_readings([self._with_count(r) if r.counted else r for r in readings])
        has_diagrams = illustration is not None and bool(illustration.diagrams)
        self.explanation.setText(WORDS.say("diagrams") if has_diagrams else WORDS["explanation"][0])
        warning = self._problem if illustration is None else illustration.warning or self._problem
        why = "" if warning is None else full_sentence(warning.sentence(of_phenomena, read_text))
        self.warning.show_text(why)
        self._let_choose(values, why if illustration is not None and illustration.idle else "")

    def _with_count(self, reading: Reading) -> Reading:
        """Give a counted reading its value, or its note if there was nothing to count."""
        share = None
        if self._counted is not None and self._counted[0] is self._illustration:
            share = self._counted[1]
        if share is not None and math.isnan(share):
            return reading
        return replace(reading, value=share, note=None)

    def _let_choose(self, values: ImpliedSettings, why_not: str) -> None:
        """Enable the settings that have an effect; `why_not` says why none has."""
        without_effect = set()
        for setting in () if self._phenomenon is None else self._phenomenon.settings:
            name, row = setting.name, self.rows[setting.name]
            why = why_not
            if values and not why:
                why = self._without_another(setting, values)
                if why:
                    without_effect.add(name)
                elif values[name] is None and not isinstance(row, ChoiceRow):
                    why = WORDS.say("no-value")
            if why != self._why_not.get(row, ""):
                for part in (row, *row.findChildren(QWidget)):
                    self._why_not[part] = why
                row.setEnabled(not why)
                if why and name in self.motions:
                    self.motions[name].pause()
        if without_effect != self._without_effect:
            self._without_effect = without_effect
            self.show_some(self._matches)

    def _without_another(self, setting: Parameter, values: ImpliedSettings) -> str:
        """Say which value of another setting this one needs, if it has another value."""
        assert self._phenomenon is not None
        name, wanted = setting.only_with or ("", None)
        if not name or values[name] == wanted:
            return ""
        other = next(other for other in self._phenomenon.settings if other.name == name)
        label = of_phenomena(other.title)
        if isinstance(wanted, bool):
            return WORDS.say("switched", label)
        return WORDS.say("only", label, of_phenomena(dict(other.choices)[str(wanted)]))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QShowEvent):  # perhaps elsewhere, while the card is hidden
            self.readable.settle()
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            why = self._why_not.get(watched) if isinstance(watched, QWidget) else None
            if why:
                show_tip(event.globalPos(), why)  # instead of its own
                return True
        return False

    def _fit(self) -> None:
        """Set the size of the name with a style sheet, because a theme would reset a font."""
        sheet = f"font-size: {TITLE * self.font().pointSizeF():g}pt; font-weight: 600;"
        if sheet != self.title.styleSheet():
            self.title.setStyleSheet(sheet)
