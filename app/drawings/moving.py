"""Films: GIF, APNG, WebP and MP4 of frames that are encoded one by one.

Pillow encodes the frames. Its own writers of animations join frames that are equal, and keep all
pixels in memory; here a file has exactly the frames that it is given. MP4 is encoded by the program
``ffmpeg`` if this machine has it: the frames go to it through a pipe, and the film comes from a
folder of its own, so that it never gets the name of a file that a user has chosen.
"""

import io
import os
import shutil
import struct
import subprocess
import tempfile
import zlib
from collections.abc import Sequence
from subprocess import PIPE

import numpy as np
from PIL import GifImagePlugin, Image

from app.document.codec import picture_json
from app.document.files import chunks
from app.drawings.figure import Figure
from app.drawings.figure_files import png_bytes
from app.drawings.off_screen import Pixels
from app.model.refusal import REFUSALS, Refusal
from app.strangers import printable

WEBP_PX = 16383  # largest side of a WebP picture
_GIF_COLOURS = 256
PROGRAM = "ffmpeg"

# Every player shows colours of half the resolution; better quality would not change those.
_COLOURS = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
_MARKS = ("-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709")
_QUALITY = ("-c:v", "libx264", "-crf", "18")


def encoded(figure: Figure, ending: str) -> bytes:
    """Draw a frame as `moving` takes it; as APNG it carries its document, as a figure does."""
    pixels = figure.pixels()
    if ending in (".apng", ".mp4"):
        json = picture_json(figure.document) if ending == ".apng" else None
        return png_bytes(pixels, json, figure.scale)
    if ending == ".gif":
        return b"".join(GifImagePlugin.getdata(_indexed(pixels), include_color_table=True))
    buffer = io.BytesIO()
    Image.fromarray(pixels).save(buffer, "WEBP", lossless=True, exact=True)
    return buffer.getvalue()[12:]  # without the head of a file


def moving(
    frames: Sequence[bytes], ending: str, size: tuple[int, int], fps: float, once: bool
) -> bytes:
    """Return the file of `encoded` frames of a size in pixels; it repeats unless `once`.

    MP4 cannot say whether it repeats.
    """
    if ending == ".mp4":
        return _mp4(frames, fps)
    if ending == ".apng":
        return _apng(frames, size, fps, once)
    return (_gif if ending == ".gif" else _webp)(frames, size, fps, once)


def _indexed(pixels: Pixels) -> Image.Image:
    """The picture with 256 colours of its own: the same pixels if it has no more."""
    image = Image.fromarray(pixels)
    if image.getcolors(_GIF_COLOURS) is None:
        return image.quantize(_GIF_COLOURS, kmeans=1, dither=Image.Dither.NONE)
    colours, index = np.unique(pixels.reshape(-1, 3), axis=0, return_inverse=True)
    picture = Image.fromarray(index.reshape(pixels.shape[:2]).astype(np.uint8), "P")
    picture.putpalette(colours.tobytes())
    return picture


def _gif(frames: Sequence[bytes], size: tuple[int, int], fps: float, once: bool) -> bytes:
    repeat = b"" if once else b"!\xff\x0bNETSCAPE2.0\x03\x01\0\0\0"
    before = b"!\xf9\x04\0" + struct.pack("<H", round(100.0 / fps)) + b"\0\0"
    head = b"GIF89a" + struct.pack("<HH", *size) + b"\x70\0\0" + repeat
    return head + b"".join(before + frame for frame in frames) + b";"


def _apng(frames: Sequence[bytes], size: tuple[int, int], fps: float, once: bool) -> bytes:
    def chunk(kind: bytes, body: bytes) -> bytes:
        return (
            struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        )

    head = [(kind, bytes(body)) for kind, body in chunks(frames[0])]
    parts, number = [frames[0][:8]], 0
    parts += [chunk(*each) for each in head if each[0] not in (b"IDAT", b"IEND")]
    parts.insert(2, chunk(b"acTL", struct.pack(">II", len(frames), int(once))))
    for first, frame in enumerate(frames):
        wait = struct.pack(">HHBB", round(1000.0 / fps), 1000, 0, 0)
        parts.append(chunk(b"fcTL", struct.pack(">5I", number, *size, 0, 0) + wait))
        number += 1
        for kind, body in chunks(frame):
            if kind == b"IDAT" and not first:
                parts.append(chunk(kind, bytes(body)))
            elif kind == b"IDAT":
                parts.append(chunk(b"fdAT", struct.pack(">I", number) + bytes(body)))
                number += 1
    return b"".join([*parts, chunk(b"IEND", b"")])


def _webp(frames: Sequence[bytes], size: tuple[int, int], fps: float, once: bool) -> bytes:
    def chunk(kind: bytes, body: bytes) -> bytes:
        return kind + struct.pack("<I", len(body)) + body + b"\0" * (len(body) % 2)

    def three(*values: int) -> bytes:
        return b"".join(struct.pack("<I", value)[:3] for value in values)

    sides = three(size[0] - 1, size[1] - 1)
    # Flags: animated, perhaps with alpha; a frame replaces what was there.
    parts = [
        chunk(b"VP8X", b"\x12\0\0\0" + sides),
        chunk(b"ANIM", struct.pack("<IH", 0, int(once))),
    ]
    about = three(0, 0) + sides + three(round(1000.0 / fps)) + b"\x02"
    parts += [chunk(b"ANMF", about + frame) for frame in frames]
    return chunk(b"RIFF", b"WEBP" + b"".join(parts))


def program() -> str:
    """Return the path of ffmpeg; a `Refusal` if this machine has none."""
    path = shutil.which(PROGRAM)
    if path is None:
        raise Refusal.in_document(REFUSALS["no-program"], PROGRAM)
    return os.path.abspath(path)


def _mp4(frames: Sequence[bytes], fps: float) -> bytes:
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
        raise Refusal.in_document(REFUSALS["failed"], PROGRAM, printable(why.rstrip(".")))
