"""Stretches of yarns, and a core, that are modelled as curves: cables and beams."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from mpi4py import MPI

from ...bodies import BeamBody, BeamSection, CableBody, YarnMaterial
from ...bodies.tilt import SHARE
from ...scene import Core, Scene
from ...system.constraints import Floats
from ..yarns import yarn_material, yarn_section


@dataclass(frozen=True)
class Line:
    """A curve of finite elements.

    Attributes:
        points: Nodes of the straight rope, shape (num_nodes, 3), mm.
        directors: Sections of a beam, shape (num_nodes, 2, 3).
    """

    points: Floats
    directors: Floats


def cables(comm: MPI.Comm, scene: Scene, lines: Sequence[Line]) -> CableBody:
    """Stretches of yarns as cables, slack in the straight rope."""
    return CableBody(
        comm,
        [line.points for line in lines],
        axial_stiffness=scene.yarn.axial_stiffness,
        area=scene.yarn.section_area,
    )


def beams(comm: MPI.Comm, scene: Scene, lines: Sequence[Line], core: Line | None) -> BeamBody:
    """Stretches of yarns as beams, and after them the core if it is one, free of stress in the straight rope."""
    yarn = scene.yarn
    sections = [yarn_section(scene)] * len(lines)
    materials = [yarn_material(scene)] * len(lines)
    bending = [yarn.bundle_factor] * len(lines)
    torsion = [yarn.bundle_factor if yarn.torsion_factor is None else yarn.torsion_factor] * len(
        lines
    )
    everything = list(lines)
    if core is not None:
        assert scene.core is not None
        everything.append(core)
        sections.append(core_section(scene.core))
        materials.append(core_material(scene.core))
        bending.append(1.0)
        torsion.append(1.0)
    return BeamBody(
        comm,
        [line.points for line in everything],
        section=sections,
        material=materials,
        directors=[line.directors for line in everything],
        bundle_factor=bending,
        torsion_factor=torsion,
        axial_law="linear" if scene.yarn.axial_law == "linear" else "Saint-Venant-Kirchhoff",
    )


def core_material(core: Core) -> YarnMaterial:
    """Material of the core, isotropic."""
    return YarnMaterial.isotropic(core.modulus, core.poisson)


def core_section(core: Core) -> BeamSection:
    """Section of a round core; a share of its shear is taken at the nodes (bodies/tilt.py)."""
    outer, inner = core.radius, core.inner_radius
    area = math.pi * (outer**2 - inner**2)
    inertia = math.pi * (outer**4 - inner**4) / 4.0
    return BeamSection(area, inertia, inertia, 2.0 * inertia, area * (1.0 - SHARE))


def shear_stiffness(body: BeamBody, scene: Scene, has_core: bool) -> Floats:
    """Share of the shear stiffness G A that is taken at the nodes, shape (num_nodes,), N."""
    yarn, core = scene.yarn, scene.core
    stiffness = np.full(body.num_nodes, SHARE * yarn.shear_modulus * yarn.section_area)
    if has_core:
        assert core is not None
        shear_modulus = core_material(core).axial_shear_modulus
        stiffness[body.curves[-2] :] = SHARE * shear_modulus * core_section(core).area
    return stiffness


def core_line(scene: Scene, num_elements: int) -> Line:
    """The axis of the straight rope as the line of its core."""
    points = np.zeros((num_elements + 1, 3))
    points[:, 2] = np.linspace(0.0, scene.length, num_elements + 1)
    directors = np.broadcast_to(np.eye(3)[:2], (num_elements + 1, 2, 3)).copy()
    return Line(points, directors)
