"""What all studies take from summary.json."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path

SECONDS = "seconds"


def summary_values(folder: Path, columns: Mapping[str, str]) -> dict[str, float]:
    """Results of a run, and its seconds.

    Args:
        folder: Of the run.
        columns: Name of the result by column.
    Returns:
        Numbers by column; NaN where the run does not have one.
    """
    summary = json.loads((folder / "summary.json").read_text("utf-8"))
    results = {name: entry["value"] for name, entry in summary["results"].items()}
    values = {
        column: math.nan if results.get(name) is None else float(results[name])
        for column, name in columns.items()
    }
    phases = summary["cost"]["phases"].values()
    return {**values, SECONDS: sum(float(phase["seconds"]) for phase in phases)}
