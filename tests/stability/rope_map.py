"""Map of the random ropes: how steep their yarns are, and how sharply bent; one picture per kind."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from braidx.processes.sharp_bends import HOOKED
from family import Family
from judge import Outcome
from maps import LOOKS
from rope_recipes import KINDS


def draw_ropes(family: Family, outcomes: Sequence[Outcome], path: Path) -> None:
    """Writes the map."""
    figure, axes = plt.subplots(
        2, 2, figsize=(7.6, 6.4), dpi=110, sharey=True, layout="constrained"
    )
    for number, (kind, frame) in enumerate(zip(KINDS, axes.ravel(), strict=True)):
        mine = [outcome for outcome in outcomes if outcome.case[1] == number]
        frame.set_title(f"{kind} ({len(mine)})", fontsize=10)
        for status, (colour, marker, _) in LOOKS.items():
            chosen = [outcome for outcome in mine if outcome.status == status]
            frame.scatter(
                [outcome.values["angle"] for outcome in chosen],
                [outcome.values.get("bend", np.nan) for outcome in chosen],
                s=42,
                c=colour,
                marker=marker,
                linewidths=0,
                zorder=3,
            )
        frame.axhline(HOOKED, color="0.5", linewidth=0.8, linestyle="--")
        frame.set_yscale("log")
        frame.grid(alpha=0.3)
        frame.margins(0.06)
    for frame in axes[1]:
        frame.set_xlabel("angle of yarns from the axis (degrees)")
    for frame in axes[:, 0]:
        frame.set_ylabel("sharpest bend, over yarn radius")
    for status, (colour, marker, label) in LOOKS.items():
        count = sum(outcome.status == status for outcome in outcomes)
        axes[0, 0].scatter([], [], s=60, c=colour, marker=marker, label=f"{label} ({count})")
    figure.legend(loc="outside upper center", ncols=5, frameon=False, fontsize=9)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path)
    plt.close(figure)
