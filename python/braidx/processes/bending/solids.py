"""Stretches of yarns, and a core, that are modelled as solids."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from mpi4py import MPI

from ...bodies import YarnMaterial
from ...bodies.solid import Law, SolidBody
from ...meshing import SolidMesh, join, round_section, sweep
from ...scene import Core, Scene
from ...system.constraints import Floats
from ..yarns import yarn_material

LAWS: dict[str, Law] = {
    "st-venant-kirchhoff": "Saint-Venant-Kirchhoff",
    "neo-hooke": "neo-Hooke",
}


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
    yarn = scene.yarn
    # As stiff as the round section: axial force and bending come from its area.
    section = round_section(yarn.radius, yarn.seeds, degree=yarn.solid_degree, equal_area=True)
    meshes = [sweep(line, section, g) for line, g in zip(lines, directors, strict=True)]
    return SolidBody(comm, join(meshes), material=yarn_material(scene))


def core_solid(comm: MPI.Comm, scene: Scene) -> SolidBody:
    """The core, free of stress in the straight rope."""
    core = scene.core
    assert core is not None
    material = YarnMaterial.isotropic(core.modulus, core.poisson)
    return SolidBody(comm, _core_mesh(scene, core), material=material, law=LAWS[core.law])


def _core_mesh(scene: Scene, core: Core) -> SolidMesh:
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
