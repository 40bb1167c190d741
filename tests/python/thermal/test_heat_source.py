"""Work of friction as heat sources: all of it arrives, and where it belongs."""

from __future__ import annotations

import numpy as np
import pytest

from braidx.thermal import crossing_powers, spread
from braidx.thermal.source import cell_volumes

RADIAL, AXIAL = np.linspace(0.0, 6.0, 13), np.linspace(0.0, 40.0, 31)


def test_power_is_work_times_frequency() -> None:
    np.testing.assert_allclose(crossing_powers(np.array([2.0, 50.0]), 0.5), [1e-3, 25e-3])


def test_total_power_is_kept_exactly() -> None:
    generator = np.random.default_rng(0)
    count = 200
    angle, distance = generator.uniform(0, 2 * np.pi, count), generator.uniform(0, 6.5, count)
    z = generator.uniform(-0.5, 40.5, count)  # some rings reach beyond the body
    places = np.stack([distance * np.cos(angle), distance * np.sin(angle), z], axis=1)
    powers = generator.uniform(0, 1e-2, count)
    density = spread(RADIAL, AXIAL, places, powers, 1.0)
    total = (density * cell_volumes(RADIAL, AXIAL)).sum()
    assert total == pytest.approx(powers.sum(), rel=1e-13)
    assert density.min() >= 0.0


def test_a_source_fills_its_ring_evenly() -> None:
    place = np.array([[0.0, -4.0, 20.0]])
    density = spread(RADIAL, AXIAL, place, np.array([0.6]), 1.0)
    r, z = 0.5 * (RADIAL[1:] + RADIAL[:-1]), 0.5 * (AXIAL[1:] + AXIAL[:-1])
    inside = ((r > 3) & (r < 5))[:, None] & ((z > 19.4) & (z < 20.6))
    volume = np.pi * (25 - 9) * 2.0
    np.testing.assert_allclose(density[inside], 0.6 / volume)
    beyond = ((r < 3) | (r > 5))[:, None] | ((z < 18) | (z > 22))
    assert (density[np.broadcast_to(beyond, density.shape)] == 0.0).all()


def test_a_source_outside_is_named() -> None:
    for place, how in (([0.0, 9.0, 5.0], "radially"), ([0.0, 4.0, 45.0], "axially")):
        with pytest.raises(ValueError, match=how):
            spread(RADIAL, AXIAL, np.array([place]), np.ones(1), 1.0)
