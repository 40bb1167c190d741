"""Faces of solids that follow beams, and cables that follow faces."""

import numpy as np
import pytest
from example_solids import bar

from braidx.bodies.coupling import follow_mean, follow_section
from braidx.meshing import round_section
from braidx.system.constraints import Constraints

MESH = bar(round_section(0.5, 8), 1.0, 1)
SWEEP = MESH.sweeps[0]
FIRST = 9  # of the solid's unknowns
FACE = FIRST + 3 * SWEEP.layers[0][:, None] + np.arange(3)


def resolve(follow, **arguments):
    """Constraint map and values of nine unknowns of an end and those of the bar."""
    constraints = Constraints(FIRST + 3 * MESH.num_nodes)
    values = np.full(constraints.num_unknowns, 7.0)
    follow(constraints, values, FACE, first_unknown=0, **arguments)
    return constraints.resolve(), values


def test_face_follows_the_section():
    mapped, values = resolve(follow_section, section=SWEEP.section)
    assert np.all(values[FACE] == 0.0) and np.count_nonzero(values) == len(values) - FACE.size
    free = np.random.default_rng(0).standard_normal(len(mapped.free))
    q = mapped.expand(free, np.where(values == 7.0, 0.0, values))
    x, g1, g2 = q[:9].reshape(3, 3)
    for node, (xi1, xi2) in zip(FACE, SWEEP.section):
        assert q[node] == pytest.approx(x + xi1 * g1 + xi2 * g2, rel=1e-14)


def test_forces_on_the_face_reach_the_node_with_their_moments():
    mapped, _ = resolve(follow_section, section=SWEEP.section)
    forces = np.zeros(mapped.transform.shape[0])
    forces[FACE] = np.random.default_rng(1).standard_normal(FACE.shape)
    node = mapped.reduce(forces)[:9].reshape(3, 3)
    assert node[0] == pytest.approx(forces[FACE].sum(axis=0), rel=1e-13)
    assert node[1:] == pytest.approx(SWEEP.section.T @ forces[FACE], rel=1e-13)


def test_cable_follows_the_mean_and_pulls_evenly():
    mapped, values = resolve(follow_mean, weights=SWEEP.weights)
    assert np.all(values[:3] == 0.0)
    free = np.random.default_rng(0).standard_normal(len(mapped.free))
    q = mapped.expand(free, 0.0 * values)
    share = SWEEP.weights / SWEEP.area
    assert q[:3] == pytest.approx(share @ q[FACE], rel=1e-13)
    pull = np.zeros(len(q))
    pull[:3] = [0.0, 0.0, 5.0]
    passed = np.zeros(len(q))
    passed[mapped.free] = mapped.reduce(pull)
    assert passed[FACE] == pytest.approx(share[:, None] * [0.0, 0.0, 5.0])


def test_errors():
    constraints = Constraints(100)
    with pytest.raises(ValueError, match=r"face_unknowns has shape \(9,\)"):
        follow_section(constraints, np.zeros(100), np.arange(9), np.zeros((3, 2)), 9)
    with pytest.raises(ValueError, match=r"section has shape \(3, 3\): give \(3, 2\)"):
        follow_section(constraints, np.zeros(100), np.arange(9).reshape(3, 3), np.zeros((3, 3)), 9)
    with pytest.raises(ValueError, match="face_unknowns has shape"):
        follow_mean(constraints, np.zeros(100), np.arange(9).reshape(3, 3), np.ones(4), 9)
