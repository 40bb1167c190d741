"""(l) Random ropes: formed from their recipes, brought to rest, pulled, cycled or bent, and judged by their folders."""

from __future__ import annotations

import contextlib
import io
import math
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from bent_judge import BentRun
from braidx.cli.folder import create_folder
from braidx.geometry import build_rope
from braidx.geometry.closed_forms import helix_angle
from braidx.geometry.strand import strand_section
from braidx.output import history, snapshot
from braidx.processes import NotConverged, run
from braidx.processes.sharp_bends import sharpest_bend
from braidx.scene import Bend, Scene, SceneError
from braidx.scene.build import scene_from_dict
from family import Family
from judge import CONVERGED, ENERGY, FAILED, REFUSED, WRONG, Outcome
from rope_judge import RopeRun, row_of
from rope_map import draw_ropes
from rope_recipes import KINDS, NUMBER, Recipe, recipes

FORCE = 0.01  # of the force on the rope, and of the contact forces on a yarn
BURST = 0.03  # of what yarns pull inwards
CONE = 1e-6  # of the largest normal force
HIDDEN = 0.03  # of a radius: overlap that the run does not tell of
UNWOUND = 0.05  # turns
STABILISATION = 0.05  # of the largest energy
TOLD = "the stabilisation did"  # begins what a run says whose results are not to be trusted


def outcome(case: tuple[float, ...], recipe: Recipe) -> Outcome:
    """Checks, runs and judges a rope."""
    started = time.perf_counter()
    quiet = {"pictures": False, "fields": False, "states": True}
    try:
        scene = scene_from_dict({**recipe, "output": quiet}, "rope")
        build_rope(scene)
    except SceneError as error:
        return Outcome(case, REFUSED, str(error))
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place) / "rope"
        create_folder(folder, scene)
        found = judged(case, scene, folder, computed(scene, folder))
    return replace(found, seconds=time.perf_counter() - started)


def computed(scene: Scene, folder: Path) -> str:
    """Runs a scene into a folder; the message if there is no equilibrium."""
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            run(scene, folder)
    except NotConverged as failure:
        return str(failure)
    return ""


def judged(case: tuple[float, ...], scene: Scene, folder: Path, message: str) -> Outcome:
    """What is to be thought of a run that left a folder, and perhaps a message."""
    rows = history.read(folder / "history.csv")
    judge = _of_bent if any(isinstance(step, Bend) for step in scene.steps) else _of_straight
    found = judge(scene, folder)
    wrong = [what for what, is_so in _misplaced(found, scene) if is_so]
    unbalanced = [what for what, is_so in _unbalanced(found) if is_so]
    if unbalanced and TOLD in (folder / "run.log").read_text("utf-8"):
        message = message or "as the run says, its stabilisation did too much: " + "; ".join(
            unbalanced
        )
    else:
        wrong += unbalanced
    return Outcome(
        case,
        WRONG if wrong else FAILED if message else CONVERGED,
        "; ".join(wrong) or message,
        int(rows["Newton iterations"].sum()),
        len(rows["step"]),
        int(rows["cuts"].sum()),
        found["force"],
        found["yarn"],
        found["penetration"],
        1.0 - found["overlap"] / 2.0,
        found["energy"],
        values={
            **{name: found[name] for name in ("burst", "held", "diameter")},
            "bend": _sharpest(folder, scene.yarn.radius),
        },
    )


def _sharpest(folder: Path, radius: float) -> float:
    """Least radius of curvature of all yarns over their own, in the last state that the run has kept."""
    pictures = sorted((folder / "snapshots").glob("*.npz"), key=row_of)
    lines = snapshot.load(pictures[-1]).centre_lines if pictures else []
    return sharpest_bend(lines, np.full(len(lines), radius))[0] if lines else math.nan


def _misplaced(found: dict[str, float], scene: Scene) -> list[tuple[str, bool]]:
    limit = 1.05 * scene.contact.penetration_tolerance
    hidden = found["overlap"] - found["penetration"]
    return [
        (f"penetration {found['penetration']:.3g} r", found["penetration"] > limit),
        (f"hidden overlap of {hidden:.2g} r", hidden > HIDDEN),
        (f"{found['wrong']:.0f} crossings on the wrong side", found["wrong"] > 0),
        (f"yarns passed each other: {found['unwound']:.2g} turns", found["unwound"] > UNWOUND),
        ("not a number", not all(np.isfinite(value) for value in found.values())),
    ]


def _unbalanced(found: dict[str, float]) -> list[tuple[str, bool]]:
    lost = found["energy"] if not found["snapped"] else 0.0
    return [
        (f"the force is off by {found['force']:.1%}", found["force"] > FORCE),
        (f"contacts push outwards {found['burst']:.1%} off", found["burst"] > BURST),
        (f"contact forces on a yarn are off by {found['yarn']:.1%}", found["yarn"] > FORCE),
        (f"friction is {found['cone']:.1e} beyond its cone", found["cone"] > CONE),
        (f"friction work is off by {found['untold']:.1%}", abs(found["untold"]) > ENERGY),
        (f"energy made: {-found['energy']:.1%}", found["energy"] < -ENERGY),
        (f"energy lost: {lost:.1%}", lost > ENERGY),
        (f"stabilisation takes {found['held']:.1%}", found["held"] > STABILISATION),
    ]


MEASURES = ("force", "burst", "yarn", "cone", "energy", "untold", "snapped", "held")
PLACES = ("penetration", "overlap", "wrong", "unwound", "diameter")
NOTHING = dict.fromkeys(MEASURES + PLACES, 0.0)


