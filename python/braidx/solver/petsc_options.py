"""Options in PETSc's table, which is one for all solvers of a process."""

from __future__ import annotations

from collections.abc import Mapping

from petsc4py import PETSc

PREFIX = "braidx_"  # of all options

_given: dict[str, object] = {}


def set_options(values: Mapping[str, object], own: Mapping[str, object] | None = None) -> None:
    """Replaces the options given to PETSc: those of an earlier solver do not stay.

    PETSc tells at its end which options nobody asked for since they were set. So those that stay are left alone, and
    the solver's own, which the user did not set, are asked for here.

    Args:
        values: The user's, without prefix.
        own: The solver's; the user's prevail.
    """
    own = own or {}
    wanted = {**own, **values}
    options = PETSc.Options(PREFIX)
    for key in [key for key in _given if key not in wanted]:
        options.delValue(key)
        del _given[key]
    for key, value in wanted.items():
        if _given.get(key) != value:
            options[key] = value
        if key in own:
            options.getString(key)
    _given.update(wanted)
