"""Each part of an energy is compiled on its own: the defect that this avoids, and its avoidance."""

import numpy as np
import pytest
import ufl
from beam_line import beam_line
from dolfinx import fem

from braidx.bodies.assembly import compile_form
from braidx.forms.variation import variations


def disturbed_line():
    line = beam_line()
    line.state.x.array[:] += 0.3 * np.random.default_rng(5).standard_normal(45)
    return line


def finite_difference_tangent(line, step=1e-6):
    space = line.state.function_space
    test = ufl.TestFunction(space)
    gradients = [
        compile_form(ufl.derivative(line.form([part]), line.state, test)) for part in line.parts
    ]

    def gradient():
        total = np.zeros(45)
        for form in gradients:
            fem.assemble_vector(total, form)
        return total

    columns = np.zeros((45, 45))
    for i in range(45):
        line.state.x.array[i] += step
        columns[:, i] = gradient()
        line.state.x.array[i] -= 2.0 * step
        columns[:, i] -= gradient()
        line.state.x.array[i] += step
    return columns / (2.0 * step)


def relative_difference(matrix, reference):
    return np.linalg.norm(matrix - reference) / np.linalg.norm(reference)


def test_tangent_of_separate_forms_is_the_derivative_of_the_residual():
    line = disturbed_line()
    separate = sum(line.tangent([part]) for part in line.parts)
    assert relative_difference(separate, finite_difference_tangent(line)) < 1e-8


@pytest.mark.xfail(strict=True, reason="FFCx assembles a wrong matrix from mixed degrees")
def test_tangent_of_one_form_with_two_degrees():
    """Fails as long as the compiler has the defect; when it passes, the separation may go."""
    line = disturbed_line()
    separate = sum(line.tangent([part]) for part in line.parts)
    assert relative_difference(line.tangent(line.parts), separate) < 1e-12


@pytest.mark.parametrize("degree", [1, 2])
def test_variations_keep_one_degree_per_form(degree):
    line = beam_line(degree)
    for variation in variations(line.parts, line.state):
        for form in variation:
            degrees = {i.metadata()["quadrature_degree"] for i in form.integrals()}
            assert len(degrees) == 1
