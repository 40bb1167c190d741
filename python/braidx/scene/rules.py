"""Rules between the tables and steps of a scene in which a rope is bent over a sheave."""

from __future__ import annotations

from pathlib import Path

from braidx.scene.bending import Bend, BendCycles, RunOver, Straighten
from braidx.scene.effects import SOLID, STRAIGHT, bends
from braidx.scene.errors import SceneError
from braidx.scene.steps import Form, Pull
from braidx.scene.tables import SceneTables


def check_bending(scene: SceneTables) -> None:
    """Raises SceneError, with the cure, where tables and steps do not go together."""
    _check_braid(scene)
    _check_steps(scene)
    _check_models(scene)
    _check_mesh(scene)
    _check_friction(scene)


def _check_braid(scene: SceneTables) -> None:
    for name, table in (("sheave", scene.sheave), ("core", scene.core)):
        if table is not None and scene.braid is None:
            cure = f"a rope without a braid has no {name}; add [braid] or remove [{name}]."
            raise SceneError(name, cure)


def _check_steps(scene: SceneTables) -> None:
    bent = False
    for i, step in enumerate(scene.steps):
        if isinstance(step, Bend):
            _check_bend(scene, step, i)
            bent = True
        elif isinstance(step, (Straighten, BendCycles, RunOver)) and not bent:
            cure = 'the rope is not bent yet; put a step kind = "bend" before it.'
            raise SceneError(f"steps[{i}].kind", cure, step.kind)
        elif isinstance(step, Pull) and bends(scene):
            _check_pull(step, i)
        elif isinstance(step, STRAIGHT):
            _check_straight(scene, step.kind, i)
        elif isinstance(step, Form) and i:
            cure = "a rope is formed once and first; move this step to the top, or remove it."
            raise SceneError(f"steps[{i}].kind", cure, step.kind)


def _check_bend(scene: SceneTables, step: Bend, i: int) -> None:
    if scene.sheave is None:
        cure = "a rope is bent over a sheave; add a table [sheave] with its diameter."
        raise SceneError(f"steps[{i}].kind", cure, step.kind)
    if scene.core is not None and scene.core.model == "rigid":
        cure = f"a rigid core does not bend, as steps[{i}] would have it; use a solid or a beam."
        raise SceneError("core.model", cure, scene.core.model)
    if step.travel >= scene.length / 2.0:
        cure = (
            f"the ends cannot come so far, must be below half of the sample's {scene.length:.4g} mm; use a shorter "
            "travel or more rope.pitches."
        )
        raise SceneError(f"steps[{i}].travel", cure, step.travel)


def _check_pull(step: Pull, i: int) -> None:
    if step.to_force is None:
        cure = "a rope that is bent in the same scene is pulled to a force; give to_force, in kN."
        raise SceneError(f"steps[{i}].to_strain", cure, step.to_strain)


def _check_straight(scene: SceneTables, kind: str, i: int) -> None:
    if scene.sheave is not None:
        table, instead = (
            "[sheave]",
            "use steps form, pull, bend, run_over, straighten and bend_cycles",
        )
    elif scene.core is not None and scene.core.model != "rigid":
        table, instead = f'[core] of model "{scene.core.model}"', 'use core.model = "rigid"'
    else:
        return
    cure = f"not possible in a scene with a {table}; {instead}, or remove that table."
    raise SceneError(f"steps[{i}].kind", cure, kind)


def _check_models(scene: SceneTables) -> None:
    named = {f"yarn.models.{number}": model for number, model in scene.yarn.models.items()}
    for key, model in {"yarn.model": scene.yarn.model, **named}.items():
        if model in SOLID and not bends(scene):
            cure = 'only ropes that are bent have such yarns; use cable or beam, or add a step kind = "bend".'
            raise SceneError(key, cure, model)
        if model == "mixed":
            _check_stretch(scene, key)


def _check_stretch(scene: SceneTables, key: str) -> None:
    stretch = scene.yarn.solid_stretch
    if stretch is None:
        cure = "needs yarn.solid_stretch, in mm: the length about the crown that is solid."
        raise SceneError(key, cure, "mixed")
    if stretch >= scene.length:
        cure = f'must be below the sample\'s {scene.length:.4g} mm; or use yarn.model = "solid".'
        raise SceneError("yarn.solid_stretch", cure, stretch)


def _check_mesh(scene: SceneTables) -> None:
    if scene.core is not None and scene.core.mesh and not Path(scene.core.mesh).is_file():
        cure = "no such file; give the path of a mesh, or leave it out for a cylinder."
        raise SceneError("core.mesh", cure, scene.core.mesh)


def _check_friction(scene: SceneTables) -> None:
    """Pairs of bodies that the rope does not have."""
    for name, table in (("core", scene.core), ("sheave", scene.sheave)):
        pair = f"yarn-{name}"
        if table is None and pair in scene.contact.friction_between:
            cure = f"there is no {name}; add [{name}], or remove this pair."
            value = scene.contact.friction_between[pair]
            raise SceneError(f"contact.friction_between.{pair}", cure, value)
