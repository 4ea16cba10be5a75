"""One sentence that states the result of a trade."""

from functools import partial

from app.languages import with_comma
from app.measure.results import COLUMNS, STEADY, ChartPoint, Trade, named, of_measure, plain
from app.model.refusal import MEASURE, SENTENCES

_plain = partial(plain, digits=2)
GOOD_ENOUGH = {  # an invisible error in the trade's unit: a hundredth of a pixel, half a texel, ...
    "arithmetic": 0.01,
    "interpolation": 0.5,
    "smoothing": 5.0,
    "detail": 1.0,
    "drift": 0.01,
    "jitter": 0.01,
    "vertex-depth": 0.01,
    "cracks": 0.01,
    "unprojection": 1e-3,
}

USUAL = {  # the choice that the others are compared with
    "arithmetic": "float32",
    "interpolation": "perspective-correct",
    "depth": "fixed24, opengl",
    "smoothing": "none",
    "detail": "100 %",
    "drift": "float32, two sines",
    "jitter": "float32, world coordinates",
    "vertex-depth": "each pixel",
    "cracks": "16 bits, own boxes",
    "unprojection": "float32, inverse of P V",
}
GIVEN_UP = SENTENCES["Measure/given up"]
SHOWN = {
    "arithmetic": {"scene": "cheap-arithmetic", "settings.preset": "bits8"},
    "interpolation": {"scene": "interpolation", "settings.interpolation": "affine"},
    "depth": {"scene": "depth-buffer"},
    "smoothing": {"smoothing": "half resolution"},
    "detail": {
        "scene": "far-plane-popping", "settings.detail": "true",
        "settings.detail_1": "0", "settings.detail_2": "0.001",
    },
}  # fmt: skip
"""How a trade is shown, in the form of `ChartPoint.use`; without a scene, every scene shows it. If
it is missing, the scene of the trade's own name does."""
ANY_SCENE = "letter-f"  # the scene of a trade that every scene shows
_BARGAINS = {
    ("time", True): MEASURE["bargains-time-true"],
    ("time", False): MEASURE["bargains-time-false"],
    ("bytes", True): MEASURE["bargains-bytes-true"],
    ("bytes", False): MEASURE["bargains-bytes-false"],
}


def meaning(trade: Trade) -> str:
    """State what a trade's measurements mean for a choice."""
    parts = [_template_and_values(trade)]
    if trade.frontier and trade.name != "depth":
        cheapest_one = trade.frontier[0]
        if len(trade.frontier) == 1:
            parts += _costs_elsewhere(trade, cheapest_one)
        if equal := trade.as_cheap(cheapest_one):
            others = "; ".join(
                named(each.name)
                + (f" ({_plain(each.bytes)} B)" if each.bytes != cheapest_one.bytes else "")
                for each in equal
            )
            equal_in = MEASURE["equal-bytes"] if trade.cost_unit == "B" else MEASURE["equal-time"]
            parts.append((equal_in, (cheapest_one.name, others)))
        parts += [(MEASURE["doubtful"], (doubt,)) for doubt in trade.doubts]
    said = " ".join(
        of_measure(template).format(*(named(value) for value in values))
        for template, values in parts
    )
    return with_comma(said)


def _costs_elsewhere(trade: Trade, best: ChartPoint) -> list[tuple[str, tuple[str, ...]]]:
    """Name the further columns in which another choice is better than the best of the trade."""
    prices = []
    for column in trade.columns:
        if column in best.values and "predicted" not in column:
            other = min(
                (each for each in trade.choices if column in each.values),
                key=lambda each: each.values[column],
            )
            values = (best.values[column], other.values[column])
            if values[0] > values[1]:
                texts = (COLUMNS.get(column, column), *map(_plain, values), other.name)
                prices.append((MEASURE["costs-elsewhere"], texts))
    return prices


