"""docs/accuracy.md and its charts, from what is stored."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import remarks
from bench import Bench, Options, Outcome, error, errors, front, key, load
from charts import costs_and_errors, draw
from lookup import Lookup
from rope_remarks import bent, models, pulled, reasons, twelve
from rows import table
from scenes import BENCHES

HEAD = """\
# Accuracy against cost

What an error of 5 %, 1 % or 0.1 % costs, and which choices it takes: scenes with an exact answer, then ropes against
their own finest run. The numbers, tables and charts of this page are made from stored results by

    ./braidx shell python3 tests/benchmark/accuracy_cost/measure.py

which computes what is not stored yet. CPU time is that of the process, with one thread, on a machine that was busy with
other work: differences below a third mean nothing, and about 0.07 s of each is the same for every scene. Unknowns and
Newton iterations (attempts that fail and forming included) are exact. In the charts each point is a run; lines join
those of a series, whose first and last are named. The star is the default, the grey staircase the Pareto front of all:
none is both cheaper and more exact. The short version is [at the end](#for-5--1--01--use-this).
"""
WIDTH = 120
GAIN = 0.9  # factor on the error of the one before that a run of the front is listed for
REMARKS = {
    "capstan": remarks.capstan,
    "fibres": remarks.fibres,
    "strand": remarks.strand,
    "bar": remarks.bar,
    "pulled": pulled,
    "twelve": twelve,
    "bent": bent,
}
DOCS = Path(__file__).parents[3] / "docs"
NAMED = 3  # runs that are better than a default, at most
CHEAPER, FINER = 1.5, 2.0  # factors on cost and error that a default may miss the front by
NAMES = {  # options as the page calls them
    "yarn__elements_per_pitch": "elements per pitch",
    "yarn__degree": "degree",
    "yarn__model": "model",
    "contact__station_spacing": "station spacing",
    "contact__penetration_tolerance": "penetration",
    "steps__pull__strain_increment": "strain per increment",
    "steps__bend__increments": "increments",
    "solver__tangent": "tangent",
    "solver__tolerance": "residual",
    "solver__petsc__pc_factor_mat_solver_type": "factors by",
    "symmetrised": "symmetric tangent",
    "solver": "factors by",
    "tolerance": "residual",
    "angle": "degrees between nodes",
    "spans": "spans",
    "spacing": "station spacing",
    "penetration": "penetration",
}


def write() -> None:
    """Page and charts of the scenes whose runs are all stored."""
    for bench in complete():
        draw(bench, load(bench.name), DOCS / "images" / f"accuracy_{bench.name}.png")
    (DOCS / "accuracy.md").write_text(page(), "utf-8")


def page() -> str:
    """The text of the page."""
    parts = [HEAD]
    for bench in complete():
        parts += section(bench, load(bench.name))
    if len(complete()) == len(BENCHES):
        parts += [models()]
    parts += [defaults(), table()]
    return "\n".join(parts)


def complete() -> list[Bench]:
    """The scenes whose runs are all stored."""
    return [b for b in BENCHES if all(key(o) in load(b.name) for o in b.runs())]


def wrapped(text: str) -> str:
    """A paragraph in lines that are short enough; a per cent sign stays with its number."""
    held = " ".join(text.split()).replace(" %", "\u00a0%")
    lines = textwrap.wrap(held, WIDTH, break_long_words=False, break_on_hyphens=False)
    return "\n".join(lines).replace("\u00a0", " ")


def section(bench: Bench, outcomes: Mapping[str, Outcome]) -> list[str]:
    """Chart, front and remarks of a scene."""
    lines = [f"## {bench.title}", "", wrapped(bench.says), ""]
    lines += [f"![{bench.title}: error against cost](images/accuracy_{bench.name}.png)", ""]
    for paragraph in REMARKS[bench.name](Lookup(bench, outcomes)):
        lines += [wrapped(paragraph), ""]
    lines += [
        "The Pareto front of CPU time, in steps of a tenth of the error at least:",
        "",
        *front_table(bench, outcomes),
        "",
    ]
    failed = [o for o in outcomes.values() if o.failure]
    if failed:
        told = "; ".join(f"{called(o.options)}: {o.failure}" for o in failed)
        lines += [wrapped(f"Runs that failed: {told}."), ""]
    return lines


def front_table(bench: Bench, outcomes: Mapping[str, Outcome]) -> list[str]:
    """Runs on the front, and the default."""
    runs = [o for o in outcomes.values() if costs_and_errors(bench, [o], outcomes, "seconds")]
    points = costs_and_errors(bench, runs, outcomes, "seconds")
    chosen: list[Outcome] = []
    for outcome in (runs[i] for i in front(points)):
        if not chosen or error(bench, outcome, outcomes) < GAIN * error(
            bench, chosen[-1], outcomes
        ):
            chosen.append(outcome)
    default = outcomes[key({})]
    names = [f"error of {name.replace('_', ' ')} (%)" for name in bench.judged]
    lines = [f"| run | {' | '.join(names)} | CPU time (s) | unknowns | iterations |"]
    lines.append("| --- |" + " ---: |" * (len(names) + 3))
    rest = [] if default in chosen else [default]
    for outcome in [*chosen, *rest]:
        found = errors(bench, outcome, outcomes)
        cells = [shown(found.get(name, math.nan)) for name in bench.judged]
        star = "**default**" if outcome is default else called(outcome.options)
        star += " (not on the front)" if outcome in rest else ""
        cost = f"{outcome.seconds:.2f} | {outcome.unknowns or ''} | {outcome.iterations or ''}"
        lines.append(f"| {star} | {' | '.join(cells)} | {cost} |")
    return lines


def defaults() -> str:
    """Whether the defaults lie near the front of each scene, and what is better where they do not."""
    lines = ["## Are the defaults well chosen?", ""]
    counts = (
        f"A default counts as near the front if no run is {CHEAPER:g} times cheaper and at least as exact, and none "
        f"{FINER:g} times as exact and no dearer."
    )
    lines += [
        wrapped(counts),
        "",
        "| scene | error of the default (%) | CPU time (s) | better by that much |",
    ]
    lines.append("| --- | ---: | ---: | --- |")
    for bench in complete():
        outcomes = load(bench.name)
        default = outcomes[key({})]
        better = dominating(bench, outcomes)
        told = "; ".join(
            f"{called(o.options)} ({shown(error(bench, o, outcomes))} %, {o.seconds:.2f} s)"
            for o in better[:NAMED]
        )
        mine = shown(error(bench, default, outcomes))
        lines.append(f"| {bench.title} | {mine} | {default.seconds:.2f} | {told or 'none: near'} |")
    if len(complete()) == len(BENCHES):
        for paragraph in reasons():
            lines += ["", wrapped(paragraph)]
    return "\n".join([*lines, ""])


def dominating(bench: Bench, outcomes: Mapping[str, Outcome]) -> list[Outcome]:
    """Runs of the default's model that are better than the default by the factors above."""
    default = outcomes[key({})]
    mine, found = error(bench, default, outcomes), []
    for outcome in outcomes.values():
        its = error(bench, outcome, outcomes)
        if not math.isfinite(its) or outcome.seconds >= default.seconds or its <= 0.0:
            continue
        cheaper = outcome.seconds * CHEAPER <= default.seconds and its <= mine
        if cheaper or its * FINER <= mine:
            found.append(outcome)
    return sorted(found, key=lambda outcome: error(bench, outcome, outcomes))


def called(options: Options) -> str:
    """What departs from the defaults, in words."""
    told = [f"{NAMES.get(name, name)} {_value(value)}" for name, value in options.items()]
    return ", ".join(told) or "default"


def _value(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value).lower()


def shown(value: float) -> str:
    """A fraction in per cent, two digits."""
    return f"{100.0 * value:.2g}"
