"""Parallel yarns with groups of ends, and their run through steps; as a script, on several processes."""

import sys
from dataclasses import replace

import numpy as np
from mpi4py import MPI

from braidx.geometry import angles_of, best_fit
from braidx.processes.pull import hold, pull
from braidx.processes.start import make_model, start_state
from braidx.scene import (
    ContactOptions,
    EndConditions,
    EndGroup,
    Hold,
    Pull,
    RopeRecipe,
    Scene,
    StrandRecipe,
    YarnModel,
)

CLAMP = EndGroup(end="first", level="rope", rigid=True)
TURN = 60.0  # degrees
MEAN_TURN = EndGroup(
    end="last", level="rope", displacement={"x": "held", "y": "held"}, rotation={"z": TURN}
)
SIDE = EndGroup(
    end="last", level="yarn", which=(1,), force={"x": 0.03}
)  # kN: one end goes its own way
PROGRAMME = (Pull(to_strain=0.01, strain_increment=0.0025), Hold(increments=12))


def bundle(*groups, model="cable", steps=PROGRAMME, rings=(1, 6), radius=1.1):
    """The scene; rings of yarns at a distance of `radius` (mm) from the axis."""
    return Scene(
        rope=RopeRecipe(pitch=40.0, pitches=1, type="strand"),
        strand=StrandRecipe(rings=rings, helix_radius=radius),
        yarn=YarnModel(
            radius=0.5,
            axial_stiffness=1e5,
            model=model,
            elements_per_pitch=16,
            bundle_factor=0.1 if model == "beam" else 1e-3,
        ),
        contact=ContactOptions(friction=0.1),
        ends=EndConditions(transverse="free", groups=groups),
        steps=steps,
    )


def run(scene, comm=MPI.COMM_SELF):
    """All steps of a scene that forms nothing; the model and the outcomes of all increments."""
    state, outcomes = start_state(scene), []
    model = make_model(comm, scene, state)
    for step in scene.steps:
        for outcome in {Pull: pull, Hold: hold}[type(step)](model, state, step):
            outcomes.append(outcome)
            state = outcome.state
        state = state.next_step()
    return model, outcomes


def last_ends(model, q):
    """Positions of the last ends, shape (num_yarns, 3), mm."""
    return q[model.ends.nodes.last[:, None] + np.arange(3)]


def mean_rotation(model, q):
    """Tilts and turn of the last ends since the reference state, degrees."""
    now, before = last_ends(model, q), last_ends(model, model.start)
    return np.degrees(angles_of(best_fit(before - before.mean(axis=0), now - now.mean(axis=0))))


def main(path):
    """Writes unknowns, force and moment at the end of the programme."""
    scene = replace(bundle(CLAMP, MEAN_TURN), steps=(PROGRAMME[0], Hold(increments=5)))
    _, outcomes = run(scene, MPI.COMM_WORLD)
    last = outcomes[-1]
    if MPI.COMM_WORLD.rank == 0:
        np.savez(path, q=last.state.q, force=last.force, moment=last.moment)


if __name__ == "__main__":
    main(sys.argv[1])
