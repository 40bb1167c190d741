"""Forming: the equilibrium shape of a rope, found from interpenetrating helices (paper 1, 3).

Cables under one constant tension are separated by the stacking order of their strands, gaps being reduced
step by step (eq. 6), within a die if there is one. Once no yarn is on the wrong side and the deepest
penetration is moderate, the penalty is raised step by step until yarns hardly penetrate. At last the rope comes to
rest with friction, consistent pairs and penetrations within the tolerance. Yarns that leave a die keep the lengths that
they have in it: they get their real stiffness, and one end section carries the force that the rope was formed under.
A cable under constant tension has no material memory: until it rests, nodes are spread evenly before each increment.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import braidx_engine as engine
import numpy as np
from scipy.interpolate import CubicSpline

from ..geometry import one_for_all
from ..output.log import LOGGER
from ..scene import Form, Scene
from ..solver.increment import Diverged, Increment, IncrementOptions
from ..system.constraints import Floats
from .directors import with_directors
from .model import RopeModel
from .outcome import NotConverged, Outcome
from .rope_contact import AXIS, core_walls, set_friction
from .sharp_bends import HOOKED, sharpest_bend
from .state import State

STRETCH = 10.0  # axial stiffness over tension: holds nodes apart within an increment
DENSER = 0.7  # penetration over radius below which stations stand as dense as they will
PRESSED = 0.06  # penetration over radius at which nodes are no longer spread
PRESS_ON = (
    1.5  # factor on the penalty that would just bring yarns to the tolerance when they come to rest
)
OPENING = 0.05  # growth of the bore's radius over that of a yarn, per increment, until
RELEASED = 0.005  # the share of all normal forces that acts on the bore is smaller than this
RAISE = 2.0  # factor on the penalty, every RAISE_EVERY increments once stations are dense, or without progress
RAISE_EVERY = 4
STUCK = 0.98  # share of the least penetration until now that an increment has to come below for progress
COARSER = 2.0  # factor on the spacing of stations until then
PASSING = (1e-2, 8)  # tolerance and iterations of Newton for states that are only passed through
REST = 2  # increments that the rope is given to come to rest, with consistent pairs
ONCE_MORE = {"rested": REST - 1.0, "stiffening": 1.0}  # comes to rest after a part of it did
AT_REST = 20  # contact updates in which it has to; those that do take a few
RETRIES = 4  # doublings of the viscosity before forming gives up
SNAPSHOTS = 4  # pictures on the way


def in_die(scene: Scene, state: State) -> bool:
    """Whether a rope being formed is in its die."""
    return _has_die(scene, state) and state.model == "cell"


def keeps_lengths(scene: Scene, state: State) -> bool:
    """Whether a rope being formed has left its die: yarns keep the lengths that they had in it."""
    return _has_die(scene, state) and state.model != "cell"


def _has_die(scene: Scene, state: State) -> bool:
    step = scene.steps[state.step]
    return isinstance(step, Form) and step.die_diameter is not None


def form(model: RopeModel, state: State, step: Form) -> Iterator[Outcome]:
    """Separates, compacts, and releases.

    Raises:
        NotConverged: If an increment fails, or yarns still penetrate or lie on the wrong side at the end.
    """
    former = Former(model, state, step)
    while not former.finished:
        yield former.increment()
    former.check()


class Former:
    """The forming of one rope; all its numbers are in state.progress, so that it can go on from a checkpoint."""

    def __init__(self, model: RopeModel, state: State, step: Form) -> None:
        self.model, self.state, self.step = model, state, step
        scene, radius = model.scene, float(model.rope.radius.min())
        self._tolerance = scene.contact.penetration_tolerance * radius
        self._radius = radius
        element = scene.rope.pitch / scene.yarn.elements_per_pitch
        self._viscosity = step.viscosity * step.tension / element
        self._in_die, self._keeps_lengths = in_die(scene, state), keeps_lengths(scene, state)
        self._beams = model.body.block == 9
        self._turning = element**2 if self._keeps_lengths or self._beams else 0.0
        contact = model.contact
        set_friction(contact, 0.0, 0.0)
        # A rope that is far from its rest gains nothing from the exact tangent.
        contact.symmetrised = True
        contact.laws.gap_step = step.gap_reduction * radius
        contact.pairing.keep_side = False
        self._spacing = contact.pairing.spacing
        # Whatever it is made of: yarns under a small tension find their places on it.
        self._core = core_walls(scene)
        self._number = {
            "done": 0.0,
            "separated": 0.0,
            "penalty": step.penalty * step.tension / radius**2,
            "raised": 0.0,
            "least": np.inf,
            "dense": 0.0,
            "pressed": 0.0,
            "opening": 0.0,
            "open": float(step.die_diameter is None),
            "rested": 0.0,
            "stiffening": 1.0,
            **state.progress,
        }
        if self._keeps_lengths:
            model.pull_by(state.results["formed_force"])

    @property
    def finished(self) -> bool:
        """Whether this stage of forming is over, or the increments are used up."""
        return self._has_come or self._number["done"] >= self.step.increments

    @property
    def _has_come(self) -> bool:
        return bool(self._number["pressed"]) if self._in_die else self._number["rested"] >= REST

    def increment(self) -> Outcome:
        """One increment of forming."""
        number = self._number
        self._prepare()
        increment = self._solve()
        number["done"] += 1
        self._advance(increment)
        force = self.model.axial_force(increment.q)
        self.state = replace(
            self.state,
            q=increment.q,
            reference=self.model.body.rest.ravel().copy(),
            rest_tension=self.model.tension(increment.q),
            contacts=self.model.contact.arrays(),
            progress=dict(number),
            friction_work=self.state.friction_work + self.model.copies * increment.friction_work,
        )
        every = max(1, self.step.increments // (2 * SNAPSHOTS))
        name = f"forming {number['done']:.0f}" if number["done"] % every == 0 else None
        return Outcome(
            self.state,
            increment,
            min(1.0, number["done"] / self.step.increments),
            None,
            force,
            cost=(increment.iterations, increment.linear_solves),
            snapshot=self._stage if self.finished else name,
        )

    @property
    def _stage(self) -> str:
        """Name of the state that this stage ends with."""
        if self._in_die:
            return "in the die"
        names = (
            {} if one_for_all(self.model.scene) else {"cell": "one pitch", "released": "released"}
        )
        return names.get(self.state.model, "formed")

    def check(self) -> None:
        """Raises NotConverged unless the shape found is one of yarns that do not penetrate."""
        contact = self.model.contact
        contact.set_state(self.state.q)
        deepest = contact.deepest_penetration(self.state.q)
        wrong = self.model.wrong_side_crossings(self.state.q)
        if not self._has_come or wrong:
            pairs = ", ".join(f"{a}-{b}" for a, b in contact.worst_pairs())
            raise NotConverged(
                f"the rope is not formed after {self._number['done']:.0f} increments: penetration {deepest:.3f} mm "
                f"(wanted {self._tolerance:.3f}), {wrong} crossings on the wrong side, "
                f"deepest between yarns {pairs or 'none'}; "
                "try a larger form.die_diameter or braid.helix_radius, more form.increments, or thinner yarns"
            )

    def _prepare(self) -> None:
        """Spreads nodes evenly and renews the tension, unless the rope rests already; puts the die in its place."""
        model, number, contact = self.model, self._number, self.model.contact
        contact.pairing.stiffness = number["penalty"]
        contact.pairing.spacing = self._spacing * (1.0 if number["dense"] else COARSER)
        contact.pairing.crossing.by_point = bool(number["separated"])
        if not number["rested"] and not self._keeps_lengths:
            q = spread_nodes(model.centre_lines(self.state.q))
            q = with_directors(model.scene, q) if self._beams else q
            model.set_reference(q)
            self.state = replace(self.state, q=q)
            contact.elements = engine.ContactElements()
            contact.pairing.stiffness *= number["stiffening"]
            number["stiffening"] = 1.0
        stretch, real = STRETCH * self.step.tension, model.scene.yarn.axial_stiffness
        model.set_yarns(self.step.tension, real if self._keeps_lengths else stretch)
        contact.rigid = self._core
        if self.step.die_diameter is not None and not number["open"]:
            bore = self.step.die_diameter / 2 + number["opening"]
            contact.rigid = [*self._core, engine.make_cylinder(0 * AXIS, AXIS, bore, True, 0)]

    def _solve(self) -> Increment:
        newton, contact, number = self.model.newton, self.model.contact, self._number
        options = IncrementOptions(max_updates=1, in_passing=True)
        newton.tolerance, newton.max_iterations = PASSING
        newton.bold = False
        if number["pressed"] and number["open"]:
            options = IncrementOptions(penetration=self._tolerance, max_updates=AT_REST)
            newton.restore_options()
            newton.bold = True
            contact.laws.gap_step = -1.0
            set_friction(contact, *self._friction_at_rest())
        for retry in range(RETRIES + 1):
            viscosity = self._viscosity * 2**retry
            self.model.set_viscosity(viscosity, self._turning * viscosity)
            try:
                return self.model.incrementer.solve(
                    self.state.q, self.state.q, options, number["stiffening"]
                )
            except Diverged as failure:
                LOGGER.warning("forming: %s; stabilisation doubled", failure)
                last = failure
            bend, yarn = sharpest_bend(
                self.model.centre_lines(self.state.q), self.model.rope.radius
            )
            if retry and bend <= HOOKED:
                break  # more stabilisation does not help, either
        cure = "try a smaller form.gap_reduction, a higher form.viscosity or a larger form.die_diameter"
        if bend <= HOOKED:
            cure = (
                f"yarn {yarn} is bent to {bend:.2g} times its radius, hooked into others: try a longer rope.pitch, "
                "thinner yarns or a thick core"
            )
        raise NotConverged(
            f"forming stopped: {last}; deepest contacts between yarns {last.deepest}; {cure}"
        )

    def _friction_at_rest(self) -> tuple[float, float]:
        """Coefficients of friction between yarns and on the core while the rope comes to rest."""
        own, given = self.step.friction, self.model.scene.contact
        if own is not None:
            return own, own
        return given.friction_of("yarn-yarn"), given.friction_of("yarn-core")

    def _advance(self, increment: Increment) -> None:
        """What the next increment does: separate, raise the penalty, rest."""
        number, depth = self._number, increment.penetration / self._radius
        number["stiffening"] = 1.0
        if not number["separated"]:
            number["separated"] = float(self.model.wrong_side_crossings(increment.q) == 0)
            self._raise_where_stuck(depth)
        elif not number["dense"]:
            number["dense"] = float(depth < DENSER)
            self._raise_where_stuck(depth)
        elif not number["open"] and self._keeps_lengths:
            number["open"] = float(self.model.contact.rigid_share(increment.q) < RELEASED)
            number["opening"] += OPENING * self._radius
        elif number["pressed"]:
            number["rested"] += 1
        elif depth < PRESSED:
            number["pressed"] = 1.0
            number["stiffening"] = PRESS_ON * max(1.0, increment.penetration / self._tolerance)
        else:
            self._raise_at_times()

    def _raise_where_stuck(self, depth: float) -> None:
        """Raises the penalty where yarns do not come apart any more, being no match for the tension."""
        number = self._number
        if depth < STUCK * number["least"]:
            number["least"], number["raised"] = depth, number["done"]
        else:
            self._raise_at_times()
        if number["dense"]:
            number["raised"] = number["done"]

    def _raise_at_times(self) -> None:
        number = self._number
        if number["done"] - number["raised"] >= RAISE_EVERY:
            number["penalty"] *= RAISE
            number["raised"] = number["done"]


def spread_nodes(lines: tuple[Floats, ...]) -> Floats:
    """Nodes at equal arc lengths along smooth curves through the given ones, shape (3 num_nodes,), mm."""
    spread = []
    for line in lines:
        arc = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
        spread.append(CubicSpline(arc, line)(np.linspace(0.0, arc[-1], len(line))))
    return np.concatenate(spread).ravel()
