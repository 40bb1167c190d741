"""(c) Slack yarns: strands and braids are cut loose and pushed; bundles that hardly resist bending, up to bars."""

from __future__ import annotations

import birdcage
from family import Family
from judge import Outcome
from rope_recipes import Recipe
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


def braid(model: str, factor: float, *steps: Recipe) -> Recipe:
    """The rope of demos/small_rope.toml with 24 elements, formed and brought to rest, and what is done to it then."""
    return {
        "rope": {"pitch": 36.0, "pitches": 1},
        "braid": {
            "strands_per_direction": [4, 4],
            "motif": "1-over-1-under",
            "helix_radius": 2.0,
        },
        "yarn": {
            "radius": 0.86,
            "axial_stiffness": 162e3,
            "model": model,
            "bundle_factor": factor,
            "elements_per_pitch": 24,
        },
        "contact": {"friction": 0.1},
        "solver": {"max_cuts": 4},
        "steps": [{"kind": "form", "tension": 20.0}, {"kind": "settle"}, *steps],
    }


def released(factor: float, strain: float) -> Outcome:
    """A braid of beams is formed, pulled to 1 kN, and pushed to a strain."""
    pull = {"kind": "pull", "to_force": 1.0}
    push = {"kind": "pull", "to_strain": -strain, "strain_increment": 0.002}
    return rope_outcome((factor, strain), braid("beam", factor, pull, push))


STRAND = Family(
    "slack_strand",
    "Slack yarns: a strand that is pushed",
    ("bundle factor", "strain of compression"),
    (FACTORS, PUSHES),
    pushed,
    "The three twisted yarns of the family above, at rest, with bundle factors down to those of loose filaments.",
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
)
