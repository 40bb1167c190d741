"""First guesses of rods that are placed elsewhere."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from braidx.rods import Beam, Cable, Rods, YarnMaterial, straight
from braidx.rods.placed import placed

BEAM = Beam(straight((0, 0, 0), (10, 0, 0), 8), 0.5, YarnMaterial.isotropic(1e3, 0.3))


def test_directors_turn_with_the_line():
    rods = Rods([BEAM, Cable(straight((0, 5, 0), (10, 5, 0), 8), 0.5, 1e3)], contact=False)
    turn = Rotation.from_rotvec([0.0, 0.6, 0.8])  # about an axis across the line: no twist
    guess = placed(rods.layout, rods.q, {0: turn.apply(rods.positions(0)) + [1.0, 2.0, 3.0]})
    before, after = rods.q[rods.layout.unknowns(0, slice(None))], guess[:81].reshape(9, 9)
    for first in (3, 6):
        assert after[:, first : first + 3] == pytest.approx(
            turn.apply(before[:, first : first + 3])
        )
    assert guess[81:] == pytest.approx(rods.q[81:])


def test_an_equilibrium_is_found_from_where_a_rod_is_placed():
    """A cantilever turned over at its clamp, by more than increments of its own would bear at once."""
    rods = Rods([BEAM])
    rods.clamp(0, 0)
    turn = np.array([0.0, 0.0, 2.0])
    rods.move(0, 0, turn=turn)
    line = Rotation.from_rotvec(turn).apply(BEAM.line)
    found = rods.solve(1, guess={0: line}, max_cuts=0)
    assert rods.positions(0) == pytest.approx(line, abs=1e-6)
    assert found[0].iterations <= 2


def test_lines_of_another_number_of_nodes_are_refused():
    with pytest.raises(ValueError, match="guess of rod 0 has shape .5, 3.: give .9, 3."):
        Rods([BEAM]).solve(1, guess={0: np.zeros((5, 3))})
