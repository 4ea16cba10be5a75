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
        write_out(["\nEverything needed is here.\n"])
        return 0
    lines = [f"  {finding.name}: {finding.remedy}\n" for finding in missing]
    write_out(["\nThis is missing:\n", *lines])
    return CANNOT_DRAW


def examine() -> Iterator[Finding]:
    """Examine everything, the slow parts last, without downloading anything."""
    set_up = bootstrap.enter()
    yield Finding("Frustum Lab", f"{__version__} in {bootstrap.ROOT}")
    yield Finding("Python", f"{platform.python_version()} ({sys.executable})")
    yield Finding("Platform", platform.platform())
    if aside := os.environ.get(modules.SET_ASIDE):
        yield Finding("Set aside", f"{aside}; Frustum Lab prefers its own packages")
    if set_up:
        yield from _packages()
    else:
        start = bootstrap.command_line([Path(sys.executable).name, "-m", "app"])
        remedy = f"the first start sets it up, which needs the network: {start}"
        yield Finding("Environment", "not set up yet", remedy)
    missing = [] if set_up else system_packages.venv_module()
    missing += system_packages.missing_system("window")
    if missing:
        names = ", ".join(item.name for item in missing)
        yield Finding("System libraries", f"missing: {names}", system_packages.advice(missing))
    else:
        yield Finding("System libraries", "all here")
    if set_up:
        yield from _folders()
        yield from _display()
        yield _off_screen()
    # Nothing is missing without it: there are other formats of moving pictures.
    ffmpeg = shutil.which("ffmpeg")
    yield Finding("MP4", f"through {ffmpeg}" if ffmpeg else "not without ffmpeg; .webp needs none")


def _packages() -> Iterator[Finding]:
    from importlib import metadata  # slow, and every command imports this file

    if os.path.exists(bootstrap.ROOT / "pyproject.toml"):
        yield Finding("Environment", sys.prefix)
        for requirement in requirements(bootstrap.ROOT):
            bounds = requirement.text.partition(";")[0].removeprefix(requirement.name).strip()
            try:
                version = metadata.version(requirement.name)
            except metadata.PackageNotFoundError:
                version = "missing"
            helps = "" if requirement.admits(version) else bootstrap.pip_install(requirement.text)
            yield Finding(requirement.name, f"{version} (needed: {bounds})", helps)
    try:
        from PySide6.QtCore import qVersion
    except ImportError as error:
        yield _not_loaded("Qt", error)
    else:
        yield Finding("Qt", qVersion())


def _not_loaded(name: str, error: ImportError) -> Finding:
    remedy = bootstrap.damage(error) or "see the system libraries above"
    return Finding(name, f"cannot be loaded: {error}", remedy)


def _folders() -> Iterator[Finding]:
    try:
        from widgets.window.settings import data_folder, log_path, settings_path
    except ImportError:
        return  # `_display` says so
    for name, folder in (
        ("Settings folder", settings_path().parent),
        ("Recovery folder", data_folder()),
        ("Log folder", log_path().parent),
    ):
        there = folder
        while not os.path.exists(there) and there != there.parent:
            there = there.parent
        if os.path.isdir(there) and os.access(there, os.W_OK):
            yield Finding(name, str(folder))
        else:
            remedy = f"make {there} a folder that you may write to"
            yield Finding(name, f"{folder}: not writable", remedy)


def _display() -> Iterator[Finding]:
    try:
        import widgets.program.application  # noqa: F401 -- with all that a window needs
        from widgets.program.display import display
        from widgets.program.opengl import DisplayError
    except ImportError as error:
        yield _not_loaded("Window", error)
        return
    try:
        with display():
            answer, problem = _try("widgets.program.opengl", dict(os.environ))
    except DisplayError as error:
        yield Finding("Display", "none", str(error))
        return
    if answer is None:
        remedy = "update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1"
        yield Finding("OpenGL", problem, remedy)
        return
    places = {"xcb": "DISPLAY", "wayland": "WAYLAND_DISPLAY"}
    place = os.environ.get(places.get(answer["platform"], ""), "")
    yield Finding("Display", f"{answer['platform']} {place}".rstrip())
    for name, width, height, scale in answer["screens"]:
        yield Finding("Screen", f"{name}: {width} x {height} at scale {scale:g}")
    if "error" in answer:  # windows still open, drawn as pixels, if export works
        yield Finding("OpenGL", f"none for windows: {answer['error']}")
    else:
        how = "software, without a graphics card" if answer["software"] else "graphics card"
        yield Finding("OpenGL", f"{answer['version']}, {answer['renderer']} ({how})")
    how = "drawn in the window by OpenGL"
    if answer["canvas"] == "raster":
        how = "drawn off-screen and painted as pixels"
    yield Finding("Panes", f"{how} (--canvas {answer['canvas']})")


def _off_screen() -> Finding:
    environment = dict(os.environ)
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        environment.pop(name, None)
    answer, problem = _try("app.commands.doctor", environment)
    if answer is None:
        remedy = "install Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri), or update the driver"
        if problem.startswith(ModuleNotFoundError.__name__):
            remedy = "see Window"
        return Finding("Export", problem, remedy)
    return Finding("Export", f"without a display through {answer['window']}, {answer['renderer']}")


def _try(module: str, environment: dict[str, str]) -> tuple[dict[str, Any] | None, str]:
    """Run a trial that prints JSON as its last line; return None and the reason if it fails."""
    try:
        done = subprocess.run(
            modules.command(module), env=environment, capture_output=True, text=True,
            errors="replace", stdin=subprocess.DEVNULL, timeout=LONGEST_TRIAL_S, check=False,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return None, f"does not answer within {LONGEST_TRIAL_S:g} s"
    if done.returncode < 0:
        return None, f"the driver crashed (signal {-done.returncode})"
    lines = done.stdout.strip().splitlines()
    if done.returncode != 0 or not lines:
        said = done.stderr.strip().splitlines()
        return None, said[-1] if said else f"failed with exit status {done.returncode}"
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
