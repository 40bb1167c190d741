"""A sheave on a bearing without friction: it turns as the rope takes it along."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from mpi4py.MPI import SUM

from ...contact.contact import Contact
from ...solver.increment import Increment
from ...solver.trial import Diverged
from ...system.constraints import Floats

BALANCED = 0.01  # moment that may be left, over that of friction forces which all go one way
GROWTH = 4.0  # of the turn, until the moment changes its sign
MOST = 24  # turns tried in an increment


def friction_moment(
    contact: Contact, q: Floats, centre: Floats, axis: Floats
) -> tuple[float, float]:
    """Moment of friction on the rope about the axis of a sheave, the only rigid surface, N mm, of all processes.

    Returns:
        The moment, and what it would be if all forces had the same sense.
    """
    found = contact.results(q)
    on_sheave = found["tubes"][:, 1] < 0
    arms = found["position"][on_sheave] - centre
    moments = np.cross(arms, found["friction_force"][on_sheave]) @ axis
    both = np.array([moments.sum(), np.abs(moments).sum()])
    contact.comm.Allreduce(both.copy(), both, op=SUM)
    return float(both[0]), float(both[1])


def balanced(
    solve: Callable[[float], Increment],
    moment: Callable[[Increment], tuple[float, float]],
    turn: float,
    first_step: float,
) -> tuple[Increment, float]:
    """The turn of the sheave in an increment that leaves it no moment; the moment grows with the turn.

    False position (Illinois) between turns on either side of the balance.

    Args:
        solve: Equilibrium with the sheave turned by an angle (radians), from the same start each time.
        moment: Of friction in it, and what may be left of it, N mm.
        turn: First guess, radians.
        first_step: Change of the turn that is tried next, radians.
    Returns:
        The increment and the turn.
    Raises:
        Diverged: If one of the equilibria, or the balance, is not found.
    """
    low: tuple[float, float] | None = None
    high: tuple[float, float] | None = None
    last = 0
    for tried in range(MOST):
        increment = solve(turn)
        value, allowed = moment(increment)
        if abs(value) <= allowed:
            return increment, turn
        side = 1 if value > 0.0 else -1
        if side > 0:
            high = (turn, value)
            low = (low[0], low[1] / 2.0) if low and last == side else low
        else:
            low = (turn, value)
            high = (high[0], high[1] / 2.0) if high and last == side else high
        last = side
        if low and high:
            turn = (low[0] * high[1] - high[0] * low[1]) / (high[1] - low[1])
        else:
            turn -= side * first_step * GROWTH**tried
    raise Diverged(
        f"the sheave finds no balance: {value:.3g} N mm are left after {MOST} turns, {allowed:.3g} may be",
        increment.iterations,
        increment.linear_solves,
    )
