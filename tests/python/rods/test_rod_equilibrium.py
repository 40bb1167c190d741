"""What can be asked of the forces of rods: reactions, what is not balanced, what acts from outside."""

import numpy as np
import pytest

from braidx.rods import Beam, Cable, NotConverged, Rods, Scheme, YarnMaterial, straight

SOFT = YarnMaterial.isotropic(1000.0, 0.3)


def cantilever(**options):
    return Rods([Beam(straight((0, 0, 0), (20, 0, 0), 8), 1.0, SOFT, **options)])


def test_reactions_of_several_nodes_are_those_of_each():
    rods = cantilever()
    rods.clamp(0, [0, -1])
    rods.line_load(0, (0.0, 0.0, -0.5))
    rods.solve(2)
    forces, moments = rods.reactions(0, [0, 3, -1])
    for row, node in enumerate((0, 3, -1)):
        force, moment = rods.reaction(0, node)
        assert forces[row] == pytest.approx(force) and moments[row] == pytest.approx(moment)
    assert forces[:, 2] == pytest.approx([5.0, 0.0, 5.0], abs=1e-6)
    assert moments[0, 1] == pytest.approx(-moments[2, 1]) and abs(moments[0, 1]) > 1.0
    assert len(rods.reactions(0)[0]) == 9


def test_nothing_is_left_unbalanced_in_equilibrium_and_much_beside_it():
    rods = cantilever()
    rods.clamp(0, 0)
    rods.force(0, -1, (0.0, 0.0, 1.0))
    rods.solve(2)
    assert np.abs(rods.residual()).max() < 1e-5
    rods.q = rods.q.copy()
    rods.q[rods.layout.unknowns(0, -1)[0, 2]] += 0.1
    assert np.abs(rods.residual()).max() > 0.1


def test_external_forces_and_moments_cancel():
    rods = cantilever()
    rods.clamp(0, 0)
    rods.force(0, -1, (0.0, 0.0, 1.0))
    rods.couple(0, 4, (0.0, 3.0, 0.0))
    rods.solve(2)
    forces, state = rods.external_forces().reshape(-1, 3, 3), rods.q.reshape(-1, 3, 3)
    assert forces[:, 0].sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-6)
    assert np.cross(state, forces).sum(axis=(0, 1)) == pytest.approx(np.zeros(3), abs=1e-5)
    assert forces[-1, 0] == pytest.approx([0.0, 0.0, 1.0], abs=1e-6)


def test_a_mean_that_is_held_pulls_at_all_its_nodes():
    ends = [straight((0, y, 0), (10, y, 0), 4) for y in (0.0, 5.0)]
    rods = Rods([Cable(line, 0.5, 1e3, tension=10.0) for line in ends], contact=False)
    for rod in (0, 1):
        rods.pin(rod, 0)
    group = rods.hold_mean([(0, -1), (1, -1)])
    rods.move_mean(group, by=(1.0, 0.0, 0.0))
    rods.solve(1)
    assert np.abs(rods.residual()).max() < 1e-5
    pulls = [rods.reactions(rod, -1)[0][0, 0] for rod in (0, 1)]
    assert pulls == pytest.approx([rods.tension(rod)[-1] for rod in (0, 1)], rel=1e-6)


def test_after_a_failure_loads_are_those_of_the_last_equilibrium():
    rods = cantilever()
    rods.clamp(0, [0, -1])
    rods.force(0, [0], (0.0, 0.0, -7.0))
    rods.move(0, -1, by=(-35.0, 0.0, 0.0))
    with pytest.raises(NotConverged):
        rods.solve(1, max_cuts=1)
    assert rods.reaction(0, 0)[0] == pytest.approx(np.zeros(3), abs=1e-6)


def test_reactions_in_motion_are_what_changes_the_momentum():
    """A held end that is accelerated: with an inertia of its own."""
    rods = cantilever(density=1e-3)
    rods.clamp(0, 0)
    rods.move(0, 0, by=(0.0, 0.0, 1.0))
    momenta, pulls = [0.0], []
    mass, z = rods.layout.mass, rods.layout.unknowns(0, slice(None))[:, 2]

    def see(step):
        velocity = rods._inertia.velocity
        momenta.append(float(mass[z] @ velocity[z]))
        pulls.append(rods.reaction(0, 0)[0][2])

    rods.run(1.0, 0.1, scheme=Scheme.backward_euler(), observe=see)
    assert pulls == pytest.approx(np.diff(momenta) / 0.1, rel=1e-6)
