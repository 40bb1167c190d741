"""A synthetic rope for the tests of the output: 12 strands x 7 yarns, double helices."""

from __future__ import annotations

import numpy as np

from braidx.output import ContactTable, Snapshot


def rope(
    name: str = "formed",
    pitches: float = 2.0,
    nodes: int = 121,
    strands: int = 12,
    lift: float = 1.8,
    stressed: bool = False,
) -> Snapshot:
    """A 2-over 2-under braid of 1 + 6 strands whose strands undulate by +-`lift` mm.

    Strands i of one and j of the other direction meet at z = m pitch / strands, m = j - i modulo
    strands / 2; i is outside where (m + 2 i) mod 4 < 2. Ends lie in z = 0 and z = length.
    """
    pitch, radius, strand_radius, yarn_lay = 132.0, 0.86, 6.9, 1.74
    z = np.linspace(0.0, pitches * pitch, nodes)
    generator = np.random.default_rng(1)
    lines, owner, tensions = [], [], []
    per_layer = strands // 2
    for strand in range(strands):
        sense = 1 if strand < per_layer else -1
        index = strand % per_layer
        turn = sense * (2 * np.pi * z / pitch) + 2 * np.pi * index / per_layer
        crossing = z * strands / pitch
        wave = sense * np.cos(0.5 * np.pi * (crossing + sense * (2 * index - 0.5)))
        distance = strand_radius + lift * wave
        centre = np.stack([distance * np.cos(turn), distance * np.sin(turn), z], axis=1)
        radial = np.stack([np.cos(turn), np.sin(turn), 0 * z], axis=1)
        tangent = np.gradient(centre, axis=0)
        tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
        side = np.cross(tangent, radial)
        side /= np.linalg.norm(side, axis=1, keepdims=True)
        out = np.cross(side, tangent)
        for yarn in range(7):
            angle = 2 * np.pi * yarn / 6 + sense * 2 * np.pi * z / 45.0
            offset = 0.0 if yarn == 6 else yarn_lay
            line = centre + offset * (np.cos(angle)[:, None] * out + np.sin(angle)[:, None] * side)
            line[0, 2], line[-1, 2] = 0.0, z[-1]
            lines.append(line)
            owner.append(strand)
            level = 420 + 60 * generator.standard_normal()
            tensions.append(level + 70 * np.sin(6 * np.pi * z[1:] / pitch + yarn))
    count = 200
    picks = generator.integers(0, len(lines), (2, count))
    normal = generator.standard_normal((count, 3))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    gap = generator.normal(-0.004, 0.004, count)
    force = np.maximum(-gap, 0) * 5e3
    contacts = ContactTable(
        position=np.array([lines[y][generator.integers(nodes)] for y in picks[0]]),
        normal=normal,
        gap=gap,
        normal_force=force,
        friction_force=0.05 * force[:, None] * np.roll(normal, 1, axis=1),
        reversible_slip=np.abs(generator.normal(0, 0.01, count)),
        work=np.abs(generator.normal(0, 0.1, count)),
        yarn_a=picks[0],
        yarn_b=picks[1],
    )
    area = np.pi * radius**2
    return Snapshot(
        name=name,
        centre_lines=tuple(lines),
        radius=np.full(len(lines), radius),
        strand=np.array(owner),
        tension=tuple(t * area for t in tensions) if stressed else None,
        axial_stress=tuple(tensions) if stressed else None,
        contacts=contacts,
    )
