"""A twisted strand of a scene carries no force before it is pulled."""

from pathlib import Path

import pytest
from mpi4py import MPI

from braidx.processes.pull import hold
from braidx.processes.start import make_model, start_state
from braidx.scene import Hold, load_scene

DEMO = Path(__file__).parents[3] / "demos" / "twisted_strand.toml"


@pytest.mark.parametrize("model", ["cable", "beam"])
@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("spans", [8, 16, 32])
def test_no_force_at_no_strain(spans, degree, model):
    """Less than a millionth of E A; with neighbours in each other by 2 % of their radius it was 235 N."""
    options = [f"yarn.model={model}", f"yarn.degree={degree}", "rope.pitches=1"]
    scene = load_scene(DEMO, [*options, f"yarn.elements_per_pitch={spans // degree}"])
    state = start_state(scene)
    yarns = make_model(MPI.COMM_SELF, scene, state)
    end = list(hold(yarns, state, Hold(increments=1)))[-1]
    assert end.strain == 0.0
    assert abs(end.force) < 1e-6 * yarns.rope.num_yarns * scene.yarn.axial_stiffness
