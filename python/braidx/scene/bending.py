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
    pretension: float = option(
        0.0, unit="kN", minimum=0.0, doc="Force on the ends along the rope's axis while it is bent."
    )
    increments: int = option(30, minimum=1, doc="Number of increments.")


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
