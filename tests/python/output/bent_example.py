"""A braid bent over a sheave by a formula, for the tests of the output.

Paper 2's rope: 12 yarns of radius 1 mm, 1-over 1-under, on helices of radius 4 mm at 60 degrees
from the horizontal, over a sheave of 40 mm.
"""

from __future__ import annotations

import numpy as np

from braidx.output import ContactTable, CoreLine, SheavePicture, SkinPicture, Snapshot
from braidx.output.contact_table import YARN_CORE, YARN_SHEAVE, YARN_YARN
from braidx.output.cuts import frames, node_tangents
from braidx.output.interlacing_points import find_interlacing

HELIX, YARN, CORE, SHEAVE, PITCH = 4.0, 1.0, 2.0, 20.0, 2 * np.pi * 4.0 * np.sqrt(3.0)
RHO = SHEAVE + HELIX + 2 * YARN  # mm, bend radius of the rope's axis
LAYER = np.repeat([0, 1], 6)


def straight_lines(pitches: float = 4.0, nodes: int = 145) -> list[np.ndarray]:
    """Six helices in either sense; a radial sine takes them outside and inside in turn."""
    z = np.linspace(0.0, pitches * PITCH, nodes)
    lines = []
    for layer, sense in ((0, 1), (1, -1)):
        for index in range(6):
            turn = sense * 2 * np.pi * z / PITCH + 2 * np.pi * index / 6
            # Crossings are a twelfth of a pitch apart; the sine has a period of two.
            wave = (1 if layer == 0 else -1) * np.cos(12 * np.pi * z / PITCH)
            distance = HELIX + YARN * wave
            lines.append(np.stack([distance * np.cos(turn), distance * np.sin(turn), z], axis=1))
    return lines


def bend(points: np.ndarray, length: float, share: float = 1.0, wrap: float = 1.2) -> np.ndarray:
    """The axis z becomes an arc of radius RHO/share over +-wrap rad and goes on along its tangents.

    Sections stay plane, across the axis and undeformed; the axis keeps its length.
    """
    if share == 0.0:
        return points.copy()
    rho = RHO / share
    u = points[..., 2] - 0.5 * length
    angle = np.clip(u / rho, -share * wrap, share * wrap)
    beyond = u - rho * angle
    y = -rho + (rho + points[..., 1]) * np.cos(angle) - beyond * np.sin(angle)
    z = 0.5 * length + (rho + points[..., 1]) * np.sin(angle) + beyond * np.cos(angle)
    return np.stack([points[..., 0], y, z], axis=-1)


def tube_skin(line: np.ndarray, owner: int, radius: float, flatten: float = 0.0) -> SkinPicture:
    """Skin of 12 sides about a line, open at its ends, with sections flattened at every layer."""
    section = frames(node_tangents(line))
    angle = np.linspace(0.0, 2 * np.pi, 12, endpoint=False)
    circle = radius * np.stack([(1 - flatten) * np.cos(angle), (1 + flatten) * np.sin(angle)])
    points = line[:, None] + np.einsum("nkc,ks->nsc", section, circle)
    first = 12 * np.arange(len(line) - 1)[:, None] + np.arange(12)
    second = 12 * np.arange(len(line) - 1)[:, None] + (np.arange(12) + 1) % 12
    faces = np.stack([first, second, second + 12, first + 12], axis=-1).reshape(-1, 4)
    along = np.repeat(np.arange(len(line) - 1) / len(line), 12)
    stress = 120 + 80 * np.cos(8 * np.pi * along) * np.tile(np.cos(angle), len(line) - 1)
    return SkinPicture(points.reshape(-1, 3), faces, np.full(len(faces), owner), stress, stress)


def contact_table(lines: list[np.ndarray], length: float, share: float) -> ContactTable:
    """Forces at the crossings, on the core, and on the sheave at the middle of the rope."""
    points = find_interlacing(lines, np.full(12, YARN), LAYER)
    rows: list[tuple[np.ndarray, float, int, int, int]] = []
    for k in range(len(points)):
        force = 20.0 + 40 * np.exp(-(((points.position[k, 2] - length / 2) / 20) ** 2))
        rows.append((points.position[k], force, points.yarn_a[k], points.yarn_b[k], YARN_YARN))
        if points.position[k, 1] < -3.5 and abs(points.position[k, 2] - length / 2) < 30:
            below = points.position[k] * [1.3, 1.45, 1.0]
            rows.append((below, 150.0, points.yarn_a[k], -1, YARN_SHEAVE))
        rows.append((points.position[k] * [0.5, 0.5, 1.0], 8.0, points.yarn_b[k], -1, YARN_CORE))
    position = bend(np.array([row[0] for row in rows]), length, share)
    force = np.array([row[1] for row in rows])
    count = len(rows)
    return ContactTable(
        position=position,
        normal=np.tile([0.0, 1.0, 0.0], (count, 1)),
        gap=-1e-4 * force,
        normal_force=force,
        friction_force=0.1 * force[:, None] * [1.0, 0.0, 0.0],
        reversible_slip=0.01 * np.ones(count),
        work=0.02 * force,
        yarn_a=np.array([row[2] for row in rows]),
        yarn_b=np.array([row[3] for row in rows]),
        kind=np.array([row[4] for row in rows]),
        measure=np.full(count, 0.5),
        per_area=np.zeros(count, dtype=bool),
    )


def bent_rope(
    share: float = 1.0,
    name: str = "bent",
    pitches: float = 4.0,
    nodes: int = 145,
    solids: bool = False,
    groove: float | None = None,
) -> Snapshot:
    """The rope bent to `share` of the sheave's curvature, all yarns tubes or all solids."""
    straight = straight_lines(pitches, nodes)
    length = float(straight[0][-1, 2])
    lines = [bend(line, length, share) for line in straight]
    axis = np.stack([0 * straight[0][:, 2], 0 * straight[0][:, 2], straight[0][:, 2]], axis=1)
    axis = bend(axis, length, share)
    skins: tuple[SkinPicture, ...] = ()
    if solids:
        skins = tuple(tube_skin(line, k, YARN, 0.12) for k, line in enumerate(lines))
        skins += (tube_skin(axis, -1, CORE),)
    stress = [
        120 + 60 * np.sin(12 * np.pi * line[1:, 2] / PITCH) + 100 * share * line[1:, 1] / RHO
        for line in straight
    ]
    return Snapshot(
        name=name,
        centre_lines=tuple(lines),
        radius=np.full(12, YARN),
        strand=np.arange(12),
        axial_stress=tuple(stress),
        tension=tuple(np.pi * value for value in stress),
        contacts=contact_table(straight, length, share),
        core=CoreLine(axis, CORE, 0.8),
        skins=skins,
        sheave=SheavePicture(
            np.array([0.0, -RHO, 0.5 * length]), np.array([1.0, 0.0, 0.0]), SHEAVE, groove
        ),
    )
