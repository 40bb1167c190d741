"""All families, in the order of the page."""

from __future__ import annotations

import birdcage
import crossing_angle
import ends
import forming
import friction
import hockling
import knots
import large_increments
import mismatch
import penalty
import random_scenes
import refinement
import remedies
import ropes
import slack
import slenderness
import units

FAMILIES = (
    forming.FAMILY,
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
    slack.STRAND,
    slack.BRAID,
    knots.FAMILY,
    hockling.FAMILY,
    random_scenes.FAMILY,
    ropes.FAMILY,
)
