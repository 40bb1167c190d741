"""Bodies of rods that are alike."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from mpi4py import MPI

from ..bodies import BeamBody, BeamSection, CableBody, CurveBody, SolidBody
from ..meshing import join, sweep
from .rod import Beam, Cable, Rod, Solid
from .sections import directors_of


def make_body(comm: MPI.Comm, rods: Sequence[Rod]) -> CurveBody | SolidBody:
    """One body of rods of one model, degree, law and natural state, in their order."""
    solids = [rod for rod in rods if isinstance(rod, Solid)]
    if solids:
        return _solid_body(comm, solids)
    lines = [np.asarray(rod.line, dtype=np.float64) for rod in rods]
    degree, tension = rods[0].degree, [rod.tension for rod in rods]
    if isinstance(rods[0], Cable):
        return CableBody(
            comm,
            lines,
            axial_stiffness=[rod.axial_stiffness for rod in rods if isinstance(rod, Cable)],
            tension=tension,
            degree=degree,
            area=[rod.section.area for rod in rods if isinstance(rod, Cable)],
        )
    beams = [rod for rod in rods if isinstance(rod, Beam)]
    factors = [beam.bundle_factor for beam in beams]
    return BeamBody(
        comm,
        lines,
        section=[_section(beam) for beam in beams],
        material=[beam.material for beam in beams],
        directors=[directors_of(beam) for beam in beams],
        degree=degree,
        bundle_factor=factors,
        torsion_factor=[
            factor if beam.torsion_factor is None else beam.torsion_factor
            for beam, factor in zip(beams, factors, strict=True)
        ],
        natural_state=beams[0].natural_state,
        tension=tension,
        axial_law=beams[0].axial_law,
    )


def _solid_body(comm: MPI.Comm, rods: Sequence[Solid]) -> SolidBody:
    meshes = []
    for rod in rods:
        assert rod.section is not None
        meshes.append(sweep(np.asarray(rod.line, float), rod.section, directors_of(rod)))
    return SolidBody(
        comm,
        join(meshes),
        material=[rod.material for rod in rods],
        law=rods[0].law,
        fibre_stress=np.array([rod.tension / rod.area for rod in rods]),
    )


def _section(beam: Beam) -> BeamSection:
    assert beam.section is not None
    return beam.section
