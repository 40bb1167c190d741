"""Whatever a scene is made of, it is made or refused with a SceneError of one line: 2,000 inputs, no traceback."""

import copy
import dataclasses
import datetime
import io
import tomllib
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from rich.console import Console

from braidx.cli.accuracy import tell_accuracy
from braidx.cli.report import scene_table
from braidx.geometry import build_rope
from braidx.scene import EndGroup, Scene, SceneError, load_scene, scene_from_dict, to_toml
from braidx.scene.build import NAMED, TABLES
from braidx.scene.fields import Table, spec_of
from braidx.scene.size import num_crossings, num_nodes
from braidx.scene.steps import STEPS

DEMOS = sorted((Path(__file__).parents[3] / "demos").glob("*.toml"))
FILES = [path.read_bytes() for path in DEMOS]
BASES = [tomllib.loads(file.decode()) for file in FILES]
GROUPS = [
    {"end": "last", "level": "rope", "rotation": {"z": 90.0}},
    {"end": "first", "level": "yarn", "which": [0, 1], "rigid": True},
]
BASES += [{**copy.deepcopy(BASES[2]), "ends": {"transverse": "fixed", "groups": GROUPS}}]
CLASSES: dict[str, type[Table]] = {**TABLES, **NAMED, **STEPS, "ends.groups": EndGroup}
OPTIONS = sorted(
    (name, field.name) for name, cls in CLASSES.items() for field in dataclasses.fields(cls)
)
SMALL_NODES, SMALL_CROSSINGS = 1000, 200  # ropes that are placed in no time


def examples(count):
    return settings(
        max_examples=count,
        deadline=None,
        derandomize=True,
        database=None,
        suppress_health_check=list(HealthCheck),
    )


ODD = [
    *(0, 1, -1, 3, 7, 0.3, 45.0, 89.999, 1e-320, 1e200, -1e30, 10**400, -(10**25), 2**63),
    *(float("nan"), float("inf"), True, False, datetime.date(2000, 1, 1), datetime.time(1)),
    *(
        "",
        "[/x]",
        "a\nb",
        "\0",
        "../..",
        "pitch/0",
        "pitch/\u0663",
        "1-over-1-under",
        "5%",
        "\U0001f600",
    ),
    *("cable", "beam", "solid", "mixed", "auto", "rigid", "free", "fixed", "held", "same"),
    *([], [[]], [0], [1, 6], [4, 4], ["x"], [[1, -1], [-1]], [{}], [{"kind": []}], [None]),
    *({}, {"x": 1.0}, {"z": "held"}, {"0": "beam"}, {"99": "cable"}, {"yarn-yarn": 0.3}, {"": {}}),
]
values = st.one_of(st.sampled_from(ODD), st.floats(), st.text(max_size=4))


def likely_values(name, key):
    """Values that an option may take, some at its bounds."""
    field = {f.name: f for f in dataclasses.fields(CLASSES[name])}[key]
    spec = spec_of(field)
    bounds = [spec.above, spec.minimum, spec.below, spec.maximum]
    return [
        *spec.choices,
        *(bound for bound in bounds if bound is not None),
        0.4,
        1,
        2,
        4,
        16,
        40.0,
    ]


LIKELY = {option: likely_values(*option) for option in OPTIONS}


def present(data):
    """Options of the tables and steps that a scene has."""
    names = {*data, "ends", "solver", *(step["kind"] for step in data["steps"])}
    return [option for option in OPTIONS if option[0] in names and option[0] not in NAMED]


PRESENT = [present(data) for data in BASES]


def often(draw):
    """Three times out of four."""
    return draw(st.integers(0, 3)) < 3


def option_of(draw, base):
    """An option, often one that the base has a table for, and a value, often one that it may take."""
    option = draw(st.sampled_from(PRESENT[base] if often(draw) else OPTIONS))
    return option, draw(st.sampled_from(LIKELY[option]) if often(draw) else values)


@st.composite
def changed(draw):
    """Tables of a scene of which some are wrong, or gone."""
    base = draw(st.integers(0, len(BASES) - 1))
    data = copy.deepcopy(BASES[base])
    for _ in range(draw(st.integers(1, 2))):
        (name, key), value = option_of(draw, base)
        where = draw(st.sampled_from([*["option"] * 7, "table", "step", "gone"]))
        if where == "gone":
            data.pop(draw(st.sampled_from(sorted(data))), None)
            data = data or {"rope": {}}
        elif where == "table":
            data[draw(st.sampled_from([*TABLES, *NAMED, "steps", "x"]))] = value
        elif name in STEPS or where == "step":
            step = {"kind": draw(st.sampled_from([name, *STEPS])), key: value}
            steps = data.setdefault("steps", [])
            if isinstance(steps, list):
                steps.insert(draw(st.integers(0, len(steps))), step)
        elif name in NAMED:
            data[name] = {
                draw(st.sampled_from(["x", "", "[/y]", "\0"])): {"reference": 1.0, key: value}
            }
        elif isinstance(data.setdefault(name.split(".")[0], {}), dict):
            table = data[name.split(".")[0]]
            if name == "ends.groups":
                table["groups"] = [{"end": "first", "level": "rope", key: value}]
            else:
                table[key] = value
    return data


def made(make, *arguments, **options):
    """The scene, or None where it is refused; then the message is one line."""
    try:
        return make(*arguments, **options)
    except SceneError as error:
        assert "\n" not in str(error) and str(error)
        return None


