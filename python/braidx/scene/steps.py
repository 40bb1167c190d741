"""The programme of a scene: steps, each from the state the one before has left."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from braidx.scene.bending import Bend, BendCycles, RunOver, Straighten
from braidx.scene.errors import SceneError
from braidx.scene.fields import option
from braidx.scene.step import Step


@dataclass(frozen=True)
class Form(Step):
    """Find the shape of the rope: separate interpenetrating yarns by the motif (paper 1, 3)."""

    kind: ClassVar[str] = "form"
    table: ClassVar[str] = "form"

    tension: float = option(
        100.0, unit="N", above=0.0, doc="Tension of each yarn, equal along it and in all yarns."
    )
    model: str = option(
        "cable",
        choices=("cable", "beam"),
        doc="What yarns are while the rope is formed. Beams, as in paper 1, take several times as long.",
    )
    die_diameter: float | None = option(
        None,
        unit="mm",
        above=0.0,
        doc="Diameter of the bore that the rope is formed in and that is opened at the end; left out: none.",
    )
    gap_reduction: float = option(
        0.5,
        unit="yarn radius",
        above=0.0,
        doc="Largest reduction of a penetration in one increment (paper 1, eq. 6).",
    )
    penalty: float = option(
        3.0,
        unit="tension / radius^2",
        above=0.0,
        doc="Penalty per length of contact while yarns are being separated; raised afterwards.",
    )
    viscosity: float = option(
        0.33,
        unit="tension / element length",
        above=0.0,
        doc="Stabilisation of node positions: force per mm moved in the increment.",
    )
    friction: float | None = option(
        None,
        minimum=0.0,
        doc="Coefficient of friction while the rope comes to rest, after having been separated without friction; "
        "left out: what [contact] says of each pair.",
    )
    increments: int = option(150, minimum=1, doc="Most increments.")


@dataclass(frozen=True)
class Settle(Step):
    """Let the rope come to rest with its real stiffness, in its own model, at a small force."""

    kind: ClassVar[str] = "settle"
    table: ClassVar[str] = "settle"

    force: float = option(0.1, unit="kN", minimum=0.0, doc="Force on the rope.")
    increments: int = option(60, minimum=1, doc="Most increments.")
    ends: float = option(
        1.0,
        doc="Share of what [[ends.groups]] prescribe (displacement, rotation, force, moment) that is reached at the "
        "end of the step, growing evenly from the share before in the first half of the increments.",
        needs="groups",
    )


@dataclass(frozen=True)
class Pull(Step):
    """Move one end along the axis until a force or a strain is reached: give one of them."""

    kind: ClassVar[str] = "pull"
    table: ClassVar[str] = "pull"

    strain_increment: float = option(
        0.001, above=0.0, below=0.1, doc="Rope strain added per increment."
    )
    to_force: float | None = option(None, unit="kN", above=0.0, doc="Force at which the step ends.")
    to_strain: float | None = option(
        None, above=-0.5, below=1.0, doc="Rope strain at which the step ends."
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        if (self.to_force is None) == (self.to_strain is None):
            found = "both are given" if self.to_force is not None else "neither is given"
            raise SceneError("pull.to_force", f"give either to_force (kN) or to_strain; {found}.")


@dataclass(frozen=True)
class Hold(Step):
    """Keep the strain; groups of ends may be moved, turned or loaded meanwhile."""

    kind: ClassVar[str] = "hold"
    table: ClassVar[str] = "hold"

    increments: int = option(5, minimum=1, doc="Number of increments.")
    ends: float = option(
        1.0,
        doc="Share of what [[ends.groups]] prescribe (displacement, rotation, force, moment) that is reached at the "
        "end of the step, growing evenly from the share before.",
        needs="groups",
    )


@dataclass(frozen=True)
class Cycle(Step):
    """Pull and release between two forces."""

    kind: ClassVar[str] = "cycle"
    table: ClassVar[str] = "cycle"

    force_max: float = option(unit="kN", above=0.0, doc="Force at which the rope is released.")
    force_min: float = option(1.0, unit="kN", minimum=0.0, doc="Force at which it is pulled again.")
    cycles: int = option(1, minimum=1, doc="Number of cycles.")
    strain_increment: float = option(
        0.001, above=0.0, below=0.1, doc="Rope strain added or taken back per increment."
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.force_min >= self.force_max:
            raise SceneError(
                "cycle.force_min",
                f"must be below force_max = {self.force_max:g} kN.",
                self.force_min,
            )


STEPS: dict[str, type[Step]] = {
    step.kind: step
    for step in (Form, Settle, Pull, Hold, Cycle, Bend, RunOver, Straighten, BendCycles)
}
