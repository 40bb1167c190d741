"""Writes docs/stability.md when all families have been computed in this run."""

from __future__ import annotations

import pytest


def pytest_collection_finish(session: pytest.Session) -> None:
    """All scenes that are asked for are begun at once: no process waits for the last of a family."""
    from families import FAMILIES
    from family import begun

    if session.config.option.collectonly:
        return
    asked = [getattr(item, "callspec", None) for item in session.items]
    families = [called.params.get("family") for called in asked if called]
    for family in FAMILIES:
        if family in families:
            begun(family)


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    """A run of a part of the tests keeps its outcomes, and leaves the page alone."""
    from families import FAMILIES
    from family import DONE
    from report import keep, write

    if DONE:
        keep(DONE)
    if all(family.name in DONE for family in FAMILIES):
        write(FAMILIES, DONE)
