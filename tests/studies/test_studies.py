"""What paper 2 says of its studies, as trends. Hours where nothing was computed yet; runs are kept in results/studies.

./braidx test --studies
"""

import functools

import braiding_angle
import diameter_ratio
import mesh_sensitivity
import models
import numpy as np
import pytest
import yarn_count
import yarn_radius
from bent_values import NEAR_CROWN, SLIP
from study import OUT
from study_report import report
from study_runs import run_study

SCRIPTS = (diameter_ratio, braiding_angle, yarn_count, yarn_radius, mesh_sensitivity, models)
WRONG_SIDE = "crossings on the wrong side"


@functools.cache
def outcomes_of(script):
    """All cases, with table and figure as the script writes them."""
    study = script.study()
    outcomes = run_study(study, OUT)
    report(study, outcomes, OUT)
    return outcomes


def column(script, name):
    """One number per case; every case has to have it."""
    outcomes = outcomes_of(script)
    assert {outcome.case.label: outcome.failure for outcome in outcomes if outcome.failure} == {}
    return np.array([outcome.values[name] for outcome in outcomes])


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.__name__)
def test_every_case_converges_and_keeps_its_motif(script):
    assert (column(script, WRONG_SIDE) == 0).all()
    assert np.isfinite(column(script, SLIP)).all()


@pytest.mark.parametrize("name", [SLIP, NEAR_CROWN])
def test_relative_displacement_falls_with_the_diameter_ratio(name):
    assert (np.diff(column(diameter_ratio, name)) < 0.0).all()


@pytest.mark.parametrize("name", [SLIP, NEAR_CROWN])
def test_relative_displacement_rises_with_the_braiding_angle(name):
    assert (np.diff(column(braiding_angle, name)) > 0.0).all()


def spread(values):
    return np.ptp(values) / values.mean()


@pytest.mark.parametrize("script", [yarn_count, yarn_radius], ids=lambda script: script.__name__)
def test_number_and_radius_of_yarns_matter_less_than_diameter_and_angle(script):
    """Of braids that cover more than half of the rope: 8 thin yarns leave it open, and slide more (docs/bending.md)."""
    values = column(script, SLIP)[1 if script is yarn_count else 0 :]
    others = [spread(column(other, SLIP)) for other in (diameter_ratio, braiding_angle)]
    assert spread(values) < min(others)
