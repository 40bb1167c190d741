"""Cables: tension, change of properties and of the reference."""

import numpy as np
import pytest
from example_bodies import cached_body, dense_tangent, make_body, random_state
from mpi4py import MPI

from braidx.bodies import CableBody


def test_tension_of_a_stretched_line():
    line = np.linspace([0.0, 0.0, 0.0], [0.0, 0.0, 4.0], 5)
    body = CableBody(MPI.COMM_SELF, [line], axial_stiffness=100.0, tension=5.0, area=2.0)
    assert body.tension(1.1 * line) == pytest.approx(np.full(4, 15.0))
    assert body.axial_stress(1.1 * line) == pytest.approx(np.full(4, 7.5))
    assert body.rest_lengths() == pytest.approx(np.ones(4))
    assert body.energy() == pytest.approx(4.0 * (5.0 * 0.1 + 0.5 * 100.0 * 0.01))


def test_a_taut_cable_has_the_tension_of_a_bar_and_a_slack_one_none():
    line = np.linspace([0.0, 0.0, 0.0], [0.0, 0.0, 4.0], 5)
    body = CableBody(MPI.COMM_SELF, [line], axial_stiffness=1e5)
    strains = np.array([-1e-2, -1e-7, 1e-7, 1e-6, 1e-4, 5e-3])
    tension = np.array([body.tension((1.0 + strain) * line)[0] for strain in strains])
    assert not tension[:2].any()
    assert tension[2:] == pytest.approx(1e5 * strains[2:], rel=1e-8)


@pytest.mark.parametrize("degree", [1, 2])
def test_a_slack_cable_carries_no_force_and_yet_can_be_solved_for(degree):
    body = make_body("cable", degree)
    body.set_properties(tension=0.0)
    body.set_state(0.9 * body.rest)
    assert not body.residual().any()
    eigenvalues = np.linalg.eigvalsh(dense_tangent(body))
    # Nothing but motions of a whole curve in x, y or z is without stiffness: six for two curves.
    assert abs(eigenvalues[:6]).max() < 1e-10 * eigenvalues[6]


def test_tension_follows_canonical_order():
    body = cached_body("cable", 1)
    state = random_state(body)
    first, second = body.layout.elements.T
    stretch = np.linalg.norm(state[second] - state[first], axis=1) / body.rest_lengths()
    stiffness = body.layout.per_element([100.0, 150.0], "axial_stiffness")
    tension = body.layout.per_element([5.0, 7.0], "tension")
    assert body.tension(state) == pytest.approx(tension + stiffness * (stretch - 1.0))


@pytest.mark.parametrize("degree", [1, 2])
def test_new_reference_keeps_the_tension(degree):
    body = make_body("cable", degree)
    state = random_state(body, size=0.2)
    tension = body.tension(state)
    body.set_reference(state)
    assert body.tension(state) == pytest.approx(tension)
    if degree == 1:  # the tension is constant in the element: the forces are kept as well
        other = cached_body("cable", degree)
        other.set_state(state)
        body.set_state(state)
        assert body.residual() == pytest.approx(other.residual())
    body.set_properties(axial_stiffness=1e6)
    assert body.tension(state) == pytest.approx(tension, abs=1e-14 * 1e6)  # of round-off


def test_bad_input_is_named():
    line = np.linspace([0.0, 0.0, 0.0], [0.0, 0.0, 4.0], 5)
    with pytest.raises(ValueError, match="axial_stiffness"):
        CableBody(MPI.COMM_SELF, [line], axial_stiffness=0.0)
    with pytest.raises(ValueError, match="tension"):
        CableBody(MPI.COMM_SELF, [line], axial_stiffness=1.0, tension=-1.0)
    with pytest.raises(ValueError, match="centre line 0 has coinciding"):
        CableBody(MPI.COMM_SELF, [np.repeat(line, 2, axis=0)], axial_stiffness=1.0)
    with pytest.raises(ValueError, match="shape"):
        CableBody(MPI.COMM_SELF, [line[:, :2]], axial_stiffness=1.0)
    with pytest.raises(ValueError, match="area"):
        CableBody(MPI.COMM_SELF, [line], axial_stiffness=1.0).axial_stress(line)
