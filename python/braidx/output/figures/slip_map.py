"""Relative displacement of crossing yarns over the unrolled rope and along it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from braidx.output.figures.style import AMBER, BLUE, INK, figure, panels, save, styled
from braidx.output.figures.unrolled import from_sheave, unrolled
from braidx.output.interlacing import NEAREST, RelativeDisplacement


@styled
def draw_slip_map(result: RelativeDisplacement, crown: float, path: Path, name: str = "") -> Path:
    """Dots at the interlacing points of the straight rope, and their mean and maximum along it.

    Args:
        result: Relative displacement of all interlacing points.
        crown: z of the crown, mm.
        path: Where the figure goes.
        name: Of the state, for the title.
    Raises:
        ValueError: If there is no interlacing point with a displacement.
    """
    kept = np.flatnonzero(np.isfinite(result.magnitude))
    if not len(kept):
        raise ValueError("slip map: no interlacing point with a relative displacement.")
    place, slip = result.reference.position, result.magnitude
    z, angle = place[:, 2], from_sheave(np.arctan2(place[:, 1], place[:, 0]))
    span = max(float(np.ptp(z[kept])), 1.0)
    low, high = float(z[kept].min()), float(z[kept].max())
    page = figure(9.0, 6.4)
    top, bottom = panels(page, 2, 1, sharex=True, height_ratios=[1.3, 1.0])
    order = kept[np.argsort(slip[kept])]
    dots = top.scatter(z[order], angle[order], c=slip[order], s=34, cmap="viridis", vmin=0.0)
    four = result.at_crown(crown)
    top.scatter(z[four], angle[four], s=90, facecolors="none", edgecolors=INK, lw=1.1)
    unrolled(top, low, high, crown)
    bar = page.colorbar(dots, ax=top, pad=0.08)
    bar.set_label("relative displacement (mm)")
    start = f"{name}: " if name else ""
    top.set_title(
        f"{start}{len(result.reference)} interlacing points; ringed: the {NEAREST} at the crown, mean"
        f" {result.mean_at_crown(crown):.3f} mm\n"
    )
    # Bins of two levels of crossings, or a fiftieth of the rope where levels are denser.
    levels = np.unique(np.round(z[kept], 2))
    spacing = float(np.median(np.diff(levels))) if len(levels) > 1 else span
    middle, mean, highest = result.profile(max(2.0 * spacing, span / 50))
    bottom.plot(middle, highest, "o-", color=AMBER, ms=3, lw=1.2, label="maximum")
    bottom.plot(middle, mean, "o-", color=BLUE, ms=3, lw=1.6, label="mean")
    bottom.axvline(crown, color="#8a8f98", lw=0.8, ls=":")
    bottom.set_ylim(bottom=0.0)
    bottom.set_xlabel("z before bending (mm)")
    bottom.set_ylabel("relative displacement (mm)")
    bottom.grid(True, axis="y")
    bottom.set_axisbelow(True)
    bottom.legend(loc="upper right", ncols=2, bbox_to_anchor=(1.0, 1.13))
    return save(page, path)
