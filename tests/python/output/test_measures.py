"""Measures against cases with a known answer."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from rope_example import rope

from braidx.output import Snapshot, measures
from braidx.output.cuts import cut


def helices(count: int, sense: int = 1, centre: float = 6.0, radius: float = 0.8) -> Snapshot:
    """`count` equal helices about z, one strand each; two turns in 100 mm."""
    z = np.linspace(0.0, 100.0, 401)
    lines = []
    for i in range(count):
        angle = sense * 2 * np.pi * z / 50.0 + 2 * np.pi * i / count
        lines.append(np.stack([centre * np.cos(angle), centre * np.sin(angle), z], axis=1))
    return Snapshot("x", tuple(lines), np.full(count, radius), np.arange(count))


def _straight(line: np.ndarray) -> np.ndarray:
    return np.column_stack([np.tile(line[0, :2], (len(line), 1)), line[:, 2]])


def test_circumscribed_diameter_of_helices() -> None:
    # The ellipse's long axis lies along the circumference, so that its far points are not radial.
    snapshot = helices(6)
    slope = 2 * np.pi * 6.0 / 50.0
    phi = np.linspace(0, 2 * np.pi, 100_001)
    half = 0.8 * np.sqrt(1 + slope**2)
    farthest = np.hypot(6.0 + 0.8 * np.cos(phi), half * np.sin(phi)).max()
    found = measures.mean_diameter(measures.circumscribed_diameter, snapshot)
    assert found == pytest.approx(2 * farthest, rel=1e-4)


def test_diameters_of_a_single_yarn_and_of_a_pair() -> None:
    line = np.zeros((5, 3))
    line[:, 2] = np.arange(5)
    one = Snapshot("x", (line,), np.array([0.7]), np.zeros(1, dtype=np.int64))
    assert measures.outer_diameter(one) == pytest.approx(1.4)
    assert measures.outline_diameter(cut(one, 2.0)) == pytest.approx(1.4, rel=1e-3)
    assert measures.packing_fraction(cut(one, 2.0)) == pytest.approx(1.0)
    left, right = line - [1.0, 0, 0], line + [1.0, 0, 0]
    pair = Snapshot("x", (left, right), np.array([0.7, 0.7]), np.zeros(2, dtype=np.int64))
    assert measures.outer_diameter(pair) == pytest.approx(1.4 + 4 / np.pi, rel=1e-4)
    assert measures.circumscribed_diameter(cut(pair, 2.0)) == pytest.approx(3.4)


def test_outline_sinks_into_valleys() -> None:
    """Yarns on a ring that touch each other: seen from the axis the outline is theirs, not that of the circle."""
    snapshot = helices(8, centre=2.0, radius=2.0 * np.sin(np.pi / 8))
    section = cut(
        replace(snapshot, centre_lines=tuple(_straight(line) for line in snapshot.centre_lines)),
        50.0,
    )
    radius, angle = 2.0 * np.sin(np.pi / 8), np.linspace(-np.pi / 8, np.pi / 8, 10_001)
    reach = 2.0 * np.cos(angle) + np.sqrt(np.maximum(radius**2 - (2.0 * np.sin(angle)) ** 2, 0.0))
    expected = 2.0 * np.sqrt(np.mean(reach**2))
    assert measures.outline_diameter(section) == pytest.approx(expected, rel=1e-3)
    assert measures.outline_diameter(section) < measures.tape_diameter(section)


def test_layers_are_the_senses_of_turning() -> None:
    layer = measures.layers(rope(nodes=81))
    assert list(layer) == [0] * 42 + [1] * 42
    assert set(measures.layers(helices(3, sense=-1))) == {1}


def test_yarn_stress_is_weighted_by_length_and_leaves_out_the_ends() -> None:
    line = np.zeros((7, 3))
    line[:, 2] = [0.0, 1.0, 3.0, 4.0, 8.0, 9.0, 10.0]
    stress = np.array([1e6, 1.0, 2.0, 3.0, 4.0, -1e6])
    one = Snapshot("x", (line,), np.ones(1), np.zeros(1, dtype=np.int64), axial_stress=(stress,))
    found = measures.yarn_stress(one, margin=0.1)
    weights, values = np.array([2.0, 1.0, 4.0, 1.0]), np.array([1.0, 2.0, 3.0, 4.0])
    mean = np.average(values, weights=weights)
    assert found.mean == pytest.approx(mean)
    assert found.std == pytest.approx(np.sqrt(np.average((values - mean) ** 2, weights=weights)))
    assert (found.min, found.max) == (1.0, 4.0)
    with pytest.raises(ValueError, match="axial stress"):
        measures.yarn_stress(replace(one, axial_stress=None))


def test_contact_statistics() -> None:
    snapshot = rope(nodes=9)
    table = snapshot.contacts
    assert table is not None
    found = measures.contact_statistics(snapshot)
    assert found.elements == 200 and found.active == (table.gap < 0).sum()
    assert found.max_penetration_over_radius == pytest.approx(-table.gap.min() / 0.86)
    assert found.mean_mobilisation == pytest.approx(0.05)
    assert measures.contact_statistics(replace(snapshot, contacts=None)).elements == 0


def test_linear_fit_takes_the_first_loading_above_half_the_force() -> None:
    strain = np.linspace(0.0, 0.01, 21)
    force = np.where(strain < 0.003, 100 * strain, 0.3 + 9500 * (strain - 0.003))
    unload = slice(None, 10, -1)
    cycle = np.append(strain, strain[unload]), np.append(force, 0.8 * force[unload])
    fit = measures.linear_fit(*cycle)
    assert fit.stiffness == pytest.approx(9500.0)
    assert fit.offset == pytest.approx(0.003 - 0.3 / 9500)
    assert fit.last_strain == 0.01
    with pytest.raises(ValueError, match="smaller increments"):
        measures.linear_fit(np.array([0.0, 0.01]), np.array([0.0, 10.0]))
