"""A strand led along an arc, its wires stuck to the core: the strain of plane sections, whatever the first guess.

With the angle a of the wires from the cross-section the tension of a wire at the turn phi is
T + EA K r sin(phi) sin^2(a) (exact for wires that do not roll).
"""

import numpy as np
import pytest

from braidx.rods import Beam, Cable, Rods, YarnMaterial

CORE, WIRE, WIRES, LAY, TURNS = 1.0, 0.9, 3, 70.0, 1.0  # radii, lay, mm
TENSION, STIFFNESS, CURVATURE = 100.0, 1e5, 1e-4  # N, EA in N, 1/mm
SPANS = 12  # per turn
RADIUS = CORE + WIRE
PLANE_SECTIONS = STIFFNESS * CURVATURE * RADIUS / (1 + (2 * np.pi * RADIUS / LAY) ** 2)  # N


def bent(line):
    """Where plane sections take a line: the axis z goes to an arc, fibres at positive x are stretched."""
    x, y, z = line.T
    out = 1 / CURVATURE + x
    angle = CURVATURE * z
    return np.stack([out * np.cos(angle) - 1 / CURVATURE, y, out * np.sin(angle)], axis=1)


def strand(core, **options):
    z = np.linspace(0, TURNS * LAY, int(2 * SPANS * TURNS) + 1)
    axis = np.stack([0 * z, 0 * z, z], axis=1)
    stiff = YarnMaterial(1e5, 1e5, 4e4, 0.3, 0.3)
    rods = [
        Cable(axis, CORE, 10 * STIFFNESS, TENSION) if core == "cable" else Beam(axis, CORE, stiff)
    ]
    for k in range(WIRES):
        turn = 2 * np.pi * (k / WIRES + z / LAY)
        line = np.stack([RADIUS * np.cos(turn), RADIUS * np.sin(turn), z], axis=1)
        rods.append(Cable(line, WIRE, STIFFNESS, TENSION))
    out = Rods(rods, friction=5.0, tolerance=1e-7, penalty=1e5, **options)
    out.contact.laws.reversible_slip = 1e-3
    return out


def lead(rods):
    """The core's nodes and the ends of the wires go where plane sections take them."""
    rods.clamp(0, slice(None))
    for number, rod in enumerate(rods.rods):
        nodes = range(len(rod.line)) if number == 0 else (0, -1)
        for node in nodes:
            rods.pin(number, node)
            turn = (0, -CURVATURE * rod.line[node, 2], 0) if isinstance(rod, Beam) else (0, 0, 0)
            rods.move(number, node, by=(bent(rod.line) - rod.line)[node], turn=turn)


def guess(rods, kind):
    if kind == "default":
        return None
    out = {}
    for number, rod in list(enumerate(rods.rods))[1:]:
        line = bent(rod.line)
        out[number] = line
    return out


def amplitude(rods):
    """Amplitude of the tension over that of plane sections, away from the ends."""
    tensions, modes = [], []
    for k in range(WIRES):
        tension = rods.tension(k + 1)
        turn = (np.arange(len(tension)) + 0.5) / len(tension) * TURNS
        inside = (turn > 0.25) & (turn < TURNS - 0.25)
        phase = 2 * np.pi * (k / WIRES + turn[inside])
        tensions.append(tension[inside])
        modes.append(np.stack([np.ones_like(phase), np.cos(phase), np.sin(phase)], axis=1))
    found, *_ = np.linalg.lstsq(np.concatenate(modes), np.concatenate(tensions), rcond=None)
    return found[1] / PLANE_SECTIONS


def led(core, kind):
    rods = strand(core)
    for number in range(WIRES + 1):
        rods.pin(number, slice(None) if number == 0 else [0, -1])
    lead(rods)
    rods.solve(guess=guess(rods, kind))
    return amplitude(rods)


@pytest.mark.xfail(
    strict=True,
    raises=AssertionError,
    reason="cables have no sections: a pair turns as the first guess does, and friction acts on centre lines",
)
def test_stuck_wires_follow_plane_sections_from_any_guess():
    """Reversible slip takes a tenth of the amplitude; what is left does not depend on the guess."""
    found = np.array([led("cable", kind) for kind in ("default", "plane sections")])
    assert np.abs(found - 0.9).max() < 0.02 and np.ptp(found) < 1e-2, found
