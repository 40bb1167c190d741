"""What the two ends of a rope over a sheave are asked for."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ...system.constraints import Floats

PARTS = ("travel", "pull", "run")


@dataclass(frozen=True)
class Ends:
    """Motions of both ends, and the force on them.

    Attributes:
        travel: Of both towards the sheave, mm.
        pull: Force on either end along the axis of the straight rope, N.
        run: Way that the rope has been drawn over the sheave, from the first end towards the last, mm.
        slope: Angle between the rope at its ends and the straight rope while it is drawn, radians.
    """

    travel: float = 0.0
    pull: float = 0.0
    run: float = 0.0
    slope: float = 0.0

    @staticmethod
    def reached(progress: dict[str, float]) -> Ends:
        """Those of a state."""
        return Ends(*(progress.get(name, 0.0) for name in (*PARTS, "slope")))

    @property
    def parts(self) -> Floats:
        """What changes from increment to increment, shape (3,)."""
        return np.array([getattr(self, name) for name in PARTS])

    def towards(self, aim: Ends, share: float) -> Ends:
        """A share of the way to others; the slope is theirs at once."""
        way = self.parts + share * (aim.parts - self.parts)
        return replace(aim, **dict(zip(PARTS, map(float, way), strict=True)))

    def progress(self) -> dict[str, float]:
        """What a state remembers of them."""
        return {**dict(zip(PARTS, map(float, self.parts), strict=True)), "slope": self.slope}

    def __str__(self) -> str:
        text = f"a travel of {self.travel:.3f} mm"
        text += f", {self.run:.3f} mm over the sheave" if self.run else ""
        return text + (f", under {1e-3 * self.pull:.4g} kN" if self.pull else "")
