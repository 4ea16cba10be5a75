"""The command ``measure``: select the measurements, report progress, write the results."""

import os
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

from app.commands import terminal
from app.commands.arguments import check_out, document_of, load_scene
from app.commands.options import Parser, parse_number
from app.commands.terminal import CliError
from app.document.files import write_bytes_atomically
from app.document.lengths import PX_PER, Size
from app.drawings import off_screen
from app.drawings.figure import Figure
from app.languages import said
from app.measure import chart, measuring
from app.measure.meaning import meaning
from app.measure.results import GAPS, Measurements, named, table, to_csv, to_json
from app.measure.sweeps import SWEEPS
from app.model.projection import LENSES
from app.model.refusal import Cancelled


def run(arguments: Sequence[str]) -> int:
    """Measure, print and write the results; return the exit status, or raise a `CliError`."""
    options, words = Parser("measure").read(arguments)
    swept = dict(_range(name, ends) for name, ends in options.sweep or ())
    if options.attended and sys.platform != "win32":
        os.nice(10)  # the program that started this one draws meanwhile and has priority
    asked = {f"--{option}": getattr(options, option) for option in ("json", "csv", "chart")}
    targets = {option: out for option, out in asked.items() if out is not None}
    if len(set(targets.values())) < len(targets):
        *first, last = targets
        options_of = said("{0} and {1}", ", ".join(first), last)
        raise CliError("{0} must go to different files.", options_of)
    if options.chart is not None and not options.chart.lower().endswith(chart.ENDINGS):
        known = said("{0} or {1}", ", ".join(chart.ENDINGS[:-1]), chart.ENDINGS[-1])
        raise CliError("--chart = {0!r}: must end in {1}.", options.chart, known)
    if options.size and options.width:
        raise CliError("--width: its height is free; leave out --size.")
    if not options.chart and (options.size or options.width or options.text_size is not None):
        raise CliError("--size, --width and --text-size: need --chart.")
    # Check now: the measurement takes long.
    for option, out in targets.items():
        if out != "-":
            check_out(option, out, words)
    terminal.standard_output()
    settings = [*options.set, *([f"scene={options.scene}"] if options.scene else [])]
    file = words[0] if words else None
    document = document_of(file, settings)
    scene = load_scene(document.scene, document.mesh, file)
    if options.size or options.width or options.text_size is not None:
        side = (options.width or 0.0) / PX_PER["mm"]
        size = Size(side, side, "mm") if side else options.size
        # A chart has the bounds of a pane: this is a `Refusal` beyond them.
        Figure(document, scene, ("ndc",), size, text_pt=options.text_size)
    if document.projection.lens.planes is None:
        raise CliError("free-matrix", ", ".join(LENSES))
    everything = not (options.trade or options.sweep)
    trades = list(dict.fromkeys(options.trade or (measuring.TRADES if everything else ())))
    if everything:
        swept = dict.fromkeys(SWEEPS, (None, None))
    opengl = True
    try:
        off_screen.check_off_screen()
    except RuntimeError as error:
        opengl = False
        left_out = [name for name in trades if name in measuring.NEED_OPENGL]
        if left_out:
            terminal.print_error(said("{0} Not measured: {1}.", error, ", ".join(left_out)), 0)
        trades = [name for name in trades if name not in left_out]
        if not trades and not swept:
            return terminal.CANNOT_DRAW
    with _watched(options.attended) as watch:
        results = measuring.measure_all(
            document, scene, trades, swept, quick=options.quick, opengl=opengl, watch=watch
        )
    texts = {
        options.json: to_json(results),
        options.csv: "\n".join([*map(to_csv, results.trades), *map(to_csv, results.sweeps)]),
    }
    try:
        terminal.write_out([texts["-"]] if "-" in texts else _measured(results, options.cost))
    finally:  # write the files even if the reader of the tables closes the pipe
        for out, text in texts.items():
            if out not in (None, "-"):
                write_bytes_atomically(out, text.encode())
        if options.chart is not None:
            from widgets.parts.chart_picture import Paper, picture

            paper = Paper(options.size, options.width, options.text_size, options.palette)
            drawn = picture(results.by_cost(options.cost), options.chart, paper=paper)
            write_bytes_atomically(options.chart, drawn)
    return 0 if results.complete else terminal.INTERRUPTED


def _range(name: str, ends: str) -> tuple[str, tuple[float | None, float | None]]:
    """Parse the ends of a sweep, ``1e-3:10``; without ends the sweep uses its own."""
    if not ends:
        return name, (None, None)
    try:
        low, high = (parse_number(end) for end in ends.split(":"))
    except ValueError:
        raise CliError("low-high", name, ends) from None
    whole = SWEEPS[name]
    if not whole.low <= low < high <= whole.high:
        raise CliError("high-and-low", name, ends, whole.low, whole.high)
    return name, (low, high)


@contextmanager
def _watched(attended: bool) -> Iterator[Callable[[float], None]]:
    """Report the progress of a measurement, and stop it on Ctrl-C or ``cancel``."""
    going = threading.Event()
    going.set()
    reported = -1.0

    def watch(fraction: float) -> None:
        nonlocal reported
        going.wait()
        if cancelled.is_set():
            raise Cancelled
        if abs(fraction - reported) >= 0.01 and sys.stderr is not None:
            reported = fraction
            if attended:
                print(f"{fraction:.3f}", file=sys.stderr, flush=True)
            elif sys.stderr.isatty():
                print(f"\r{100.0 * fraction:3.0f} % ", end="", file=sys.stderr, flush=True)

    def obey() -> None:
        for line in sys.stdin:
            if line.strip() == "pause":
                going.clear()
            elif line.strip() == "resume":
                going.set()
            else:
                break
        cancelled.set()  # also when the starting program has ended
        going.set()

    with terminal.interrupt() as cancelled:
        if attended:
            threading.Thread(target=obey, daemon=True).start()
        try:
            yield watch
        finally:
            if not attended and sys.stderr is not None and sys.stderr.isatty():
                print("\r      \r", end="", file=sys.stderr, flush=True)


def _measured(results: Measurements, cost: str) -> Iterator[str]:
    """Yield the results as tables, each trade with its meaning for this cost."""
    for trade in results.trades:
        yield f"{trade.name}{'' if trade.complete else said(' (cancelled)')}\n"
        yield from _lines_of(table(trade), str.ljust)
        yield f"{meaning(trade.by_cost(cost))}\n\n"
    for sweep in results.sweeps:
        is_gap = sweep.parameter in GAPS
        shown = said("smallest gap in world units") if is_gap else said("largest error in px")
        yield f"{sweep.parameter}, {shown}{'' if sweep.complete else said(' (cancelled)')}\n"
        yield from _lines_of(table(sweep), str.rjust)
        yield "\n"


def _lines_of(rows: list[list[str]], align_names: Callable[[str, int], str]) -> Iterator[str]:
    """Return a table's lines: aligned names, numbers flush right, notes at the end."""
    rows[0] = [*map(named, rows[0])]
    for row in rows[1:]:
        row[-1] = named(row[-1])
        row[0] = named(row[0]) if align_names == str.ljust else row[0]  # or it is a number
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for name, *cells, note in rows:
        numbers = [cell.rjust(width) for cell, width in zip(cells, widths[1:-1], strict=True)]
        yield f"  {'  '.join([align_names(name, widths[0]), *numbers, note]).rstrip()}\n"
