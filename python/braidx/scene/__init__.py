"""Scenes: a rope, its model and its programme, as TOML files and as frozen dataclasses."""

from braidx.scene.accuracy import followed, level_of
from braidx.scene.bending import Bend, BendCycles, RunOver, Straighten
from braidx.scene.build import scene_from_dict
from braidx.scene.compare import difference
from braidx.scene.core import Core
from braidx.scene.ends import EndConditions, EndGroup
from braidx.scene.errors import SceneError
from braidx.scene.heat import Heat
from braidx.scene.load import load_scene
from braidx.scene.material import Material, YarnModel
from braidx.scene.numerics import (
    ContactOptions,
    Expected,
    OutputOptions,
    SolverOptions,
)
from braidx.scene.recipe import BraidRecipe, RopeRecipe, StrandRecipe
from braidx.scene.scene import Scene
from braidx.scene.sheave import Sheave
from braidx.scene.step import Step
from braidx.scene.steps import Cycle, Form, Hold, Pull, Settle
from braidx.scene.write import to_toml

__all__ = [
    "Bend",
    "BendCycles",
    "BraidRecipe",
    "ContactOptions",
    "Core",
    "Cycle",
    "EndConditions",
    "EndGroup",
    "Expected",
    "Form",
    "Heat",
    "Hold",
    "Material",
    "OutputOptions",
    "Pull",
    "RopeRecipe",
    "RunOver",
    "Scene",
    "SceneError",
    "Settle",
    "Sheave",
    "SolverOptions",
    "Step",
    "Straighten",
    "StrandRecipe",
    "YarnModel",
    "difference",
    "followed",
    "level_of",
    "load_scene",
    "scene_from_dict",
    "to_toml",
]
