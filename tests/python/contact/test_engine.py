"""The border of the contact engine: arrays in, arrays out."""

from __future__ import annotations

from typing import Any

import braidx_engine as engine
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

Floats = np.ndarray[Any, np.dtype[np.float64]]


def make_tubes(
    curves: list[Floats], radius: float, *, block: int = 3, degree: int = 1
) -> tuple[Any, Floats]:
    """Tubes through the nodes of curves, shapes (num_nodes_i, 3), mm; and their unknowns."""
    nodes = np.array([len(c) for c in curves])
    lengths = np.array([np.linalg.norm(np.diff(c, axis=0), axis=1).sum() for c in curves])
    num_elements = (nodes - 1) // degree
    directors = np.broadcast_to([1.0, 0, 0, 0, 1.0, 0], (nodes.sum(), 6))[:, : block - 3]
    count = len(curves)
    tubes = engine.make_tubes(
        first_unknown=block * np.concatenate([[0], np.cumsum(nodes)[:-1]]).astype(np.int64),
        num_elements=num_elements.astype(np.int32),
        degree=np.full(count, degree, np.int32),
        block=np.full(count, block, np.int32),
        radius=np.full(count, radius),
        element_length=lengths / num_elements,
        body=np.arange(count, dtype=np.int32),
        is_image=np.zeros(count, bool),
        smooth=False,
    )
    return tubes, np.hstack([np.concatenate(curves), directors]).ravel()


def no_crossings() -> Any:
    axis = np.array([[0, 0, 0], [0, 0, 1.0]])
    nothing = np.empty((0, 2), np.int32)
    return engine.make_crossings(nothing, np.empty((0, 4)), np.empty(0, np.int32), axis)


def straight(start: list[float], end: list[float], num_nodes: int) -> Any:
    return np.linspace(start, end, num_nodes)


def laws(friction: float = 0.2) -> Any:
    out = engine.ContactLaws()
    out.num_bodies = 2
    out.friction = [friction] * 4
    return out


class Press:
    """Two crossing rods pressed together on a plane, after a step in which rod 1 slid by 0.05 mm along y."""

    def __init__(self, block: int) -> None:
        curves = [straight([0, 0, -6], [0, 0, 6], 7), straight([1.98, -5, 0], [1.98, 5, 0], 6)]
        self.tubes, self.q = make_tubes(curves, 1.0, block=block)
        self.start = self.q.copy()
        self.start.reshape(-1, block)[7:, 1] -= 0.05
        wall = engine.make_plane(
            point=np.array([-0.99, 0, 0]), normal=np.array([2.0, 0, 0]), body=1
        )
        turn, shift = np.zeros(3), np.array([0, 0, 0.004])
        self.walls = [engine.moved(wall, pivot=np.zeros(3), rotation=turn, translation=shift)]
        self.elements = self.update(engine.ContactElements())

    def update(self, previous: Any) -> Any:
        options = engine.PairingOptions()
        return engine.make_contact_elements(
            self.tubes, no_crossings(), self.walls, self.q, self.start, previous, options
        )

    def residual(self, elements: Any, q: Floats) -> Floats:
        out = np.zeros_like(q)
        engine.add_residual(self.tubes, elements, q, self.start, laws(), out)
        return out

    def tangent(self, elements: Any, *, symmetric: bool) -> Floats:
        """Dense tangent, shape (num_unknowns, num_unknowns)."""
        pattern = engine.make_pattern(self.tubes, elements)
        rows, cols = pattern.blocks()
        values = np.zeros((len(rows), 3, 3))
        engine.add_tangent(
            self.tubes, elements, pattern, self.q, self.start, laws(), symmetric, values
        )
        out = np.zeros((len(self.q), len(self.q)))
        for row, col, value in zip(rows, cols, values):
            out[row : row + 3, col : col + 3] += value
        return out


@pytest.fixture(params=[3, 9], ids=["cables", "beams"])
def press(request: pytest.FixtureRequest) -> Press:
    return Press(request.param)


def test_contact_elements_survive_a_round_trip(press: Press) -> None:
    engine.commit(press.tubes, press.elements, press.q, press.start, laws())
    arrays = press.elements.arrays()
    assert np.abs(arrays["slip"]).max() > 0 and arrays["work"].max() > 0
    again = engine.ContactElements.from_arrays(arrays)
    assert len(again) == len(press.elements)
    for name, values in again.arrays().items():
        np.testing.assert_array_equal(values, arrays[name], err_msg=name)
    np.testing.assert_array_equal(
        press.residual(again, press.q), press.residual(press.elements, press.q)
    )


def test_no_contact_elements_survive_a_round_trip() -> None:
    arrays = engine.ContactElements().arrays()
    assert len(engine.ContactElements.from_arrays(arrays)) == 0


