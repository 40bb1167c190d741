"""Elements that are turned inside out are told from those that are bent."""

import numpy as np
import pytest

from braidx.rods import Beam, NotConverged, Rods, YarnMaterial, straight
from braidx.rods.folded import refuse_folded, refuse_kinked
from braidx.solver.trial import Diverged

STEEL = YarnMaterial.isotropic(1000.0, 0.3)


@pytest.mark.parametrize("degree", [1, 2])
def test_ring_is_not_folded_but_a_kink_is(degree: int) -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 12 * degree + 1)[:-1]
    ring = 10.0 * np.stack([np.cos(angle), np.sin(angle), 0.1 * angle], axis=1)
    line = ring[: 10 * degree + 1]
    rods = Rods([Beam(line, 0.1, STEEL, degree=degree)])
    refuse_folded(rods.layout, rods.q)
    q = rods.q.copy()
    node = 4 * degree
    positions = rods.layout.unknowns(0, [node, node + 1])[:, :3]
    q[positions[0]] += 1.5 * (q[positions[1]] - q[positions[0]])
    with pytest.raises(Diverged, match="rod 0 is folded at its node"):
        refuse_folded(rods.layout, q)


def test_a_thin_rod_is_rolled_up_without_a_fold() -> None:
    # In three increments the last one ended with elements inside out, without a word, and 4 % of the length off.
    line = straight((0, 0, 0), (1000, 0, 0), 64)
    rods = Rods([Beam(line, 0.1, STEEL)])
    rods.clamp(0, 0)
    rods.couple(0, -1, (0.0, 0.0, 2.0 * np.pi * 1000.0 * np.pi * 0.1**4 / 4.0 / 1000.0))
    try:
        rods.solve(3)
    except NotConverged:
        return
    assert np.linalg.norm(rods.positions(0)[-1]) < 0.01


def test_a_bend_that_gathers_between_two_nodes_is_a_kink() -> None:
    line = straight((0, 0, 0), (100, 0, 0), 20)
    rods = Rods([Beam(line, 5.0, STEEL)])

    def bent(turns: np.ndarray) -> np.ndarray:
        q, angle = rods.q.copy(), np.append(0.0, np.cumsum(turns))
        normal = np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=1)
        across = np.stack([-np.sin(angle), np.cos(angle), 0.0 * angle], axis=1)
        unknowns = rods.layout.unknowns(0, slice(None))
        q[unknowns[:, 3:6]] = across
        q[unknowns[:, 6:9]] = np.cross(normal, across)
        return q

    even = np.full(20, 0.1)
    refuse_kinked(rods.layout, bent(8.0 * even))
    refuse_kinked(rods.layout, bent(np.where(np.arange(20) < 10, 8.0, 1.0) * even))
    even[7] = 0.8
    with pytest.raises(Diverged, match="rod 0 is kinked after its node 7"):
        refuse_kinked(rods.layout, bent(even))


@pytest.mark.parametrize(("slenderness", "increments"), [(30, 3), (100, 1)])
def test_a_thick_rod_is_rolled_up_without_a_kink(slenderness: int, increments: int) -> None:
    """It stopped with 33 and with 84 degrees between two nodes, its tip off by a tenth and a quarter of its length."""
    radius = 1000.0 / slenderness
    rods = Rods([Beam(straight((0, 0, 0), (1000, 0, 0), 64), radius, STEEL)])
    rods.clamp(0, 0)
    rods.couple(0, -1, (0.0, 0.0, 2.0 * np.pi * 1000.0 * np.pi * radius**4 / 4.0 / 1000.0))
    rods.solve(increments)
    assert np.linalg.norm(rods.positions(0)[-1]) < 45.0
