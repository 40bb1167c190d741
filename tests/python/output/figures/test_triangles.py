"""Surfaces drawn into a depth buffer, against known pictures and against rays."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from braidx.output import SheavePicture
from braidx.output.figures.shade import render
from braidx.output.figures.sheave_shape import sheave_surface
from braidx.output.figures.swept import hermite, swept
from braidx.output.figures.triangles import Triangles, joined, rasterise
from braidx.output.figures.view import View, frame

_X, _Y, _Z = np.eye(3)
VIEW = View(right=_X, up=_Y, centre=np.zeros(3), width=10.0, height=6.0, pixels_per_mm=20.0)
RED, BLUE = np.array([[1.0, 0.0, 0.0]]), np.array([[0.0, 0.0, 1.0]])


def tube(start: list[float], end: list[float], radius: float = 1.0) -> Triangles:
    return swept(np.linspace(start, end, 12), radius, RED)


def test_depth_and_corner_of_single_triangles_against_brute_force() -> None:
    generator = np.random.default_rng(5)
    points = generator.uniform(-4, 4, (30, 3)) * [1.0, 0.7, 1.0]
    corners = np.arange(30).reshape(-1, 3)
    flat = Triangles(points, np.tile(_Z, (30, 1)), corners, np.ones((10, 3)))
    view = replace(VIEW, pixels_per_mm=6.0)
    found = rasterise(flat, view)
    for row in range(36):
        for column in range(60):
            place = np.array([(column + 0.5) / 6 - 5.0, 3.0 - (row + 0.5) / 6])
            best, who = -np.inf, -1
            for number, corner in enumerate(corners):
                a, b, c = points[corner]
                share = np.linalg.solve(np.stack([b - a, c - a], axis=1)[:2], place - a[:2])
                if share.min() >= 0 and share.sum() <= 1:
                    z = a[2] + share @ [b[2] - a[2], c[2] - a[2]]
                    best, who = max((best, who), (z, number))
            assert found.triangle[row, column] == who
            if who >= 0:
                assert found.depth[row, column] == pytest.approx(best)


@pytest.mark.parametrize("tilt", [0.0, 0.6, 1.2])
def test_a_swept_tube_lies_on_its_cylinder(tilt: float) -> None:
    direction = np.array([np.cos(tilt), 0.2, np.sin(tilt)])
    found = rasterise(tube(list(-30 * direction), list(30 * direction)), VIEW)
    rows, columns = np.nonzero(found.triangle >= 0)
    points = np.stack(
        [(columns + 0.5) / 20 - 5.0, 3.0 - (rows + 0.5) / 20, found.depth[rows, columns]], axis=1
    )
    axis = direction / np.linalg.norm(direction)
    across = points - (points @ axis)[:, None] * axis
    distance = np.linalg.norm(across, axis=1)
    sagitta = 1 - np.cos(np.pi / 20)
    assert 1 - sagitta - 1e-5 <= distance.min() and distance.max() <= 1 + 1e-5
    cosine = np.einsum("ij,ij->i", found.normal[rows, columns], across) / distance
    assert cosine.min() > 0.999


def test_ends_of_tubes_are_closed_and_face_outwards() -> None:
    one = tube([0, 0, -2], [0, 0, 2])
    a, b, c = one.points[one.corners].transpose(1, 0, 2)
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
    assert volume == pytest.approx(20 / 2 * np.sin(2 * np.pi / 20) * 4)
    found = rasterise(one, VIEW)
    assert found.depth[60, 100] == pytest.approx(2.0)
    np.testing.assert_allclose(found.normal[60, 100], _Z, atol=1e-6)


def test_a_cutting_plane_shows_the_inside() -> None:
    cut_view = replace(VIEW, cut_depth=0.5)
    one = tube([-30, 0, 0], [30, 0, 0])
    one = replace(one, inside=np.broadcast_to(BLUE, one.colour.shape))
    found = rasterise(one, cut_view)
    cut = found.is_cut[:, 100]
    assert cut.sum() / 20 == pytest.approx(2 * np.sqrt(0.75), abs=0.11)
    assert (found.depth[found.is_cut] == 0.5).all()
    seen = rasterise(one, cut_view)
    np.testing.assert_array_equal(seen.colour[found.is_cut][0], BLUE[0])
    assert (rasterise(tube([-30, 0, 3], [30, 0, 3]), cut_view).triangle == -1).all()


def test_the_nearer_part_hides_the_other_and_a_cut_shows_the_bore() -> None:
    far, near = tube([-9, 0, -2], [9, 0, -2]), replace(tube([0, -9, 2], [0, 9, 2]))
    near = replace(near, colour=np.broadcast_to(BLUE, near.colour.shape))
    for parts in ([far, near], [near, far]):
        assert rasterise(joined(parts), VIEW).colour[60, 100, 2] == 1.0
    bore = replace(swept(np.linspace([-9, 0, 0], [9, 0, 0], 9), 0.5, BLUE))
    seen = rasterise(joined([tube([-9, 0, 0], [9, 0, 0]), bore]), replace(VIEW, cut_depth=0.0))
    assert seen.colour[60, 100, 2] == 1.0 and seen.colour[45, 100, 0] == 1.0


def test_a_cut_body_is_whole_where_another_one_dips_into_it_behind() -> None:
    bodies = [tube([-9, 0, 0], [9, 0, 0]), tube([0, -9, -1.4], [0, 9, -1.4], 0.5)]
    for parts in (bodies, [joined(bodies)]):
        seen = rasterise(joined(parts), replace(VIEW, cut_depth=0.0))
        assert seen.is_cut[45:75, 60:140].all()
        assert not seen.is_cut[:30].any()


def test_through_glass_both_are_seen() -> None:
    behind = tube([-9, 0, -3], [9, 0, -3])
    pane = replace(tube([0, -9, 2], [0, 9, 2]))
    pane = replace(pane, colour=np.broadcast_to(BLUE, pane.colour.shape))
    picture = render([behind], VIEW, 1.0, glass=pane)
    both, alone, clear = picture[60, 100], picture[20, 100], picture[60, 30]
    assert both[0] > 0.2 and both[2] > 0.2
    assert alone[0] < 0.25 and alone[2] > 0.5 and alone[3] == 1.0  # the shine is white
    assert clear[0] > 0.5 and clear[2] < 0.25
    assert picture[10, 10, 3] == 0.0


@pytest.mark.parametrize("groove", [None, 7.0])
def test_the_sheave_is_closed_and_lies_where_it_should(groove: float | None) -> None:
    sheave = SheavePicture(np.array([1.0, 2.0, 3.0]), _X, 20.0, groove)
    surface = sheave_surface(sheave, 6.0)
    away = surface.points - sheave.centre
    radius, across = np.hypot(away[:, 1], away[:, 2]), away[:, 0]
    middle = np.abs(across) < 1e-9
    assert radius[middle].max() == pytest.approx(20.0)
    a, b, c = (surface.points - sheave.centre)[surface.corners].transpose(1, 0, 2)
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
    half = across.max()
    u = np.linspace(-half, half, 4001)
    expected = np.pi * np.trapezoid(sheave.profile(u) ** 2 - 25.0, u)
    assert volume == pytest.approx(expected, rel=2e-3)


def test_the_mark_turns_with_the_sheave() -> None:
    views = []
    for angle in (0.0, np.pi):
        sheave = SheavePicture(np.zeros(3), _X, 20.0, angle=angle)
        surface = sheave_surface(sheave, 6.0)
        darkest = surface.colour[:, 0] == surface.colour[:, 0].min()
        views.append(surface.points[surface.corners[darkest]].mean(axis=(0, 1)))
    np.testing.assert_allclose(views[0][1:], -views[1][1:], atol=1e-9)
    assert np.linalg.norm(views[0][1:]) > 5.0


@pytest.mark.parametrize("closed", [True, False])
def test_the_silhouette_of_a_bent_tube_has_its_area_and_no_gaps(closed: bool) -> None:
    turn = np.linspace(0.0, np.pi, 9)  # half a ring of radius 2.2, from nine nodes
    line = np.stack([2.2 * np.cos(turn), 2.2 * np.sin(turn) - 1.0, 0.0 * turn], axis=1)
    seen = rasterise(replace(swept(line, 0.6, RED), closed=closed), VIEW)
    assert seen.covered.sum() / 400 == pytest.approx(
        np.pi * 2.2 * 1.2, rel=0.0125
    )  # a polygon of 20 sides: width 0.988 to 1
    # Along a ray from the ring's middle every pixel between inner and outer rim is covered.
    for angle in np.linspace(0.1, np.pi - 0.1, 200):
        reach = np.linspace(2.2 - 0.55, 2.2 + 0.55, 60)
        x, y = reach * np.cos(angle), reach * np.sin(angle) - 1.0
        rows, columns = np.floor((3.0 - y) * 20).astype(int), np.floor((x + 5.0) * 20).astype(int)
        assert seen.covered[rows, columns].all()


def test_a_picture_has_the_colour_of_what_it_shows_and_a_clear_background() -> None:
    picture = render([tube([-30, 0, 0], [30, 0, 0])], VIEW, 1.0)
    assert picture.shape == (120, 200, 4)
    assert picture[0, 0, 3] == 0.0 and picture[60, 100, 3] == 1.0
    assert picture[60, 100, 0] > 0.5 > picture[60, 100, 1]
    assert picture.min() >= 0.0 and picture.max() <= 1.0
    assert picture[..., 3].sum() == pytest.approx(200 * 40, rel=0.01)
    empty = render([tube([99, 99, 0], [100, 99, 0])], VIEW, 1.0)
    assert (empty[..., 3] == 0).all()


@pytest.mark.parametrize("towards", [(0, 0, 1), (0, 0, -2.0), (1.0, -1.6, 0.9)])
def test_any_direction_has_a_view(towards: tuple[float, ...]) -> None:
    axes = frame(np.array(towards, dtype=float), _Z)
    np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(axes) == pytest.approx(1.0)
    np.testing.assert_allclose(axes[2], np.array(towards) / np.linalg.norm(towards), atol=1e-12)
    with pytest.raises(ValueError, match="no direction"):
        frame(np.zeros(3), _Z)


def test_centre_lines_are_smoothed_through_their_nodes() -> None:
    turn = np.linspace(0.0, 3.0, 11)
    line = np.stack([np.cos(turn), np.sin(turn), turn], axis=1)
    smooth = hermite(line, 4)
    np.testing.assert_allclose(smooth[::4], line, atol=1e-12)
    radius = np.hypot(smooth[4:-4, 0], smooth[4:-4, 1])
    np.testing.assert_allclose(radius, 1.0, atol=2e-4)  # a chord's sagitta is 0.011
