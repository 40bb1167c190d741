"""docs/stability.md and its maps, written from the outcomes of this run."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import judge
from family import Family, counts
from judge import FAILED, SLOW, WRONG, Outcome
from maps import draw

DOCS = Path(__file__).resolve().parents[2] / "docs"
OUTCOMES = DOCS.parent / "results" / "stability.json"
HEAD = f"""# The edge of stability

What can be asked of [scenes of rods](howto_rods.md) before they get slow or fail, and that nothing fails in silence.
This page and its maps are written by `./braidx test --stability`; its tests hold the frontiers where they were found.

Each symbol is a scene, and the number above it the Newton iterations of all calls that did not fail. One judge looks at
all of them:

- **converged**;
- **slow**: more than {judge.SLOWNESS:g} times the median iterations of its family, or increments that had to be cut;
- **failed cleanly**: `NotConverged`, with a message that says how far it got;
- **wrong**: an answer that cannot be right, without a word.

To be right, forces and moments of supports and loads have to cancel (to {judge.BALANCE:g} of them, or of what
presses rods on each other); penetrations have to stay
within their limit; centre lines, measured apart from the search for contact, may not come nearer than radii and
penetration say (by {judge.HIDDEN:g} of the sum of the radii), nor cross each other on the way of an increment; and the
work of motions and loads has to be in the elastic energy, the friction, the stabilisation and the penalties (to
{judge.ENERGY:.0%}; of increments whose forces at begin and end differ, to what lies between). Where rods snap from one
equilibrium to another, energy may be lost, but none may be made.
"""


def keep(done: dict[str, list[Outcome]]) -> None:
    """Keeps outcomes in results/stability.json, in the place of those that an earlier run left of the same families."""
    OUTCOMES.parent.mkdir(exist_ok=True)
    kept = json.loads(OUTCOMES.read_text(encoding="utf-8")) if OUTCOMES.exists() else {}
    kept |= {name: [vars(outcome) for outcome in outcomes] for name, outcomes in done.items()}
    OUTCOMES.write_text(json.dumps(kept), encoding="utf-8")


def write(families: Sequence[Family], done: dict[str, list[Outcome]]) -> None:
    """Page and maps of the families; all of them have to be done."""
    parts = [HEAD, _table(families, done)]
    for family in families:
        outcomes = done[family.name]
        (family.draw or draw)(family, outcomes, DOCS / "images" / f"stability_{family.name}.png")
        parts.append(_section(family, outcomes))
    (DOCS / "stability.md").write_text("\n".join(parts), encoding="utf-8")


def _table(families: Sequence[Family], done: dict[str, list[Outcome]]) -> str:
    rows = [
        "## All families",
        "",
        "| family | scenes | outcome | seconds |",
        "| --- | --- | --- | --- |",
    ]
    for family in families:
        outcomes = done[family.name]
        seconds = sum(outcome.seconds for outcome in outcomes)
        rows.append(f"| {family.title} | {len(outcomes)} | {counts(outcomes)} | {seconds:.0f} |")
    return "\n".join(rows) + "\n"


def _section(family: Family, outcomes: Sequence[Outcome]) -> str:
    lines = [f"## {family.title}", "", family.says, ""]
    lines += [f"![Map: {family.title}](images/stability_{family.name}.png)", ""]
    lines += [f"{counts(outcomes).capitalize()}. {_worst(outcomes)}", ""]
    if family.means:
        lines += [f"**For a scene of yours.** {family.means}", ""]
    for status in (WRONG, FAILED, SLOW):
        lines += _named(outcomes, status)
    return "\n".join(lines)


def _worst(outcomes: Sequence[Outcome]) -> str:
    converged = [outcome for outcome in outcomes if outcome.status not in (FAILED, WRONG)]
    if not converged:
        return ""
    forces = max(outcome.force_error for outcome in converged)
    moments = max(outcome.moment_error for outcome in converged)
    energy = max(
        (abs(outcome.energy_error) for outcome in converged if outcome.knows_work), default=0.0
    )
    return (
        f"Of those that converged, forces cancel to {forces:.0e}, moments to {moments:.0e}, and energy is accounted "
        f"for to {energy:.1%}."
    )


def _named(outcomes: Sequence[Outcome], status: str, most: int = 12) -> list[str]:
    """Scenes that are wrong or failed, with the reason."""
    chosen = [outcome for outcome in outcomes if outcome.status == status]
    if not chosen or status == SLOW:
        return []
    lines = [f"{status.capitalize()}:", ""]
    for outcome in chosen[:most]:
        case = ", ".join(f"{value:g}" for value in outcome.case)
        lines.append(f"- ({case}): {outcome.why.split('. Try')[0]}")
    if len(chosen) > most:
        lines.append(f"- and {len(chosen) - most} more")
    return [*lines, ""]


def rewrite() -> None:
    """Page and maps again, from the last outcomes of each family: python3 tests/stability/report.py."""
    from families import FAMILIES

    kept = json.loads(OUTCOMES.read_text(encoding="utf-8"))
    done = {
        name: [Outcome(**{**values, "case": tuple(values["case"])}) for values in outcomes]
        for name, outcomes in kept.items()
    }
    write([family for family in FAMILIES if family.name in done], done)


if __name__ == "__main__":
    rewrite()
