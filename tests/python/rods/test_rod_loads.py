"""Loads along rods, at nodes and on sections."""

import numpy as np
import pytest

from braidx.rods import Beam, Cable, Rods, YarnMaterial, arc, straight
from braidx.rods.layout import nodal_lengths

MATERIAL = YarnMaterial.isotropic(1e3, 0.3)
LOAD = np.array([0.3, -0.2, 0.5])


def test_nodal_lengths_of_degree_1():
    line = np.array([[0, 0, 0], [1, 0, 0], [4, 0, 0]], dtype=float)
    assert nodal_lengths(line, 1) == pytest.approx([0.5, 2.0, 1.5])


def test_nodal_lengths_of_degree_2():
    line = straight((0, 0, 0), (12, 0, 0), 4)
    assert nodal_lengths(line, 2) == pytest.approx([1.0, 4.0, 2.0, 4.0, 1.0])


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("model", [Cable, Beam])
def test_line_load_sums_to_q_l(model, degree):
    line = arc(10.0, 1.0, 8)
    rods = Rods([model(line, 0.2, 1e3 if model is Cable else MATERIAL, degree=degree)])
    rods.pin(0, slice(None))
    rods.line_load(0, LOAD)
    rods.solve()
    length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
    held = sum(rods.reaction(0, node)[0] for node in range(9))
    assert held == pytest.approx(-LOAD * length, rel=1e-9)


def test_forces_replace_each_other_and_add_to_line_loads():
    rods = Rods([Beam(straight((0, 0, 0), (4, 0, 0), 4), 0.5, MATERIAL)])
    rods.clamp(0, 0)
    rods.line_load(0, LOAD)
    rods.force(0, -1, (9.0, 9.0, 9.0))
    rods.force(0, -1, (1.0, 0.0, 0.0))
    rods.solve()
    assert rods.reaction(0, 0)[0] == pytest.approx(-4.0 * LOAD - [1, 0, 0], rel=1e-6)
    rods.force(0, -1, (0.0, 0.0, 0.0))
    rods.line_load(0, (0.0, 0.0, 0.0))
    rods.solve()
    assert rods.positions(0) == pytest.approx(rods.rods[0].line, abs=1e-6)


def test_couple_is_held_by_the_clamp():
    rods = Rods([Beam(straight((0, 0, 0), (10, 0, 0), 8), 0.5, MATERIAL)])
    rods.clamp(0, 0)
    couple = np.array([2.0, 5.0, -3.0])
    rods.couple(0, -1, couple)
    rods.solve(increments=2)
    force, moment = rods.reaction(0, 0)
    assert moment == pytest.approx(-couple, rel=1e-6)
    assert force == pytest.approx(np.zeros(3), abs=1e-6)


def test_a_cable_takes_no_couple():
    rods = Rods([Cable(straight((0, 0, 0), (4, 0, 0), 4), 0.5, 1e3)])
    with pytest.raises(ValueError, match="rod 0 is a cable"):
        rods.couple(0, -1, (1.0, 0.0, 0.0))
