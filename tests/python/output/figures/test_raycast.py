"""Rays against tubes with known pictures."""

from __future__ import annotations

import numpy as np
import pytest

from braidx.output.figures.raycast import Tubes, View, cast
from braidx.output.figures.shade import render

_X, _Y, _Z = np.eye(3)


def cylinder(start: list[float], end: list[float], radius: float = 1.0) -> Tubes:
    a, b = np.array([start]), np.array([end])
    tangent = (b - a) / np.linalg.norm(b - a)
    return Tubes(a, b, tangent, tangent, np.array([radius]), np.array([[1.0, 0.0, 0.0]]))


def both(one: Tubes, two: Tubes) -> Tubes:
    names = ("start", "end", "start_tangent", "end_tangent", "radius", "colour")
    return Tubes(*(np.concatenate([getattr(one, n), getattr(two, n)]) for n in names))


VIEW = View(right=_X, up=_Y, centre=np.zeros(3), width=10.0, height=6.0, pixels_per_mm=20.0)


@pytest.mark.parametrize("tilt", [0.0, 0.6, 1.2])
def test_side_of_a_cylinder_lies_on_it(tilt: float) -> None:
    direction = np.array([np.cos(tilt), 0.2, np.sin(tilt)])
    tubes = cylinder(list(-30 * direction), list(30 * direction))
    hits = cast(tubes, VIEW)
    rows, columns = np.nonzero(hits.cylinder >= 0)
    x = (columns + 0.5) / 20 - 5.0
    y = 3.0 - (rows + 0.5) / 20
    points = np.stack([x, y, hits.depth[rows, columns]], axis=1)
    axis = direction / np.linalg.norm(direction)
    across = points - (points @ axis)[:, None] * axis
    np.testing.assert_allclose(np.linalg.norm(across, axis=1), 1.0, atol=1e-9)
    np.testing.assert_allclose(hits.normal[rows, columns], across, atol=1e-9)
    assert (hits.normal[rows, columns, 2] >= 0).all()


def test_a_band_of_the_right_width_is_covered() -> None:
    hits = cast(cylinder([-30, 0.5, 0], [30, 0.5, 0]), VIEW)
    assert (hits.cylinder >= 0).sum() == 200 * 40
    assert hits.cylinder[0].max() == -1 and hits.cylinder[50].min() == 0  # y = 0.475


def test_end_on_a_disc_is_seen() -> None:
    hits = cast(cylinder([0, 0, -5], [0, 0, 2]), VIEW)
    seen = hits.cylinder >= 0
    assert seen.sum() / 400 == pytest.approx(np.pi, rel=0.01)
    assert hits.depth[60, 100] == pytest.approx(2.05)  # with the overlap of 5 % of the radius
    np.testing.assert_allclose(hits.normal[60, 100], _Z)


def test_the_nearer_tube_hides_the_other() -> None:
    far, near = cylinder([-9, 0, -2], [9, 0, -2]), cylinder([0, -9, 2], [0, 9, 2])
    for tubes, front in ((both(far, near), 1), (both(near, far), 0)):
        assert cast(tubes, VIEW).cylinder[60, 100] == front


def test_a_cutting_plane_shows_the_inside() -> None:
    view = View(_X, _Y, np.zeros(3), 10.0, 6.0, 20.0, cut_depth=0.5)
    hits = cast(cylinder([-30, 0, 0], [30, 0, 0]), view)
    cut = hits.is_cut[:, 100]
    assert cut.sum() / 20 == pytest.approx(2 * np.sqrt(0.75), abs=0.06)
    assert (hits.depth[hits.is_cut] == 0.5).all()
    assert (cast(cylinder([-30, 0, 3], [30, 0, 3]), view).cylinder == -1).all()


def test_many_cylinders_against_brute_force() -> None:
    generator = np.random.default_rng(3)
    start, end = generator.uniform(-4, 4, (2, 12, 3))
    tangent = (end - start) / np.linalg.norm(end - start, axis=1, keepdims=True)
    radius = generator.uniform(0.2, 0.8, 12)
    tubes = Tubes(start, end, tangent, tangent, radius, np.ones((12, 3)))
    view = View(_X, _Y, np.zeros(3), 10.0, 6.0, 6.0)
    hits = cast(tubes, view)
    z = np.linspace(6.0, -6.0, 1201)
    for row in range(0, 36, 3):
        for column in range(0, 60, 3):
            x, y = (column + 0.5) / 6 - 5.0, 3.0 - (row + 0.5) / 6
            points = np.stack([np.full_like(z, x), np.full_like(z, y), z], axis=1)
            offset = points[:, None] - start
            along = np.einsum("pcd,cd->pc", offset, tangent)
            distance = np.linalg.norm(offset - along[..., None] * tangent, axis=2)
            length = np.linalg.norm(end - start, axis=1)
            margin = 0.05 * radius
            inside = (distance <= radius) & (along >= -margin) & (along <= length + margin)
            first = np.flatnonzero(inside.any(axis=1))
            if len(first):
                assert hits.depth[row, column] == pytest.approx(z[first[0]], abs=0.011)


def test_a_picture_has_colour_and_a_clear_background() -> None:
    picture = render(cylinder([-30, 0, 0], [30, 0, 0]), VIEW)
    assert picture.shape == (120, 200, 4)
    assert picture[0, 0, 3] == 0.0 and picture[60, 100, 3] == 1.0
    assert picture[60, 100, 0] > 0.5 > picture[60, 100, 1]
    assert picture.min() >= 0.0 and picture.max() <= 1.0
    empty = render(cylinder([99, 99, 0], [100, 99, 0]), VIEW)
    assert (empty[..., 3] == 0).all()
