"""Steps that bend a rope over a sheave."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from braidx.scene.fields import option
from braidx.scene.step import Step


@dataclass(frozen=True)
class Bend(Step):
    """Move both ends of the rope towards the sheave, so that it wraps round it (paper 2)."""

    kind: ClassVar[str] = "bend"
    table: ClassVar[str] = "bend"

    travel: float = option(
        unit="mm",
        above=0.0,
        doc="How far both ends are moved towards the sheave at the end of the step, counted from the straight rope. "
        "Increments follow half a cosine, small at both ends.",
    )
    pretension: float | None = option(
        None,
        unit="kN",
        minimum=0.0,
        doc="Force on the ends along the straight rope's axis while it is bent. Left out: as pulled last, or none.",
    )
    increments: int = option(30, minimum=1, doc="Number of increments.")


@dataclass(frozen=True)
class RunOver(Step):
    """Draw a bent rope over the sheave, to one side, to the other and back to the middle, its ends at their slope."""

    kind: ClassVar[str] = "run_over"
    table: ClassVar[str] = "run_over"

    way: float = option(unit="mm", above=0.0, doc="Way to either side.")
    cycles: int = option(1, minimum=1, doc="Number of runs to one side, the other and back.")
    increments: int = option(10, minimum=1, doc="Number of increments per way.")


@dataclass(frozen=True)
class Straighten(Step):
    """Move the ends back to where the straight rope had them."""

    kind: ClassVar[str] = "straighten"
    table: ClassVar[str] = "straighten"

    increments: int = option(30, minimum=1, doc="Number of increments.")


@dataclass(frozen=True)
class BendCycles(Step):
    """Straighten and bend again, to the travel of the last bend and with its pretension."""

    kind: ClassVar[str] = "bend_cycles"
    table: ClassVar[str] = "bend_cycles"

    cycles: int = option(1, minimum=1, doc="Number of cycles.")
    increments: int = option(30, minimum=1, doc="Number of increments per half cycle.")
