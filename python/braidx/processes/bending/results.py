"""Results of a bent rope: which numbers are taken from which state."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...output.snapshot import Snapshot
from ..state import State

if TYPE_CHECKING:
    from .model import BentRope


def bent_results(model: BentRope, state: State, picture: Snapshot) -> dict[str, float]:
    """Results of a state worth a picture."""
    return {"end_force": float(abs(model.end_forces(state.q)).mean())}
