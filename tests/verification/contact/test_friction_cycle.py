"""C2: a rod that slides to and fro dissipates 4 mu N (d - g_rev) per cycle (exact)."""

import braidx_engine as engine
import numpy as np
import pytest

from braidx.rods import Cable, Rods, straight

RADIUS, FORCE, FRICTION, REVERSIBLE = 1.0, 20.0, 0.2, 0.01
CASES = [(0.05, 1), (0.05, 4), (0.2, 3)]  # amplitude, mm; increments per amplitude
ALL = slice(None)


def pressed(lines, sliding, **options):
    """Rod `sliding` is pressed along -x by a dead load, to be moved along z; all others are held."""
    cables = [Cable(line, RADIUS, 1e5, tension=1e3) for line in lines]
    rods = Rods(cables, friction=FRICTION, penalty=1e3, penetration=None, tolerance=1e-9, **options)
    rods.contact.laws.reversible_slip = REVERSIBLE
    for rod in range(len(lines)):
        rods.hold(rod, components=[1, 2] if rod == sliding else ALL)
    rods.force(sliding, ALL, (-FORCE / len(lines[sliding]), 0.0, 0.0))
    rods.solve()
    return rods


def work_of_a_cycle(rods, sliding, amplitude, steps):
    """Slides to +d and on round the cycle -d, +d; work of the cycle, mJ."""
    works = []
    for direction in (1, -2, 2):
        rods.move(sliding, ALL, by=(0.0, 0.0, direction * amplitude))
        rods.solve(increments=abs(direction) * steps)
        works.append(rods.friction_work)
    return works[-1] - works[0]


@pytest.mark.parametrize("amplitude, steps", CASES)
def test_rod_on_a_plane(record, amplitude, steps):
    plane = engine.make_plane(np.zeros(3), np.array([1.0, 0, 0]), 0)
    line = straight((RADIUS - 0.01, -4, 0), (RADIUS - 0.01, 4, 0), 8)
    rods = pressed([line], 0, rigid=[plane])
    expected = 4 * FRICTION * FORCE * (amplitude - REVERSIBLE)
    what = f"work of a cycle on a plane, d = {amplitude:g} mm, {steps} steps"
    work = work_of_a_cycle(rods, 0, amplitude, steps)
    record.check("C2", what, work, expected, 1e-7, unknowns=rods.q.size)


@pytest.mark.parametrize("amplitude, steps", CASES)
def test_rod_across_a_rod(record, amplitude, steps):
    """The contact wanders over elements and stations on its way."""
    lines = [
        straight((0, 0, -6), (0, 0, 6), 12),
        straight((2 * RADIUS - 0.01, -4, 0), (2 * RADIUS - 0.01, 4, 0), 8),
    ]
    rods = pressed(lines, 1)
    expected = 4 * FRICTION * FORCE * (amplitude - REVERSIBLE)
    what = f"work of a cycle across a rod, d = {amplitude:g} mm, {steps} steps"
    work = work_of_a_cycle(rods, 1, amplitude, steps)
    record.check("C2", what, work, expected, 0.02, unknowns=rods.q.size)
