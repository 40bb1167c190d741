"""Contact between curves, solids and rigid surfaces as a term of the global system."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import braidx_engine as engine
import numpy as np
import scipy.sparse as sp
from mpi4py import MPI

from ..system.terms import Floats, Ints
from .deepest_pairs import deepest_pairs
from .saved import own_pairs
from .skins import SkinLayout, engine_skins
from .tubes import TubeLayout, engine_tubes, no_crossings, nodes_beyond


class Contact:
    """Contact elements between tubes, skins of solids and rigid surfaces, and their forces.

    Surfaces are numbered together: tubes first, then skins. What acts between images only is left out.

    Attributes:
        layout: The tubes.
        skins: The skins of solids, or None.
        surfaces: Tubes and skins together (engine object).
        beyond: What is seen past their ends in a periodic sample, or None.
        elements: The current contact elements (engine object).
        laws: Laws of contact (engine object): regularisation, reversible slip, gap step, friction.
        pairing: How contact elements are made (engine object).
        min_radius: Radius of the thinnest tube or skin, mm.
        symmetrised: Whether the tangent of friction is made symmetric.
        start: Unknowns at the start of the increment, shape (num_unknowns,).
        lagged: Normal forces that the potential of friction has, N, shape (num_elements,); zero at first.
        reach: Elements that sections may move before the tangent needs a new pattern.
        num_threads: Threads that the engine uses; sums depend on it by round-off.
    """

    def __init__(
        self,
        comm: MPI.Comm,
        layout: TubeLayout,
        crossings: Any = None,
        *,
        smooth: bool,
        symmetric: bool,
        num_threads: int = 1,
        skins: SkinLayout | None = None,
        rest: Floats | None = None,
    ) -> None:
        if skins is not None and layout.beyond:
            raise ValueError(
                f"layout.beyond = {layout.beyond}: periodic samples cannot have skins; give no skins, or 0"
            )
        self.beyond = nodes_beyond(layout)
        self._skins, self._smooth = engine_skins(skins, rest), smooth
        self.tubes = engine_tubes(layout, smooth, self.beyond)
        self.comm, self.layout, self.skins = comm, layout, skins
        radii = [layout.radius] if skins is None else [layout.radius, skins.radius]
        self.min_radius = float(np.concatenate(radii).min())
        self.crossings = crossings if crossings is not None else no_crossings()
        self.symmetrised = symmetric
        self.rigid: list[Any] = []
        self.laws = engine.ContactLaws()
        self.pairing = engine.PairingOptions()
        self.pairing.part, self.pairing.num_parts = comm.rank, comm.size
        self.num_threads = self.pairing.num_threads = num_threads
        self.elements = engine.ContactElements()
        self.start: Floats = np.empty(0)
        self._q: Floats = np.empty(0)
        self.reach = 0.0
        self.pattern_version = 0
        self._pattern: Any = None
        self.lagged: Floats
        self._rows: Ints
        self._cols: Ints
        self._lay_out()

    @property
    def tubes(self) -> Any:
        """The tubes alone (engine object)."""
        return self._tubes

    @tubes.setter
    def tubes(self, tubes: Any) -> None:
        self._tubes = tubes
        self.surfaces = engine.make_surfaces(tubes, self._skins)

    @property
    def symmetric_tangent(self) -> bool:
        """Whether the tangent is symmetric: made so, or for lack of friction."""
        return self.symmetrised or not any(self.laws.friction)

    def update(self, q: Floats) -> None:
        """Makes contact elements anew at the unknowns q; memory is carried over, and turns with the pairs."""
        self.elements = engine.make_contact_elements(
            self.surfaces,
            self.crossings,
            self.rigid,
            self._seen(q),
            self._start(q),
            self.elements,
            self.pairing,
        )
        self._lay_out()

    def set_radius(self, radius: Floats) -> None:
        """Makes tubes as thick as given, shape (num_tubes,), mm."""
        self.layout = replace(self.layout, radius=radius)
        self.tubes = engine_tubes(self.layout, self._smooth, self.beyond)

    def adopt_stiffness(self) -> None:
        """New zones will start with the penalty that is usual by now: the geometric mean of all processes.

        Penalties per length and per area have a mean of their own.
        """
        for name, per_area in (("stiffness", False), ("area_stiffness", True)):
            sums = np.array(engine.sum_log_stiffness(self.elements, per_area))
            logs, count = self.comm.allreduce(sums)
            if count:
                setattr(self.pairing, name, float(np.exp(logs / count)))

    def forget_pattern(self) -> None:
        """Makes the next update lay out the tangent anew: a resumed run then orders unknowns like one that went on."""
        self._pattern = None

    def freeze_sections(self) -> None:
        """Sections and normals stay as they are until the next update."""
        engine.freeze_sections(self.elements)

    def restore(self, elements: Any) -> None:
        """Goes back to earlier contact elements, with their memory."""
        self.elements = elements
        self._lay_out()

    def commit(self, q: Floats) -> tuple[float, float, int]:
        """Contact elements remember the increment that ends at q.

        Returns:
            Of all processes: work dissipated in the increment (mJ), deepest penetration (mm), number of
            contact elements.
        """
        work, penetration = engine.commit(*self._at(q), self.num_threads)
        self.start = q  # the slip of the increment is remembered: forces at q stay what they are
        return (
            self.comm.allreduce(work),
            self.comm.allreduce(penetration, op=MPI.MAX),
            self.comm.allreduce(len(self.elements)),
        )

    def adapt_stiffness(
        self, q: Floats, tolerance: float, growth: float = 3.0, held: Any = None
    ) -> int:
        """Raises penalties where penetration exceeds `tolerance` (mm); number of zones changed, all processes.

        What touches between unknowns that are `held`, shape (num_unknowns,), is left as it is.
        """
        # Zones near the tolerance are raised or not on all processes alike.
        deepest = self.deepest_penetration(q) if self.comm.size > 1 else 0.0
        changed = engine.adapt_stiffness(
            self.surfaces,
            self.elements,
            self._seen(q),
            tolerance,
            growth,
            deepest,
            self.num_threads,
            None if held is None or self.beyond else held,
        )
        return self.comm.allreduce(changed)

    def update_multipliers(self, q: Floats) -> None:
        """Multipliers become the normal forces at q: the same forces then need less penetration."""
        engine.update_multipliers(*self._at(q), self.num_threads)

    def deepest_penetration(self, q: Floats) -> float:
        """Of all processes, mm, at least 0."""
        deepest = engine.deepest_penetration(*self._at(q)[:3], self.num_threads)
        return self.comm.allreduce(deepest, op=MPI.MAX)

    def max_step(self, q: Floats, step: Floats) -> float:
        """Largest share of a step, at most 1, up to which no two centre lines pass through each other."""
        moved = self.beyond.see(step) if self.beyond else step
        return float(engine.max_step(self.surfaces, self._seen(q), moved, self.pairing))

    def rigid_share(self, q: Floats) -> float:
        """Of all normal forces of all processes, the share that acts on rigid surfaces."""
        sums = np.array(engine.sum_normal_forces(*self._at(q), self.num_threads))
        rigid, everywhere = self.comm.allreduce(sums)
        return float(rigid / max(everywhere, 1e-300))

    def scale_stiffness(self, factor: float) -> None:
        """Multiplies all penalties and multipliers."""
        if factor != 1.0:
            engine.scale_stiffness(self.elements, factor)

    def restore_arrays(self, arrays: dict[str, np.ndarray]) -> None:
        """Takes contact elements with their memory from arrays; each process keeps the pairs that are its own."""
        self.restore(engine.ContactElements.from_arrays(own_pairs(arrays, self.pairing)))

    def arrays(self) -> dict[str, np.ndarray]:
        """Contact elements of all processes with their memory, the same on each."""
        parts = self.comm.allgather(self.elements.arrays())
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}

    def worst_pairs(self, count: int = 3) -> list[tuple[int, int]]:
        """Pairs of tubes with the deepest penetrations at the last state, deepest first."""
        return deepest_pairs(self.results(self._q), self.comm, count)

    def results(self, q: Floats) -> dict[str, np.ndarray]:
        """Results per contact element of this process: gap, normal_force, friction_force, position, normal...

        Where `per_area` is True, `weight` is an area (mm^2), and normal_force / weight a pressure (MPa); elsewhere it
        is a length (mm), and the ratio a force per length.
        """
        forces = engine.contact_results(*self._at(q), self.num_threads)
        return {**self.elements.arrays(), **forces}

    def crossing_heights(self, q: Floats) -> Floats:
        """Signed distance of yarns at each prescribed crossing within the sample, see the engine, mm."""
        heights: Floats = engine.crossing_heights(self.tubes, self.crossings, self._seen(q))
        return heights

    def set_state(self, q: Floats) -> None:
        """See Term."""
        self._q = q

    def lag(self, q: Floats) -> None:
        """The potential of friction takes the normal forces at q, until contact elements are made anew."""
        self.lagged = engine.normal_forces(*self._at(q), self.num_threads)

    def energy(self, own: Floats) -> float:
        """See Term: exact without friction; with friction where normal forces are the `lagged`."""
        return float(engine.contact_energy(*self._at(self._q), self.lagged, self.num_threads))

    def add_residual(self, residual: Floats) -> None:
        """See Term."""
        seen, start = self._seen(self._q), self._start(self._q)
        forces = np.zeros_like(seen) if self.beyond else residual
        engine.add_residual(
            self.surfaces, self.elements, seen, start, self.laws, forces, self.num_threads
        )
        if self.beyond:
            self.beyond.give_back(forces, residual)

    @property
    def spread(self) -> sp.csr_matrix | None:
        """See Term."""
        return self.beyond.spread if self.beyond else None

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """See Term."""
        return self._rows, self._cols

    def tangent_values(self) -> Floats:
        """See Term."""
        values = np.zeros(len(self._rows))
        engine.add_tangent(
            self.surfaces,
            self.elements,
            self._pattern,
            self._seen(self._q),
            self._start(self._q),
            self.laws,
            self.symmetric_tangent,
            values,
            self.num_threads,
        )
        return values

    def _seen(self, q: Floats) -> Floats:
        """All unknowns in the numbers of contact."""
        return self.beyond.see(q) if self.beyond else q

    def _at(self, q: Floats) -> tuple[Any, Any, Floats, Floats, Any]:
        """What the engine asks for to tell forces at q."""
        return self.surfaces, self.elements, self._seen(q), self._start(q), self.laws

    def _start(self, q: Floats) -> Floats:
        """What slip counts from, in the numbers of contact: the start of the increment; without one, q."""
        return self._seen(self.start if self.start.size else q)

    def _lay_out(self) -> None:
        """Finds the contact elements' places in the tangent, in a new pattern where the last one lacks some."""
        self.lagged = np.zeros(len(self.elements))
        if self._pattern is not None and engine.place(
            self._pattern, self.surfaces, self.elements, self.num_threads
        ):
            return
        self.pattern_version += 1
        self._pattern = engine.make_pattern(
            self.surfaces, self.elements, self.reach, self.num_threads
        )
        within = np.arange(3)
        row, col = self._pattern.blocks()
        shape = (len(row), 3, 3)
        self._rows = np.broadcast_to(row[:, None, None] + within[None, :, None], shape).ravel()
        self._cols = np.broadcast_to(col[:, None, None] + within[None, None, :], shape).ravel()
