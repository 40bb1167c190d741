"""C2: a rod that slides to and fro dissipates 4 mu N (d - g_rev) per cycle."""

import braidx_engine as engine
import numpy as np
import pytest
from support import Rods, cables, straight

RADIUS, FORCE, FRICTION, REVERSIBLE = 1.0, 20.0, 0.2, 0.01
CASES = [(0.05, 1), (0.05, 4), (0.2, 3)]  # amplitude, mm; increments per amplitude


def pressed(lines, sliding, **options):
    """Rod `sliding` is moved along z and pressed along -x by a dead load; all others are held."""
    rods = Rods(
        cables(lines, 1e5, 1e3), RADIUS, penalty=1e3, friction=FRICTION, symmetric=False, **options
    )
    rods.contact.laws.reversible_slip = REVERSIBLE
    nodes = rods.nodes(sliding)
    rods.hold(slice(0, nodes.start))
    rods.hold(nodes, slice(1, 3))
    rods.loads[nodes, 0] = -FORCE / len(lines[sliding])
    rods.solve()
    return rods, nodes


def work_of_a_cycle(rods, nodes, amplitude, steps):
    """Slides to +d and on round the cycle -d, +d; work of the cycle, mJ."""
    works = []
    for direction in (1, -1, -1, 1, 1):
        for _ in range(steps):
            rods.held[nodes, 2] += direction * amplitude / steps
            works.append(rods.solve().friction_work)
    return sum(works[steps:])


@pytest.mark.parametrize("amplitude, steps", CASES)
def test_rod_on_a_plane(amplitude, steps):
    plane = engine.make_plane(np.zeros(3), np.array([1.0, 0, 0]), 0)
    line = straight((RADIUS - 0.01, -4, 0), (RADIUS - 0.01, 4, 0), 8)
    rods, nodes = pressed([line], 0, rigid=[plane])
    expected = 4 * FRICTION * FORCE * (amplitude - REVERSIBLE)
    assert work_of_a_cycle(rods, nodes, amplitude, steps) == pytest.approx(expected, rel=1e-7)


@pytest.mark.parametrize("amplitude, steps", CASES)
def test_rod_across_a_rod(amplitude, steps):
    """The contact wanders over elements and stations on its way."""
    lines = [
        straight((0, 0, -6), (0, 0, 6), 12),
        straight((2 * RADIUS - 0.01, -4, 0), (2 * RADIUS - 0.01, 4, 0), 8),
    ]
    rods, nodes = pressed(lines, 1)
    expected = 4 * FRICTION * FORCE * (amplitude - REVERSIBLE)
    assert work_of_a_cycle(rods, nodes, amplitude, steps) == pytest.approx(expected, rel=0.02)
