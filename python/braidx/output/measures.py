"""Numbers read off a snapshot: diameters, packing, yarn stress, contact. Pure NumPy."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from braidx.output.cuts import Cut, cut
from braidx.output.rope_axis import axis_of
from braidx.output.snapshot import Array, Snapshot

_ANGLES = np.linspace(0.0, 2 * np.pi, 720, endpoint=False)
_DIRECTIONS = np.stack([np.cos(_ANGLES), np.sin(_ANGLES)], axis=1)


@dataclass(frozen=True)
class Statistics:
    """Mean, standard deviation and extremes of a quantity."""

    mean: float
    std: float
    min: float
    max: float


def extent(snapshot: Snapshot) -> tuple[float, float]:
    """Lowest and highest z of the centre lines, mm."""
    height = np.concatenate([line[:, 2] for line in snapshot.centre_lines])
    return float(height.min()), float(height.max())


def interior_cuts(snapshot: Snapshot, count: int = 40, margin: float = 0.15) -> list[Cut]:
    """Equidistant cross-sections, leaving out a fraction `margin` of the length at either end.

    Ends are held by the end conditions and are not representative.
    """
    low, high = extent(snapshot)
    inset = margin * (high - low)
    return [cut(snapshot, float(z)) for z in np.linspace(low + inset, high - inset, count)]


def circumscribed_diameter(section: Cut) -> float:
    """Diameter of the smallest circle about the rope axis (x = y = 0) around all yarns, mm.

    The farthest point of a set is where its support function is largest.
    """
    return 2.0 * float(section.support(_DIRECTIONS).max())


def tape_diameter(section: Cut) -> float:
    """Diameter a tape around the rope shows: girth / pi, mm.

    The girth of the convex hull is the integral of its support function (Cauchy), so that this is
    also the mean over all directions of what a calliper shows.
    """
    return 2.0 * float(section.support(_DIRECTIONS).max(axis=0).mean())


def outline_diameter(section: Cut) -> float:
    """Diameter of the circle with the area of the section's outline, mm.

    The outline joins the outermost points of yarns in all directions from the rope axis: unlike a tape it sinks into
    the valleys between them. Pictures of sections, such as by tomography, show it.
    """
    to_circle = np.linalg.inv(section.axes.transpose(0, 2, 1))  # of an ellipse to the unit circle
    centre = np.einsum("mij,mj->mi", to_circle, section.centre)
    ray = np.einsum("mij,nj->mni", to_circle, _DIRECTIONS)
    along, square = np.einsum("mni,mi->mn", ray, centre), (ray**2).sum(axis=2)
    root = along**2 - square * ((centre**2).sum(axis=1) - 1.0)[:, None]
    reach = np.where(root >= 0.0, (along + np.sqrt(np.maximum(root, 0.0))) / square, 0.0)
    return 2.0 * float(np.sqrt(np.mean(reach.max(axis=0) ** 2)))


def outer_diameter(snapshot: Snapshot, count: int = 40, margin: float = 0.15) -> float:
    """Outer diameter of the rope as a tape shows it, mean over interior cross-sections, mm.

    The diameter of fibre ropes is measured as girth over pi (ISO 2307). Source: paper 1, table 3.
    """
    return mean_diameter(tape_diameter, snapshot, count, margin)


def mean_diameter(
    of: Callable[[Cut], float], snapshot: Snapshot, count: int = 40, margin: float = 0.15
) -> float:
    """A diameter of sections, mean over interior cross-sections, mm."""
    return float(np.mean([of(section) for section in interior_cuts(snapshot, count, margin)]))


def packing_fraction(section: Cut) -> float:
    """Area of the yarns over the area of the circumscribed circle, -."""
    return float(4 * section.area().sum() / (np.pi * circumscribed_diameter(section) ** 2))


def layers(snapshot: Snapshot) -> NDArray[np.int64]:
    """Layer (direction) of each yarn: 0 where its strand turns right-handed about the rope's axis, else 1."""
    turns = np.zeros(int(snapshot.strand.max()) + 1)
    lines = snapshot.centre_lines
    if snapshot.sheave is not None:  # the rope may be bent
        axis = axis_of(snapshot)
        lines = tuple(axis.straightened(line) for line in lines)
    for line, strand in zip(lines, snapshot.strand):
        a, b = line[:-1], line[1:]
        cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        dot = a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1]
        turns[strand] += np.arctan2(cross, dot).sum()
    by_strand = np.where(turns < -0.1, 1, 0).astype(np.int64)
    by_yarn: NDArray[np.int64] = by_strand[snapshot.strand]
    return by_yarn


