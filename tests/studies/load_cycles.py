"""What each cycle of a rope that is pulled and released time after time does (paper 1, 4.3.2)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from pulled_values import Curve, straight_line

from braidx.output.measures import linear_fit


@dataclass(frozen=True)
class LoadCycle:
    """One cycle, from the least force to the largest and back.

    Attributes:
        loading, unloading: Its two branches.
        before: Strain that the first cycle started from, -.
    """

    loading: Curve
    unloading: Curve
    before: float

    @property
    def hysteresis(self) -> float:
        """Work done on the rope, J per metre of it: the area between the branches."""
        work = sum(
            float(np.trapezoid(branch.force, branch.strain))
            for branch in (self.loading, self.unloading)
        )
        return 1e3 * work

    @property
    def pulled(self) -> float:
        """Work done on the rope as it is pulled, J per metre."""
        return 1e3 * float(np.trapezoid(self.loading.force, self.loading.strain))

    @property
    def friction_work(self) -> float:
        """Dissipated by friction, mJ of the sample."""
        return float(self.unloading.friction_work[-1] - self.loading.friction_work[0])

    @property
    def residual_strain(self) -> float:
        """Strain at the least force when the cycle ends, from where the first one started, -."""
        return float(self.unloading.strain[-1]) - self.before

    @property
    def stiffness(self) -> float:
        """Slope of the upper half of the loading branch, kN."""
        return linear_fit(self.loading.strain, self.loading.force).stiffness

    @property
    def linearity(self) -> float:
        """R^2 of a straight line through the whole loading branch, -."""
        return straight_line(self.loading.strain, self.loading.force).r_squared


def load_cycles(curve: Curve) -> list[LoadCycle]:
    """The whole cycles of a curve that starts at the least force; what is pulled beyond them is left out.

    Raises:
        ValueError: If there is none.
    """
    turns = turning_points(curve)
    found = [
        LoadCycle(
            curve.part(turns[k], turns[k + 1]),
            curve.part(turns[k + 1], turns[k + 2]),
            float(curve.strain[0]),
        )
        for k in range(0, len(turns) - 2, 2)
    ]
    if not found:
        raise ValueError("load cycles: the rope was never released; give it a step of kind cycle.")
    return found


def turning_points(curve: Curve) -> list[int]:
    """Increments at which the rope starts, turns from being pulled to being released or back, and ends."""
    moved = np.flatnonzero(np.diff(curve.strain) != 0.0)
    sense = np.sign(np.diff(curve.strain)[moved])
    turns = moved[1:][sense[1:] != sense[:-1]]
    return [0, *(int(turn) for turn in turns), len(curve.strain) - 1]
