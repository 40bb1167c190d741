"""Tables and steps of a rope that is bent over a sheave: what they mean, and what is refused, with its cure."""

import tomllib
from pathlib import Path

import pytest

from braidx.scene import (
    Bend,
    BendCycles,
    ContactOptions,
    Core,
    Heat,
    SceneError,
    Sheave,
    Straighten,
    YarnModel,
    load_scene,
    scene_from_dict,
    to_toml,
)
from braidx.scene.reference import json_schema

ROPE = """
[rope]
pitches = 4
[braid]
motif = "1-over-1-under"
helix_radius = 4.0
angle = 60
undulation = 1.0
[yarn]
radius = 1.0
"""
CORE = "[core]\nradius = 2.0\n"
SHEAVE = "[sheave]\ndiameter = 40.0\n"
BEND = '[[steps]]\nkind = "bend"\ntravel = 60.0\n'
DEMO = Path(__file__).parents[3] / "demos" / "bending_over_sheave.toml"


def scene_of(text):
    return scene_from_dict(tomllib.loads(ROPE + text))


def message(make, *arguments, **values):
    with pytest.raises(SceneError) as caught:
        make(*arguments, **values)
    line = str(caught.value)
    assert "\n" not in line
    return line


def test_everything_survives_writing_and_reading(tmp_path):
    (tmp_path / "core.msh").write_text("")
    text = ROPE + CORE + 'mesh = "core.msh"\nlaw = "neo-hooke"\n' + SHEAVE
    text += 'groove_radius = 7.0\nmotion = "driven"\ndriven_angle = 90\n'
    text += "[heat]\nfrequency = 0.5\n[contact.friction_between]\nyarn-core = 0.3\n"
    text += BEND + "pretension = 1.0\n" + '[[steps]]\nkind = "straighten"\n'
    text += '[[steps]]\nkind = "bend_cycles"\ncycles = 3\n'
    path = tmp_path / "one" / "bent.toml"
    path.parent.mkdir()
    path.write_text(text.replace("core.msh", "../core.msh"), "utf-8")
    scene = load_scene(path, ["yarn.model=mixed", "yarn.solid_stretch=50", "yarn.models.3=beam"])
    assert scene.steps == (Bend(travel=60.0, pretension=1.0), Straighten(), BendCycles(cycles=3))
    assert scene.core == Core(radius=2.0, law="neo-hooke", mesh=str(tmp_path / "core.msh"))
    assert scene.heat == Heat(frequency=0.5)
    assert [scene.yarn.model_of(yarn) for yarn in (2, 3)] == ["mixed", "beam"]
    assert scene.crown == scene.length / 2.0
    copy = tmp_path / "bent.toml"
    copy.write_text(to_toml(scene), "utf-8")
    assert load_scene(copy) == scene


def test_a_scene_without_the_new_tables_has_none():
    scene = scene_of("")
    assert (scene.core, scene.sheave, scene.heat) == (None, None, None)
    assert "[core]" not in to_toml(scene) and "[sheave]" not in to_toml(scene)


def test_a_groove_is_round_if_it_has_a_radius():
    assert Sheave(diameter=40.0).groove == "flat"
    assert Sheave(diameter=40.0, groove_radius=7.0).groove == "round"
    assert "groove_radius: missing" in message(Sheave, diameter=40.0, groove="round")
    assert "flat sheave has none" in message(Sheave, diameter=1, groove="flat", groove_radius=7)


def test_friction_of_a_pair_left_out_is_that_of_all():
    contact = ContactOptions(friction=0.2, friction_between={"yarn-core": 0.0})
    assert contact.friction_of("yarn-core") == 0.0
    assert contact.friction_of("yarn-sheave") == contact.friction_of("yarn-yarn") == 0.2
    wrong = message(ContactOptions, friction_between={"yarn-cor": 0.1})
    assert "contact.friction_between.yarn-cor: unknown key; did you mean 'yarn-core'?" in wrong
    negative = message(ContactOptions, friction_between={"yarn-core": -0.1})
    assert "contact.friction_between.yarn-core = -0.1: out of range" in negative


@pytest.mark.parametrize(
    ("make", "values", "wanted"),
    [
        (Core, {"inner_radius": 2.0}, "core.inner_radius = 2.0: must be below core.radius = 2 mm"),
        (
            Core,
            {"poisson": 0.5},
            "core.poisson = 0.5: out of range, must be finite and above -1 and",
        ),
        (Core, {"seeds": 13}, "core.seeds = 13: not a multiple of 4, use 12."),
        (Core, {"model": "rigid", "mesh": "a.msh"}, 'core.mesh = "a.msh": only a solid has a mesh'),
        (Core, {"model": "beam", "inner_radius": 1}, "core.inner_radius = 1.0: a beam has no bore"),
        (Core, {"law": "neohooke"}, "did you mean 'neo-hooke'?"),
        (YarnModel, {"seeds": 10}, "yarn.seeds = 10: not a multiple of 4, use 8."),
        (YarnModel, {"models": {"a": "beam"}}, 'yarn.models.a = "beam": not the number of a yarn'),
        (YarnModel, {"models": {"03": "beam"}}, "yarn.models.03"),
        (YarnModel, {"models": {"3": "bean"}}, 'yarn.models.3 = "bean": choose cable or beam or'),
    ],
)
def test_values_that_make_no_sense_are_refused(make, values, wanted):
    assert wanted in message(make, radius=2.0, **values)


