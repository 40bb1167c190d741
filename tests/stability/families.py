"""All families, in the order of the page."""

from __future__ import annotations

import birdcage
import crossing_angle
import ends
import friction
import hockling
import large_increments
import mismatch
import penalty
import random_scenes
import refinement
import remedies
import ropes
import slenderness
import units

FAMILIES = (
    crossing_angle.FAMILY,
    remedies.FAMILY,
    friction.FAMILY,
    penalty.FAMILY,
    slenderness.BENT,
    slenderness.ROLLED,
    refinement.FAMILY,
    units.FAMILY,
    mismatch.FAMILY,
    large_increments.FAMILY,
    ends.FAMILY,
    birdcage.FAMILY,
    hockling.FAMILY,
    random_scenes.FAMILY,
    ropes.FAMILY,
)
