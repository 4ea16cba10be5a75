"""The words of a tool: ``--help`` shows what its module says, and a wrong word is one sentence."""

import argparse
from collections.abc import Callable, Collection
from typing import NoReturn


class ToolParser(argparse.ArgumentParser):
    def __init__(self, name: str, about: str | None) -> None:
        plain = argparse.RawDescriptionHelpFormatter
        super().__init__(f"python3 -m tests.{name}", description=about, formatter_class=plain)

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{self.prog}: {message}; --help tells more.\n")


def one_of(known: Collection[str], kind: str) -> Callable[[str], str]:
    """Return what reads a word that must be known, such as a scene's name."""

    def read(word: str) -> str:
        if word not in known:
            raise argparse.ArgumentTypeError(f"there is no {kind} {word!r}")
        return word

    return read
