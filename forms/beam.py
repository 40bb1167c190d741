"""Beam with deformable sections: nine unknowns per node, the position x and two directors g1, g2.

A particle of the section is at x + xi1 g1 + xi2 g2 (paper 1, eq. 1). A plain three-dimensional law
on both axial force and bending locks, because a section that can only deform uniformly sees the
constrained modulus in bending. The energy is therefore split: the full law acts on the strain at
the centroid, uniaxial moduli on the parts linear in (xi1, xi2):

    psi = A w(E0) + T0 E0_33 + 1/2 beta E sum_a I_a k_a^2 + 1/2 beta_t G sum_ab I_ab t_ab^2
    E0 = 1/2 (F^T F - F0^T F0),  F = [g1 g2 x']
    k_a = x' . g_a' - X' . G_a'          curvature
    t_ab = g_a . g_b' - G_a . G_b'       torsion (a != b), gradient of the section's stretch (a = b)

with I_a the integral of xi_a^2 over the section, I_ab = I_b for a = b and I_b J / (I_1 + I_2) else,
so that J is the torsion constant. beta is paper 1's reduction of the stiffness of bending ("bundle
factor", about one over the number of filaments), beta_t the same for torsion. T0 is the tension of
the reference state, whose sections and curvature may be free of stress all the same.
"""

from typing import Any, NamedTuple

import ufl

from .curve import LIKE_NODES, Nodes, Part, arc_derivative, at_nodes, change_of_slope, gauss
from .materials import (
    Strain,
    TransverselyIsotropic,
    axial_energy,
    section_energy,
    shear_energy,
)


class Section(NamedTuple):
    """Constants of a section; each a scalar, constant in an element."""

    area: Any  # A, mm^2
    shear_area: Any  # area that resists shear between axis and section, mm^2
    inertia_1: Any  # I_1, integral of xi1^2, mm^4
    inertia_2: Any  # I_2, integral of xi2^2, mm^4
    torsion_constant: Any  # J, mm^4
    bundle_factor: Any  # beta, -
    torsion_factor: Any  # beta_t, -
    natural_curvature: Any  # share of the placed curvature and torsion free of stress, 0 to 1
    tension: Any  # T0, axial force in the reference state, N


class Frame(NamedTuple):
    """Axis and directors at a point, with their derivatives by reference arc length."""

    slope: Any  # x', shape (3,)
    directors: tuple[Any, Any]  # g1, g2, shape (3,), -
    rates: tuple[Any, Any]  # g1', g2', shape (3,), 1/mm
    change: Any  # of the slope along an element, shape (3,), -


def _third(vector: Any, i: int) -> Any:
    return ufl.as_vector([vector[3 * i + j] for j in range(3)])


def current_frame(unknowns: Any, tangent: Any) -> Frame:
    """Frame of the current state; `unknowns` of shape (9,) are x (mm), g1 and g2."""
    rate = arc_derivative(unknowns, tangent)
    return Frame(
        slope=_third(rate, 0),
        directors=(_third(unknowns, 1), _third(unknowns, 2)),
        rates=(_third(rate, 1), _third(rate, 2)),
        change=_third(change_of_slope(unknowns, tangent), 0),
    )


def rest_frame(rest: Any, tangent: Any) -> Frame:
    """Frame of the reference state: directors from `rest`, shape (9,), the axis from the mesh."""
    return current_frame(rest, tangent)._replace(slope=tangent)


class Products(NamedTuple):
    """Scalar products of a frame's vectors: strains are differences of them."""

    directors: Any  # g_a . g_b, shape (2, 2), -
    stretch: Any  # x' . x', -
    shear: Any  # g_a . x', shape (2,), -
    bending: Any  # x' . g_a', shape (2,), 1/mm
    torsion: Any  # g_a . g_b', shape (2, 2), 1/mm
    bow: Any  # of the change of slope with itself, -

    def less(self, other: "Products") -> "Products":
        """Differences from those of another frame."""
        return Products(*(mine - its for mine, its in zip(self, other)))


def products(frame: Frame) -> Products:
    """Scalar products of a frame's vectors."""

    def matrix(others: tuple[Any, Any]) -> Any:
        return ufl.as_matrix([[ufl.dot(g, other) for other in others] for g in frame.directors])

    return Products(
        directors=matrix(frame.directors),
        stretch=ufl.dot(frame.slope, frame.slope),
        shear=ufl.as_vector([ufl.dot(g, frame.slope) for g in frame.directors]),
        bending=ufl.as_vector([ufl.dot(frame.slope, rate) for rate in frame.rates]),
        torsion=matrix(frame.rates),
        bow=ufl.dot(frame.change, frame.change),
    )


