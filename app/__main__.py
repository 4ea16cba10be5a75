"""``python3 -m app`` and ``frustum-lab``: first the set-up, then the command line."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

if not __package__ and not hasattr(sys, "frozen"):  # started by the path of its folder
    sys.path[0] = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))

TYPE_CHECKING = False  # as in `typing`, which is not imported here: Ctrl-C could interrupt that
if TYPE_CHECKING:
    from app import system_packages

#: What each command needs of the machine; all others open the window.
NEEDS: dict[str, system_packages.Need] = {
    "project": "numbers",
    "matrices": "numbers",
    "export": "picture",
    "measure": "picture",
    "bundle": "numbers",
}
HELP = frozenset({"-h", "--help", "--version"})


def need_of(arguments: Sequence[str]) -> system_packages.Need:
    """What the command line needs of the machine."""
    return next((NEEDS.get(word, "window") for word in arguments if word[:1] != "-"), "window")


def command_first(arguments: list[str]) -> list[str]:
    """Put what follows ``--language hr`` before it: options stand behind their command."""
    ahead = 2 if arguments[:1] == ["--language"] else 0
    ahead = 1 if "".join(arguments[:1]).startswith("--language=") else ahead
    word = "".join(arguments[ahead : ahead + 1])
    if not ahead or word[:1] in ("", "-"):
        return arguments
    return [word, *arguments[:ahead], *arguments[ahead + 1 :]]


def main() -> int:
    """Set up, run the command line, return its exit status."""
    try:  # from the first import on: Ctrl-C is no error
        from app import modules

        if modules.prefer_own():
            from app import bootstrap

            bootstrap.again(sys.executable)
        arguments = command_first(sys.argv[1:])
        if modules.FROZEN and arguments[:1] == ["-m"]:  # a process of `modules.command`
            import runpy

            del sys.argv[:2]
            runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)
            return 0
        end = arguments.index("--") if "--" in arguments else None  # files may have such names
        if not HELP.isdisjoint(arguments[:end]):
            _check(arguments)  # which prints it
            return 0
        if arguments[:1] == ["doctor"]:
            from app.commands import doctor, options, terminal

            options.choose_language(arguments)
            return terminal.outcome(lambda: doctor.run(arguments[1:]))
        from app import bootstrap

        bootstrap.start(need_of(arguments), before=lambda: _check(arguments))
        try:
            from app.commands.cli import main as run  # only now are its imports sure to be there
        except ImportError as error:
            from app.commands.options import choose_language

            choose_language(arguments)
            if sentence := bootstrap.damage(error):
                bootstrap.fail(sentence)
            raise
    except KeyboardInterrupt:
        return 130
    return run(arguments)


def _check(arguments: Sequence[str]) -> None:
    """Refuse misspelt words and options, or print the help: the set-up takes minutes."""
    from app.commands import options, terminal

    if status := terminal.outcome(lambda: options.check(arguments)):
        raise SystemExit(status)


if __name__ == "__main__":
    sys.exit(main())
