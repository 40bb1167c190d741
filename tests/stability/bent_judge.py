"""The judge of bent ropes, from the folder of a run: what the sheave pushes, where yarns are, where the work went."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt
from mpi4py import MPI
from scipy.spatial import cKDTree

from braidx.geometry import build_rope
from braidx.output import history, snapshot
from braidx.output.contact_table import CORE_SHEAVE, YARN_SHEAVE
from braidx.output.snapshot import Snapshot
from braidx.processes import state as checkpoint
from braidx.processes.bending.start import make_bent_rope
from braidx.scene import Bend, Scene
from lines import FINER, smooth
from rope_lines import deepest_overlap, half_widths, wrong_sides
from rope_work import work_of

Floats = npt.NDArray[np.float64]


class BentRun:
    """What a run in which a rope was bent has left.

    Args:
        scene: The scene that was run.
        folder: Its output folder.
    """

    def __init__(self, scene: Scene, folder: Path) -> None:
        self.scene, self.folder, self.rope = scene, folder, build_rope(scene)
        self.rows = history.read(folder / "history.csv")
        self.ways = ~np.isnan(self.rows["travel (mm)"].astype(float))
        pictures = [snapshot.load(path) for path in sorted((folder / "snapshots").glob("*.npz"))]
        self.found = [p for p in pictures if p.sheave is not None and p.contacts is not None]

    def force_error(self) -> float:
        """What the sheave pushes the rope with against what moves its two ends, over the latter when it is largest."""
        rows = self.rows
        forces = 2e3 * rows["force (kN)"][self.ways].astype(float)
        travels = rows["travel (mm)"][self.ways].astype(float)
        error = 0.0
        for picture in self.found:
            table = picture.contacts
            assert table is not None
            on = (table.kind == YARN_SHEAVE) | (table.kind == CORE_SHEAVE)
            on_sheave = table.normal_force[:, None] * table.normal + table.friction_force
            # The bent rope, pulled towards the sheave, is the one whose force can be told from none.
            if picture.name == "bent":
                at = int(np.argmax(travels))
                error = abs(float(on_sheave[on, 1].sum()) + forces[at]) / forces.max()
        return error

    def overlap(self, picture: Snapshot) -> float:
        """Deepest overlap of two yarns, or of a yarn and the sheave, over their radius; not within the clamps."""
        radius, sheave = self.scene.yarn.radius, picture.sheave
        assert sheave is not None
        inner = slice(FINER, -FINER)
        lines = [smooth(line, False)[inner] for line in picture.centre_lines]
        pairs: Sequence[Floats | None] = picture.directors or [None] * len(lines)
        halves = [
            half_widths(pair, len(line), radius)[inner]
            for pair, line in zip(pairs, picture.centre_lines, strict=True)
        ]
        deep = deepest_overlap(lines, halves, False, 0.0)
        for line, half in zip(lines, halves, strict=True):
            away = ((line[1:] + line[:-1]) / 2.0 - sheave.centre) * [0.0, 1.0, 1.0]
            distance = np.linalg.norm(away, axis=1)
            along = away / distance[:, None]
            width = np.sqrt(np.einsum("ni,nij,nj->n", along, half, along))
            deep = max(deep, float((sheave.radius + width - distance).max()))
        return deep / radius

    def wrong_sides(self, picture: Snapshot) -> int:
        """Crossings whose wrong yarn is outside, seen from the core."""
        assert picture.core is not None
        axis = smooth(picture.core.line, False)
        lines = [unrolled(smooth(line, False), axis) for line in picture.centre_lines]
        length = float(np.linalg.norm(np.diff(axis, axis=0), axis=1).sum())
        return wrong_sides(self.rope, lines, length, False)

    def energy_error(self) -> float:
        """Work of the ends that is in nothing, missing or made, over all of it; of ropes that end bent."""
        last = checkpoint.load(self.folder)
        assert last is not None
        model, last = make_bent_rope(MPI.COMM_WORLD, self.scene, last)
        spent = model.internal_energy(last.q) + last.friction_work + last.stabilisation_work
        force = 2e3 * self.rows["force (kN)"][self.ways].astype(float)
        travel = self.rows["travel (mm)"][self.ways].astype(float)
        work, unsure = work_of(force, travel)
        table = self.found[-1].contacts
        assert table is not None
        # Penetrations grow from none with the forces: on the whole they take half of what these would do on them.
        work -= self._pretension() * self._shorter(model.lines)
        missing = work - spent + 0.5 * float(table.normal_force @ np.minimum(table.gap, 0.0))
        return float(max(0.0, abs(missing) - unsure) * np.sign(missing) / max(work, spent))

    def _pretension(self) -> float:
        bends = [step for step in self.scene.steps if isinstance(step, Bend)]
        return 1e3 * (bends[-1].pretension or 0.0)

    def _shorter(self, straight: Sequence[Floats]) -> float:
        """What both ends have come nearer to each other along the axis of the straight rope, mm."""
        spans = [
            np.mean([line[-1, 2] - line[0, 2] for line in lines])
            for lines in (straight, self.found[-1].centre_lines)
        ]
        return float(spans[0] - spans[1])


def unrolled(line: Floats, axis: Floats) -> Floats:
    """Places about a plane curve across x: along x, away from it in its plane, and along it; shapes (n, 3), mm."""
    tangent = np.gradient(axis, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    arc = np.append(0.0, np.linalg.norm(np.diff(axis, axis=0), axis=1).cumsum())
    at = cKDTree(axis).query(line)[1]
    away = line - axis[at]
    beside = np.stack([0.0 * at, tangent[at, 2], -tangent[at, 1]], axis=1)
    along = arc[at] + np.einsum("ni,ni->n", away, tangent[at])
    return np.stack([away[:, 0], np.einsum("ni,ni->n", away, beside), along], axis=1)