def test_shapes_of_results(press: Press) -> None:
    n = len(press.elements)
    arrays = press.elements.arrays()
    widths = {
        "tubes": 2,
        "s": 2,
        "facet": 2,
        "round": 2,
        "normal": 3,
        "slip": 3,
        "xi": 4,
        "wall": 6,
        "in_frame": 3,
    }
    for name, values in arrays.items():
        assert values.shape == ((n, widths[name]) if name in widths else (n,)), name
    results = engine.contact_results(press.tubes, press.elements, press.q, press.start, laws())
    for name in ("gap", "normal_force"):
        assert results[name].shape == (n,)
    for name in ("friction_force", "position"):
        assert results[name].shape == (n, 3)
    assert results["per_area"].shape == (n,) and not results["per_area"].any()
    assert results["gap"].min() < 0 < results["normal_force"].max()
    friction = np.linalg.norm(results["friction_force"], axis=1)
    assert np.all(friction <= 0.2 * results["normal_force"] * (1 + 1e-12))


def test_a_copy_has_its_own_memory(press: Press) -> None:
    copy = press.elements.copy()
    work, penetration = engine.commit(press.tubes, copy, press.q, press.start, laws())
    assert work == pytest.approx(copy.arrays()["work"].sum()) and work > 0
    assert penetration == pytest.approx(0.02)
    assert not press.elements.arrays()["work"].any()


def test_memory_goes_on_through_an_update(press: Press) -> None:
    engine.commit(press.tubes, press.elements, press.q, press.start, laws())
    old, new = press.elements.arrays(), press.update(press.elements).arrays()
    for name in ("station", "work", "slip"):
        np.testing.assert_allclose(new[name], old[name], atol=1e-14, err_msg=name)


def test_penalties_grow(press: Press) -> None:
    changed = engine.adapt_stiffness(press.tubes, press.elements, press.q, 0.018, 3.0)
    assert changed == 1  # the crossing; the plane is 0.01 mm deep
    arrays = press.elements.arrays()
    assert set(arrays["stiffness"][arrays["tubes"][:, 1] < 0]) == {1000.0}
    assert arrays["stiffness"][arrays["tubes"][:, 1] > 0] == pytest.approx(
        1000 * 1.6 * 0.02 / 0.018
    )


def test_tangent_is_the_derivative_of_the_residual(press: Press) -> None:
    tangent = press.tangent(press.elements, symmetric=False)
    rng = np.random.default_rng(1)
    for _ in range(3):
        step = 1e-7 * rng.uniform(-1, 1, len(press.q))
        ahead = press.residual(press.elements, press.q + step)
        change = ahead - press.residual(press.elements, press.q - step)
        assert np.linalg.norm(change - 2 * tangent @ step) < 1e-5 * np.linalg.norm(change)
    symmetric = press.tangent(press.elements, symmetric=True)
    np.testing.assert_allclose(symmetric, symmetric.T, atol=1e-9)


def test_blocks_are_unique(press: Press) -> None:
    rows, cols = engine.make_pattern(press.tubes, press.elements).blocks()
    assert len({*zip(rows.tolist(), cols.tolist())}) == len(rows)


def test_height_of_crossings_is_signed_or_not_a_number() -> None:
    curves = [straight([10, 0, -6], [10, 0, 6], 7), straight([11, -5, 0], [11, 5, 0], 6)]
    tubes, q = make_tubes(curves, 1.0)
    windows = np.array([[2.0, 10, 1, 9], [2.0, 10, 1, 9], [0, 2, 1, 9]])
    crossings = engine.make_crossings(
        tubes=np.array([[0, 1]] * 3, np.int32),
        windows=windows,
        order=np.array([1, -1, 1], np.int32),
        axis=np.array([[0, 0, 0], [0, 0, 1.0]]),
    )
    assert len(crossings) == 3
    heights = engine.crossing_heights(tubes, crossings, q)
    np.testing.assert_allclose(heights, [-1, 1, np.nan], atol=1e-6)


def segment_samples(curve: Floats) -> Floats:
    """Points along each segment of a curve, shape (num_segments, 9, 3)."""
    t = np.linspace(0, 1, 9)[None, :, None]
    return curve[:-1, None] * (1 - t) + curve[1:, None] * t


@settings(max_examples=40)
@given(
    seed=st.integers(0, 10_000),
    count=st.integers(1, 4),
    num_nodes=st.integers(2, 12),
    radius=st.floats(0.05, 1.0),
    margin=st.floats(0.0, 1.0),
)
def test_close_pairs_miss_none_of_the_sampled_ones(
    seed: int, count: int, num_nodes: int, radius: float, margin: float
) -> None:
    rng = np.random.default_rng(seed)
    curves = [np.cumsum(rng.normal(size=(num_nodes, 3)), axis=0) for _ in range(count)]
    tubes, q = make_tubes(curves, radius)
    options = engine.SearchOptions()
    options.margin = margin
    found = {tuple(pair) for pair in engine.close_pairs(tubes, q, options).tolist()}
    samples = [segment_samples(curve) for curve in curves]
    for a in range(count):
        for b in range(a + 1, count):
            apart = samples[a][:, None, :, None] - samples[b][None, :, None, :]
            near = np.linalg.norm(apart, axis=-1).min(axis=(2, 3)) <= 2 * radius + margin
            assert {(a, b, *map(int, e)) for e in np.argwhere(near)} <= found
