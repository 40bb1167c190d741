"""How a scene is computed: contact, solver, and what is written."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from braidx.scene.fields import Table, option


@dataclass(frozen=True)
class ContactOptions(Table):
    """Contact and friction between yarns (paper 1, 2.3)."""

    table: ClassVar[str] = "contact"

    friction: float = option(0.1, minimum=0.0, maximum=2.0, doc="Coefficient of friction.")
    friction_between: dict[str, float] = option(
        {},
        keys=("yarn-yarn", "yarn-core", "yarn-sheave"),
        minimum=0.0,
        maximum=2.0,
        doc="Coefficients of friction of pairs of their own; of a pair left out: friction.",
    )
    # left out only until the scene is made, see defaults.py
    penetration_tolerance: float = option(
        None,
        unit="yarn radius",
        above=0.0,
        maximum=0.5,
        doc="Penetration beyond which the penalty of a proximity zone is raised; left out: 0.005 in ropes that are "
        "bent and have six nodes or more from crossing to crossing, otherwise 0.015.",
    )
    regularisation: float = option(
        0.005,
        unit="yarn radius",
        above=0.0,
        maximum=0.5,
        doc="Penetration p_reg below which the normal force grows quadratically (eq. 4).",
    )
    reversible_slip: float = option(
        0.01,
        unit="yarn radius",
        above=0.0,
        doc="Slip that is given back before sliding starts (eq. 5).",
        needs="rubs",
    )
    penalty: float | None = option(
        None,
        unit="N/mm per mm",
        above=0.0,
        doc="First penalty per length of contact in a scene that forms no rope; left out: 1 % of "
        "axial stiffness / radius^2. It is adapted from there.",
        needs="first penalty",
    )
    station_spacing: float = option(
        0.25,
        unit="element length",
        above=0.0,
        maximum=2.0,
        doc="Distance of contact elements along the intermediate geometry.",
    )
    search_distance: float = option(
        0.5,
        unit="yarn radius",
        above=0.0,
        doc="Gap up to which two yarns are paired (threshold of the proximity zones).",
    )

    def friction_of(self, pair: str) -> float:
        """Coefficient of friction of "yarn-yarn", "yarn-core" or "yarn-sheave"."""
        return self.friction_between.get(pair, self.friction)


@dataclass(frozen=True)
class SolverOptions(Table):
    """Newton iterations, their linear systems, and the size of increments."""

    table: ClassVar[str] = "solver"

    tolerance: float = option(
        1e-5,
        above=0.0,
        below=1.0,
        doc="Residual at which an equilibrium is accepted, relative to the forces in play.",
    )
    max_iterations: int = option(
        25,
        minimum=1,
        doc="Newton iterations for given contact elements before an increment is cut; of straight ropes four times as "
        "many for the whole increment.",
    )
    max_cuts: int = option(
        8,
        minimum=0,
        doc="Halvings of an increment before the run gives up; twice as many in a row.",
        needs="cuts",
    )
    tangent: str = option(
        "consistent",
        choices=("symmetric", "consistent"),
        doc="Tangent of friction: symmetrised (CHOLMOD), or consistent (MUMPS), with which Newton's method converges "
        "in a fifth of the iterations.",
        needs="rubbing equilibria",
    )
    viscosity: float = option(
        1.0,
        unit="N/mm",
        minimum=0.0,
        doc="Stabilisation of node positions, force per mm moved in the increment; a thousandth of it acts, four times "
        "as much with every halving of an increment.",
        needs="bent",
    )
    director_viscosity: float = option(
        500.0,
        unit="N mm",
        minimum=0.0,
        doc="Stabilisation of the directors of beams and of the tangents of cables, per radian turned in the "
        "increment; likewise.",
        needs="bent",
    )
    director_cap: float = option(
        0.3,
        above=0.0,
        doc="Largest change of a director in one Newton iteration.",
        needs="directors",
    )
    symmetry: bool = option(
        True,
        doc="Keep the rope symmetric under the rotations about its axis that its recipe is symmetric under: yarns "
        "follow those that they are images of, and there is that much less to solve; false lets it leave them. "
        "Groups of ends, once they act, do so too.",
        needs="alike",
    )
    accuracy: str = option(
        "",
        choices=("", "5%", "1%", "0.1%"),
        doc="Relative error that the mesh, contact and increments are chosen for where the scene states nothing about "
        "them, from what was measured ([accuracy](accuracy.md)); as --accuracy does. Empty: the defaults.",
    )
    petsc: dict[str, float | int | bool | str] = option(
        {}, doc="Any PETSc options, without the leading dash; they win over the program's own."
    )


@dataclass(frozen=True)
class OutputOptions(Table):
    """What a run writes besides summary.json and history.csv."""

    table: ClassVar[str] = "output"

    pictures: bool = option(True, doc="Write the pictures.")
    fields: bool = option(True, doc="Write files for ParaView.")
    every: int = option(1, minimum=1, doc="Write fields every so many increments.", needs="fields")
    states: bool = option(
        False,
        doc="Keep the state of every increment in states/, as those at the end of a stage are kept in snapshots/.",
    )


@dataclass(frozen=True)
class Expected(Table):
    """An expected result, [expected.NAME]; a run compares its own of that name with it."""

    table: ClassVar[str] = "expected"

    reference: float = option(doc="Value, in the unit of the result.")
    tolerance: float | None = option(
        None,
        minimum=0.0,
        doc="Deviation allowed as a fraction of the reference; where the reference is 0, as a "
        "magnitude. Left out: the two are only shown side by side.",
    )
    source: str = option("", doc="Where the value comes from.")
