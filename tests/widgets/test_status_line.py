"""The status line: predictions when the hand rests, silence when all is well."""

import math
import re
from dataclasses import replace
from typing import Any

import pytest
from PySide6.QtCore import QLocale, QTimer
from pytestqt.qtbot import QtBot

from app import languages
from app.document.document import Document
from app.drawings.scene_place import predictions
from app.model.projection import Camera, Perspective, Projection
from app.precision.levels import predict
from app.precision.quality import Quality
from app.scenes.scene import Scene, load
from tests.support.bounds import drawing_bound_px
from tests.support.shown import show
from tests.support.window import MakeWindow
from widgets.parts.number_field import NumberDialog
from widgets.window import status_line
from widgets.window.status_line import StatusLine

EVERYDAY = Projection(Camera(), Perspective(45.0, 1.0, 30.0))


@pytest.fixture
def scene() -> Scene:
    return load("letter-f")


@pytest.fixture
def line(qtbot: QtBot) -> StatusLine:
    line = StatusLine()
    line.resize(1600, 24)
    qtbot.addWidget(line)
    line.show()
    qtbot.waitExposed(line)
    return line


def rested(qtbot: QtBot, line: StatusLine, projection: Projection, scene: Scene) -> None:
    """Show a projection and let the hand rest."""
    show(line, projection, scene)
    rest = line.findChild(QTimer)
    qtbot.waitUntil(lambda: not rest.isActive())


def test_precisions_are_predicted_when_the_input_stops(
    qtbot: QtBot, line: StatusLine, scene: Scene
) -> None:
    rested(qtbot, line, EVERYDAY, scene)
    found = predict(EVERYDAY, scene.apart[0].vertices, scene.origin)
    assert found is not None
    drawn = drawing_bound_px(EVERYDAY, scene.boxes.together, scene.origin)
    read = found["float64"].px
    shown = re.fullmatch(r"drawn float32 ±(\S+) px, read float64 ±(\S+) px", line.precision.text())
    assert shown is not None
    for bound, text in zip((drawn, read), shown.groups(), strict=True):
        assert bound <= float(text) <= 2.0 * bound  # one digit, rounded up
    assert line.health.text() == "" and line.health.toolTip() == ""
    line.precision.menu().aboutToShow.emit()
    texts = [action.text() for action in line.precision.menu().actions()]
    assert [text.split(":")[0] for text in texts[:3]] == ["float32", "float64", "exact"]
    assert texts[0].endswith("(drawn)") and texts[1].endswith("(read)")
    of_32 = re.search(r"up to (\S+) px, (\S+) in depth", texts[0])
    assert of_32 is not None
    for bound, text in zip(found["float32"], of_32.groups(), strict=True):
        assert bound <= float(text) <= 1.1 * bound  # two digits
    assert texts[-1] == "Drawing tolerance 0.01 px…"
    # Whatever computes it, a rasteriser is handed float32: 1280 px in 24 bits.
    line.show_quality(Quality(rung="float64"), [])
    rested(qtbot, line, replace(EVERYDAY, image_size=(1280, 720)), scene)
    assert line.precision.text().startswith("drawn float64 ±8e-05 px, read float64 ±")


def test_the_figure_of_a_risk_has_the_language_s_decimal_comma(
    qtbot: QtBot, line: StatusLine, scene: Scene
) -> None:
    languages.choose("hr")
    try:
        far_off = replace(EVERYDAY, lens=Perspective(45.0, 1.3e-5, math.inf))
        rested(qtbot, line, far_off, scene)
        assert re.search(r"\d,\d", line.health.toolTip())
        assert not re.search(r"\d\.\d", line.health.toolTip())
    finally:
        languages.choose(languages.ENGLISH)


def test_an_error_without_a_bound_is_reported_in_a_sentence(
    qtbot: QtBot, line: StatusLine, scene: Scene
) -> None:
    line.resize(3200, 24)
    beyond = replace(EVERYDAY, lens=Perspective(1e-80, 1.0, 30.0))
    line.show_quality(Quality(rung="float32"), [])
    rested(qtbot, line, beyond, scene)
    assert line.precision.text().startswith("drawn float32 ±∞ px, read ")
    line.precision.menu().aboutToShow.emit()
    texts = [action.text() for action in line.precision.menu().actions()]
    assert texts[0] == "float32: its error has no bound here  (drawn)"


