"""The wiring of the main window: a table of its components' signals and slots.

`MainWindow` notifies the components of changes to the document, in the order of its list.
"""

from functools import partial
from typing import Any

from widgets.panes.pane import Pane
from widgets.parts.gestures import Gestures
from widgets.parts.messages import all_digits, lettering
from widgets.parts.panel import Panel
from widgets.window.hiding import hide


def wire(window: Any) -> None:
    """Connect the components of a `MainWindow`, which imports this module, to each other."""
    _wire_components(window)
    _wire_lesson(window)
    _wire_gestures(window)
    _wire_highlight(window)


def _wire_components(window: Any) -> None:
    store, controls, menus, strip, world = (
        window.store, window.controls, window.menus, window.strip, window.panes["world"]
    )  # fmt: skip
    look, card, compare = window.look, controls.card, window.comparing.pictures
    probe, measure = window.probe_panel, window.measure_panel
    settings, reduces = window.settings, menus.reduce_motion
    lettering.set("own")  # it may still belong to another window
    all_digits.set(settings.all_digits)
    menus.show_recent()
    wires: tuple[tuple[Any, ...], ...] = (
        (store.changed, window.show_document),
        (store.view_changed, window.show_view),
        (controls.edited, store.set_projection),
        (controls.object_unfolded, partial(world.request, "object_axes")),
        (controls.chain.compared, partial(world.request, "former")),
        (controls.chain.stood, strip.go_to),
        (controls.chain.factored, lambda: window.panels.open(window.matrices)),
        (controls.chain.factored, window.matrices.show_object),
        (window.matrices.sought, controls.show_tile),
        (controls.animation.gesture_started, partial(menus.show_playing, True)),
        (controls.animation.gesture_finished, partial(menus.show_playing, False)),
        (controls.animation.walked, partial(world.request, "walk")),
        (card.use_mesh.clicked, window.files.mesh_dialog),
        (card.remove_mesh.clicked, lambda: window.files.use_mesh("")),
        (window.counting.counted, card.show_count),
        (window.manipulation.edited, store.set_projection),
        (window.frame_panel.step_changed, partial(world.request, "step")),
        (strip.moved, partial(window.panes["ndc"].request, "stage"), window.matrices.show_stage),
        (strip.turned, controls.chain.turn),
        *((strip.turned, partial(pane.request, "from_left")) for pane in window.panes.values()),
        (strip.named, window.panes["ndc"].header.show_title),
        (strip.gesture_started, partial(look.refine, "ndc", False)),
        (strip.gesture_finished, partial(look.refine, "ndc", True)),
        (window.matrices.letters_changed, lettering.set, look.set_letters),
        (window.panels.idle.timeout, lambda: window.matrices.prepare(window.shown.projection)),
        (window.history.rested, look.rest, compare.refresh),
        (look.built, window.manipulation.leave, compare.set_style),
        (look.built, window.set_style, window.slide.equation.set_style, window.slide.pen.set_style),
        (look.built, window.band.set_style),
        (menus.all_digits.triggered, lambda on: setattr(settings, "all_digits", on)),
        (menus.all_digits.triggered, all_digits.set),
        (reduces.triggered, lambda on: setattr(settings, "reduce_motion", on)),
        (menus.view_menu.aboutToShow, lambda: reduces.setChecked(not window.transition.is_wanted)),
        (menus.find.triggered, window.find_control),
        (menus.play.triggered, controls.animation.toggle),
        (menus.undo.triggered, window.status.clearMessage),  # it may be what brings changes back
        (menus.theme_chosen, look.set_theme),
        (menus.language_chosen, window.choose_language),
        (menus.present.triggered, window.lesson_card.reopen, window.present.toggle),
        (menus.present_all.triggered, window.lesson_card.reopen),
        (menus.present_all.triggered, lambda: window.lessons.go(0), window.present.begin),
        (menus.blank.triggered, window.present.blank),
        (menus.strip.triggered, window.control_strip.toggle),
        (menus.pen.triggered, window.slide.pen.switch),
        (window.slide.pen.switched, menus.pen.setChecked),
        (window.slide.touched, window.control_strip.show_now),
        (compare.drawn, window.slide.question.place),
        (menus.pointer.toggled, window.probing.set_pointing),
        (menus.start_card.triggered, window.show_start_card),
        (menus.trades.triggered, window.show_trades),
        (menus.controls.triggered, window.show_beside),
        (menus.show_cost.triggered, window.cost.measure),
        (menus.remove_probe.triggered, probe.remove),
        (probe.changed, lambda: menus.remove_probe.setEnabled(bool(probe.probes))),
        (window.present.switched, window.show_presenting, window.messages.put_off),
        (window.present.switched, window.laser.listen),
        (window.present.moved, window.fit_screen),
        (window.slots.rearranged, window.show_beside),
        (window.files.recent_changed, menus.show_recent),
        (window.pictures.exported, window.show_message),
        (window.probing.refused, window.messages.show_message),
        (window.panels.chosen, window.probing.begin),
        (measure.refusal_withdrawn, window.messages.hide_message),
        (probe.refusal_withdrawn, window.messages.hide_message),
        (measure.succeeded, window.messages.done),
        (measure.used, window.manipulation.let_go, window.quality.use),
        (measure.used, lambda: window.panels.open(measure)),  # it stays open
    )
    for name, pane in window.panes.items():
        if name != "ndc":  # the others have no stage after the world's
            strip.moved.connect(lambda at, pane=pane: pane.request("stage", min(at, 0.0) or None))
        window.control_strip.grips_wanted.connect(partial(pane.request, "grips"))
    for signal, *slots in wires:
        for slot in slots:
            signal.connect(slot)
    for panel in window.panels.all:
        panel.edited.connect(store.set_projection)
        panel.adjusted.connect(window.show_message)
        panel.refused.connect(window.messages.show_message)
        panel.copy_wanted.connect(window.pictures.copy_diagram)
        panel.export_wanted.connect(window.pictures.export_diagram)
        look.built.connect(panel.set_style)


