"""Frontiers of stability, held where they were found; see docs/stability.md, which this run writes."""

from __future__ import annotations

import pytest

import birdcage
import crossing_angle
import ends
import forming
import friction
import hockling
import knots
import large_increments
import mismatch
import penalty
import random_scenes
import refinement
import remedies
import ropes
import scenes
import slack
import slenderness
import units
from families import FAMILIES
from family import Family, cases_with, explore, good, none_is_wrong
from judge import CONVERGED, FAILED, REFUSED, Watch
from rope_recipes import NUMBER


@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.name)
def test_nothing_fails_in_silence(family: Family) -> None:
    assert none_is_wrong(explore(family))


def test_held_ends_within_each_other_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(scenes, "CLEAR", 0.0)
    rods = scenes.crossing(2.0)
    watch = Watch(rods)
    scenes.press(rods, watch)
    assert watch.outcome().status == FAILED
    assert "rod 0 and node 0 of rod 1 would be" in watch.message


def test_soft_penalties_help() -> None:
    outcomes = explore(remedies.FAMILY)
    soft = float([name for name, _ in remedies.REMEDIES].index("penalty 0.01 E"))
    for angle in (1.0, 2.0, 5.0):
        assert outcomes[angle, soft].iterations < 0.7 * outcomes[angle, 0.0].iterations


def test_slender_beams_are_right_in_any_number_of_increments() -> None:
    bent, rolled = explore(slenderness.BENT), explore(slenderness.ROLLED)
    assert good(bent) == set(bent)
    assert good(rolled) == {case for case in rolled if case[0] > 10.0}


def test_viscosity_leaves_forces_as_they_are() -> None:
    outcomes = explore(remedies.FAMILY)
    viscous = float([name for name, _ in remedies.REMEDIES].index("viscosity 1e-3 N/mm"))
    for angle in (1.0, 2.0, 5.0, 20.0):
        lift = outcomes[angle, 0.0].values["lift"]
        assert outcomes[angle, viscous].values["lift"] == pytest.approx(lift, rel=1e-3)


def test_eight_elements_will_do_for_any_slenderness() -> None:
    outcomes = explore(refinement.FAMILY)
    assert good(outcomes) == set(outcomes)


def test_beams_cross_at_half_a_degree() -> None:
    outcomes = explore(crossing_angle.FAMILY)
    assert good(outcomes) == set(outcomes)
    assert all(case in cases_with(outcomes, CONVERGED) for case in outcomes if case[0] >= 5.0)


def test_friction_up_to_one_with_reversal() -> None:
    outcomes = explore(friction.FAMILY)
    assert good(outcomes) == set(outcomes)
    for (coefficient, angle), outcome in outcomes.items():
        assert abs(outcome.values["ahead"]) == pytest.approx(abs(outcome.values["back"]), rel=1e-3)
        if angle >= 30.0:
            assert outcome.values["ahead"] == pytest.approx(coefficient, abs=0.015)


def test_penalties_over_six_decades() -> None:
    outcomes = explore(penalty.FAMILY)
    assert good(outcomes) == set(outcomes)
    assert cases_with(outcomes, CONVERGED) >= {case for case in outcomes if case[0] <= 100.0}


def test_units_do_not_matter() -> None:
    outcomes = explore(units.FAMILY)
    assert max(outcome.values["error"] for outcome in outcomes.values()) < 1e-8


def test_meshes_of_one_to_twenty() -> None:
    outcomes = explore(mismatch.FAMILY)
    assert good(outcomes) == set(outcomes)
    for outcome in outcomes.values():
        assert outcome.values["force over that of fine meshes"] == pytest.approx(1.0, abs=0.01)


def test_increments_of_a_hundred_times() -> None:
    outcomes = explore(large_increments.FAMILY)
    assert good(outcomes) == set(outcomes)
    for outcome in outcomes.values():
        assert outcome.values["lift over that of small increments"] == pytest.approx(1.0, abs=1e-3)


def test_the_way_to_a_formed_rope_does_not_show_in_it() -> None:
    outcomes = explore(forming.FAMILY)
    assert good(outcomes) >= {case for case in outcomes if case[1] < 1e4}


def test_knots_are_tightened_until_they_lock() -> None:
    outcomes = explore(knots.FAMILY)
    assert good(outcomes) >= {case for case in outcomes if case[1] >= 40.0}
    # A locked knot is pulled far harder for each radius than a loose one, and the harder the rougher it is.
    for rough in knots.FRICTIONS:
        force = [outcomes[rough, left].values["force"] for left in (120.0, 80.0, 60.0, 40.0)]
        assert force[3] - force[2] > 2.5 * (force[1] - force[0])
    assert outcomes[0.5, 40.0].values["force"] > 3.0 * outcomes[0.0, 40.0].values["force"]


def test_parallel_fibres_drag_by_their_coefficient_of_friction() -> None:
    outcomes = explore(ends.FAMILY)
    for (_, coefficient), outcome in outcomes.items():
        assert outcome.values["drag"] == pytest.approx(coefficient, abs=0.01)


@pytest.mark.parametrize(
    "family",
    [ends.FAMILY, birdcage.FAMILY, slack.STRAND, slack.BRAID, hockling.FAMILY],
    ids=lambda f: f.name,
)
def test_most_of_the_hard_scenes_are_solved(family: Family) -> None:
    outcomes = explore(family)
    assert len(good(outcomes)) >= FRONTIERS[family.name]


def test_random_scenes_are_solved_or_fail_with_a_message() -> None:
    outcomes = explore(random_scenes.FAMILY)
    assert len(good(outcomes)) >= FRONTIERS["random"]


def test_random_ropes_are_found_or_fail_with_a_message() -> None:
    outcomes = explore(ropes.FAMILY)
    assert len(outcomes) == NUMBER
    assert len(cases_with(outcomes, REFUSED)) <= 0.05 * NUMBER
    assert len(good(outcomes)) >= FRONTIERS["ropes"]
    failed = [outcomes[case] for case in cases_with(outcomes, FAILED)]
    assert all(outcome.why for outcome in failed)


# Scenes that converge (found, where a few may come and go: random 38, ropes 166).
FRONTIERS = {
    "ends": 12,
    "birdcage": 12,
    "slack_strand": 24,
    "slack_braid": 29,
    "hockling": 7,
    "random": 36,
    "ropes": 160,
}