def interior_stress(snapshot: Snapshot, margin: float = 0.15) -> tuple[Array, Array]:
    """Axial stress of the segments away from the ends.

    Returns:
        Stresses, MPa, and current lengths, mm, of all such segments of all yarns.
    Raises:
        ValueError: If the snapshot has no axial stress.
    """
    if snapshot.axial_stress is None:
        raise ValueError(f"Snapshot {snapshot.name!r} has no axial stress; store it when saving.")
    low, high = extent(snapshot)
    inset = margin * (high - low)
    stresses, lengths = [], []
    for line, stress in zip(snapshot.centre_lines, snapshot.axial_stress):
        middle = 0.5 * (line[1:, 2] + line[:-1, 2])
        inside = (middle >= low + inset) & (middle <= high - inset)
        stresses.append(stress[inside])
        lengths.append(np.linalg.norm(np.diff(line, axis=0), axis=1)[inside])
    return np.concatenate(stresses), np.concatenate(lengths)


def yarn_stress(snapshot: Snapshot, margin: float = 0.15) -> Statistics:
    """Axial stress over all yarns and along them, away from the ends, weighted by length, MPa.

    Source: paper 1, 5.2.2: heterogeneity between yarns and along each yarn.
    """
    stress, length = interior_stress(snapshot, margin)
    mean = float(np.average(stress, weights=length))
    std = float(np.sqrt(np.average((stress - mean) ** 2, weights=length)))
    return Statistics(mean, std, float(stress.min()), float(stress.max()))


@dataclass(frozen=True)
class ContactStatistics:
    """Contact of one state."""

    elements: int
    active: int  # elements that carry a normal force
    max_penetration: float  # mm
    max_penetration_over_radius: float  # -, radius of the thinner yarn of the pair
    total_normal_force: float  # N, sum of magnitudes
    mean_mobilisation: float  # -, friction force over normal force, over active elements
    friction_work: float  # mJ


def contact_statistics(snapshot: Snapshot) -> ContactStatistics:
    """Contact statistics; all zero without contacts."""
    table = snapshot.contacts
    if table is None or not len(table.gap):
        return ContactStatistics(0, 0, 0.0, 0.0, 0.0, 0.0, 0.0)
    penetration = np.maximum(-table.gap, 0.0)
    # Core and sheave, yarn number -1, are thicker than any yarn.
    radius = np.append(snapshot.radius, np.inf if snapshot.core is None else snapshot.core.radius)
    thinner = np.minimum(radius[table.yarn_a], radius[table.yarn_b])
    active = table.normal_force > 0.0
    normal = table.normal_force[active]
    friction = np.linalg.norm(table.friction_force[active], axis=1)
    return ContactStatistics(
        elements=len(table.gap),
        active=int(active.sum()),
        max_penetration=float(penetration.max()),
        max_penetration_over_radius=float((penetration / thinner).max()),
        total_normal_force=float(normal.sum()),
        mean_mobilisation=float(np.mean(friction / normal)) if len(normal) else 0.0,
        friction_work=float(table.work.sum()),
    )


@dataclass(frozen=True)
class LinearFit:
    """Least-squares line force = stiffness (strain - offset) through the linear part of a curve."""

    stiffness: float  # kN per unit strain, i.e. EA in kN
    offset: float  # -, strain at which the line meets zero force
    first_strain: float  # -
    last_strain: float  # -


def linear_fit(strain: Array, force: Array, lower: float = 0.5, upper: float = 1.0) -> LinearFit:
    """Axial stiffness EA of a rope: slope of its force-strain curve where it is linear.

    The linear part is the first loading from `lower` to `upper` times the largest force.

    Args:
        strain: -, shape (n,), in the order of loading.
        force: kN, shape (n,).
    Raises:
        ValueError: If fewer than two different points lie on the linear part.
    Source: paper 1, 4.3.2 (stiffness from the linear part of the curve).
    """
    peak = int(np.argmax(force))
    first = np.asarray(strain)[: peak + 1], np.asarray(force)[: peak + 1]
    chosen = (first[1] >= lower * force[peak]) & (first[1] <= upper * force[peak])
    x, y = first[0][chosen], first[1][chosen]
    if len(x) < 2 or np.ptp(x) == 0.0:
        raise ValueError(f"Linear part: {len(x)} increment(s) in it; use smaller increments.")
    stiffness, constant = np.polyfit(x, y, 1)
    return LinearFit(float(stiffness), float(-constant / stiffness), float(x.min()), float(x.max()))
