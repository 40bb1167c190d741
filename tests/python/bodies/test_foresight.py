"""The tangent after a step has the stresses that the step foresaw."""

import numpy as np
import pytest
from example_bodies import cached_body, dense_tangent, random_state


@pytest.mark.parametrize("degree", [1, 2])
def test_tangent_leaves_out_the_stresses_of_the_square_of_the_step(degree: int) -> None:
    # The energy W is quadratic in strains e that are quadratic in the unknowns. A step d adds e''(d, d) / 2 to what it
    # foresaw; stresses of that change d K d by C e''(d, d) e''(d, d) / 2, a sixth of the fourth derivative of W.
    # (Strains are quadratic where bundle and torsion factors agree: else curvature is divided by the stretch.)
    body = cached_body("beam of one factor", degree)
    q = random_state(body, 0.05)
    step = random_state(body, 0.2) - body.rest

    def energy(share: float) -> float:
        body.set_state(q + share * step)
        return body.energy()

    fourth = energy(2) - 4 * energy(1) + 6 * energy(0) - 4 * energy(-1) + energy(-2)
    body.set_state(q)
    plain = dense_tangent(body)
    body.set_step(step)
    foreseen = dense_tangent(body)
    body.set_step(np.zeros_like(step))
    d = step.ravel()
    assert d @ (plain - foreseen) @ d == pytest.approx(fourth / 6.0, rel=1e-9)
    assert np.abs(foreseen - foreseen.T).max() < 1e-12 * np.abs(foreseen).max()
    assert np.array_equal(dense_tangent(body), plain)
