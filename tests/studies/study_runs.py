"""Runs of a study through the command line, one folder each, and the numbers taken from them."""

from __future__ import annotations

import hashlib
import json
import os
import re
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import bent_values
import pulled_values
from study import BENDING, Case, Study
from summaries import SECONDS

from braidx.geometry import build_rope
from braidx.processes.bending.crossings import FILE
from braidx.scene import OutputOptions, Scene, SceneError, Step, difference, load_scene, to_toml


@dataclass(frozen=True)
class Outcome:
    """What came of a case.

    Attributes:
        case: The case.
        values: Numbers by column, of a run that converged; NaN where a run does not have one.
        failure: Why there are none; empty otherwise.
        folder: Where the run is, of a run that converged.
    """

    case: Case
    values: dict[str, float] = field(default_factory=dict)
    failure: str = ""
    folder: Path = Path()


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
        outcome = run_case(study, case, out / "runs", overrides)
        told = outcome.failure or headline(outcome.values)
        print(f"{study.name}, {case.label}: {told}", flush=True)
        outcomes.append(outcome)
    return outcomes


def run_case(study: Study, case: Case, runs: Path, overrides: Sequence[str] = ()) -> Outcome:
    """Runs a case, resumes it, or takes what it left, in a folder of its own below `runs`."""
    try:
        scene = scene_of(study, case, overrides)
        build_rope(scene)
    except SceneError as error:
        told = SceneError(error.key, error.cure, error.value)  # without the path of the demo
        return Outcome(case, failure=f"bad input: {told}")
    folder = runs / folder_name(scene)
    if not is_finished(folder, scene):
        failure = _run(scene, folder)
        if failure:
            return Outcome(case, failure=failure)
    return Outcome(case, values_of(scene, folder), folder=folder)


def case_scene(
    overrides: Sequence[str], demo: Path = BENDING, programme: tuple[Step, ...] = ()
) -> Scene:
    """A demo with overrides, which may replace one another, and other steps after forming where there are some.

    Of what the demo expects only limits are kept, which hold for any rope. Nothing is drawn, which would take a bent
    rope 50 s; `python -m braidx.output.figures FOLDER` draws what there is of a run later.
    """
    scene = load_scene(demo, ["output.pictures=false", "output.fields=false", *overrides])
    kept = {name: value for name, value in scene.expected.items() if value.reference == 0.0}
    steps = (scene.steps[0], *programme) if programme else scene.steps
    return replace(scene, expected=kept, steps=steps)


def scene_of(study: Study, case: Case, overrides: Sequence[str] = ()) -> Scene:
    """The scene of a case."""
    return case_scene([*study.base, *case.overrides, *overrides], study.demo, study.programme)


def folder_name(scene: Scene) -> str:
    """A name that ropes share only if all of their results are the same."""
    bare = replace(scene, rope=replace(scene.rope, name=""), expected={}, output=OutputOptions())
    digest = hashlib.sha256(to_toml(bare).encode()).hexdigest()[:8]
    assert scene.braid is not None
    yarns = sum(scene.braid.strands_per_direction) * sum(scene.strand.rings)
    told = f"{scene.yarn.model} {yarns} yarns r {scene.yarn.radius:g} pitch {scene.rope.pitch:.1f}"
    varied = f"D {scene.sheave.diameter:g}" if scene.sheave else f"mu {scene.contact.friction:g}"
    return re.sub(r"[^\w.]+", "_", f"{told} {varied} {digest}")


def is_finished(folder: Path, scene: Scene) -> bool:
    """Whether a folder has a run of this scene that converged."""
    files = ("summary.json", "scene.toml", *([FILE] if scene.sheave else []))
    if not all((folder / name).is_file() for name in files):
        return False
    converged: bool = json.loads((folder / files[0]).read_text("utf-8"))["converged"]
    return converged and not difference(scene, load_scene(folder / files[1]))


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
    """The numbers of a finished run, by column; the one that a study is about comes first."""
    of_a_kind = bent_values if scene.sheave else pulled_values
    return of_a_kind.values_of(scene, folder)


def headline(values: dict[str, float]) -> str:
    """The number that a study is about, and the cost."""
    name, value = next(iter(values.items()))
    return f"{name} {value:.4g}, {values[SECONDS]:.0f} s"
