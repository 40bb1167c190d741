"""Zigzag stretch of sections is resisted by their own stiffness, however thin the filaments."""

import numpy as np
import pytest
from beam_line import beam_line

from braidx.forms.curve import gauss


def section_stretch_stiffness(line, parts):
    """Tangent for the modes e11, e22, e12 of each section, shape (15, 15)."""
    modes = np.zeros((5, 9, 5, 3))
    for node in range(5):
        modes[node, 4, node, 0] = 1.0
        modes[node, 8, node, 1] = 1.0
        modes[node, [5, 7], node, 2] = np.sqrt(0.5)
    modes = modes.reshape(45, 15)
    return modes.T @ sum(line.tangent([part]) for part in parts) @ modes


def lowest_over_largest(matrix):
    values = np.linalg.eigvalsh(matrix)
    return values[0] / values[-1]


@pytest.mark.parametrize("degree", [1, 2])
def test_no_section_hourglass(degree):
    line = beam_line(degree)
    assert lowest_over_largest(section_stretch_stiffness(line, line.parts)) > 0.05


def test_one_point_for_all_has_the_hourglass():
    line = beam_line(degree=1)
    parts = [gauss(part.density, num_points=1) for part in line.parts]
    assert lowest_over_largest(section_stretch_stiffness(line, parts)) < 1e-4
