"""Conduction of heat in a body of revolution: quadratic functionals of the temperature.

The mesh lies in the plane (r, z); every integral is over the body, 2 pi r dr dz, or over its
surface. Units: mm, s, W, J, K. The matrix of a functional is its second derivative.
"""

from typing import Any

import ufl

from .variation import Variation


def radius(mesh: ufl.Mesh) -> Any:
    """Distance from the axis, mm."""
    return ufl.SpatialCoordinate(mesh)[0]


def capacity(temperature: ufl.Coefficient, heat_capacity: Any, degree: int) -> Variation:
    """Half the heat capacity times the square of the temperature.

    Args:
        temperature: The unknown field, K.
        heat_capacity: Per volume, J/(mm^3 K).
        degree: Quadrature degree that is exact for the field's products times r.
    """
    density = 0.5 * heat_capacity * temperature**2
    return _variation(density, ufl.dx, temperature, degree)


def conduction(temperature: ufl.Coefficient, across: Any, along: Any, degree: int) -> Variation:
    """Half the heat conducted, with conductivities across and along the axis, W/(mm K)."""
    slope = ufl.grad(temperature)
    density = 0.5 * (across * slope[0] ** 2 + along * slope[1] ** 2)
    return _variation(density, ufl.dx, temperature, degree)


def convection(temperature: ufl.Coefficient, transfer: Any, degree: int) -> Variation:
    """Half the heat given off by the lateral surface into surroundings of zero temperature.

    Args:
        temperature: The unknown field, K.
        transfer: Coefficient of heat transfer, W/(mm^2 K).
        degree: Quadrature degree.
    """
    normal = ufl.FacetNormal(temperature.ufl_function_space().ufl_domain())
    # Of all boundaries the one that faces away from the axis; ends and bore are insulated.
    lateral = ufl.conditional(ufl.gt(normal[0], 0.5), 1.0, 0.0)
    return _variation(0.5 * lateral * transfer * temperature**2, ufl.ds, temperature, degree)


def source(test: Any, density: ufl.Coefficient, degree: int) -> ufl.Form:
    """Power of a heat source, W/mm^3, on each test function, W."""
    mesh = density.ufl_function_space().ufl_domain()
    measure = ufl.dx(domain=mesh, metadata={"quadrature_degree": degree})
    return 2.0 * ufl.pi * radius(mesh) * density * test * measure


def _variation(density: Any, measure: Any, field: ufl.Coefficient, degree: int) -> Variation:
    space = field.ufl_function_space()
    mesh = space.ufl_domain()
    around = 2.0 * ufl.pi * radius(mesh)
    energy = around * density * measure(domain=mesh, metadata={"quadrature_degree": degree})
    residual = ufl.derivative(energy, field, ufl.TestFunction(space))
    return Variation(energy, residual, ufl.derivative(residual, field, ufl.TrialFunction(space)))
