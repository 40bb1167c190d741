"""The page of a study in the documentation: what the paper says beside what was computed, and whether it holds.

Its words are pages/NAME.md, where each number is a name in braces.

Whether a statement holds is decided by a criterion, which the page states, too, and which tests judge by.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from study import Report, Study
from study_runs import Outcome

PAGES = Path(__file__).parent / "pages"
HOLDS, DOES_NOT = "holds", "**does not hold**"


@dataclass(frozen=True)
class Claim:
    """A statement of the paper and what became of it.

    Attributes:
        name: That tests know it by.
        said: What the paper says.
        criterion: When that is taken to hold.
        found: What was computed.
        holds: Whether it meets the criterion.
    """

    name: str
    said: str
    criterion: str
    found: str
    holds: bool


@dataclass(frozen=True)
class Page:
    """How the page of a study is made, of outcomes of all of its cases.

    Attributes:
        name: The page is study_NAME.md, its images images/study_NAME*.png.
        claims: The statements.
        numbers: What the names in the page stand for; `title` and `verdicts` need not be among them.
        draw: Writes the images into a folder.
    """

    name: str
    claims: Callable[[Sequence[Outcome]], list[Claim]]
    numbers: Callable[[Sequence[Outcome]], dict[str, str | float]]
    draw: Callable[[Sequence[Outcome], Path], None]

    def report(self) -> Report:
        """Writes page and images below a folder; the page."""
        return lambda study, outcomes, folder: write(self, study, outcomes, folder)


def write(page: Page, study: Study, outcomes: Sequence[Outcome], folder: Path) -> str:
    """Page and images below a folder; of a study with cases left out or failed only what became of each case."""
    (folder / "images").mkdir(parents=True, exist_ok=True)
    failed = any(outcome.failure for outcome in outcomes)
    if failed or len(outcomes) < len(study.cases):
        text = f"# {study.title}\n\n{states(study, outcomes)}"
    else:
        words = (PAGES / f"{page.name}.md").read_text("utf-8")
        judged = verdicts(page.claims(outcomes))
        text = words.format(title=study.title, verdicts=judged, **page.numbers(outcomes))
        page.draw(outcomes, folder / "images")
    (folder / f"study_{page.name}.md").write_text(text, "utf-8")
    return text


def states(study: Study, outcomes: Sequence[Outcome]) -> str:
    """What became of each case."""
    rows = [
        [o.case.label, o.failure or "converged", *[f"{v:.4g}" for v in [*o.values.values()][:1]]]
        for o in outcomes
    ]
    headline = next((next(iter(o.values)) for o in outcomes if o.values), "")
    return table([study.quantity, "state", headline], [[*row, ""][:3] for row in rows])


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table in Markdown, its first column left, the others right."""
    lines = [header, ["---", *["---:"] * (len(header) - 1)], *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def verdicts(claims: Sequence[Claim]) -> str:
    """A table of statements in Markdown."""
    rows = [[c.said, c.criterion, c.found, HOLDS if c.holds else DOES_NOT] for c in claims]
    header = ["the paper", "taken to hold if", "computed", ""]
    lines = [header, ["---"] * 4, *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def column(outcomes: Sequence[Outcome], name: str) -> list[float]:
    """One number per case."""
    return [outcome.values[name] for outcome in outcomes]


def listed(values: Sequence[float], form: str) -> str:
    """Numbers one after the other."""
    return ", ".join(format(value, form) for value in values)
