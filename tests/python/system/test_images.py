"""What acts between images of a symmetric rope is left out: nothing that anybody asks for changes."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import scipy.sparse as sp
from mpi4py import MPI

from braidx.contact.tubes import engine_tubes
from braidx.processes.start import make_model, start_state
from braidx.scene import load_scene

SMALL = Path(__file__).parents[3] / "demos" / "small_rope.toml"


def small_rope(model):
    """Eight yarns, four times two that are images of one another, as placed and a little shaken, symmetrically."""
    overrides = [
        f"yarn.model={model}",
        "contact.friction=0.2",
        "braid.helix_radius=3.0",
    ]
    scene = load_scene(SMALL, overrides)
    scene = replace(scene, steps=scene.steps[1:])  # in its own model from the start
    state = start_state(scene)
    rope = make_model(MPI.COMM_SELF, scene, state)
    system = rope.system
    rng = np.random.default_rng(3)
    p = system.free_values(state.q)
    rope.set_viscosity(3.0, 200.0)
    rope.loads.loads[rope.ends.nodes.last_axial] = 10.0
    rope.contact.start = system.expand(p - 1e-2 * rng.standard_normal(len(p)))
    q = system.expand(p + 2e-3 * rng.standard_normal(len(p)))
    rope.contact.update(q)
    return rope, q


def without_images(rope, q):
    """The same model again, whose contact elements are all asked for."""
    contact = rope.contact
    contact.tubes = engine_tubes(replace(contact.layout, is_image=None), True, contact.beyond)
    contact.forget_pattern()
    contact.update(q)
    return rope


def evaluated(rope, q):
    """Reduced residual and tangent, force on the rope, norms of terms, and entries of the contact tangent."""
    system = rope.system
    system.update_pattern()
    system.set_state(q)
    system.assemble_residual(system.vector)
    residual = system.gather(system.vector)
    system.assemble_tangent()
    indptr, indices, data = system.matrix.getValuesCSR()
    tangent = sp.csr_matrix((data, indices, indptr), shape=system.matrix.getSize())
    entries = len(rope.contact.tangent_pattern()[0])
    return residual, tangent.toarray(), rope.axial_force(q), system.term_norms, entries


@pytest.fixture(scope="module", params=["cable", "beam"])
def both(request):
    rope, q = small_rope(request.param)
    assert rope.contact.layout.is_image.sum() == 6
    assert (rope.contact.results(q)["gap"] < 0).sum() > 20
    images = evaluated(rope, q)
    return images, evaluated(without_images(rope, q), q), rope, q


def test_the_residual_is_unchanged(both):
    images, everything, *_ = both
    scale = np.linalg.norm(everything[0])
    assert np.linalg.norm(images[0] - everything[0]) < 1e-13 * scale


def test_the_tangent_is_unchanged_with_fewer_entries(both):
    images, everything, *_ = both
    scale = np.linalg.norm(everything[1])
    assert np.linalg.norm(images[1] - everything[1]) < 1e-13 * scale
    assert images[4] < 0.3 * everything[4]


def test_the_force_on_the_rope_is_that_of_all_yarns(both):
    images, everything, rope, q = both
    assert images[2] == everything[2]
    whole = (rope.system.residual() + rope.loads.loads)[rope.ends.nodes.last_axial].sum()
    assert images[2] == pytest.approx(whole, rel=1e-8)


def test_norms_of_terms_are_those_of_all_yarns(both):
    images, everything, rope, _ = both
    np.testing.assert_allclose(images[3], everything[3], rtol=1e-13)
    parts = np.zeros((len(rope.system.terms), len(rope.system.q)))
    for part, term in zip(parts, rope.system.terms, strict=True):
        term.add_residual(part)
    parts[1:, rope.system.constraints.held] = 0.0  # of what bodies ask of supports, all counts
    np.testing.assert_allclose(images[3], np.linalg.norm(parts, axis=1), rtol=1e-6)
