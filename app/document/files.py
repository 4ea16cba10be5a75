"""Document files: read defensively, and written completely or not at all.

A document is a JSON file, or it travels in a PNG picture as an iTXt chunk.
"""

import contextlib
import os
import re
import secrets
import stat
import struct
import time
import zlib
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from app.document.codec import FORMAT, Path, parse, to_json
from app.document.document import MESH_ENDINGS, Document, is_mesh
from app.lecture.letters import LONGEST_FILE, Letters, lettering
from app.model.refusal import REFUSALS, Bound, Refusal
from app.strangers import decode, log_warning, open_regular

if TYPE_CHECKING:
    from app.document.camera_files import Views

LARGEST_DOCUMENT = 2**20  # most bytes of a document; one with a thousand unknown keys has 100 000
LARGEST_CAMERAS = 2**26
"""Most bytes read as cameras; a thousand images of COLMAP, with their points, may have that."""
MOST_NAMED = 12  # most views that a refusal names
LARGEST_PICTURE = 2**30  # most bytes read as a PNG picture
STALE_S = 60.0  # the age at which an unfinished file counts as left by a killed program

CLOUDS = frozenset({".xyz", ".pts", ".pcd", ".las", ".laz", ".e57"})


@contextlib.contextmanager
def blamed_on(path: Path, bound: Bound) -> Iterator[None]:
    """Add the file's name to what is raised, and turn operating-system errors into refusals."""
    file = os.fspath(path)
    if "\0" in file:
        raise Refusal.in_document(REFUSALS["bad-name"], file=file)
    try:
        yield
    except Refusal as error:
        error.file = file
        raise
    except OSError as error:
        if isinstance(error, FileNotFoundError) and bound == REFUSALS["files-unreadable"]:
            raise Refusal.in_document(REFUSALS["no-file"], file=file) from error
        raise Refusal.in_document(bound, error.strerror or error, file=file) from error
    except UnicodeEncodeError as error:  # half of a surrogate pair
        raise Refusal.in_document(REFUSALS["bad-name"], file=file) from error


# --------------------------------------------------------------------------- reading


def content_of(path: Path, largest: int) -> bytes:
    """Return what a regular file contains; a `Refusal` if that is more than `largest` bytes."""
    with open_regular(path) as file:
        content = file.read(largest + 1)
    if len(content) > largest:
        limit = f"{largest // 2**10} KiB" if largest < 2**20 else f"{largest // 2**20} MiB"
        raise Refusal.in_document(REFUSALS["files-too-large"], limit)
    return content


def read_letters(path: Path) -> Letters:
    """Read a file of one's own letters; a `Refusal` names it and the line."""
    with blamed_on(path, REFUSALS["files-unreadable"]):
        letters, note = decode(content_of(path, 4 * LONGEST_FILE))
        log_warning(path, note)
        try:
            lettering(letters)
        except Refusal as error:
            field = error.field.removeprefix("letters, ")
            raise Refusal.in_document(
                error.bound, *error.limits, field=field, value=error.value
            ) from error
        return letters


def read(
    path: Path, over: Document | None = None, choose: Callable[[list[str]], str] | None = None
) -> Document:
    """Read a document from its file, or from a PNG picture that carries one.

    The content, not the name, decides which of the two it is. A camera file of another program puts
    its camera in the place of that of `over`, or of the default document; ``FILE#VIEW`` is one of
    its views, by name or by number from 1, or else `choose` takes one of the names. Raises a
    `Refusal` if the file does not exist, cannot be read, or is not a valid document.
    """
    file, view = split_view(path)
    with blamed_on(file, REFUSALS["files-unreadable"]):
        content = _read_bytes(file)
        if view and (content.startswith(_PNG) or _has_mark(content)):
            raise Refusal.in_document(REFUSALS["no-views"], f"#{view}")
        folder = os.path.dirname(os.path.realpath(file))
        if content.startswith(_PNG):
            text = extract(content)
            if text is None:
                raise Refusal.in_document(REFUSALS["plain-picture"])
            # A picture names its mesh without folders: look beside the link, then beside the
            # picture.
            document = parse(text, os.path.dirname(os.path.abspath(file)))
            if os.path.exists(document.scene if is_mesh(document.scene) else document.mesh):
                return document
            return parse(text, folder)
        ending = os.path.splitext(file)[1].lower()
        try:
            if not _has_mark(content):
                document = over or Document()
                if cameras := _views(file, content):
                    projection = cameras[_chosen(cameras, view, choose)](document.projection)
                    return replace(document, projection=projection)
            if len(content) > LARGEST_DOCUMENT:
                limit = f"{LARGEST_DOCUMENT // 2**20} MiB"
                raise Refusal.in_document(REFUSALS["files-too-large"], limit)
            text, note = _decode(content)
            document = parse(text, folder)
            log_warning(path, note)
            return document
        except Refusal as error:
            known = REFUSALS["broken"], REFUSALS["empty"], REFUSALS["foreign"], REFUSALS["not-text"]
            if ending == ".json" or error.bound not in known:
                raise
            if ending == ".png":
                raise Refusal.in_document(REFUSALS["broken-picture"]) from error
            raise Refusal.in_document(REFUSALS["neither"], ", ".join(MESH_ENDINGS)) from error


