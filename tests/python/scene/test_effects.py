"""Values without an effect are refused: each option in scenes that have what it needs, and in scenes that lack it."""

import dataclasses
import itertools
import logging
import tomllib

import pytest

from braidx.scene import SceneError, load_scene, scene_from_dict
from braidx.scene.build import TABLES
from braidx.scene.effects import NEEDS, NoEffect
from braidx.scene.fields import spec_of
from braidx.scene.steps import STEPS

OPTIONS = [
    (name, field.name, spec_of(field))
    for name, cls in {**TABLES, **STEPS}.items()
    for field in dataclasses.fields(cls)
    if spec_of(field).needs
]
YARN = "[yarn]\nradius = 0.6\n"
STRAND = (
    '[rope]\ntype = "strand"\npitch = 17.0\n[strand]\nrings = [3]\nyarn_pitch = "pitch/1"\n' + YARN
)
ONE = '[rope]\ntype = "strand"\npitch = 17.0\n' + YARN
BRAID = "[rope]\npitch = 17.0\n[braid]\nhelix_radius = 1.6\nstrands_per_direction = [2, 2]\n" + YARN
CORE, SHEAVE = '[core]\nradius = 0.4\nmodel = "{}"\n', "[sheave]\ndiameter = 20.0\n"
FORM, SETTLE, HOLD = (
    '[[steps]]\nkind = "{}"\n'.format(kind) for kind in ("form", "settle", "hold")
)
BEND = '[[steps]]\nkind = "bend"\ntravel = 1.0\n'
GROUP = '[ends]\ntransverse = "fixed"\n[[ends.groups]]\nend = "last"\nlevel = "rope"\nforce = { x = 0.1 }\n'
GROUPED = {"end": "first", "level": "rope", "force": {"x": 0.1}}
SMOOTH = "[contact]\nfriction = 0.0\n"
SCENES = {
    "strand": STRAND + SETTLE + HOLD,
    "one yarn": ONE + SETTLE + HOLD,
    "beams": STRAND + 'model = "beam"\n' + SETTLE + HOLD,
    "beams, ends free": STRAND + 'model = "beam"\n[ends]\ntransverse = "free"\n' + SETTLE + HOLD,
    "groups": STRAND + GROUP + SETTLE + HOLD,
    "smooth": STRAND + SMOOTH + SETTLE + HOLD,
    "formed": BRAID + FORM,
    "formed about a solid core": BRAID + CORE.format("solid") + FORM,
    "formed about a rigid core": BRAID + CORE.format("rigid") + FORM + SETTLE,
    "no fields": BRAID + "[output]\nfields = false\n" + FORM,
    "bent": BRAID + CORE.format("beam") + SHEAVE + BEND,
    "bent, solid core": BRAID + CORE.format("solid") + SHEAVE + BEND,
    "bent, meshed core": BRAID + CORE.format("solid") + 'mesh = "MESH"\n' + SHEAVE + BEND,
    "bent, solids": BRAID + 'model = "solid"\n' + SHEAVE + BEND,
    "bent, mixed": BRAID + 'model = "mixed"\nsolid_stretch = 6.0\n' + SHEAVE + BEND,
    "formed and bent": BRAID + SHEAVE + FORM + BEND,
}


@pytest.fixture
def scenes(tmp_path):
    mesh = tmp_path / "core.msh"
    mesh.write_text("")
    return {name: tomllib.loads(text.replace("MESH", str(mesh))) for name, text in SCENES.items()}


