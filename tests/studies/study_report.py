"""Table and figure of a study."""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from pathlib import Path

from bent_values import CROSSING_FORCE, ESTIMATE, NEAR_CROWN, SLIP, SUMMARY
from matplotlib.axes import Axes
from study import Study
from study_runs import Outcome
from summaries import SECONDS

from braidx.output.figures.style import AMBER, BLUE, GREY, INK, figure, save, styled

COLUMNS = (SLIP, NEAR_CROWN, *list(SUMMARY)[1:], CROSSING_FORCE, ESTIMATE, SECONDS)
ERROR = "error (%)"  # of the relative displacement, against the reference
SIDE = ("end force (N)", "core pressure (MPa)", CROSSING_FORCE)  # panels beside the main one


def report(study: Study, outcomes: Sequence[Outcome], out: Path) -> str:
    """Writes NAME.csv, NAME.md and NAME.png below `out`; the table as Markdown."""
    out.mkdir(parents=True, exist_ok=True)
    rows = table(study, outcomes)
    with (out / f"{study.name}.csv").open("w", newline="", encoding="utf-8") as stream:
        csv.writer(stream, lineterminator="\n").writerows(rows)
    text = markdown(study, rows)
    (out / f"{study.name}.md").write_text(text, "utf-8")
    draw(study, outcomes, out / f"{study.name}.png")
    return text


def table(study: Study, outcomes: Sequence[Outcome]) -> list[list[str]]:
    """Header and one row per case; a case that failed says so, its numbers are empty."""
    columns = [*COLUMNS, *([ERROR] if study.reference else [])]
    error = errors(study, outcomes)
    rows = [[study.quantity, *columns, "state"]]
    for outcome in outcomes:
        values = {**outcome.values, ERROR: error.get(outcome.case.label, math.nan)}
        cells = [values.get(name, math.nan) for name in columns]
        numbers = [f"{value:.4g}" if math.isfinite(value) else "" for value in cells]
        rows.append([outcome.case.label, *numbers, outcome.failure or "converged"])
    return rows


def errors(study: Study, outcomes: Sequence[Outcome]) -> dict[str, float]:
    """Error of the relative displacement by label, %, of all cases but the reference; none without its result."""
    slips = {outcome.case.label: outcome.values.get(SLIP, math.nan) for outcome in outcomes}
    exact = slips.pop(study.reference, math.nan) if study.reference else math.nan
    if not math.isfinite(exact) or exact == 0.0:
        return {}
    return {label: 100.0 * abs(slip - exact) / exact for label, slip in slips.items()}


def markdown(study: Study, rows: Sequence[Sequence[str]]) -> str:
    """Heading, what the paper says, what was chosen, and the table."""
    lines = [f"# {study.title}", ""]
    lines += [
        f"{statement.text[0].upper()}{statement.text[1:]}.\n" for statement in study.statements
    ]
    lines += [f"{study.chosen}\n"] if study.chosen else []
    header, *body = ([cell.replace("|", "/") for cell in row] for row in rows)
    lines.append(f"| {' | '.join(header)} |")
    lines.append(f"| {' | '.join(['---', *['---:'] * (len(header) - 2), '---'])} |")
    lines += [f"| {' | '.join(row)} |" for row in body]
    return "\n".join(lines) + "\n"


@styled
def draw(study: Study, outcomes: Sequence[Outcome], path: Path) -> Path:
    """Relative displacement beside the paper's statements, forces and pressure, and error against seconds."""
    error = errors(study, outcomes)
    page = figure(11.0, 8.0)
    grid = page.add_gridspec(3, 2, width_ratios=[1.5, 1.0])
    main = page.add_subplot(grid[:2, 0] if error else grid[:, 0])
    _draw_slip(study, outcomes, main)
    for row, name in enumerate(SIDE):
        ax = page.add_subplot(grid[row, 1])
        _curve(ax, outcomes, name, BLUE, name)
        ax.set_ylabel(name.replace(" (", "\n("))
        ax.margins(y=0.15)
        ax.set_ylim(bottom=0.0)
        _abscissa(study, ax, row == len(SIDE) - 1)
    if error:
        _draw_error(study, error, outcomes, page.add_subplot(grid[2, 0]))
    return save(page, path)


def _draw_slip(study: Study, outcomes: Sequence[Outcome], ax: Axes) -> None:
    _curve(ax, outcomes, SLIP, BLUE, "mean of the four crossings at the crown (paper 2)")
    _curve(ax, outcomes, NEAR_CROWN, AMBER, "largest within half a pitch of the crown")
    _curve(ax, outcomes, ESTIMATE, GREY, "frictionless estimate", "--")
    for outcome in outcomes:
        if outcome.failure:
            place = (outcome.case.value, 0.02)
            ax.text(*place, "failed", color=INK, rotation=90, ha="center", va="bottom")
    said = []
    for statement in study.statements:
        if statement.level is None:
            said.append(statement.text)
            continue
        ax.hlines(statement.level, *statement.span, color=INK, lw=2.0)
        # Towards the middle of the chart.
        cases = [case.value for case in study.cases]
        left = sum(statement.span) < min(cases) + max(cases)
        end = (statement.span[0 if left else 1], statement.level)
        side = "left" if left else "right"
        ax.annotate(statement.text, end, (0, 4), textcoords="offset points", ha=side)
    ax.set_title("\n".join([study.title, *said]))
    ax.set_ylabel("relative displacement (mm)")
    ax.margins(y=0.15)
    ax.set_ylim(bottom=0.0)
    ax.legend(loc="best")
    _abscissa(study, ax, True)


def _draw_error(
    study: Study, error: dict[str, float], outcomes: Sequence[Outcome], ax: Axes
) -> None:
    for outcome in outcomes:
        label, seconds = outcome.case.label, outcome.values.get(SECONDS, math.nan)
        if label in error:
            ax.plot(seconds, error[label], "o", color=BLUE, ms=5)
            ax.annotate(label, (seconds, error[label]), (5, 3), textcoords="offset points")
        elif label == study.reference:
            ax.axvline(seconds, color=GREY, lw=0.8, ls=":", label=f"{label}, the reference")
    ax.set_xscale("log")
    for tick in (ax.xaxis.set_major_formatter, ax.xaxis.set_minor_formatter):
        tick("{x:g}")
    ax.margins(x=0.2, y=0.2)
    ax.set_xlabel("seconds")
    ax.set_ylabel("error of the relative\ndisplacement (%)")
    ax.set_ylim(bottom=0.0)
    ax.grid(True)
    ax.legend(loc="best")


def _curve(
    ax: Axes, outcomes: Sequence[Outcome], name: str, colour: str, label: str, style: str = "-"
) -> None:
    done = [outcome for outcome in outcomes if not outcome.failure]
    x = [outcome.case.value for outcome in done]
    y = [outcome.values[name] for outcome in done]
    ax.plot(x, y, "o" + style, color=colour, ms=4, lw=1.5, label=label)


def _abscissa(study: Study, ax: Axes, labelled: bool) -> None:
    if study.named or not labelled:
        names = [case.label for case in study.cases] if labelled else []
        ticks = [case.value for case in study.cases]
        ax.set_xticks(ticks, names or [""] * len(ticks))
    if labelled:
        ax.set_xlabel(study.quantity)
    # All cases, those that failed too, and what the paper speaks of.
    said = [end for s in study.statements if s.level is not None for end in s.span]
    places = [*said, *(case.value for case in study.cases)]
    margin = 0.1 * (max(places) - min(places)) or 0.5
    ax.set_xlim(min(places) - margin, max(places) + margin)
    ax.grid(True)
    ax.set_axisbelow(True)
