"""Colours, sizes and saving, the same in all figures."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import wraps
from pathlib import Path
from typing import Any, ParamSpec

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from braidx.output.measures import layers
from braidx.output.snapshot import Array, Snapshot

DPI = 150
BLUE, AMBER, GREY, INK = "#3f6fa8", "#d69a3c", "#8a8f98", "#23272e"
LAYER_NAMES = ("strands turning right", "strands turning left")
_TONES = (
    ("#3f6fa8", "#6d97c4", "#2c5384"),  # strands that turn right-handed
    ("#d69a3c", "#e8bf78", "#b47c24"),  # strands that turn left-handed
)
_RC = {
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.titlelocation": "left",
    "axes.edgecolor": "#b8bcc4",
    "axes.labelcolor": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "grid.color": "#e6e8ec",
}
P = ParamSpec("P")


def styled(draw: Callable[P, Path]) -> Callable[P, Path]:
    """Decorator of functions that draw: text and lines in the house style."""

    @wraps(draw)
    def wrapper(*args: P.args, **kwargs: P.kwargs) -> Path:
        with rc_context(_RC):
            return draw(*args, **kwargs)

    return wrapper


def yarn_colours(snapshot: Snapshot) -> Array:
    """Colour of each yarn, shape (num_yarns, 3): hue by layer, tone by strand.

    In a single strand the tone tells yarns apart instead.
    """
    strands, position = np.unique(snapshot.strand, return_inverse=True)
    single = len(strands) == 1
    tone = np.arange(snapshot.num_yarns) if single else np.zeros(snapshot.num_yarns, dtype=int)
    layer = layers(snapshot)
    for number in (0, 1):
        members = np.unique(position[layer == number])
        for rank, member in enumerate(members):
            if not single:
                tone[position == member] = rank
    palette = np.array([[to_rgb(colour) for colour in row] for row in _TONES])
    colours: Array = palette[layer, tone % len(_TONES[0])]
    return colours


def figure(width: float, height: float) -> Figure:
    """An empty figure, inches. It belongs to no window and to no global state."""
    page = Figure(figsize=(width, height), dpi=DPI, layout="constrained", facecolor="white")
    FigureCanvasAgg(page)
    return page


def panels(page: Figure, rows: int, columns: int, **options: Any) -> list[Axes]:
    """Axes of a grid in reading order; options as in `Figure.subplots`."""
    return list(np.asarray(page.subplots(rows, columns, squeeze=False, **options)).ravel())


def save(page: Figure, path: Path) -> Path:
    """Write a figure as png, which takes half the time of the default compression and 6 % more room."""
    packing = {"compress_level": 4}
    page.savefig(
        path, dpi=DPI, bbox_inches="tight", metadata={"Software": None}, pil_kwargs=packing
    )
    return path


def stages(snapshots: Sequence[Snapshot], most: int = 4) -> list[Snapshot]:
    """At most `most` of the snapshots from the start to the formed rope, evenly chosen.

    The forming ends with the snapshot named "formed", without one with the last snapshot.
    """
    names = [snapshot.name for snapshot in snapshots]
    last = names.index("formed") if "formed" in names else len(names) - 1
    chosen = np.unique(np.linspace(0, last, min(most, last + 1)).round().astype(int))
    return [snapshots[i] for i in chosen]


def formed(snapshots: Sequence[Snapshot]) -> Snapshot:
    """The formed rope."""
    return stages(snapshots)[-1]


def loaded(snapshots: Sequence[Snapshot]) -> Snapshot | None:
    """The state that results of the loaded rope are those of: the end of the first pull.

    Without a pull it is the last state that has axial stresses, if any.
    """
    pulled = [snapshot for snapshot in snapshots if snapshot.is_pulled]
    stressed = [snapshot for snapshot in snapshots if snapshot.axial_stress is not None]
    return pulled[0] if pulled else stressed[-1] if stressed else None
