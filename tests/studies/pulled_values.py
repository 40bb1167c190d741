"""Numbers, curves and states taken from a run of a straight rope that was pulled (paper 1)."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from summaries import summary_values

from braidx.output import Snapshot, history, snapshot
from braidx.scene import Pull, Scene, load_scene

Array = NDArray[np.float64]

STIFFNESS = "axial stiffness (kN)"
EFFICIENCY = "efficiency (-)"
FORMED = "diameter, formed (mm)"
LOADED = "diameter, loaded (mm)"
STRESS, SCATTER = "mean stress (MPa)", "deviation of stress (MPa)"
WRONG_SIDE = "crossings on the wrong side"
PENETRATION = "deepest penetration over radius (-)"
HELD = "work of the stabilisation over elastic energy (-)"
SUMMARY = {  # results of summary.json by column
    STIFFNESS: "rope_axial_stiffness",
    EFFICIENCY: "efficiency",
    FORMED: "outer_diameter_formed",
    LOADED: "outer_diameter_loaded",
    STRESS: "yarn_stress_mean",
    SCATTER: "yarn_stress_std",
    "friction work (mJ)": "friction_work",
    WRONG_SIDE: "wrong_side_crossings",
    PENETRATION: "max_penetration_over_radius",
    HELD: "stabilisation_residual_share",
}


def values_of(scene: Scene, folder: Path) -> dict[str, float]:
    """The numbers of a finished run, by column."""
    return summary_values(folder, SUMMARY)


@dataclass(frozen=True)
class Curve:
    """The way of a rope from rest, one entry per increment, the first of them at rest."""

    strain: Array  # (n,), -, from the formed rope
    force: Array  # (n,), kN
    friction_work: Array  # (n,), mJ, of the sample, since the start of the run
    held: Array  # (n,), -, work of the stabilisation over the elastic energy
    step: Array  # (n,), number of the step, from 1

    def part(self, first: int, last: int) -> Curve:
        """From one increment to another, both included."""
        kept = slice(first, last + 1)
        return Curve(*(getattr(self, column.name)[kept] for column in fields(self)))


def curve_of(folder: Path) -> Curve:
    """The curve of a run, from the end of settling on."""
    columns = history.read(folder / "history.csv")
    step = np.array([str(name).split()[-1] for name in columns["step"]])
    first = int(np.flatnonzero(step == "settle")[-1])
    names = (
        "rope strain (-)",
        "force (kN)",
        "friction work (mJ)",
        "stabilisation residual share (-)",
    )
    values = [np.asarray(columns[name][first:], dtype=float) for name in names]
    number = np.array([float(str(name).split()[0]) for name in columns["step"][first:]])
    return Curve(*values, number)


def state_of(folder: Path, name: str) -> Snapshot:
    """The state of a run with a name, such as "formed" or "70 kN".

    Raises:
        KeyError: If the run has none.
    """
    for path in sorted((folder / "snapshots").glob("*.npz")):
        found = snapshot.load(path)
        if found.name == name:
            return found
    raise KeyError(f"{folder.name} has no state {name!r}")


def loaded_state(folder: Path) -> Snapshot:
    """The state at the end of the first pull of a run, which its results "loaded" are of."""
    steps = load_scene(folder / "scene.toml").steps
    first = next(step for step in steps if isinstance(step, Pull))
    return state_of(folder, f"{first.to_force:g} kN")


@dataclass(frozen=True)
class Line:
    """Least-squares line y = slope x + constant."""

    slope: float
    constant: float
    r_squared: (
        float  # share of the variance of y that the line accounts for; 1 where y does not vary
    )

    def __call__(self, x: Array) -> Array:
        return self.slope * np.asarray(x) + self.constant


def straight_line(x: Array, y: Array) -> Line:
    """The line through points, shape (n,) each.

    Raises:
        ValueError: If there are fewer than two different abscissae.
    """
    x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    if len(x) < 2 or np.ptp(x) == 0.0:
        raise ValueError(f"straight line: {len(x)} point(s) at one abscissa; give two or more.")
    slope, constant = np.polyfit(x, y, 1)
    left, whole = np.sum((y - slope * x - constant) ** 2), np.sum((y - y.mean()) ** 2)
    return Line(float(slope), float(constant), float(1.0 - left / whole) if whole > 0.0 else 1.0)
