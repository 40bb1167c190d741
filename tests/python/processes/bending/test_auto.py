"""What a bent rope asks for more than it is modelled as."""

from dataclasses import replace

import numpy as np
import pytest
from test_bent_model import bent_rope

from braidx.processes.bending.auto import upgraded, upgrades, verdict
from braidx.processes.state import State
from braidx.scene import Expected


def picture_of(model):
    nothing = np.empty(0)
    progress = {"travel": 0.0, "furthest": 0.0}
    state = State(model.start, "bent", nothing, nothing, progress=progress)
    model.system.set_state(model.start)
    model.contact.start = model.start
    return model.picture(state, "bent")


@pytest.fixture(scope="module")
def beams():
    model = bent_rope("yarn.model=auto", "yarn.seeds=4")
    return model, picture_of(model)


def squeezed(picture, yarn, nodes, by):
    """The picture with a yarn's sections squeezed."""
    directors = [np.array(g) for g in picture.directors]
    directors[yarn][nodes, 0] *= 1.0 - by
    return replace(picture, directors=tuple(directors))


def test_a_straight_rope_of_beams_needs_nothing(beams):
    assert upgrades(*beams) == []
    assert "0.0% (limit 5%)" in verdict(*beams)


def test_where_one_section_is_strained_too_much_all_yarns_are_solid(beams):
    model, picture = beams
    node = 9
    changes = upgrades(model, squeezed(picture, 2, node, 0.2))
    assert sorted(change.yarn for change in changes) == list(range(6))
    assert {change.model for change in changes} == {"solid"}
    told = {change.yarn: change.why for change in changes}
    assert "18.0% (limit 5%)" in told.pop(2)
    assert set(told.values()) == {"yarns beside it are solid"}
    height = model.lines[2][node, 2]
    room = model.scene.rope.pitch / 6
    for change in changes:
        z = model.lines[change.yarn][[change.first, change.last], 2]
        assert z[0] < height < z[1] and np.abs(z - height).max() <= room + 1e-9


def test_a_little_strain_is_a_beams_own(beams):
    model, picture = beams
    assert upgrades(model, squeezed(picture, 2, slice(None), 0.03)) == []


def test_yarns_with_a_model_of_their_own_keep_it():
    model = bent_rope()
    assert upgrades(model, squeezed(picture_of(model), 2, 9, 0.2)) == []


def test_stress_is_asked_of_solids_about_the_crown():
    model = bent_rope("yarn.model=auto", "yarn.seeds=4", "rope.pitches=2", "steps.bend.travel=5")
    model.scene = replace(model.scene, expected={"von_mises_max": Expected(reference=1.0)})
    changes = upgrades(model, picture_of(model))
    stretches = upgraded(model, changes)
    for yarn in range(6):
        mine = [s for s in stretches if s.yarn == yarn]
        assert [s.model for s in mine] == ["beam", "solid", "beam"]
        assert mine[0].first == 0 and mine[-1].last == len(model.lines[yarn]) - 1
        z = model.lines[yarn][[mine[1].first, mine[1].last], 2]
        assert z[0] < model.scene.crown < z[1]
