"""How cost grows: seconds per phase of paper 1's rope with more yarns and more pitches, and fitted exponents.

    ./braidx shell python3 tests/benchmark/scaling.py OUT [--yarns 12 36 84] [--pitches 1 2 4]

Runs each number of yarns at the fewest pitches, and each number of pitches with the fewest yarns, one after the other
in folders below OUT, and prints a table per series. Pitches are all solved for here (solver.symmetry = false): one that
stands for all costs the same however many they are. Runs that exist are not repeated.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from braidx.scene import Form, Pull, Scene, load_scene, to_toml

PAPER = Path(__file__).parents[2] / "demos" / "tensile_test.toml"
RINGS = {1: (1,), 3: (3,), 7: (1, 6)}  # yarns per strand of the twelve
PHASES = ("form", "settle", "pull")


def scene_of(num_yarns: int, pitches: int, overrides: Sequence[str] = ()) -> Scene:
    """Paper 1's rope with 12, 36 or 84 yarns, formed in a bore of the same fill, pulled to the same stress."""
    rings = list(RINGS[num_yarns // 12])
    touching = {3: ["strand.helix_radius=0.94"]}.get(num_yarns // 12, [])
    size = [f"rope.pitches={pitches}", f"strand.rings={rings}", "output.pictures=false"]
    scene = load_scene(PAPER, [*size, *touching, "output.fields=false", *overrides])
    share = num_yarns / 84
    room = (
        1.05 if num_yarns < 84 else 1.0
    )  # strands of three yarns are less round than those of seven
    steps = []
    for step in scene.steps[:3]:
        if isinstance(step, Form) and step.die_diameter is not None:
            step = replace(
                step, die_diameter=room * step.die_diameter * share**0.5 if num_yarns > 12 else None
            )
        elif isinstance(step, Pull) and step.to_force is not None:
            step = replace(step, to_force=step.to_force * share)
        steps.append(step)
    return replace(scene, steps=tuple(steps), expected={})


def measure(scene: Scene, folder: Path) -> dict[str, float]:
    """Seconds per phase, and all together, of a run in a folder.

    Raises:
        RuntimeError: If the run does not converge.
    """
    summary = folder / "summary.json"
    if not summary.exists():
        folder.parent.mkdir(parents=True, exist_ok=True)
        path = folder.with_suffix(".toml")
        path.write_text(to_toml(scene), "utf-8")
        words = [sys.executable, "-m", "braidx", "run", str(path), "--out", str(folder)]
        done = subprocess.run(words, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(f"{folder.name}: {done.stderr.strip()}")
    cost = json.loads(summary.read_text("utf-8"))["cost"]
    seconds = {name: phase["seconds"] for name, phase in cost["phases"].items()}
    return {**seconds, "all": sum(seconds.values()), "memory": cost["peak_memory_MB"]}


def exponent(sizes: Sequence[float], seconds: Sequence[float]) -> float:
    """Slope of log(seconds) over log(sizes), least squares; NaN for fewer than two sizes."""
    if len(sizes) < 2:
        return float("nan")
    return float(np.polyfit(np.log(sizes), np.log(seconds), 1)[0])


def table(quantity: str, rows: dict[int, dict[str, float]]) -> str:
    """Seconds per phase by size, as a Markdown table with the exponents in its last row."""
    columns = [*PHASES, "all"]
    lines = [f"| {quantity} | {' | '.join(f'{c} (s)' for c in columns)} | memory (MB) |"]
    lines.append("|" + " ---: |" * (len(columns) + 2))
    for size, row in rows.items():
        cells = [f"{row[c]:.2f}" for c in columns]
        lines.append(f"| {size} | {' | '.join(cells)} | {row['memory']:.0f} |")
    slopes = [exponent(list(rows), [row[c] for row in rows.values()]) for c in columns]
    lines.append(f"| exponent | {' | '.join(f'{s:.2f}' for s in slopes)} | |")
    return "\n".join(lines)


def run_series(
    out: Path, yarns: Sequence[int], pitches: Sequence[int], overrides: Sequence[str] = ()
) -> list[str]:
    """Both tables; runs are kept in folders below `out`."""

    def row(num_yarns: int, num_pitches: int, *more: str) -> dict[str, float]:
        scene = scene_of(num_yarns, num_pitches, [*overrides, *more])
        name = f"{num_yarns}_yarns_{num_pitches}_pitches{'_each' * bool(more)}"
        return measure(scene, out / name)

    return [
        table("yarns", {n: row(n, min(pitches)) for n in yarns}),
        table("pitches", {n: row(min(yarns), n, "solver.symmetry=false") for n in pitches}),
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=Path)
    parser.add_argument("--yarns", type=int, nargs="+", default=[12, 36, 84], choices=(12, 36, 84))
    parser.add_argument("--pitches", type=int, nargs="+", default=[1, 2, 4])
    parser.add_argument("--set", dest="overrides", action="append", default=[], metavar="KEY=VALUE")
    words = parser.parse_args()
    print("\n\n".join(run_series(words.out, words.yarns, words.pitches, words.overrides)))


if __name__ == "__main__":
    main()
