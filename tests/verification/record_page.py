"""docs/verification.md and its images, of what the cases stated."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

import matplotlib
import numpy as np
from record import Records, Row, Verdict

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the way to draw comes first)

ROUND_OFF = 1e-16  # what is drawn of errors below it, as there is no logarithm of 0
TITLES = {
    "yarn": "Yarns",
    "contact": "Contact and friction",
    "strands": "Strands and braids",
    "solids": "Solids",
    "papers": "Ropes of two papers",
}
INTRODUCTIONS = {
    "papers": """\
An experiment and the models of two papers are references, not exact values: tests of one rope differ by 1 %, values
are read off figures, and what the papers do not state was chosen, openly ([paper 1](deviations.md#the-rope-of-paper-1),
[paper 2](deviations.md#bending-over-a-sheave-paper-2)). Tolerances say what is called agreement.

Ropes are formed and pulled, or bent, anew (`tests/verification/paper/`), unless `BRAIDX_PAPER_RUNS` names a folder that
has them; seconds are theirs, each on one thread. The pitch of 132 mm (R5) is given.
There is more in the studies of [pitch](study_pitch.md), of [friction](study_friction.md), with 0.03, too, and of
[bending](bending.md): that sliding hardly depends on the number and the radius of yarns (R7) is judged there alone.
"""
}
HEAD = """\
# Verification

Problems with known solutions, ropes of two papers, and what braidx makes of them. This page and its images are written
by `./braidx test --verification` from what the tests in `tests/verification/` state, whenever all of them have run and
passed; nothing here is written by hand. Each value is checked against the tolerance beside it. Errors are over the
expected value, or over the size of the whole (a length, a load) where that is 0. Of values that are compared all at
once the worst is shown, of orders from mesh to mesh the least. Seconds are those of one core of the machine that wrote
the page. A statement in words is judged by the criterion beside it. What is missed is said, and why.
"""
COLUMNS = "| case | what | expected | computed | error | tolerance | order | unknowns | s |"
VERDICT_COLUMNS = "| case | the paper | taken to hold if | computed | |"


def write(records: Records, docs: Path) -> None:
    """Writes the page and one image per family."""
    parts = [HEAD]
    for family, title in TITLES.items():
        rows = sorted(records.rows.get(family, []), key=_place)
        if rows:
            image = docs / "images" / f"verification_{family}.png"
            draw(rows, image)
            parts.append(f"## {title}\n")
            if family in INTRODUCTIONS:
                parts.append(INTRODUCTIONS[family])
            parts.append(f"![Errors and tolerances](images/{image.name})\n")
            parts.append(_table(COLUMNS, map(line, rows)))
            verdicts = sorted(records.verdicts.get(family, []), key=_place)
            if verdicts:
                parts.append(_table(VERDICT_COLUMNS, map(verdict_line, verdicts)))
            missed = [(row.case, row.what, row.missed) for row in rows]
            missed += [(verdict.case, verdict.said, verdict.missed) for verdict in verdicts]
            parts += [f"{case}, {what}, is missed: {why}\n" for case, what, why in missed if why]
    (docs / "verification.md").write_text("\n".join(parts), "utf-8")


def _table(columns: str, lines: Iterable[str]) -> str:
    return "\n".join([columns, "|---" * (columns.count("|") - 1) + "|", *lines]) + "\n"


def verdict_line(verdict: Verdict) -> str:
    """A line of the table of what papers say in words."""
    cells = [verdict.case, verdict.said, verdict.criterion, verdict.found]
    cells.append("**missed**" if verdict.missed else "holds")
    return "| " + " | ".join(cells) + " |"


def line(row: Row) -> str:
    """A line of the table."""
    of_many = f" (worst of {row.count})" if row.count > 1 else ""
    convergence = bool(row.meshes)
    cells = [
        row.case,
        row.what + of_many,
        "" if convergence else f"{row.expected:.7g}",
        "" if convergence else f"{row.computed:.7g}",
        f"{row.error:.2g}",
        f"{row.tolerance:.2g}" if np.isfinite(row.tolerance) else "",
        "" if row.order is None else f"{row.order:.2f}",
        str(row.unknowns or ""),
        f"{row.seconds:.2f}",
    ]
    if row.missed:
        cells[5] += " **missed**"
    return "| " + " | ".join(cells) + " |"


def draw(rows: list[Row], path: Path) -> None:
    """Errors beside their tolerances, and over the number of elements where there are several; 800 px wide."""
    judged = [row for row in rows if np.isfinite(row.tolerance) and not row.meshes]
    series = [row for row in rows if row.meshes]
    heights = [0.23 * len(judged) + 1.0] + [4.6] * bool(series)
    figure = plt.figure(figsize=(8.0, sum(heights)), dpi=100, layout="constrained")
    parts = figure.subfigures(len(heights), height_ratios=heights, squeeze=False).ravel()
    _bars(parts[0].subplots(), judged)
    if series:
        _convergence(parts[1].subplots(), series)
    figure.savefig(path)
    plt.close(figure)


def _bars(axes: plt.Axes, rows: list[Row]) -> None:
    places = np.arange(len(rows))
    errors = np.maximum([row.error for row in rows], ROUND_OFF)
    tolerances = [row.tolerance for row in rows]
    colours = ["#ee9944" if row.missed else "#4477aa" for row in rows]
    low = 0.1 * errors.min()
    axes.barh(places, errors - low, left=low, color=colours, height=0.6, label="error")
    axes.plot(tolerances, places, "|", color="#cc3311", ms=11, mew=2.5, label="tolerance")
    axes.set_yticks(places, [_short(row) for row in rows], fontsize=7.5)
    axes.set(xscale="log", xlim=(3.0 * low, 3.0), ylim=(len(rows) - 0.4, -0.6))
    axes.set_xlabel("error, -")
    axes.grid(axis="x", alpha=0.3)
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2, fontsize=8, frameon=False)


def _convergence(axes: plt.Axes, rows: list[Row]) -> None:
    for row, marker in zip(rows, "os^vDPX*<>" * 3, strict=False):
        number, error = np.array(row.meshes).T
        label = f"{_short(row)}: order {row.order:.1f}"
        axes.loglog(number, error, marker + "-", label=label)
    numbers = sorted({number for row in rows for number, _ in row.meshes})
    axes.set_xticks(numbers, map(str, numbers))
    axes.minorticks_off()
    axes.set(xlabel="elements", ylabel="error, -")
    axes.grid(which="both", alpha=0.3)
    axes.legend(fontsize=8, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)


def _short(row: Row) -> str:
    text = f"{row.case} {row.what}"
    return text if len(text) <= 60 else text[:58] + " .."


def _place(row: Row | Verdict) -> tuple[str, int]:
    """Cases by letter and number."""
    letter, number = re.fullmatch(r"([A-Z])(\d+).*", row.case).groups()
    return "VCR".find(letter), int(number)
