"""No option is ignored: what a run of some kind of scene never looks at is refused there, whatever its value.

Options come from the dataclasses, so that new ones are looked at too. A run tells which of them it reads; reads while a
scene is made, checked or written do not count.
"""

import dataclasses
import sys
import tomllib
from contextlib import contextmanager

import pytest
from mpi4py import MPI

from braidx.geometry import build_rope
from braidx.processes import NotConverged, run
from braidx.processes.bending.start import clamped, make_bent_rope
from braidx.processes.start import start_state
from braidx.scene import (
    Bend,
    OutputOptions,
    RopeRecipe,
    SceneError,
    SolverOptions,
    scene_from_dict,
)
from braidx.scene.fields import Table, spec_of
from braidx.scene.write import to_dict

MAKING = {f"braidx.scene.{name}" for name in ("build", "compare", "defaults", "effects")}
MAKING |= {f"braidx.scene.{name}" for name in ("fields", "pitch", "rules", "size", "write")}
MAKING |= {"dataclasses", __name__}

STRAND = """
[rope]
type = "strand"
pitch = 10.0
pitches = 1
[strand]
rings = [3]
yarn_pitch = "pitch/1"
[yarn]
radius = 0.5
axial_stiffness = 1e5
elements_per_pitch = 8
[output]
pictures = false
fields = false
"""
PULLED = """
[[steps]]
kind = "settle"
increments = 2
[[steps]]
kind = "pull"
to_strain = 0.002
"""
ENDS = """
[ends]
transverse = "fixed"
[[ends.groups]]
end = "last"
level = "rope"
rotation = { z = 1.0 }
[[steps]]
kind = "settle"
increments = 2
ends = 0.5
[[steps]]
kind = "hold"
increments = 1
"""
BRAID = """
[rope]
pitch = 18.0
pitches = 1
[braid]
strands_per_direction = [2, 2]
motif = "1-over-1-under"
helix_radius = 1.6
[core]
radius = 0.3
model = "rigid"
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
kind = "settle"
increments = 2
"""
BENT = """
[rope]
pitch = 17.0
pitches = 1
[braid]
strands_per_direction = [2, 2]
motif = "1-over-1-under"
helix_radius = 1.6
undulation = 0.6
[core]
radius = 0.4
model = "beam"
[sheave]
diameter = 20.0
[yarn]
radius = 0.6
model = "beam"
axial_stiffness = 22.6e3
elements_per_pitch = 8
[output]
pictures = false
fields = false
[[steps]]
kind = "bend"
travel = 0.1
increments = 1
"""
SOLID = 'yarn.model = "mixed"\nyarn.solid_stretch = 6\nyarn.seeds = 4\ncore.model = "solid"\ncore.seeds = 4'
KINDS = {
    "cables pulled": (STRAND + PULLED, ""),
    "beams pulled": (STRAND + PULLED, 'yarn.model = "beam"'),
    "cables with groups of ends": (STRAND + ENDS, ""),
    "braid formed about a rigid core": (BRAID, ""),
    "braid formed with beams": (BRAID, 'steps.form.model = "beam"'),
    "beams bent": (BENT, ""),
    "mixed yarns bent": (BENT, SOLID),
}


def tables_of(kind):
    text, changes = KINDS[kind]
    data = tomllib.loads(text)
    for line in filter(None, changes.split("\n")):
        key, _, value = line.partition(" = ")
        *path, last = key.split(".")
        table = data["steps"][0] if path[0] == "steps" else data[path[0]]
        table[last] = tomllib.loads(f"value = {value}")["value"]
    return data


@contextmanager
def reads():
    """Options that are read meanwhile, (class, name)."""
    found = set()

    def tracked(table, name):
        if name[0] != "_" and sys._getframe(1).f_globals["__name__"] not in MAKING:
            found.add((type(table), name))
        return object.__getattribute__(table, name)

    Table.__getattribute__ = tracked
    try:
        yield found
    finally:
        del Table.__getattribute__


def looked_at(scene, folder):
    """What a run of a scene reads. Of solids, which take longer, the model and what every run reads stand for it."""
    with reads() as found:
        if scene.yarn.model == "mixed":
            build_rope(scene)
            make_bent_rope(MPI.COMM_SELF, scene, clamped(scene, start_state(scene)))
        else:
            try:
                run(scene, folder)
            except NotConverged:  # as good a run as any: it has read what there is
                pass
    if scene.yarn.model == "mixed":
        classes = (RopeRecipe, SolverOptions, OutputOptions, Bend)
        found |= {(cls, field.name) for cls in classes for field in dataclasses.fields(cls)}
    return found


def other_values(field, value):
    """Values of an option that it may have, other than the one it has."""
    spec = spec_of(field)
    bounds = [b for b in (spec.minimum, spec.maximum) if b is not None]
    tried = [
        *spec.choices,
        *bounds,
        *(0.3, 0.02, 1, 2, 3, 5, 8, 40.0, True, False, "x", [1], [1, 2]),
    ]
    tried += [{"x": 1.0}, {"0": "cable"}, {"yarn-yarn": 0.4}]
    tried += ["pitch/2", "2-over-2-under"]
    return [each for each in tried if each != value]


def with_value(data, table, name, value):
    """A copy of a scene's tables in which one value is another."""
    changed = {**data, "steps": [dict(step) for step in data["steps"]]}
    if isinstance(table, int):
        changed["steps"][table][name] = value
    else:
        changed[table] = {**data.get(table, {}), name: value}
    return changed


def outcome(data, table, name, value):
    """ "accepted", "refused", or "elsewhere" where other options of the scene follow from this one."""
    try:
        scene = scene_from_dict(with_value(data, table, name, value), "x")
    except SceneError:
        return "refused"
    plain, base = to_dict(scene), to_dict(scene_from_dict(data, "x"))
    for tables in (plain, base):
        found = tables["steps"][table] if isinstance(table, int) else tables.get(table, {})
        found.pop(name, None)
    return "accepted" if plain == base else "elsewhere"


@pytest.fixture(scope="module", params=KINDS)
def kind(request, tmp_path_factory):
    data = tables_of(request.param)
    scene = scene_from_dict(data, "x")
    return data, scene, looked_at(scene, tmp_path_factory.mktemp("run"))


def tables(scene):
    """Tables and steps of a scene by their place in it."""
    for field in dataclasses.fields(scene):
        if isinstance(getattr(scene, field.name), Table):
            yield field.name, getattr(scene, field.name)
    yield from enumerate(scene.steps)


def test_what_a_run_does_not_look_at_is_refused(kind):
    data, scene, found = kind
    ignored = []
    for place, table in tables(scene):
        for field in dataclasses.fields(table):
            owners = {cls for cls in type(table).__mro__ if (cls, field.name) in found}
            if owners:
                continue
            values = other_values(field, getattr(table, field.name))
            outcomes = [outcome(data, place, field.name, value) for value in values]
            if "accepted" in outcomes:
                value = values[outcomes.index("accepted")]
                ignored.append(f"{place}.{field.name} = {value!r}")
    assert not ignored
