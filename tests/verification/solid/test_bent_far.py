"""A slender bar of solids bent to a quarter of a circle: moment and shape are those of the elastica, M = E I kappa.

Stress along the fibre stays below the shear modulus, beyond which compressed fibres kink.
"""

import numpy as np
import pytest
import scipy.sparse as sp
import scipy.sparse.linalg as spl
from mpi4py import MPI

from braidx.bodies import SolidBody, YarnMaterial
from braidx.meshing import rectangle, round_section, sweep
from braidx.system.constraints import Constraints

LENGTH = 20.0
YARN = YarnMaterial(1000.0, 50.0, 20.0, 0.3, 0.3)


def bar(section, num_elements):
    z = np.linspace(0.0, LENGTH, num_elements * section.degree + 1)
    directors = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    line = np.stack([0.0 * z, 0.0 * z, z], axis=1)
    return sweep(line, section, np.broadcast_to(directors, (len(z), 2, 3)))


def rolled(points, curvature):
    """Points of the bar bent to a circle in the plane (x, z)."""
    angle, rest = curvature * points[:, 2], 1.0 / curvature - points[:, 0]
    x = 1.0 / curvature - rest * np.cos(angle)
    return np.stack([x, points[:, 1], rest * np.sin(angle)], axis=1)


def turned_end(body, curvature):
    """Equilibrium with the start held and the end turned about y as in a circle, free to move as a rigid plane.

    Returns:
        Positions, and the moment about y at the start, N mm.
    """
    first, *_, last = body.mesh.sweeps[0].layers
    unknowns = 3 * last[:, None] + np.arange(3)
    constraints = Constraints(body.num_unknowns)
    constraints.hold((3 * first[:, None] + np.arange(3)).ravel())
    constraints.tie(unknowns[1:].ravel(), np.tile(unknowns[0], len(last) - 1))
    mapped = constraints.resolve()
    q = rolled(body.rest, curvature)
    values, free = np.zeros(body.num_unknowns), q.ravel()[mapped.free]
    values.reshape(-1, 3)[first] = body.rest[first]
    values.reshape(-1, 3)[last[1:]] = q[last[1:]] - q[last[0]]
    for _ in range(20):
        q = mapped.expand(free, values).reshape(-1, 3)
        body.set_state(q)
        residual = mapped.reduce(body.residual())
        entries = (body.tangent_values(), body.tangent_pattern())
        tangent = sp.csr_matrix(entries, shape=(body.num_unknowns,) * 2)
        reduced = mapped.transform.T @ tangent @ mapped.transform
        change = spl.spsolve(reduced.tocsc(), residual)
        free = free - change
        if np.abs(change).max() < 1e-8 * LENGTH:
            forces = body.residual().reshape(-1, 3)[first]
            return q, -float(np.cross(body.rest[first], forces).sum(axis=0)[1])
    raise AssertionError(f"no equilibrium: the last change was {np.abs(change).max()} mm")


@pytest.mark.parametrize(
    "section",
    [rectangle(0.4, 0.4), round_section(0.2, 8), rectangle(0.4, 0.4, degree=2)],
    ids=["one cell", "o-grid", "degree 2"],
)
def test_quarter_of_a_circle(section):
    body = SolidBody(MPI.COMM_SELF, bar(section, 16 // section.degree), material=YARN)
    curvature = 0.5 * np.pi / LENGTH
    q, moment = turned_end(body, curvature)
    _, inertia, _ = section.moments()
    assert moment == pytest.approx(YARN.axial_modulus * inertia * curvature, rel=0.02)
    swept = body.mesh.sweeps[0]
    centres = np.einsum("j,lji->li", swept.weights / swept.area, q[swept.layers])
    angle = np.linspace(0.0, 0.5 * np.pi, len(centres))
    circle = np.stack([1.0 - np.cos(angle), 0.0 * angle, np.sin(angle)], axis=1) / curvature
    assert np.abs(centres - circle).max() < 0.005 * LENGTH
    outermost = YARN.axial_modulus * swept.area * curvature * swept.section.max()
    assert np.abs(body.mean_axial_force(q)).max() < 0.02 * outermost
