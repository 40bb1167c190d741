"""Two parallel cables tied to a rigid body: bifilar suspension, and a force beside the centroid.

Cables of stiffness EA and length L at x = +-a, their first ends held. Turned by t about z, at a distance l0 between
their end sections, each has the length l = sqrt(l0^2 + 2 a^2 (1 - cos t)) and the tension T = EA (l / L - 1); the
moment about z is 2 T a^2 sin(t) / l, the force along z 2 T l0 / l. A force F along z at x = e is the force and a moment
-e F about y on the centroid: tensions are F (1 +- e / a) / 2, and the body tilts by the difference of elongations over
2 a.
"""

import numpy as np
import pytest
from mpi4py import MPI
from scipy.optimize import brentq

from braidx.geometry import angles_of, best_fit
from braidx.processes.pull import hold, pull
from braidx.processes.start import make_model, start_state
from braidx.scene import (
    EndConditions,
    EndGroup,
    Hold,
    Pull,
    RopeRecipe,
    Scene,
    StrandRecipe,
    YarnModel,
)

STIFFNESS, LENGTH, ARM, STRAIN = 1e5, 100.0, 5.0, 0.01  # N, mm, mm, -
PULL = Pull(to_strain=STRAIN, strain_increment=0.005)


def run(group, *steps):
    """Tension of each cable (N), angles of the body (radians), and the last outcome."""
    scene = Scene(
        rope=RopeRecipe(pitch=LENGTH, pitches=1, type="strand"),
        strand=StrandRecipe(rings=(2,), helix_radius=ARM),
        yarn=YarnModel(radius=0.5, axial_stiffness=STIFFNESS, elements_per_pitch=5),
        ends=EndConditions(transverse="fixed", groups=(group,)),
        steps=steps,
    )
    state = start_state(scene)
    model = make_model(MPI.COMM_SELF, scene, state)
    for step in steps:
        for outcome in {Pull: pull, Hold: hold}[type(step)](model, state, step):
            state = outcome.state
        state = state.next_step()
    last = model.ends.nodes.last[:, None] + np.arange(3)
    before, now = (q[last] - q[last].mean(axis=0) for q in (model.start, state.q))
    angles = angles_of(best_fit(before, now))
    assert np.linalg.norm(now[0] - now[1]) == pytest.approx(2 * ARM, abs=1e-3)
    return model.tension(state.q)[[0, -1]], angles, outcome


def bifilar(turn):
    """Moment (N mm) and force (N)."""
    distance = LENGTH * (1 + STRAIN)
    length = np.sqrt(distance**2 + 2 * ARM**2 * (1 - np.cos(turn)))
    tension = STIFFNESS * (length / LENGTH - 1)
    return 2 * tension * ARM**2 * np.sin(turn) / length, 2 * tension * distance / length


@pytest.mark.parametrize("turn", [40.0, 150.0])
def test_moment_and_force_of_a_turn(turn):
    body = EndGroup(end="last", level="rope", rigid=True, rotation={"z": turn})
    _, angles, outcome = run(body, PULL, Hold(increments=int(turn / 10)))
    moment, force = bifilar(np.radians(turn))
    assert np.cos(angles[2]) == pytest.approx(np.cos(np.radians(turn)), abs=1e-9)
    assert outcome.moment == pytest.approx(moment, rel=1e-6)
    assert outcome.force == pytest.approx(force, rel=1e-6)


def test_turn_of_a_moment():
    moment = 300.0
    body = EndGroup(end="last", level="rope", rigid=True, moment={"z": moment})
    _, angles, outcome = run(body, PULL, Hold(increments=8), Hold(increments=12))
    exact = brentq(lambda turn: bifilar(turn)[0] - moment, 0.0, 1.0)
    assert angles[2] == pytest.approx(exact, rel=1e-3)
    assert outcome.moment == pytest.approx(moment, rel=1e-3)
    assert outcome.force == pytest.approx(bifilar(exact)[1], rel=1e-3)


def test_force_beside_the_centroid():
    force, beside = 2000.0, 2.0
    body = EndGroup(
        end="last",
        level="rope",
        rigid=True,
        force={"z": force / 1e3},
        moment={"y": -beside * force},
    )
    tension, angles, outcome = run(body, Hold(increments=4), Hold(increments=4))
    assert outcome.force == pytest.approx(force, rel=1e-4)
    # Arms shorten by 1 - cos(tilt) = 0.3 %, and with them tensions differ from F (1 +- e / a) / 2 by 0.2 %.
    arm = ARM * np.cos(angles[1])
    assert tension == pytest.approx(
        force / 2 * np.array([1 + beside / arm, 1 - beside / arm]), rel=5e-4
    )
    elongation = tension / STIFFNESS * LENGTH
    assert np.sin(angles[1]) == pytest.approx(
        -(elongation[0] - elongation[1]) / (2 * ARM), rel=1e-3
    )
    assert outcome.strain == pytest.approx(elongation.mean() / LENGTH, rel=1e-3)
