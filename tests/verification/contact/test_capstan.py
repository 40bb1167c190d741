"""C3: a cable that slides round a cylinder, T2 / T1 = exp(mu theta), line load q = T / R (exact)."""

import braidx_engine as engine
import numpy as np
import pytest

from braidx.rods import Cable, Rods

RADIUS, THIN, TAIL = 10.0, 0.1, 5.0  # cylinder, cable, straight ends, mm
TENSION, STIFFNESS = 10.0, 1e5  # T1, EA, N
WAYS = (0.01, 0.04, 0.05, 0.1)  # mm
ELEMENT = 1.5  # degrees of wrap
EXACT = {
    (0.1, 90): 1.170089,
    (0.1, 180): 1.369108,
    (0.1, 360): 1.874456,
    (0.2, 90): 1.369108,
    (0.2, 180): 1.874456,
    (0.2, 360): 3.513586,
    (0.3, 180): 2.566332,
}


def wrapped_line(wrap, element=ELEMENT):
    """A line round the cylinder (axis z), its tangent turning by `wrap` degrees, with straight tails.

    Nodes are `element` degrees apart. It climbs by five radii a turn, so that a full turn does not meet itself.
    """
    centre = RADIUS + THIN
    climb = np.arctan(5 * THIN / (2 * np.pi * centre))
    angle = np.radians(np.arange(0, wrap + element / 2, element)) / np.cos(climb)
    rise = centre * np.tan(climb)
    arc = np.stack([centre * np.cos(angle), centre * np.sin(angle), rise * angle], axis=1)

    def tangent(a):
        t = np.array([-centre * np.sin(a), centre * np.cos(a), rise])
        return t / np.linalg.norm(t)

    start, end = tangent(angle[0]), tangent(angle[-1])
    step = np.linalg.norm(arc[1] - arc[0])
    along = step * np.arange(1, int(TAIL / step))[:, None]
    return np.concatenate([arc[0] - along[::-1] * start, arc, arc[-1] + along * end]), start, end


def cable(line):
    return Cable(line, THIN, STIFFNESS, TENSION)


def slide(friction, wrap, element=ELEMENT, rod=cable, ways=WAYS, symmetrised=False, **options):
    """Pulled over the cylinder in motions of `ways` (mm); `rod` makes one of a line, `options` are those of Rods."""
    line, start, end = wrapped_line(wrap, element)
    cylinder = engine.make_cylinder(np.zeros(3), np.array([0, 0, 1.0]), RADIUS, False, 0)
    given = {"penalty": 2e3, "penetration": None, "tolerance": 1e-7, **options}
    rods = Rods([rod(line)], friction=friction, rigid=[cylinder], **given)
    rods.contact.symmetrised = symmetrised
    rods.force(0, 0, -TENSION * start)
    rods.pin(0, -1)
    for way in ways:
        rods.move(0, -1, by=way * end)
        rods.solve()
    return rods, end


def ratio_of_tensions(rods, end):
    """T2 / T1."""
    return rods.reaction(0, -1)[0] @ end / TENSION


@pytest.mark.parametrize("friction, wrap", EXACT)
def test_ratio_of_tensions(record, friction, wrap):
    rods, end = slide(friction, wrap)
    ratio = ratio_of_tensions(rods, end)
    what = f"capstan, mu = {friction:g}, {wrap} degrees: T2 / T1"
    record.check("C3", what, ratio, EXACT[friction, wrap], 5e-4, unknowns=rods.q.size)


def line_loads(rods, margin=10):
    """Load per length at the contact elements but for those at either end of an arc of 180 degrees, and T / R there.

    Both in N/mm; the ends that are left out are `margin` degrees long.
    """
    contacts, tension = rods.contacts(), rods.tension(0)
    element = np.clip(contacts["s"][:, 0].astype(int), 0, len(tension) - 1)
    angle = np.degrees(np.arctan2(contacts["position"][:, 1], contacts["position"][:, 0]))
    inside = (angle > margin) & (angle < 180 - margin)
    load = contacts["normal_force"] / contacts["weight"]
    return load[inside], tension[element[inside]] / (RADIUS + THIN)


def test_line_load(record):
    rods, _ = slide(0.2, 180)
    load, exact = line_loads(rods)
    assert len(load) > 100
    what = "capstan, mu = 0.2, 180 degrees: line load T / R"
    record.check("C3", what, load, exact, 5e-3, unknowns=rods.q.size)
