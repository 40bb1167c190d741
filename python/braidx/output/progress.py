"""What a run says while it runs: a progress line, one line per increment, a table at the end."""

from __future__ import annotations

import io
import time
from collections.abc import Callable, Mapping, Sequence

from rich.console import Console
from rich.progress import BarColumn, Progress as Bar, TaskID, TextColumn
from rich.table import Table

from braidx.output.history import HistoryRow
from braidx.output.log import LOGGER
from braidx.output.summary import PhaseCost


class Progress:
    """Progress through the steps of a run.

    On a terminal a bar stays below the increments' lines; elsewhere the same estimate ends each
    line. Everything goes through the logger, hence to run.log too.

    Args:
        steps: Names of the steps in order.
        weights: Expected share of the run's time per step, any scale; None takes them as equal.
        console: The console given to `open_log`.
        enabled: False on all ranks but the first: nothing is printed.
        clock: Seconds; for tests.
    """

    def __init__(
        self,
        steps: Sequence[str],
        weights: Sequence[float] | None = None,
        console: Console | None = None,
        enabled: bool = True,
        clock: Callable[[], float] = time.perf_counter,
    ) -> None:
        self._steps = list(steps)
        shares = list(weights) if weights is not None else [1.0] * len(self._steps)
        self._weights = [share / sum(shares) for share in shares]
        self._clock = clock
        self._start = clock()
        self._start_fraction: float | None = None
        self._enabled = enabled
        console = console or Console()
        self._bar: Bar | None = None
        self._task = TaskID(0)
        if enabled and console.is_terminal:
            columns = (
                TextColumn("{task.description}"),
                BarColumn(),
                TextColumn("{task.fields[left]}"),
            )
            self._bar = Bar(*columns, console=console, transient=True)
            self._task = self._bar.add_task("starting", total=1.0, left="")
            self._bar.start()

    def fraction(self, step: str, share: float) -> float:
        """Fraction of the whole run that is done when `share` (0..1) of a step is."""
        position = self._steps.index(step)
        return sum(self._weights[:position]) + self._weights[position] * min(max(share, 0.0), 1.0)

    def seconds_left(self, fraction: float) -> float | None:
        """Estimate of the seconds left, from the time this run took so far (s)."""
        if self._start_fraction is None or fraction <= self._start_fraction:
            return None
        pace = (self._clock() - self._start) / (fraction - self._start_fraction)
        return pace * (1.0 - fraction)

    def resume(self, step: str, share: float) -> None:
        """Tell where a resumed run starts, so that the estimate counts only what it does itself."""
        self._start_fraction = self.fraction(step, share)
        self._start = self._clock()

    def increment(self, row: HistoryRow, share: float) -> None:
        """Say that an increment has converged.

        Args:
            row: Its row of the history.
            share: How much of its step is done now, 0..1.
        """
        if not self._enabled:
            return
        if self._start_fraction is None:
            self._start_fraction = 0.0
        done = self.fraction(row.step, share)
        left = describe(done, self.seconds_left(done))
        if self._bar is None:
            LOGGER.info("%s | %s", increment_line(row), left)
        else:
            LOGGER.info("%s", increment_line(row))
            self._bar.update(self._task, completed=done, description=row.step, left=left)

    def finish(self, phases: Mapping[str, PhaseCost]) -> None:
        """Remove the bar and print the table of time per phase."""
        if self._bar is not None:
            self._bar.stop()
            self._bar = None
        if self._enabled and phases:
            LOGGER.info("%s", phase_table(phases))


def increment_line(row: HistoryRow) -> str:
    """One line, units named: `pull  12 | strain 0.600 % | force 31.20 kN | ...`."""
    parts = [f"{row.step} {row.increment:4d}"]
    if row.rope_strain is not None:
        parts.append(f"strain {100 * row.rope_strain:.3f} %")
    if row.travel is not None:
        parts.append(f"travel {row.travel:.2f} mm")
    if row.run:
        parts.append(f"run {row.run:.2f} mm")
    if row.force is not None:
        parts.append(f"force {in_newtons(1e3 * row.force)}")
    parts.append(f"Newton {row.newton_iterations:2d}")
    parts.append(f"contact elements {row.contact_elements}")
    parts.append(f"penetration {100 * row.penetration_over_radius:.2f} % of radius")
    parts.append(f"{row.seconds:.1f} s")
    return " | ".join(parts)


def in_newtons(force: float) -> str:
    """`31.20 kN`, and below one of them `312.0 N`."""
    return f"{1e-3 * force:.2f} kN" if abs(force) >= 1e3 else f"{force:.1f} N"


def describe(fraction: float, seconds: float | None) -> str:
    """`45 % done, about 2 min left`."""
    text = f"{100 * fraction:.0f} % done"
    if seconds is None:
        return text
    if seconds < 90:
        return f"{text}, about {seconds:.0f} s left"
    return f"{text}, about {seconds / 60:.0f} min left"


def phase_table(phases: Mapping[str, PhaseCost]) -> str:
    """Table of seconds, increments, iterations and solves per phase, as plain text."""
    table = Table(title="Time per phase", title_justify="left")
    table.add_column("phase")
    headings = ("seconds", "share (%)", "increments", "Newton iterations", "linear solves")
    for heading in headings:
        table.add_column(heading, justify="right")
    total = PhaseCost()
    for cost in phases.values():
        total.seconds += cost.seconds
        total.increments += cost.increments
        total.newton_iterations += cost.newton_iterations
        total.linear_solves += cost.linear_solves
    for name, cost in [*phases.items(), ("all", total)]:
        share = 100 * cost.seconds / total.seconds if total.seconds else 0.0
        counts = (cost.increments, cost.newton_iterations, cost.linear_solves)
        if name == "all":
            table.add_section()
        table.add_row(name, f"{cost.seconds:.1f}", f"{share:.0f}", *map(str, counts))
    plain = Console(file=io.StringIO(), width=100, color_system=None)
    with plain.capture() as capture:
        plain.print(table)
    return capture.get().rstrip()
