"""Elastic laws of yarns, written for any scalar type (UFL expressions or floats)."""

from typing import Any, NamedTuple


class TransverselyIsotropic(NamedTuple):
    """Saint-Venant-Kirchhoff law, isotropic in the plane (1, 2) across the yarn's axis 3."""

    axial_modulus: Any  # E_a, MPa
    transverse_modulus: Any  # E_t, MPa
    axial_shear_modulus: Any  # G_a, MPa
    axial_poisson: Any  # contraction across by stretching along, -
    transverse_poisson: Any  # contraction across by stretching across, -


class Strain(NamedTuple):
    """Green-Lagrange strain in the frame of the section; each component a scalar."""

    e11: Any
    e22: Any
    e12: Any
    e33: Any
    e13: Any
    e23: Any


class SectionStiffness(NamedTuple):
    """Elastic constants of strains across the yarn at held axial strain, MPa."""

    c11: Any
    c12: Any


def stiffness(law: TransverselyIsotropic) -> SectionStiffness:
    """Invert the compliance of a transversely isotropic law.

    The axial Poisson ratio n_a and the transverse one n_t enter through
    m = E_t / E_a n_a^2; the law is positive definite if |n_t| < 1 and 1 - n_t - 2 m > 0.
    """
    m = law.transverse_modulus / law.axial_modulus * law.axial_poisson**2
    volumetric = 1.0 - law.transverse_poisson - 2.0 * m
    in_plane = law.transverse_modulus / ((1.0 + law.transverse_poisson) * volumetric)
    return SectionStiffness(
        c11=in_plane * (1.0 - m),
        c12=in_plane * (law.transverse_poisson + m),
    )


def axial_energy(e33: Any, law: TransverselyIsotropic) -> Any:
    """Energy of the axial strain while the section contracts freely, MPa."""
    return 0.5 * law.axial_modulus * e33**2


def section_energy(strain: Strain, law: TransverselyIsotropic) -> Any:
    """Energy of the section's strain beyond its free contraction -n_a e33, MPa.

    Together with `axial_energy` it is the whole energy of the normal strains and e12; as neither is
    ever negative, they may be integrated at different points.
    """
    c = stiffness(law)
    e11 = strain.e11 + law.axial_poisson * strain.e33
    e22 = strain.e22 + law.axial_poisson * strain.e33
    normal = 0.5 * c.c11 * (e11**2 + e22**2) + c.c12 * e11 * e22
    return normal + (c.c11 - c.c12) * strain.e12**2


def shear_energy(strain: Strain, law: TransverselyIsotropic) -> Any:
    """Energy of the shear between axis and section, MPa."""
    return 2.0 * law.axial_shear_modulus * (strain.e13**2 + strain.e23**2)
