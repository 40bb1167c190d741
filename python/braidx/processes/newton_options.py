"""Newton's method as a scene asks for it."""

from __future__ import annotations

from ..scene import Scene
from ..solver.newton import NewtonOptions
from ..solver.pseudo_transient import StepOptions

UNSTRETCHED = (
    1e-6  # strain of yarns that counts as none: beside it round-off (1e-16 of a position) is small
)


def newton_options(scene: Scene) -> NewtonOptions:
    """Options of the Newton iteration; no step is longer than a yarn's radius."""
    solver = scene.solver
    return NewtonOptions(
        tolerance=solver.tolerance,
        max_iterations=solver.max_iterations,
        max_step=scene.yarn.radius,
        max_turn=solver.director_cap,
        symmetric=solver.tangent == "symmetric",
        petsc=solver.petsc,
        # Yarns that are placed without overlap carry no force that a residual could be compared with.
        least_force=UNSTRETCHED * scene.yarn.axial_stiffness,
    )


def step_options(scene: Scene) -> StepOptions:
    """Limits of steps of the pseudo-transient continuation: those of the Newton iteration."""
    newton = newton_options(scene)
    return StepOptions(newton.max_step, newton.max_turn, newton.least_force)
