"""A study: cases that differ from a demo in a few values, and what a paper says of the result.

The one command of each study is that of its script,

    ./braidx shell python3 tests/studies/diameter_ratio.py [--out DIR] [--quick] [--only LABEL ...] [--set KEY=VALUE]

Runs are in DIR/runs, shared by all studies: what has been computed is not computed again, what was interrupted is
resumed. Table and figure are DIR/NAME.csv, .md and .png. A study of paper 1 writes its page of the
documentation, docs/study_NAME.md and its images, from runs of all cases; of some of them, or of other ropes, the page
is in DIR. A case that fails is in the table, and the others go on.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from braidx.scene import Pull, Settle, Step

if TYPE_CHECKING:
    from study_runs import Outcome

ROOT = Path(__file__).resolve().parents[2]
OUT, DOCS = ROOT / "results" / "studies", ROOT / "docs"
BENDING, TENSILE = (
    ROOT / "demos" / f"{name}.toml" for name in ("bending_over_sheave", "tensile_test")
)

# The smallest braid that bends: four yarns about a thin core, 2 pitches of 17 mm.
QUICK = (
    "rope.pitches=2",
    "braid.strands_per_direction=[2, 2]",
    "braid.helix_radius=1.6",
    "braid.undulation=0.6",
    "core.radius=0.4",
    "core.model=beam",
    "sheave.diameter=20",
    "yarn.radius=0.6",
    "yarn.axial_stiffness=22.6e3",
    "yarn.elements_per_pitch=16",
    "steps.bend.travel=1",
    "steps.bend.increments=2",
    "solver.director_viscosity=100",
)
# Of its yarns where these are mixed.
QUICK_MIXED = ("yarn.model=mixed", "yarn.seeds=8", "yarn.solid_stretch=10")

# The smallest braid that is pulled: eight yarns, one pitch of 36 mm.
SMALL = (
    "rope.pitch=36",
    "rope.pitches=1",
    "braid.strands_per_direction=[4, 4]",
    "braid.motif=1-over-1-under",
    "braid.helix_radius=2",
    "strand.rings=[1]",
    "strand.yarn_pitch=untwisted",
    "yarn.radius=0.86",
    "yarn.elements_per_pitch=36",
)
SMALL_PROGRAMME = (Settle(force=0.5), Pull(to_force=3.0), Pull(to_force=5.0))


def yarn_of(radius: float, axial_stiffness: float, helix_radius: float = 4.0) -> tuple[str, ...]:
    """Overrides of a yarn (mm, N) on helices of a radius; undulation and core as they follow from it."""
    return (
        f"yarn.radius={radius:g}",
        f"yarn.axial_stiffness={axial_stiffness:.6g}",
        f"braid.undulation={radius:g}",
        f"core.radius={helix_radius - 2.0 * radius:g}",
    )


class Report(Protocol):
    """Writes table and figures of a study below a folder; the text."""

    def __call__(self, study: Study, outcomes: Sequence[Outcome], out: Path, /) -> str: ...


@dataclass(frozen=True)
class Case:
    """One rope of a study.

    Attributes:
        label: Its name in the table.
        value: Where it stands on the abscissa.
        overrides: What differs from the demo, KEY=VALUE.
    """

    label: str
    value: float
    overrides: tuple[str, ...] = ()


@dataclass(frozen=True)
class Statement:
    """What the paper says, with the level (mm) and the range of the abscissa that it says it of, where there is one."""

    text: str
    level: float | None = None
    span: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True)
class Study:
    """All cases of a study.

    Attributes:
        name: Of its files.
        title: Heading of table and figure.
        quantity: What varies, with its unit.
        cases: In the order of the abscissa.
        statements: Of the paper, as far as they are drawn.
        base: Overrides of all cases, before their own.
        chosen: What the paper leaves open, and what was chosen.
        named: Whether cases are named on the abscissa, not numbered.
        reference: Label of the case that errors are counted from; None where none is more exact than the others.
        demo: The scene that cases differ from.
        programme: Steps of all cases after forming, in place of the demo's; empty: those of the demo.
    """

    name: str
    title: str
    quantity: str
    cases: tuple[Case, ...]
    statements: tuple[Statement, ...] = ()
    base: tuple[str, ...] = ()
    chosen: str = ""
    named: bool = False
    reference: str | None = None
    demo: Path = BENDING
    programme: tuple[Step, ...] = ()


def main(
    make: Callable[[bool], Study],
    words: Sequence[str] | None = None,
    report: Report | None = None,
    docs: Path | None = None,
) -> int:
    """The command of a study; 1 if a case has failed.

    Args:
        make: Gives the study, or the quick one.
        words: Of the command line; those of this process if None.
        report: Of the study; that of paper 2's if None.
        docs: Where the report of all cases goes, rather than to --out.
    """
    from study_runs import run_study

    if report is None:
        from study_report import report as report_of_bending

        report = report_of_bending

    parser = argparse.ArgumentParser(description=make(False).title)
    parser.add_argument("--out", type=Path, default=OUT, help="results [results/studies]")
    parser.add_argument("--quick", action="store_true", help="a tiny rope, to try the script")
    parser.add_argument("--only", nargs="+", metavar="LABEL", help="some of the cases")
    parser.add_argument("--set", dest="overrides", action="append", default=[], metavar="KEY=VALUE")
    given = parser.parse_args(words)
    study = make(given.quick)
    labels = [case.label for case in study.cases]
    for label in given.only or ():
        if label not in labels:
            parser.error(f"--only {label!r}: no such case; choose from {', '.join(labels)}")
    outcomes = run_study(study, given.out, given.overrides, given.only)
    failed = any(outcome.failure for outcome in outcomes)
    whole = not (failed or given.quick or given.only or given.overrides)
    print("\n" + report(study, outcomes, docs if docs and whole else given.out))
    return 1 if failed else 0
