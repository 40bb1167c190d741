"""First guesses: what is free follows what is held."""

import numpy as np
import pytest

from braidx.rods import Beam, Cable, Rods, YarnMaterial, helix, straight
from braidx.rods.first_guess import follow_supports

LINE = straight((0, 0, 0), (10, 0, 0), 8)
STEEL = YarnMaterial.isotropic(1e3, 0.3)


def asked(rods, share):
    """The system of the next equilibria, asked for a share of the way, and a guess that moves what is held alone."""
    equilibria = rods._equilibria
    equilibria.prepare()
    equilibria._ask_for(share)
    system = equilibria.system
    return system, system.expand(system.free_values(rods.q))


def cantilever():
    rods = Rods([Beam(LINE, 0.5, STEEL)])
    rods.clamp(0, [0, -1])
    return rods


def test_a_small_motion_leaves_hardly_any_residual():
    rods = cantilever()
    residuals = []
    for by in (2e-3, 1e-3):
        rods.supports.finish(0.0)
        rods.move(0, -1, by=(0.0, by, 0.0), turn=(0.0, 0.0, by))
        system, moved = asked(rods, 1.0)
        guess = follow_supports(system, rods.layout, rods.contact, rods.q, rods.q)
        norms = []
        for state in (moved, guess):
            system.set_state(state)
            norms.append(np.linalg.norm(system.constraints.reduce(system.residual())))
        assert norms[1] < 1e-2 * norms[0]
        residuals.append(norms[1])
    assert residuals[0] == pytest.approx(4.0 * residuals[1], rel=0.2)  # of second order


def test_the_tangent_along_a_direction_is_that_of_finite_differences():
    lines = [straight((-5, 0, 0), (5, 0, 0), 8), straight((0, -5, 0.95), (0, 5, 0.95), 8)]
    rods = Rods([Beam(lines[0], 0.5, STEEL), Cable(lines[1], 0.5, 1e3, tension=10.0)], friction=0.2)
    system = rods._equilibria.system
    rods.contact.start = rods.q
    rods.contact.update(rods.q)
    random = np.random.default_rng(0)
    state = rods.q + 1e-3 * random.normal(size=rods.q.size)
    direction, h = random.normal(size=rods.q.size), 1e-7
    system.set_state(state)
    tangent = system.tangent_times(direction)
    forces = []
    for sign in (1.0, -1.0):
        system.set_state(state + sign * h * direction)
        forces.append(system.residual())
    difference = (forces[0] - forces[1]) / (2.0 * h)
    assert tangent == pytest.approx(difference, abs=1e-5 * np.abs(difference).max())


def tip(rods):
    """Where a guess takes the last node of a rod, across it; None without a guess."""
    system, _ = asked(rods, 1.0)
    guess = follow_supports(system, rods.layout, rods.contact, rods.q, rods.q)
    return None if guess is None else guess[rods.layout.unknowns(0, -1)[0, 1]]


def test_a_section_that_turns_takes_a_free_end_along():
    rods = Rods([Beam(LINE, 0.5, STEEL)])
    rods.clamp(0, 0)
    rods.move(0, 0, turn=(0.0, 0.0, 0.01))
    assert tip(rods) == pytest.approx(0.1, rel=1e-3)


def test_guesses_that_go_too_far_are_none():
    """Two nodes near each other, held like a hand that swings a rod: its end would go eight times as far."""
    rods = Rods([Beam(LINE, 0.5, STEEL)])
    rods.pin(0, [0, 1])
    rods.hold(0, 0, 8)  # no spin
    rods.move(0, 1, by=(0.0, 0.01, 0.0))
    assert tip(rods) is None


def test_a_bent_strand_needs_few_iterations():
    """Three wires about a fourth, turned by 0.1 radians at one end."""
    parts = [Beam(straight((0, 0, 0), (0, 0, 30), 16), 1.0, STEEL)]
    parts += [Beam(helix(1.99, 30, 30, 16, phase), 1.0, STEEL) for phase in (0.0, 2.1, 4.2)]
    rods = Rods(parts, friction=0.15, tolerance=1e-6, penalty=100.0)
    for wire in range(4):
        rods.clamp(wire, -1)
        rods.hold(wire, 0, slice(0, 2))
        rods.hold(wire, 0, slice(3, 9))
        rods.move(wire, -1, turn=(0.0, 0.1, 0.0), about=(0.0, 0.0, 15.0))
    (increment,) = rods.solve()
    assert (
        increment.iterations <= 10
    )  # one that moves what is held alone has to be cut, and takes 23


def test_means_of_some_components_are_held():
    rods = Rods([Cable(line, 0.3, 1e3, tension=5.0) for line in (LINE, LINE + [0, 3, 0])])
    for cable in (0, 1):
        rods.pin(cable, 0)
        rods.hold(cable, -1, 2)
    group = rods.hold_mean([(0, -1), (1, -1)], [0, 1])
    rods.force(0, -1, (0.0, 1.0, 0.0))
    rods.move_mean(group, by=(0.5, 0.2))
    rods.solve()
    ends = np.array([rods.positions(cable)[-1] for cable in (0, 1)])
    assert ends.mean(axis=0) == pytest.approx([10.5, 1.7, 0.0], abs=1e-9)
    assert ends[0, 1] > 0.21
    force, moment = rods.resultant([(0, -1), (1, -1)], about=(0.0, 0.0, 0.0))
    parts = [rods.reaction(cable, -1) for cable in (0, 1)]
    assert force == pytest.approx(parts[0][0] + parts[1][0])
    assert moment == pytest.approx(
        sum(np.cross(end, part[0]) for end, part in zip(ends, parts, strict=True))
    )
