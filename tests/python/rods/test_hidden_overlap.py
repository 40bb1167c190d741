"""Rods that overlap beside their contact elements: seen, and mended or refused."""

import braidx_engine as engine
import numpy as np
import pytest

from braidx.rods import Beam, NotConverged, Rods, YarnMaterial, equilibria, straight
from braidx.rods.overlap import hidden_overlap

POINT = np.iinfo(np.int64).max  # number of a station where curves cross
JUMP = 3.4  # mm: more than the 2 mm between stations, and to the middle between two


def pressed():
    """Beams of radius 1 that cross at a right angle; the ends of the upper one have come down by 1.5 mm."""
    lines = [straight((-20, 0, 0), (20, 0, 0), 20), straight((0.6, -20, 2), (0.6, 20, 2), 20)]
    rods = Rods([Beam(line, 1.0, YarnMaterial.isotropic(1000.0, 0.3)) for line in lines])
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    rods.move(1, [0, -1], by=(0.0, 0.0, -1.5))
    return rods


def elsewhere(rods):
    """A first guess in which the beams cross where they do not in the end."""
    guess, along = rods.q.copy(), np.linspace(0.0, np.pi, len(rods.positions(1)))
    guess[rods.layout.unknowns(1, slice(None))[:, 0]] += JUMP * np.sin(along) ** 2
    return guess


def distance(rods):
    """Of the centre lines, mm, from a fine sampling of the quadratic elements."""
    lines = []
    for rod in (0, 1):
        nodes = rods.positions(rod)
        a, b, c = nodes[:-1:2, None], nodes[1::2, None], nodes[2::2, None]
        s = np.linspace(0.0, 1.0, 41)[:, None]
        curve = (1 - s) * (1 - 2 * s) * a + 4 * s * (1 - s) * b + s * (2 * s - 1) * c
        lines.append(curve.reshape(-1, 3))
    return np.linalg.norm(lines[0][:, None] - lines[1][None], axis=-1).min()


def test_a_crossing_that_jumps_is_found_again():
    rods = pressed()
    rods.solve(1)
    rods.move(1, [0, -1], by=(0.0, 0.0, -0.2))
    rods.solve(1, guess=elsewhere(rods))
    assert distance(rods) == pytest.approx(2.0, abs=0.02)
    gaps = rods.contacts()["gap"]
    assert distance(rods) - 2.0 == pytest.approx(gaps.min(), abs=2e-3)


def without_points(elements):
    """Contact elements but for those where rods cross."""
    arrays = elements.arrays()
    lines = arrays["station"] < POINT
    assert not lines.all()
    return engine.ContactElements.from_arrays({name: part[lines] for name, part in arrays.items()})


def test_contact_elements_made_anew_see_a_crossing_that_is_lost():
    rods = pressed()
    rods.solve(1)
    moved, contact = elsewhere(rods), rods.contact
    contact.update(moved)
    assert hidden_overlap(contact, moved)[0] == 0.0
    deepest = -contact.results(moved)["gap"].min()
    contact.restore(without_points(contact.elements))
    assert contact.results(moved)["gap"].min() > 0.0
    depth, a, b = hidden_overlap(contact, moved)
    assert (a, b) == (0, 1) and depth > 0.02
    assert depth == pytest.approx(deepest, rel=1e-3)


@pytest.mark.parametrize("hidden", [1, 9])
def test_what_hides_an_overlap_is_solved_again_and_refused_in_the_end(monkeypatch, hidden):
    """With an overlap that is hidden as often as told."""
    left = [(0.3, 0, 1)] * hidden
    monkeypatch.setattr(
        equilibria, "hidden_overlap", lambda *_: left.pop() if left else (0.0, 0, 0)
    )
    rods = pressed()
    if hidden < equilibria.LOOKS:
        rods.solve(1)
        assert not left and distance(rods) == pytest.approx(2.0, abs=0.02)
        return
    with pytest.raises(NotConverged, match="rods 0 and 1 overlap by 0.3 mm more than contact sees"):
        rods.solve(1, max_cuts=0)
    assert len(rods.contact.elements) == 0  # as before
