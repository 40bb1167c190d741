"""Contact forces over the unrolled rope."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from braidx.output.bending_measures import crown_of
from braidx.output.contact_table import KINDS
from braidx.output.figures.style import figure, panels, save, styled
from braidx.output.figures.unrolled import from_sheave, unrolled
from braidx.output.rope_axis import axis_of
from braidx.output.snapshot import Snapshot


@styled
def draw_contact_map(snapshot: Snapshot, path: Path) -> Path:
    """Elements that carry a force, one panel per kind of contact; area of dots grows with force.

    Raises:
        ValueError: If no contact carries a force.
    """
    table = snapshot.contacts
    if table is None or not (table.normal_force > 0.0).any():
        raise ValueError(f"Snapshot {snapshot.name!r}: no contact carries a force.")
    axis = axis_of(snapshot)
    low, high = axis.arc_length(np.array([0.0, len(axis.line) - 1.0]))
    crown = np.array([int(np.argmin(np.abs(axis.line[:, 2] - crown_of(snapshot))))], dtype=float)
    kinds = [k for k in range(len(KINDS)) if (table.of(k).normal_force > 0.0).any()]
    page = figure(9.0, 2.9 * len(kinds) + 0.5)
    axes = panels(page, len(kinds), 1, sharex=True)
    for ax, kind in zip(axes, kinds):
        rows = table.of(kind)
        active = np.flatnonzero(rows.normal_force > 0.0)
        active = active[np.argsort(rows.normal_force[active])]
        force = rows.normal_force[active]
        along, angle, _ = axis.unroll(rows.position[active])
        size = 4.0 + 46.0 * force / force.max()
        dots = ax.scatter(
            along, from_sheave(angle), c=force, s=size, cmap="viridis", vmin=0.0, lw=0
        )
        unrolled(ax, low, high, float(axis.arc_length(crown)[0]))
        page.colorbar(dots, ax=ax, pad=0.08).set_label("normal force (N)")
        ax.set_title(
            f"{snapshot.state}, {KINDS[kind]}: {len(force)} elements, largest {force.max():.3g} N\n"
        )
    axes[-1].set_xlabel("length along the rope's axis (mm)")
    return save(page, path)
