"""Rods that would go through each other: one search over all chords finds what a look at each two of them does."""

from itertools import combinations_with_replacement

import numpy as np
import pytest

from braidx.rods import Beam, Cable, Rods, YarnMaterial, curve, straight
from braidx.rods.passing import NEAR, Chords, refuse_passing
from braidx.solver.trial import Diverged

EXCLUDED = 3.0  # radii along a rod
NUMBER = 6


def distance(a, b, c, d):
    """Of two straight pieces, from ends to pieces and, where they cross, between the lines."""

    def to_piece(point, begin, end):
        share = np.dot(point - begin, end - begin) / np.dot(end - begin, end - begin)
        return np.linalg.norm(begin + np.clip(share, 0.0, 1.0) * (end - begin) - point)

    ends = min(to_piece(a, c, d), to_piece(b, c, d), to_piece(c, a, b), to_piece(d, a, b))
    normal = np.cross(b - a, d - c)
    apart = np.dot(c - a, normal) / np.linalg.norm(normal)
    # Seen along the common normal the pieces cross where each goes from one side of the other to the other.
    sides = [np.dot(np.cross(b - a, x - a), normal) for x in (c, d)]
    others = [np.dot(np.cross(d - c, x - c), normal) for x in (a, b)]
    return abs(apart) if np.prod(sides) < 0.0 and np.prod(others) < 0.0 else ends


def meet(rods, a, b):
    lines = rods.positions(a), rods.positions(b)
    limit = NEAR * (rods.rods[a].radius + rods.rods[b].radius)
    arc = np.append(0.0, np.linalg.norm(np.diff(lines[0], axis=0), axis=1).cumsum())
    return any(
        distance(*lines[0][i : i + 2], *lines[1][j : j + 2]) < limit
        for i in range(len(lines[0]) - 1)
        for j in range(len(lines[1]) - 1)
        if a != b or max(arc[i] - arc[j + 1], arc[j] - arc[i + 1]) > EXCLUDED * rods.rods[a].radius
    )


def tangle(seed, **options):
    """Curved rods of several radii, with chords of several lengths, some of which meet, themselves too."""
    random = np.random.default_rng(seed)
    material, parts = YarnMaterial.isotropic(1e3, 0.3), []
    for number in range(NUMBER):
        start, speed, phase = random.uniform(-7, 7, 3), random.normal(size=3), random.uniform(0, 6)

        def point(t, start=start, speed=speed, phase=phase):
            wave = np.stack([np.sin(t + phase), np.cos(t * 1.1), np.sin(1.7 * t)], axis=1)
            return start + 3.0 * wave + t[:, None] * speed

        line = curve(point, 0.0, 5.0, int(random.choice([6, 10, 24])))
        radius = float(random.choice([0.2, 0.4, 0.8]))
        parts.append(
            Beam(line, radius, material) if number % 2 else Cable(line, radius, 1e3, tension=1.0)
        )
    return Rods(parts, **options)


@pytest.mark.parametrize("options", [{}, {"self_contact": EXCLUDED}, {"contact": False}])
def test_meetings_are_those_of_a_look_at_all_pairs(options):
    found, others, themselves = 0, options.get("contact", True), "self_contact" in options
    for seed in range(2):
        rods = tangle(seed, **options)
        asked = [
            (a, b)
            for a, b in combinations_with_replacement(range(NUMBER), 2)
            if (themselves if a == b else others)
        ]
        expected = {pair for pair in asked if meet(rods, *pair)}
        assert Chords.of(rods.layout, rods.contact).meetings(rods.q) == expected
        found += sum(a == b if themselves else 1 for a, b in expected)
    assert bool(found) == (others or themselves)


def crossing_at(height, **options):
    """Two beams of radius 1 across each other, the upper one at a height."""
    material = YarnMaterial.isotropic(1e3, 0.3)
    lines = [straight((-8, 0, 0), (8, 0, 0), 8), straight((0, -8, height), (0, 8, height), 8)]
    return Rods([Beam(line, 1.0, material) for line in lines], **options)


def passed(rods, before, after, **options):
    try:
        refuse_passing(rods.layout, rods.contact, before, after, **options)
    except Diverged as refused:
        return str(refused)
    return ""


def moved(rods, rod, by):
    after = rods.q.copy()
    after[rods.layout.unknowns(rod, slice(None))[:, :3]] += by
    return after


@pytest.mark.parametrize("way", [5.0, 300.0, 3e4])
def test_no_way_is_too_long_for_a_passage_to_be_seen(way):
    """Rods that meet on a thousandth of their way, and such as pass beside each other."""
    rods = crossing_at(3.0)
    far = moved(rods, 1, (0.0, 0.0, 0.9 * way))
    assert "go through" in passed(rods, far, moved(rods, 1, (0.0, 0.0, -0.1 * way - 5.0)))
    aside = far.copy()
    aside[rods.layout.unknowns(1, slice(None))[:, 0]] += 20.0
    down = moved(rods, 1, (20.0, 0.0, -0.1 * way - 5.0))
    assert passed(rods, aside, down) == ""
    assert passed(rods, rods.q, rods.q + way) == ""  # both together


def test_long_ways_are_looked_at_where_rods_are_near(monkeypatch):
    rods, looks = crossing_at(3.0), []
    meetings = Chords.meetings
    monkeypatch.setattr(Chords, "meetings", lambda *args: looks.append(args) or meetings(*args))
    assert passed(rods, rods.q, moved(rods, 1, (0.0, 0.0, 3e3))) == ""
    assert len(looks) < 3e3 / 2.0 / 0.5 / 2.0  # every chord's length, not every half radius


@pytest.mark.parametrize("leap", [False, True])
def test_a_state_with_rods_deep_in_each_other_is_refused_however_it_was_reached(leap):
    rods = crossing_at(0.9)
    assert passed(rods, rods.q, rods.q, leap=leap) == "rods 0 and 1 are deep in each other"
    rods = crossing_at(1.1)
    assert passed(rods, rods.q, rods.q, leap=leap) == ""


def test_neighbours_on_a_rod_do_not_meet():
    """Chords longer than the length within which a rod does not touch itself."""
    rods = Rods(
        [Cable(straight((0, 0, 0), (80, 0, 0), 8), 1.0, 1e3, tension=1.0)], self_contact=EXCLUDED
    )
    assert not Chords.of(rods.layout, rods.contact).meetings(rods.q)
