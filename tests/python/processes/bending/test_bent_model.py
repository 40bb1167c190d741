"""Residual and tangent of a bent rope, its clamps and its joints."""

from pathlib import Path

import numpy as np
import pytest
import scipy.sparse as sp
from mpi4py import MPI

from braidx.geometry import build_rope
from braidx.processes.bending.clamp import Clamp, ClampTerm
from braidx.processes.bending.ends import Ends
from braidx.processes.bending.model import BentRope
from braidx.processes.bending.stretches import stretches_of
from braidx.processes.bending.yarn_states import axial_stress, centre_lines
from braidx.scene import load_scene

SCENE = Path(__file__).parent / "small_bend.toml"
MIXED = ["yarn.model=mixed", "yarn.solid_stretch=14"]
MODELS = {
    "cables and beam": ["yarn.model=cable"],
    "free sheave": ["yarn.model=cable", "sheave.motion=free"],
    "beams and solid": ["core.model=solid", "core.seeds=8"],
    "solids": ["yarn.model=solid", "yarn.seeds=4", "core.model=solid", "core.seeds=8"],
    "mixed": [*MIXED, "yarn.seeds=4", "core.model=solid", "core.seeds=8"],
    "mixed with cables": [*MIXED, "yarn.outer_model=cable", "yarn.seeds=4"],
}


def bent_rope(*overrides):
    """A rope as placed; thin yarns, so that they hardly overlap."""
    scene = load_scene(
        SCENE, ["yarn.radius=0.7", "rope.pitches=1", "steps.bend.travel=5", *overrides]
    )
    lines = build_rope(scene).centre_lines
    return BentRope(MPI.COMM_SELF, scene, lines, stretches_of(scene, lines))


@pytest.mark.parametrize("name", MODELS)
def test_tangent_is_the_derivative_of_the_residual(name):
    model = bent_rope(*MODELS[name])
    system, contact = model.system, model.contact
    rng = np.random.default_rng(4)
    model.move(Ends(0.2, 10.0, 0.3, 0.2), 0.01)
    model.set_viscosity(2.0, 30.0)
    free = system.free_values(model.start)
    q = system.expand(free + 1e-3 * rng.standard_normal(len(free)))
    contact.start = model.start
    contact.update(q)
    contact.freeze_sections()
    model.proximal.start = model.start
    system.update_pattern()
    system.set_state(q)
    system.assemble_tangent()
    tangent = sp.csr_matrix(system.matrix.getValuesCSR()[::-1], shape=(len(free),) * 2)
    direction = rng.standard_normal(len(free))
    step = 1e-7

    def residual(sign):
        moved = system.free_values(q) + sign * step * direction
        system.set_state(system.expand(moved))
        return system.constraints.reduce(system.residual())

    numerical = (residual(1.0) - residual(-1.0)) / (2.0 * step)
    analytic = tangent @ direction
    assert np.abs(analytic - numerical).max() < 2e-5 * np.abs(numerical).max()


@pytest.mark.parametrize("name", MODELS)
def test_the_straight_rope_is_free_of_stress_and_whole(name):
    model = bent_rope(*MODELS[name])
    assert model.system.expand(model.system.free_values(model.start)) == pytest.approx(
        model.start, abs=1e-9
    )
    assert abs(model.internal_energy(model.start)) < 1e-9
    for line, placed in zip(centre_lines(model.assembly, model.start), model.lines, strict=True):
        assert np.abs(line - placed).max() < 1e-9
    assert max(np.abs(s).max() for s in axial_stress(model.assembly, model.start)) < 1e-9


@pytest.mark.parametrize("name", ["mixed", "solids"])
def test_a_clamp_moves_what_ends_in_it_like_a_rigid_body(name):
    model = bent_rope(*MODELS[name])
    angle, (first, last) = 0.3, model.assembly.clamps
    q = model.start.copy()
    q[first.vector(1)], q[first.vector(2)] = [1, 0, 0], [0, np.cos(angle), np.sin(angle)]
    q[last.axial] = model.scene.length - 2.0
    q = model.system.expand(model.system.free_values(q))
    turn = np.array(
        [[1, 0, 0], [0, np.cos(angle), -np.sin(angle)], [0, np.sin(angle), np.cos(angle)]]
    )
    for piece in (pieces[0] for pieces in model.assembly.yarns()):
        # Those of solids, which end aslant, are off the clamp's plane.
        unknowns = piece.positions[0][:, None] + np.arange(3)
        rigid = model.start[unknowns] @ turn.T + [0, 0, 2.0]
        assert q[unknowns] == pytest.approx(rigid, abs=1e-12)
    assert q[first.axial] == pytest.approx(2.0)


def test_a_sheave_turns_with_its_frame():
    model = bent_rope("sheave.motion=free")
    frame, system = model.assembly.sheave, model.system
    q = model.start.copy()
    for angle in (0.4, 2.5, -2.0):  # less than half a turn each, more than a whole one together
        before, told = q, np.array([np.cos(angle), np.sin(angle)])
        g2 = q[frame.vector(2)[1:]]
        q = q.copy()
        q[frame.vector(2)[1:]] = [
            g2[0] * told[0] - g2[1] * told[1],
            g2[0] * told[1] + g2[1] * told[0],
        ]
        q = system.expand(system.free_values(q))
        directors = q[frame.first_unknown + 3 :].reshape(3, 3)
        assert directors @ directors.T == pytest.approx(np.eye(3), abs=1e-12)
        assert np.linalg.det(directors) == pytest.approx(1.0)
        assert frame.turned(before, q) == pytest.approx(angle)
        assert q[frame.vector(0)] == pytest.approx(model.sheave.centre)


def test_energy_of_clamps_and_its_derivatives():
    clamps = (Clamp(0, 0.0), Clamp(9, 5.0))
    term = ClampTerm([clamp.vector(2) for clamp in clamps], stiffness=3.0)
    q = np.concatenate([clamp.start for clamp in clamps])
    rng = np.random.default_rng(1)
    q += 0.2 * rng.standard_normal(len(q))
    rows, cols = term.tangent_pattern()
    term.set_state(q)
    matrix = sp.coo_matrix((term.tangent_values(), (rows, cols)), shape=(len(q),) * 2).toarray()
    residual = np.zeros(len(q))
    term.add_residual(residual)
    for i in range(len(q)):
        energies, forces = [], []
        for sign in (1.0, -1.0):
            moved = q.copy()
            moved[i] += sign * 1e-6
            term.set_state(moved)
            energies.append(term.energy())
            force = np.zeros(len(q))
            term.add_residual(force)
            forces.append(force)
        assert residual[i] == pytest.approx((energies[0] - energies[1]) / 2e-6, abs=1e-8)
        assert matrix[:, i] == pytest.approx((forces[0] - forces[1]) / 2e-6, abs=1e-7)
