"""The judge of ropes: whether what a run left in its folder can be right.

Of the run it takes where yarns are, what presses them on each other, and the force that it reports. Tensions, energies,
distances, sides and sums of forces are worked out anew.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import numpy.typing as npt

from braidx.geometry import Rope, build_rope
from braidx.output import history, snapshot
from braidx.output.contact_table import YARN_CORE, ContactTable
from braidx.processes import state as checkpoint
from braidx.scene import Form, Scene, Settle
from contact_work import contact_work
from lines import FINER, smooth
from rope_lines import deepest_overlap, half_widths, windings, wrong_sides
from rope_work import Taken
from yarn_energy import Yarns

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Found:
    """A state of equilibrium that a run has kept; of ropes that repeat themselves one pitch of it.

    Attributes:
        name: Of its snapshot.
        now: Unknowns, shape (num_yarns, num_nodes, 3 or 9), mm.
        contacts: What presses yarns on each other.
        row: Of the history.
        goes_on: Whether it repeats itself past its ends.
    """

    name: str
    now: Floats
    contacts: ContactTable
    row: int
    goes_on: bool

    @property
    def lines(self) -> list[Floats]:
        """Smooth centre lines."""
        return [smooth(line, self.goes_on) for line in self.now[..., :3]]

    @property
    def length(self) -> float:
        """Along the axis, mm."""
        return float((self.now[:, -1, 2] - self.now[:, 0, 2]).mean())


class RopeRun:
    """What a run has left.

    Args:
        scene: The scene that was run.
        folder: Its output folder.
    """

    def __init__(self, scene: Scene, folder: Path) -> None:
        self.scene, self.folder = scene, folder
        self.rows = history.read(folder / "history.csv")
        last = checkpoint.load(folder)
        assert last is not None
        self.block = 9 if last.model == "beam" else 3
        count = build_rope(scene).num_yarns
        self.nodes = last.reference.size // self.block // count
        intervals = scene.yarn.elements_per_pitch * scene.rope.pitches
        self.copies = intervals // (self.nodes - 1)
        self.rope: Rope = build_rope(scene, scene.rope.pitches // self.copies)
        self.yarns = Yarns(
            scene,
            last.reference.reshape(count, -1, self.block),
            last.rest_tension.reshape(count, -1),
        )
        self.goes_on = scene.ends.transverse == "periodic"

    @cached_property
    def formed(self) -> list[Found]:
        """The shape that the rope was formed to; none if the run says that it was not."""
        steps = {str(step) for step in self.rows["step"]}
        summary = json.loads((self.folder / "summary.json").read_text("utf-8"))
        only = all(step.endswith("form") for step in steps)
        return [] if only and not summary["converged"] else self._states("form")[-1:]

    @cached_property
    def found(self) -> list[Found]:
        """States with the yarns' real stiffness."""
        return self._states("")

    def _states(self, kind: str) -> list[Found]:
        states = []
        for path in sorted((self.folder / "snapshots").glob("*.npz")):
            row = row_of(path)
            forms = row >= 0 and str(self.rows["step"][row]).endswith("form")
            if row < 0 or forms != (kind == "form") or (forms and "formed" not in path.name):
                continue
            states.append(self._load(path))
        return states

    def _load(self, path: Path) -> Found:
        picture = snapshot.load(path)
        now = np.array([line[: self.nodes] for line in picture.centre_lines])
        if picture.directors is not None:
            g = [pair[: self.nodes].reshape(-1, 6) for pair in picture.directors]
            now = np.concatenate([now, g], axis=2)
        assert picture.contacts is not None
        contacts = self._of_one(picture.contacts)
        return Found(picture.name, now, contacts, row_of(path), self.goes_on)

    def _of_one(self, table: ContactTable) -> ContactTable:
        count = len(table.gap) // self.copies
        return ContactTable(**{name: values[:count] for name, values in vars(table).items()})

    def force(self, found: Found) -> float:
        """On the rope, as the run reports it, N."""
        return 1e3 * float(self.rows["force (kN)"][found.row])

    # What is worked out anew

    def overlap(self, found: Found) -> float:
        """Deepest overlap of two yarns over their radius; not in the first and last elements of ends that are held."""
        radius = self.scene.yarn.radius
        pairs = [q[:, 3:].reshape(-1, 2, 3) if q.shape[1] == 9 else None for q in found.now]
        halves = [half_widths(pair, self.nodes, radius) for pair in pairs]
        lines, cut = found.lines, 0 if self.goes_on else FINER
        inner = [line[cut : len(line) - cut] for line in lines]
        within = [half[cut : len(half) - cut] for half in halves]
        return deepest_overlap(inner, within, self.goes_on, found.length) / radius

    def diameter(self, found: Found) -> float:
        """Of the rope where a centre line is farthest from its axis, mm."""
        away = max(float(np.linalg.norm(line[:, :2], axis=1).max()) for line in found.lines)
        return 2.0 * (away + self.scene.yarn.radius)

    def penetration(self, found: Found) -> float:
        """Deepest of all contacts over the radius; not in the first and last elements of ends that are held."""
        table, z = found.contacts, found.contacts.position[:, 2]
        element = found.length / (self.nodes - 1)
        low, high = found.now[:, 0, 2].mean() + element, found.now[:, -1, 2].mean() - element
        inner = np.ones(len(z), bool) if self.goes_on else (z > low) & (z < high)
        return -float(table.gap[inner].min(initial=0.0)) / self.scene.yarn.radius

    def wrong_sides(self, found: Found) -> int:
        """Crossings of yarns whose wrong one is outside, or that are not there, where that can be told."""
        return wrong_sides(self.rope, found.lines, found.length, self.goes_on)

    def unwound(self, found: Found) -> float:
        """Most turns that two yarns wind about each other more or less than in the recipe."""
        wanted = windings(self.rope.centre_lines)
        strand, layer = self.rope.strand, self.rope.layer
        crossing = layer[strand][:, None] != layer[strand][None, :]
        turns = np.zeros((self.rope.num_strands, self.rope.num_strands))
        crossings = self.rope.crossings
        np.add.at(turns, (crossings.strand_a, crossings.strand_b), crossings.order / 2.0)
        turns += turns.T
        wanted = np.where(crossing, turns[np.ix_(strand, strand)], wanted)
        return float(np.abs(windings(found.lines) - wanted).max())

    def axial_force(self, found: Found) -> float:
        """Force on the rope from tensions and contacts of all sections, in the mean along the axis, N."""
        table = found.contacts
        work = self.yarns.stretching_work(found.now, 2) - self._contact_work(found, 2)
        core = table.of(YARN_CORE)
        work += float(core.friction_force[:, 2] @ core.position[:, 2])
        return work / found.length

    def burst(self, found: Found) -> float:
        """What contacts push outwards more than yarns pull inwards, over what they pull; 0 in equilibrium.

        Yarns that nothing touches pull nothing: what they do is measured by the force on the rope.
        """
        pull = sum(self.yarns.stretching_work(found.now, axis) for axis in (0, 1))
        push = sum(self._contact_work(found, axis) for axis in (0, 1))
        alone = not found.contacts.normal_force.any()
        force = max(self._least(found), abs(self.force(found)) if alone else 0.0)
        return (push - pull) / max(abs(pull), abs(push), force * found.length)

    def unbalanced(self, found: Found) -> float:
        """Largest sum of contact forces on one yarn over the sum of all their sizes divided by the number of yarns."""
        table = found.contacts
        on_b = table.normal_force[:, None] * table.normal + table.friction_force
        sums = np.zeros((self.rope.num_yarns, 3))
        np.add.at(sums, table.yarn_a, -on_b)
        between = table.yarn_b >= 0
        np.add.at(sums, table.yarn_b[between], on_b[between])
        size = 2.0 * table.normal_force.sum() / self.rope.num_yarns
        return float(np.linalg.norm(sums, axis=1).max() / max(size, self._least(found)))

    def beyond_cone(self, found: Found) -> float:
        """Most friction that there is more than the coefficient times the pressing force allows, over all of that."""
        table, coefficient = found.contacts, self.scene.contact.friction
        beyond = np.linalg.norm(table.friction_force, axis=1) - coefficient * table.normal_force
        return float(beyond.max(initial=0.0)) / max(
            float(table.normal_force.max(initial=0.0)), 1e-12
        )

    def elastic(self, found: Found) -> float:
        """Elastic energy of the yarns, mJ."""
        return self.copies * self.yarns.energy(found.now)

    def _contact_work(self, found: Found, axis: int) -> float:
        """What contacts do in an even stretch along an axis, mJ."""
        table, radius = found.contacts, self.scene.yarn.radius
        core = self.scene.core.radius if self.scene.core else 0.0
        apart = table.gap + radius + np.where(table.kind == YARN_CORE, core, radius)
        along = table.normal[:, axis]
        force = table.normal_force * along + table.friction_force[:, axis]
        return float((force * apart * along).sum())

    def _least(self, found: Found) -> float:
        """Force that counts as none, N: a strain of 1e-6 in all yarns."""
        return 1e-6 * self.scene.yarn.axial_stiffness * self.rope.num_yarns

    def ways(self) -> list[tuple[Found, Found]]:
        """States between which the rope is pulled or released, begin and end."""
        steps = self.scene.steps
        rests = [not isinstance(steps[self._step(found)], (Form, Settle)) for found in self.found]
        pairs = zip(self.found[:-1], self.found[1:], rests[1:], strict=True)
        return [(begin, end) for begin, end, pulled in pairs if pulled]

    def _step(self, found: Found) -> int:
        return int(str(self.rows["step"][found.row]).split()[0]) - 1

    def way(self, begin: Found, end: Found) -> list[Found]:
        """All states that the run has kept from one to another."""
        paths = sorted((self.folder / "states").glob("*.npz"))
        between = [path for path in paths if begin.row < row_of(path) < end.row]
        return [begin, *map(self._load, between), end]

    def taken(self, begin: Found, end: Found) -> Taken:
        """Where the work of pulling goes from one state to another."""
        states = self.way(begin, end)
        pairs = zip(states[:-1], states[1:], strict=True)
        parts = np.array([self._taken(*pair) for pair in pairs])
        sums = np.append(parts[:, :-1].sum(axis=0), parts[:, -1].max())
        told = [float(self.rows["friction work (mJ)"][state.row]) for state in (begin, end)]
        largest = max(abs(float(sums[0])), self.elastic(begin), self.elastic(end))
        return Taken(*sums, told=told[1] - told[0], largest=largest)

    def _taken(self, begin: Found, end: Found) -> Floats:
        """Work of the rope's force, and what takes it, in the order of Taken, mJ."""
        moved, states = end.now - begin.now, (begin, end)
        strains = [float(self.rows["rope strain (-)"][state.row]) for state in states]
        rest = begin.length * self.copies / (1.0 + strains[0])
        pull = [self.force(state) * (strains[1] - strains[0]) * rest for state in states]
        strain = [self.copies * self.yarns.work(state.now, moved) for state in states]
        contacts = [(state.contacts, state.now) for state in states]
        touch = self.copies * contact_work(contacts, moved, self.goes_on, self.scene.yarn.radius)
        held = self.stabilisation(end) - self.stabilisation(begin)
        springs = max(map(self._springs, states))
        rub = touch[:, 1]
        return np.array([np.mean(pull), np.mean(strain), touch[:, 0].mean(), *rub, held, springs])

    def _springs(self, found: Found) -> float:
        """Friction forces times the slip that is reversible, mJ."""
        slip = self.scene.contact.reversible_slip * self.scene.yarn.radius
        sizes = np.linalg.norm(found.contacts.friction_force, axis=1)
        return self.copies * slip * float(sizes.sum())

    def gives_way(self, begin: Found, end: Found) -> bool:
        """Whether the force falls while the rope is pulled, or grows while it is let go: it snaps, and loses energy."""
        span = slice(begin.row, end.row + 1)
        strain, force = (self.rows[name][span] for name in ("rope strain (-)", "force (kN)"))
        return bool(np.any(np.diff(strain.astype(float)) * np.diff(force.astype(float)) < 0.0))

    def stabilisation(self, found: Found) -> float:
        """Work of the stabilisation since the rope came to rest, mJ."""
        share = float(self.rows["stabilisation residual share (-)"][found.row])
        return share * self.elastic(found)


def row_of(path: Path) -> int:
    """Row of the history that a snapshot belongs to; -1: the start."""
    return int(path.name.split("_")[0]) - 1
