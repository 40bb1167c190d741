"""The yarns of a scene as bodies, with what belongs to them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from mpi4py import MPI

from ..bodies import BeamBody, BeamSection, CableBody, CurveBody, YarnMaterial
from ..bodies.tilt import SHARE, SectionTilt
from ..scene import Scene
from ..system.constraints import Floats
from ..system.turning import Turning


def cable_body(
    comm: MPI.Comm,
    scene: Scene,
    lines: Sequence[Floats],
    axial_stiffness: float,
    tension: Floats | float,
) -> CableBody:
    """Yarns as cables along the given centre lines."""
    return CableBody(
        comm,
        lines,
        axial_stiffness=axial_stiffness,
        tension=tension,
        degree=scene.yarn.degree,
        area=scene.yarn.section_area,
    )


def beam_body(
    comm: MPI.Comm, scene: Scene, lines: Sequence[Floats], tension: Floats | float
) -> BeamBody:
    """Yarns as beams, under tension but unbent as placed (or straight).

    Args:
        comm: Communicator.
        scene: The scene.
        lines: Positions and directors of each yarn's nodes, shape (num_nodes_i, 9).
        tension: Axial force as placed, N.
    """
    yarn = scene.yarn
    return BeamBody(
        comm,
        [line[:, :3] for line in lines],
        section=yarn_section(scene),
        material=yarn_material(scene),
        directors=[line[:, 3:].reshape(-1, 2, 3) for line in lines],
        degree=yarn.degree,
        bundle_factor=yarn.bundle_factor,
        torsion_factor=yarn.torsion_factor,
        natural_state="straight" if yarn.natural_state == "straight" else "as placed",
        tension=tension,
        axial_law="linear" if yarn.axial_law == "linear" else "Saint-Venant-Kirchhoff",
    )


def yarn_section(scene: Scene) -> BeamSection:
    """Section of beams; of degree 1, a share of the shear is taken at the nodes (bodies/tilt.py)."""
    yarn = scene.yarn
    circle = BeamSection.round(yarn.radius)
    inertia_1 = yarn.inertia_1 or circle.inertia_1
    inertia_2 = yarn.inertia_2 or circle.inertia_2
    return BeamSection(
        yarn.section_area,
        inertia_1,
        inertia_2,
        yarn.torsion_constant or inertia_1 + inertia_2,
        yarn.section_area * (1.0 - SHARE if yarn.degree == 1 else 1.0),
    )


def yarn_material(scene: Scene, axial_stiffness: float | None = None) -> YarnMaterial:
    """Material of beams; with an axial stiffness (N) other than the yarn's there is no lateral contraction."""
    yarn = scene.yarn
    real = axial_stiffness is None or axial_stiffness == yarn.axial_stiffness
    return YarnMaterial(
        (axial_stiffness or yarn.axial_stiffness) / yarn.section_area,
        yarn.transverse_modulus,
        yarn.shear_modulus,
        yarn.poisson_axial if real else 0.0,
        yarn.poisson_transverse,
    )


def cable_turning(body: CurveBody, first_unknown: int = 0) -> Turning | None:
    """Stabilisation of the tangents of cables whose unknowns begin at `first_unknown`."""
    if body.block != 3:
        return None
    nodes = np.setdiff1d(np.arange(body.num_nodes - 1), body.layout.curves[1:-1] - 1)
    length = np.repeat(body.rest_lengths() / body.layout.degree, body.layout.degree)
    before = first_unknown + 3 * nodes
    return Turning(before, before + 3, length)


def section_tilt(comm: MPI.Comm, scene: Scene, body: CurveBody) -> SectionTilt | None:
    """The nodes' share of the shear of beams of degree 1."""
    if body.block != 9 or body.layout.degree != 1:
        return None
    shear_stiffness = SHARE * scene.yarn.shear_modulus * scene.yarn.section_area
    return SectionTilt(body.layout, body.rest, shear_stiffness, mine=comm.rank == 0)
