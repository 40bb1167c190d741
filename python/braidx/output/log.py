"""run.log and the console: one logger, `braidx`, quiet on all ranks but the first."""

from __future__ import annotations

import logging
from pathlib import Path

from rich.console import Console

LOGGER = logging.getLogger("braidx")


class _ConsoleHandler(logging.Handler):
    """Prints through the rich console, so that lines and a live progress bar do not collide."""

    def __init__(self, console: Console) -> None:
        super().__init__(logging.INFO)
        self._console = console

    def emit(self, record: logging.LogRecord) -> None:
        style = "yellow" if record.levelno >= logging.WARNING else None
        self._console.print(self.format(record), style=style, markup=False, highlight=False)


def open_log(out_dir: Path, console: Console, rank: int = 0, append: bool = False) -> None:
    """Send the logger's messages to `out_dir/run.log` (with times) and to the console.

    Args:
        out_dir: Existing output folder of the run.
        console: The console that `Progress` uses too.
        rank: MPI rank; only rank 0 logs.
        append: Continue an existing log (a resume) instead of starting a new one.
    """
    close_log()
    LOGGER.propagate = False
    LOGGER.setLevel(logging.DEBUG)
    if rank != 0:
        LOGGER.addHandler(logging.NullHandler())
        return
    file = logging.FileHandler(out_dir / "run.log", mode="a" if append else "w", encoding="utf-8")
    file.setFormatter(logging.Formatter("%(asctime)s %(levelname)-7s %(message)s"))
    LOGGER.addHandler(file)
    LOGGER.addHandler(_ConsoleHandler(console))


def close_log() -> None:
    """Close the handlers of `open_log`."""
    for handler in list(LOGGER.handlers):
        LOGGER.removeHandler(handler)
        handler.close()
