"""Closed rods: nothing at their joint differs from what is elsewhere, and rings do what is known of them."""

import numpy as np
import pytest

from braidx.rods import Beam, Cable, Rods, Solid, YarnMaterial, ring, straight

STEEL = YarnMaterial.isotropic(2e4, 0.3)
SPANS = 48


@pytest.mark.parametrize("degree", [1, 2])
def test_a_ring_at_rest_stays_at_rest(degree):
    line = ring(80.0, SPANS)
    rods = Rods([Beam(line, 1.2, STEEL, degree=degree, closed=True)], self_contact=8.0)
    rods.clamp(0, [0, -1])
    (found,) = rods.solve()
    assert found.penetration == 0.0 and found.contact_elements == 0
    assert np.abs(rods.reaction(0, 0)[0]).max() < 1e-8
    assert rods.positions(0) == pytest.approx(line, abs=1e-9)
    assert rods.positions(0)[0] == pytest.approx(rods.positions(0)[-1], abs=0.0)


@pytest.mark.parametrize("degree", [1, 2])
def test_hoop_tension_is_q_times_r(degree):
    """A ring under a load per length q outwards: T = q R, with lengths and R at rest."""
    radius, load, stiffness = 80.0, 2.0, 1e5
    line = ring(radius, SPANS)
    cable = Cable(line, 1.2, stiffness, tension=10.0, degree=degree, closed=True)
    rods = Rods([cable])
    rods.hold(0, slice(None), 2)
    rods.hold(0, [0, SPANS // 2], 1)
    rods.hold(0, [SPANS // 4, 3 * SPANS // 4], 0)
    lengths = rods.layout.lengths[rods.layout.unknowns(0, slice(0, SPANS))[:, 0]]
    for node in range(SPANS):
        rods.force(0, node, load * lengths[node] * line[node] / radius)
    rods.solve(2)
    # Chords of elements of degree 1 are in equilibrium with forces of their length exactly.
    expected = load * radius
    assert rods.tension(0) == pytest.approx(expected, rel=1e-8 if degree == 1 else 1e-3)
    grown = np.linalg.norm(rods.positions(0), axis=1) / radius
    assert grown == pytest.approx(1.0 + (expected - 10.0) / stiffness, abs=2e-5)


@pytest.mark.parametrize("at", [0, 7])
def test_a_ring_that_is_squeezed(at):
    """Two opposite forces P bring each other nearer by (pi/4 - 2/pi) P R^3 / EI, at the joint and elsewhere."""
    radius, thickness, force = 80.0, 0.8, 1e-3
    rods = Rods([Beam(ring(radius, SPANS), thickness, STEEL, closed=True)])
    ends, across = [at, at + SPANS // 2], [at + SPANS // 4, (at + 3 * SPANS // 4) % SPANS]
    inwards = -rods.rods[0].line[at] / radius
    rods.hold(0, slice(None), 2)
    for group in (ends, across):
        rods.hold_mean([(0, node) for node in group], [0, 1])
    rods.force(0, ends[0], force * inwards)
    rods.force(0, ends[1], -force * inwards)
    before = rods.positions(0)[ends]
    rods.solve()
    after = rods.positions(0)[ends]
    nearer = (np.linalg.norm(np.diff(x, axis=0)) for x in (before, after))
    bending = 2e4 * np.pi * thickness**4 / 4.0
    expected = (np.pi / 4.0 - 2.0 / np.pi) * force * radius**3 / bending
    assert next(nearer) - next(nearer) == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize("angle", [0.5 * np.pi, np.pi])
def test_energy_of_a_ring_turned_inside_out(angle):
    """All sections turned about the line: 2 pi EI / R (1 - cos(angle))."""
    radius, thickness = 80.0, 1.2
    rods = Rods([Beam(ring(radius, SPANS), thickness, STEEL, closed=True)])
    rods.clamp(0, slice(None))
    around = np.linspace(0.0, 2.0 * np.pi, SPANS + 1)[:-1]
    for node, at in enumerate(around):
        rods.move(0, node, turn=angle * np.array([-np.sin(at), np.cos(at), 0.0]))
    rods.solve(2)
    bending = 2e4 * np.pi * thickness**4 / 4.0
    expected = 2.0 * np.pi * bending / radius * (1.0 - np.cos(angle))
    assert rods.elastic_energy() == pytest.approx(expected, rel=5e-3)


def dented(spans, start):
    """A ring whose opposite sides nearly touch, which begins at one of its nodes."""
    at = 2.0 * np.pi * (np.arange(spans + 1) + start) / spans
    radius = 4.0 + 3.0 * np.cos(2.0 * at) + 0.1 * np.cos(at - 0.4)
    return np.stack([radius * np.cos(at), radius * np.sin(at), 0.02 * np.cos(3.0 * at)], axis=1)


def forces(model, degree, start, rod):
    """Contact forces on the nodes of a ring that begins at a node, in its own order, and on a rod across it."""
    line = dented(SPANS, start)
    options = {"tension": 1.0} if model is Cable else {}
    made = model(
        line, 1.05, 1e3 if model is Cable else STEEL, degree=degree, closed=True, **options
    )
    rods = Rods(
        [made, Cable(rod, 0.9, 1e3, tension=1.0)], self_contact=5.0, penalty=10.0, spacing=0.1
    )
    residual = np.zeros(rods.q.size)
    rods.contact.update(rods.q)
    rods.contact.set_state(rods.q)
    rods.contact.start = rods.q
    rods.contact.add_residual(residual)
    (own, other) = (residual[rods.layout.unknowns(i, slice(None))[:, :3]] for i in (0, 1))
    return np.roll(own[:-1], start, axis=0), other


@pytest.mark.parametrize("crossed", ["node", "element"])
@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("model", [Beam, Cable])
def test_contact_does_not_depend_on_where_the_joint_is(model, degree, crossed):
    """A ring that touches itself and a rod, with its joint at the contacts, between nodes of them, and far away."""
    place = dented(SPANS, 0)[[0, 1]].mean(axis=0) if crossed == "element" else dented(SPANS, 0)[0]
    rod = straight(place + [0.0, 0.0, -9.0], place + [0.0, 0.3, 9.0], 8) + [1.7, 0.0, 0.0]
    far = forces(model, degree, 6, rod)
    assert np.abs(far[0]).max() > 0.1 and np.abs(far[1]).max() > 0.1
    scale = max(np.abs(far[0]).max(), np.abs(far[1]).max())
    # Stations are cut at the joint; curves of degree 2 have kinks at their nodes, where these count more.
    share = {1: 0.02, 2: 0.06}[degree]
    for start in (0, 2, 12, 46):
        near = forces(model, degree, start, rod)
        for one, other in zip(near, far, strict=True):
            assert one == pytest.approx(other, abs=share * scale)


def test_impossible_rings_are_refused():
    with pytest.raises(
        ValueError, match="rod 0 is closed, and its last node is 20 mm from its first"
    ):
        Rods([Beam(straight((0, 0, 0), (20, 0, 0), 8), 1.0, STEEL, closed=True)])
    with pytest.raises(ValueError, match="rod 0 is closed and has 3 elements: give 4 or more"):
        Rods([Beam(ring(20.0, 6), 1.0, STEEL, closed=True)])
    with pytest.raises(ValueError, match="Solid has two ends, give a Beam or a Cable"):
        Solid(ring(20.0, 16), 1.0, STEEL, closed=True)


def test_a_ring_moves_and_weighs_what_it_is_made_of():
    rods = Rods([Beam(ring(20.0, 16), 1.0, STEEL, closed=True, density=1e-9)])
    positions = ~rods.layout.is_director
    chords = np.linalg.norm(np.diff(rods.rods[0].line, axis=0), axis=1).sum()
    assert rods.layout.mass[positions].sum() / 3.0 == pytest.approx(1e-9 * np.pi * chords)
    velocity = np.zeros(rods.q.size)
    velocity[rods.layout.unknowns(0, slice(None))[:, 2]] = 5.0
    rods.run(1e-3, 5e-4, velocity=velocity)
    assert rods.positions(0)[:, 2] == pytest.approx(5e-3, rel=1e-6)
