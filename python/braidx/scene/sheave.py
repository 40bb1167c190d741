"""The sheave that a rope is bent over."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from braidx.scene.errors import SceneError
from braidx.scene.fields import Table, option


@dataclass(frozen=True)
class Sheave(Table):
    """A rigid sheave (paper 2). Its axis is x, and it lies below the middle of the sample, on the side of -y."""

    table: ClassVar[str] = "sheave"

    diameter: float = option(
        unit="mm", above=0.0, doc="Diameter where the rope lies, at the bottom of the groove."
    )
    groove: str = option(
        None,
        choices=("flat", "round"),
        doc="Flat: a cylinder. Round: a groove of radius groove_radius. Left out: round if that radius is given.",
    )
    groove_radius: float | None = option(
        None, unit="mm", above=0.0, doc="Radius of a round groove's section."
    )
    motion: str = option(
        "fixed",
        choices=("fixed", "free", "driven"),
        doc="Fixed: it does not turn. Free: it turns as friction takes it along. Driven: by driven_angle.",
    )
    driven_angle: float = option(
        0.0,
        unit="degrees",
        doc="Angle that a driven sheave turns by over the travel, positive about x.",
    )
    gap: float = option(
        0.01,
        unit="mm",
        minimum=0.0,
        doc="Clearance between rope and sheave at the start, from the outer diameter of the recipe.",
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.groove is None:
            groove = "flat" if self.groove_radius is None else "round"
            object.__setattr__(self, "groove", groove)
        if self.groove == "round" and self.groove_radius is None:
            cure = (
                'missing, add it, in mm, a little above the radius of the rope; or groove = "flat".'
            )
            raise SceneError("sheave.groove_radius", cure)
        if self.groove == "flat" and self.groove_radius is not None:
            cure = 'a flat sheave has none; leave it out, or write groove = "round".'
            raise SceneError("sheave.groove_radius", cure, self.groove_radius)
        if self.driven_angle and self.motion != "driven":
            cure = f'nothing turns a sheave with motion = "{self.motion}"; use motion = "driven".'
            raise SceneError("sheave.driven_angle", cure, self.driven_angle)
