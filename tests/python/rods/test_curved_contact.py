"""Rods that touch in the middle of long curved elements, whose chords are more than a radius away."""

import numpy as np
import pytest

from braidx.rods import Beam, Cable, Rods, YarnMaterial, arc, straight
from braidx.rods.overlap import hidden_overlap
from braidx.rods.passing import Chords, refuse_passing
from braidx.solver.trial import Diverged

MATERIAL = YarnMaterial.isotropic(1e3, 0.3)
RADIUS, BEND = 1.0, 20.0
SPANS, ANGLE = 6, 0.75 * np.pi  # three elements of degree 2, each with a sagitta of 1.5 mm


def arc_and_rod(degree, radius, gap, kind="beam"):
    """Elements of 45 degrees, and a rod across the middle of one of them, at a gap outside; the way outwards."""
    line = arc(BEND, ANGLE, SPANS if degree == 2 else SPANS // 2)
    out = np.array([np.sin(ANGLE / 2), -np.cos(ANGLE / 2), 0.0])
    bent = (
        Beam(line, RADIUS, MATERIAL, degree=degree)
        if kind == "beam"
        else Cable(line, RADIUS, 3e3, tension=10.0, degree=degree)
    )
    bare = Rods([bent], contact=False)
    middle = sampled(bare, 0, degree)[SAMPLES * 3 // 2]
    place = middle + (RADIUS + radius + gap) * out
    across = straight(place - [0, 0, 4.3], place + [0, 0, 5.1], 4)
    return Rods([bent, Beam(across, radius, MATERIAL)]), out


SAMPLES = 40  # of an element, even


def sampled(rods, rod, degree=2):
    """Points on the true curve of a rod, an element after the other: through three nodes, or by Hermite's formula."""
    nodes = rods.positions(rod)
    t = np.linspace(0.0, 1.0, SAMPLES + 1)[:-1, None]
    parts = []
    if degree == 2:
        for a, b, c in zip(nodes[:-2:2], nodes[1:-1:2], nodes[2::2], strict=True):
            parts.append((1 - t) * (1 - 2 * t) * a + 4 * t * (1 - t) * b + t * (2 * t - 1) * c)
    else:
        slopes = np.gradient(nodes, axis=0, edge_order=2)
        for i in range(len(nodes) - 1):
            a, b, u, v = *nodes[i : i + 2], *slopes[i : i + 2]
            hermite = (1 + 2 * t) * (1 - t) ** 2 * a + t * t * (3 - 2 * t) * b
            parts.append(hermite + t * (1 - t) ** 2 * u - t * t * (1 - t) * v)
    return np.concatenate([*parts, nodes[-1:]])


def distance(rods, degree):
    first, second = sampled(rods, 0, degree), sampled(rods, 1)
    return np.linalg.norm(first[:, None] - second[None], axis=2).min()


@pytest.mark.parametrize("kind", ["beam", "cable"])
@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("radius", [0.3, 1.0])
def test_contact_on_a_long_element_is_found_at_any_depth(degree, kind, radius):
    for share in (-0.1, -0.5, -1.0, -1.2):
        gap = share * radius
        rods, _ = arc_and_rod(degree, radius, gap, kind)
        assert distance(rods, degree) == pytest.approx(RADIUS + radius + gap, abs=5e-3)
        rods.contact.start = rods.q
        depth, *pair = hidden_overlap(rods.contact, rods.q)
        assert depth == pytest.approx(-gap, abs=1e-3 * radius) and pair == [0, 1]
        rods.contact.update(rods.q)
        assert rods.contact.deepest_penetration(rods.q) == pytest.approx(-gap, abs=1e-3 * radius)


def test_a_rod_is_stopped_by_the_middle_of_a_long_element():
    rods, out = arc_and_rod(2, RADIUS, 0.1)
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    rods.move(1, [0, -1], by=-0.4 * out)
    steps = rods.solve(2)
    assert steps[-1].penetration < 0.011 * RADIUS
    assert distance(rods, 2) > 2 * RADIUS * (1 - 0.01)
    pushed = rods.reaction(1, 0)[0] + rods.reaction(1, -1)[0]
    held = rods.reaction(0, 0)[0] + rods.reaction(0, -1)[0]
    assert pushed @ -out > 1.0
    np.testing.assert_allclose(pushed, -held, atol=1e-4 * np.linalg.norm(pushed))


@pytest.mark.parametrize("degree", [1, 2])
def test_centre_lines_that_meet_between_nodes_are_seen(degree):
    """Where chords between nodes are 1.5 mm, or for degree 1 as far as splines allow, off the curve."""
    bent = Beam(arc(BEND, np.pi, 4), RADIUS, MATERIAL, degree=degree)
    curve = sampled(Rods([bent]), 0, degree)
    place = curve[SAMPLES // (2 * degree)]
    out = (place - [0, BEND, 0]) / np.linalg.norm(place - [0, BEND, 0])

    def at(gap):
        across = straight(place + gap * out - [0, 0, 4], place + gap * out + [0, 0, 5], 4)
        return Rods([bent, Beam(across, RADIUS, MATERIAL)])

    for gap, meets in ((-0.8, True), (0.0, True), (0.9, True), (1.1, False)):
        rods = at(gap)
        met = Chords.of(rods.layout, rods.contact, rods.q).meetings(rods.q)
        assert met == ({(0, 1)} if meets else set()), gap
    outside, inside = at(2.5), at(-2.5)
    with pytest.raises(Diverged, match="rod 0 would go through rod 1"):
        refuse_passing(outside.layout, outside.contact, outside.q, inside.q)
    refuse_passing(outside.layout, outside.contact, outside.q, outside.q)
