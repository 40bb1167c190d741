"""The judge of stability: whether a scene converged, how laboriously, and whether what it found can be right.

Nothing here trusts what increments report of themselves: forces, distances and energies are summed up anew.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from braidx.rods import Beam, NotConverged, Rods
from lines import FINER, POINTS, centre_line, nearness, nearness_on_the_way
from particles import apart
from rope_lines import half_widths

Floats = npt.NDArray[np.float64]

CONVERGED, SLOW, FAILED, WRONG = "converged", "slow", "failed", "WRONG"
REFUSED = "refused"  # by the checks of a scene
SLOWNESS = 3.0  # times the median of the iterations of a family
BALANCE = (
    1e-4  # of forces and moments, of the largest sum of sizes: of loads and supports, or contacts
)
ENERGY = 0.05  # of the largest work
HIDDEN = 0.02  # of the sum of radii: overlap that contact elements know nothing of
THROUGH = 0.5  # of the sum of radii: centre lines that come nearer on the way have passed
LEFT = 10.0  # round-offs of axial forces, that an equilibrium may leave; times the root of the number of nodes in all
TURN = 0.7  # change of directors in an increment above which its chord says nothing of the work of couples


@dataclass(frozen=True)
class Outcome:
    """What became of a scene.

    Attributes:
        case: Values of its parameters.
        status: Converged, slow, failed or wrong.
        why: What is wrong, or the message of the failure.
        iterations, increments: In all; of these increments, `cuts` are more than were asked for.
        force_error, moment_error: What does not cancel, over the largest sum of sizes, -.
        penetration: Deepest, over the smallest radius, by the contact elements.
        nearest: Smallest distance of centre lines over the sum of radii, on the way between increments, too.
        energy_error: What is missing (positive) or too much (negative) in the balance, over the largest work.
        seconds: Wall clock.
        knows_work: Whether the balance of energy says something.
        values: Results that a family asks for.
    """

    case: tuple[float, ...]
    status: str = CONVERGED
    why: str = ""
    iterations: int = 0
    increments: int = 0
    cuts: int = 0
    force_error: float = 0.0
    moment_error: float = 0.0
    penetration: float = 0.0
    nearest: float = np.inf
    energy_error: float = 0.0
    seconds: float = 0.0
    knows_work: bool = True
    values: dict[str, float] = field(default_factory=dict)


class Watch:
    """Follows a scene through its increments; to be made when the rods are at rest.

    Args:
        rods: The scene.
        conserves: Whether all energy is accounted for: not where rods snap from one equilibrium to the next.
        balance: To which forces and moments have to cancel.
    """

    def __init__(self, rods: Rods, conserves: bool = True, balance: float = BALANCE) -> None:
        self.rods, self.conserves, self.balance = rods, conserves, balance
        self._left = LEFT * rods.layout.round_off * float(np.sqrt(rods.layout.num_nodes.sum()))
        self.iterations = self.increments = self.asked = 0
        self.force_error = self.moment_error = self.penetration = 0.0
        self.message = ""
        self.work = np.zeros(3)  # with forces at begin, middle and end of increments, mJ
        self.stabilisation = self.largest = 0.0
        self._moving, self._knows_work = False, True
        self._started = time.perf_counter()
        self._q, self._external = rods.q.copy(), np.zeros_like(rods.q)
        self._lines = self._centre_lines()
        self.nearest, self.hidden = nearness(rods, self._lines), 0.0
        self._energy_before = self._stored() + rods.friction_work

    def solve(self, increments: int, **options: Any) -> bool:
        """As Rods.solve; False if it failed."""
        self._moving = False
        return self._follow(
            increments, lambda see: self.rods.solve(increments, observe=see, **options)
        )

    def run(self, duration: float, step: float, **options: Any) -> bool:
        """As Rods.run; False if it failed."""
        self._moving = True
        number = max(1, round(duration / step))
        return self._follow(
            number, lambda see: self.rods.run(duration, step, observe=see, **options)
        )

    def outcome(self, *case: float, **values: float) -> Outcome:
        """The judgement; slowness is left to the family."""
        wrong = self._what_is_wrong()
        status = WRONG if wrong else FAILED if self.message else CONVERGED
        return Outcome(
            case,
            status,
            "; ".join(wrong) or self.message,
            self.iterations,
            self.increments,
            max(0, self.increments - self.asked),
            self.force_error,
            self.moment_error,
            self.penetration,
            self.nearest,
            self.energy_error(),
            time.perf_counter() - self._started,
            self._knows_work and self.conserves,
            values,
        )

    def energy_error(self) -> float:
        """Work that is missing, over the largest work: the trapezium rule's, no more than begin and end differ."""
        spent = self._stored() - self._energy_before + self.rods.friction_work
        spent += self.rods.kinetic_energy()
        low, high = min(self.work), max(self.work)
        missing = max(0.0, low - spent) - max(0.0, spent - high)
        scale = max(self.largest, abs(spent))
        return missing / scale if scale > 0.0 else 0.0

    def _follow(self, asked: int, go: Callable[[Callable[[float], None]], Sequence[Any]]) -> bool:
        self.asked += asked
        try:
            found = go(self._see)
        except NotConverged as failure:
            self.message = str(failure)
            return False
        self.iterations += sum(increment.iterations for increment in found)
        self.stabilisation += sum(increment.stabilisation_work for increment in found)
        return True

    def _see(self, share: float) -> None:
        rods = self.rods
        self.increments += 1
        external = rods.external_forces()
        moved = rods.q - self._q
        turns = np.abs(moved[rods.layout.is_director]).max(initial=0.0)
        self._knows_work = self._knows_work and bool(turns < TURN)
        begin, end = float(self._external @ moved), float(external @ moved)
        self.work += [begin, (begin + end) / 2.0, end]
        self.largest = max(self.largest, abs(self.work[1]), rods.elastic_energy())
        if not self._moving:
            self._check_balance(external)
        self._check_distances()
        self._q, self._external = rods.q.copy(), external

    def _check_balance(self, external: Floats) -> None:
        force, moment, size, turning = resultants(self.rods, external)
        extent = max(float(np.ptp(rod.line, axis=0).max()) for rod in self.rods.rods)
        touching = self.rods.contacts()
        # A knot presses itself harder than it is pulled.
        within = float(touching["normal_force"].sum())
        # Smaller forces are not told from none.
        least = max(size, turning / extent, within, self._left / self.balance)
        self.force_error = max(self.force_error, force / least)
        # Friction acts on particles of both surfaces, which are a little apart.
        friction = np.linalg.norm(touching["friction_force"], axis=1)
        couples = float(friction @ apart(self.rods, touching))
        self.moment_error = max(self.moment_error, max(0.0, moment - couples) / (least * extent))

    def _check_distances(self) -> None:
        rods = self.rods
        lines = self._centre_lines()
        self.nearest = min(self.nearest, nearness_on_the_way(rods, self._lines, lines))
        gaps = rods.contacts()["gap"]
        depth = -float(gaps.min(initial=0.0)) / rods.contact.min_radius
        # Sections that are squeezed, or thinner for being pulled, come nearer than round ones.
        overlap = 1.0 - nearness(rods, lines, self._widths())
        self.hidden = max(self.hidden, overlap - depth / 2.0)
        self.penetration, self._lines = max(self.penetration, depth), lines

    def _what_is_wrong(self) -> list[str]:
        limit = self.rods.penetration
        allowed = np.inf if limit is None else 1.05 * limit / self.rods.contact.min_radius
        error = self.energy_error()
        checks = {
            f"forces are off by {self.force_error:.1e}": self.force_error > self.balance,
            f"moments are off by {self.moment_error:.1e}": self.moment_error > self.balance,
            f"penetration {self.penetration:.3g} r": self.penetration > allowed,
            f"hidden overlap of {self.hidden:.2g} (r + r)": self.hidden > HIDDEN,
            f"rods passed: nearest {self.nearest:.2g} (r + r)": self.nearest < THROUGH,
            f"energy made: {-error:.1%}": error < -ENERGY and self._knows_work,
            f"energy lost: {error:.1%}": error > ENERGY and self.conserves and self._knows_work,
            f"stabilisation takes {self.stabilisation / max(self.largest, 1e-300):.1%}": self.stabilisation
            > ENERGY * self.largest,
            "not a number": not np.all(np.isfinite(self.rods.q)),
        }
        return [what for what, is_so in checks.items() if is_so]

    def _centre_lines(self) -> list[Floats]:
        rods = self.rods
        return [
            centre_line(rods.positions(i).copy(), rod.degree) for i, rod in enumerate(rods.rods)
        ]

    def _widths(self) -> list[Floats]:
        found, rods = [], self.rods
        for i, rod in enumerate(rods.rods):
            state = rods.q[rods.layout.unknowns(i, slice(None))]
            directors = state[:, 3:].reshape(-1, 2, 3) if isinstance(rod, Beam) else None
            finer = FINER if rod.degree == 1 else POINTS // 2
            found.append(half_widths(directors, len(state), rod.radius, finer))
        return found

    def _stored(self) -> float:
        """Elastic energy with that of the penalties, mJ."""
        touching = self.rods.contacts()
        springs = 0.5 * float(touching["normal_force"] @ np.maximum(-touching["gap"], 0.0))
        return self.rods.elastic_energy() + springs


