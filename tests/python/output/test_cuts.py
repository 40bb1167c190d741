"""Cross-sections of tubes against exact ellipses and points on the surface."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rope_example import rope

from braidx.output import Snapshot
from braidx.output.cuts import cut, frames, node_tangents


def straight(direction: tuple[float, float, float], radius: float = 0.8) -> Snapshot:
    along = np.asarray(direction) / np.linalg.norm(direction)
    line = np.array([2.0, -1.0, 5.0]) + np.linspace(-20, 20, 9)[:, None] * along
    return Snapshot("x", (line,), np.array([radius]), np.zeros(1, dtype=np.int64))


@given(st.floats(0.0, 1.2), st.floats(0.0, 6.28))
def test_inclined_tube_is_cut_in_an_ellipse(theta: float, turn: float) -> None:
    radius = 0.8
    direction = (np.sin(theta) * np.cos(turn), np.sin(theta) * np.sin(turn), np.cos(theta))
    section = cut(straight(direction, radius), 5.0)
    assert section.centre == pytest.approx(np.array([[2.0, -1.0]]), abs=1e-9)
    assert section.area()[0] == pytest.approx(np.pi * radius**2 / np.cos(theta))
    along = np.array([np.cos(turn), np.sin(turn)])
    across = np.array([-along[1], along[0]])
    reach = (
        section.support(np.stack([along, across]))[0] - section.centre @ np.array([along, across]).T
    )
    assert reach.ravel() == pytest.approx([radius / np.cos(theta), radius])


def test_outline_points_lie_on_the_tube() -> None:
    direction = np.array([0.3, -0.5, 1.0])
    section = cut(straight(tuple(direction)), 5.0)
    points = np.column_stack([section.outlines(16)[0], np.full(16, 5.0)])
    from_axis = np.cross(points - [2.0, -1.0, 5.0], direction / np.linalg.norm(direction))
    assert np.linalg.norm(from_axis, axis=1) == pytest.approx(0.8)


def test_deformed_sections_of_beams() -> None:
    one = straight((0.0, 0.0, 1.0), radius=1.0)
    flat = np.tile(np.array([[1.5, 0.0, 0.0], [0.0, 0.5, 0.0]]), (9, 1, 1))
    section = cut(replace(one, directors=(flat,)), 4.2)
    assert section.area()[0] == pytest.approx(np.pi * 0.75)
    assert np.ptp(section.outlines(64)[0], axis=0) == pytest.approx([3.0, 1.0])


def test_planes_that_miss_and_lines_that_return() -> None:
    assert len(cut(straight((0.0, 0.0, 1.0)), 99.0).yarn) == 0
    z = np.array([0.0, 10.0, 10.0, 0.0])
    line = np.stack([np.array([0.0, 0.0, 5.0, 5.0]), np.zeros(4), z], axis=1)
    bow = Snapshot("x", (line,), np.array([0.5]), np.zeros(1, dtype=np.int64))
    assert len(cut(bow, 4.0).yarn) == 2


def test_every_yarn_of_a_rope_is_cut_once() -> None:
    section = cut(rope(nodes=81), 132.0)
    assert list(section.yarn) == list(range(84))


def test_frames_are_orthonormal_and_smooth() -> None:
    tangent = node_tangents(rope(nodes=81).centre_lines[3])
    frame = frames(tangent)
    basis = np.concatenate([frame, tangent[:, None]], axis=1)
    np.testing.assert_allclose(
        basis @ basis.transpose(0, 2, 1), np.tile(np.eye(3), (81, 1, 1)), atol=1e-12
    )
    assert (np.einsum("nij,nij->ni", frame[1:], frame[:-1]) > 0.9).all()
