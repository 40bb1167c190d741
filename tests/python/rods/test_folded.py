"""Elements that are turned inside out are told from those that are bent."""

import numpy as np
import pytest
from scipy.optimize import brentq

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
    """It stopped with 33 and with 84 degrees between two nodes, its tip off by a tenth and a quarter of its length.

    By the law of Saint-Venant and Kirchhoff without a force, and with u = I k^2 / A of the curvature k per rest length,
    the section is narrower across the bend, g^2 = (1 - 2 u) / (1 - 8 u^2), the square of the stretch is 1 - 3 u g^2,
    and the moment EI k g^2 (1 - 4 u g^2): the couple of a full circle bends by more.
    """
    length, radius = 1000.0, 1000.0 / slenderness
    rods = Rods(
        [Beam(straight((0, 0, 0), (length, 0, 0), 64), radius, YarnMaterial.isotropic(1000.0, 0.0))]
    )
    rods.clamp(0, 0)
    turn = 2.0 * np.pi / length
    rods.couple(0, -1, (0.0, 0.0, turn * 1000.0 * np.pi * radius**4 / 4.0))
    rods.solve(increments)

    def state(ratio: float) -> tuple[float, float]:
        u = radius**2 / 4.0 * (ratio * turn) ** 2
        section = (1.0 - 2.0 * u) / (1.0 - 8.0 * u**2)
        return ratio * section * (1.0 - 4.0 * u * section), np.sqrt(1.0 - 3.0 * u * section)

    ratio = brentq(lambda ratio: state(ratio)[0] - 1.0, 1.0, 1.5)
    angle, stretch = 2.0 * np.pi * ratio, state(ratio)[1]
    tip = 2.0 * stretch * length / angle * abs(np.sin(angle / 2.0))
    assert np.linalg.norm(rods.positions(0)[-1]) == pytest.approx(tip, rel=0.02)
