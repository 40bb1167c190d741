"""Where a Newton iteration spends its time, at the last state of a run.

    ./braidx shell python3 tests/benchmark/newton_step.py RUN

Prints the median seconds of a contact update and of the parts of an iteration: forms, contact, assembly, linear solve.
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from mpi4py import MPI
from petsc4py import PETSc

from braidx.processes import state as checkpoint
from braidx.processes.model import RopeModel
from braidx.processes.start import make_model
from braidx.scene import load_scene
from braidx.system.terms import BodyTerm


def load_model(folder: Path) -> tuple[RopeModel, checkpoint.State]:
    """The model of a run and its last state."""
    state = checkpoint.load(folder)
    if state is None:
        raise SystemExit(f"{folder}: no checkpoint")
    scene = load_scene(folder / "scene.toml")
    model = make_model(MPI.COMM_SELF, scene, state)
    model.measure(float(np.mean(model.tension(state.q))))
    return model, state


def median_seconds(action: Callable[[], object], repeats: int) -> float:
    seconds = []
    for _ in range(repeats):
        start = time.perf_counter()
        action()
        seconds.append(time.perf_counter() - start)
    return statistics.median(seconds)


def step_costs(model: RopeModel, state: checkpoint.State, repeats: int = 5) -> dict[str, float]:
    """Seconds of each part, in the order of a Newton step."""
    system, contact, q = model.system, model.contact, state.q
    body = next(term for term in system.terms if isinstance(term, BodyTerm))
    costs = {"contact update": median_seconds(lambda: contact.update(q), repeats)}
    costs["pattern"] = median_seconds(system.update_pattern, repeats)
    system.set_state(q)
    residual = system.residual().copy()
    costs["forms: residual"] = median_seconds(lambda: body.add_residual(residual), repeats)
    costs["forms: tangent"] = median_seconds(body.tangent_values, repeats)
    costs["contact: residual"] = median_seconds(lambda: contact.add_residual(residual), repeats)
    costs["contact: tangent"] = median_seconds(contact.tangent_values, repeats)
    costs["all residual"] = median_seconds(lambda: system.assemble_residual(system.vector), repeats)
    costs["all tangent"] = median_seconds(system.assemble_tangent, repeats)
    costs["linear solve"] = median_seconds(lambda: solve(model), repeats)
    return costs


def solve(model: RopeModel) -> None:
    """Factorises the tangent as it is and solves once."""
    system, symmetric = model.system, model.newton.options.symmetric
    ksp = PETSc.KSP().create(system.comm)
    ksp.setType("preonly")
    ksp.getPC().setType("cholesky" if symmetric else "lu")
    ksp.getPC().setFactorSolverType("cholmod" if symmetric else "mumps")
    ksp.setOperators(system.matrix)
    ksp.solve(system.vector, system.vector.duplicate())
    ksp.destroy()


def main() -> None:
    model, state = load_model(Path(sys.argv[1]))
    elements = len(model.contact.elements)
    print(f"{model.system.num_free} unknowns, {elements} contact elements, median seconds:")
    for name, seconds in step_costs(model, state).items():
        print(f"  {name:18s} {seconds:.4f}")


if __name__ == "__main__":
    main()
