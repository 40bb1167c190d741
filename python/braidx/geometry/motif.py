"""Stacking order of a braid: which strand is outside at which crossing (paper 1, 3.4.2).

Unrolled, the crossings of the two layers form a lattice: line i of layer 0 meets line j of layer 1.
A motif of +1 and -1 of any size m0 x m1 repeats over this lattice. +1: the strand of layer 0 is
outside. Around the closed cylinder line i + N0 of layer 0 and line j + N1 of layer 1 cross where i
and j do, so the motif has to agree there.
"""

from __future__ import annotations

import math
import re

import numpy as np
from numpy.typing import NDArray

from braidx.scene.errors import SceneError

Motif = NDArray[np.int64]


def motif_matrix(motif: str | tuple[tuple[int, ...], ...]) -> Motif:
    """The motif as a matrix of +1 and -1, shape (m0, m1).

    "k-over-l-under" passes outside k strands and inside l, and moves on by one strand from line to
    line, so that the order depends on i + j alone: ribs along the axis, as a maypole braider makes
    them.

    Raises:
        SceneError: If the rows of a matrix differ in length.
    """
    if isinstance(motif, str):
        over, under = map(int, re.findall(r"\d+", motif))
        lines = np.arange(over + under)
        return np.where((lines[:, None] + lines[None, :]) % (over + under) < over, 1, -1)
    if len({len(row) for row in motif}) != 1 or not motif[0]:
        raise SceneError("braid.motif", "rows differ in length; give a full matrix.", motif)
    return np.array(motif, dtype=np.int64)


def check_motif(motif: Motif, counts: tuple[int, int]) -> None:
    """Raises SceneError unless the motif closes around a braid of counts[0] + counts[1] strands."""
    if closes(motif, counts):
        return
    size = f"{motif.shape[0]} x {motif.shape[1]}"
    fitting = [n for n in range(1, 65) if closes(motif, (n, n))]
    below = [n for n in fitting if n <= min(counts)][-1:]
    near = below + [n for n in fitting if n > min(counts)][:1]
    cure = f"a motif that repeats after {counts[0]} rows and {counts[1]} columns"
    if near:
        cure += ", or " + " or ".join(f"[{n}, {n}]" for n in near) + " strands"
    raise SceneError(
        "braid.motif",
        f"the {size} motif does not close around {counts[0]} + {counts[1]} strands; use {cure}.",
    )


def closes(motif: Motif, counts: tuple[int, int]) -> bool:
    """Whether the motif agrees with itself around the cylinder."""
    return bool(np.array_equal(np.roll(motif, counts, axis=(0, 1)), motif))


def repeats(motif: Motif, layer_1: int) -> bool:
    """Whether a motif that closes repeats after one pitch, in which a strand meets each of the other layer twice."""
    return bool(np.array_equal(np.roll(motif, 2 * layer_1, axis=1), motif))


def stacking_order(motif: Motif, line_0: NDArray[np.int64], line_1: NDArray[np.int64]) -> Motif:
    """Order at crossings of lines of layer 0 and layer 1: +1 where layer 0 is outside.

    Args:
        motif: Shape (m0, m1).
        line_0, line_1: Numbers of the lines, any integers, shape (n,).
    """
    return motif[line_0 % motif.shape[0], line_1 % motif.shape[1]]


def braid_pattern_order(
    pattern: Motif,
    counts: tuple[int, int],
    strands: tuple[int, int],
    shift: tuple[float, float],
    pitch: float,
) -> int:
    """Stacking order at a crossing exactly as paper 1, 3.4.2 prints it; the oracle of this module.

    Args:
        pattern: Braid_pattern over the elementary motif, shape (2 N1, 2 N2).
        counts: N1, N2, strands of the two layers.
        strands: s_a, s_b, numbers of the two strands, counted from 0.
        shift: dV = V_c - V_0 from the first crossing of the pair: (degrees, mm).
        pitch: p_strand, mm.
    """
    along_circle, along_axis = shift[0] / 180.0, shift[1] / (pitch / 2.0)
    mu = ((along_axis + along_circle) / 2.0, (along_axis - along_circle) / 2.0)
    whole = [math.floor(component + 0.5) for component in mu]
    lam = [number - 2 * math.floor(number / 2) for number in whole]
    return int(pattern[strands[0] + lam[0] * counts[0], strands[1] + lam[1] * counts[1]])
