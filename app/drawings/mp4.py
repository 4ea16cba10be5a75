"""MP4 films, encoded by the program ``ffmpeg`` if this machine has it.

The frames go to it through a pipe, and the film comes from a folder of its own: `ffmpeg` never gets
the name of a file that a user has chosen.
"""

import os
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from subprocess import PIPE

from app.model.refusal import QT_TRANSLATE_NOOP, REFUSALS, Refusal
from app.strangers import printable

PROGRAM = "ffmpeg"
FAILED = QT_TRANSLATE_NOOP("Refusal", "cannot be written: {0} says “{1}”")

# Every player shows colours of half the resolution; better quality would not change those.
_COLOURS = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
_MARKS = ("-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709")
_QUALITY = ("-c:v", "libx264", "-crf", "18")


def program() -> str:
    """Return the path of ffmpeg; a `Refusal` if this machine has none."""
    path = shutil.which(PROGRAM)
    if path is None:
        raise Refusal.in_document(REFUSALS["no-program"], PROGRAM)
    return os.path.abspath(path)


def mp4(frames: Sequence[bytes], fps: float) -> bytes:
    """Return the film of frames that are PNG files; a `Refusal` if ffmpeg fails.

    When Python is interrupted, ffmpeg is ended, and its folder removed.
    """
    with tempfile.TemporaryDirectory(prefix="frustum-lab-") as folder:
        film = os.path.join(folder, "film.mp4")
        command = [
            program(), "-hide_banner", "-loglevel", "error", "-f", "image2pipe", "-c:v", "png",
            "-framerate", f"{fps:.6g}", "-i", "pipe:0", "-vf", _COLOURS, *_QUALITY, *_MARKS,
            "-movflags", "+faststart", "-bitexact", film,
        ]  # fmt: skip
        with subprocess.Popen(command, stdin=PIPE, stdout=PIPE, stderr=PIPE, cwd=folder) as process:
            try:
                _, wrong = process.communicate(b"".join(frames))
            except BaseException:
                process.kill()
                process.wait()  # or its folder could not be removed
                raise
        if not process.returncode:
            with open(film, "rb") as file:
                return file.read()
        said = wrong.decode("utf-8", "replace").strip().rpartition("\n")[2]
        why = said[:200] or f"status {process.returncode}"
        raise Refusal.in_document(FAILED, PROGRAM, printable(why.rstrip(".")))
