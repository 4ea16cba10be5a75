"""The command ``doctor``: what this machine has, what is missing, and how to install it.

Drivers are tried in processes of their own, because a broken driver ends the process.
"""

import json
import os
import platform
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from app import __version__, bootstrap, modules, system_packages
from app.commands.options import Parser
from app.commands.terminal import CANNOT_DRAW, CliError, write_out
from app.languages import said
from app.python_packages import requirements

LONGEST_TRIAL_S = 60.0  # longest time for a driver to answer


class Finding(NamedTuple):
    """One line of the report, and its remedy; empty if nothing is wrong."""

    name: str
    text: str
    remedy: str = ""


def run(arguments: Sequence[str]) -> int:
    """The command ``doctor``: print the findings, and at the end what is missing."""
    Parser("doctor").read(arguments)
    missing = []
    for finding in examine():
        write_out([f"{finding.name:<20}{finding.text}\n"])
        if finding.remedy:
            missing.append(finding)
    if not missing:
        write_out([f"\n{said('Everything needed is here.')}\n"])
        return 0
    lines = [f"  {finding.name}: {finding.remedy}\n" for finding in missing]
    write_out([f"\n{said('This is missing:')}\n", *lines])
    return CANNOT_DRAW


def examine() -> Iterator[Finding]:
    """Examine everything, the slow parts last, without downloading anything."""
    set_up = bootstrap.enter()
    yield Finding("Frustum Lab", said("{0} in {1}", __version__, bootstrap.ROOT))
    yield Finding("Python", f"{platform.python_version()} ({sys.executable})")
    yield Finding(said("Platform"), platform.platform())
    if aside := os.environ.get(modules.SET_ASIDE):
        text = said("{0}; Frustum Lab prefers its own packages", aside)
        yield Finding(said("Set aside"), text)
    if set_up:
        yield from _packages()
    else:
        start = bootstrap.command_line([Path(sys.executable).name, "-m", "app"])
        remedy = said("the first start sets it up, which needs the network: {0}", start)
        yield Finding(said("Environment"), said("not set up yet"), remedy)
    missing = [] if set_up else system_packages.venv_module()
    missing += system_packages.missing_system("window")
    text, remedy = said("all here"), ""
    if missing:
        text = said("missing: {0}", ", ".join(said(item.name) for item in missing))
        remedy = system_packages.advice(missing)
    yield Finding(said("System libraries"), text, remedy)
    if set_up:
        yield from _folders()
        yield from _display()
        yield _off_screen()
    # Nothing is missing without it: there are other formats of films.
    ffmpeg = shutil.which("ffmpeg")
    without = said("not without ffmpeg; .webp needs none")
    yield Finding("MP4", said("through {0}", ffmpeg) if ffmpeg else without)


def _packages() -> Iterator[Finding]:
    from importlib import metadata  # slow, and every command imports this file

    if os.path.exists(bootstrap.ROOT / "pyproject.toml"):
        yield Finding(said("Environment"), sys.prefix)
        for requirement in requirements(bootstrap.ROOT):
            bounds = requirement.text.partition(";")[0].removeprefix(requirement.name).strip()
            try:
                version = metadata.version(requirement.name)
            except metadata.PackageNotFoundError:
                version = said("missing")
            helps = "" if requirement.admits(version) else bootstrap.pip_install(requirement.text)
            yield Finding(requirement.name, said("{0} (needed: {1})", version, bounds), helps)
    try:
        from PySide6.QtCore import qVersion
    except ImportError as error:
        yield _not_loaded("Qt", error)
    else:
        yield Finding("Qt", qVersion())


def _not_loaded(name: str, error: ImportError) -> Finding:
    remedy = bootstrap.damage(error) or said("see the system libraries above")
    return Finding(name, said("cannot be loaded: {0}", error), remedy)


def _folders() -> Iterator[Finding]:
    try:
        from widgets.window.settings import data_folder, log_path, settings_path
    except ImportError:
        return  # `_display` says so
    for name, folder in (
        (said("Settings folder"), settings_path().parent),
        (said("Recovery folder"), data_folder()),
        (said("Log folder"), log_path().parent),
    ):
        there = next(filter(os.path.exists, (folder, *folder.parents)), folder)
        if os.path.isdir(there) and os.access(there, os.W_OK):
            yield Finding(name, str(folder))
        else:
            remedy = said("make {0} a folder that you may write to", there)
            yield Finding(name, said("{0}: not writable", folder), remedy)


