"""Defaults that depend on what else a scene states: how finely yarns are divided, and how deep they may press.

They are worked out when the scene is made, so that it shows them; what it states stays. Their sizes are those that pay
in docs/accuracy.md.
"""

from __future__ import annotations

from dataclasses import replace

from braidx.scene.bending import Bend
from braidx.scene.material import YarnModel
from braidx.scene.numerics import ContactOptions
from braidx.scene.tables import SceneTables

STRAIGHT, CURVED = 1, 2  # degrees of elements
ELEMENTS = 40  # straight ones per pitch
BETWEEN = 3  # curved ones from crossing to crossing
EIGHTHS = 8  # of a pitch: what stands for crossings where there are fewer
APART = 1 / 3  # radii between nodes at least: closer ones form other shapes, or do not come to rest
WIDE = 2 / 3  # the same where curved ones are chosen: with half a radius a braid did not rest
DEPTH, BENT_DEPTH = 0.015, 0.005  # penetrations allowed, over the radius
SPANS = 6  # between nodes, from crossing to crossing, that yarns are kept apart to the smaller depth with


def crossings(scene: SceneTables) -> int:
    """Crossings of a strand in a pitch; of a rope without a braid, eighths of its pitch stand for them."""
    return EIGHTHS if scene.braid is None else sum(scene.braid.strands_per_direction)


def most_elements(scene: SceneTables, degree: int, apart: float = APART) -> int:
    """Elements per pitch that leave so many radii between nodes."""
    return max(4, int(scene.rope.pitch / (apart * scene.yarn.radius * degree)))


def is_bundled(scene: SceneTables) -> bool:
    """Whether yarns are braided in strands of several, which lie along each other and are pressed together.

    Kinks between curved elements seem to hold the forming of such ropes up: 36 yarns took 15 times as long, 84 found no
    shape.
    """
    return scene.braid is not None and sum(scene.strand.rings) > 1


def with_mesh(scene: SceneTables) -> YarnModel:
    """The scene's yarns, divided.

    Curved elements are better for cables that are not bundled, in stiffness and in what presses on them; beams that
    bend in contact do no better with them. A scene that states a number of elements means straight ones: nodes are as
    many as it says.
    """
    yarn = scene.yarn
    cables = {yarn.model, *yarn.models.values()} == {"cable"}
    degree, elements = yarn.degree, yarn.elements_per_pitch
    if degree is None:
        curved = cables and elements is None and not is_bundled(scene)
        degree = CURVED if curved else STRAIGHT
    if elements is None:
        wanted = BETWEEN * max(EIGHTHS, crossings(scene))
        elements = (
            ELEMENTS if degree == STRAIGHT else min(wanted, most_elements(scene, degree, WIDE))
        )
    return replace(yarn, degree=degree, elements_per_pitch=elements)


def with_depth(scene: SceneTables) -> ContactOptions:
    """The scene's contact, penetrations bounded; the mesh of its yarns has to be known.

    Ropes that are bent need to be kept apart better than those that are pulled, and can be where elements are fine:
    chords that are off their curves by more find no equilibrium.
    """
    if scene.contact.penetration_tolerance is not None:
        return scene.contact
    spans = scene.yarn.elements_per_pitch * scene.yarn.degree
    fine = spans >= SPANS * crossings(scene)
    bends = any(isinstance(step, Bend) for step in scene.steps)
    return replace(scene.contact, penetration_tolerance=BENT_DEPTH if bends and fine else DEPTH)
