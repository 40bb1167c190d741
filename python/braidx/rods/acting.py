"""Loads on rods as terms of the system."""

from __future__ import annotations

import numpy as np

from ..system.constraints import ConstraintMap
from ..system.terms import Floats, LoadTerm, Term
from .couples import CoupleTerm
from .followers import FollowerForceTerm, PressureTerm
from .layout import Layout
from .loads import Loads


class ActingLoads:
    """Terms of loads at a share of their way.

    Attributes:
        terms: All of them.
    """

    def __init__(self, layout: Layout, loads: Loads, rank: int) -> None:
        self._loads, self._layout = loads, layout
        self._dead = LoadTerm(layout.rest.size, rank)
        self._couples = CoupleTerm(loads.couples.keys[:, None] + np.arange(6), rank)
        self._followers = FollowerForceTerm(loads.followers.keys[:, None] + np.arange(9), rank)
        rods = loads.pressures.keys
        lines = [layout.unknowns(int(rod), slice(None))[:, :3] for rod in rods]
        self._pressures = PressureTerm(lines, [int(layout.degree[rod]) for rod in rods], rank)
        self.terms: list[Term] = [self._dead, self._couples, self._followers, self._pressures]

    def ask_for(self, share: float) -> None:
        """Sets loads to a share of their way."""
        self._dead.loads[:] = self._loads.at(share)
        self._couples.couples = self._loads.couples.at(share)
        self._followers.forces = self._loads.followers.at(share)
        self._pressures.pressures = self._loads.pressures.at(share)

    @property
    def dead(self) -> Floats:
        """Dead loads, shape (num_unknowns,), N."""
        return self._dead.loads

    def tell_stability(self, is_held: np.ndarray) -> bool:
        """Whether negative pivots tell of instability under these loads: forces that follow have no potential.

        Pressure has one on rings and between ends that are held.

        Args:
            is_held: Unknowns that are held, shape (num_unknowns,).
        """
        if self._followers.forces.any():
            return False
        rods = self._loads.pressures.keys[self._pressures.pressures.any(axis=1)]
        closed = self._layout.joints.rods
        ends = [self._layout.unknowns(int(rod), [0, -1])[:, :3] for rod in set(rods) - closed]
        return all(is_held[unknowns].all() for unknowns in ends)

    def moves(self, constraints: ConstraintMap) -> bool:
        """Whether loads act on anything that can move."""
        others = (self._couples.couples, self._followers.forces, self._pressures.pressures)
        return bool(constraints.reduce(self.dead).any() or any(part.any() for part in others))
