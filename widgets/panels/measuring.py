"""One measurement at a time, in a separate process, so that the window does not wait.

::

    start(document, ...) --> python -m app measure --attended --json - ...
    set_paused           --> "pause", "resume" on its standard input
    cancel               --> "cancel"; the results until then still come
    progressed           <-- a fraction, a line each, on its standard error
    finished             <-- Measurements on its standard output, or why there are none
"""

import os
import tempfile
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

from PySide6.QtCore import QObject, QProcess, Signal

from app import modules
from app.document.codec import to_json
from app.document.document import Document, is_mesh
from app.document.files import write_bytes_atomically
from app.measure.results import from_json
from app.model.refusal import Refusal
from widgets.parts.messages import sentence

PAUSE, RESUME, CANCEL = b"pause\n", b"resume\n", b"cancel\n"
_KILLED_WITHIN_MS = 30_000  # longest wait for the process to end; usually it ends at once


class Measuring(QObject):
    """Runs the command `measure` on a document that need not be saved."""

    progressed = Signal(float)  # the fraction done
    finished = Signal(object, str)
    """`Measurements` or None, and a sentence on what could not be measured, if anything."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._process: QProcess | None = None
        self._file = ""  # holds the document while it is measured
        self._paused = False
        self._lines: list[str] = []  # the process's standard error, without the fractions
        self._rest = b""  # the beginning of an incomplete line

    @property
    def running(self) -> bool:
        """Whether a measurement is under way, paused or not."""
        return self._process is not None

    def start(
        self, document: Document, trades: Sequence[str], sweeps: Sequence[str], *, quick: bool
    ) -> None:
        """Measure trades and sweeps of a document; no other measurement may be running."""
        assert not self.running
        try:
            self._file = _written(document)
        except (Refusal, OSError) as error:
            self.finished.emit(None, sentence(error))
            return
        process = self._process = QProcess(self)
        process.readyReadStandardError.connect(self._read)
        process.errorOccurred.connect(self._failed)
        process.finished.connect(self._ended)
        self._lines, self._rest = [], b""
        options = [f"--trade={name}" for name in trades] + [f"--sweep={name}" for name in sweeps]
        if quick:
            options.append("--quick")
        options += ["--attended", "--json=-", self._file]
        program, *arguments = modules.command("app", "measure", *options)
        process.start(program, arguments)
        if self._paused:
            process.write(PAUSE)

    def set_paused(self, paused: bool) -> None:
        """Pause before the next timing, or resume."""
        if paused != self._paused:
            self._paused = paused
            self._send(PAUSE if paused else RESUME)

    def cancel(self) -> None:
        """Stop after the current timing; `finished` has the results until then."""
        self._send(CANCEL)

    def kill(self) -> None:
        """End the process at once; `finished` is not emitted."""
        process = self._process
        if process is None:
            return
        process.blockSignals(True)
        process.kill()
        process.waitForFinished(_KILLED_WITHIN_MS)
        self._clear()

    def _send(self, words: bytes) -> None:
        if self._process is not None:
            self._process.write(words)

    def _read(self) -> None:
        assert self._process is not None
        self._rest += bytes(self._process.readAllStandardError().data())
        *lines, self._rest = self._rest.split(b"\n")
        for line in (line.decode(errors="replace").strip() for line in lines):
            try:
                fraction = float(line)
            except ValueError:
                if line:
                    self._lines.append(line)
            else:
                self.progressed.emit(fraction)

    def _failed(self, error: QProcess.ProcessError) -> None:
        """Report a process that did not start; `_ended` reports all other ends."""
        if error == QProcess.ProcessError.FailedToStart and self._process is not None:
            text = self.tr("The measurement cannot be started: {0}.")
            said = text.format(self._process.errorString().rstrip("."))
            self._clear()
            self.finished.emit(None, said)

    def _ended(self, _code: int, _status: QProcess.ExitStatus) -> None:
        assert self._process is not None
        self._read()
        out = bytes(self._process.readAllStandardOutput().data())
        said = self._lines[-1] if self._lines else ""  # a traceback ends with the error
        said = said.removeprefix(f"{self._file}: ")  # a temporary name
        self._clear()
        try:
            results = from_json(out.decode(), self.tr("The measurement"))
        except (Refusal, UnicodeDecodeError):  # `said` has the reason, unless it was killed
            self.finished.emit(None, said or self.tr("The measurement ended unexpectedly."))
        else:
            self.finished.emit(results, said)

    def _clear(self) -> None:
        if self._process is not None:
            self._process.deleteLater()
            self._process = None
        with suppress(OSError):  # the system may have removed it
            os.unlink(self._file)


def _written(document: Document) -> str:
    """Write the document to a temporary file, with absolute paths of meshes."""

    def absolute(path: str) -> str:
        return os.path.abspath(path) if is_mesh(path) else path

    there = replace(document, scene=absolute(document.scene), mesh=absolute(document.mesh))
    descriptor, path = tempfile.mkstemp(".json", "frustum-lab-")
    os.close(descriptor)
    write_bytes_atomically(path, to_json(there).encode())
    return path