def outcomes(data, name, key, spec):
    """What becomes of other values than the default: "made", "no effect" or "refused"."""
    tried = [*spec.choices, *(b for b in (spec.minimum, spec.maximum) if b is not None)]
    tried += [
        str(data.get("core", {}).get("mesh", __file__)),
        [GROUPED],
        0.2,
        0.3,
        0.5,
        2,
        8,
        12,
        20.0,
        5.0,
        False,
        [1, 2],
        "x",
        "pitch/2",
        "pitch/1",
        {"0": "beam"},
    ]
    places = [name] if name in TABLES else []
    places += [i for i, step in enumerate(data["steps"]) if step["kind"] == name]
    for place, value in ((place, value) for place in places for value in tried):
        changed = {**data, "steps": [dict(step) for step in data["steps"]]}
        if name in TABLES:
            if name in ("core", "sheave", "heat") and name not in data:
                continue
            changed[place] = {**data.get(place, {}), key: value}
        else:
            changed["steps"][place][key] = value
        try:
            scene_from_dict(changed, "x")
            yield "made"
        except NoEffect as error:
            where = place if name in TABLES else f"steps[{place}]"
            own = error.key == f"{where}.{key}"
            yield "no effect" if own else "refused"
        except SceneError:
            yield "refused"


@pytest.mark.parametrize(("name", "key", "spec"), OPTIONS, ids=lambda part: str(part)[:20])
def test_an_option_acts_in_some_scenes_and_is_refused_in_others(scenes, name, key, spec):
    missing = {"made", "no effect"}
    for found in itertools.chain.from_iterable(
        outcomes(data, name, key, spec) for data in scenes.values()
    ):
        missing -= {found}
        if not missing:
            return
    raise AssertionError(f"{name}.{key}: in no scene {missing}")


def test_all_that_is_needed_is_known_and_needed():
    used = {spec.needs for _, _, spec in OPTIONS}
    assert used <= set(NEEDS)
    assert set(NEEDS) - used <= {"cycles", "bent"}  # of whole tables


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (
            STRAND + "bundle_factor = 0.1\n" + SETTLE,
            "yarn.bundle_factor = 0.1: has no effect: cables",
        ),
        (BRAID + SHEAVE + FORM, 'sheave: has no effect: no step kind = "bend"'),
        (
            BRAID + "[heat]\nfrequency = 1.0\n" + SHEAVE + BEND,
            "heat: has no effect: the rope is not bent",
        ),
        (
            STRAND + "[material.m]\nshear_modulus = 5.0\n" + SETTLE,
            "material.m: has no effect: no yarn",
        ),
        (
            STRAND + GROUP.replace("force", "#force") + "rigid = true\n" + SETTLE + "ends = 0.5\n",
            "steps[0].ends",
        ),
        (BRAID + FORM + SETTLE + FORM, "steps[2].kind"),
    ],
)
def test_messages_say_what_lacks(text, wanted):
    with pytest.raises(SceneError) as refused:
        scene_from_dict(tomllib.loads(text), "x")
    assert wanted in str(refused.value)


def test_a_scene_without_steps_is_only_looked_at():
    scene_from_dict(tomllib.loads(STRAND + "bundle_factor = 0.1\n"), "x")


def test_a_material_says_what_it_is_whatever_yarns_are_modelled_as():
    text = (
        STRAND + 'material = "m"\n[material.m]\nbundle_factor = 0.1\nshear_modulus = 5.0\n' + SETTLE
    )
    assert scene_from_dict(tomllib.loads(text), "x").yarn.bundle_factor == 0.1


def test_what_a_value_on_the_command_line_takes_the_effect_from_is_left_out(
    tmp_path, caplog, monkeypatch
):
    monkeypatch.setattr(logging.getLogger("braidx"), "propagate", True)  # runs switch it off
    path = tmp_path / "x.toml"
    path.write_text(STRAND + 'model = "beam"\nbundle_factor = 0.1\n' + SETTLE)
    with caplog.at_level(logging.WARNING, "braidx"):
        scene = load_scene(path, ["yarn.model=cable"])
    assert scene.yarn.bundle_factor != 0.1
    assert "yarn.bundle_factor = 0.1" in caplog.text and "yarn.model=cable" in caplog.text
    with pytest.raises(NoEffect, match="yarn.torsion_factor = 0.5: has no effect"):
        load_scene(path, ["yarn.model=cable", "yarn.torsion_factor=0.5"])
