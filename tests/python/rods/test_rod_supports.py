"""Nodes and means that are held, and how they move."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from braidx.rods import Beam, Cable, Rods, YarnMaterial, straight

LINE = straight((0, 0, 0), (10, 0, 0), 4)
BEAM = Beam(LINE, 0.5, YarnMaterial.isotropic(1e3, 0.3))
TURN = np.array([0.1, 0.3, -0.2])


@pytest.fixture
def rods():
    rods = Rods([BEAM])
    rods.clamp(0, [0, -1])
    return rods


def end(rods):
    """Position and directors of the last node."""
    return rods.positions(0)[-1], rods.directors(0)[-1]


def test_turn_of_a_node_about_itself(rods):
    _, directors = end(rods)
    rods.move(0, -1, by=(0.1, 0.0, 0.2), turn=TURN)
    rods.solve(increments=2)
    position, turned = end(rods)
    assert position == pytest.approx(LINE[-1] + [0.1, 0.0, 0.2])
    assert turned == pytest.approx(Rotation.from_rotvec(TURN).apply(directors))


def test_turn_about_a_point_comes_before_the_displacement(rods):
    about, turn = np.array([8.0, 1.0, 0.0]), Rotation.from_rotvec(TURN)
    _, directors = end(rods)
    rods.move(0, -1, by=(0.1, 0.0, 0.2), turn=TURN, about=about)
    rods.solve(increments=2)
    position, turned = end(rods)
    assert position == pytest.approx(about + turn.apply(LINE[-1] - about) + [0.1, 0.0, 0.2])
    assert turned == pytest.approx(turn.apply(directors))


def test_motions_follow_each_other(rods):
    _, directors = end(rods)
    first, second = np.array([0.3, 0.0, 0.0]), np.array([0.0, 0.2, 0.0])
    rods.move(0, -1, turn=first)
    rods.move(0, -1, turn=second)
    rods.solve(increments=2)
    turn = Rotation.from_rotvec(second) * Rotation.from_rotvec(first)
    assert end(rods)[1] == pytest.approx(turn.apply(directors))
    rods.solve()  # and are done once
    assert end(rods)[1] == pytest.approx(turn.apply(directors))


def test_free_nodes_cannot_be_moved():
    rods = Rods([BEAM])
    rods.clamp(0, 0)
    with pytest.raises(ValueError, match="is free to go elsewhere"):
        rods.move(0, -1, by=(0.1, 0.0, 0.0))
    rods.pin(0, -1)
    rods.move(0, -1, by=(0.1, 0.0, 0.0))
    with pytest.raises(ValueError, match="is free to go elsewhere"):
        rods.move(0, -1, turn=TURN)


def test_only_components_that_move_have_to_be_held():
    rods = Rods([Cable(LINE, 0.5, 1e3, tension=1.0)])
    rods.pin(0, 0)
    rods.hold(0, -1, [0])
    rods.hold(0, components=[2])
    rods.move(0, -1, by=(0.1, 0.0, 0.0))
    rods.solve()
    assert rods.positions(0)[-1] == pytest.approx(LINE[-1] + [0.1, 0, 0])


def test_what_is_released_is_free(rods):
    rods.move(0, -1, by=(0.1, 0.0, 0.0))
    rods.solve()
    rods.release(0, -1)
    rods.solve()
    assert rods.positions(0)[-1] == pytest.approx(LINE[-1], abs=1e-6)


def test_means_are_held_and_moved():
    """Two cables, one twice as stiff, pulled by the mean of their ends: it goes where it is asked to go."""
    lines = [LINE, LINE + [0, 3, 0]]
    rods = Rods([Cable(lines[0], 0.5, 1e3, 1.0), Cable(lines[1], 0.5, 2e3, 2.0)])
    for rod in (0, 1):
        rods.pin(rod, 0)
    rods.hold(0, -1, [1, 2])
    group = rods.hold_mean([(0, -1), (1, -1)])
    rods.solve()

    def ends():
        return np.array([rods.positions(rod)[-1] for rod in (0, 1)])

    assert ends().mean(axis=0) == pytest.approx([10.0, 1.5, 0.0])
    rods.move_mean(group, (0.3, 0.0, 0.0))
    rods.solve(increments=2)
    assert ends().mean(axis=0) == pytest.approx([10.3, 1.5, 0.0])
    # The mean takes as much from both: the stiffer cable is stretched less.
    pulls = [rods.tension(rod)[-1] for rod in (0, 1)]
    assert pulls[0] == pytest.approx(pulls[1], rel=1e-5)
