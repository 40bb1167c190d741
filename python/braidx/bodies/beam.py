"""Yarns as beams with deformable sections: nine unknowns per node, position and two directors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import astuple
from typing import Literal, TypeVar

import numpy as np
import numpy.typing as npt
from dolfinx import fem
from mpi4py import MPI

from ..forms import beam
from ..forms.materials import TransverselyIsotropic
from ..geometry.frames import check_right_handed, rotation_minimising_frames
from ..geometry.lines import stack_lines
from ..meshing.beam_section import BeamSection
from .body import CurveBody
from .layout import FloatArray
from .mesh import ElementField
from .yarn_material import YarnMaterial

NaturalState = Literal["as placed", "straight"]
PerCurve = TypeVar("PerCurve", BeamSection, YarnMaterial)


class BeamBody(CurveBody):
    """Curves that resist stretching, shear, bending, torsion and deformation of their sections
    (forms.beam).

    Args:
        comm: Communicator.
        centre_lines: Reference configuration, shape (num_nodes_i, 3) each, mm.
        section: Section, one for all or one per curve.
        material: Material, one for all or one per curve.
        directors: Reference directors g1, g2, shape (num_nodes_i, 2, 3) each; rotation minimising
            by default.
        degree: Degree of the line elements, 1 or 2.
        bundle_factor: Factor on the bending stiffness; one value, one per curve or one per element.
        torsion_factor: Factor on the torsion stiffness, likewise; the bundle factor by default.
        natural_state: "as placed": the reference is free of stress; "straight": the yarn would be
            straight and untwisted if it were set free.
        tension: Axial force in the reference state, N; one value, one per curve or one per element.
        axial_law: Of the force along fibres: linear in their Green-Lagrange strain ("Saint-Venant-Kirchhoff"), or in
            their stretch ("linear").
    """

    def __init__(
        self,
        comm: MPI.Comm,
        centre_lines: Sequence[FloatArray],
        *,
        section: BeamSection | Sequence[BeamSection],
        material: YarnMaterial | Sequence[YarnMaterial],
        directors: Sequence[FloatArray] | None = None,
        degree: int = 1,
        bundle_factor: npt.ArrayLike = 1.0,
        torsion_factor: npt.ArrayLike | None = None,
        natural_state: NaturalState = "as placed",
        tension: npt.ArrayLike = 0.0,
        axial_law: beam.AxialLaw = "Saint-Venant-Kirchhoff",
    ) -> None:
        positions = stack_lines(centre_lines)
        if directors is None:
            directors = rotation_minimising_frames(centre_lines)
        for i, (line, pairs) in enumerate(zip(centre_lines, directors, strict=True)):
            check_right_handed(line, np.asarray(pairs), f"directors of curve {i}")
        rest = np.hstack([positions, np.concatenate(list(directors)).reshape(-1, 6)])
        sections = _per_curve(section, len(centre_lines), "section")
        super().__init__(comm, centre_lines, rest, degree, [s.area for s in sections])
        self._rest_state = fem.Function(self._space)
        self._write_rest(rest)
        self._section = ElementField(self._curve_mesh, len(beam.Section._fields))
        self._material = ElementField(self._curve_mesh, len(TransverselyIsotropic._fields))
        self._section_values = np.zeros((self.num_elements, len(beam.Section._fields)))
        self.set_properties(
            section=section,
            material=material,
            bundle_factor=bundle_factor,
            torsion_factor=bundle_factor if torsion_factor is None else torsion_factor,
            natural_state=natural_state,
            tension=tension,
        )
        self._step = fem.Function(self._space)
        now = beam.current_frame(self._state, self._tangent)
        placed = beam.rest_frame(self._rest_state, self._tangent)
        step = beam.current_frame(self._step, self._tangent)
        constants = beam.Section(*_components(self._section))
        law = TransverselyIsotropic(*_components(self._material))
        is_at, was_at, moved = (
            beam.products(beam.relative(frame, placed, constants)) for frame in (now, placed, step)
        )
        self._set_energy(
            beam.energy(is_at, was_at, constants, law, degree, axial_law),
            beam.axial_force(now, placed, constants, law, axial_law),
            beam.energy(is_at.less(moved), was_at, constants, law, degree, axial_law),
        )

    def set_properties(
        self,
        *,
        section: BeamSection | Sequence[BeamSection] | None = None,
        material: YarnMaterial | Sequence[YarnMaterial] | None = None,
        bundle_factor: npt.ArrayLike | None = None,
        torsion_factor: npt.ArrayLike | None = None,
        natural_state: NaturalState | None = None,
        tension: npt.ArrayLike | None = None,
    ) -> None:
        """Change properties, as in the constructor, without a new compilation; what is None stays.

        Raises:
            ValueError: If a factor is not positive, the natural state unknown or a shape wrong.
        """
        values = self._section_values
        column = {name: i for i, name in enumerate(beam.Section._fields)}
        if section is not None:
            for curve, one in enumerate(_per_curve(section, self.layout.num_curves, "section")):
                first, end = self.layout.curve_elements[[curve, curve + 1]]
                for name in one.__dataclass_fields__:
                    values[first:end, column[name]] = getattr(one, name)
            self._area = values[:, column["area"]].copy()
        for name, factor in (("bundle_factor", bundle_factor), ("torsion_factor", torsion_factor)):
            if factor is not None:
                values[:, column[name]] = self.layout.per_element(factor, name)
                if np.any(values[:, column[name]] <= 0.0):
                    raise ValueError(f"{name} is {np.min(factor)}: it must be positive")
        if natural_state is not None:
            if natural_state not in ("as placed", "straight"):
                raise ValueError(
                    f'natural_state is "{natural_state}": give "as placed" or "straight"'
                )
            values[:, column["natural_curvature"]] = float(natural_state == "as placed")
        if tension is not None:
            values[:, column["tension"]] = self.layout.per_element(tension, "tension")
        self._section.set(values)
        if material is not None:
            laws = _per_curve(material, self.layout.num_curves, "material")
            constants = np.array([astuple(law) for law in laws])
            self._material.set(np.repeat(constants, np.diff(self.layout.curve_elements), axis=0))

    def set_reference(self, q: FloatArray) -> None:
        """Make state `q`, shape (num_nodes, 9), the reference.

        It is free of stress if the natural state is "as placed".
        """
        self._curve_mesh.move(q[:, :3])
        self.rest = np.array(q, dtype=np.float64)
        self._write_rest(self.rest)

    def _write_rest(self, rest: FloatArray) -> None:
        self._rest_state.x.array[:] = rest[self._nodes].ravel()


def _components(field: ElementField) -> list[fem.Function]:
    return [field.function[i] for i in range(field.function.ufl_shape[0])]


def _per_curve(
    given: PerCurve | Sequence[PerCurve], num_curves: int, name: str
) -> Sequence[PerCurve]:
    """One item per curve from one for all or one for each."""
    if isinstance(given, (BeamSection, YarnMaterial)):
        return [given] * num_curves
    if len(given) != num_curves:
        raise ValueError(
            f"{name} has {len(given)} items: give one, or one per curve ({num_curves})"
        )
    return given
