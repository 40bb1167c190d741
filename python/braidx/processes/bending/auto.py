"""No more than a scene needs: which stretches of which yarns ask for more than they are modelled as, and why.

A rope is bent with the cheapest models first (cheapest.py). Indicators taken from the bent rope then tell, yarn by
yarn, what a model leaves out, and only what needs it is upgraded:

- a cable has no bending: its yarn becomes a beam where the energy of the curvature it took would have been more than a
  share of its energy (BENDING);
- a beam's section deforms evenly: stretches become solid where the section's strain (SECTION), or the pressure of
  contact over the modulus across the yarn (PRESSURE), is more than a beam's linear section stands for;
- what the scene expects of solids, the stress in them, is there in solids only: with it, yarns are solid where the
  rope lies on the sheave.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ...geometry.frames import nodal_tangents
from ...output.bending_measures import nominal_pressure
from ...output.contact_table import KINDS
from ...output.snapshot import Snapshot
from ...system.constraints import Floats
from ..yarns import yarn_section
from .cheapest import BENDING
from .model import BentRope
from .stretches import Stretch, with_solid

SECTION = 0.05  # largest strain of a section
# Nominal pressure over the transverse modulus. At 0.15 beams slide as solids do, to 5 % (docs/bending.md).
PRESSURE = 0.2
BESIDE = "yarns beside it are solid"
STRESS = "von_mises_max"  # what only solids have


@dataclass(frozen=True)
class Upgrade:
    """A yarn's stretch that is modelled as something better from now on.

    Attributes:
        yarn, model: Which, and as what.
        first, last: Nodes of its centre line.
        why: The indicator and its value, beside the limit.
    """

    yarn: int
    model: str
    first: int
    last: int
    why: str

    def __str__(self) -> str:
        return f"yarn {self.yarn}, nodes {self.first} to {self.last}: {self.model}, {self.why}"


def upgrades(model: BentRope, picture: Snapshot) -> list[Upgrade]:
    """What asks for more than it is modelled as, in the bent rope of a picture; nothing where all is well.

    Where one yarn has to be solid all are, so that facets meet facets: tubes that lie on the facets of soft solids
    are found at other places with every update of the contact elements.
    """
    out: list[Upgrade] = []
    pressure, needs = _pressures(picture), []
    for stretch in model.assembly.stretches:
        if model.scene.yarn.model_of(stretch.yarn) != "auto" or stretch.model == "solid":
            continue
        if stretch.model == "cable":
            share = bending_share(model, picture, stretch.yarn)
            if share > BENDING:
                why = f"bending has {share:.0%} of the energy (limit {BENDING:.0%})"
                out.append(Upgrade(stretch.yarn, "beam", stretch.first, stretch.last, why))
            continue
        needs.append((stretch, *_solid_nodes(model, picture, stretch, pressure[stretch.yarn])))
    bands = _bands(model, [(stretch.yarn, own) for stretch, own, _ in needs])
    for stretch, own, why in needs:
        height = model.lines[stretch.yarn][:, 2]
        within = np.any([(height >= low) & (height <= high) for low, high in bands], axis=0)
        for first, last in _runs(np.broadcast_to(within, height.shape), stretch):
            reason = why if own[first : last + 1].any() else BESIDE
            out.append(Upgrade(stretch.yarn, "solid", first, last, reason))
    return out


def verdict(model: BentRope, picture: Snapshot) -> str:
    """The largest indicators of beams beside their limits, for a rope that asks for nothing more."""
    pressures = enumerate(_pressures(picture))
    found = [_indicators(model, picture, yarn, pressure) for yarn, pressure in pressures]
    strain, over = (max(float(values.max(initial=0.0)) for values in part) for part in zip(*found))
    return (
        f"sections of beams are strained by at most {strain:.1%} (limit {SECTION:.0%}), "
        f"pressure is at most {over:.1%} of the modulus (limit {PRESSURE:.0%})"
    )


def upgraded(model: BentRope, changes: list[Upgrade]) -> tuple[Stretch, ...]:
    """The stretches of all yarns after upgrades."""
    out: list[Stretch] = []
    for yarn, line in enumerate(model.lines):
        old = [stretch for stretch in model.assembly.stretches if stretch.yarn == yarn]
        mine = [change for change in changes if change.yarn == yarn]
        outer = next((s.model for s in old if s.model != "solid"), "solid")
        outer = "beam" if any(change.model == "beam" for change in mine) else outer
        solid = np.zeros(len(line), dtype=bool)
        for first, last in [
            *((s.first, s.last) for s in old if s.model == "solid"),
            *((c.first, c.last) for c in mine if c.model == "solid"),
        ]:
            solid[first : last + 1] = True
        out += with_solid(yarn, outer, solid)
    return tuple(out)


def bending_share(model: BentRope, picture: Snapshot, yarn: int) -> float:
    """Energy of the change of curvature over that and the axial energy of a yarn, if it were a beam, -."""
    scene = model.scene
    section = yarn_section(scene)
    stiffness = (
        scene.yarn.bundle_factor * scene.yarn.axial_stiffness * section.inertia_1 / section.area
    )
    assert picture.tension is not None
    change = _curvatures(picture.centre_lines[yarn]) - _curvatures(model.lines[yarn])
    step = np.linalg.norm(np.diff(model.lines[yarn], axis=0), axis=1)
    bending = 0.5 * stiffness * float((change**2).sum(axis=1) @ step)
    axial = 0.5 * float(picture.tension[yarn] ** 2 @ step) / scene.yarn.axial_stiffness
    return bending / max(bending + axial, 1e-300)


def section_strain(directors: Floats) -> Floats:
    """Largest principal strain of the sections of a beam, shape (num_nodes,), -."""
    metric = np.einsum("nai,nbi->nab", directors, directors)
    return np.asarray(np.abs(0.5 * (np.linalg.eigvalsh(metric) - 1.0)).max(axis=1))


def _indicators(
    model: BentRope, picture: Snapshot, yarn: int, pressure: Floats
) -> tuple[Floats, Floats]:
    """Strain of a yarn's sections, and pressure over its modulus, at each of its nodes, -."""
    strain: Floats = np.zeros(len(pressure))
    if picture.directors is not None:
        strain = section_strain(picture.directors[yarn])
    return strain, np.asarray(pressure / model.scene.yarn.transverse_modulus)


