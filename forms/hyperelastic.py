"""Stored energies of solids, split into the shares that take different quadratures (forms.solid).

F = grad x is the deformation gradient of the current position x, E = 1/2 (F^T F - I) the
Green-Lagrange strain. Constants are those of an isotropic law (`Isotropic`) or of one that is isotropic
across a unit direction a, the fibre (materials.TransverselyIsotropic).
"""

from typing import Any, NamedTuple

import ufl

from .materials import TransverselyIsotropic, stiffness


class Isotropic(NamedTuple):
    """Constants of an isotropic law."""

    modulus: Any  # Young's modulus, MPa
    poisson: Any  # Poisson's ratio, -


class Split(NamedTuple):
    """Energy per reference volume, MPa, in shares of which none is ever negative without prestress.

    Without a fibre `axial` and `shear` are None, `shape` is the energy of the whole change of shape and `volume` that
    of the change of volume.
    """

    axial: Any  # of the fibre's strain while the section contracts freely
    shear: Any  # of the shear between fibre and section
    shape: Any  # of the section's change of shape
    volume: Any  # of the section's change of area beyond its free contraction


def green_lagrange(gradient: Any, step: Any = None) -> Any:
    """Green-Lagrange strain E of a deformation gradient, shape (3, 3).

    With the gradient of the last step of Newton's method it is the strain that this step foresaw, which lacks the
    square of the step (bodies.assembled).
    """
    strain = 0.5 * (gradient.T * gradient - ufl.Identity(3))
    return strain if step is None else strain - 0.5 * step.T * step


def _lame(law: Isotropic) -> tuple[Any, Any]:
    """Shear and bulk modulus, MPa."""
    shear = law.modulus / (2.0 * (1.0 + law.poisson))
    return shear, law.modulus / (3.0 * (1.0 - 2.0 * law.poisson))


def saint_venant_kirchhoff(strain: Any, law: Isotropic) -> Split:
    """Quadratic in E: mu dev E : dev E + K / 2 (tr E)^2."""
    shear, bulk = _lame(law)
    shape = ufl.dev(strain)
    return Split(None, None, shear * ufl.inner(shape, shape), 0.5 * bulk * ufl.tr(strain) ** 2)


def neo_hooke(gradient: Any, law: Isotropic) -> Split:
    """Compressible, with decoupled change of volume: mu / 2 (J^(-2/3) tr C - 3) + K / 2 (ln J)^2."""
    shear, bulk = _lame(law)
    volume = ufl.det(gradient)
    stretch = ufl.inner(gradient, gradient) * volume ** (-2.0 / 3.0)
    return Split(None, None, 0.5 * shear * (stretch - 3.0), 0.5 * bulk * ufl.ln(volume) ** 2)


def transversely_isotropic(
    strain: Any, fibre: Any, law: TransverselyIsotropic, fibre_stress: Any = 0.0
) -> Split:
    """Quadratic in E, isotropic across the unit direction `fibre` (shape (3,)).

    The energies of `materials`, written with the invariants tr E, a.E.a, |E a|^2 and tr E^2, so that no
    second direction is needed. Compressed beyond about G_a along the fibre it kinks, as bundles of
    fibres do, in bands of one cell: a yarn that bends without being pulled needs a G_a of that size.
    `fibre_stress` is the fibre's second Piola-Kirchhoff stress at rest, MPa.
    """
    along = ufl.dot(strain, fibre)
    axial = ufl.dot(fibre, along)
    slide = ufl.dot(along, along) - axial**2
    # Sum of e11 and e22, and of the squares of the section's strains, beyond the free contraction.
    free = law.axial_poisson * axial
    trace = ufl.tr(strain) - axial
    area = trace + 2.0 * free
    squares = ufl.inner(strain, strain) - 2.0 * slide - axial**2 + 2.0 * free * (trace + free)
    c = stiffness(law)
    return Split(
        axial=0.5 * law.axial_modulus * axial**2 + fibre_stress * axial,
        shear=2.0 * law.axial_shear_modulus * slide,
        shape=0.5 * (c.c11 - c.c12) * (squares - 0.5 * area**2),
        volume=0.25 * (c.c11 + c.c12) * area**2,
    )


def stress(gradient: Any, energy: Any) -> Any:
    """Cauchy stress, MPa, of an `energy` that is a function of the ufl.variable `gradient`."""
    nominal = ufl.diff(energy, gradient)
    return nominal * gradient.T / ufl.det(gradient)


def von_mises(cauchy: Any) -> Any:
    """Equivalent stress after von Mises, MPa, never negative."""
    shape = ufl.dev(cauchy)
    return ufl.sqrt(1.5 * ufl.inner(shape, shape))
