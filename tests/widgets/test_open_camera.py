"""A camera file of another program, opened in the window: its views to choose from, and undo."""

import json
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QListWidget

from app.document.document import Document
from app.document.files import read
from tests.support.window import MakeWindow, settle

OK, CANCEL = (QDialogButtonBox.StandardButton.Ok, QDialogButtonBox.StandardButton.Cancel)
BACK = [[1, 0, 0, 0.0], [0, 1, 0, 2.0], [0, 0, 1, 12.0], [0, 0, 0, 1]]


@pytest.mark.undrawn
def test_a_view_of_a_camera_file_is_chosen_over_the_current_scene(
    make_window: MakeWindow, tmp_path: Path
) -> None:
    frames = [
        {"file_path": f"train/r_{i}", "transform_matrix": BACK, "camera_angle_x": 0.5 + i / 10}
        for i in range(3)
    ]
    path = tmp_path / "transforms.json"
    path.write_text(json.dumps({"w": 800, "h": 600, "frames": frames}), encoding="utf-8")
    window = make_window(replace(Document(), scene="cube"))
    before, asked = window.store.document, list[list[str]]()

    def answer(row: int, button: QDialogButtonBox.StandardButton) -> None:
        dialog: Any = QApplication.activeModalWidget()
        views = dialog.findChild(QListWidget)
        asked.append([views.item(i).text() for i in range(views.count())])
        views.setCurrentRow(row)
        dialog.findChild(QDialogButtonBox).button(button).click()

    QTimer.singleShot(0, partial(answer, 1, CANCEL))
    assert not window.files.open(path)
    assert asked == [["train/r_0", "train/r_1", "train/r_2"]]
    assert window.store.document == before and window.messages.text == ""
    QTimer.singleShot(0, partial(answer, 1, OK))
    assert window.files.open(path)
    settle()
    document = window.store.document
    assert document.scene == "cube" and document.projection.image_size == (800, 600)
    assert document.projection == read(f"{path}#2", before).projection
    assert document.projection.camera.eye == (0.0, 2.0, 12.0)
    # It is no document to be saved to, and undo brings the former camera back.
    assert window.files.path is None and window.files.recent[0] == str(path)
    window.store.undo()
    assert window.store.document == before
    assert window.files.open(f"{path}#train/r_1") and len(asked) == 2
    assert window.store.document == document
    # One that is not possible changes nothing, and says why.
    path.write_text(json.dumps({"k1": 0.5, "frames": frames[:1]}), encoding="utf-8")
    assert not window.files.open(path) and window.store.document == document
    assert "transforms.json: k1 = '0.5': is a lens with distortion" in window.messages.text
