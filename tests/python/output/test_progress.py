"""Progress lines, estimates, the table at the end, run.log."""

from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path

import pytest
from rich.console import Console

from braidx.output.history import HistoryRow
from braidx.output.log import LOGGER, close_log, open_log
from braidx.output.progress import Progress, describe, increment_line, phase_table
from braidx.output.summary import PhaseCost


class Clock:
    seconds = 0.0

    def __call__(self) -> float:
        return self.seconds


def row(increment: int, step: str, strain: float | None = None) -> HistoryRow:
    return HistoryRow(increment, strain, 12.345, 4, 9000, 0.01, 0.5, 1.25, step, 0.0123, 1e-3)


def test_estimate_follows_the_weights_of_the_steps() -> None:
    clock = Clock()
    progress = Progress(["form", "pull"], weights=[1, 3], enabled=False, clock=clock)
    assert progress.fraction("form", 0.5) == pytest.approx(0.125)
    assert progress.fraction("pull", 2.0) == pytest.approx(1.0)
    assert progress.seconds_left(0.5) is None
    progress.resume("pull", 0.0)
    clock.seconds = 10.0
    assert progress.seconds_left(progress.fraction("pull", 0.5)) == pytest.approx(10.0)


def test_lines_reach_console_and_log_without_a_terminal(tmp_path: Path) -> None:
    stream = io.StringIO()
    console = Console(file=stream, width=200)
    clock = Clock()
    open_log(tmp_path, console)
    progress = Progress(["form", "pull"], console=console, clock=clock)
    clock.seconds = 4.0
    progress.increment(row(1, "form"), 0.5)
    progress.finish({"form": PhaseCost(4.0, 1, 4, 4)})
    LOGGER.warning("penetration [bold] is large")
    close_log()
    text = stream.getvalue()
    assert "25 % done, about 12 s left" in text
    assert "[bold]" in text and "\x1b" not in text
    log = (tmp_path / "run.log").read_text()
    assert "Newton  4" in log and "WARNING" in log and "Time per phase" in log


def test_a_terminal_gets_a_bar_below_the_lines() -> None:
    stream = io.StringIO()
    console = Console(file=stream, width=160, force_terminal=True, force_interactive=True)
    progress = Progress(["form"], console=console)
    progress.increment(row(1, "form"), 0.5)
    progress.finish({})
    assert stream.getvalue()


def test_other_ranks_are_silent(tmp_path: Path) -> None:
    stream = io.StringIO()
    console = Console(file=stream)
    open_log(tmp_path, console, rank=1)
    progress = Progress(["form"], console=console, enabled=False)
    progress.increment(row(1, "form"), 0.5)
    progress.finish({"form": PhaseCost()})
    close_log()
    assert stream.getvalue() == "" and not list(tmp_path.iterdir())


def test_texts() -> None:
    line = increment_line(row(12, "pull", 0.006))
    assert "strain 0.600 %" in line and "force 12.35 kN" in line and "1.23 % of radius" in line
    assert "strain" not in increment_line(row(12, "form"))
    bent = increment_line(replace(row(12, "bend"), travel=12.5, force=0.0504))
    assert "travel 12.50 mm | force 50.4 N" in bent
    assert describe(0.5, 300.0) == "50 % done, about 5 min left"
    table = phase_table({"form": PhaseCost(3.0, 10, 30, 31), "pull": PhaseCost(9.0, 5, 20, 22)})
    for word in ("form", "75", "all", "12.0", "50", "53"):
        assert word in table
