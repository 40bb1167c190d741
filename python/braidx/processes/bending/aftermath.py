"""What is worked out when a run in which a rope was bent has ended: the table of crossings, and the heat."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from ...geometry import Rope
from ...scene import Scene
from .. import state as checkpoint
from .crossings import FILE, crossings_of, write_crossings
from .heat import rope_heat
from .start import BENT
from .turning_points import turning_points


def after_bending(
    scene: Scene, rope: Rope, folder: Path, snapshots: Sequence[Path]
) -> dict[str, float]:
    """Writes crossings.csv and, where it is asked for, the heat; results by name, none of a rope not bent.

    Args:
        scene, rope: As of the run.
        folder: Of the run, with its history and checkpoint.
        snapshots: Kept in the run, in its order.
    """
    state = checkpoint.load(folder)
    if state is None or state.model != BENT:
        return {}
    lines = tuple(state.reference.reshape(rope.num_yarns, -1, 3))
    points = turning_points(snapshots, folder / "history.csv")
    crossings = crossings_of(lines, rope.layer[rope.strand], points)
    if crossings is None:
        return {}
    write_crossings(crossings, folder / FILE)
    return rope_heat(scene, crossings, folder)
