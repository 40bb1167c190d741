"""Writes docs/stability.md when all families have been computed in this run."""

from __future__ import annotations

import pytest


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    """A run of a part of the tests keeps its outcomes, and leaves the page alone."""
    from families import FAMILIES
    from family import DONE
    from report import keep, write

    if DONE:
        keep(DONE)
    if all(family.name in DONE for family in FAMILIES):
        write(FAMILIES, DONE)
