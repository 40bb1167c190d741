"""A bar that is half beam, half solid, with loads at its ends: the exact states pass through the joint.

Square section of one hexahedron of degree 2 with nu = 0, where beam and solid are exact in constant strain, bending and
torsion; a round section with nu = 0.3 in constant strain, where the joint's section contracts freely with the bar.
"""

import numpy as np
import pytest
import scipy.sparse as sp
import scipy.sparse.linalg as spl
from mpi4py import MPI

from braidx.bodies import BeamBody, SolidBody, YarnMaterial
from braidx.bodies.coupling import follow_section
from braidx.meshing import rectangle, round_section, sweep
from braidx.meshing.reference import QUADS
from braidx.system.constraints import Constraints
from braidx.system.terms import BodyTerm

HALF = 2.0  # mm, length of the beam and of the solid
DIRECTORS = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
SIZE = 1e-3  # strain, curvature (1/mm) and twist (1/mm): any, as the bar is linearised


class Bar:
    """Beam from z = -HALF to 0, solid from 0 to HALF; unknowns of the beam come first."""

    def __init__(self, section, poisson, beam_degree):
        self.material = YarnMaterial.isotropic(100.0, poisson)
        lines = [self._line(-HALF, 0.0, 2 * beam_degree), self._line(0.0, HALF, 2 * section.degree)]
        self.section, self.mesh = section, sweep(lines[1], section, self._directors(lines[1]))
        self.beam = BeamBody(
            MPI.COMM_SELF,
            lines[:1],
            section=section.beam_section(),
            material=self.material,
            directors=[self._directors(lines[0])],
            degree=beam_degree,
        )
        self.solid = SolidBody(MPI.COMM_SELF, self.mesh, material=self.material)
        self.first = self.beam.num_unknowns
        self.rest = np.concatenate([self.beam.rest.ravel(), self.solid.rest.ravel()])

    @staticmethod
    def _line(start, end, num_steps):
        z = np.linspace(start, end, num_steps + 1)
        return np.stack([0.0 * z, 0.0 * z, z], axis=1)

    @staticmethod
    def _directors(line):
        return np.broadcast_to(DIRECTORS, (len(line), 2, 3))

    def state(self, displacement, gradient):
        """Change of all unknowns in a field u(x), whose gradient moves the directors."""
        z = self.beam.rest[:, :3]
        turned = np.einsum("nij,aj->nai", gradient(z), DIRECTORS).reshape(-1, 6)
        beam = np.hstack([displacement(z), turned])
        return np.concatenate([beam.ravel(), displacement(self.mesh.points).ravel()])

    def loads(self, traction):
        """Forces on the nodes of the solid's end under a traction, a function of x (n, 3)."""
        abscissae, weights = np.polynomial.legendre.leggauss(4)
        at = np.stack(np.meshgrid(abscissae, abscissae), axis=-1).reshape(-1, 2) / 2.0 + 0.5
        quad = QUADS[self.mesh.degree]
        shape, nodes = quad.shape(at), self.mesh.facet_nodes("end")
        corners = self.mesh.points[nodes]
        du, dv = np.einsum("pdn,fni->dfpi", quad.gradient(at), corners)
        area = np.linalg.norm(np.cross(du, dv), axis=2) * np.outer(weights, weights).ravel() / 4
        forces = np.zeros_like(self.mesh.points)
        x = np.einsum("pn,fni->fpi", shape, corners)
        density = traction(x.reshape(-1, 3)).reshape(x.shape) * area[..., None]
        np.add.at(forces, nodes, np.einsum("fpi,pn->fni", density, shape))
        return np.concatenate([np.zeros(self.first), forces.ravel()])

    def solve(self, exact, loads):
        """Linear response to the loads with the start held as in `exact`, and the forces on all unknowns."""
        n = len(self.rest)
        tangent = sp.csr_matrix((n, n))
        for body, first in ((self.beam, 0), (self.solid, self.first)):
            term = BodyTerm(body, first)
            term.set_state(self.rest)
            tangent += sp.csr_matrix((term.tangent_values(), term.tangent_pattern()), shape=(n, n))
        constraints, values = Constraints(n), np.zeros(n)
        constraints.hold(np.arange(9))
        values[:9] = exact[:9]
        face = self.first + 3 * self.mesh.sweeps[0].layers[0][:, None] + np.arange(3)
        joint = 9 * (self.beam.num_nodes - 1)
        follow_section(constraints, values, face, self.section.points, joint)
        mapped = constraints.resolve()
        held = mapped.closure @ values
        reduced = mapped.transform.T @ tangent @ mapped.transform
        free = spl.spsolve(reduced.tocsc(), mapped.reduce(loads - tangent @ held))
        result = mapped.expand(free, values)
        return result, tangent @ result


