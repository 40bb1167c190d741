"""A core of its own mesh: placed and clamped, or one clear error before anything is computed."""

from pathlib import Path

import numpy as np
import pytest
from mpi4py import MPI

from braidx.geometry import build_rope
from braidx.processes.bending.model import BentRope
from braidx.processes.bending.solids import check_core
from braidx.processes.bending.stretches import stretches_of
from braidx.scene import SceneError, load_scene

SCENE = Path(__file__).parent / "small_bend.toml"
GEO = """SetFactory("OpenCASCADE");
Cylinder(1) = {{0, 0, 0, 0, 0, {length}, 1.0}};
Physical Volume("core") = {{1}};
Physical Surface("{tag}") = {{1}};
Mesh.MeshSizeMin = 1.2;
Mesh.MeshSizeMax = 1.2;
"""
PITCH = 2.0 * np.pi * 3.0 * np.tan(np.radians(60.0))


@pytest.fixture
def scene_with(tmp_path):
    pytest.importorskip("gmsh")

    def make(length=PITCH, tag="lateral"):
        path = tmp_path / "core.geo"
        path.write_text(GEO.format(length=repr(float(length)), tag=tag), "utf-8")
        sets = ["core.model=solid", f"core.mesh={path}", "rope.pitches=1", "steps.bend.travel=5"]
        return load_scene(SCENE, ["yarn.radius=0.7", *sets])

    return make


def test_a_meshed_core_is_clamped_at_both_ends_and_free_of_stress(scene_with):
    scene = scene_with()
    check_core(scene)
    lines = build_rope(scene).centre_lines
    model = BentRope(MPI.COMM_SELF, scene, lines, stretches_of(scene, lines))
    assert model.assembly.core_solid is not None
    assert abs(model.internal_energy(model.start)) < 1e-9
    axis = model.assembly.core.centre_line(model.start)
    assert axis[0, 2] == pytest.approx(0.0, abs=1e-6)
    assert axis[-1, 2] == pytest.approx(scene.length, abs=1e-4)
    q = model.start.copy()
    q[model.assembly.clamps[1].axial] += 0.5
    q = model.system.expand(model.system.free_values(q))
    moved = model.assembly.core.centre_line(q) - axis
    assert moved[-1] == pytest.approx([0.0, 0.0, 0.5], abs=1e-9)
    assert moved[0] == pytest.approx([0.0, 0.0, -0.5], abs=1e-9)


@pytest.mark.parametrize(
    "given, said",
    [({"length": 30.0}, "has to end in the planes z = 0"), ({"tag": "outside"}, "lateral")],
)
def test_a_mesh_that_does_not_fit_is_one_clear_error(scene_with, given, said):
    with pytest.raises(SceneError, match=said) as error:
        check_core(scene_with(**given))
    assert "core.mesh" in str(error.value)
