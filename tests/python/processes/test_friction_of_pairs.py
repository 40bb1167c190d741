"""Friction of pairs of bodies of their own, in straight ropes: what is said of a pair acts, and on that pair alone."""

import tomllib

import numpy as np
import pytest
from mpi4py import MPI

from braidx.output import history
from braidx.processes import run
from braidx.processes.form import form as form_rope
from braidx.processes.start import make_model, start_state
from braidx.scene import SceneError, load_scene, scene_from_dict
from runs import SMALL

# The smallest braid that forms: four yarns, a pitch of 18 mm; pulled in two increments.
BRAID = """
[rope]
pitch = 18.0
pitches = 1
[braid]
strands_per_direction = [2, 2]
motif = "1-over-1-under"
helix_radius = 1.6
[yarn]
radius = 0.6
axial_stiffness = 22.6e3
elements_per_pitch = 16
[output]
pictures = false
fields = false
[[steps]]
kind = "form"
tension = 10.0
[[steps]]
kind = "pull"
to_strain = 0.002
"""
CORE = '[core]\nradius = 0.3\nmodel = "rigid"\n'
YARNS, ON_CORE = "{yarn-yarn=0.3}", "{yarn-core=0.3}"


def scene_of(text, **contact):
    return scene_from_dict({**tomllib.loads(text), "contact": contact}, "braid")


def columns(folder, **contact):
    """History of a run, but for its wall times."""
    folder.mkdir()
    run(scene_of(BRAID, **contact), folder)
    found = history.read(folder / "history.csv")
    return np.array([found["force (kN)"], found["friction work (mJ)"]])


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    top = tmp_path_factory.mktemp("pairs")
    pair = columns(top / "pair", friction=0.1, friction_between={"yarn-yarn": 0.3})
    return pair, columns(top / "all", friction=0.3), columns(top / "less", friction=0.1)


def test_friction_of_yarns_on_yarns_is_that_of_the_rope(runs):
    pair, everywhere, less = runs
    assert pair == pytest.approx(everywhere, rel=1e-9, abs=1e-12)
    assert abs(pair - less).max() > 1e-4 * abs(pair).max()


def test_the_command_line_takes_an_inline_table():
    scene = load_scene(SMALL, [f"contact.friction_between={YARNS}"])
    assert scene.contact.friction_between == {"yarn-yarn": 0.3}
    model = make_model(MPI.COMM_SELF, scene, start_state(scene))
    assert list(model.contact.laws.friction) == [0.3]


def test_a_rigid_core_rubs_while_the_rope_comes_to_rest_and_then_no_more():
    scene = scene_of(BRAID + CORE, friction_between={"yarn-core": 0.3, "yarn-yarn": 0.2})
    model = make_model(MPI.COMM_SELF, scene, start_state(scene))
    assert list(model.contact.laws.friction) == [0.2, 0.0, 0.0, 0.0]
    step, state = scene.steps[0], start_state(scene)
    for _ in form_rope(model, state, step):
        pass
    assert list(model.contact.laws.friction) == [0.2, 0.3, 0.3, 0.0]


@pytest.mark.parametrize(("pair", "cure"), [("yarn-core", "[core]"), ("yarn-sheave", "[sheave]")])
def test_pairs_that_the_scene_does_not_have_are_refused(pair, cure):
    with pytest.raises(SceneError) as refused:
        scene_of(BRAID, friction_between={pair: 0.3})
    assert f"contact.friction_between.{pair} = 0.3" in str(refused.value)
    assert cure in str(refused.value)