def split_view(path: Path) -> tuple[str, str]:
    """Split ``FILE#VIEW``; the view is empty if there is none, or a file has the whole name."""
    name = os.fspath(path)
    file, mark, view = name.rpartition("#")
    has_view = mark and not os.path.lexists(name) and os.path.isfile(file)
    return (file, view) if has_view else (name, "")


def _has_mark(content: bytes) -> bool:
    """Whether a file may be a document, which says so."""
    return FORMAT.encode() in content or FORMAT.encode("utf-16-le") in content


def _views(path: str, content: bytes) -> "Views":
    """Return the views of a camera file by name; none if it is no such file."""
    from app.document import camera_files

    def beside(name: str) -> str:
        other = os.path.join(os.path.dirname(path), name)
        with blamed_on(other, REFUSALS["files-unreadable"]):
            return _decode(content_of(other, LARGEST_CAMERAS))[0] if os.path.isfile(other) else ""

    camera_files.refuse_others(path)
    return camera_files.views_of(path, _decode(content)[0], beside) or {}


def _decode(content: bytes) -> tuple[str, str]:
    """Return the text of a file, and the note on its encoding; refuse what is no text."""
    text, note = decode(content)
    if note and re.search("[\0-\x08]", text):
        raise Refusal.in_document(REFUSALS["not-text"])
    return text, note


def _chosen(views: "Views", view: str, choose: Callable[[list[str]], str] | None) -> str:
    """Return the name of the view that a name, a number or a person chooses, or the only one."""
    names = list(views)
    if not view and len(names) > 1 and choose is not None:
        return choose(names)
    if view in names or (not view and len(names) == 1):
        return view or names[0]
    if re.fullmatch("[0-9]{1,7}", view) and 1 <= int(view) <= len(names):
        return names[int(view) - 1]
    last = [re.split(r"[/\\]", name)[-1] for name in names]
    alike = [view in (each, os.path.splitext(each)[0]) for each in last]
    if sum(alike) == 1:
        return names[alike.index(True)]
    some = ", ".join(names[:MOST_NAMED]) + (", ..." if len(names) > MOST_NAMED else "")
    raise Refusal.in_document(REFUSALS["views"], len(names), some)


def holds_document(path: Path) -> bool:
    """Whether a file that was read can be saved to: no mesh, picture, camera file or device."""
    if is_mesh(os.fspath(path)) or not os.path.isfile(path):
        return False
    with open_regular(path) as file:
        content = file.read(LARGEST_DOCUMENT)
    return not content.startswith(_PNG) and _has_mark(content)


def _read_bytes(path: Path) -> bytes:
    if os.path.isdir(path):
        raise Refusal.in_document(REFUSALS["folder"])
    ending = os.path.splitext(path)[1].lower()
    if ending in CLOUDS and os.path.exists(path):
        raise Refusal.in_document(REFUSALS["cloud"], ending)
    with open_regular(path) as file:
        is_picture = file.read(len(_PNG)) == _PNG
    return content_of(path, LARGEST_PICTURE if is_picture else LARGEST_CAMERAS)


# --------------------------------------------------------------------------- PNG pictures

# Pillow writes the chunk (`app.drawings.figure_files`). It is read here: Pillow decodes all pixels
# to see what follows them, refuses compressed texts above 1 MB, and lets a damaged end pass.
_PNG = b"\x89PNG\r\n\x1a\n"


def extract(png: bytes, keyword: str = FORMAT) -> str | None:
    """Return the text of the document in a PNG picture, or of another keyword; None for none.

    Raises a `Refusal` if `png` is not a complete PNG picture, or the text in it is damaged.
    """
    try:
        begin = keyword.encode() + b"\0"
        texts = [_text(body, begin) for kind, body in chunks(png) if kind == b"iTXt"]
    except (ValueError, struct.error, zlib.error) as error:
        raise Refusal.in_document(REFUSALS["broken-picture"]) from error
    return next((text for text in texts if text is not None), None)


