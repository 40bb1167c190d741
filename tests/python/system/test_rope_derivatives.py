"""Residual and tangent of a whole rope: body, contact, friction, stabilisation, loads, ends."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import scipy.sparse as sp
from mpi4py import MPI

from braidx.processes.start import make_model, start_state
from braidx.scene import EndConditions, EndGroup, load_scene

STRAND = Path(__file__).parents[3] / "demos" / "twisted_strand.toml"


GROUPS = {  # of the last ends: a body free to turn and tilt, means of all ends, and both one within the other
    "body": [("rope", True, {"x": "free"}, {"x": "free", "z": "free"})],
    "means": [("rope", False, {"x": "held", "z": "held"}, {"z": 3.0})],
    "bodies and means": [
        ("strand", True, {axis: "free" for axis in "xyz"}, {axis: "free" for axis in "xyz"}),
        ("rope", False, {"x": 0.1, "z": "held"}, {"y": "held", "z": 3.0}),
    ],
}


def grouped(scene, groups):
    """The scene with groups of its last ends, across the axis free."""
    tables = tuple(
        EndGroup(end="last", level=level, rigid=rigid, displacement=shift, rotation=turn)
        for level, rigid, shift, turn in GROUPS[groups]
    )
    sections = "fixed" if scene.yarn.model == "beam" else "free"
    return replace(scene, ends=EndConditions(transverse="free", sections=sections, groups=tables))


def strand_model(model, friction, transverse="periodic", groups=None):
    """A short strand that is pressed together and slides, at a state off equilibrium."""
    overrides = [
        f"yarn.model={model}",
        f"contact.friction={friction}",
        f"ends.transverse={transverse}",
        "solver.tangent=consistent",
        "strand.helix_radius=1.70",
        "rope.pitches=1",
        "yarn.elements_per_pitch=20",
        "material.filaments.bundle_factor=0.1",
    ]
    scene = load_scene(STRAND, overrides)
    scene = grouped(scene, groups) if groups else scene
    state = start_state(scene)
    rope_model = make_model(MPI.COMM_SELF, scene, state)
    rng = np.random.default_rng(3)
    q = state.q + 2e-3 * rng.standard_normal(len(state.q))
    system, contact = rope_model.system, rope_model.contact
    rope_model.set_viscosity(3.0, 200.0)
    rope_model.loads.loads[:] = rng.standard_normal(len(q))
    rope_model.proximal.start = state.q
    contact.start = q - 1e-2 * rng.standard_normal(len(q))
    ends = rope_model.ends
    q = ends.place(q, 0.01, 0.8)
    system.constraints, system.constraint_values = ends.held(0.01, 0.8, q)
    contact.update(q)
    system.update_pattern()
    return rope_model, q


def reduced_residual(system, free_values):
    system.set_state(system.expand(free_values))
    return system.constraints.reduce(system.residual())


def tangent_matrix(system, free_values):
    system.set_state(system.expand(free_values))
    system.assemble_tangent()
    indptr, indices, data = system.matrix.getValuesCSR()
    return sp.csr_matrix((data, indices, indptr), shape=system.matrix.getSize())


def relative_error(system, p, seed=4):
    """Of the tangent in random directions, against central differences."""
    rng, tangent, errors = np.random.default_rng(seed), tangent_matrix(system, p), []
    for _ in range(4):
        step = 1e-7 * rng.standard_normal(len(p))
        change = reduced_residual(system, p + step) - reduced_residual(system, p - step)
        errors.append(np.linalg.norm(change - 2 * tangent @ step) / np.linalg.norm(change))
    return max(errors)


@pytest.mark.parametrize("transverse", ["periodic", "fixed", "free"])
@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("model", ["cable", "beam"])
def test_tangent_is_the_derivative_of_the_residual(model, friction, transverse):
    rope_model, q = strand_model(model, friction, transverse)
    system = rope_model.system
    assert (rope_model.contact.results(q)["gap"] < 0).sum() > 20
    assert relative_error(system, system.free_values(q)) < 1e-5


@pytest.mark.parametrize("groups", GROUPS)
@pytest.mark.parametrize("model", ["cable", "beam"])
def test_tangent_with_groups_of_ends(model, groups):
    rope_model, q = strand_model(model, 0.3, groups=groups)
    system = rope_model.system
    assert relative_error(system, system.free_values(q)) < 1e-5
