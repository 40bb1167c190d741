"""Drawing one picture after the other."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from braidx.output.log import LOGGER


def draw_jobs(jobs: Mapping[Path, Callable[[Path], Path]]) -> list[Path]:
    """Draw to each path; a picture that cannot be drawn is reported and left out.

    Returns:
        The files written.
    """
    drawn = []
    for path, job in jobs.items():
        try:
            drawn.append(job(path))
        except Exception as error:  # a picture never costs the results
            LOGGER.warning("figure %s left out: %s", path.stem, error)
            LOGGER.debug("figure %s", path.stem, exc_info=True)
    return drawn
