"""Look at a scene before it runs, or at a run."""

from __future__ import annotations

import json
from pathlib import Path

from rich.console import Console

from braidx.cli.report import cost_table, results_table, scene_table
from braidx.geometry import Rope, build_rope
from braidx.scene import Scene, SceneError


def show_scene(scene: Scene, picture: Path, console: Console) -> None:
    """Print what would be computed and draw the start configuration as a PNG."""
    rope = build_rope(scene)
    console.print(scene_table(scene, rope))
    try:
        picture.parent.mkdir(parents=True, exist_ok=True)
        picture.touch()
    except OSError as error:
        cure = f"cannot write to {picture} ({error.strerror}); choose another file."
        raise SceneError("--out", cure) from None
    draw_start(rope, picture)
    console.print(f"start configuration: {picture}")


def draw_start(rope: Rope, picture: Path) -> None:
    """Draw the rope as it is placed, seen from the side."""
    from braidx.output import Snapshot
    from braidx.output.figures.rope import draw_forming

    start = Snapshot(
        name="start configuration",
        centre_lines=rope.centre_lines,
        radius=rope.radius,
        strand=rope.strand,
    )
    draw_forming([start], picture)


def show_run(folder: Path, console: Console) -> None:
    """Print the summary of a run."""
    path = folder / "summary.json"
    try:
        summary = json.loads(path.read_text("utf-8"))
        tables = [results_table(summary), cost_table(summary)]
    except FileNotFoundError:
        cure = "no summary.json here; name a scene or the output folder of a run that has ended."
        raise SceneError("", cure) from None
    except (OSError, ValueError, LookupError, TypeError) as error:
        cure = (
            f"summary.json cannot be read ({type(error).__name__}: {error}); run the scene again."
        )
        raise SceneError("", cure) from None
    for table in tables:
        console.print(table)