def _template_and_values(trade: Trade) -> tuple[str, tuple[str, ...]]:
    frontier = trade.frontier
    if not frontier:
        notes = [choice.note for choice in trade.choices if choice.note]
        return MEASURE["meaning-nothing"], (notes[0] if notes else "-",)
    first, last = frontier[0], frontier[-1]
    if trade.name == "depth":
        parts = [choice.name.partition(", ") for choice in (first, last)]
        (cheap, _, cheap_mapping), (fine, _, fine_mapping) = parts
        values = (cheap, _plain(first.error), cheap_mapping, fine, fine_mapping, _plain(last.error))
        return MEASURE["depth"], values
    error = f" {named(trade.error_unit)}"
    low, high = ((c.name, _price(trade, c), _plain(c.error) + error) for c in (first, last))
    if first is last:
        return MEASURE["fastest-is-best"], low
    limit = GOOD_ENOUGH[trade.name]
    good = cheapest(trade, limit)
    ends = (*low, *high, f"{limit:g}{error}")
    return (MEASURE["trade-off"], (*ends, good.name)) if good else (MEASURE["none-good"], ends)


def shown_by(name: str) -> dict[str, str]:
    """Return the scene that shows a trade, and how, in the form of `ChartPoint.use`."""
    return SHOWN.get(name, {"scene": name})


def boldest(trade: Trade) -> tuple[str, ChartPoint] | None:
    """Return the cost, time before bytes, and the choice that saves most against the usual one.

    Of choices that cost the same it is the smallest, then the least exact. If none saves anything,
    it is the cheapest that is more exact.
    """
    offers, usual = [], USUAL[trade.name]
    for cost in ("time", "bytes"):
        part = trade.by_cost(cost)
        for best in part.frontier:
            others = [c for c in part.as_cheap(best) if c.name != usual]
            choice = min((best, *others), key=lambda c: (c.bytes or 0.0, -(c.error or 0.0)))
            offers.append((_times_cheaper(part, choice), cost, choice))
    known = [offer for offer in offers if offer[0] and offer[2].name != usual]
    saving = [offer for offer in known if offer[0] > 1.0 + STEADY]
    return next((offer[1:] for offer in saving or known), None)


def _times_cheaper(trade: Trade, choice: ChartPoint) -> float:
    """Return the usual choice's cost over that of a choice; 0 if one is unknown."""
    usual = next((c.cost for c in trade.choices if c.name == USUAL[trade.name]), None)
    return usual / choice.cost if usual and choice.cost else 0.0


def bargain(trade: Trade, choice: ChartPoint) -> str:
    """State what a choice gains and costs against the usual one; empty if that is unknown."""
    usual, ratio = USUAL[trade.name], _times_cheaper(trade, choice)
    if usual == choice.name or not ratio or choice.error is None:
        return ""
    paid = "bytes" if trade.cost_unit == "B" else "time"
    template = _BARGAINS[paid, ratio > 1.0]
    if max(ratio, 1.0 / ratio) <= (1.0 if paid == "bytes" else 1.0 + STEADY):
        template = MEASURE["as-dear"]
    error = choice.error if choice.predicted is None else max(choice.predicted, choice.error)
    off = MEASURE["measured"] if choice.predicted is None else MEASURE["predicted"]
    off = of_measure(MEASURE["separates"] if trade.name == "depth" else off)
    off = off.format(f"{_plain(error)} {named(trade.error_unit)}")
    names = (named(each) for each in (choice.name, usual))
    return with_comma(of_measure(template).format(*names, _plain(max(ratio, 1.0 / ratio)), off))


def _price(trade: Trade, choice: ChartPoint) -> str:
    prices = {trade.cost_unit: choice.cost, "B": choice.bytes}
    return ", ".join(f"{_plain(price)} {unit}" for unit, price in prices.items() if price)


def cheapest(trade: Trade, limit: float) -> ChartPoint | None:
    """Return the cheapest choice whose error is at most `limit`."""
    good = [choice for choice in trade.frontier if (choice.error or 0.0) <= limit]
    return good[0] if good else None
