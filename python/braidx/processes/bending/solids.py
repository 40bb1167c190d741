"""Stretches of yarns, and a core, that are modelled as solids."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from mpi4py import MPI

from ...bodies.solid import Law, SolidBody
from ...meshing import SectionMesh, SolidMesh, join, read_mesh, round_section, sweep
from ...scene import Core, Scene, SceneError, YarnModel
from ...system.constraints import Floats, Ints
from ..yarns import yarn_material
from .curves import core_material

LAWS: dict[str, Law] = {
    "st-venant-kirchhoff": "Saint-Venant-Kirchhoff",
    "neo-hooke": "neo-Hooke",
}
SLICES = 40  # that a core of its own mesh is seen as along its axis


def layers_per_element(scene: Scene) -> int:
    """Layers of nodes of solid yarns per element of the curves that yarns are elsewhere."""
    yarn = scene.yarn
    finer = (yarn.solid_elements_per_pitch or yarn.elements_per_pitch) / yarn.elements_per_pitch
    return max(1, round(finer)) * yarn.solid_degree


def yarn_solids(
    comm: MPI.Comm, scene: Scene, lines: Sequence[Floats], directors: Sequence[Floats]
) -> SolidBody:
    """Stretches of yarns as solids, one part each, free of stress in the straight rope.

    Args:
        comm, scene: As of the run.
        lines: Centre of each layer of nodes, shape (num_layers, 3) each, mm.
        directors: Sections, shape (num_layers, 2, 3) each.
    """
    section = _yarn_section(scene.yarn)
    try:
        meshes = [sweep(line, section, g) for line, g in zip(lines, directors, strict=True)]
    except ValueError as error:
        cure = f"{error}; or use beams, a smaller yarn.radius or a braid.angle nearer to 90."
        raise SceneError("yarn.model", cure, scene.yarn.model) from None
    return SolidBody(comm, join(meshes), material=yarn_material(scene))


def _yarn_section(yarn: YarnModel) -> SectionMesh:
    """As stiff as the round section: axial force and bending come from its area."""
    return round_section(yarn.radius, yarn.seeds, degree=yarn.solid_degree, equal_area=True)


def yarn_offset(yarn: YarnModel) -> float:
    """How far the surface of a yarn is outside the nodes of its section, mm (negative), see SkinLayout."""
    return float(yarn.radius - _yarn_section(yarn).outer_radius)


def core_solid(comm: MPI.Comm, scene: Scene) -> SolidBody:
    """The core, free of stress in the straight rope."""
    core = scene.core
    assert core is not None
    mesh = _core_mesh(scene, core)
    return SolidBody(comm, mesh, material=core_material(core), law=LAWS[core.law])


def check_core(scene: Scene) -> None:
    """Raises SceneError where the core's own mesh cannot be read, is placed otherwise, or lacks its surface."""
    if scene.core is not None and scene.core.mesh:
        _core_mesh(scene, scene.core)


def sections_along(mesh: SolidMesh, length: float) -> list[Ints]:
    """Nodes of a mesh that was not swept: those in the two planes it ends in, and slices in between."""
    z = mesh.points[:, 2]
    near = 1e-6 * length
    inner = np.linspace(near, length - near, SLICES + 1)
    slices = [
        np.flatnonzero((z > a) & (z <= b)) for a, b in zip(inner[:-1], inner[1:], strict=True)
    ]
    ends = [np.flatnonzero(np.abs(z - end) <= near) for end in (0.0, length)]
    return [ends[0], *(nodes for nodes in slices if len(nodes)), ends[1]]


def _core_mesh(scene: Scene, core: Core) -> SolidMesh:
    """The core's mesh: its own, or a swept cylinder."""
    if not core.mesh:
        return _cylinder(scene, core)
    try:
        mesh = read_mesh(core.mesh)
        mesh.facets_of(core.surface)
    except ValueError as error:
        raise SceneError(
            "core.mesh", f"{error}; mend the mesh, or leave it out.", core.mesh
        ) from None
    sections = sections_along(mesh, scene.length)
    if len(sections[0]) < 3 or len(sections[-1]) < 3:
        z = mesh.points[:, 2]
        cure = (
            f"reaches from z = {z.min():.6g} to {z.max():.6g} mm and has to end in the planes z = 0 and "
            f"z = {scene.length:.10g} mm of the rope; place it so."
        )
        raise SceneError("core.mesh", cure, core.mesh)
    return mesh


def _cylinder(scene: Scene, core: Core) -> SolidMesh:
    length = core.element_length or scene.rope.pitch / scene.yarn.elements_per_pitch
    num_layers = core.degree * max(1, round(scene.length / length)) + 1
    line = np.zeros((num_layers, 3))
    line[:, 2] = np.linspace(0.0, scene.length, num_layers)
    section = round_section(
        core.radius,
        core.seeds,
        template=core.section,
        degree=core.degree,
        inner_radius=core.inner_radius,
        equal_area=True,
    )
    directors = np.broadcast_to(np.eye(3)[:2], (num_layers, 2, 3))
    return sweep(line, section, directors)
