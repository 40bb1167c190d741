"""Scenes without an exact answer, run as a user runs them: a braid that is pulled, and one that is bent."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[3]
sys.path += [str(ROOT / "tests" / "python" / "processes"), str(ROOT / "tests" / "benchmark")]

from bench import Values  # noqa: E402
from scaling import scene_of  # noqa: E402
import numpy as np  # noqa: E402
from tiny_bent_rope import TINY  # noqa: E402

from braidx.processes import run  # noqa: E402
from braidx.processes.bending.crossings import FILE, read_crossings  # noqa: E402
from braidx.scene import Bend, Form, Scene, load_scene  # noqa: E402

PULLED = ROOT / "demos" / "small_rope.toml"
SLID, MEAN = "relative displacement (mm)", "mean_relative_displacement"
QUIET = ("output.pictures=false", "output.fields=false")
TRAVEL = 3.0  # of the ends of the rope that is bent, mm


def pulled(**options: Any) -> Scene:
    """The braid of eight yarns of demos/small_rope.toml, formed and pulled."""
    return divided(load_scene(PULLED, [*QUIET, *words(options)]), options)


def twelve(**options: Any) -> Scene:
    """Paper 1's rope with single yarns for its strands, twelve of them, one pitch."""
    return divided(scene_of(12, 1, [*QUIET, *words(options)]), options)


def bent(**options: Any) -> Scene:
    """The smallest braid of the tests, four yarns about a core, two pitches, formed and bent."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "bent.toml"
        path.write_text(TINY, "utf-8")
        given = ["steps.bend.increments=30", f"steps.bend.travel={TRAVEL}", *words(options)]
        scene = load_scene(path, [*QUIET, *given])
    steps = tuple(step for step in scene.steps if isinstance(step, (Form, Bend)))
    return divided(replace(scene, steps=steps, heat=None), options)


def divided(scene: Scene, options: dict[str, Any]) -> Scene:
    """The scene with the mesh and the penetration that options give, or else with the defaults, not with its own."""
    yarn = {name: options.get(f"yarn__{name}") for name in ("degree", "elements_per_pitch")}
    depth = options.get("contact__penetration_tolerance")
    contact = replace(scene.contact, penetration_tolerance=depth)
    return replace(scene, yarn=replace(scene.yarn, **yarn), contact=contact)


SCENES = {"pulled": pulled, "twelve": twelve, "bent": bent}


def computed(name: str) -> Callable[..., Values]:
    """What computes a scene with options."""
    return lambda **options: results(SCENES[name](**options))


def words(options: dict[str, Any]) -> list[str]:
    """What --set is given; a pair of underscores stands for the dot."""
    return [f"{name.replace('__', '.')}={value}" for name, value in options.items()]


def results(scene: Scene) -> Values:
    """Numbers of summary.json; of a bent rope also the mean relative displacement of all crossings, mm."""
    with tempfile.TemporaryDirectory() as folder:
        summary = run(scene, Path(folder))
        table = Path(folder) / FILE
        slid = read_crossings(table)[SLID] if table.exists() else np.empty(0)
    found = {name: entry["value"] for name, entry in summary["results"].items()}
    values = {name: float(value) for name, value in found.items() if value is not None}
    return values | ({MEAN: float(np.nanmean(slid))} if len(slid) else {})