def resultants(rods: Rods, external: Floats) -> tuple[float, float, float, float]:
    """Sizes of the sum of forces and of moments about the middle of the scene, and the sums of sizes."""
    places = np.vstack([rods.positions(i) for i in range(len(rods.rods))])
    middle = (places.max(axis=0) + places.min(axis=0)) / 2.0
    force, moment, size, turning = np.zeros(3), np.zeros(3), 0.0, 0.0
    for number, rod in enumerate(rods.rods):
        unknowns = rods.layout.unknowns(number, slice(None))
        own, state = external[unknowns].reshape(len(unknowns), -1, 3), rods.q[unknowns]
        arms = state.reshape(len(unknowns), -1, 3).copy()
        arms[:, 0] -= middle
        moments = np.cross(arms, own)
        force, moment = force + own[:, 0].sum(axis=0), moment + moments.sum(axis=(0, 1))
        size += float(np.linalg.norm(own[:, 0], axis=1).sum())
        turning += float(np.linalg.norm(moments.sum(axis=1), axis=1).sum())
        assert isinstance(rod, Beam) or own.shape[1] == 1
    return float(np.linalg.norm(force)), float(np.linalg.norm(moment)), size, turning


def with_slowness(outcomes: Sequence[Outcome]) -> list[Outcome]:
    """Calls those slow that took several times the median of iterations, or more increments than asked for."""
    counts = [outcome.iterations for outcome in outcomes if outcome.status == CONVERGED]
    median = float(np.median(counts)) if counts else np.inf
    return [
        (
            replace(outcome, status=SLOW)
            if outcome.status == CONVERGED
            and (outcome.cuts or outcome.iterations > SLOWNESS * median)
            else outcome
        )
        for outcome in outcomes
    ]
