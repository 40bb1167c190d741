"""Relative displacement of crossing yarns against motions with known answers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bent_example import LAYER, PITCH, YARN, bend, contact_table, straight_lines
from rope_example import rope
from scipy.interpolate import CubicSpline

from braidx.output.interlacing import relative_displacement, work_per_crossing
from braidx.output.interlacing_points import crossing, find_interlacing
from braidx.output.measures import layers
from braidx.output.rope_axis import RopeAxis, mean_axis
from braidx.output.yarn_curves import YarnCurves

RADIUS = np.full(12, YARN)
LENGTH = 4 * PITCH


def compare(current: list[np.ndarray]):
    return relative_displacement(straight_lines(), current, RADIUS, LAYER)


def rotation(axis: list[float], angle: float) -> np.ndarray:
    """Rodrigues's formula."""
    u = np.array(axis) / np.linalg.norm(axis)
    cross = np.cross(np.eye(3), u).T
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def slid(amount: float, yarns: range) -> list[np.ndarray]:
    """Material of some yarns moved along their own paths: each node further on by `amount` nodes."""
    lines = straight_lines()
    for yarn in yarns:
        spline = CubicSpline(np.arange(len(lines[yarn])), lines[yarn])
        lines[yarn] = spline(np.arange(len(lines[yarn])) + amount)
    return lines


def test_every_crossing_is_found_at_its_place() -> None:
    points = find_interlacing(straight_lines(), RADIUS, LAYER)
    # Every pair meets twice per pitch, every twelfth of a pitch six pairs do. The ends have half.
    inside = (points.position[:, 2] > 1e-6) & (points.position[:, 2] < LENGTH - 1e-6)
    assert inside.sum() == 47 * 6
    places = points.position[:, 2] / (PITCH / 12)
    np.testing.assert_allclose(places, places.round(), atol=2e-5)
    np.testing.assert_allclose(points.distance, 2 * YARN, rtol=1e-5)
    np.testing.assert_allclose(np.hypot(*points.position[:, :2].T), 4.0, rtol=1e-5)


def test_crossings_against_brute_force() -> None:
    """Multi-yarn strands, where many crossings lie near each other; polygons through fine samples."""
    one = rope(pitches=0.5, nodes=81, strands=4)
    lines = one.centre_lines[:7] + one.centre_lines[14:21]
    radius, layer = np.full(14, 0.86), np.repeat([0, 1], 7)
    axis = RopeAxis(np.linspace([0.0, 0.0, 0.0], [0.0, 0.0, 66.0], 10))
    points = find_interlacing(lines, radius, layer, axis)
    assert len(points) > 15
    fine = np.linspace(0.0, 80.0, 401)
    samples = [YarnCurves(lines)(np.full(401, k), fine) for k in range(14)]
    count = 0
    for a in range(7):
        for b in range(7, 14):
            for place in polygon_crossings(samples[a], samples[b], 2.6 * 0.86):
                own = (points.yarn_a == a) & (points.yarn_b == b)
                s = np.stack([points.s_a[own], points.s_b[own]], axis=1)
                assert np.abs(s - 0.2 * place).max(axis=1).min() < 0.05
                count += 1
    assert count == len(points)


def polygon_crossings(a: np.ndarray, b: np.ndarray, reach: float) -> list[np.ndarray]:
    """Sample indices, real, where two polygons cross in the plane of angle and height."""
    places = []
    flat = [np.stack([np.unwrap(np.arctan2(p[:, 1], p[:, 0])), p[:, 2]], axis=1) for p in (a, b)]
    for turns in (-2, -1, 0, 1, 2):
        p, q = flat[0], flat[1] + [2 * np.pi * turns, 0.0]
        u, v = np.diff(p, axis=0)[:, None], np.diff(q, axis=0)[None]
        w = q[None, :-1] - p[:-1, None]
        area = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
        area = np.where(area == 0.0, 1e-300, area)
        i_share = (w[..., 0] * v[..., 1] - w[..., 1] * v[..., 0]) / area
        j_share = (w[..., 0] * u[..., 1] - w[..., 1] * u[..., 0]) / area
        hit = (i_share >= 0) & (i_share < 1) & (j_share >= 0) & (j_share < 1)
        for i, j in zip(*np.nonzero(hit)):
            x = a[i] + i_share[i, j] * (a[i + 1] - a[i])
            y = b[j] + j_share[i, j] * (b[j + 1] - b[j])
            if np.linalg.norm(x - y) < reach:
                places.append(np.array([i + i_share[i, j], j + j_share[i, j]]))
    return places


def test_the_same_is_found_from_nearby_starts() -> None:
    curves, axis = YarnCurves(straight_lines()), mean_axis(straight_lines())
    points = find_interlacing(straight_lines(), RADIUS, LAYER)
    offset = np.random.default_rng(0).uniform(-0.7, 0.7, (2, len(points)))
    starts = points.s_a + offset[0], points.s_b + offset[1]
    s_a, s_b, found = crossing(curves, axis, points.yarn_a, points.yarn_b, *starts)
    assert found.all()
    np.testing.assert_allclose([s_a, s_b], [points.s_a, points.s_b], atol=1e-8)


def test_rigid_motion_displaces_nothing() -> None:
    turn = rotation([1.0, 2.0, -0.5], 1.3)
    result = compare([line @ turn.T + [5.0, -3.0, 40.0] for line in straight_lines()])
    assert result.maximum() < 1e-10
    assert np.abs(result.moved).max() < 1e-9


