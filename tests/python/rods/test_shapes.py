"""Shapes that rods are placed in."""

import numpy as np
import pytest

from braidx.rods import Beam, Cable, Rods, YarnMaterial, helix, straight

T = np.linspace(0.0, 1.0, 2001)[:, None, None]  # along an element
RADIUS, PITCH, CORE = 2.0, 30.0, 1.1


def parabolas(nodes):
    """Points of elements of degree 2, shape (len(T), num_elements, 3)."""
    first, middle, last = nodes[:-2:2], nodes[1::2], nodes[2::2]
    return (1 - T) * (1 - 2 * T) * first + 4 * T * (1 - T) * middle + T * (2 * T - 1) * last


def splines(nodes):
    """Points of Catmull-Rom splines, which are means of the parabolas on either side; those at the ends are one."""
    before, here, after = nodes[:-2], nodes[1:-1], nodes[2:]
    back = T * (T - 1) / 2 * before + (1 - T**2) * here + T * (T + 1) / 2 * after  # from `here` on
    s = T - 1
    fore = s * (s - 1) / 2 * before + (1 - s**2) * here + s * (s + 1) / 2 * after  # up to `here`
    return np.concatenate([fore[:, :1], (1 - T) * back[:, :-1] + T * fore[:, 1:], back[:, -1:]], 1)


def from_axis(points):
    return np.hypot(points[..., 0], points[..., 1])


@pytest.mark.parametrize("spans", [4, 8, 16, 32])
def test_no_curve_through_the_nodes_of_a_helix_comes_nearer_to_the_axis(spans):
    """Sampled: parabolas through three nodes come as near as the radius, and nothing comes nearer."""
    nodes = helix(RADIUS, PITCH, PITCH, spans, phase=0.3)
    assert from_axis(parabolas(nodes)).min() == pytest.approx(RADIUS, rel=1e-6)
    assert from_axis(splines(nodes)).min() == pytest.approx(RADIUS, rel=1e-6)
    assert from_axis(splines(nodes)[:, 1:-1]).min() >= RADIUS


def test_a_helix_of_fewer_than_four_spans_in_a_turn_is_refused():
    with pytest.raises(
        ValueError, match="num_spans = 7: a helix needs four spans in a turn, here 8"
    ):
        helix(RADIUS, PITCH, 2.0 * PITCH, 7)


@pytest.mark.parametrize("kind", ["beams", "cables"])
@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("spans", [8, 16, 32])
def test_a_strand_carries_no_force_before_it_is_pulled(kind, degree, spans):
    """Six on a core: with nodes on the radius, deep in it by 0.1 to 0.0001 mm and pressed by 2800 to 2 N."""
    lines = [straight((0, 0, 0), (0, 0, PITCH), spans)]
    lines += [helix(RADIUS, PITCH, PITCH, spans, phase) for phase in np.arange(6) * np.pi / 3]
    radii = [CORE] + 6 * [RADIUS - CORE]
    if kind == "beams":
        steel = YarnMaterial.isotropic(2e5, 0.3)
        parts = [Beam(x, r, steel, degree=degree) for x, r in zip(lines, radii, strict=True)]
    else:
        parts = [Cable(x, r, 6e5, degree=degree) for x, r in zip(lines, radii, strict=True)]
    rods = Rods(parts)
    rods.contact.update(rods.q)
    rods.contact.set_state(rods.q)
    force = np.zeros(rods.q.size)
    rods.contact.add_residual(force)
    touching = rods.contact.results(rods.q)
    assert (touching["gap"] < 1e-2).any()  # places are looked at
    assert touching["gap"].min() >= -1e-12 and np.abs(force).max() < 1e-9
