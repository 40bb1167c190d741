"""What the stabilisation could not let go of once, it holds for the rest of the step where that is little."""

from dataclasses import replace
from pathlib import Path

import pytest
from mpi4py import MPI

from braidx.processes.puller import HELD, HOLDABLE, Puller
from braidx.processes.start import make_model, start_state
from braidx.scene import load_scene

STRAND = Path(__file__).parents[3] / "demos" / "twisted_strand.toml"


@pytest.mark.parametrize("fails", [False, True])
def test_letting_go_is_tried_again_where_it_worked(fails, monkeypatch):
    scene = load_scene(STRAND, ["rope.pitches=1", "yarn.elements_per_pitch=20"])
    state = start_state(scene)
    model = make_model(MPI.COMM_SELF, scene, state)
    puller, asked = Puller(model, state), []
    solve = model.incrementer.solve

    def noted(start, guess, options, stiffening):
        asked.append(options.stabilisation / model.internal_energy(guess))
        assert options.may_hold / model.internal_energy(guess) == pytest.approx(HOLDABLE)
        return replace(solve(start, guess, options, stiffening), held=fails)

    monkeypatch.setattr(model.incrementer, "solve", noted)
    for strain in (5e-4, 1e-3):
        puller.to(strain)
    assert asked == pytest.approx([HELD, HOLDABLE if fails else HELD])
    assert "stuck" not in puller.state.next_step().progress
