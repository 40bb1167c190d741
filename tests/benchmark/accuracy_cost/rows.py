"""The table that --accuracy chooses from, derived from what was measured."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from bench import Bench, Outcome, error, load
from ropes import BENT_RADIUS, TRAVEL
from scenes import BENCHES, BENDING, CUTS, DEGREE, DEPTH, ELEMENTS, STEP

from braidx.scene.accuracy import BENT, LEVELS, PULLED, Choice, fraction

OPTIONS = {BENDING, CUTS, DEGREE, DEPTH, ELEMENTS, STEP}
CROSSINGS = {"pulled": 8, "bent": 4}  # of a yarn per pitch
KINDS = {"pulled": "pulled", "bent": "bent over a sheave"}
SAYS = """\
The cheapest of the runs above that reach the level, provided that all runs as fine in every respect do, too;
`--accuracy` takes these rows for what a scene leaves open. Where no run reaches the level the row is the most exact one,
and the error says so. Penetrations below the default are only taken with elements as fine as the row's: coarser ones
cannot be kept apart so well."""
TABLES: Mapping[str, Mapping[str, Choice]] = {"pulled": PULLED, "bent": BENT}


@dataclass(frozen=True)
class Candidate:
    """A run that might be a row of the table."""

    outcome: Outcome
    choice: Choice

    def is_as_fine_as(self, other: Candidate) -> bool:
        """In every respect."""
        mine, its = self.choice, other.choice
        return (
            mine.degree >= its.degree
            and mine.elements >= its.elements
            and mine.station_spacing <= its.station_spacing
            and mine.penetration <= its.penetration
            and mine.step <= its.step
        )


def candidates(bench: Bench) -> list[Candidate]:
    """Runs of a rope that differ in what the table has, and did not fail."""
    outcomes = load(bench.name)
    found = [o for o in outcomes.values() if set(o.options) <= OPTIONS and not o.failure]
    reference = bench.reference() if bench.reference is not None else {}
    return [Candidate(o, _choice(bench, o, outcomes)) for o in found if o.options != reference]


def _choice(bench: Bench, outcome: Outcome, outcomes: Mapping[str, Outcome]) -> Choice:
    options = outcome.options
    step = options.get(STEP, 1e-3)
    if bench.name == "bent":
        step = TRAVEL / options.get(BENDING, 30) / BENT_RADIUS
    return Choice(
        options.get(DEGREE, 1),
        options.get(ELEMENTS, 40) / CROSSINGS[bench.name],
        options.get(CUTS, 0.25),
        options.get(DEPTH, 0.015),
        step,
        error(bench, outcome, outcomes),
    )


def derived(name: str) -> dict[str, Choice]:
    """The cheapest candidate per level that reaches it, as do all that are as fine in every respect.

    Where none does it is the one with the smallest error.
    """
    (bench,) = (bench for bench in BENCHES if bench.name == name)
    return {level: cheapest(candidates(bench), fraction(level)).choice for level in LEVELS}


def cheapest(found: list[Candidate], limit: float) -> Candidate:
    """See `derived`."""
    sure = [
        each
        for each in found
        if all(o.choice.reached <= limit for o in found if o.is_as_fine_as(each))
    ]
    if sure:
        return min(sure, key=lambda each: each.outcome.seconds)
    return min(found, key=lambda each: each.choice.reached)


def table() -> str:
    """The end of the page."""
    lines = ["## For 5 %, 1 %, 0.1 %: use this", ""]
    lines += [
        SAYS,
        "",
        "| rope | for | degree | elements from crossing to crossing | station spacing (elements) | "
        "penetration (radius) | increment | error measured (%) |",
        "| --- | --- | ---: | ---: | ---: | ---: | --- | ---: |",
    ]
    for name, kind in KINDS.items():
        for level, row in TABLES[name].items():
            unit = "of strain" if name == "pulled" else "radii of travel"
            missed = " **missed**" if row.reached > fraction(level) else ""
            lines.append(
                f"| {kind} | {level.replace('%', ' %')} | {row.degree} | {row.elements:g} | {row.station_spacing:g} | "
                f"{row.penetration:g} | {row.step:.3g} {unit} | {100 * row.reached:.2g}{missed} |"
            )
    return "\n".join([*lines, ""])


def agree(mine: Choice, other: Choice) -> bool:
    """Whether two rows are the same but for round-off."""
    pairs = zip(vars(mine).values(), vars(other).values())
    return all(math.isclose(a, b, rel_tol=0.02) for a, b in pairs)
