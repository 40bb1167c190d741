"""Held nodes that are told to be within each other.

There is no such equilibrium, and contact, which looks at places between nodes, would not see them.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from ..contact.contact import Contact
from ..system.terms import Floats, Ints
from .chords import chord_distances
from .contact import may_touch
from .layout import Layout
from .overlap import HIDDEN
from .passing import NEAR
from .path import Impossible


class HeldEnds:
    """Nodes of rods whose positions are held, and the chords between neighbours.

    Rods and rigid surfaces may overlap there as they do at rest, where they were made so, and as deep as contact may
    penetrate.

    Args:
        layout, contact: Of all rods.
        is_held: Unknowns that are held, shape (num_unknowns,).
        penetration: That contact may have, mm. None: any, and rods may come as near as half of touching.
    """

    def __init__(
        self, layout: Layout, contact: Contact, is_held: np.ndarray, penetration: float | None
    ) -> None:
        self._contact, self._radius = contact, layout.radius.copy()
        # A solid is held at its flat ends, which others may touch: only the centres of the faces count.
        self._radius[list(layout.sections)] = 0.0
        self._penetration = np.inf if penetration is None else penetration
        pieces = [_pieces(layout, rod, is_held) for rod in range(len(layout.first))]
        self._rods = np.repeat(np.arange(len(pieces)), [len(piece) for piece in pieces])
        self._nodes = np.concatenate(pieces)
        positions = [layout.unknowns(rod, slice(None))[:, :3] for rod in range(len(pieces))]
        self._unknowns = np.concatenate(
            [own[piece] for own, piece in zip(positions, pieces, strict=True)]
        )
        self._rest = layout.rest
        lines = [layout.rest[own] for own in positions]
        arcs = [np.append(0.0, np.linalg.norm(np.diff(x, axis=0), axis=1).cumsum()) for x in lines]
        closed = [arc[-1] if i in layout.joints.rods else np.inf for i, arc in enumerate(arcs)]
        self._around = np.array(closed)[self._rods]
        self._arcs = np.concatenate(
            [arc[piece[:, 0]] for arc, piece in zip(arcs, pieces, strict=True)]
        )

    def refuse_overlap(self, held: Floats) -> None:
        """Looks at where held nodes are told to be.

        Args:
            held: Unknowns, right where they are held, shape (num_unknowns,).
        Raises:
            Impossible: If two are within each other, or one is within a rigid surface.
        """
        if len(self._rods):
            self._refuse_rigid(held)
            self._refuse_each_other(held)

    def _refuse_each_other(self, held: Floats) -> None:
        a, b = self._near(held)
        both = self._radius[self._rods[a]] + self._radius[self._rods[b]]
        now, rest = self._apart(held, a, b), self._apart(self._rest, a, b)
        allowed = np.minimum(self._penetration, (1.0 - NEAR) * both) + HIDDEN * both
        hidden = both - now - np.maximum(allowed, both - rest)
        if hidden.max(initial=0.0) > 0.0:
            worst = int(hidden.argmax())
            one, other = self._name(a[worst]), self._name(b[worst])
            raise Impossible(
                f"{one} and {other} would be {now[worst]:.4g} mm apart, and their radii are {both[worst]:.4g} mm "
                "together: held nodes cannot give way"
            )

    def _refuse_rigid(self, held: Floats) -> None:
        places = self._unknowns.reshape(-1, 3)
        radius = self._radius[self._rods].repeat(2)
        for number, rigid in enumerate(self._contact.rigid):
            now, rest = (rigid.distances(q[places]) for q in (held, self._rest))
            allowed = np.minimum(self._penetration, (1.0 - NEAR) * radius) + HIDDEN * radius
            hidden = radius - now - np.maximum(allowed, radius - rest)
            if hidden.max() > 0.0:
                worst = int(hidden.argmax())
                raise Impossible(
                    f"{self._name(worst // 2)} would be {now[worst]:.4g} mm from the rigid surface {number}, and the "
                    f"radius of the rod is {radius[worst]:.4g} mm: held nodes cannot give way"
                )

    def _near(self, held: Floats) -> tuple[Ints, Ints]:
        """Pieces that may touch, and are near enough to be looked at, shape (n,) each."""
        ends = held[self._unknowns]
        longest = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).max()
        reach = 2.0 * float(self._radius.max()) + float(longest)
        a, b = cKDTree(ends.mean(axis=1)).query_pairs(reach, output_type="ndarray").T
        same = self._rods[a] == self._rods[b]
        exclusion = self._contact.pairing.search.self_exclusion * self._radius[self._rods[a]]
        along = np.abs(self._arcs[a] - self._arcs[b])
        may = np.minimum(along, self._around[a] - along) > exclusion
        may[~same] = self._contact.layout.group is None
        may &= may_touch(self._contact)[self._rods[a], self._rods[b]]
        return a[may], b[may]

    def _apart(self, q: Floats, a: Ints, b: Ints) -> Floats:
        """Distances of pieces, shape (n,), mm."""
        ends = q[self._unknowns]
        return chord_distances(ends[a, 0], ends[a, 1], ends[b, 0], ends[b, 1])

    def _name(self, piece: int) -> str:
        nodes = sorted(set(self._nodes[piece].tolist()))
        return (
            f"node{'s'[: len(nodes) - 1]} {' to '.join(map(str, nodes))} of rod {self._rods[piece]}"
        )


def _pieces(layout: Layout, rod: int, is_held: np.ndarray) -> Ints:
    """Chords between held neighbours, and held nodes without held neighbours as chords to themselves, shape (n, 2)."""
    held: np.ndarray = np.all(is_held[layout.unknowns(rod, slice(None))[:, :3]], axis=1)
    after, before = np.append(held[1:], False), np.append(False, held[:-1])
    chords, alone = np.flatnonzero(held & after), np.flatnonzero(held & ~after & ~before)
    return np.concatenate([np.stack([chords, chords + 1], 1), np.stack([alone, alone], 1)])
