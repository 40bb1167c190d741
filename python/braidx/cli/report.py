"""Tables the commands print: what would be computed, and what came out."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from rich.markup import escape
from rich.table import Table

from braidx.cli.bending_report import BLOCK, bending_rows, own_unknowns
from braidx.geometry import (
    Rope,
    largest_overlap,
    no_rotations,
    one_for_all,
    outer_diameter,
    rotations,
)
from braidx.geometry.closed_forms import cover_factor, helix_angle
from braidx.geometry.strand import strand_section, yarn_pitch
from braidx.scene import Bend, Form, Scene


def scene_table(scene: Scene, rope: Rope) -> Table:
    """What would be computed."""
    rows = {
        "yarns": f"{rope.num_yarns} ({scene.yarn.model}), radius {scene.yarn.radius:g} mm",
        "strands": f"{rope.num_strands} of {_strand_text(scene)}",
    }
    if scene.braid is not None:
        rows |= _braid_rows(scene, rope)
    rows |= bending_rows(scene)
    per_yarn = (len(rope.centre_lines[0]) - 1) // scene.yarn.degree
    rows |= {
        "start": f"outer diameter {outer_diameter(scene):.4g} mm, "
        f"yarns overlap by up to {largest_overlap(rope):.3g} mm",
        "sample": f"{rope.length:g} mm, {scene.rope.pitches} x {rope.pitch:g} mm",
        "elements": f"{rope.num_yarns * per_yarn} of degree {scene.yarn.degree}, "
        f"{rope.length / per_yarn:.3g} mm long",
        "unknowns": _unknowns_text(scene, rope),
        "solved for": _solved_text(scene, rope),
        "steps": ", ".join(step.kind for step in scene.steps) or "none",
        "expected": ", ".join(scene.expected) or "none",
    }
    table = Table(title=escape(scene.name), show_header=False, title_justify="left")
    for name, text in rows.items():
        table.add_row(name, escape(text))
    return table


def _unknowns_text(scene: Scene, rope: Rope) -> str:
    """Unknowns of all yarns before end conditions, in the models that they are formed and computed in."""
    nodes = sum(len(line) for line in rope.centre_lines)
    forming = [step.model for step in scene.steps if isinstance(step, Form)]
    texts = [f"{BLOCK[model] * nodes} as {model}s" for model in forming]
    return ", ".join(dict.fromkeys([*texts, own_unknowns(scene, rope)]))


def _solved_text(scene: Scene, rope: Rope) -> str:
    """The part of the rope that stands for all of it, once it is kept symmetric."""
    alike = (
        rotations(rope) if scene.solver.symmetry and not scene.ends.groups else no_rotations(rope)
    )
    leaders = len(np.unique(alike.leader))
    bends = any(isinstance(step, Bend) for step in scene.steps)
    alone = scene.rope.pitches == 1 or (one_for_all(scene) and not bends)
    if any(isinstance(step, Bend) for step in scene.steps):
        return f"while formed {leaders} of {rope.num_yarns} yarns, bent all of them"
    pitches = "one pitch" if alone else f"{scene.rope.pitches} pitches"
    return f"{pitches}, {leaders} of {rope.num_yarns} yarns"


def _strand_text(scene: Scene) -> str:
    count = " + ".join(map(str, scene.strand.rings))
    pitch = yarn_pitch(scene.strand, scene.rope.pitch)
    if scene.strand.rings == (1,):
        return "1 yarn"
    twist = "untwisted" if math.isinf(pitch) else f"pitch {pitch:g} mm, lay {scene.strand.lay}"
    return f"{count} yarns, {twist}"


def _braid_rows(scene: Scene, rope: Rope) -> dict[str, str]:
    assert scene.braid is not None
    motif, radius = scene.braid.motif, scene.braid.helix_radius
    text = motif if isinstance(motif, str) else f"{len(motif)} x {len(motif[0])} matrix"
    angle = helix_angle(radius, rope.pitch)
    width = 2.0 * strand_section(scene.strand, scene.yarn.radius).outer_radius
    cover = cover_factor(rope.num_strands, width, radius, angle)
    return {
        "crossings": f"{len(rope.crossings)}, {text}",
        "helices": f"radius {radius:g} mm, undulation {scene.braid.undulation:g} mm, cover factor {cover:.3f}",
        "braiding angle": f"{90.0 - math.degrees(angle):.2f} degrees from the horizontal, "
        f"{math.degrees(angle):.2f} from the axis",
    }


def results_table(summary: dict[str, Any]) -> Table:
    """The results of a run beside what was expected."""
    state = "converged" if summary["converged"] else "not converged"
    table = Table(title=escape(f"{summary['scene']}: {state}"), title_justify="left")
    for heading in ("result", "value", "unit", "reference", "met", "state", "source"):
        table.add_column(
            heading,
            justify="right" if heading in ("value", "reference") else "left",
            no_wrap=heading in ("result", "value"),  # where lines are short the others wrap
        )
    for name, result in summary["results"].items():
        met = {True: "yes", False: "[bold red]no", None: ""}[result["met"]]
        reference = _number(result["reference"])
        if result["tolerance"]:
            percent = f"{100.0 * result['tolerance']:g} %"
            reference += f" ± {percent if result['reference'] else _number(result['tolerance'])}"
        numbers = (_number(result["value"]), result["unit"], reference)
        of, source = (escape(result.get(key) or "") for key in ("state", "source"))
        table.add_row(escape(name), *numbers, met, of, source)
    return table


def cost_table(summary: dict[str, Any]) -> Table:
    """What a run cost, phase by phase."""
    cost = summary["cost"]
    sizes = f"{cost['unknowns']} unknowns, {cost['contact_elements']} contact elements"
    memory = f"{cost['peak_memory_MB']:.0f} MB, {cost['ranks']} ranks, {cost['threads']} threads"
    table = Table(title=f"{sizes}, {memory}", title_justify="left")
    columns = ("seconds", "increments", "newton_iterations", "linear_solves")
    table.add_column("phase")
    for column in columns:
        table.add_column(column.replace("_", " "), justify="right")
    for name, phase in cost["phases"].items():
        table.add_row(name, f"{phase['seconds']:.1f}", *(str(phase[c]) for c in columns[1:]))
    return table


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.6g}"
