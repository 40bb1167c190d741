"""One pitch for all: symmetric while it is formed, laid end to end with its contacts' memory."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from mpi4py import MPI

from braidx.contact.tubes import engine_tubes
from braidx.geometry import build_rope
from braidx.processes.pitches import laid_end_to_end
from braidx.processes.start import make_model, start_state
from braidx.scene import load_scene

SMALL = Path(__file__).parents[3] / "demos" / "small_rope.toml"


@pytest.fixture(scope="module", params=["solver.symmetry=false", 'ends.transverse="fixed"'])
def cell(request):
    """One pitch of a rope of three, which does not stand for all, with fresh contact elements, and its state."""
    scene = load_scene(SMALL, ["rope.pitches=3", request.param])
    state = start_state(scene)
    model = make_model(MPI.COMM_SELF, scene, state)
    model.contact.update(state.q)
    slip = np.random.default_rng(0).standard_normal((len(model.contact.elements), 3))
    arrays = {**model.contact.arrays(), "slip": slip}
    model.contact.restore_arrays(arrays)
    return scene, model, replace(state, contacts=arrays)


def test_the_start_configuration_laid_end_to_end_is_the_whole_one(cell):
    scene, model, state = cell
    whole = laid_end_to_end(model, state)
    assert whole.model == "forming"
    lines = np.concatenate(build_rope(scene).centre_lines)
    assert np.allclose(whole.q.reshape(-1, 3), lines, atol=1e-9)
    assert make_model(MPI.COMM_SELF, scene, whole).body.num_unknowns == len(whole.q)


def test_contact_elements_made_anew_inherit_the_memory(cell):
    scene, model, state = cell
    whole = laid_end_to_end(model, state)
    rope = make_model(MPI.COMM_SELF, scene, whole)
    given = np.linalg.norm(rope.contact.results(whole.q)["slip"], axis=1)
    assert len(given) == 3 * len(state.contacts["weight"]) and given.min() > 0
    rope.contact.update(whole.q)
    made = rope.contact.results(whole.q)
    assert np.mean(np.linalg.norm(made["slip"], axis=1) > 0) > 0.9


@pytest.fixture
def disturbed():
    """One pitch without friction in a symmetric state near the start, and the free unknowns of that state."""
    scene = load_scene(SMALL, ["rope.pitches=3"])
    model = make_model(MPI.COMM_SELF, scene, start_state(scene))
    model.contact.laws.friction = [0.0]
    model.contact.laws.gap_step = -1.0
    model.body.set_properties(tension=20.0, axial_stiffness=200.0)
    system = model.system
    rng = np.random.default_rng(1)
    p = system.free_values(model.start) + 1e-3 * rng.standard_normal(system.num_free)
    q = system.expand(p)
    model.contact.start = model.proximal.start = q
    model.contact.update(q)
    model.contact.freeze_sections()
    return model, p


def test_equilibrium_of_leaders_is_that_of_all(disturbed):
    """In a symmetric state the reduced equations are those of virtual work over the number of images."""
    model, p = disturbed
    system, constraints = model.system, model.system.constraints
    assert system.num_free < model.body.num_unknowns / 4
    contact = model.contact
    contact.tubes = engine_tubes(replace(contact.layout, is_image=None), True, contact.beyond)
    system.set_state(system.expand(p))
    residual = system.residual()
    work = constraints.transform.T @ residual
    assert 4 * constraints.reduce(residual) == pytest.approx(work, abs=1e-6 * np.abs(work).max())


def test_the_tangent_of_a_symmetric_rope_is_the_derivative_of_its_residual(disturbed):
    model, p = disturbed
    system, constraints = model.system, model.system.constraints
    system.update_pattern()

    def reduced(values):
        system.set_state(system.expand(values))
        return constraints.reduce(system.residual())

    system.set_state(system.expand(p))
    system.assemble_tangent()
    step = 1e-7 * np.random.default_rng(2).standard_normal(len(p))
    product, direction = system.matrix.createVecs()
    direction.array[:] = step
    system.matrix.mult(direction, product)
    change = (reduced(p + step) - reduced(p - step)) / 2
    assert np.linalg.norm(change - product.array) < 1e-5 * np.linalg.norm(change)


@pytest.fixture(scope="module")
def alone_and_amid():
    """Forces of contact on one periodic pitch in a disturbed state, and on the pitch amid three of the same."""
    forces, works = [], []
    for pitches in (1, 3):
        scene = load_scene(SMALL, [f"rope.pitches={pitches}", "solver.symmetry=false"])
        one = load_scene(SMALL, ["solver.symmetry=false"])
        state = start_state(one)
        lines = state.q.reshape(-1, one.yarn.elements_per_pitch + 1, 3)
        shake = 0.02 * np.random.default_rng(3).standard_normal(lines.shape)
        shake[:, -1] = shake[:, 0]
        shake[:, [0, -1], 2] = 0.0
        q = lines + shake
        shifts = np.arange(pitches)[:, None, None] * [0.0, 0.0, one.rope.pitch]
        parts = [q[:, :-1] + shift for shift in shifts] + [q[:, -1:] + shifts[-1]]
        q = np.concatenate(parts, axis=1).ravel()
        whole = replace(state, model="cell" if pitches == 1 else "forming", q=q, reference=q)
        model = make_model(MPI.COMM_SELF, scene, whole)
        model.contact.start = q
        model.contact.update(q)
        model.contact.set_state(q)
        residual = np.zeros_like(q)
        model.contact.add_residual(residual)
        rows = residual.reshape(len(lines), -1, 3)
        per_pitch = rows.shape[1] // pitches
        amid = rows[:, per_pitch * (pitches // 2) :][:, : per_pitch + 1].copy()
        if pitches == 1:  # both ends are one node; amid, each belongs to two pitches
            amid[:, 0] += amid[:, -1]
            amid[:, 0, 2] = amid[:, -1, 2] = 0.0
            amid[:, -1] = amid[:, 0]
        else:
            amid[:, [0, -1], 2] = 0.0
        forces.append(amid)
        works.append(len(model.contact.elements) / pitches)
    return forces, works


def test_a_pitch_alone_feels_the_contact_of_a_pitch_amid_others(alone_and_amid):
    (alone, amid), (number_alone, number_amid) = alone_and_amid
    assert number_alone == number_amid
    assert np.abs(alone - amid).max() < 1e-9 * np.abs(amid).max()
