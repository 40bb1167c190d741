"""Rows of the table of a scene in which a rope is bent over a sheave."""

from __future__ import annotations

import numpy as np

from braidx.geometry import Rope, outer_diameter
from braidx.geometry.bending_checks import inner_radius
from braidx.scene import Scene

BLOCK = {"cable": 3, "beam": 9}  # unknowns per node


def bending_rows(scene: Scene) -> dict[str, str]:
    """Core and sheave, where there are such."""
    rows = {}
    if scene.core is not None:
        rows["core"] = _core_text(scene)
    if scene.sheave is not None:
        rows["sheave"] = _sheave_text(scene)
    return rows


def own_unknowns(scene: Scene, rope: Rope) -> str:
    """Unknowns of all yarns in their own models, before end conditions, and what these are."""
    models = [scene.yarn.model_of(yarn) for yarn in range(rope.num_yarns)]
    names = list(dict.fromkeys(models))
    if "auto" in names:
        return "those of the models chosen when it runs, auto"
    nodes = len(rope.centre_lines[0])
    total = sum(_yarn_unknowns(scene, model, nodes) for model in models)
    about = "about " if {"solid", "mixed"} & set(names) else ""
    plural = ", ".join(name if name == "mixed" else f"{name}s" for name in names)
    return f"{about}{round(total)} as {plural}"


def _layers(scene: Scene) -> int:
    """Elements of a solid yarn along the whole sample."""
    per_pitch = scene.yarn.solid_elements_per_pitch or scene.yarn.elements_per_pitch
    return per_pitch * scene.rope.pitches


def _yarn_unknowns(scene: Scene, model: str, nodes: int) -> float:
    if model in BLOCK:
        return BLOCK[model] * nodes
    solid = _solid_unknowns(scene)
    if model == "solid":
        return solid
    assert scene.yarn.solid_stretch is not None
    share = scene.yarn.solid_stretch / scene.length
    return share * solid + (1.0 - share) * BLOCK[scene.yarn.outer_model] * nodes


def _solid_unknowns(scene: Scene) -> float:
    """Three per node of layers with a square of quadrilaterals and one ring about it."""
    side, degree = scene.yarn.seeds // 4, scene.yarn.solid_degree
    section = (side * degree + 1) ** 2 + scene.yarn.seeds * degree**2
    return 3.0 * section * (_layers(scene) * degree + 1)


def _core_text(scene: Scene) -> str:
    core = scene.core
    assert core is not None
    bore = f", bore {core.inner_radius:g} mm" if core.inner_radius else ""
    law = "" if core.model == "rigid" else f", {core.law}, {core.modulus:g} MPa"
    clearance = inner_radius(scene) - core.radius
    room = (
        "touching the yarns" if np.isclose(clearance, 0.0) else f"{clearance:.3g} mm to the yarns"
    )
    mesh = f", mesh {core.mesh}" if core.mesh else ""
    return f"{core.model}, radius {core.radius:g} mm{bore}{law}{mesh}, {room}"


def _sheave_text(scene: Scene) -> str:
    sheave = scene.sheave
    assert sheave is not None
    round_ = sheave.groove == "round"
    groove = f"groove of {sheave.groove_radius:g} mm" if round_ else "flat"
    ratio = sheave.diameter / outer_diameter(scene)
    return f"diameter {sheave.diameter:g} mm, D/d {ratio:.2f}, {groove}, {sheave.motion}"
