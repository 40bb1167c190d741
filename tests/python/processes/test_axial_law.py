"""yarn.axial_law: a law of beams, and refused where there are none."""

import numpy as np
import pytest
from mpi4py import MPI

from braidx.processes.yarns import beam_body
from braidx.scene import RopeRecipe, Scene, SceneError, Settle, StrandRecipe, YarnModel

STRAIN, STIFFNESS = 0.01, 1e5


def force(law):
    """Of one straight yarn, N."""
    scene = Scene(
        rope=RopeRecipe(pitch=40.0, pitches=1, type="strand"),
        strand=StrandRecipe(rings=(1,)),
        yarn=YarnModel(
            radius=1.0,
            model="beam",
            degree=1,
            axial_stiffness=STIFFNESS,
            axial_law=law,
            poisson_axial=0.0,
        ),
        steps=(Settle(),),
    )
    line = np.zeros((5, 9))
    line[:, 2], line[:, 3], line[:, 7] = np.linspace(0.0, 10.0, 5), 1.0, 1.0
    body = beam_body(MPI.COMM_SELF, scene, [line], 0.0)
    line[:, 2] *= 1.0 + STRAIN
    return body.tension(line)


def test_the_linear_law_takes_off_what_the_other_has_more():
    assert force("linear") == pytest.approx(np.full(4, STIFFNESS * STRAIN))
    stretch = 1.0 + STRAIN
    expected = STIFFNESS * stretch * (stretch**2 - 1.0) / 2.0
    assert force("Saint-Venant-Kirchhoff") == pytest.approx(np.full(4, expected))


def test_a_law_of_beams_is_refused_where_there_are_none():
    with pytest.raises(SceneError, match="yarn.axial_law"):
        YarnModel(radius=1.0, model="cable", axial_law="linear")
    YarnModel(radius=1.0, model="cable", models={"2": "beam"}, axial_law="linear")
