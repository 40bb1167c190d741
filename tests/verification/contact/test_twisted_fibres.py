"""C4: two straight fibres, stretched and turned round each other, become a double helix.

Inputs as published; the results are exact for inextensible sections without torsion.
"""

import numpy as np

from braidx.rods import Beam, BeamSection, Rods, YarnMaterial, straight

LENGTH, RADIUS, OFFSET = 5.0, 0.01, 0.0095
AREA, INERTIA, MODULUS = np.pi * 1e-4, 7.8539816e-9, 1e9
STRETCH, PENALTY = 0.04964722261, 4.6845279809533553e4
ELEMENTS = 80
MIDDLE, LOAD, END_FORCE = -0.019, 46.8452798, 3141.3715  # displacement, per rest length, per fibre


def fibres(spans, degree):
    """Shear hardly deforms the fibres, nor does transverse load; torsion costs next to nothing.

    As in the reference, the force is linear in the stretch of the axis.
    """
    section = BeamSection(AREA, INERTIA, INERTIA, 2 * INERTIA, AREA)
    material = YarnMaterial(MODULUS, MODULUS, MODULUS)
    frame = np.tile([[1.0, 0, 0], [0, 1, 0]], (spans + 1, 1, 1))
    lines = [straight((x, 0, 0), (x, 0, LENGTH), spans) for x in (-OFFSET, OFFSET)]
    return [
        Beam(line, RADIUS, material, section, frame, degree, 1.0, 1e-3, axial_law="linear")
        for line in lines
    ]


def double_helix(rest):
    """First guess: sections turned with the ends and square to the helix, shape as `rest`."""
    x, z = rest[:, 0], rest[:, 2]
    angle, height = 2 * np.pi * z / LENGTH, (1 + STRETCH / LENGTH) * z
    cos, sin = np.cos(angle), np.sin(angle)
    radial = np.stack([cos, sin, 0 * z], axis=1)
    across = np.stack([-sin, cos, 0 * z], axis=1)
    climb = (LENGTH + STRETCH) / (2 * np.pi * x[:, None])  # of the helix, over its circumference
    binormal = (climb * across - [0, 0, 1]) / np.hypot(climb, 1) * np.sign(climb)
    return np.hstack([x[:, None] * radial + height[:, None] * [0, 0, 1], radial, binormal])


def twisted(spans=ELEMENTS, degree=1, **options):
    """Fibres after one turn of their far end, which brings it back to where it was but for the stretch.

    Args:
        spans: Between nodes of a fibre; an element takes `degree` of them.
        options: Of Rods.
    """
    rods = Rods(fibres(spans, degree), penalty=PENALTY, penetration=None, **options)
    rods.contact.laws.regularisation = 1e-9
    for rod in (0, 1):
        rods.hold(rod, [0, -1], slice(0, 6))  # g1 stays radial: no radial component of the tangent
        rods.move(rod, -1, by=(0.0, 0.0, STRETCH))
    rest = np.concatenate([rods.positions(rod) for rod in (0, 1)])
    rods.solve(guess=double_helix(rest).ravel())
    return rods


def test_double_helix(record):
    rods = twisted()
    size = rods.q.size
    moved = rods.positions(1)[ELEMENTS // 2, 0] - OFFSET
    record.check("C4", "double helix: u_x of the middle", moved, MIDDLE, 1e-3, unknowns=size)
    contacts = rods.contacts()
    load = contacts["normal_force"] / contacts["weight"]
    force = [abs(rods.reaction(rod, end)[0][2]) for rod in (0, 1) for end in (0, -1)]
    depth = -contacts["gap"]
    record.check("C4", "double helix: penetration", depth, 1e-3, 1.5e-2, unknowns=size)
    record.check("C4", "double helix: load per length", load, LOAD, 1.5e-2, unknowns=size)
    median = np.median(load)
    record.check("C4", "double helix: its median", median, LOAD, 1e-3, unknowns=size)
    record.check("C4", "double helix: axial force", force, END_FORCE, 2e-5, unknowns=size)