def check(scene):
    """What `braidx check` does; and the scene survives being written, as every run does."""
    assert scene_from_dict(tomllib.loads(to_toml(scene))) == scene
    if num_nodes(scene) > SMALL_NODES or num_crossings(scene) > SMALL_CROSSINGS:
        return
    console = Console(file=io.StringIO(), width=120)
    tell_accuracy(scene, console)
    rope = made(build_rope, scene)
    if rope is not None:
        console.print(scene_table(scene, rope))


@given(changed())
@examples(900)
def test_tables(data):
    scene = made(scene_from_dict, data, "name")
    if scene is not None:
        check(scene)


@st.composite
def bytes_of_files(draw):
    """A scene's file with bytes replaced, cut out or put in; or any bytes."""
    data = bytearray(draw(st.sampled_from(FILES)))
    for _ in range(draw(st.integers(1, 3))):
        at, count = draw(st.integers(0, len(data))), draw(st.integers(0, 8))
        data[at : at + count] = draw(
            st.one_of(
                st.binary(max_size=8),
                st.sampled_from(
                    [b"=[[", b"9" * 5000, b"[" * 900, b"1e999", b"nan", b'"', b"\n[rope]\n"]
                ),
            )
        )
    return draw(st.sampled_from([bytes(data), bytes(data), bytes(data), bytes(data[:40])]))


@given(bytes_of_files())
@examples(400)
def test_files(tmp_path_factory, data):
    path = tmp_path_factory.getbasetemp() / "any.toml"
    path.write_bytes(data)
    scene = made(load_scene, path)
    if scene is not None:
        check(scene)


@st.composite
def overrides(draw):
    """A scene's file, and what stands behind --set."""
    base = draw(st.integers(0, len(DEMOS) - 1))
    (name, key), value = option_of(draw, base)
    words = st.sampled_from(["steps", "0", "form", "x", "", '"', "groups", name, key])
    path = [name, key] if often(draw) else draw(st.lists(words, max_size=4))
    path = ["steps", *path] if name in STEPS and path == [name, key] else path
    written = "9" * 5000 if value == 2**63 else draw(st.sampled_from([str(value), repr(value)]))
    equals = "=" if often(draw) else draw(st.sampled_from([" = ", "", "=="]))
    return DEMOS[base], ".".join(path) + equals + written.replace("'", '"')


@given(overrides())
@examples(400)
def test_overrides(override):
    path, word = override
    scene = made(load_scene, path, [word])
    if scene is not None:
        check(scene)


things = st.one_of(
    values,
    st.none(),
    st.sampled_from([b"x", object(), {1: 2}, (1, 2), {1.0}, range(3), print, 1j]),
)


@given(st.sampled_from(OPTIONS), things)
@examples(200)
def test_tables_in_python(option, value):
    name, key = option
    least = {"radius": 1.0, "diameter": 1.0, "frequency": 1.0, "reference": 1.0, "travel": 1.0}
    least |= {
        "helix_radius": 1.0,
        "force_max": 2.0,
        "to_force": 1.0,
        "way": 1.0,
        "end": "last",
        "level": "rope",
    }
    known = {field.name for field in dataclasses.fields(CLASSES[name])}
    needed = {each: given for each, given in least.items() if each in known}
    if name == "strand":
        needed = {}
    made(CLASSES[name], **{**needed, key: value})


WHOLE = [scene_from_dict(data, "base") for data in BASES]


@given(st.sampled_from(WHOLE), st.sampled_from(WHOLE), st.data())
@examples(100)
def test_scenes_in_python(scene, other, data):
    parts = [field.name for field in dataclasses.fields(Scene)]
    own = [getattr(other, part) for part in parts]
    part = data.draw(st.sampled_from(parts))
    value = data.draw(
        st.one_of(things, st.sampled_from([*own, tuple(own), [own[0]], {"x": own[0]}]))
    )
    found = made(dataclasses.replace, scene, **{part: value})
    if found is not None:
        check(found)


@pytest.mark.parametrize("value", [[], ["form"], {}, 3, True])
def test_a_kind_that_is_no_text_is_named(value):
    with pytest.raises(SceneError, match=r"steps\[0\].kind = .*: wrong type, give a text"):
        scene_from_dict({**BASES[2], "steps": [{"kind": value}]})


@pytest.mark.parametrize("digits", [400, 5000])  # beyond floats, and beyond what Python writes out
def test_a_number_beyond_floats_is_named(digits):
    with pytest.raises(SceneError) as refused:
        scene_from_dict({**BASES[2], "rope": {"pitch": 10**digits}})
    assert "rope.pitch = a whole number of" in str(refused.value)
    assert "too large, no number may be beyond 1e+30" in str(refused.value)


def test_a_rope_that_no_machine_holds_is_refused():
    rope = {"pitch": 36.0, "pitches": 10**12}
    with pytest.raises(SceneError, match="rope: too large to be computed: .* nodes; use fewer"):
        scene_from_dict({**BASES[2], "rope": rope})


def test_names_are_printed_as_they_are():
    rope = {**BASES[2]["rope"], "name": "[bold]x"}
    scene = scene_from_dict({**BASES[2], "rope": rope})
    console = Console(file=io.StringIO(), width=120)
    console.print(scene_table(scene, build_rope(scene)))
    printed = console.file.getvalue()
    assert "[bold]x" in printed
