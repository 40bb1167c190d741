"""A straight beam of four elements, built from the forms directly."""

from typing import Any, NamedTuple

import numpy as np
import ufl
from dolfinx import fem
from mpi4py import MPI

from braidx.bodies.assembly import compile_form
from braidx.bodies.layout import CurveLayout, FloatArray
from braidx.bodies.mesh import create_curve_mesh
from braidx.forms import beam
from braidx.forms.curve import Part, integral, unit_tangent
from braidx.forms.materials import TransverselyIsotropic

LAW = TransverselyIsotropic(10.0, 3.0, 2.0, 0.2, 0.3)
SECTION = beam.Section(2.0, 1.5, 0.3, 0.4, 0.5, 1e-4, 1e-4, 1.0, 0.1)


class BeamLine(NamedTuple):
    """The state and the energy of the beam."""

    state: fem.Function
    parts: list[Part]

    def form(self, parts: list[Part]) -> Any:
        domain = self.state.function_space.mesh.ufl_domain()
        return sum(integral(part, domain) for part in parts)

    def tangent(self, parts: list[Part]) -> FloatArray:
        """Matrix of all `parts` compiled into one form, shape (45, 45)."""
        space = self.state.function_space
        test, trial = ufl.TestFunction(space), ufl.TrialFunction(space)
        gradient = ufl.derivative(self.form(parts), self.state, test)
        hessian = compile_form(ufl.derivative(gradient, self.state, trial))
        return np.asarray(fem.assemble_matrix(hessian).to_dense())


def beam_line(degree: int = 1) -> BeamLine:
    """Beam along x at rest, directors along y and z, all lengths of order one."""
    layout = CurveLayout.from_node_counts([5], degree)
    points = np.linspace([0.0, 0.0, 0.0], [4.0, 0.0, 0.0], 5)
    mesh = create_curve_mesh(MPI.COMM_SELF, layout, points)
    space = mesh.blocked_space(9)
    state, rest = fem.Function(space), fem.Function(space)
    directors = np.tile([0.0, 1.0, 0.0, 0.0, 0.0, 1.0], (5, 1))
    rest.x.array[:] = np.hstack([points, directors])[mesh.space_nodes(space)].ravel()
    state.x.array[:] = rest.x.array
    tangent = unit_tangent(mesh.mesh.ufl_domain())
    placed = beam.rest_frame(rest, tangent)
    frames = (beam.current_frame(state, tangent), placed)
    now, was = (beam.products(beam.relative(frame, placed, SECTION)) for frame in frames)
    parts = beam.energy(now, was, SECTION, LAW, degree)
    return BeamLine(state, parts)
