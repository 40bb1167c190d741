"""Which options have an effect in which scenes: a value that changes nothing is refused, not ignored.

An option names the condition that it needs (`needs` of its field). Where that does not hold it has to have its default,
or the value that the yarn's material gives it.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from braidx.scene.bending import Bend, BendCycles, Straighten
from braidx.scene.errors import SceneError
from braidx.scene.fields import Table, spec_of
from braidx.scene.steps import Cycle, Form, Hold, Pull, Settle
from braidx.scene.tables import SceneTables

STRAIGHT = (Settle, Pull, Hold, Cycle)  # steps that know the yarns of a straight rope only
SOLID = (
    "solid",
    "mixed",
    "auto",
)  # models with yarns, or stretches of them, that are or may become solid


class NoEffect(SceneError):
    """A value that changes nothing in its scene."""


@dataclass(frozen=True)
class Need:
    """What an option needs.

    Attributes:
        holds: Whether a scene has it.
        lacks: What a scene does not have without it, as in "no effect: ...".
        only: Where the option has an effect, for the reference.
    """

    holds: Callable[[SceneTables], bool]
    lacks: str
    only: str


def has_step(scene: SceneTables, *kinds: type) -> bool:
    """Whether a scene has a step of one of these kinds."""
    return any(isinstance(step, kinds) for step in scene.steps)


def bends(scene: SceneTables) -> bool:
    """Whether the rope is bent over its sheave."""
    return has_step(scene, Bend)


def yarn_models(scene: SceneTables) -> set[str]:
    """Models of yarns or of stretches of them; "auto" stands for any."""
    named = {scene.yarn.model, *scene.yarn.models.values()}
    return named | ({scene.yarn.outer_model, "solid"} if "mixed" in named else set())


def _placed_beams(scene: SceneTables) -> bool:
    formed = any(isinstance(step, Form) and step.model == "beam" for step in scene.steps)
    return formed or (scene.yarn.model == "beam" and not bends(scene))


def _beams(scene: SceneTables) -> bool:
    return _placed_beams(scene) or not yarn_models(scene).isdisjoint({"beam", "auto"})


def _solids(scene: SceneTables) -> bool:
    return not yarn_models(scene).isdisjoint({"solid", "auto"})


def _rubs(scene: SceneTables) -> bool:
    pairs = [scene.contact.friction_of("yarn-yarn")]
    pairs += [scene.contact.friction_of("yarn-core")] if scene.core else []
    pairs += [scene.contact.friction_of("yarn-sheave")] if scene.sheave else []
    pairs += [step.friction or 0.0 for step in scene.steps if isinstance(step, Form)]
    return any(pairs)


def _core(scene: SceneTables, *models: str) -> bool:
    return scene.core is not None and bends(scene) and scene.core.model in models


def _swept_core(scene: SceneTables) -> bool:
    return _core(scene, "solid") and scene.core is not None and not scene.core.mesh


def _returns(scene: SceneTables) -> bool:
    """Whether the rope is bent, straightened and bent again."""
    kinds = [type(step) for step in scene.steps if isinstance(step, (Bend, Straighten))]
    cycle = any(kinds[i : i + 3] == [Bend, Straighten, Bend] for i in range(len(kinds)))
    return has_step(scene, BendCycles) or cycle


def _forms(scene: SceneTables) -> bool:
    return has_step(scene, Form)


NEEDS = {
    "beams": Need(_beams, "no yarn is a beam", "beams"),
    "placed beams": Need(
        _placed_beams,
        "no beam is placed: beams of bent ropes are free of stress in the straight rope",
        "beams of straight ropes, and beams that are formed",
    ),
    "sections": Need(
        lambda scene: _beams(scene) or _solids(scene),
        "cables do not know it; choose another yarn.model",
        "beams and solids",
    ),
    "sections or bent": Need(
        lambda scene: _beams(scene) or _solids(scene) or bends(scene),
        "cables do not know it; choose another yarn.model",
        "beams, solids, and ropes that are bent",
    ),
    "solids": Need(_solids, "no yarn is solid", "solid yarns"),
    "mixed": Need(
        lambda scene: "mixed" in {scene.yarn.model, *scene.yarn.models.values()},
        "no yarn is mixed",
        "mixed yarns",
    ),
    "bent": Need(bends, 'no step kind = "bend"', "ropes that are bent"),
    "soft core": Need(
        lambda scene: _core(scene, "solid", "beam"),
        "the core does not deform: it is rigid, and so is any core while the rope is formed",
        "cores of bent ropes that are not rigid",
    ),
    "solid core": Need(
        lambda scene: _core(scene, "solid"),
        "the core is no solid that is bent",
        "solid cores of bent ropes",
    ),
    "swept core": Need(
        _swept_core,
        "the core is no solid cylinder that is bent",
        "solid cores of bent ropes without a mesh of their own",
    ),
    "meshed core": Need(
        lambda scene: _core(scene, "solid") and not _swept_core(scene),
        "the core has no mesh of its own",
        "cores with a mesh of their own",
    ),
    "cycles": Need(
        _returns,
        'the rope is not bent again and again; add a step kind = "bend_cycles"',
        "ropes that are bent again and again",
    ),
    "first penalty": Need(
        lambda scene: bends(scene) or not _forms(scene),
        "a rope that is formed goes on with the penalties that it was formed with; use steps.form.penalty",
        "ropes that are not formed, or bent",
    ),
    "rubs": Need(_rubs, "there is no friction", "contact with friction"),
    "own model": Need(
        lambda scene: has_step(scene, Bend, *STRAIGHT),
        "the rope is formed only, as steps.form.model says",
        "all steps but form, which has a model of its own",
    ),
    "cuts": Need(
        lambda scene: has_step(scene, Bend, Pull, Hold, Cycle)
        or (has_step(scene, Settle) and bool(scene.ends.groups)),
        "a rope that is formed and settled is under its force at once",
        "steps pull, hold, cycle and those that bend, and groups of ends",
    ),
    "rubbing equilibria": Need(
        lambda scene: _rubs(scene) and has_step(scene, Bend, *STRAIGHT),
        "there is no friction, or the rope is formed only",
        "all steps but form, with friction",
    ),
    "directors": Need(
        lambda scene: _beams(scene) or bends(scene),
        "cables have no directors",
        "beams, and ropes that are bent",
    ),
    "alike": Need(
        lambda scene: _forms(scene) or not (bends(scene) or scene.ends.groups),
        "neither ropes that are bent nor groups of ends are kept symmetric",
        "ropes that are formed, or pulled without groups of ends",
    ),
    "ends": Need(
        lambda scene: _forms(scene) or not bends(scene),
        "the ends of a rope that is bent are clamped",
        "straight ropes, and ropes that are formed",
    ),
    "ends of beams": Need(
        lambda scene: _placed_beams(scene)
        and (scene.ends.transverse != "periodic" or bool(scene.ends.groups)),
        "there are no beams, or the rope goes on past its ends, where sections turn alike",
        'beams of straight ropes that do not go on past their ends (ends.transverse = "periodic")',
    ),
    "straight steps": Need(
        lambda scene: has_step(scene, *STRAIGHT),
        "groups of ends act in steps settle, pull, hold and cycle",
        "steps settle, pull, hold and cycle",
    ),
    "groups": Need(
        lambda scene: any(group.prescribes for group in scene.ends.groups),
        "no [[ends.groups]] prescribes anything",
        "groups of ends that prescribe something",
    ),
    "several yarns": Need(
        lambda scene: scene.strand.rings != (1,),
        "the strand is one yarn",
        "strands of several yarns",
    ),
    "twist": Need(
        lambda scene: scene.strand.rings != (1,) and scene.strand.yarn_pitch != "untwisted",
        "the yarns are not twisted; give strand.yarn_pitch",
        "strands of several yarns that are twisted",
    ),
    "fields": Need(lambda scene: scene.output.fields, "no fields are written", "fields"),
}


def check_effects(scene: SceneTables) -> None:
    """Raises NoEffect for the first value that changes nothing.

    A scene without steps is a rope that is only looked at: what it will be computed with is open.
    """
    if not scene.steps:
        return
    _check_tables(scene)
    own = _material_of(scene)
    for name, table in _tables(scene):
        for field in dataclasses.fields(table):
            need, value = spec_of(field).needs, getattr(table, field.name)
            if not need or value == _default(field) or NEEDS[need].holds(scene):
                continue
            if name == "yarn" and field.name in own and own[field.name] == value:
                continue
            cure = f"has no effect: {NEEDS[need].lacks}; or leave it out."
            raise NoEffect(f"{name}.{field.name}", cure, value)


def _check_tables(scene: SceneTables) -> None:
    for name, table, need in (("sheave", scene.sheave, "bent"), ("heat", scene.heat, "cycles")):
        if table is not None and not NEEDS[need].holds(scene):
            raise NoEffect(name, f"has no effect: {NEEDS[need].lacks}; or remove [{name}].")
    for name in scene.material:
        if name != scene.yarn.material:
            cure = f'has no effect: no yarn is of it; write yarn.material = "{name}", or remove it.'
            raise NoEffect(f"material.{name}", cure)


def _tables(scene: SceneTables) -> Iterator[tuple[str, Table]]:
    for field in dataclasses.fields(scene):
        table = getattr(scene, field.name)
        if isinstance(table, Table):
            yield field.name, table
    for i, step in enumerate(scene.steps):
        yield f"steps[{i}]", step


def _material_of(scene: SceneTables) -> dict[str, Any]:
    """What the yarn's material says: of a material some models do not know all."""
    material = scene.material.get(scene.yarn.material)
    return {} if material is None else vars(material)


def _default(field: dataclasses.Field[Any]) -> Any:
    make = field.default_factory
    return field.default if make is dataclasses.MISSING else make()