def constant_strain(material):
    contraction = np.diag([-material.axial_poisson, -material.axial_poisson, 1.0]) * SIZE
    stress = [0.0, 0.0, material.axial_modulus * SIZE]
    return (
        lambda x: x @ contraction,
        lambda x: np.broadcast_to(contraction, (len(x), 3, 3)),
        lambda x: np.broadcast_to(stress, x.shape),
    )


def field_gradient(rows):
    """Gradient of a field from its rows, each with three functions of x."""
    return lambda x: np.stack([np.stack([c + 0.0 * x[:, 0] for c in r], 1) for r in rows(x)], 1)


def bending(material):
    return (
        lambda x: SIZE * np.stack([-0.5 * x[:, 2] ** 2, 0.0 * x[:, 0], x[:, 0] * x[:, 2]], 1),
        field_gradient(
            lambda x: [
                [0.0, 0.0, -SIZE * x[:, 2]],
                [0.0] * 3,
                [SIZE * x[:, 2], 0.0, SIZE * x[:, 0]],
            ]
        ),
        lambda x: material.axial_modulus * SIZE * np.stack([0 * x[:, 0], 0 * x[:, 0], x[:, 0]], 1),
    )


def torsion(material):
    return (
        lambda x: SIZE * np.stack([-x[:, 1] * x[:, 2], x[:, 0] * x[:, 2], 0.0 * x[:, 0]], 1),
        field_gradient(
            lambda x: [
                [0.0, -SIZE * x[:, 2], -SIZE * x[:, 1]],
                [SIZE * x[:, 2], 0.0, SIZE * x[:, 0]],
                [0.0] * 3,
            ]
        ),
        lambda x: material.axial_shear_modulus
        * SIZE
        * np.stack([-x[:, 1], x[:, 0], 0.0 * x[:, 0]], 1),
    )


def check(bar, field):
    displacement, gradient, traction = field(bar.material)
    exact, loads = bar.state(displacement, gradient), bar.loads(traction)
    result, forces = bar.solve(exact, loads)
    assert np.abs(result - exact).max() < 1e-10 * np.abs(exact).max()
    # The start gives back force and moment of the end.
    force, moments = forces[:3], forces[3:9].reshape(2, 3)
    nodal = loads[bar.first :].reshape(-1, 3)
    turned = np.cross(bar.mesh.points + [0.0, 0.0, HALF], nodal).sum(axis=0)
    scale = np.abs(nodal).sum()
    assert np.abs(force + nodal.sum(axis=0)).max() < 1e-10 * scale
    assert np.abs(np.cross(DIRECTORS, moments).sum(axis=0) + turned).max() < 1e-10 * scale


@pytest.mark.parametrize("beam_degree", [1, 2])
@pytest.mark.parametrize("field", [constant_strain, bending, torsion])
def test_square_bar(field, beam_degree):
    check(Bar(rectangle(1.0, 1.0, degree=2), 0.0, beam_degree), field)


@pytest.mark.parametrize("degree", [1, 2])
def test_round_bar_contracts_freely(degree):
    check(Bar(round_section(0.5, 12, degree=degree), 0.3, 1), constant_strain)