def centroid_strain(now: Products, rest: Products) -> Strain:
    """Green-Lagrange strain E0 on the axis."""
    change = now.less(rest)
    return Strain(
        e11=0.5 * change.directors[0, 0],
        e22=0.5 * change.directors[1, 1],
        e12=0.5 * change.directors[0, 1],
        e33=0.5 * change.stretch,
        e13=0.5 * change.shear[0],
        e23=0.5 * change.shear[1],
    )


def smooth_strain(now: Products, rest: Products, nodes: Nodes) -> Strain:
    """Strain on the axis at nodes, where e33 is that of the line through its values at the Gauss points.

    In a bent element of degree 2 the axial strain itself is a parabola that vanishes at the Gauss points only. Sections
    that were to contract by it would narrow and widen from node to node, which locks the bending of thin rods.
    """
    strain = centroid_strain(now, rest)
    return strain._replace(e33=strain.e33 - 0.5 * nodes.beyond_gauss * (now.bow - rest.bow))


def stretching_energy(strain: Strain, section: Section, law: TransverselyIsotropic) -> Any:
    """Energy of the axial strain per reference length, N, tension of the reference state included."""
    return section.area * axial_energy(strain, law) + section.tension * strain.e33


def bending_energy(
    now: Products, rest: Products, section: Section, law: TransverselyIsotropic
) -> Any:
    """Energy of bending per reference length, N."""
    curvature = now.bending - section.natural_curvature * rest.bending
    inertias = (section.inertia_1, section.inertia_2)
    density = sum(inertia * curvature[a] ** 2 for a, inertia in enumerate(inertias))
    return 0.5 * section.bundle_factor * law.axial_modulus * density


def torsion_energy(
    now: Products, rest: Products, section: Section, law: TransverselyIsotropic
) -> Any:
    """Energy of torsion and of the gradient of the section's stretch per reference length, N."""
    change = now.torsion - section.natural_curvature * rest.torsion
    inertias = (section.inertia_1, section.inertia_2)
    warping = section.torsion_constant / (section.inertia_1 + section.inertia_2)
    density = 0.0
    for a in range(2):
        for b in range(2):
            weight = inertias[b] if a == b else warping * inertias[b]
            density += weight * change[a, b] ** 2
    return 0.5 * section.torsion_factor * law.axial_shear_modulus * density


def energy(
    now: Products, rest: Products, section: Section, law: TransverselyIsotropic, degree: int
) -> list[Part]:
    """Stored energy, with selective quadrature.

    One Gauss point per element of degree 1 (two of degree 2) avoids shear and membrane locking but
    does not see sections that stretch in a zigzag from node to node (hourglass). The strain of the
    section is therefore integrated at the nodes, where the directors are unknowns of their own:
    every section resists its stretch, and none is strained only because directors that are turned
    against each other get shorter between the nodes, which would lock the bending of thin rods.

    Args:
        now, rest: Products of the current and the reference frame. Without those of the last step of Newton's method,
            `now` has the stresses that this step foresaw (Products.less, bodies.beam).
        section, law: Constants of the section and of the yarn.
        degree: Degree of the line elements, 1 or 2.
    """
    strain = centroid_strain(now, rest)
    axis = stretching_energy(strain, section, law) + section.shear_area * shear_energy(strain, law)
    turning = bending_energy(now, rest, section, law) + torsion_energy(now, rest, section, law)
    stretch = [
        at_nodes(section.area * section_energy(smooth_strain(now, rest, nodes), law), nodes)
        for nodes in LIKE_NODES[degree]
    ]
    return [gauss(axis + turning, num_points=degree), *stretch]


def axial_force(now: Frame, rest: Frame, section: Section, law: TransverselyIsotropic) -> Any:
    """Force along the current axis, N, positive when pulled: projection of d energy / d x'."""
    slope = ufl.variable(now.slope)
    moved, placed = products(now._replace(slope=slope)), products(rest)
    strain = centroid_strain(moved, placed)
    normal = stretching_energy(strain, section, law) + section.area * section_energy(strain, law)
    shear = section.shear_area * shear_energy(strain, law)
    density = normal + shear + bending_energy(moved, placed, section, law)
    return ufl.dot(ufl.diff(density, slope), slope) / ufl.sqrt(ufl.dot(slope, slope))
