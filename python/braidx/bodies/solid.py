"""Yarns and cores as solids: three unknowns per node, the current position."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import astuple
from functools import cached_property
from typing import Any, Literal

import numpy as np
import numpy.typing as npt
import ufl
from dolfinx import fem
from mpi4py import MPI

from ..forms import hyperelastic, solid
from ..forms.curve import Part, integral
from ..forms.materials import TransverselyIsotropic
from ..forms.variation import variations
from ..meshing.solid_mesh import SolidMesh
from .assembled import AssembledBody
from .assembly import Assembler, compile_form
from .layout import FloatArray, IntArray
from .mesh import ElementField
from .yarn_material import YarnMaterial
from .solid_domain import create_solid_domain

Law = Literal["transversely isotropic", "Saint-Venant-Kirchhoff", "neo-Hooke"]
LAWS: tuple[str, ...] = ("transversely isotropic", "Saint-Venant-Kirchhoff", "neo-Hooke")


class SolidBody(AssembledBody):
    """Hexahedra or tetrahedra that resist every deformation (forms.solid, forms.hyperelastic).

    All arrays are in the numbering of `mesh`: nodes by three components, cells.

    Args:
        comm: Communicator; chunks of cells are dealt out to its ranks.
        mesh: Reference configuration.
        material: One for all parts or one per part. The isotropic laws take its axial modulus and axial Poisson ratio.
        law: Law of all parts; "transversely isotropic" with isotropic constants is Saint-Venant and Kirchhoff's.
        fibre_stress: Second Piola-Kirchhoff stress along the fibre at rest, MPa, positive when pulled; one value, one
            per part or one per cell. A yarn under tension T has T over its area.
    Raises:
        ValueError: If the law is unknown, not that of the material, or a shape is wrong.
    """

    block = 3

    def __init__(
        self,
        comm: MPI.Comm,
        mesh: SolidMesh,
        *,
        material: YarnMaterial | Sequence[YarnMaterial],
        law: Law = "transversely isotropic",
        fibre_stress: npt.ArrayLike = 0.0,
    ) -> None:
        if law not in LAWS:
            raise ValueError(f'law is "{law}": give one of {", ".join(LAWS)}')
        self.comm, self.mesh, self.law = comm, mesh, law
        self.rest = mesh.points
        materials = _per_part(material, mesh.num_parts)
        if law != "transversely isotropic":
            _check_isotropic(materials, law)
        self._domain = create_solid_domain(comm, mesh)
        self._space = self._domain.position_space()
        self._nodes = self._domain.space_nodes(self._space)
        self._state = fem.Function(self._space)
        self._material = ElementField(self._domain, len(TransverselyIsotropic._fields))
        self._material.set(np.array([astuple(one) for one in materials])[mesh.cell_part])
        self._fibre = ElementField(self._domain, 3)
        self._fibre.set(mesh.fibre)
        self._prestress = ElementField(self._domain)
        self.set_fibre_stress(fibre_stress)
        self.set_state(self.rest)
        gradient, foreseen = ufl.grad(self._state), None
        if law != "neo-Hooke":
            self._step = fem.Function(self._space)
            foreseen = self._parts(self._split(gradient, ufl.grad(self._step)))
        forms = variations(self._parts(self._split(gradient)), self._state, foreseen)
        self._assembler = Assembler(forms, self._space, self._nodes, self.num_nodes)

    def _parts(self, split: hyperelastic.Split) -> list[Part]:
        return solid.energy(split, self.mesh.cell.name, self.mesh.degree, self.mesh.is_swept)

    def _split(self, gradient: Any, step: Any = None) -> hyperelastic.Split:
        """Energy of a deformation gradient; of laws quadratic in E as that of the last step foresaw it."""
        law = TransverselyIsotropic(*(self._material.function[i] for i in range(5)))
        isotropic = hyperelastic.Isotropic(law.axial_modulus, law.axial_poisson)
        if self.law == "neo-Hooke":
            return hyperelastic.neo_hooke(gradient, isotropic)
        strain = hyperelastic.green_lagrange(gradient, step)
        if self.law == "Saint-Venant-Kirchhoff":
            return hyperelastic.saint_venant_kirchhoff(strain, isotropic)
        fibre, stress = self._fibre.function, self._prestress.function
        return hyperelastic.transversely_isotropic(strain, fibre, law, stress)

    @property
    def num_nodes(self) -> int:
        return self.mesh.num_nodes

    @property
    def num_elements(self) -> int:
        """Number of cells."""
        return self.mesh.num_cells

    def set_fibre_stress(self, fibre_stress: npt.ArrayLike) -> None:
        """Change the fibre's stress at rest, as in the constructor, without a new compilation."""
        values = np.asarray(fibre_stress, dtype=np.float64)
        if values.shape == (self.mesh.num_parts,):
            values = values[self.mesh.cell_part]
        if values.shape not in ((), (self.num_elements,)) or not np.all(np.isfinite(values)):
            raise ValueError(
                f"fibre_stress has shape {values.shape}: give one finite value, one per part "
                f"({self.mesh.num_parts},) or one per cell ({self.num_elements},)"
            )
        if self.law != "transversely isotropic" and np.any(values):
            raise ValueError(f'fibre_stress needs a fibre: law "{self.law}" has none')
        self._prestress.set(np.broadcast_to(values, self.num_elements))

    def cells_of(self, part: int) -> IntArray:
        """Cells of a part, shape (n,); see SolidMesh."""
        return self.mesh.cells_of(part)

    def facet_nodes(self, tag: str, part: int | None = None) -> IntArray:
        """Nodes of the facets of a surface, shape (num_facets, 4, 9, 3 or 6), turned outward; see SolidMesh."""
        return self.mesh.facet_nodes(tag, part)

    def von_mises(self, q: FloatArray) -> FloatArray:
        """Mean equivalent stress of each cell in state `q`, MPa, shape (num_cells,), the same on each rank.

        Leaves the body in state `q`, as all measures do.
        """
        return self._mean(q, "von_mises")

    def fibre_stress(self, q: FloatArray) -> FloatArray:
        """Mean Cauchy stress along the current fibre, MPa, positive when pulled, shape (num_cells,)."""
        return self._mean(q, "fibre_stress")

    def energy_density(self, q: FloatArray) -> FloatArray:
        """Mean stored energy per reference volume, MPa, shape (num_cells,)."""
        return self._mean(q, "energy")

    def volumes(self) -> FloatArray:
        """Reference volume of each cell, mm^3, shape (num_cells,)."""
        return self._integrals()["volume"]

    def mean_axial_force(self, q: FloatArray, part: int = 0) -> FloatArray:
        """Axial force of a swept part, N, positive when pulled: mean over each of its elements, shape (num_elements,).

        Mean of the nominal stress along the fibre over the volume between two layers, times the section's area.

        Raises:
            ValueError: If the part was not swept.
        """
        sweep = self.mesh.sweeps.get(part)
        if sweep is None:
            swept = ", ".join(map(str, self.mesh.sweeps)) or "none"
            raise ValueError(f"part {part} has no centre line: swept parts are {swept}")
        self.set_state(q)
        totals = self._integrals()
        force, volume = (
            totals[name][sweep.cells].sum(axis=1) for name in ("axial_force", "volume")
        )
        return np.asarray(force / volume * sweep.area)

    def _mean(self, q: FloatArray, name: str) -> FloatArray:
        """Mean of a measure over each cell."""
        self.set_state(q)
        totals = self._integrals()
        return totals[name] / totals["volume"]

    def _integrals(self) -> dict[str, FloatArray]:
        """Integral of every measure over each cell in the current state, shape (num_cells,) each."""
        field, form = self._measures
        local = np.zeros_like(field.function.x.array)
        fem.assemble_vector(local, form)
        gathered = field.gather(local, self.num_elements)
        return dict(zip(solid.Measures._fields, gathered.T))

    @cached_property
    def _measures(self) -> tuple[ElementField, fem.Form]:
        """Form of the integrals of all measures; compiled when first asked for."""
        field = ElementField(self._domain, len(solid.Measures._fields))
        gradient = ufl.variable(ufl.grad(self._state))
        values = solid.measures(gradient, self._split(gradient), self._fibre.function)
        test = ufl.TestFunction(field.function.function_space)
        density = ufl.dot(ufl.as_vector(list(values)), test)
        part = solid.best_points(density, self.mesh.cell.name, self.mesh.degree)
        return field, compile_form(integral(part, self._domain.mesh.ufl_domain()))


def _per_part(
    given: YarnMaterial | Sequence[YarnMaterial], num_parts: int
) -> Sequence[YarnMaterial]:
    if isinstance(given, YarnMaterial):
        return [given] * num_parts
    if len(given) != num_parts:
        raise ValueError(
            f"material has {len(given)} items: give one, or one per part ({num_parts})"
        )
    return given


def _check_isotropic(materials: Sequence[YarnMaterial], law: str) -> None:
    for part, one in enumerate(materials):
        like = astuple(YarnMaterial.isotropic(one.axial_modulus, one.axial_poisson))
        if not np.allclose(astuple(one), like, rtol=1e-9, atol=0.0):
            raise ValueError(
                f'material of part {part} is not isotropic, law "{law}" is: '
                "use YarnMaterial.isotropic or the transversely isotropic law"
            )
