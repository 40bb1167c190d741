"""What yarns of a bent rope look like and bear in a state, whatever they are modelled as."""

from __future__ import annotations

import numpy as np

from ...system.constraints import Floats
from .assembly import Assembly


def centre_lines(assembly: Assembly, q: Floats) -> tuple[Floats, ...]:
    """Centre lines of all yarns, shape (num_nodes, 3) each, mm, with the nodes of the straight rope."""
    out = [np.empty_like(line) for line in assembly.lines]
    for stretch, piece in zip(assembly.stretches, assembly.pieces, strict=True):
        out[stretch.yarn][stretch.nodes] = piece.centre_line(q)
    return tuple(out)


def directors(assembly: Assembly, q: Floats) -> tuple[Floats, ...] | None:
    """Sections of yarns, shape (num_nodes, 2, 3) each, if all of them are beams from end to end."""
    if any(not piece.directors for piece in assembly.pieces):
        return None
    return tuple(piece.sections(q) for piece in assembly.pieces)


def axial_stress(assembly: Assembly, q: Floats) -> tuple[Floats, ...]:
    """Axial force of yarns over their section at rest, between the nodes of centre lines, MPa."""
    out = [np.empty(len(line) - 1) for line in assembly.lines]
    area = assembly.scene.yarn.section_area
    for model, part in (("cable", assembly.cables), ("beam", assembly.beams)):
        if part is None:
            continue
        body, first = part
        rows = q[first : first + body.num_unknowns].reshape(-1, body.block)
        stress, cuts = body.axial_stress(rows), body.layout.curve_elements
        for curve, stretch in enumerate(assembly.of(model)):
            out[stretch.yarn][stretch.first : stretch.last] = stress[cuts[curve] : cuts[curve + 1]]
    if assembly.solids is not None:
        solid, first = assembly.solids
        rows = q[first : first + solid.num_unknowns].reshape(-1, 3)
        for part_number, stretch in enumerate(assembly.of("solid")):
            force = solid.mean_axial_force(rows, part_number)
            elements = force.reshape(stretch.last - stretch.first, -1)
            out[stretch.yarn][stretch.first : stretch.last] = elements.mean(axis=1) / area
    return tuple(out)