def chunks(png: bytes) -> Iterator[tuple[bytes, memoryview]]:
    """Yield kind and content of each chunk; `ValueError` or `struct.error` for a damaged one."""
    view, begin, kind = memoryview(png), len(_PNG), b""
    if not png.startswith(_PNG) or not png.startswith(b"IHDR", begin + 4):
        raise ValueError(png[:16])
    while kind != b"IEND":
        length, kind = struct.unpack_from(">I4s", png, begin)
        end = begin + 8 + length
        if struct.unpack_from(">I", png, end)[0] != zlib.crc32(view[begin + 4 : end]):
            raise ValueError(kind)
        yield kind, view[begin + 8 : end]
        begin = end + 4


def _text(body: memoryview, keyword: bytes) -> str | None:
    """Return the text of our iTXt chunk; another program may have compressed it."""
    content = bytes(body)
    if not content.startswith(keyword):
        return None
    content = content.removeprefix(keyword)
    _language, _translated, text = content[2:].split(b"\0", 2)
    if content[:1] == b"\1":
        unpacked = zlib.decompressobj()
        text = unpacked.decompress(text, LARGEST_DOCUMENT)
        if not unpacked.eof:
            raise ValueError(keyword)
    return text.decode()


# --------------------------------------------------------------------------- writing


def write(document: Document, path: Path) -> None:
    """Write a document to its file, as `write_bytes_atomically` does."""
    with blamed_on(path, REFUSALS["unwritable"]):
        folder = os.path.dirname(os.path.realpath(path))
    write_bytes_atomically(path, to_json(document, folder).encode())


def path_of(field: str, value: object) -> str:
    """Return the path that a script gives, or a `Refusal`."""
    if not isinstance(value, (str, os.PathLike)):
        raise Refusal(field, value, REFUSALS["a-path"])
    return os.fspath(value)


def write_bytes_atomically(path: Path, content: bytes, *, is_trial: bool = False) -> None:
    """Write a file completely or not at all, even if the power fails.

    The content goes to a new file in the same folder, which replaces the old one once it is safely
    on the disk. Links are followed, and the permissions of an old file are kept. Whoever writes
    there a minute later removes unfinished files of killed programs. A trial leaves the old file in
    its place: it only finds out whether another one could be written. Raises a `Refusal` if it
    cannot be written; an old file is unchanged.
    """
    finish = (lambda unfinished, _: os.unlink(unfinished)) if is_trial else os.replace
    with blamed_on(path, REFUSALS["unwritable"]):
        target = os.path.realpath(path)
        mode = _mode_to_keep(target)
        folder = os.path.dirname(target)
        _remove_unfinished(folder)
        unfinished = os.path.join(folder, f".frustum-lab-{secrets.token_hex(4)}.tmp")
        opener = partial(os.open, mode=0o666 if mode is None else 0o600)
        file = open(unfinished, "xb", opener=opener)  # noqa: SIM115 it is closed below
        try:
            with file:
                if mode is not None:
                    os.chmod(unfinished, stat.S_IMODE(mode))
                file.write(content)
                file.flush()
                os.fsync(file.fileno())
            finish(unfinished, target)  # Windows renames closed files only
        except BaseException:
            with contextlib.suppress(OSError):
                os.unlink(unfinished)
            raise
        _sync_folder(folder)


def _mode_to_keep(target: str) -> int | None:
    """Return the old file's mode; None if there is no old file."""
    try:
        mode = os.stat(target).st_mode
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(mode):
        raise Refusal.in_document(REFUSALS["folder"])
    if not stat.S_ISREG(mode):  # it would wait for a reader, or overwrite a disk
        raise Refusal.in_document(REFUSALS["not-regular"])
    if not os.access(target, os.W_OK):  # replacing it would bypass its owner's write protection
        raise Refusal.in_document(REFUSALS["write-protected"])
    return mode


_UNFINISHED = re.compile(r"\.frustum-lab-[0-9a-f]{8}\.tmp")


def _remove_unfinished(folder: str) -> None:
    """Remove files that killed programs left: our own files that nobody has written to lately."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in filter(lambda entry: _UNFINISHED.fullmatch(entry.name), entries):
            with contextlib.suppress(OSError):
                is_stale = time.time() - entry.stat().st_mtime > STALE_S
                if is_stale and entry.is_file(follow_symlinks=False):
                    os.unlink(entry.path)


def _sync_folder(folder: str) -> None:
    """Flush the new name to the disk as well, where the system allows it."""
    with contextlib.suppress(OSError):  # Windows opens no folder
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
