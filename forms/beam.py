"""Beam with deformable sections: nine unknowns per node, the position x and two directors g1, g2.

A particle of the section is at x + xi1 g1 + xi2 g2 (paper 1, eq. 1). A plain three-dimensional law
on both axial force and bending locks, because a section that can only deform uniformly sees the
constrained modulus in bending. The energy is therefore split: the full law acts on the strain at
the centroid, averaged over the section along the fibres, uniaxial moduli on the parts linear in (xi1, xi2):

    psi = A w(E0) + T0 e + 1/2 beta E sum_a I_a k_a^2 + 1/2 beta_t G sum_ab I_ab t_ab^2
    E0 = 1/2 (F^T F - F0^T F0),  F = [g1 g2 x'],  d_a = g_a' - F F0^-1 G_a'
    k_a = x' . d_a        curvature
    t_ab = g_a . d_b      torsion (a != b), gradient of the section's stretch (a = b)
    e = E0_33 + 1/2 sum_a I_a / A (beta_t |d_a|^2 + (beta - beta_t) k_a^2 / l^2)    mean strain of the fibres

with l = |x'|, I_a the integral of xi_a^2 over the section, I_ab = I_b for a = b and I_b J / (I_1 + I_2) else, so that J
is the torsion constant. d_a is how a rate of the section differs from one that moves with F: a fibre of the reference
state, curved or twisted, has the stretch vector x' + xi_a d_a / j, j being its length there over that of the axis. Its
Green-Lagrange strain E0_33 + xi_a k_a / j + 1/2 |xi_a d_a / j|^2, averaged over the section, is e: twist stretches
fibres (Wagner's term), and so does bending. Left out is what their energy has of fourth order in xi.

beta is paper 1's reduction of the stiffness of bending ("bundle factor", about one over the number of filaments),
beta_t the same for torsion; filaments that slide are each bent and twisted about axes of their own. T0 is the tension
of the reference state, whose sections and curvature may be free of stress all the same.

The law of the fibres is Saint-Venant's and Kirchhoff's as above, or linear in their stretch. The latter has in place of
e and k_a

    l - 1 + 1/2 beta_t sum_a I_a / A (|d_a|^2 - k_a^2 / l^2) / l,    k_a / l.
"""

from typing import Any, Literal, NamedTuple

import ufl

from .curve import LIKE_NODES, Nodes, Part, arc_derivative, at_nodes, change_of_slope, gauss
from .materials import (
    Strain,
    TransverselyIsotropic,
    axial_energy,
    section_energy,
    shear_energy,
)

AxialLaw = Literal["Saint-Venant-Kirchhoff", "linear"]
# Square of the stretch below which the linear law goes on along its tangent: no rod is squeezed to half of its length,
# but a long step of Newton's method may predict it.
SQUEEZED = 0.25


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
    rates: tuple[Any, Any]  # g1', g2', or what `relative` leaves of them, shape (3,), 1/mm
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


def _gradient(frame: Frame) -> Any:
    """F = [g1 g2 x'], shape (3, 3)."""
    vectors = (*frame.directors, frame.slope)
    return ufl.as_matrix([[vector[i] for vector in vectors] for i in range(3)])


def relative(frame: Frame, rest: Frame, section: "Section") -> Frame:
    """A frame whose rates d_a are those beyond the free ones of the reference state, which move with the frame."""
    moved = section.natural_curvature * ufl.dot(_gradient(frame), ufl.inv(_gradient(rest)))
    pairs = zip(frame.rates, rest.rates)
    return frame._replace(rates=tuple(rate - ufl.dot(moved, placed) for rate, placed in pairs))


class Products(NamedTuple):
    """Scalar products of a frame's vectors: strains are differences of them."""

    directors: Any  # g_a . g_b, shape (2, 2), -
    stretch: Any  # x' . x', -
    shear: Any  # g_a . x', shape (2,), -
    bending: Any  # x' . d_a, shape (2,), 1/mm
    torsion: Any  # g_a . d_b, shape (2, 2), 1/mm
    spread: Any  # d_a . d_a, shape (2,), 1/mm^2
    bow: Any  # of the change of slope with itself, -

    def less(self, other: "Products") -> "Products":
        """Differences from those of another frame."""
        return Products(*(mine - its for mine, its in zip(self, other)))


def products(frame: Frame) -> Products:
    """Scalar products of a frame's vectors, whose rates are relative ones."""

    def matrix(others: tuple[Any, Any]) -> Any:
        return ufl.as_matrix([[ufl.dot(g, other) for other in others] for g in frame.directors])

    return Products(
        directors=matrix(frame.directors),
        stretch=ufl.dot(frame.slope, frame.slope),
        shear=ufl.as_vector([ufl.dot(g, frame.slope) for g in frame.directors]),
        bending=ufl.as_vector([ufl.dot(frame.slope, rate) for rate in frame.rates]),
        torsion=matrix(frame.rates),
        spread=ufl.as_vector([ufl.dot(rate, rate) for rate in frame.rates]),
        bow=ufl.dot(frame.change, frame.change),
    )


def _square_of_stretch(products: Products) -> Any:
    return ufl.max_value(products.stretch, SQUEEZED)


def _spread(products: Products, section: Section, bent: Any) -> Any:
    """Half the mean square of xi_a d_a / A over the section: of twist, and `bent` times that of bending."""
    total = 0.0
    for a, inertia in enumerate((section.inertia_1, section.inertia_2)):
        along = products.bending[a] ** 2 / _square_of_stretch(products)
        total += inertia * (section.torsion_factor * (products.spread[a] - along) + bent * along)
    return 0.5 * total / section.area


