"""Surfaces of solids as pictures show them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...bodies.solid import SolidBody
from ...output.skin_picture import SkinPicture
from ...system.constraints import Floats, Ints

# Corners of the faces that a facet is drawn as, against the clock as seen from outside, by its number of nodes.
FACES = {
    3: [[0, 1, 2, 2]],
    4: [[0, 1, 3, 2]],
    6: [[0, 5, 4, 4], [5, 1, 3, 3], [4, 3, 2, 2], [5, 3, 4, 4]],
    9: [[0, 4, 8, 5], [4, 1, 6, 8], [8, 6, 3, 7], [5, 8, 7, 2]],
}


def skin_picture(body: SolidBody, q: Floats, tag: str, owners: Sequence[int]) -> SkinPicture:
    """Surface of a body, with the stress of the cells behind it.

    Args:
        body: The solids.
        q: Their unknowns, shape (num_nodes, 3).
        tag: Name of the surface.
        owners: Yarn that each part belongs to, or -1 for the core.
    """
    facets, nodes = body.mesh.facets_of(tag), body.facet_nodes(tag)
    corners = np.array(FACES[nodes.shape[1]])
    faces = nodes[:, corners].reshape(-1, 4)
    used, number = np.unique(faces, return_inverse=True)
    cells = np.repeat(facets[:, 0], len(corners))
    owner: Ints = np.asarray(owners, dtype=np.int64)[body.mesh.cell_part[cells]]
    along: Floats = np.full(body.num_elements, np.nan)
    if (owner >= 0).any():  # a core has no fibre
        along = body.fibre_stress(q)
    return SkinPicture(
        q[used], number.reshape(faces.shape), owner, body.von_mises(q)[cells], along[cells]
    )
