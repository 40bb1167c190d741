"""Relative displacement of crossing yarns (paper 2, "Relative displacement").

The paper follows two nodes, one on each of two crossing yarns, that face each other in the straight
rope, and takes from the displacement of either the motion of the interlacing point; what is left is
how far one yarn has slid over the other. Here the two nodes are the material points that lie on one
radius of the straight rope. In another state the interlacing point is where the two yarns lie on
one radius then, and the displacement is the separation of the two material points across that
radius, which is normal to both yarns there. To first order it is what the paper's rule gives: with
the interlacing point moved by m_a along yarn a and by m_b along yarn b it is m_a t_a - m_b t_b.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from braidx.output.arrays import Array, Integers
from braidx.output.contact_table import YARN_YARN, ContactTable
from braidx.output.interlacing_points import (
    InterlacingPoints,
    crossing,
    find_interlacing,
    radial,
)
from braidx.output.rope_axis import RopeAxis, mean_axis
from braidx.output.yarn_curves import YarnCurves

NEAREST = 4  # interlacing points that the paper averages over


@dataclass(frozen=True)
class RelativeDisplacement:
    """Relative displacement at all interlacing points of a rope (k of them)."""

    reference: InterlacingPoints  # of the straight rope
    displacement: Array  # (k, 3), mm, of yarn b over yarn a; NaN where the crossing is lost
    magnitude: Array  # (k,), mm
    moved: Array  # (k, 2), mm, of the interlacing point along yarns a and b
    position: Array  # (k, 3), mm, now, half way between the two material points

    def at_crown(self, crown: float, count: int = NEAREST) -> Integers:
        """The `count` interlacing points near the crown that slide farthest.

        The paper takes four near the point of maximum bending, "so it should represent the maximum displacement of
        yarns", and does not say which. Here they are among as many as there are yarns, one turn of crossings about
        the crown: those nearest in the straight rope, to a tenth of a mm.
        """
        yarns = len(np.union1d(self.reference.yarn_a, self.reference.yarn_b))
        far = np.round(np.abs(self.reference.position[:, 2] - crown), 1)
        near = np.argsort(far, kind="stable")[:yarns]
        slid = np.nan_to_num(self.magnitude[near], nan=-1.0)
        return np.asarray(near[np.argsort(-slid, kind="stable")][:count], dtype=np.int64)

    def mean_at_crown(self, crown: float, count: int = NEAREST) -> float:
        """Mean over the `count` interlacing points `at_crown`, mm; NaN without any."""
        chosen = self.magnitude[self.at_crown(crown, count)]
        chosen = chosen[np.isfinite(chosen)]
        return float(chosen.mean()) if len(chosen) else float("nan")

    def maximum(self) -> float:
        """Largest relative displacement, mm; NaN without interlacing points."""
        kept = self.magnitude[np.isfinite(self.magnitude)]
        return float(kept.max()) if len(kept) else float("nan")

    def profile(self, width: float) -> tuple[Array, Array, Array]:
        """Relative displacement along the straight rope in bins of z, `width` mm each.

        Returns:
            Middles of the bins that have interlacing points, mean and maximum in them, all mm.
        """
        kept = np.isfinite(self.magnitude)
        bins = np.floor(self.reference.position[kept, 2] / width).astype(np.int64)
        there, at = np.unique(bins, return_inverse=True)
        total = np.zeros(len(there))
        highest = np.zeros(len(there))
        np.add.at(total, at, self.magnitude[kept])
        np.maximum.at(highest, at, self.magnitude[kept])
        return (there + 0.5) * width, total / np.bincount(at, minlength=len(there)), highest


def relative_displacement(
    reference: Sequence[Array],
    current: Sequence[Array],
    radius: Array,
    layer: Integers,
    points: InterlacingPoints | None = None,
    axes: tuple[RopeAxis, RopeAxis] | None = None,
) -> RelativeDisplacement:
    """Compare two states of a rope at its interlacing points.

    Args:
        reference: Per yarn the nodes before bending, shape (n_i, 3), mm.
        current: The same nodes now.
        radius: Per yarn, mm.
        layer: Per yarn its direction, 0 or 1, in the reference.
        points: Interlacing points of the reference, where known already.
        axes: Axis of the rope before bending and now; means of the yarns if None.
    Raises:
        ValueError: If the two states do not have the same nodes.
    """
    if [len(line) for line in reference] != [len(line) for line in current]:
        raise ValueError(
            "relative displacement: the two states have different numbers of nodes; compare states"
            " of one run with one mesh."
        )
    before, after = axes or (mean_axis(reference), mean_axis(current))
    if points is None:
        points = find_interlacing(reference, radius, layer, before)
    now, a, b = YarnCurves(current), points.yarn_a, points.yarn_b
    s_a, s_b, found = crossing(now, after, a, b, points.s_a, points.s_b)
    # In the reference the separation is along the radius: nothing across it has to be deducted.
    across = _across(now, points, radial(after, 0.5 * (now(a, s_a) + now(b, s_b))))
    lengths = [now.arc_length(a, points.s_a, s_a), now.arc_length(b, points.s_b, s_b)]
    displacement = np.where(found[:, None], across, np.nan)
    return RelativeDisplacement(
        reference=points,
        displacement=displacement,
        magnitude=np.linalg.norm(displacement, axis=1),
        moved=np.where(found[:, None], np.stack(lengths, axis=1), np.nan),
        position=0.5 * (now(a, points.s_a) + now(b, points.s_b)),
    )


def work_per_crossing(result: RelativeDisplacement, contacts: ContactTable) -> Array:
    """Work of friction per interlacing point, shape (k,), mJ; see `per_crossing`."""
    return per_crossing(result, contacts, contacts.work)


def per_crossing(result: RelativeDisplacement, contacts: ContactTable, values: Array) -> Array:
    """Sums per interlacing point over contact elements between its yarns, shape (k,).

    Each contact element between two yarns counts for the nearest interlacing point of the two;
    elements between yarns that do not cross are left out.

    Args:
        result: The interlacing points, in the state of the contacts.
        contacts: All contact elements (m of them).
        values: What is summed, shape (m,), such as `contacts.normal_force`.
    """
    points = result.reference
    sums = np.zeros(len(points))
    between, own = contacts.of(YARN_YARN), values[contacts.kind == YARN_YARN]
    crossings = _by_pair(points.yarn_a, points.yarn_b)
    for pair, elements in _by_pair(between.yarn_a, between.yarn_b).items():
        if pair in crossings:
            here = crossings[pair]
            apart = between.position[elements][:, None] - result.position[here]
            nearest = here[np.argmin((apart**2).sum(axis=2), axis=1)]
            np.add.at(sums, nearest, own[elements])
    return sums


def _across(curves: YarnCurves, points: InterlacingPoints, normal: Array) -> Array:
    """Separation b - a of the material points without its part along a normal, shape (k, 3)."""
    separation = curves(points.yarn_b, points.s_b) - curves(points.yarn_a, points.s_a)
    return np.asarray(separation - np.einsum("ij,ij->i", separation, normal)[:, None] * normal)


def _by_pair(first: Integers, second: Integers) -> dict[tuple[int, int], Integers]:
    """Rows of each unordered pair of yarns."""
    pairs = np.sort(np.stack([first, second], axis=1), axis=1)
    if not len(pairs):
        return {}
    kinds, at = np.unique(pairs, axis=0, return_inverse=True)
    order = np.argsort(at.ravel(), kind="stable")
    groups = np.split(order, np.cumsum(np.bincount(at.ravel()))[:-1])
    return {(int(kinds[k, 0]), int(kinds[k, 1])): group for k, group in enumerate(groups)}
