"""Reading scenes, replacing values, writing them whole."""

from pathlib import Path

import pytest
from braidx.scene import (
    Expected,
    Form,
    Pull,
    RopeRecipe,
    Scene,
    SceneError,
    YarnModel,
    load_scene,
    to_toml,
)

DEMOS = sorted((Path(__file__).parents[3] / "demos").glob("*.toml"))
SMALL = Path(__file__).parents[3] / "demos" / "small_rope.toml"

MINIMAL = """
[rope]
type = "strand"
pitch = 10.0
[yarn]
radius = 0.5
"""


def load(tmp_path, text, *overrides):
    path = tmp_path / "scene.toml"
    path.write_text(text, "utf-8")
    return load_scene(path, overrides)


def message(tmp_path, text, *overrides):
    with pytest.raises(SceneError) as caught:
        load(tmp_path, text, *overrides)
    line = str(caught.value)
    assert "\n" not in line and line.startswith(str(tmp_path / "scene.toml"))
    return line


@pytest.mark.parametrize("path", DEMOS, ids=lambda path: path.stem)
def test_a_scene_survives_writing_and_reading(path, tmp_path):
    scene = load_scene(path)
    assert scene.name == path.stem
    copy = tmp_path / "scene.toml"
    copy.write_text(to_toml(scene), "utf-8")
    assert load_scene(copy) == scene


def test_a_scene_in_python_equals_one_in_toml(tmp_path):
    scene = Scene(
        rope=RopeRecipe(pitch=10.0, type="strand", name="scene"),
        yarn=YarnModel(radius=0.5),
        steps=(Form(), Pull(to_strain=0.01)),
        expected={"efficiency": Expected(reference=1.0)},
    )
    text = (
        MINIMAL
        + """
[[steps]]
kind = "form"
[[steps]]
kind = "pull"
to_strain = 0.01
[expected.efficiency]
reference = 1
"""
    )
    assert load(tmp_path, text) == scene


def test_options_of_every_kind_survive(tmp_path):
    options = [
        "solver.petsc.mat_mumps_icntl_14=80",
        "solver.petsc.ksp_type=preonly",
        'rope.name="a \\"quoted\\" \\\\ name"',
        "expected.efficiency.reference=1e-3",
    ]
    scene = load(tmp_path, MINIMAL, *options)
    assert scene.solver.petsc == {"mat_mumps_icntl_14": 80, "ksp_type": "preonly"}
    assert load(tmp_path, to_toml(scene)) == scene


def test_overrides_take_bare_texts_and_toml_values(tmp_path):
    scene = load(tmp_path, MINIMAL, "yarn.model=beam", "strand.rings=[1, 6]", "rope.pitches=3")
    assert (scene.yarn.model, scene.strand.rings, scene.rope.pitches) == ("beam", (1, 6), 3)


def test_a_step_is_named_by_kind_or_number():
    for name in ("pull", "2"):
        scene = load_scene(SMALL, [f"steps.{name}.to_force=3"])
        assert getattr(scene.steps[2], "to_force") == 3.0
    with pytest.raises(SceneError, match="no step 'twist'; the scene has form, settle, pull"):
        load_scene(SMALL, ["steps.twist.to_force=3"])


@pytest.mark.parametrize("text", ["pitch=3", "rope.pitch", "=3", "rope..pitch=3"])
def test_an_override_is_table_key_value(tmp_path, text):
    assert "table.key=value" in message(tmp_path, MINIMAL, text)


@pytest.mark.parametrize(
    ("override", "wanted"),
    [
        ("contact.fricton=0.1", "contact.fricton: unknown key; did you mean 'friction'?"),
        ("contcat.friction=0.1", "contcat: unknown table; did you mean 'contact'?"),
        ("yarn.material=hmpe", "no table [material.hmpe]"),
        ("rope.pitch.x=1", "'pitch' is a value, not a table"),
        ("rope.pitch.x.y=1", "'x' is inside a value"),
        ("rope.type=braid", "braid: table missing"),
        ("steps=3", "table.key=value"),
        ("expected.x.tolerance=0.1", "expected.x.reference: missing"),
        ("expected.eficiency.reference=1", "no such result; did you mean 'efficiency'?"),
        ("material.hmpe.density=1", "material.hmpe.density: unknown key"),
    ],
)
def test_wrong_keys_are_named_with_a_cure(tmp_path, override, wanted):
    assert wanted in message(tmp_path, MINIMAL, override)


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("", "rope: table missing, add [rope]."),
        ("[rope]\n[yarn]\nradius = 1", "rope.pitch: missing, add it, in mm."),
        ("rope = 3\n[yarn]", "rope = 3: wrong type"),
        ("[rope", "not valid TOML"),
        (MINIMAL + "[[steps]]\nkind = 'pul'", "did you mean 'pull'?"),
        (MINIMAL + "[[steps]]\nforce = 1", "steps[0].kind: missing"),
        (MINIMAL + "[steps]\nkind = 'form'", "[[steps]]"),
        (MINIMAL + "[[steps]]\nkind = 'form'\ntension = -1", "steps[0].tension = -1.0"),
        (MINIMAL + "[braid]\nhelix_radius = 1", "rope.type"),
    ],
)
def test_wrong_files_are_named_with_a_cure(tmp_path, text, wanted):
    assert wanted in message(tmp_path, text)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(SceneError, match=r"nosuch.toml: no such file"):
        load_scene(tmp_path / "nosuch.toml")
    with pytest.raises(SceneError, match="cannot be read"):
        load_scene(tmp_path)


def test_a_material_fills_the_yarn_and_the_yarn_wins(tmp_path):
    text = (
        MINIMAL
        + """
shear_modulus = 5.0
material = "soft"
[material.soft]
axial_modulus = 100.0
shear_modulus = 7.0
poisson_axial = 0.1
transverse_modulus = 50.0
"""
    )
    scene = load(tmp_path, text)
    assert scene.yarn.axial_stiffness == pytest.approx(100.0 * 3.14159265 * 0.25)
    assert scene.yarn.shear_modulus == 5.0
    assert scene.yarn.poisson_axial == 0.1
    assert load(tmp_path, to_toml(scene)) == scene
