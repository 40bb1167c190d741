"""Solids in a scene of rods: held, loaded and moved by their sections, like beams."""

import numpy as np
import pytest

from braidx.meshing import rectangle
from braidx.rods import Beam, Rods, Scheme, Solid, YarnMaterial, arc, straight

LENGTH, SIDE = 20.0, 1.0
MATERIAL = YarnMaterial.isotropic(1000.0, 0.0)
SECTION = rectangle(SIDE, SIDE, degree=2)
DENSITY = 1e-9


def bars(line=None, **options):
    """The same bar as a solid and as a beam, far from each other."""
    line = straight((0, 0, 0), (LENGTH, 0, 0), 20) if line is None else line
    frame = np.broadcast_to(np.eye(3)[1:], (len(line), 2, 3))
    solid = Solid(line, SIDE / 2, MATERIAL, SECTION, frame, density=DENSITY)
    beam = Beam(
        line + [0.0, 0.0, 50.0],
        SIDE / 2,
        MATERIAL,
        SECTION.beam_section(),
        frame,
        degree=2,
        density=DENSITY,
    )
    return Rods([solid, beam], contact=False, **options)


def same(rods, what, within=5e-3):
    """Whether solid and beam agree, but for what beams leave out: they are twenty times as long as thick."""
    solid, beam = (what(rod) for rod in (0, 1))
    return solid == pytest.approx(beam, rel=within, abs=within * max(1.0, np.abs(beam).max()))


def displacement(rods):
    return lambda rod: rods.positions(rod) - rods.rods[rod].line


@pytest.mark.parametrize("load", ["force", "line load", "force inside", "couple", "couple inside"])
def test_loads_bend_a_solid_like_a_beam(load):
    rods = bars()
    for rod in (0, 1):
        rods.clamp(rod, 0)
        if load.startswith("force"):
            rods.force(rod, -1 if load == "force" else 10, (0.0, 1.0, 0.3))
        elif load == "line load":
            rods.line_load(rod, (0.0, 0.0, -0.05))
        else:
            rods.couple(rod, -1 if load == "couple" else 10, (3.0, 0.0, 5.0))
    rods.solve(increments=2)
    assert np.abs(displacement(rods)(1)).max() > 1.0
    assert same(rods, displacement(rods))
    assert same(rods, lambda rod: rods.reaction(rod, 0)[0])
    assert same(rods, lambda rod: rods.reaction(rod, 0)[1])


def test_ends_move_and_turn():
    rods = bars()
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
        rods.move(rod, -1, by=(0.2, 0.5, 0.0), turn=(0.2, 0.0, 0.4))
    rods.solve(increments=4)
    assert same(rods, displacement(rods))
    assert same(rods, rods.directors)
    assert same(rods, lambda rod: rods.reaction(rod, -1)[1], 1e-2)
    assert same(rods, lambda rod: rods.tension(rod).mean(), 1e-2)


def test_what_holds_balances_what_pulls():
    rods = bars()
    for rod in (0, 1):
        rods.pin(rod, 0)
        rods.hold(rod, 0, [3, 4, 5])
        rods.hold(rod, -1, [1, 2])
        rods.line_load(rod, (0.0, 0.0, -0.05))
        rods.force(rod, 10, (0.0, 0.4, 0.0))
    rods.solve()
    assert np.abs(rods.residual()).max() < 1e-7
    outside = rods.external_forces()[rods.layout.is_director == False]  # noqa: E712
    assert np.abs(outside.reshape(-1, 3).sum(axis=0)).max() < 1e-7


def test_mean_of_solid_and_beam_is_held():
    rods = bars()
    for rod in (0, 1):
        rods.clamp(rod, 0)
    group = rods.hold_mean([(0, -1), (1, -1)])
    rods.move_mean(group, (0.0, 1.0, 0.0))
    rods.solve()
    ends = [displacement(rods)(rod)[-1, 1] for rod in (0, 1)]
    assert np.mean(ends) == pytest.approx(1.0)
    assert ends[0] == pytest.approx(ends[1], rel=5e-3)