def test_a_wedge_takes_any_number_of_seeds():
    assert Core(radius=2.0, section="wedge", seeds=10).seeds == 10


def test_only_a_driven_sheave_has_an_angle():
    wrong = message(Sheave, diameter=40.0, driven_angle=5.0)
    assert 'sheave.driven_angle = 5.0: nothing turns a sheave with motion = "fixed"' in wrong


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (BEND, 'steps[0].kind = "bend": a rope is bent over a sheave; add a table [sheave]'),
        (SHEAVE + '[[steps]]\nkind="straighten"', 'steps[0].kind = "straighten": the rope is not'),
        (SHEAVE + '[[steps]]\nkind="bend_cycles"\n' + BEND, 'steps[0].kind = "bend_cycles": the r'),
        (
            SHEAVE + '[[steps]]\nkind="settle"',
            'steps[0].kind = "settle": not possible in a scene wi',
        ),
        (
            CORE + '[[steps]]\nkind="pull"\nto_force=1',
            'with a [core] of model "solid"; use core.mode',
        ),
        (
            CORE + '[[steps]]\nkind="cycle"\nforce_max=2',
            'steps[0].kind = "cycle": not possible in a',
        ),
        (
            SHEAVE + BEND + '[[steps]]\nkind="hold"',
            'steps[1].kind = "hold": not possible in a scene',
        ),
        (SHEAVE + BEND.replace("60", "90"), "steps[0].travel = 90.0: the ends cannot come so far"),
        (SHEAVE + BEND.replace("60", "-6"), "steps[0].travel = -6.0: out of range"),
        (CORE + 'mesh = "nosuch.msh"', 'core.mesh = "nosuch.msh": no such file; give the path'),
    ],
)
def test_steps_and_tables_that_do_not_go_together_are_refused(text, wanted):
    assert wanted in message(scene_of, text)


def test_a_rigid_core_may_be_pulled_over():
    scene_of(CORE + 'model = "rigid"\n[[steps]]\nkind = "settle"')


@pytest.mark.parametrize("table", ["core", "sheave"])
def test_a_rope_without_a_braid_has_neither(table):
    text = (
        '[rope]\ntype = "strand"\npitch = 9\n[yarn]\nradius = 1\n'
        + {"core": CORE, "sheave": SHEAVE}[table]
    )
    wrong = message(lambda: scene_from_dict(tomllib.loads(text)))
    assert (
        f"{table}: a rope without a braid has no {table}; add [braid] or remove [{table}]" in wrong
    )


@pytest.mark.parametrize(
    ("yarn", "wanted"),
    [
        ('model = "mixed"', 'yarn.model = "mixed": needs yarn.solid_stretch, in mm'),
        ('models = { 2 = "mixed" }', 'yarn.models.2 = "mixed": needs yarn.solid_stretch'),
        (
            'model = "mixed"\nsolid_stretch = 175',
            "yarn.solid_stretch = 175.0: must be below the sample's 174.1",
        ),
    ],
)
def test_a_mixed_yarn_says_where_it_is_solid(yarn, wanted):
    rope = ROPE + yarn + "\n" + SHEAVE + BEND
    assert wanted in message(lambda: scene_from_dict(tomllib.loads(rope)))


@pytest.mark.parametrize("yarn", ['model = "solid"', 'model = "auto"', 'models = { 2 = "solid" }'])
def test_solid_yarns_are_those_of_ropes_that_are_bent(yarn):
    rope = ROPE + yarn + '\n[[steps]]\nkind = "form"'
    assert "only ropes that are bent have such yarns" in message(
        lambda: scene_from_dict(tomllib.loads(rope))
    )
    scene_from_dict(tomllib.loads(ROPE + yarn + "\n" + SHEAVE + BEND))


def test_the_demo_is_the_rope_of_paper_2():
    scene = load_scene(DEMO)
    assert scene.rope.pitch == pytest.approx(43.531, abs=1e-3)
    assert scene.sheave == Sheave(diameter=40.0) and scene.contact.friction_of("yarn-core") == 0.2
    assert [step.kind for step in scene.steps] == ["form", "bend"]


def test_the_schema_knows_tables_and_steps():
    schema = json_schema()["properties"]
    assert schema["core"]["required"] == ["radius"] and schema["heat"]["required"] == ["frequency"]
    pairs = schema["contact"]["properties"]["friction_between"]["properties"]
    assert pairs["yarn-sheave"] == {"type": "number", "minimum": 0.0, "maximum": 2.0}
    kinds = [step["properties"]["kind"]["const"] for step in schema["steps"]["items"]["oneOf"]]
    assert kinds[-4:] == ["bend", "run_over", "straighten", "bend_cycles"]


def test_a_rope_that_is_bent_is_pulled_to_a_force_and_drawn_over_the_sheave():
    pull = '[[steps]]\nkind = "pull"\n'
    run = '[[steps]]\nkind = "run_over"\nway = 3.0\n'
    scene = scene_from_dict(tomllib.loads(ROPE + SHEAVE + pull + "to_force = 1.0\n" + BEND + run))
    assert [step.kind for step in scene.steps] == ["pull", "bend", "run_over"]
    assert scene.steps[1].pretension is None
    for text, wanted in (
        (pull + "to_strain = 0.01\n" + BEND, "pulled to a force; give to_force"),
        (run + BEND, 'put a step kind = "bend" before it'),
    ):
        assert wanted in message(lambda: scene_from_dict(tomllib.loads(ROPE + SHEAVE + text)))
