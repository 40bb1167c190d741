"""(c) Slack yarns: strands and braids are cut loose and pushed; bundles that hardly resist bending, up to bars."""

from __future__ import annotations

import birdcage
from family import Family
from judge import Outcome
from rope_recipes import small_braid
from ropes import outcome as rope_outcome

FACTORS = (1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0)
PUSHES = (0.003, 0.01, 0.03, 0.1)
RELEASES = (0.0, 0.002, 0.005, 0.01, 0.02)


def pushed(factor: float, push: float) -> Outcome:
    """A strand of three beams is pulled by 0.2 %, let go and pushed.

    Args:
        factor: On bending and torsion of its yarns.
        push: Strain.
    """
    return birdcage.pulled_and_pushed(birdcage.strand(bundle_factor=factor), (factor, push), push)


def released(factor: float, strain: float) -> Outcome:
    """A braid of beams is formed, pulled to 1 kN, and pushed to a strain."""
    pull = {"kind": "pull", "to_force": 1.0}
    push = {"kind": "pull", "to_strain": -strain, "strain_increment": 0.002}
    return rope_outcome((factor, strain), small_braid("beam", factor, pull, push))


STRAND = Family(
    "slack_strand",
    "Slack yarns: a strand that is pushed",
    ("bundle factor", "strain of compression"),
    (FACTORS, PUSHES),
    pushed,
    "The three twisted yarns of the family above, at rest, with bundle factors down to those of loose filaments.",
    means=(
        "Any bundle factor does, and from 0.01 down strands open to the same shape, to 0.5 % of the widest place. What "
        "gets dearer is the way there: yarns that hardly resist bending buckle under next to nothing, and at 1e-4 and "
        "1e-5 it takes 20 to 60 times the iterations of 0.01. Factors below 1e-3 gain nothing and cost time."
    ),
)
BRAID = Family(
    "slack_braid",
    "Slack yarns: a braid that is pushed",
    ("bundle factor", "strain that the rope is pushed to"),
    (FACTORS, RELEASES),
    released,
    "The rope of `demos/small_rope.toml`, of beams with 24 elements, is formed, pulled to 1 kN, and pushed by "
    "0.2 % per increment, beyond the length at which it carries nothing.",
    logarithmic=(True, False),
    means=(
        "A rope can be pushed by as much as it was pulled and more, whatever its yarns are; cut to zero force and "
        "pushed by 2 % it takes 4 to 10 times the iterations of the pull. Yarns of a small factor stay in contact; "
        "bars (factor 1) part, and carry the push by bending alone. Before this map was drawn one rope crept on for "
        "ever in smaller and smaller increments."
    ),
)