def _display() -> Iterator[Finding]:
    try:
        import widgets.program.application  # noqa: F401 -- with all that a window needs
        from widgets.program.display import display
        from widgets.program.opengl import DisplayError
    except ImportError as error:
        yield _not_loaded(said("Window"), error)
        return
    try:
        with display():
            answer, problem = _try("widgets.program.opengl", dict(os.environ))
    except DisplayError as error:
        yield Finding(said("Display"), said("none"), str(error))
        return
    if answer is None:
        remedy = said("update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1")
        yield Finding("OpenGL", problem, remedy)
        return
    places = {"xcb": "DISPLAY", "wayland": "WAYLAND_DISPLAY"}
    place = os.environ.get(places.get(answer["platform"], ""), "")
    yield Finding(said("Display"), f"{answer['platform']} {place}".rstrip())
    for screen in answer["screens"]:
        yield Finding(said("Screen"), said("{0}: {1} x {2} at scale {3:g}", *screen))
    if "error" in answer:  # windows still open, drawn as pixels, if export works
        yield Finding("OpenGL", said("none for windows: {0}", answer["error"]))
    else:
        software = said("software, without a graphics card")
        how = software if answer["software"] else said("graphics card")
        yield Finding("OpenGL", f"{answer['version']}, {answer['renderer']} ({how})")
    how = said("drawn in the window by OpenGL")
    if answer["canvas"] == "raster":
        how = said("drawn off-screen and painted as pixels")
    yield Finding(said("Panes"), f"{how} (--canvas {answer['canvas']})")


def _off_screen() -> Finding:
    places = "DISPLAY", "WAYLAND_DISPLAY"
    environment = {name: value for name, value in os.environ.items() if name not in places}
    answer, problem = _try("app.commands.doctor", environment)
    if answer is None:
        is_lost = problem.startswith(ModuleNotFoundError.__name__)
        remedy = said("see Window") if is_lost else said("install-mesa")
        return Finding(said("Export"), problem, remedy)
    text = said("without a display through {0}, {1}", answer["window"], answer["renderer"])
    return Finding(said("Export"), text)


def _try(module: str, environment: dict[str, str]) -> tuple[dict[str, Any] | None, str]:
    """Run a trial that prints JSON as its last line; return None and the reason if it fails."""
    try:
        done = subprocess.run(
            modules.command(module), env=environment, capture_output=True, text=True,
            errors="replace", stdin=subprocess.DEVNULL, timeout=LONGEST_TRIAL_S, check=False,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return None, said("does not answer within {0:g} s", LONGEST_TRIAL_S)
    if done.returncode < 0:
        return None, said("the driver crashed (signal {0})", -done.returncode)
    lines = done.stdout.strip().splitlines()
    if done.returncode != 0 or not lines:
        lines = done.stderr.strip().splitlines() or [said("exit status {0}", done.returncode)]
        return None, lines[-1]
    answer: dict[str, Any] = json.loads(lines[-1])
    return answer, ""


def _draw_off_screen() -> None:
    """Draw a red square without a window, check its colour, and print what drew it."""
    from app.commands.arguments import check_drawing
    from app.drawings.actors import face_actor, identity_camera
    from app.drawings.off_screen import off_screen, pixels_of

    try:
        check_drawing()
    except CliError as error:
        raise SystemExit(str(error)) from None
    square = [(x, y, 0.0) for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))]
    with off_screen(40, 30) as screen:
        screen.renderer.AddViewProp(face_actor(square, [range(4)], "#ff0000"))
        screen.renderer.SetActiveCamera(identity_camera())
        screen.render_window.Render()
        if pixels_of(screen.render_window)[15, 20, :3].tolist() != [255, 0, 0]:
            raise SystemExit("The picture is wrong: update the graphics driver.")
        window = screen.render_window
        details = window.ReportCapabilities().splitlines()
        renderer = [line.partition(":")[2].strip() for line in details if "renderer string" in line]
        name = window.GetClassName().removeprefix("vtk").removesuffix("RenderWindow")
    print(json.dumps({"window": name, "renderer": renderer[0] if renderer else "unknown"}))


if __name__ == "__main__":
    _draw_off_screen()
