"""The table that --accuracy chooses from, derived from what was measured."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

from bench import Bench, error, load
from ropes import SCENES
from scenes import BENCHES, BENDING, CUTS, DEGREE, DEPTH, ELEMENTS, STEP

from braidx.scene import Bend, Pull, Scene
from braidx.scene.accuracy import BENT, LEVELS, PULLED, Choice, fraction
from braidx.scene.defaults import crossings

OPTIONS = {BENDING, CUTS, DEGREE, DEPTH, ELEMENTS, STEP}
ROUND_OFF = 1e-9
MOST_NODES = {
    "pulled": 167,
    "twelve": 652,
    "bent": 113,
}  # per pitch: a quarter of the yarn's radius apart
ROPES = {"pulled": ("pulled", "twelve"), "bent": ("bent",)}  # that rows are derived from
KINDS = {"pulled": "pulled", "bent": "bent over a sheave"}
SAYS = """\
The cheapest options, by unknowns times iterations, that reach the level in all runs above which are as fine in every
respect, so that none is there by luck; the error is the largest of those runs (of both ropes that are pulled). Runs
with nodes closer than a quarter of the yarn's radius are left aside. Where no options reach the level the row is the
one with the smallest such error, and is marked. `--accuracy` takes these rows for what a scene leaves open, but no more
elements than leave a third of a radius between nodes, and penetrations below the default only with elements as fine as
the row's: coarser ones cannot be kept apart so well. Braids of strands of several yarns get as many nodes of degree 1,
and scenes that state their elements keep degree 1. Of a strand without a braid an eighth of a lay stands for the way
from crossing to crossing. Errors are those of stiffness and diameter, or of the force on an end: friction work, and
sliding as small as in the braid above, are less exact."""
TABLES: Mapping[str, Mapping[str, Choice]] = {"pulled": PULLED, "bent": BENT}


@dataclass(frozen=True)
class Candidate:
    """Options that might be a row of the table.

    Attributes:
        choice: With the largest error of all ropes of the kind.
        work: Unknowns times iterations, of all of them: a cost that does not depend on the machine.
    """

    choice: Choice
    work: float

    def is_as_fine_as(self, other: Candidate) -> bool:
        """In every respect."""
        mine, its = self.choice, other.choice
        return (
            mine.degree >= its.degree
            and mine.elements >= its.elements - ROUND_OFF
            and mine.station_spacing <= its.station_spacing
            and mine.penetration <= its.penetration
            and mine.step <= its.step + ROUND_OFF
        )


def candidates(kind: str) -> list[Candidate]:
    """Options that all ropes of a kind were computed with."""
    ropes = [runs(bench) for bench in BENCHES if bench.name in ROPES[kind]]
    found = []
    for options in ropes[0]:
        pairs = [rope[options] for rope in ropes if options in rope]
        if len(pairs) == len(ropes):
            works, found_errors = zip(*pairs)
            found.append(Candidate(Choice(*options, max(found_errors)), sum(works)))
    return found


def runs(bench: Bench) -> dict[tuple[float, ...], tuple[float, float]]:
    """Work and error of the runs that differ in what the table has and did not fail, by its options."""
    outcomes, found = load(bench.name), {}
    reference = bench.reference() if bench.reference is not None else {}
    for outcome in outcomes.values():
        options = outcome.options
        if not set(options) <= OPTIONS or options == reference or outcome.failure:
            continue
        scene, missed = SCENES[bench.name](**options), error(bench, outcome, outcomes)
        nodes = scene.yarn.degree * scene.yarn.elements_per_pitch
        if nodes <= MOST_NODES[bench.name] and math.isfinite(missed):
            found[_row(scene)] = float(outcome.unknowns * outcome.iterations), missed
    return found


def _row(scene: Scene) -> tuple[float, ...]:
    """Options as the table has them, in the order of Choice."""
    (step,) = (each for each in scene.steps if isinstance(each, (Pull, Bend)))
    return (
        scene.yarn.degree,
        scene.yarn.elements_per_pitch / crossings(scene),
        scene.contact.station_spacing,
        scene.contact.penetration_tolerance,
        (
            step.strain_increment
            if isinstance(step, Pull)
            else round(step.travel / step.increments / scene.yarn.radius, 3)
        ),
    )


def derived(kind: str) -> dict[str, Choice]:
    """A row for each level, see SAYS; its error is the largest of all runs that are as fine in every respect."""
    found = candidates(kind)
    bounds = [max(o.choice.reached for o in found if o.is_as_fine_as(each)) for each in found]
    rows = {}
    for level in LEVELS:
        sure = [i for i in range(len(found)) if bounds[i] <= fraction(level)]
        best = min(sure, key=lambda i: found[i].work, default=None)
        if best is None:
            best = min(range(len(found)), key=lambda i: bounds[i])
        rows[level] = replace(found[best].choice, reached=bounds[best])
    return rows


def table() -> str:
    """The end of the page."""
    lines = ["## For 5 %, 1 %, 0.1 %: use this", ""]
    lines += [
        SAYS,
        "",
        "| rope | for | degree | elements from crossing to crossing | station spacing (elements) | "
        "penetration (radius) | increment | error at most (%) |",
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
