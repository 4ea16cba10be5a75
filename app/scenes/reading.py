"""Read a mesh file without risk to the window: a large one in a separate process.

The process can be stopped at once and has a memory limit; neither its crash nor exhausted memory
affects the window. It is a fresh Python with the modules of this one, which imports nothing but
numpy. It writes lines of JSON to its standard output (the progress, or a refusal) and then the
bytes of the mesh's arrays.
"""

import json
import os
import subprocess
import sys
import threading
import time
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import Any, BinaryIO

import numpy as np

from app import modules
from app.model.refusal import REFUSALS, Refusal
from app.scenes import mesh_files as meshes
from app.scenes.finishing import DIVIDING, Finished, finished
from app.scenes.mesh import Progress, open_mesh, report

SMALL = 2**20  # most bytes of a file read in this process in the 0.1 s that one takes to start
SMALL_MESH = 100_000, 32 * 2**20
"""Most triangles and bytes of such a file's mesh: a short glTF file can expand greatly."""
SMALL_POLYGONS = 500
"""Most corners of such a mesh in faces of more than four: the worst take 0.05 s to be divided."""
DIVIDING_S = 120
"""Longest time between two reports while faces are divided: it grows with the square of a face's
corners, or faster."""
MEMORY = 6 * 2**30  # the process's memory limit: `app.scenes.mesh.LARGEST` and the file's text
_POLL_S = 0.05


def read(path: Path, progress: Progress | None = None) -> Finished:
    """Read a mesh file, ready to be drawn; see `app.scenes.mesh_files.read`.

    For a large file `progress` is called at least 20 times a second.
    """
    with open_mesh(path) as file:
        size = os.fstat(file.fileno()).st_size
    if size <= SMALL:
        try:
            mesh = meshes.read(path, progress, SMALL_MESH)
            counts = np.diff(mesh.offsets)
            if counts[counts > 4].sum() <= SMALL_POLYGONS:
                return finished(path, mesh, progress)
        except Refusal as error:
            if error.bound != REFUSALS["too-much"]:  # it may still be small enough for the process
                raise
    return _read_apart(path, progress)


def _read_apart(path: Path, progress: Progress | None) -> Finished:
    child = subprocess.Popen(
        modules.command("app.scenes.reading", os.fspath(path)),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env=os.environ | {"OPENBLAS_NUM_THREADS": "1"},
        creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
    )
    assert child.stdout is not None
    answers: SimpleQueue[Any] = SimpleQueue()
    # Not every system can wait for a pipe together with the window's events.
    listener = threading.Thread(target=_queue_answers, args=(child.stdout, answers), daemon=True)
    listener.start()
    done, heard = 0.0, time.monotonic()
    try:
        while True:
            report(progress, done)
            try:
                answer = answers.get(timeout=_POLL_S)
            except Empty:
                if done >= DIVIDING and time.monotonic() - heard > DIVIDING_S:
                    raise Refusal.saying(REFUSALS["too-long"], path, DIVIDING_S) from None
                continue
            if isinstance(answer, Finished):
                return answer
            if answer is None:
                raise Refusal.saying(REFUSALS["ended"], path)
            if "refused" in answer:
                template, *parts = answer["refused"]
                raise Refusal.saying(template, path, *parts[1:])
            done, heard = answer["done"], time.monotonic()
    finally:
        child.kill()
        child.wait()
        listener.join()
        child.stdout.close()


def _queue_answers(pipe: BinaryIO, answers: SimpleQueue[Any]) -> None:
    """Queue the answers of the process; None when it has ended."""
    try:
        while line := pipe.readline():
            answer = json.loads(line)
            if "mesh" in answer:
                arrays = [_received(pipe, *array) for array in answer["mesh"]]
                notes = [tuple(note) for note in answer["notes"]]
                answer = Finished._make([*arrays, notes])
            answers.put(answer)
    except (EOFError, MemoryError, ValueError):  # the process ended within an answer
        pass
    finally:
        answers.put(None)


def _received(pipe: BinaryIO, kind: str, shape: list[int]) -> Any:
    values = np.empty(shape, dtype=kind)
    octets = values.reshape(-1).view(np.uint8)
    if pipe.readinto(octets) != octets.size:  # type: ignore[attr-defined]
        raise EOFError
    return values


# --------------------------------------------------------------------------- in the other process


def main(path: Path) -> None:
    """Read a mesh and write it, or the refusal, to standard output for `read`."""
    _limit_memory()
    out = sys.stdout.buffer

    def send(answer: dict[str, Any]) -> None:
        out.write(json.dumps(answer).encode() + b"\n")
        out.flush()

    sent = -1.0

    def progress(fraction: float) -> bool:
        nonlocal sent
        fraction = round(fraction, 4)  # not an answer for each of a million faces
        if fraction != sent:
            sent = fraction
            send({"done": fraction})
        return True

    try:
        *parts, notes = finished(path, meshes.read(path, progress), progress)
        arrays = [np.ascontiguousarray(part) for part in parts]
        send({"mesh": [[each.dtype.str, each.shape] for each in arrays], "notes": notes})
        for array in arrays:
            out.write(array.ravel().view(np.uint8).data)
        out.flush()
    except Refusal as error:
        parts = [part if isinstance(part, int) else str(part) for part in error.limits]
        send({"refused": [error.bound, *parts]})


def _limit_memory() -> None:
    """Limit the memory of this process to `MEMORY`, where the system can."""
    if sys.platform == "win32":
        return  # Windows has no such limit without a job object; `mesh.LARGEST` still applies
    import resource

    if sys.platform == "linux":
        _, hard = resource.getrlimit(resource.RLIMIT_AS)
        limit = MEMORY if hard == resource.RLIM_INFINITY else min(MEMORY, hard)
        resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
        return

    def watch() -> None:  # macOS does not enforce the limit
        while resource.getrusage(resource.RUSAGE_SELF).ru_maxrss < MEMORY:
            time.sleep(_POLL_S)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
