"""Temperature of a rope: half section, along the axis, and in time."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from braidx.output import vtp
from braidx.output.arrays import Array
from braidx.output.figures.style import AMBER, BLUE, GREY, figure, panels, save, styled


@styled
def draw_temperature(
    radii: Array,
    heights: Array,
    field: Array,
    path: Path,
    time: Array | None = None,
    maximum: Array | None = None,
    crown: float | None = None,
) -> Path:
    """The field over (z, r), its course along axis and surface, and the maximum against time.

    Args:
        radii: Of the nodes, shape (m,), mm.
        heights: Of the nodes along the rope, shape (n,), mm.
        field: Temperature, shape (m, n), degrees C.
        path: Where the figure goes.
        time: Instants, s; without it the course in time is left out.
        maximum: Largest temperature at these instants, degrees C.
        crown: z of the crown, mm, where it is to be marked.
    """
    timed = time is not None and maximum is not None
    page = figure(9.0, 7.6 if timed else 5.2)
    heights_of = [1.0, 1.2, 1.2] if timed else [1.0, 1.2]
    axes = panels(page, len(heights_of), 1, height_ratios=heights_of)
    map_axes, along = axes[0], axes[1]
    colours = map_axes.contourf(heights, radii, field, levels=40, cmap="inferno")
    map_axes.set_ylabel("distance from\nthe axis (mm)")
    map_axes.set_title(f"temperature in the rope, at most {field.max():.1f} °C")
    bar = page.colorbar(colours, ax=map_axes, pad=0.01)
    bar.set_label("°C")
    bar.ax.locator_params(axis="y", nbins=5)
    along.plot(heights, field.max(axis=0), color=AMBER, lw=1.6, label="hottest in the section")
    along.plot(heights, field[-1], color=BLUE, lw=1.6, label="surface")
    along.set_xlabel("z before bending (mm)")
    along.set_ylabel("temperature (°C)")
    along.set_xlim(heights[0], heights[-1])
    map_axes.set_xlim(heights[0], heights[-1])
    if crown is not None:
        along.axvline(crown, color=GREY, lw=0.8, ls=":")
        along.text(
            crown, 1.01, "crown", color=GREY, ha="center", transform=along.get_xaxis_transform()
        )
    along.legend(loc="upper right")
    if time is not None and maximum is not None:
        axes[2].plot(time / 60.0, maximum, color=AMBER, lw=1.6)
        axes[2].set_xlabel("time (min)")
        axes[2].set_ylabel("largest\ntemperature (°C)")
        axes[2].set_xlim(0.0, float(time[-1]) / 60.0)
    for ax in axes[1:]:
        ax.grid(True)
        ax.set_axisbelow(True)
    return save(page, path)


def write_temperature(radii: Array, heights: Array, field: Array, path: Path) -> None:
    """The field on a half section (x = r, z) as a file for ParaView.

    Args:
        radii: Of the nodes, shape (m,), mm.
        heights: Of the nodes, shape (n,), mm.
        field: Temperature, shape (m, n), degrees C.
        path: File name ending in .vtp.
    """
    r, z = np.meshgrid(radii, heights, indexing="ij")
    points = np.stack([r, 0.0 * r, z], axis=-1).reshape(-1, 3)
    first = (
        np.arange(len(radii) - 1)[:, None] * len(heights) + np.arange(len(heights) - 1)
    ).ravel()
    quads = np.stack([first, first + len(heights), first + len(heights) + 1, first + 1], axis=1)
    vtp.write(path, points, {"Polys": quads}, {"temperature (degrees C)": field.ravel()})
