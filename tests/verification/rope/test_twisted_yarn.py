"""R2: modulus of a twisted yarn of constant pitch, cos^2 B of its filaments', B the helix angle at its surface.

Derivation: a filament at radius r is strained by cos^2 of its angle, pulls with another cos and fills 1 / cos of its
own area: the mean of cos^4 over the yarn is cos^2 B. Approximate, as the yarn does not contract.
"""

import braidx_engine as engine
import numpy as np
import pytest

from braidx.rods import Cable, Rods, helix

PITCH, THIN, STIFFNESS, STRAIN = 60.0, 0.01, 1e4, 1e-3
TAUT = 1.0  # N: lays the filament on its core
LAYERS, SPANS = 10, 48


def pull(radius):
    """Axial force over that of a straight filament; the helix is wound on a smooth core that does not give."""
    axis = np.array([0.0, 0.0, 1.0])
    core = engine.make_cylinder(0.0 * axis, axis, radius - THIN, False, 0)
    line = helix(radius, PITCH, PITCH / 2.0, SPANS)
    options = {"penalty": 1e5, "penetration": None, "max_step": 0.1, "tolerance": 1e-7}
    rods = Rods([Cable(line, THIN, STIFFNESS, TAUT, degree=2)], rigid=[core], **options)
    rods.pin(0, [0, -1])
    rods.solve()
    taut = rods.reaction(0, -1)[0][2]
    rods.move(0, -1, by=(0.0, 0.0, STRAIN * PITCH / 2.0))
    rods.solve(increments=2)
    return (rods.reaction(0, -1)[0][2] - taut) / (STIFFNESS * STRAIN)


@pytest.mark.parametrize("surface_angle", [10, 20, 30])
def test_modulus(record, surface_angle):
    outer = np.tan(np.radians(surface_angle)) * PITCH / (2.0 * np.pi)
    radii = outer * (np.arange(LAYERS) + 0.5) / LAYERS
    cos = np.cos(np.arctan(2.0 * np.pi * radii / PITCH))
    modulus = np.average(cos * [pull(radius) for radius in radii], weights=radii)
    exact = np.cos(np.radians(surface_angle)) ** 2
    what = f"twisted yarn, B = {surface_angle} degrees: modulus ratio"
    record.check("R2", what, modulus, exact, 2e-3)