def _of_straight(scene: Scene, folder: Path) -> dict[str, float]:
    """Worst of what is found in the states of a straight rope."""
    left, rows = RopeRun(scene, folder), history.read(folder / "history.csv")
    found = dict(NOTHING)

    def worst(name: str, values: list[float]) -> None:
        found[name] = float(max([found[name], *values], key=abs))

    shapes = left.formed + left.found
    if not shapes:
        return found
    worst("overlap", [left.overlap(state) for state in shapes])
    found["diameter"] = left.diameter(shapes[-1])
    worst("wrong", [left.wrong_sides(state) for state in shapes])
    worst("unwound", [left.unwound(state) for state in shapes])
    if left.goes_on:
        last = slice(shapes[0].row, None)
        worst("penetration", list(rows["max penetration / radius (-)"][last]))
    else:  # held ends are where they are
        worst("penetration", [left.penetration(state) for state in shapes])
    most = max([left.elastic(state) for state in left.found], default=1.0)
    worst("held", [left.stabilisation(state) / most for state in left.found[1:]])
    worst("cone", [left.beyond_cone(state) for state in left.found])
    pulled = max([left.force(state) for state in left.found], default=1.0)
    worst("force", [abs(left.axial_force(s) - left.force(s)) / pulled for s in left.found])
    if left.goes_on:
        worst("burst", [abs(left.burst(state)) for state in left.found])
        worst("yarn", [left.unbalanced(state) for state in left.found])
    for begin, end in left.ways():
        taken = left.taken(begin, end)
        worst("energy", [taken.lost])
        if scene.yarn.model == "beam":  # friction of cables leaves couples that they do not take
            worst("untold", [taken.untold])
        worst("snapped", [left.gives_way(begin, end)])
    return found


def _of_bent(scene: Scene, folder: Path) -> dict[str, float]:
    """Worst of what is found in the states of a bent rope."""
    left, found = BentRun(scene, folder), dict(NOTHING)
    if not left.found:
        return found
    pictures, rows = left.found, left.rows
    found["overlap"] = max(left.overlap(picture) for picture in pictures)
    found["wrong"] = max(left.wrong_sides(picture) for picture in pictures)
    found["force"] = left.force_error()
    found["penetration"] = float(rows["max penetration / radius (-)"][left.ways].max())
    # Of the largest energy until then: what little there is of it at first says nothing.
    found["held"] = float(rows["stabilisation residual share (-)"][left.ways][-1])
    if isinstance(scene.steps[-1], Bend) and left.found[-1].name == "bent":
        found["energy"] = left.energy_error()
    return found


def random_rope(number: float, kind: float) -> Outcome:
    """One of the random ropes.

    Args:
        number: Of its recipe.
        kind: Number of its kind, for the map.
    """
    recipe = recipes()[int(number)][1]
    found = outcome((number, kind), recipe)
    friction = recipe["contact"]["friction"]
    return replace(found, values={**found.values, "angle": _angle(recipe), "friction": friction})


def _angle(recipe: Recipe) -> float:
    """Of the outermost yarns from the axis, degrees."""
    braid = recipe.get("braid", {})
    if braid:
        return float(braid.get("angle_from_axis", 90.0 - braid.get("angle", 0.0)))
    scene = scene_from_dict(recipe)
    around = max(strand_section(scene.strand, scene.yarn.radius).ring_radius)
    return math.degrees(helix_angle(around, scene.rope.pitch))


FAMILY = Family(
    "ropes",
    "Random ropes",
    ("number", "kind"),
    (tuple(float(n) for n in range(NUMBER)), tuple(float(k) for k in range(len(KINDS)))),
    random_rope,
    "Strands of two to seven twisted yarns, braids of one to three yarns per strand, open and jammed, with a "
    "rigid core or none, and a few bent over a sheave: radii of 0.2 to 3 mm, moduli of 2 to 150 GPa, friction up "
    "to 0.6, cables and beams with bundle factors of 1e-3 to 0.1, periodic or held ends. They are formed, brought "
    "to rest, and pulled or cycled to some tenths of a percent. What the run leaves in its folder is judged by "
    "code of its own: the force on the rope against tensions and contacts of all its sections, contacts against "
    "what yarns pull inwards, the forces on each yarn, the cone of friction, overlaps, the side of every "
    "crossing, how often each yarn winds about each other one, and the work of pulling.",
    means=(
        "No rope is wrong. All 60 strands are found, and of 130 braids 53 of the 54 whose yarns are less than 24 "
        "degrees from the axis. What stops steeper ones (48 of 75) is that their yarns hook into each other: "
        "pulled taut without room they are bent more sharply than one that lies across another, which has twice "
        "its own radius (the dashed line). Of 19 ropes bent to 1.7 and less none is found, of those above 2 all "
        "but eight, four of which had hooked when they stopped, after the last state on the map; the message says "
        "so. A longer pitch, thinner yarns or a thick core help; other steps, penalties, viscosities, more "
        "elements and beams did not. Friction, the model of yarns and the kind of ends hardly matter. Ropes bent "
        "over a sheave are the hardest, 4 of 10: cables cannot be clamped, and of two "
        "with beams the stabilisation did more work than an equilibrium may leave to it, which ends the run."
    ),
    draw=draw_ropes,
    chosen=lambda number, kind: recipes()[int(number)][0] == list(KINDS)[int(kind)],
)