def mean_strain(now: Products, rest: Products, section: Section) -> Strain:
    """Green-Lagrange strain E0 on the axis, e33 being the mean of the fibres."""
    change = now.less(rest)
    bent = section.bundle_factor
    return Strain(
        e11=0.5 * change.directors[0, 0],
        e22=0.5 * change.directors[1, 1],
        e12=0.5 * change.directors[0, 1],
        e33=0.5 * change.stretch + _spread(now, section, bent) - _spread(rest, section, bent),
        e13=0.5 * change.shear[0],
        e23=0.5 * change.shear[1],
    )


def smooth_strain(now: Products, rest: Products, section: Section, nodes: Nodes) -> Strain:
    """Strain at nodes, where E0_33 is that of the line through its values at the Gauss points.

    In a bent element of degree 2 the axial strain itself is a parabola that vanishes at the Gauss points only. Sections
    that were to contract by it would narrow and widen from node to node, which locks the bending of thin rods.
    """
    strain = mean_strain(now, rest, section)
    return strain._replace(e33=strain.e33 - 0.5 * nodes.beyond_gauss * (now.bow - rest.bow))


class Fibres(NamedTuple):
    """What the axial law is linear in."""

    mean: Any  # mean strain, -
    bending: Any  # shape (2,), 1/mm


def _linear(products: Products, section: Section) -> Fibres:
    """Mean stretch of the fibres, which bending leaves as it is, and its gradients across."""
    stretch = ufl.sqrt(_square_of_stretch(products))
    beyond = ufl.min_value(products.stretch - SQUEEZED, 0.0) / (2.0 * SQUEEZED**0.5)
    mean = stretch + beyond + _spread(products, section, 0.0) / stretch
    return Fibres(mean, products.bending / stretch)


def fibres(now: Products, rest: Products, section: Section, axial_law: AxialLaw) -> Fibres:
    """Strains of the fibres by a law."""
    if axial_law == "linear":
        moved, placed = _linear(now, section), _linear(rest, section)
        return moved._replace(mean=moved.mean - placed.mean)
    return Fibres(mean_strain(now, rest, section).e33, now.bending)


def fibre_energy(fibre: Fibres, section: Section, law: TransverselyIsotropic) -> Any:
    """Energy of the fibres per reference length, N: of their mean strain, of the tension at rest and of bending."""
    stretching = section.area * axial_energy(fibre.mean, law) + section.tension * fibre.mean
    inertias = (section.inertia_1, section.inertia_2)
    density = sum(inertia * fibre.bending[a] ** 2 for a, inertia in enumerate(inertias))
    return stretching + 0.5 * section.bundle_factor * law.axial_modulus * density


def torsion_energy(now: Products, section: Section, law: TransverselyIsotropic) -> Any:
    """Energy of torsion and of the gradient of the section's stretch per reference length, N."""
    inertias = (section.inertia_1, section.inertia_2)
    warping = section.torsion_constant / (section.inertia_1 + section.inertia_2)
    density = 0.0
    for a in range(2):
        for b in range(2):
            weight = inertias[b] if a == b else warping * inertias[b]
            density += weight * now.torsion[a, b] ** 2
    return 0.5 * section.torsion_factor * law.axial_shear_modulus * density


def energy(
    now: Products,
    rest: Products,
    section: Section,
    law: TransverselyIsotropic,
    degree: int,
    axial_law: AxialLaw = "Saint-Venant-Kirchhoff",
) -> list[Part]:
    """Stored energy, with selective quadrature.

    One Gauss point per element of degree 1 (two of degree 2) avoids shear and membrane locking but
    does not see sections that stretch in a zigzag from node to node (hourglass). The strain of the
    section is therefore integrated at the nodes, where the directors are unknowns of their own:
    every section resists its stretch, and none is strained only because directors that are turned
    against each other get shorter between the nodes, which would lock the bending of thin rods.

    Args:
        now, rest: Products of the current and the reference frame, both made `relative`. Without those of the last step
            of Newton's method, `now` has the stresses that this step foresaw (Products.less, bodies.beam).
        section, law: Constants of the section and of the yarn.
        degree: Degree of the line elements, 1 or 2.
        axial_law: Of the fibres.
    """
    axis = fibre_energy(fibres(now, rest, section, axial_law), section, law)
    shear = section.shear_area * shear_energy(mean_strain(now, rest, section), law)
    turning = torsion_energy(now, section, law)
    stretch = [
        at_nodes(
            section.area * section_energy(smooth_strain(now, rest, section, nodes), law), nodes
        )
        for nodes in LIKE_NODES[degree]
    ]
    return [gauss(axis + shear + turning, num_points=degree), *stretch]


def axial_force(
    now: Frame,
    rest: Frame,
    section: Section,
    law: TransverselyIsotropic,
    axial_law: AxialLaw = "Saint-Venant-Kirchhoff",
) -> Any:
    """Force along the current axis, N, positive when pulled: projection of d energy / d x'.

    `now` and `rest` have their whole rates; the other arguments as in `energy`.
    """
    slope = ufl.variable(now.slope)
    moved = products(relative(now._replace(slope=slope), rest, section))
    placed = products(relative(rest, rest, section))
    strain = mean_strain(moved, placed, section)
    density = fibre_energy(fibres(moved, placed, section, axial_law), section, law)
    density += section.area * section_energy(strain, law)
    density += section.shear_area * shear_energy(strain, law) + torsion_energy(moved, section, law)
    return ufl.dot(ufl.diff(density, slope), slope) / ufl.sqrt(ufl.dot(slope, slope))
