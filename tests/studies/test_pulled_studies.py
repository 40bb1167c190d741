"""What paper 1 says of its rope, as its studies judge it. Long where nothing was computed yet; runs are kept in
results/studies. Once all cases of a study have run, its page in docs/ is written anew.

./braidx test --studies
"""

import functools

import bedding_in
import friction_coefficient
import pitch_length
import pytest
import sensitivity
from missed import MISSED
from pulled_values import PENETRATION, WRONG_SIDE, curve_of
from study import DOCS, OUT
from study_page import column
from study_runs import run_study

SCRIPTS = (pitch_length, friction_coefficient, bedding_in, sensitivity)


@functools.cache
def outcomes_of(script):
    """All cases, with page and images as the script writes them; every case has to converge."""
    study = script.study()
    outcomes = run_study(study, OUT)
    failures = {outcome.case.label: outcome.failure for outcome in outcomes if outcome.failure}
    script.PAGE.report()(study, outcomes, OUT if failures else DOCS)
    assert failures == {}
    return outcomes


def named(script):
    return script.__name__


@pytest.mark.parametrize("script", SCRIPTS, ids=named)
def test_every_case_is_an_equilibrium_with_its_motif(script):
    outcomes = outcomes_of(script)
    assert max(column(outcomes, WRONG_SIDE)) == 0
    assert max(column(outcomes, PENETRATION)) <= 0.02
    # Under the largest force: the elastic energy of a rope that is nearly slack is no measure.
    for curve in (curve_of(outcome.folder) for outcome in outcomes):
        assert curve.held[curve.force.argmax()] <= 0.01


@pytest.mark.parametrize("script", SCRIPTS, ids=named)
def test_statements_of_the_paper(script):
    claims = script.claims(outcomes_of(script))
    assert {claim.name for claim in claims if not claim.holds} == set(MISSED[script.PAGE.name])
