"""Rods that are placed in each other are pushed apart before anything is asked of them."""

from __future__ import annotations

import braidx_engine as engine
import numpy as np

from ..contact.contact import Contact
from ..output.log import LOGGER
from ..solver.increment import Increment
from ..solver.trial import Diverged
from ..system.terms import Floats
from .equilibria import Equilibria
from .friction import without_friction
from .layout import Layout
from .overlap import overlaps
from .passing import Chords
from .path import NotConverged, follow

PLACED = (
    0.03  # sums of radii: a deeper overlap at the start is more than the error of a rope's geometry
)
GROWTH = 0.1  # sums of radii that an increment pushes rods apart by
COINCIDE = 1e-3  # sums of radii: centre lines that are nearer have no direction to be pushed in


def push_apart(equilibria: Equilibria, layout: Layout, contact: Contact, q: Floats) -> Floats:
    """The equilibrium of rods that were placed in each other, without loads, in which they only touch.

    Contact takes their tubes as thinner at first, so that none are in each other, and lets them grow to what they are:
    a ramp of the initial gap reduction. Rods go to the side of each other where their centre lines are. Friction does
    not act.

    Args:
        q: Unknowns, shape (num_unknowns,).
    Returns:
        Unknowns, shape (num_unknowns,); those given where nothing overlaps.
    Raises:
        NotConverged: If centre lines coincide or no such equilibrium is found.
    """
    radius, names = contact.layout.radius, layout.surface_rods
    coinciding = Chords.of(layout, contact, q).meetings(q, near=COINCIDE)
    if coinciding:
        raise NotConverged(
            "the centre lines of rods {} and {} meet at the start: place the rods beside each other".format(
                *min(coinciding)
            )
        )
    deepest, depth, a, b = _deepest(contact, q)
    if deepest <= PLACED:
        return q
    what = f"rods {names[a]} and {names[b]} begin {depth:.3g} mm in each other"
    LOGGER.info("%s: rods are pushed apart before the first increment", what)

    def grow(begin: float, end: float, before: Floats) -> Increment:
        contact.set_radius(radius * (1.0 - (1.0 - end) * deepest))
        return equilibria.find(state[0], state[0] + before, 0.0)

    state = [q]
    count = int(np.ceil(deepest / GROWTH))
    try:
        with without_friction(contact):
            follow(grow, q, count, 4, lambda found, _: state.insert(0, found.q))
    except NotConverged as failure:
        cause = failure.__cause__ if isinstance(failure.__cause__, Diverged) else failure
        raise NotConverged(
            f"{what} and could not be pushed apart: {cause}. Place them apart."
        ) from failure
    finally:
        contact.set_radius(radius)
    _forget_slip(contact)
    return state[0]


def _deepest(contact: Contact, q: Floats) -> tuple[float, float, int, int]:
    """Deepest overlap over the sum of radii, that in mm, and the tubes; of all processes."""
    radius, worst = contact.layout.radius, (0.0, 0.0, 0, 0)
    for (a, b), depth in overlaps(contact, q).items():
        worst = max(worst, (depth / (radius[a] + radius[b]), depth, a, b))
    return max(contact.comm.allgather(worst))


def _forget_slip(contact: Contact) -> None:
    """Rods that were pushed apart have not slid on each other."""
    arrays = contact.elements.arrays()
    for name in ("slip", "work"):
        arrays[name] = np.zeros_like(arrays[name])
    contact.restore(engine.ContactElements.from_arrays(arrays))
