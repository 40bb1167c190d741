"""Numbers read off a bent rope: forces on sheave and core, stress, shape of sections."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from braidx.output.arrays import Array
from braidx.output.contact_table import CORE_SHEAVE, YARN_CORE, YARN_SHEAVE, ContactTable
from braidx.output.measures import extent
from braidx.output.slices import Slice, section_ratio, slice_skin
from braidx.output.snapshot import Snapshot
from braidx.output.yarn_curves import YarnCurves


def crown_of(snapshot: Snapshot) -> float:
    """z of the crown, mm: that of the sheave's axis, or else the middle of the rope."""
    if snapshot.sheave is not None:
        return float(snapshot.sheave.centre[2])
    low, high = extent(snapshot)
    return 0.5 * (low + high)


def yarn_sheave_force_max(snapshot: Snapshot) -> float:
    """Largest normal force of one contact element between a yarn and the sheave, N.

    It grows with the length or area that an element stands for: compare states of one mesh, or use
    `nominal_pressure`. Source: paper 2, "Contact force": the node under the greatest compression.
    """
    return float(_table(snapshot).of(YARN_SHEAVE).normal_force.max(initial=0.0))


def sheave_force(snapshot: Snapshot) -> Array:
    """Resultant force of the rope on the sheave, normal and friction, shape (3,), N."""
    table = _table(snapshot)
    total = np.zeros(3)
    for kind in (YARN_SHEAVE, CORE_SHEAVE):
        rows = table.of(kind)
        total += (rows.normal_force[:, None] * rows.normal + rows.friction_force).sum(axis=0)
    return total


def sheave_force_total(snapshot: Snapshot) -> float:
    """Sum of the magnitudes of all normal forces on the sheave, N."""
    table = _table(snapshot)
    return float(sum(table.of(kind).normal_force.sum() for kind in (YARN_SHEAVE, CORE_SHEAVE)))


def nominal_pressure(snapshot: Snapshot, kind: int) -> Array:
    """Nominal contact pressure of the elements of one kind, shape (k,), MPa.

    Of elements that stand for an area it is force / area. Of elements along a line it is the line
    load over the diameter of the thinner body, force / (length 2 r): the mean pressure over the
    projected width of the yarn, not the peak of a contact patch, which a line contact of tubes does
    not resolve. NaN where it is not known what an element stands for.
    """
    rows = _table(snapshot).of(kind)
    radius = np.append(snapshot.radius, np.inf if snapshot.core is None else snapshot.core.radius)
    width = 2.0 * np.minimum(radius[rows.yarn_a], radius[rows.yarn_b])
    area = np.where(rows.per_area, rows.measure, rows.measure * width)
    return np.asarray(rows.normal_force / area)


def core_pressure_max(snapshot: Snapshot) -> float:
    """Largest nominal pressure of yarns on the core, MPa; 0 without contact, NaN if not known."""
    pressure = nominal_pressure(snapshot, YARN_CORE)
    return float(pressure.max()) if len(pressure) else 0.0


def von_mises_max(snapshot: Snapshot) -> float:
    """Largest von Mises stress on all surfaces, MPa; NaN without any."""
    found = [skin.von_mises[np.isfinite(skin.von_mises)] for skin in snapshot.skins]
    stress = np.concatenate([np.empty(0), *found])
    return float(stress.max()) if len(stress) else float("nan")


def work_per_cycle(cumulative: Sequence[float], per_cycle: int) -> Array:
    """Work of friction in each whole cycle, shape (cycles,), mJ.

    Args:
        cumulative: Work so far at the start and after each increment, mJ.
        per_cycle: Increments per cycle.
    Raises:
        ValueError: If there is less than one cycle.
    """
    work = np.asarray(cumulative, dtype=float)
    cycles = (len(work) - 1) // per_cycle if per_cycle > 0 else 0
    if cycles < 1:
        raise ValueError(
            f"work per cycle: {len(work)} states with {per_cycle} increments per cycle; record at"
            " least one whole cycle."
        )
    return np.diff(work[: cycles * per_cycle + 1 : per_cycle])


def section_ratios(snapshot: Snapshot, z: float) -> Array:
    """Minor over major axis of the sections of all yarns where their lines pass z, across the yarn.

    Sections of solids are slices of their skins, those of beams follow from their directors, those
    of cables stay circles. At the crown (`crown_of`) the rope crosses the plane z = const once.

    Returns:
        One number per yarn, shape (num_yarns,), -; NaN where a yarn does not pass z.
    """
    curves = YarnCurves(snapshot.centre_lines)
    ratios = np.full(snapshot.num_yarns, np.nan)
    for yarn, line in enumerate(snapshot.centre_lines):
        above = line[:, 2] > z
        at = np.flatnonzero(above[1:] != above[:-1])[:1]
        if not len(at):
            continue
        place = at + (z - line[at, 2]) / (line[at + 1, 2] - line[at, 2])
        who = np.array([yarn])
        centre, tangent = curves(who, place)[0], curves.tangent(who, place)[0]
        own = [
            piece
            for piece in skin_slices(snapshot, centre, tangent)
            if piece.owner == yarn
            and np.linalg.norm(piece.outline.mean(axis=0) - centre) < snapshot.radius[yarn]
        ]
        if own:
            ratios[yarn] = section_ratio(own[0].outline)
        elif snapshot.directors is None:
            ratios[yarn] = 1.0
        else:
            share = float(place[0] - at[0])
            pair = snapshot.directors[yarn][at[0] : at[0] + 2]
            section = (1 - share) * pair[0] + share * pair[1]  # (2, 3)
            flat = section - np.outer(section @ tangent, tangent)
            most, least = np.linalg.svd(flat, compute_uv=False)
            ratios[yarn] = least / most
    return ratios


def skin_slices(snapshot: Snapshot, origin: Array, normal: Array) -> list[Slice]:
    """Outlines that a plane cuts from all surfaces."""
    return [piece for skin in snapshot.skins for piece in slice_skin(skin, origin, normal)]


def _table(snapshot: Snapshot) -> ContactTable:
    """The contacts.

    Raises:
        ValueError: If the snapshot has none.
    """
    if snapshot.contacts is None:
        raise ValueError(f"Snapshot {snapshot.name!r} has no contacts; store them when saving.")
    return snapshot.contacts
