"""Rigid groups of nodes: held, moved, turning freely, loaded; against statics of cables between rigid plates."""

import numpy as np
import pytest
from scipy.optimize import fsolve
from scipy.spatial.transform import Rotation

from braidx.rods import Beam, Cable, Rods, Solid, YarnMaterial, straight

STIFFNESS, LENGTH, ARM = 1e5, 50.0, 5.0
CORNERS = ARM * np.array([[1.0, 0.0], [-0.5, 0.8], [-0.5, -0.8]])
SOFT = YarnMaterial.isotropic(1e3, 0.3)


def test_three_cables_share_a_load_off_centre():
    """Statics: sum T = F, sum T r = F r_F."""
    lines = [straight((0, *at), (LENGTH, *at), 2) for at in CORNERS]
    rods = Rods([Cable(x, 0.5, STIFFNESS, tension=1.0) for x in lines])
    for rod in range(3):
        rods.pin(rod, 0)
    load, at = 9.0, np.array([0.7, -0.4])
    group = rods.rigid([(rod, -1) for rod in range(3)], centre=(LENGTH, *at))
    rods.force(group, 0, (load, 0.0, 0.0))
    rods.solve()
    statics = np.linalg.solve(np.vstack([np.ones(3), CORNERS.T]), load * np.append(1.0, at))
    # The plate tilts by strains of 1e-4.
    assert [rods.tension(rod)[0] for rod in range(3)] == pytest.approx(statics, rel=1e-3)
    assert rods.reaction(group, 0)[0] == pytest.approx(np.zeros(3), abs=1e-6)


def skew_cables(turn, **options):
    """Three cables between two rigid plates about z, the upper one turned; the plates' numbers are 3 and 4."""
    below = np.column_stack([CORNERS, np.zeros(3)])
    above = Rotation.from_rotvec([0, 0, turn]).apply(below) + [0, 0, LENGTH]
    lines = [straight(a, b, 2) for a, b in zip(below, above, strict=True)]
    rods = Rods([Cable(x, 0.5, STIFFNESS, **options) for x in lines], contact=False)
    plates = [rods.rigid([(rod, end) for rod in range(3)]) for end in (0, -1)]
    assert plates == [3, 4]
    rods.clamp(3, 0)
    return rods


def pull(height, turn, rest):
    """Axial force and torque of cables between plates (exact), N and N mm."""
    arms = (CORNERS**2).sum(axis=1)
    length = np.sqrt(height**2 + 2.0 * arms * (1.0 - np.cos(turn)))
    force = STIFFNESS * (length / rest - 1.0)
    return (force * height / length).sum(), (force * arms * np.sin(turn) / length).sum()


@pytest.mark.parametrize("way", [(0.0, 0.0, 0.2), (0.0, 0.0, 0.0)])
def test_prescribed_pull_and_turn_of_a_plate(way):
    turn, more = 0.6, 0.3
    rods = skew_cables(turn)
    rest = [np.linalg.norm(x.line[-1] - x.line[0]) for x in rods.rods]
    rods.clamp(4, 0)
    rods.move(4, 0, by=way, turn=(0, 0, more))
    rods.solve()
    force, moment = rods.reaction(4, 0)
    axial, torque = pull(LENGTH + way[2], turn + more, np.array(rest))
    assert [force[2], moment[2]] == pytest.approx([axial, torque], rel=1e-6)
    held = rods.reaction(3, 0)
    assert held[0] == pytest.approx(-force, rel=1e-6, abs=1e-6)


def test_a_plate_that_may_turn_goes_where_its_torque_and_pull_are_those_asked_for():
    """About its axis only: pull-turn coupling of cables, solved by fsolve."""
    turn, load, torque = 0.6, 400.0, 150.0
    rods = skew_cables(turn)
    rest = np.array([np.linalg.norm(x.line[-1] - x.line[0]) for x in rods.rods])
    rods.hold(4, 0, [0, 1, *range(9, 12)])
    rods.force(4, 0, (0.0, 0.0, load))
    rods.couple(4, 0, (0.0, 0.0, torque))
    rods.solve(increments=4)
    height, angle = fsolve(
        lambda x: np.subtract(pull(*x, rest), (load, torque)), (LENGTH, turn), xtol=1e-12
    )
    assert rods.positions(4)[0, 2] == pytest.approx(height, rel=1e-6)
    g1 = rods.directors(4)[0, 0]
    assert np.arctan2(g1[1], g1[0]) == pytest.approx(angle - turn, abs=1e-5)
    assert rods.reaction(4, 0)[1][2] == pytest.approx(0.0, abs=1e-5)
    assert np.linalg.norm(rods.directors(4)[0], axis=1) == pytest.approx(np.ones(3), abs=1e-5)


