"""Contact of all yarns of a rope: laws, spacing, prescribed crossings."""

from __future__ import annotations

import math
from typing import Any

import braidx_engine as engine
import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from ..bodies import CurveBody
from ..contact.contact import Contact
from ..contact.tubes import TubeLayout
from ..geometry import Crossings, Rope
from ..scene import Scene
from ..system.constraints import Floats
from .threads import num_threads

WINDOW = 0.1  # of a pitch: how far to either side of its crossing a yarn is held to its side
AXIS = np.array([0.0, 0.0, 1.0])
YARN, CORE = range(2)  # bodies


def make_contact(
    comm: MPI.Comm,
    scene: Scene,
    rope: Rope,
    body: CurveBody,
    is_image: npt.NDArray[np.bool_],
    beyond: int,
) -> Contact:
    """Contact of all yarns, with laws and spacing from the scene.

    Args:
        comm, scene, rope, body: As of the model.
        is_image: Whether the equilibrium of a yarn repeats another's, shape (num_yarns,).
        beyond: Elements that yarns go on for past their ends.
    """
    curves = body.layout.curves
    num_elements = np.diff(body.layout.curve_elements)
    lengths = body.curve_lengths()
    ones = np.ones(len(num_elements), dtype=np.int64)
    layout = TubeLayout(
        first_unknown=curves[:-1] * body.block,
        num_elements=num_elements,
        degree=ones * body.layout.degree,
        block=ones * body.block,
        radius=rope.radius,
        element_length=lengths / num_elements,
        body=0 * ones,
        beyond=beyond,
        is_image=is_image,
    )
    crossings = engine_crossings(rope, lengths, beyond / num_elements[0])
    contact = Contact(
        comm,
        layout,
        crossings,
        smooth=True,
        symmetric=scene.solver.tangent == "symmetric",
        num_threads=num_threads(comm),
    )
    set_options(contact, scene)
    penalty = scene.contact.penalty
    contact.pairing.stiffness = penalty or 0.01 * scene.yarn.axial_stiffness / scene.yarn.radius**2
    contact.pairing.crossing.by_point = True
    contact.rigid = core_walls(scene)
    if contact.rigid:
        contact.laws.num_bodies = contact.pairing.num_bodies = 2
    # A core that does not stretch would hold a rope back the more, the farther a pitch is from the end that stays: what
    # holds for one pitch holds for all of them without friction only.
    set_friction(contact, scene.contact.friction_of("yarn-yarn"), 0.0)
    return contact


def core_walls(scene: Scene) -> list[Any]:
    """The core, if there is one, as a rigid cylinder (engine object), whatever it is made of."""
    if scene.core is None:
        return []
    return [engine.make_cylinder(0 * AXIS, AXIS, scene.core.radius, False, CORE)]


def set_friction(contact: Contact, yarns: float, core: float) -> None:
    """Coefficients of friction between yarns, and of yarns on the core."""
    both = contact.laws.num_bodies == 2
    contact.laws.friction = [yarns, core, core, 0.0] if both else [yarns]


def set_options(contact: Contact, scene: Scene) -> None:
    """Spacing, tolerances and laws of contact, but for friction, from the scene."""
    options, radius, layout = scene.contact, scene.yarn.radius, contact.layout
    if len(layout.element_length):  # solids have contact points of their own
        shortest = float((layout.element_length / layout.degree).min())
        contact.pairing.spacing = options.station_spacing * shortest
    contact.pairing.search.margin = options.search_distance * radius
    contact.pairing.point_tolerance = options.penetration_tolerance * radius
    contact.laws.regularisation = options.regularisation * radius
    contact.laws.reversible_slip = options.reversible_slip * radius


def elements_beyond(rope: Rope, body: CurveBody) -> int:
    """Elements that yarns of a periodic sample go on for past its ends: whole windows of crossings, and one more."""
    per_pitch = np.diff(body.layout.curve_elements).min() * rope.pitch / rope.length
    return math.ceil(WINDOW * per_pitch) + 1


def engine_crossings(rope: Rope, lengths: Floats, beyond: float) -> Any:
    """Crossings of all yarns of crossing strands, with windows in rest arc length (mm).

    A window reaches a tenth of a pitch to either side: crossings of one pair are half a pitch apart. Those whose
    windows reach past an end come last, once more at the other end.

    Args:
        rope: The start configuration.
        lengths: Of the yarns at rest, shape (num_yarns,), mm.
        beyond: What yarns go on for past their ends, over their length.
    """
    yarns = [np.flatnonzero(rope.strand == s) for s in range(rope.num_strands)]
    crossings: Crossings = rope.crossings
    tubes, windows, order = [], [], []
    for period in (0, 1, -1):
        for a, b, z, sign in zip(
            crossings.strand_a, crossings.strand_b, crossings.z, crossings.order, strict=True
        ):
            reach = np.array([-WINDOW, WINDOW]) * rope.pitch
            window = np.clip((z + reach) / rope.length + period, -beyond, 1.0 + beyond)
            if window[0] >= window[1]:
                continue
            for yarn_a in yarns[a]:
                for yarn_b in yarns[b]:
                    tubes.append((yarn_a, yarn_b))
                    windows.append(
                        np.concatenate([window * lengths[yarn_a], window * lengths[yarn_b]])
                    )
                    order.append(sign)
    return engine.make_crossings(
        tubes=np.array(tubes, np.int32).reshape(-1, 2),
        windows=np.array(windows, float).reshape(-1, 4),
        order=np.array(order, np.int32),
        axis=np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
    )
