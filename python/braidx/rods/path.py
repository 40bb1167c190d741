"""The way to what is asked for, in increments that are halved where none is found."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..output.log import LOGGER
from ..solver.increment import Increment
from ..solver.trial import Diverged
from ..system.terms import Floats

EASY = 3  # increments in a row without a cut after which halved ones are doubled again


class NotConverged(Exception):
    """No equilibrium was found. The message tells how far the way went, why, and likely cures."""


class Impossible(Diverged):
    """There is no equilibrium, however short the increment."""

    def __init__(self, reason: str) -> None:
        super().__init__(reason, 0, 0)


def follow(
    step: Callable[[float, float, Floats], Increment],
    start: Floats,
    increments: int,
    max_cuts: int,
    accept: Callable[[Increment, float], None],
) -> list[Increment]:
    """Increments from 0 to 1.

    Args:
        step: Finds the state at a share of the way from the one before; takes both shares, and how far the state goes
            on at the pace of the last increment.
        start: The state at 0.
        increments: Number of equal ones, as long as none is cut.
        max_cuts: How often one may be halved.
        accept: Called with each increment and its share before the next begins.
    Raises:
        NotConverged: If an increment fails after all cuts.
    """
    size, cuts, easy, share, q = 1.0 / increments, 0, 0, 0.0, start
    found: list[Increment] = []
    rate = np.zeros_like(start)
    while share < 1.0 - 1e-9:
        end = min(1.0, share + size / 2**cuts)
        if 1.0 - end < 1e-9:
            end = 1.0
        try:
            increment = step(share, end, (end - share) * rate)
        except Impossible as failure:
            raise NotConverged(
                f"no equilibrium at {end:.4g} of the way, after {len(found)} increments: {failure}."
            ) from failure
        except Diverged as failure:
            LOGGER.warning("increment to %.4g cut: %s", end, failure)
            cuts, easy, rate = cuts + 1, 0, np.zeros_like(start)
            if cuts > max_cuts:
                where = (
                    f"; deepest contacts between rods {failure.deepest}" if failure.pairs else ""
                )
                raise NotConverged(
                    f"no {failure.sought} at {end:.4g} of the way, after {len(found)} increments: {failure}{where}. "
                    f"Try {failure.cures}."
                ) from failure
            continue
        rate = (increment.q - q) / (end - share)
        share, q = end, increment.q
        found.append(increment)
        accept(increment, share)
        easy += 1
        if cuts and easy >= EASY and _fits(share, size / 2 ** (cuts - 1)):
            cuts, easy = cuts - 1, 0
    return found


def _fits(share: float, size: float) -> bool:
    """Whether whole increments of a size end at this share."""
    return abs(share / size - round(share / size)) < 1e-6
