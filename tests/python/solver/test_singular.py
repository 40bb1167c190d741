"""A tangent that cannot be factorised."""

import numpy as np
import pytest

from braidx.forms.cable import SLACK
from braidx.rods import Cable, NotConverged, Rods, straight


def test_a_singular_tangent_is_told_and_leaves_the_solver_in_order():
    """A cable without tension has no stiffness across: first it finds no equilibrium, then, pulled taut, it does."""
    rods = Rods([Cable(straight((0, 0, 0), (10, 0, 0), 5), 0.1, 1e3)])
    rods.pin(0, [0, -1])
    rods.force(0, 2, (0, 1e-3, 0))
    with pytest.raises(NotConverged):
        rods.solve(max_cuts=2)
    rods.force(0, 2, (0, 0, 0))
    rods.move(0, -1, by=(0.1, 0, 0))
    rods.solve(guess=rods.layout.rest * np.tile([1.01, 1.0, 1.0], 6))
    assert rods.tension(0) == pytest.approx(np.full(5, 1e3 * (0.01 - SLACK)), rel=1e-6)
