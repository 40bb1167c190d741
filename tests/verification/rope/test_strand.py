"""R1: axial and torsional stiffness of a straight strand of 1 + m wires, against the closed form.

A wire's own stiffnesses E A, E I, G J and the helix angle a from the cross-section plane, s = sin a, c = cos a, give
K11 (force per strain), K12 = K21 (force per twist, couple per strain) and K22 (couple per twist). The penalty lets
the helix shrink by delta_r = q / k, q the force on the core per length of the strand. Exact for rigid sections.
Wires are curved bars, as thick as they are: fibres on the inside are shorter at rest, and a stretch e of the axis adds
- e c^2 / r to the change of the rate of rotation, from which Winkler's theory takes the couple of bending.
"""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from braidx.rods import Beam, BeamSection, Cable, Rods, YarnMaterial, helix, straight

MODULUS, SHEAR = 1e5, 4e4  # MPa
CORE, WIRE, WIRES = 1.1, 1.0, 6  # radii, mm: wires touch the core, not each other
HELIX = CORE + WIRE
PITCH, SPANS, DEGREE = 80.0, 32, 2
PENALTY = 1e5  # N/mm per mm
STRAINS = np.array([1e-3, 2e-3, 3e-3])
TWIST = 2e-4 / HELIX  # per length, to either side, 1/mm


def closed_form(bending, penalty=PENALTY):
    """K11, K12 = K21, K22 in N, N mm, N mm^2; `bending` 0 drops E I and G J."""
    angle = np.arctan2(PITCH, 2 * np.pi * HELIX)
    s, c, r = np.sin(angle), np.cos(angle), HELIX
    core, wire = BeamSection.round(CORE), BeamSection.round(WIRE)
    flexural, torsion = bending * MODULUS * wire.inertia_1, bending * SHEAR * wire.torsion_constant
    shrinkage = (
        MODULUS * wire.area * s * c**4 / (penalty * r**2)
    )  # delta_r c^2 / r over axial strain
    axial = MODULUS * wire.area / (1 + shrinkage)
    stretch = np.array([s**2, r * s * c])
    curvature = np.array([-(s**2) * c**2 / r, s * c * (1 + s**2)]) - c**2 / r * stretch
    twist = np.array([s * c**3 / r, s**4])
    parts = zip((axial, flexural, torsion), (stretch, curvature, twist))
    wires = WIRES * sum(stiffness * np.outer(rate, rate) for stiffness, rate in parts) / s
    own = np.array([[MODULUS * core.area, 0], [0, bending * SHEAR * core.torsion_constant]])
    return own + wires


def strand(beams, spans=SPANS, degree=DEGREE, **options):
    """The strand at rest, its end sections held; spans between nodes, degree of elements, options of Rods."""
    phases = 2 * np.pi / WIRES * np.arange(WIRES)
    lines = [straight((0, 0, 0), (0, 0, PITCH), spans)]
    lines += [helix(HELIX, PITCH, PITCH, spans, phase) for phase in phases]
    radii = [CORE, *[WIRE] * WIRES]
    if beams:
        rigid_across = YarnMaterial(MODULUS, 1e2 * MODULUS, SHEAR)
        parts = [Beam(line, r, rigid_across, degree=degree) for line, r in zip(lines, radii)]
    else:
        parts = [
            Cable(line, r, MODULUS * np.pi * r**2, tension=1.0, degree=degree)
            for line, r in zip(lines, radii)
        ]
    given = {"penalty": PENALTY, "penetration": None, "tolerance": 5e-7, **options}
    rods = Rods(parts, **given)
    rods.contact.laws.regularisation = 1e-9
    rods.contact.pairing.point_tolerance = 0.1  # lines touch all along: no closest points there
    for rod in range(1 + WIRES):
        rods.clamp(rod, [0, -1])
    return rods


def tilts(positions, strain, twist):
    """Rotation vectors by which sections of wires at rest tilt with the angle of the helix, shape (n, 3)."""
    lay, outside = 2 * np.pi * HELIX / PITCH, np.hypot(*positions[:, :2].T) > CORE
    tilt = np.arctan2(1 + strain, lay + HELIX * twist) - np.arctan2(1, lay)
    return outside[:, None] * tilt * positions * [1, 1, 0] / HELIX


def uniform(rods, strain, twist):
    """All nodes stretched and twisted alike at constant radius: first guess."""
    guess = []
    for rod in range(1 + WIRES):
        x = rods.positions(rod)
        turn = Rotation.from_rotvec(np.outer(twist * x[:, 2], [0, 0, 1]))
        tilted = turn * Rotation.from_rotvec(tilts(x, strain, twist))
        directors = [tilted.apply(g) for g in rods.directors(rod).swapaxes(0, 1)]
        guess.append(np.hstack([turn.apply(x) + np.outer(strain * x[:, 2], [0, 0, 1]), *directors]))
    return np.concatenate(guess).ravel()


def end_loads(beams, strain, twist, **options):
    """Force (N) and couple (N mm) on the far end at an axial strain and a twist per length."""
    rods = strand(beams, **options)
    for rod in range(1 + WIRES):
        for node in (0, -1):
            tilt = tilts(rods.positions(rod)[[node]], strain, twist)[0]
            rods.move(rod, node, turn=tilt)
        along, turn = (0, 0, strain * PITCH), (0, 0, twist * PITCH)
        rods.move(rod, -1, by=along, turn=turn, about=(0, 0, 0))
    rods.solve(guess=uniform(rods, strain, twist))
    force, couple = np.zeros(3), np.zeros(3)
    for rod in range(1 + WIRES):
        pull, moment = rods.reaction(rod, -1)
        force += pull
        couple += moment + np.cross(rods.positions(rod)[-1], pull)
    return force[2], couple[2]


def stiffness(beams, **options):
    """Derivatives of force and couple with strain and twist, extrapolated to the state at rest."""
    loads = np.array(
        [[end_loads(beams, e, t, **options) for t in (-TWIST, TWIST)] for e in STRAINS]
    )
    with_strain = np.polyfit(STRAINS, loads.mean(axis=1), 2)[1]
    with_twist = np.polyfit(STRAINS, (loads[:, 1] - loads[:, 0]) / (2 * TWIST), 2)[2]
    return np.stack([with_strain, with_twist], axis=1)


@pytest.mark.parametrize("beams", [True, False], ids=["beams", "cables"])
def test_stiffness(record, beams):
    """Without the wires' thickness in the closed form K12 of beams would be missed by 0.3 %."""
    exact, got = closed_form(float(beams)), stiffness(beams)
    kind = "beams" if beams else "cables"
    for row, column in ((0, 0), (0, 1), (1, 0), (1, 1)):
        what = f"strand of 1 + 6 {kind}: K{row + 1}{column + 1}"
        record.check("R1", what, got[row, column], exact[row, column], 1e-3)
