"""A bent rope as a picture: yarns, core, sheave, stresses and contacts."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...output.contact_table import CORE_SHEAVE, YARN_CORE, YARN_SHEAVE, YARN_YARN, ContactTable
from ...output.core_line import CoreLine
from ...output.sheave_picture import SheavePicture
from ...output.skin_picture import SkinPicture
from ...output.snapshot import Snapshot
from ...system.constraints import Floats
from ..rope_picture import contact_columns, gathered_results
from ..state import State
from .sheave import AXIS
from .skins import skin_picture
from .surfaces import NO_YARN
from .yarn_states import axial_stress, centre_lines, directors

if TYPE_CHECKING:
    from .model import BentRope


def bent_picture(model: BentRope, state: State, name: str) -> Snapshot:
    """A state with everything that is known of it; gathered from all processes."""
    scene, assembly, q = model.scene, model.assembly, state.q
    lines = centre_lines(assembly, q)
    stress = axial_stress(assembly, q)
    core = None
    if scene.core is not None and assembly.core is not None:
        line = assembly.core.centre_line(q)
        core = CoreLine(line, scene.core.radius, scene.core.inner_radius)
    place = model.sheave
    return Snapshot(
        name,
        lines,
        np.full(len(lines), scene.yarn.radius),
        np.arange(len(lines)),
        directors=directors(assembly, q),
        tension=tuple(s * scene.yarn.section_area for s in stress),
        axial_stress=stress,
        contacts=_contacts(model, q),
        core=core,
        skins=_skins(model, q),
        sheave=SheavePicture(place.centre, AXIS, place.radius, place.groove_radius),
    )


def _skins(model: BentRope, q: Floats) -> tuple[SkinPicture, ...]:
    assembly, core = model.assembly, model.scene.core
    out = []
    if assembly.solids is not None:
        body, first = assembly.solids
        yarns = [stretch.yarn for stretch in assembly.of("solid")]
        rows = q[first : first + body.num_unknowns].reshape(-1, 3)
        out.append(skin_picture(body, rows, "lateral", yarns))
    if assembly.core_solid is not None:
        assert core is not None
        body, first = assembly.core_solid
        rows = q[first : first + body.num_unknowns].reshape(-1, 3)
        out.append(skin_picture(body, rows, core.surface, [NO_YARN]))
    return tuple(out)


def _contacts(model: BentRope, q: Floats) -> ContactTable:
    whole = gathered_results(model.comm, model.contact, q)
    a, b = whole["tubes"].astype(np.int64).T
    yarn = model.surfaces.yarn
    yarn_a = yarn[a]
    yarn_b = np.where(b < 0, NO_YARN, yarn[b])
    on_sheave, with_core = b < 0, (yarn_a == NO_YARN) | ((b >= 0) & (yarn_b == NO_YARN))
    kind = np.select(
        [on_sheave & with_core, on_sheave, with_core],
        [CORE_SHEAVE, YARN_SHEAVE, YARN_CORE],
        YARN_YARN,
    )
    return ContactTable(
        **contact_columns(whole),
        yarn_a=yarn_a,
        yarn_b=yarn_b,
        kind=kind,
        measure=whole["weight"],
        per_area=whole["per_area"].astype(bool),
    )
