"""The monitors of an X server, set and unplugged as a program does that arranges screens.

Spoken in X's own protocol, of which five requests are enough: no system has a program for it
everywhere, and Qt knows monitors only.
"""

import socket
import struct
from pathlib import Path

_INTERN_ATOM, _GET_INPUT_FOCUS, _QUERY_EXTENSION = 16, 43, 98
_QUERY_VERSION, _GET_SCREEN_RESOURCES, _SET_MONITOR, _DELETE_MONITOR = 0, 8, 43, 44  # of RandR


class Monitors:
    """A connection to a server that asks for no authority.

    Parameters
    ----------
    display : str
        Such as ``":99"``.
    """

    def __init__(self, display: str) -> None:
        self._socket = socket.socket(socket.AF_UNIX)
        self._socket.connect(str(Path("/tmp/.X11-unix") / f"X{display.removeprefix(':')}"))
        self._socket.sendall(struct.pack("<cxHHHHxx", b"l", 11, 0, 0, 0))
        setup = self._read(4 * struct.unpack_from("<H", self._read(8), 6)[0])
        vendor, formats = struct.unpack_from("<H", setup, 16)[0], setup[21]
        (self._root,) = struct.unpack_from("<I", setup, 32 + (vendor + 3) // 4 * 4 + 8 * formats)
        self._randr = self._ask(_QUERY_EXTENSION, 0, struct.pack("<Hxx", 5) + b"RANDR")[9]
        self._ask(self._randr, _QUERY_VERSION, struct.pack("<II", 1, 5))
        found = self._ask(self._randr, _GET_SCREEN_RESOURCES, struct.pack("<I", self._root))
        (self._output,) = struct.unpack_from(
            "<I", found, 32 + 4 * struct.unpack_from("<H", found, 16)[0]
        )

    def set(self, name: str, x: int, width: int, height: int, *, real: bool) -> None:
        """Have a monitor of this name and place: the server's own output, or a made-up one."""
        info = (self._root, self._atom(name), real, 0, int(real), x, 0, width, height, 300, 200)
        outputs = struct.pack("<I", self._output) if real else b""
        self._send(self._randr, _SET_MONITOR, struct.pack("<IIBBHhhHHII", *info) + outputs)
        self._ask(_GET_INPUT_FOCUS, 0, b"")  # answered when that is done

    def unplug(self, name: str) -> None:
        """Have it no more."""
        place = struct.pack("<II", self._root, self._atom(name))
        self._send(self._randr, _DELETE_MONITOR, place)
        self._ask(_GET_INPUT_FOCUS, 0, b"")

    def close(self) -> None:
        """Leave the server."""
        self._socket.close()

    def _atom(self, name: str) -> int:
        found = self._ask(_INTERN_ATOM, 0, struct.pack("<Hxx", len(name)) + name.encode())
        return int(struct.unpack_from("<I", found, 8)[0])

    def _send(self, major: int, minor: int, body: bytes) -> None:
        body += bytes(-len(body) % 4)
        self._socket.sendall(struct.pack("<BBH", major, minor, 1 + len(body) // 4) + body)

    def _ask(self, major: int, minor: int, body: bytes) -> bytes:
        self._send(major, minor, body)
        while True:
            head = self._read(32)
            assert head[0] != 0, f"X refuses request {major} {minor} with error {head[1]}"
            if head[0] == 1:  # a reply, no event
                return head + self._read(4 * struct.unpack_from("<I", head, 4)[0])

    def _read(self, count: int) -> bytes:
        found = b""
        while len(found) < count:
            found += self._socket.recv(count - len(found))
        return found
