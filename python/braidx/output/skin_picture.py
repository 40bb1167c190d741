"""The surface of solid yarns or of a solid core in a picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from braidx.output.arrays import Array, Integers


@dataclass(frozen=True)
class SkinPicture:
    """A surface of quadrilaterals and triangles seen from outside.

    The corners of a face go round it against the clock as seen from outside the solid. A triangle
    repeats its last corner.

    Raises:
        ValueError: If the arrays do not belong together.
    """

    points: Array  # (n, 3), mm
    faces: Integers  # (m, 4), corners
    owner: Integers  # (m,), number of the yarn, -1 for the core
    von_mises: Array  # (m,), MPa; NaN where unknown
    axial_stress: (
        Array  # (m,), MPa along the fibre, positive in tension; NaN where there is no fibre
    )

    def __post_init__(self) -> None:
        count = len(self.faces)
        shapes = {
            "points": (len(self.points), 3),
            "faces": (count, 4),
            "owner": (count,),
            "von_mises": (count,),
            "axial_stress": (count,),
        }
        for name, expected in shapes.items():
            found = np.shape(getattr(self, name))
            if found != expected:
                raise ValueError(f"SkinPicture.{name}: {found}, expected {expected}.")
        if count and not 0 <= self.faces.min() <= self.faces.max() < len(self.points):
            raise ValueError(
                f"SkinPicture.faces: corners {self.faces.min()} to {self.faces.max()} of"
                f" {len(self.points)} points; give numbers of points."
            )

    def triangles(self) -> tuple[Integers, Integers]:
        """Corners of triangles, shape (t, 3), and the face each is part of, shape (t,)."""
        whole = np.flatnonzero(self.faces[:, 3] != self.faces[:, 2])
        corners = np.concatenate([self.faces[:, :3], self.faces[whole][:, [0, 2, 3]]])
        return corners, np.concatenate([np.arange(len(self.faces)), whole])
