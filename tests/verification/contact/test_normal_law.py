"""C1: eq. (4) of paper 1 between two rods: k p_reg / 2, slope k and energy k p_reg^2 / 6 at -p_reg (exact)."""

import numpy as np

from braidx.rods import Cable, Rods, straight

RADIUS, LENGTH, PENALTY, REGULARISATION = 1.0, 12.0, 300.0, 0.04
STEP = 0.1 * REGULARISATION


def load(penetration):
    """Contact force per length of two parallel rods, N/mm; they are held at a penetration in units of p_reg."""
    apart = 2.0 * RADIUS - penetration * REGULARISATION
    lines = [straight((x, 0, 0), (x, 0, LENGTH), 6) for x in (0.0, apart)]
    pair = [Cable(line, RADIUS, 1e4, tension=10.0) for line in lines]
    rods = Rods(pair, penalty=PENALTY, penetration=None)
    rods.contact.laws.regularisation = REGULARISATION
    rods.hold(0)
    rods.hold(1, components=[0, 1])
    rods.hold(1, [0, -1])
    rods.solve()
    contacts = rods.contacts()
    return contacts["normal_force"].sum() / contacts["weight"].sum()


def test_threshold(record):
    places = (0.0, 0.5, 0.8, 0.9, 1.0, 1.1, 1.2)
    q = dict(zip(places, map(load, places)))
    value = PENALTY * REGULARISATION / 2.0
    record.check("C1", "load per length at -p_reg: k p_reg / 2", q[1.0], value, 1e-9)
    # Differences of second order, which are exact for the parabola on one side and the line on the other.
    below = (3.0 * q[1.0] - 4.0 * q[0.9] + q[0.8]) / (2.0 * STEP)
    beyond = (4.0 * q[1.1] - 3.0 * q[1.0] - q[1.2]) / (2.0 * STEP)
    record.check("C1", "slope at -p_reg from both sides: k", [below, beyond], PENALTY, 1e-9)
    energy = REGULARISATION * (q[0.0] + 4.0 * q[0.5] + q[1.0]) / 6.0  # Simpson's rule: exact, too
    exact = PENALTY * REGULARISATION**2 / 6.0
    record.check("C1", "energy per length at -p_reg: k p_reg^2 / 6", energy, exact, 1e-9)
    assert np.all(np.diff(list(q.values())) > 0.0)