@pytest.mark.parametrize("hold", [Rods.clamp, Rods.pin, lambda rods, *at: rods.hold_mean([at])])
def test_sections_between_ends_cannot_be_held(hold):
    rods = bars()
    with pytest.raises(ValueError, match="node 7 of rod 0 cannot be held: of a solid"):
        hold(rods, 0, 7)


def test_a_guess_moves_the_whole_solid():
    """The bar placed along an arc finds back to where it is held, section by section."""
    rods = bars()
    for rod in (0, 1):
        rods.clamp(rod, 0)
    line = arc(200.0, LENGTH / 200.0, 20)
    rods.solve(guess={0: line, 1: line + [0.0, 0.0, 50.0]})
    assert np.abs(displacement(rods)(0)).max() < 1e-6


def test_tension_at_rest():
    line = straight((0, 0, 0), (LENGTH, 0, 0), 8)
    rods = Rods([Solid(line, 0.5, MATERIAL, tension=12.0)])
    rods.clamp(0, [0, -1])
    rods.solve()
    assert rods.tension(0) == pytest.approx(12.0)
    assert rods.reaction(0, -1)[0] == pytest.approx([12.0, 0.0, 0.0], abs=1e-9)


def test_swings_like_a_beam():
    rods = bars()
    for rod in (0, 1):
        rods.clamp(rod, 0)
        rods.force(rod, -1, (0.0, 0.1, 0.0))
    rods.solve()
    drawn = displacement(rods)(0)[-1, 1]
    for rod in (0, 1):
        rods.force(rod, -1, (0.0, 0.0, 0.0))
    period = 2.0 * np.pi / 3.516 * np.sqrt(DENSITY * LENGTH**4 / (1000.0 / 12.0))
    rods.run(0.05 * period, 0.05 * period)  # lets go
    energy = rods.elastic_energy() + rods.kinetic_energy()
    rods.run(0.45 * period, 0.025 * period, scheme=Scheme.generalised_alpha(1.0))
    assert same(rods, displacement(rods))
    assert displacement(rods)(0)[-1, 1] < -0.8 * drawn
    assert rods.elastic_energy() + rods.kinetic_energy() == pytest.approx(energy, rel=0.02)


def test_solids_touch_each_other_and_beams():
    """Three rods in a pile, the middle one a beam: normal forces are those of the supports."""
    lines = [
        straight((-5, 0, 0), (5, 0, 0), 10),
        straight((0, -5, 2), (0, 5, 2), 10),
        straight((-5, 0, 4), (5, 0, 4), 10),
    ]
    material = YarnMaterial.isotropic(1000.0, 0.3)
    kinds = (Solid, Beam, Solid)
    rods = Rods([kind(line, 1.0, material) for kind, line in zip(kinds, lines)])
    for rod in (0, 2):
        rods.clamp(rod, [0, -1])
    rods.hold(1, [0, -1], [0, 1])
    rods.move(2, [0, -1], by=(0.0, 0.0, -0.2))
    rods.solve(increments=2)
    contacts = rods.contacts()
    assert {tuple(sorted(pair)) for pair in contacts["tubes"].tolist()} == {(0, 1), (1, 2)}
    up = sum(rods.reaction(0, end)[0][2] for end in (0, -1))
    for pair in [(0, 1), (1, 2)]:
        own = [tuple(sorted(p)) == pair for p in contacts["tubes"].tolist()]
        across = contacts["normal_force"][own] * contacts["normal"][own, 2]
        assert abs(across.sum()) == pytest.approx(up, rel=1e-5)
    assert up > 1.0


def test_a_solid_is_drawn(tmp_path):
    rods = bars()
    assert rods.draw(tmp_path / "bars.png", by_tension=True).stat().st_size > 1000