def test_a_twisted_strand_that_may_turn_has_no_torque():
    """It opens to parallel cables: a turn of 0.6."""
    rods = skew_cables(0.6)
    rods.hold(4, 0, [0, 1, *range(9, 12)])
    rods.force(4, 0, (0.0, 0.0, 100.0))
    rods.solve(increments=4)
    assert rods.reaction(3, 0)[1][2] == pytest.approx(0.0, abs=1e-4)
    ends = np.array([rods.positions(rod)[[0, -1], :2] for rod in range(3)])
    assert ends[:, 0] == pytest.approx(ends[:, 1], abs=1e-4)


@pytest.mark.parametrize("model", [Beam, Solid])
def test_a_group_at_an_arm_bends_a_cantilever(model):
    """A force off the centre line bends by its moment, which is constant: a clamp of F and F e."""
    rods = Rods([model(straight((0, 0, 0), (20, 0, 0), 4), 1.0, SOFT)])
    rods.clamp(0, 0)
    arm, load = 3.0, 0.02
    group = rods.rigid([(0, -1)], centre=(20.0, arm, 0.0))
    rods.force(group, 0, (load, 0.0, 0.0))
    rods.solve()
    force, moment = rods.reaction(0, 0)
    bent = rods.positions(group)[0]  # the arm as it is now
    assert force == pytest.approx([-load, 0.0, 0.0], abs=1e-6)
    assert moment == pytest.approx(-np.cross(bent, [load, 0.0, 0.0]), rel=1e-5, abs=1e-7)
    if model is Beam:
        turned = np.linalg.norm(rods.directors(group)[0] - np.eye(3), axis=1).max()
        # EI v'' = F (e + v - v(L)): the slope at the end is e k tanh(k L), k^2 = F / EI.
        k = np.sqrt(load / (1e3 * np.pi / 4.0))
        assert turned == pytest.approx(arm * k * np.tanh(k * 20.0), rel=1e-4)


@pytest.mark.parametrize("count, idle", [(1, True), (2, True), (3, False)])
def test_groups_that_may_spin_idly_are_refused(count, idle):
    """Of ends of cables: one, two on a line, three that are not."""
    lines = [straight((0, *at), (LENGTH, *at), 2) for at in CORNERS[:count]]
    rods = Rods([Cable(x, 0.5, STIFFNESS, tension=1.0) for x in lines])
    for rod in range(count):
        rods.pin(rod, 0)
    group = rods.rigid([(rod, -1) for rod in range(count)])
    rods.force(group, 0, (9.0, 0.0, 0.0))
    if idle:
        with pytest.raises(ValueError, match=f"the rigid group {group} can turn without moving"):
            rods.solve()
        rods.hold(group, 0, slice(3, 12))
    rods.solve()
    assert sum(rods.tension(rod)[0] for rod in range(count)) == pytest.approx(9.0, rel=1e-5)


def test_bad_groups_are_named():
    def rods():
        lines = [straight((0, y, 0), (9, y, 0), 4) for y in (0.0, 3.0)]
        return Rods([Beam(x, 1.0, SOFT) for x in lines])

    with pytest.raises(ValueError, match="places is empty"):
        rods().rigid([])
    with pytest.raises(ValueError, match="a node is named twice"):
        rods().rigid([(0, [0, -1]), (0, 4)])
    with pytest.raises(IndexError, match="rod 2: there are rods 0 to 1"):
        rods().rigid([(2, 0)])
    with pytest.raises(ValueError, match="axis is .*: give a direction"):
        rods().rigid([(0, 0)], axis=(0, 0, 0))
    scene = rods()
    scene.pin(0, 0)
    with pytest.raises(ValueError, match="node 0 of rod 0 is held: put the group in its place"):
        scene.rigid([(0, [-1, 0])])
    scene.hold_mean([(1, 2), (1, 3)])
    with pytest.raises(ValueError, match="node 2 of rod 1 is held"):
        scene.rigid([(1, 2)])
    scene.rigid([(1, 4)])
    with pytest.raises(ValueError, match="node 4 of rod 1 is part of a joint or a rigid group"):
        scene.rigid([(0, 4), (1, -1)])
    with pytest.raises(ValueError, match="node 4 of rod 1 follows a rigid group or a joint"):
        scene.clamp(1, [0, -1])
    with pytest.raises(IndexError, match="rods 0 to 1, rigid groups and joints to 2"):
        scene.clamp(3, 0)
    solid = Rods([Solid(straight((0, 0, 0), (9, 0, 0), 4), 1.0, SOFT)])
    with pytest.raises(ValueError, match="node 2 of rod 0 cannot be held"):
        solid.rigid([(0, 2)])
