"""C9 at the level of a rope: contact forces of all yarns balance, and no yarn is special."""

from pathlib import Path

import numpy as np
import pytest
from mpi4py import MPI

from braidx.bodies import BeamBody, BeamSection, CableBody, CurveBody, YarnMaterial
from braidx.contact.contact import Contact
from braidx.geometry import build_rope
from braidx.rods.surfaces import body_tubes
from braidx.scene import load_scene

SCENE = load_scene(Path(__file__).parents[3] / "demos" / "twisted_strand.toml")
ROPE = build_rope(SCENE)
RADIUS = 1.02 * SCENE.yarn.radius  # the yarns press on each other


def yarns(lines, beams) -> CurveBody:
    if not beams:
        return CableBody(MPI.COMM_SELF, lines, axial_stiffness=1e5)
    section, material = BeamSection.round(RADIUS), YarnMaterial.isotropic(1e3, 0.3)
    return BeamBody(MPI.COMM_SELF, lines, section=section, material=material)


def contact_forces(body, q, start, friction):
    """Forces of contact on all unknowns, shape as q, after a step from `start` to `q`."""
    contact = Contact(MPI.COMM_SELF, body_tubes(body, RADIUS), smooth=True, symmetric=True)
    contact.laws.friction = [friction]
    contact.start = start.ravel()
    contact.update(q.ravel())
    contact.set_state(q.ravel())
    residual = np.zeros(q.size)
    contact.add_residual(residual)
    return -residual.reshape(q.shape)


def state(body, seed=1):
    """A shaken state, and one before in which every yarn was elsewhere along the axis."""
    rng = np.random.default_rng(seed)
    q = body.rest.copy()
    q[:, :3] += 0.005 * rng.standard_normal((len(q), 3))
    start = q.copy()
    yarn = np.repeat(np.arange(ROPE.num_yarns), np.diff(body.curves))
    start[:, 2] -= 0.05 * rng.standard_normal(ROPE.num_yarns)[yarn]
    return q, start


@pytest.mark.parametrize("beams", [False, True], ids=["cables", "beams"])
@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_forces_and_moments_sum_to_zero(record, beams, friction):
    """Friction of cables acts on their centre lines, two radii apart: it alone leaves a couple.

    Normal forces of beams balance up to the distance between the section that faces the other side and the one that
    carries the half width.
    """
    body = yarns(ROPE.centre_lines, beams)
    q, start = state(body)
    force = contact_forces(body, q, start, friction)
    size = np.abs(force[:, :3]).sum()
    assert size > 100
    total = force[:, :3].sum(axis=0)
    record.check("C9", "strand: sum of contact forces", total, 0.0, 1e-13, scale=size)
    if not friction:
        parts = range(0, q.shape[1], 3)
        moment = sum(np.cross(q[:, i : i + 3], force[:, i : i + 3]) for i in parts).sum(axis=0)
        kind, tolerance = ("beams", 1e-6) if beams else ("cables", 1e-13)
        what = f"strand of {kind}: sum of moments, no friction"
        record.check("C9", what, moment, 0.0, tolerance, scale=size * ROPE.length)


@pytest.mark.parametrize("beams", [False, True], ids=["cables", "beams"])
@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_order_of_the_yarns_does_not_matter(record, beams, friction):
    body, reversed_body = yarns(ROPE.centre_lines, beams), yarns(ROPE.centre_lines[::-1], beams)

    def backwards(nodal):
        return np.concatenate(np.split(nodal, ROPE.num_yarns)[::-1])

    q, start = state(body)
    force = contact_forces(body, q, start, friction)
    swapped = contact_forces(reversed_body, backwards(q), backwards(start), friction)
    what, size = "strand: contact forces, yarns in reversed order", np.abs(force).max()
    record.check("C9", what, backwards(swapped), force, 1e-8, scale=size)
