"""(h) Beams that lie on each other slide along: boundaries of elements pass each other, then ends."""

from __future__ import annotations

from braidx.rods import Beam, Rods, YarnMaterial, straight
from family import Family
from judge import Outcome, Watch

LONG, SHORT, STEP = 80.0, 30.0, 0.5  # radii
TRAVEL = (LONG / 2 - SHORT) + SHORT / 4.0  # until a quarter is beyond
LOAD = 0.005  # N/mm
FINE = 2.0  # length of the elements below over the radius


def outcome(length: float, friction: float) -> Outcome:
    """A short beam, pressed on a long one by a line load, is pulled along until a quarter of it is beyond the end.

    Args:
        length: Of the elements of the short one over the radius.
    """
    material = YarnMaterial.isotropic(1000.0, 0.3)
    below = straight((-LONG / 2, 0, 0), (LONG / 2, 0, 0), 2 * round(LONG / FINE))
    above = straight((0, 0, 2.0), (SHORT, 0, 2.0), 2 * max(1, round(SHORT / length)))
    rods = Rods([Beam(line, 1.0, material) for line in (below, above)], friction=friction)
    rods.clamp(0, [0, -1])
    rods.hold(1, 0, 0)
    rods.hold(1, slice(None), 1)
    watch = Watch(rods)
    rods.line_load(1, (0.0, 0.0, -LOAD))
    if watch.solve(2):
        rods.move(1, 0, by=(TRAVEL, 0.0, 0.0))
        watch.solve(round(TRAVEL / STEP), max_cuts=3)
    drag = float(rods.reaction(1, 0)[0][0]) / (LOAD * SHORT)
    return watch.outcome(length, friction, drag=drag)


FAMILY = Family(
    "ends",
    "Boundaries of elements, and ends",
    ("length of elements above over the radius (below: 2)", "coefficient of friction"),
    ((1.0, 2.0, 2.7, 10.0), (0.0, 0.3, 0.6)),
    outcome,
    "A beam of 30 radii lies on a clamped one of 80 radii, pressed by a line load, and is pulled "
    "along it by its rear end, half a radius per increment, until a quarter of it is beyond the "
    "other's end. The pull has to be the friction of the whole load.",
    logarithmic=(True, False),
    means=(
        "Boundaries and ends pass, at the price of cut increments: most with elements of one or two radii, "
        "few with those of ten."
    ),
)