def _wire_lesson(window: Any) -> None:
    """Connect the lesson's card to its keys, and to everything that a task may require."""
    card, menus = window.lesson_card, window.menus
    menus.lesson_menu.wire(card, window.settings, window.practice, window.talks)
    card.begun_again.connect(window.offer_answers)
    cursors = window.cursors.values()
    card.page.hidden.connect(partial(hide, window.panels, window.controls, cursors, window.panes))
    card.page.hidden.connect(window.pane_words.hide)
    card.page.aimed.connect(window.pointing.aim)
    card.toggled.connect(window.show_beside)
    card.toggled.connect(window.side.make_room)
    card.handles_called.connect(partial(window.panes["world"].request, "handles"))
    guided = window.controls.card.set_guided
    window.lessons.opened.connect(lambda: guided(window.lessons.lesson is not None))
    reveal = window.controls.reveal  # what the step needs, once its card has its room
    window.lessons.stepped.connect(lambda: reveal(window.store.document.view.controls))
    for signal in (
        window.store.changed,
        window.store.view_changed,
        window.strip.moved,
        window.slots.rearranged,
        window.panels.opened,
        window.probe_panel.changed,
        window.frame_panel.step_changed,
        window.matrices.letters_changed,
        window.comparing.pictures.changed,
        *(pane.hand.moved for pane in window.panes.values()),
        *(each.triggered for each in (*menus.fixed.values(), *menus.layers.values())),
        menus.name_everything.triggered,
    ):
        signal.connect(card.look_again)
        signal.connect(window.pane_words.describe_later)


def _wire_gestures(window: Any) -> None:
    """Connect every gesture, such as a drag, to the store, which makes it one undo step."""
    store, controls, panels = window.store, window.controls, window.panels.all
    sources: tuple[Gestures, ...] = (controls, controls.animation, window.manipulation, *panels)
    for each in sources:
        for told in (store, controls.card.readable, window.slide.equation, *panels):
            each.gesture_started.connect(told.begin_gesture)
            each.gesture_finished.connect(told.end_gesture)
        each.gesture_abandoned.connect(store.abandon_gesture)
    window.strip.gesture_started.connect(window.measure_panel.begin_gesture)
    window.strip.gesture_finished.connect(window.measure_panel.end_gesture)


def _wire_highlight(window: Any) -> None:
    """Connect every pane and panel to the highlighter, in both directions."""
    mark = window.highlighter.mark
    window.controls.highlighted.connect(mark)
    places: tuple[Pane | Panel, ...] = (*window.panes.values(), *window.panels.all)
    for number, place in enumerate(places):
        place.highlighted.connect(partial(mark, number))
        window.highlighter.changed.connect(place.show_highlight)
    window.highlighter.changed.connect(window.controls.show_highlight)
