"""The edge of stability, in seconds: what tests/stability found wrong once stays right, and frontiers stay."""

import numpy as np
import pytest

from braidx.rods import Beam, NotConverged, Rods, YarnMaterial, straight


def crossing(angle: float, element: float = 4.0, unit: float = 1.0, friction: float = 0.3) -> Rods:
    """Two clamped beams of radius `unit` that touch at an angle (degrees), elements `element` radii long."""
    half = max(40.0, 2.6 / np.sin(np.radians(angle))) * unit
    spans = 2 * round(2 * half / (element * unit))
    along = half * np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle)), 0.0])
    up, material = np.array([0.0, 0.0, 2.0 * unit]), YarnMaterial.isotropic(1000.0, 0.3)
    lines = [straight((-half, 0, 0), (half, 0, 0), spans), straight(up - along, up + along, spans)]
    rods = Rods([Beam(line, unit, material) for line in lines], friction=friction)
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    return rods


def lift(rods: Rods) -> float:
    """What holds the upper beam down, N."""
    return -float(sum(rods.reaction(1, node)[0][2] for node in (0, -1)))


def press_and_slide(rods: Rods, unit: float = 1.0, slides: int = 4) -> float:
    rods.move(1, [0, -1], by=(0.0, 0.0, -2.0 * unit))
    rods.solve(2)
    rods.move(1, [0, -1], by=(6.0 * unit, 0.0, 0.0))
    rods.solve(slides)
    return lift(rods)


@pytest.mark.parametrize("unit", [1e-6, 1e-3, 1e3])
def test_forces_do_not_depend_on_the_unit_of_length(unit: float) -> None:
    force = press_and_slide(crossing(60.0, unit=unit), unit) / unit**2
    assert force == pytest.approx(press_and_slide(crossing(60.0)), rel=1e-6)


@pytest.mark.parametrize("slides", [1, 2])
def test_large_motions_do_not_fold_elements(slides: int) -> None:
    force = press_and_slide(crossing(60.0), slides=slides)
    assert force == pytest.approx(press_and_slide(crossing(60.0), slides=12), rel=1e-3)


@pytest.mark.parametrize("angle", [5.0, 10.0, 20.0])
def test_long_elements_do_not_overlap_between_stations(angle: float) -> None:
    rods = crossing(angle, element=16.0)
    rods.move(1, [0, -1], by=(0.0, 0.0, -2.0))
    rods.solve(4)
    middle = len(rods.positions(0)) // 2
    apart = rods.positions(1)[middle] - rods.positions(0)[middle]
    assert np.linalg.norm(apart) == pytest.approx(2.0, abs=0.02)


def test_beams_that_cross_at_two_degrees_press_on_each_other() -> None:
    rods = crossing(2.0)
    rods.move(1, [0, -1], by=(0.0, 0.0, -1.0))
    rods.solve(4)
    assert lift(rods) > 0.0


def test_a_motion_that_has_no_equilibrium_fails_with_a_message() -> None:
    line = straight((0, 0, 0), (10, 0, 0), 8)
    rods = Rods([Beam(line, 1.0, YarnMaterial.isotropic(1000.0, 0.3))])
    rods.clamp(0, [0, -1])
    rods.move(0, -1, by=(-15.0, 0.0, 0.0))
    with pytest.raises(NotConverged, match="no equilibrium at"):
        rods.solve(1, max_cuts=1)


def test_a_rod_does_not_go_through_another_in_one_increment() -> None:
    lines = [straight((-30, 0, 0), (30, 0, 0), 24), straight((0, -30, 5), (0, 30, 5), 24)]
    rods = Rods([Beam(line, 1.0, YarnMaterial.isotropic(1000.0, 0.3)) for line in lines])
    rods.clamp(0, [0, -1])
    rods.hold(1, slice(None), slice(0, 3))
    rods.move(1, slice(None), by=(0.0, 0.0, -6.0))
    rods.solve(1)
    middle = [rods.positions(rod)[12] for rod in (0, 1)]
    assert middle[1][2] - middle[0][2] == pytest.approx(2.0, abs=0.1)