def test_no_error_is_predicted_while_the_model_moves(
    qtbot: QtBot, line: StatusLine, scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[Projection] = []

    def counting(projection: Projection, *rest: Any) -> Any:
        calls.append(projection)
        return predictions(projection, *rest)

    monkeypatch.setattr(status_line, "predictions", counting)
    moved = [replace(EVERYDAY, lens=Perspective(45.0 + i, 1.0, 30.0)) for i in range(20)]
    for projection in moved:
        show(line, projection, scene)
    assert calls == []
    qtbot.waitUntil(lambda: calls != [])
    assert calls == moved[-1:]


def test_errors_are_predicted_when_the_hidden_line_appears(
    qtbot: QtBot, line: StatusLine, scene: Scene
) -> None:
    line.hide()
    rest = line.findChild(QTimer)
    rest.stop()
    line.precision.setText("")
    show(line, EVERYDAY, scene)
    assert not rest.isActive()
    line.show()
    qtbot.waitUntil(lambda: line.precision.text() != "")
    line.hide()  # as while presenting; the Precision panel is open
    line.precision.setText("")
    qtbot.addWidget(line.precision)
    line.precision.show()
    qtbot.waitUntil(lambda: line.precision.text() != "")
    was = line.precision.text()
    show(line, replace(EVERYDAY, lens=Perspective(1e-6, 1.0, 30.0)), scene)
    qtbot.waitUntil(lambda: line.precision.text() != was)


def test_near_is_dragged_to_the_letter_without_a_warning(
    qtbot: QtBot, line: StatusLine, scene: Scene
) -> None:
    """A corner of the ground lies beside the eye, where nobody sees it."""
    for near in (5.0, 9.0, 11.0):
        projection = replace(scene.start, lens=replace(scene.start.lens, near=near))  # type: ignore[call-arg]
        rested(qtbot, line, projection, scene)
        assert line.health.text() == "" and "read float64" in line.precision.text()


def test_a_risk_is_reported_and_withdrawn(qtbot: QtBot, line: StatusLine, scene: Scene) -> None:
    risky = replace(EVERYDAY, lens=Perspective(179.5, 1e-6, math.inf))
    rested(qtbot, line, risky, scene)
    assert line.health.text().startswith("At the target, a 24-bit depth buffer")
    assert "clamp the field of view to 179°" in line.health.toolTip()
    assert line.health.accessibleDescription() == line.health.toolTip().replace("\n", " ")
    line.resize(400, 24)
    qtbot.waitUntil(lambda: line.health.text().endswith("…"))
    rested(qtbot, line, EVERYDAY, scene)
    assert line.health.text() == "" and line.health.toolTip() == ""


def test_a_plane_is_named_as_inside_a_sentence(
    qtbot: QtBot, line: StatusLine, scene: Scene
) -> None:
    away = replace(EVERYDAY, lens=Perspective(45.0, 1e3, 1e4))
    rested(qtbot, line, away, scene)
    assert "all lie outside the near plane." in line.health.toolTip()


def test_numbers_of_a_narrow_slab_are_read_exactly(
    qtbot: QtBot, line: StatusLine, scene: Scene
) -> None:
    slab = replace(EVERYDAY, lens=Perspective(45.0, 9.0, 9.0 * (1 + 1e-9)))
    rested(qtbot, line, slab, scene)
    assert "read exact" in line.precision.text()
    assert "computed exactly" in line.health.toolTip()


def test_the_tolerance_decides_what_draws(qtbot: QtBot, line: StatusLine, scene: Scene) -> None:
    rested(qtbot, line, EVERYDAY, scene)
    assert line.precision.text().startswith("drawn float32")
    line.set_tolerance(1e-4)
    qtbot.waitUntil(lambda: line.precision.text().startswith("drawn float64"))


@pytest.mark.undrawn
def test_the_tolerance_is_kept_in_the_settings(make_window: MakeWindow) -> None:
    window = make_window(Document())
    window.status.tolerance_edited.emit(0.5)
    assert window.settings.tolerance_px == 0.5
    assert window.status.tolerance_px == 0.5


@pytest.mark.parametrize("language", ["C", "de_DE", "ar_EG"])
def test_a_number_is_asked_for_as_the_rows_read_it(
    line: StatusLine, language: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Qt's own question took 33.5 for 335 where the point stands between thousands."""
    texts = ["33.5", "33,5", "0,05", "1/4 px", "1e3", "", "1.000,5", "-1", "5e-5", "inf", "٣", "2"]
    wanted = [33.5, 33.5, 0.05, 0.25, "at most 100", *2 * ["a number"], *2 * ["at least 0.0001"],
              "at most 100", "a number", 0.01]  # fmt: skip
    found: list[Any] = []

    def answer(dialog: NumberDialog) -> int:
        assert dialog.field.text() == f"{line.tolerance_px:g}"
        dialog.field.setText(texts[len(found)])
        if len(found) == len(texts) - 1:
            dialog.reject()
            found.append(dialog.number)
        else:
            dialog.accept()
            found.append(dialog.problem.text() or dialog.number)
        return dialog.result()

    monkeypatch.setattr(NumberDialog, "exec", answer)
    taken: list[float] = []
    line.tolerance_edited.connect(taken.append)
    before = QLocale()
    QLocale.setDefault(QLocale(language))
    try:
        for _ in texts:
            line.precision.menu().aboutToShow.emit()
            line.precision.menu().actions()[-1].trigger()
    finally:
        QLocale.setDefault(before)
    for value, want in zip(found, wanted, strict=True):
        if isinstance(want, str):
            assert value.startswith("Not possible. Drawing tolerance = ") and want in value
        else:
            assert value == want
    assert taken == [want for want in wanted[:-1] if isinstance(want, float)]


def test_points_behind_the_camera_have_no_prediction(
    qtbot: QtBot, line: StatusLine, scene: Scene
) -> None:
    away = replace(EVERYDAY, camera=Camera((0.0, 2.0, 100.0), (0.0, 2.0, 200.0)))
    rested(qtbot, line, away, scene)
    assert line.precision.text() == "drawn float32, read float64"


def test_a_message_stands_alone(qtbot: QtBot, line: StatusLine, scene: Scene) -> None:
    """Qt hides the health meanwhile; what is shown then would be painted over it."""
    risky = replace(EVERYDAY, lens=Perspective(179.5, 1e-6, math.inf))
    line.showMessage("1/3 is taken as 0.333")
    rested(qtbot, line, risky, scene)
    assert line.health.text() and not line.health.isVisible()
    line.clearMessage()
    assert line.health.isVisible()