def _solid_nodes(
    model: BentRope, picture: Snapshot, stretch: Stretch, pressure: Floats
) -> tuple[npt.NDArray[np.bool_], str]:
    """Nodes of a yarn that need solids, and why."""
    scene = model.scene
    strain, over = _indicators(model, picture, stretch.yarn, pressure)
    reasons = [
        (strain > SECTION, f"its section is strained by {strain.max():.1%} (limit {SECTION:.0%})"),
        (over > PRESSURE, f"pressure is {over.max():.1%} of its modulus (limit {PRESSURE:.0%})"),
    ]
    if STRESS in scene.expected:
        asked = np.abs(model.lines[stretch.yarn][:, 2] - scene.crown) < scene.rope.pitch / 2.0
        reasons.append((asked, f"the scene asks for {STRESS}"))
    needs = np.any([which for which, _ in reasons], axis=0)
    return needs, "; ".join(why for which, why in reasons if which.any())


def _bands(
    model: BentRope, needs: list[tuple[int, npt.NDArray[np.bool_]]]
) -> list[tuple[float, float]]:
    """Heights in the straight rope that need solids, with room to the next crossing of a yarn to either side, mm."""
    room = model.scene.rope.pitch / len(model.lines)
    heights = np.sort(np.concatenate([[], *(model.lines[yarn][own, 2] for yarn, own in needs)]))
    parts = np.split(heights, np.flatnonzero(np.diff(heights) > 2.0 * room) + 1)
    return [(float(part[0]) - room, float(part[-1]) + room) for part in parts if len(part)]


def _runs(within: npt.NDArray[np.bool_], stretch: Stretch) -> list[tuple[int, int]]:
    """First and last nodes of what of a stretch is within the bands, two elements at least."""
    mine = within.copy()
    mine[: stretch.first] = mine[stretch.last + 1 :] = False
    edges = np.flatnonzero(np.diff(np.concatenate([[0], mine.astype(int), [0]])))
    return [(int(a), int(b) - 1) for a, b in edges.reshape(-1, 2) if b - a > 2]


def _pressures(picture: Snapshot) -> list[Floats]:
    """Largest nominal pressure of contact near each node of each yarn, MPa."""
    out: list[Floats] = [np.zeros(len(line)) for line in picture.centre_lines]
    assert picture.contacts is not None
    for kind in range(len(KINDS)):
        rows = picture.contacts.of(kind)
        if not len(rows.gap):
            continue
        values = nominal_pressure(picture, kind)
        for yarns in (rows.yarn_a, rows.yarn_b):
            for yarn in np.unique(yarns[yarns >= 0]):
                at = yarns == yarn
                apart = picture.centre_lines[yarn][None] - rows.position[at][:, None]
                node = np.argmin((apart**2).sum(axis=2), axis=1)
                np.maximum.at(out[yarn], node, values[at])
    return out


def _curvatures(line: Floats) -> Floats:
    """Curvature vectors between the nodes of a line, shape (num_nodes - 1, 3), 1/mm."""
    tangents = nodal_tangents(line)
    return np.asarray(
        np.diff(tangents, axis=0) / np.linalg.norm(np.diff(line, axis=0), axis=1)[:, None]
    )
