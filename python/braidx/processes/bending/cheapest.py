"""The cheapest model that the yarns of a bent rope may start with."""

from __future__ import annotations

import math

from ...geometry.bending_checks import outer_diameter
from ...geometry.bent_helix import bend_radius
from ...output.log import LOGGER
from ...scene import Bend, Scene
from ..yarns import yarn_section

BENDING = 0.05  # share of bending in the energy of a yarn above which a cable does not stand for it


def cheapest_model(scene: Scene) -> str:
    """ "cable", or "beam" where the energy of bending is foreseen to matter; told in the log."""
    share = foreseen_bending_share(scene)
    if share <= BENDING:
        return "cable"
    LOGGER.info(
        "yarns start as beams: bending is foreseen to have %.0f %% of their energy (limit %.0f %%)",
        100.0 * share,
        100.0 * BENDING,
    )
    return "beam"


def foreseen_bending_share(scene: Scene) -> float:
    """Energy of bending over that and the axial energy of a yarn, -.

    The yarn is taken to be bent like the rope on the sheave, E I / rho^2, and pulled by its share of the pretension,
    T^2 / E A. Without a pretension it has nothing but its stiffness in bending: a slack cable has no shape.
    """
    yarn, section = scene.yarn, yarn_section(scene)
    assert scene.sheave is not None and scene.braid is not None
    pull = max(
        (step.pretension or 0.0 for step in scene.steps if isinstance(step, Bend)), default=0.0
    )
    angle = math.atan(2.0 * math.pi * scene.braid.helix_radius / scene.rope.pitch)
    tension = 1e3 * pull / (sum(scene.braid.strands_per_direction) * math.cos(angle))
    curvature = 1.0 / bend_radius(scene.sheave.diameter, outer_diameter(scene))
    axial = yarn.axial_stiffness
    bending = yarn.bundle_factor * axial * section.inertia_1 / section.area * curvature**2
    return bending / (bending + tension**2 / axial)
