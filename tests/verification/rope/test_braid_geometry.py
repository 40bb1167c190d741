"""R3: cover and jamming of a biaxial braid of N yarns of width w on a radius R (exact): N = 12, w = 2 mm."""

import math

import pytest

from braidx.geometry.closed_forms import cover_factor, jamming_angle


@pytest.mark.parametrize("degrees, cover", [(30, 0.6876), (45, 0.7886), (60, 0.9443)])
def test_cover(record, degrees, cover):
    computed = cover_factor(12, 2.0, 5.0, math.radians(degrees))
    record.check(
        "R3", f"braid at {degrees} degrees, R = 5: cover", computed, cover, 5e-5, scale=1.0
    )


def test_jamming(record):
    computed = math.degrees(jamming_angle(12, 2.0, 4.0))
    record.check("R3", "braid, R = 4: jamming angle, degrees", computed, 61.48, 1e-4)