def test_a_bent_rope_with_rigid_sections_has_none_at_crossings() -> None:
    """Separations lie across the section; bending turns them with it and keeps them normal."""
    result = compare([bend(line, LENGTH) for line in straight_lines()])
    # Where the arc meets its tangents curvature jumps, and a cubic over 1 mm smooths the jump.
    z = result.reference.position[:, 2] - 0.5 * LENGTH
    smooth = np.abs(np.abs(z) - 1.2 * 26.0) > 8.0
    assert smooth.sum() > 200
    assert result.magnitude[smooth].max() < 2e-5
    assert np.abs(result.moved[smooth]).max() < 1e-4


def test_straight_yarns_slid_along_themselves_show_exactly_that() -> None:
    x = np.linspace(-20.0, 20.0, 41)
    tilt = 0.4
    one = np.stack([0 * x, 0 * x, x], axis=1)
    two = np.stack([x * np.sin(tilt), 0 * x + 2.0, x * np.cos(tilt)], axis=1)
    layer, radius = np.array([0, 1]), np.ones(2)
    slide_a, slide_b = 0.7, -1.9
    along = np.array([np.sin(tilt), 0.0, np.cos(tilt)])
    current = [one + [0.0, 0.0, slide_a], two + slide_b * along]
    axis = RopeAxis(np.stack([0 * x, 0 * x - 5.0, x], axis=1))
    result = relative_displacement([one, two], current, radius, layer, axes=(axis, axis))
    assert len(result.magnitude) == 1
    expected = slide_b * along - [0.0, 0.0, slide_a]
    np.testing.assert_allclose(result.displacement[0], expected, atol=1e-12)
    # The interlacing point stays in space: along the material it moves back.
    np.testing.assert_allclose(result.moved[0], [-slide_a, -slide_b], atol=1e-12)


@pytest.mark.parametrize("yarns", [range(6), range(6, 12), range(12)])
def test_displacement_is_the_motion_of_the_interlacing_point(yarns: range) -> None:
    """d = m_a t_a - m_b t_b, with an error that is of second order in the slide."""
    errors = []
    for amount in (0.1, 0.05):
        lines = slid(amount, yarns)
        result = relative_displacement(straight_lines(), lines, RADIUS, LAYER)
        now, points = YarnCurves(lines), result.reference
        kept = np.abs(points.position[:, 2] - 0.5 * LENGTH) < 60
        t_a = now.tangent(points.yarn_a, points.s_a)
        t_b = now.tangent(points.yarn_b, points.s_b)
        first = result.moved[:, :1] * t_a - result.moved[:, 1:] * t_b
        assert result.magnitude[kept].min() > 0.5 * amount
        errors.append(np.abs(result.displacement - first)[kept].max())
    # The radial sine has a curvature of 0.75/mm, the slide is 0.19 mm at most.
    assert errors[0] < 0.75 * 0.19**2 and errors[1] < 0.3 * errors[0]


def test_a_slide_along_an_undulating_yarn_is_its_length() -> None:
    result = compare(slid(0.1, range(6)))
    kept = np.abs(result.reference.position[:, 2] - 0.5 * LENGTH) < 60
    curves = YarnCurves(straight_lines())
    points = result.reference
    length = curves.arc_length(points.yarn_a, points.s_a, points.s_a + 0.1)
    np.testing.assert_allclose(result.moved[kept, 0], -length[kept], rtol=0.01)
    np.testing.assert_allclose(result.moved[kept, 1], 0.0, atol=1e-4)


def test_the_four_at_the_crown_and_the_profile() -> None:
    result = compare(slid(0.1, range(6)))
    crown = 0.5 * LENGTH
    chosen = result.at_crown(crown)
    far = np.round(np.abs(result.reference.position[:, 2] - crown), 1)
    near = np.argsort(far, kind="stable")[:12]  # as many as there are yarns
    assert len(chosen) == 4 and set(chosen) <= set(near)
    assert result.magnitude[chosen].min() >= np.sort(result.magnitude[near])[-4] - 1e-12
    assert result.mean_at_crown(crown) == pytest.approx(result.magnitude[chosen].mean())
    middle, mean, highest = result.profile(10.0)
    z = result.reference.position[:, 2]
    own = (z >= middle[9] - 5.0) & (z < middle[9] + 5.0)
    assert mean[9] == pytest.approx(result.magnitude[own].mean())
    assert highest[9] == pytest.approx(result.magnitude[own].max())
    assert result.maximum() == pytest.approx(highest.max())


def test_work_goes_to_the_nearest_crossing_of_the_two_yarns() -> None:
    lines = straight_lines()
    table = contact_table(lines, LENGTH, 1.0)
    result = compare([bend(line, LENGTH) for line in lines])
    work = work_per_crossing(result, table)
    assert work.sum() == pytest.approx(table.work[table.kind == 0].sum())
    expected = 0.02 * (
        20 + 40 * np.exp(-(((result.reference.position[:, 2] - LENGTH / 2) / 20) ** 2))
    )
    np.testing.assert_allclose(work, expected, rtol=1e-6)
    strangers = replace(table, yarn_b=table.yarn_a)  # pairs that never cross
    assert work_per_crossing(result, strangers).sum() == 0.0


def test_states_of_different_meshes_are_refused() -> None:
    with pytest.raises(ValueError, match="numbers of nodes"):
        relative_displacement(straight_lines(), straight_lines(nodes=73), RADIUS, LAYER)


def test_no_crossing_no_result() -> None:
    lines = straight_lines()[:2]
    result = relative_displacement(lines, lines, RADIUS[:2], np.zeros(2, dtype=int))
    assert len(result.reference) == 0 and np.isnan(result.maximum())
    assert np.isnan(result.mean_at_crown(0.0)) and len(result.profile(1.0)[0]) == 0


def test_layers_of_the_example() -> None:
    np.testing.assert_array_equal(layers(rope(nodes=61)), np.repeat([0, 1], 42))
