"""Runs of a study through the command line, one folder each, and the numbers taken from them."""

from __future__ import annotations

import hashlib
import json
import math
import os
import re
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from study import Case, Study

from braidx.geometry import build_rope
from braidx.geometry.bending_checks import outer_diameter
from braidx.geometry.bent_helix import bend_radius, frictionless_slip
from braidx.processes.bending.crossings import FILE, read_crossings
from braidx.scene import OutputOptions, Scene, SceneError, difference, load_scene, to_toml

DEMO = Path(__file__).resolve().parents[2] / "demos" / "bending_over_sheave.toml"
SLIP = "relative displacement (mm)"  # the paper's: mean of the four crossings nearest to the crown
NEAR_CROWN = "maximum near the crown (mm)"  # of the crossings within half a pitch of it
ESTIMATE = "frictionless estimate (mm)"
SECONDS = "seconds"
SUMMARY = {  # results of summary.json by column
    SLIP: "relative_displacement",
    "maximum (mm)": "relative_displacement_max",
    "end force (N)": "end_force",
    "core pressure (MPa)": "core_pressure_max",
    "largest force on the sheave (N)": "yarn_sheave_force_max",
    "friction work (mJ)": "friction_work",
    "crossings on the wrong side": "wrong_side_crossings",
}
CROSSING_FORCE = "largest force at a crossing (N)"


@dataclass(frozen=True)
class Outcome:
    """What came of a case.

    Attributes:
        case: The case.
        values: Numbers by column, of a run that converged; NaN where a run does not have one.
        failure: Why there are none; empty otherwise.
    """

    case: Case
    values: dict[str, float] = field(default_factory=dict)
    failure: str = ""


def run_study(
    study: Study,
    out: Path,
    overrides: Sequence[str] = (),
    only: Sequence[str] | None = None,
) -> list[Outcome]:
    """All cases, or those with the labels `only`, one after the other; one line is printed for each."""
    outcomes = []
    for case in study.cases:
        if only is not None and case.label not in only:
            continue
        outcome = run_case(case, out / "runs", [*study.base, *case.overrides, *overrides])
        slip, seconds = (outcome.values.get(name, math.nan) for name in (SLIP, SECONDS))
        told = outcome.failure or f"relative displacement {slip:.3f} mm, {seconds:.0f} s"
        print(f"{study.name}, {case.label}: {told}", flush=True)
        outcomes.append(outcome)
    return outcomes


def run_case(case: Case, runs: Path, overrides: Sequence[str]) -> Outcome:
    """Runs a case, resumes it, or takes what it left, in a folder of its own below `runs`."""
    try:
        scene = case_scene(overrides)
        build_rope(scene)
    except SceneError as error:
        told = SceneError(error.key, error.cure, error.value)  # without the path of the demo
        return Outcome(case, failure=f"bad input: {told}")
    folder = runs / folder_name(scene)
    if not is_finished(folder, scene):
        failure = _run(scene, folder)
        if failure:
            return Outcome(case, failure=failure)
    return Outcome(case, values_of(scene, folder))


def case_scene(overrides: Sequence[str]) -> Scene:
    """The demo with overrides, which may replace one another; of what it expects only what holds for any rope."""
    scene = load_scene(DEMO, ["output.fields=false", *overrides])
    kept = {name: value for name, value in scene.expected.items() if name != SUMMARY[SLIP]}
    return replace(scene, expected=kept)


def folder_name(scene: Scene) -> str:
    """A name that ropes share only if all of their results are the same."""
    bare = replace(scene, rope=replace(scene.rope, name=""), expected={}, output=OutputOptions())
    digest = hashlib.sha256(to_toml(bare).encode()).hexdigest()[:8]
    assert scene.braid is not None and scene.sheave is not None
    told = (
        f"{scene.yarn.model} {sum(scene.braid.strands_per_direction)} yarns r {scene.yarn.radius:g} "
        f"pitch {scene.rope.pitch:.1f} D {scene.sheave.diameter:g} {digest}"
    )
    return re.sub(r"[^\w.]+", "_", told)


def is_finished(folder: Path, scene: Scene) -> bool:
    """Whether a folder has a run of this scene that converged."""
    summary, copy = folder / "summary.json", folder / "scene.toml"
    if not (summary.is_file() and copy.is_file() and (folder / FILE).is_file()):
        return False
    converged: bool = json.loads(summary.read_text("utf-8"))["converged"]
    return converged and not difference(scene, load_scene(copy))


def _run(scene: Scene, folder: Path) -> str:
    """Starts or resumes a run; why it failed, or nothing."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    path = folder.with_name(folder.name + ".toml")
    path.write_text(to_toml(scene), "utf-8")
    words = [sys.executable, "-m", "braidx", "run", str(path), "--out", str(folder)]
    words += ["--resume"] * (folder / "scene.toml").is_file()
    done = subprocess.run(
        words, capture_output=True, text=True, env={"OPENBLAS_NUM_THREADS": "1", **os.environ}
    )
    if done.returncode == 0:
        return ""
    last = (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[-1]
    why = last.removeprefix("braidx: ").split(" (state so far:")[0]
    return f"not converged: {why}" if done.returncode == 3 else f"failed: {why}"


def values_of(scene: Scene, folder: Path) -> dict[str, float]:
    """The numbers of a finished run, by column."""
    summary = json.loads((folder / "summary.json").read_text("utf-8"))
    results = {name: entry["value"] for name, entry in summary["results"].items()}
    values = {
        column: math.nan if results.get(name) is None else float(results[name])
        for column, name in SUMMARY.items()
    }
    table = read_crossings(folder / FILE)
    near = np.abs(table["z (mm)"] - scene.crown) <= scene.rope.pitch / 2.0
    slid = table["relative displacement (mm)"][near]
    values[NEAR_CROWN] = float(slid[np.isfinite(slid)].max(initial=0.0))
    values[CROSSING_FORCE] = float(table["normal force (N)"].max(initial=0.0))
    values[ESTIMATE] = estimate(scene)
    phases = summary["cost"]["phases"].values()
    values[SECONDS] = sum(float(phase["seconds"]) for phase in phases)
    return values


def estimate(scene: Scene) -> float:
    """Largest relative displacement without friction (geometry/bent_helix.py), mm."""
    assert scene.braid is not None and scene.sheave is not None
    radius = scene.braid.helix_radius
    angle = math.atan(2.0 * math.pi * radius / scene.rope.pitch)
    bent = bend_radius(scene.sheave.diameter, outer_diameter(scene))
    return frictionless_slip(radius, angle, bent)
