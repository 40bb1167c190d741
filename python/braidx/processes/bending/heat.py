"""The heat of a rope that was bent once and back, if it went on like that: temperatures, picture, ParaView file."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
from mpi4py import MPI

from ...geometry.bending_checks import outer_diameter
from ...output.figures.jobs import draw_jobs
from ...output.figures.temperature import draw_temperature, write_temperature
from ...scene import Heat, Scene
from ...system.constraints import Floats
from ...thermal import HeatHistory, RopeHeat, ThermalMaterial, crossing_powers, spread
from .crossings import Crossings

CELLS_PER_RADIUS = 2  # cells across a yarn's radius, and half as many along it
TIME_STEPS = 100


def rope_heat(scene: Scene, crossings: Crossings, folder: Path) -> dict[str, float]:
    """Temperatures (degrees C) after heat.cycles and in the end, and the power of all crossings (W).

    Nothing if the scene has no [heat] or no whole cycle was computed. Only friction at crossings is
    counted. Work of the first process alone.

    Args:
        scene: The scene.
        crossings: With the work of the last cycle.
        folder: Of the run; figures/temperature.png and fields/temperature.vtp go there if the scene wants them.
    """
    if scene.heat is None or crossings.cycle_work is None:
        return {}
    heat = scene.heat
    powers = crossing_powers(crossings.cycle_work, heat.frequency)
    radial, axial = _edges(scene)
    model = RopeHeat(MPI.COMM_SELF, radial, axial, _material(heat))
    places = crossings.points.position
    model.set_source(spread(radial, axial, places, powers, scene.yarn.radius))
    course = model.run(heat.cycles / heat.frequency, TIME_STEPS)
    _write(scene, model, course, folder)
    return {
        "temperature_max": float(course.maximum[-1]),
        "temperature_steady_max": float(model.steady().max()),
        "heating_power": float(powers.sum()),
    }


def _edges(scene: Scene) -> tuple[Floats, Floats]:
    """Borders of the cells of the rope as a cylinder, across and along, mm."""
    radius, inner = outer_diameter(scene) / 2.0, scene.core.inner_radius if scene.core else 0.0
    size = scene.yarn.radius / CELLS_PER_RADIUS
    across = math.ceil((radius - inner) / size)
    along = math.ceil(scene.length / (2.0 * size))
    radial: Floats = np.linspace(inner, radius, across + 1, dtype=np.float64)
    axial: Floats = np.linspace(0.0, scene.length, along + 1, dtype=np.float64)
    return radial, axial


def _material(heat: Heat) -> ThermalMaterial:
    return ThermalMaterial(
        conductivity_axial=heat.conductivity_axial,
        conductivity_radial=heat.conductivity_radial,
        density=heat.density,
        heat_capacity=heat.heat_capacity,
        convection=heat.convection,
        ambient=heat.ambient,
    )


def _write(scene: Scene, model: RopeHeat, course: HeatHistory, folder: Path) -> None:
    radii, heights = model.nodes
    if scene.output.fields:
        (folder / "fields").mkdir(exist_ok=True)
        write_temperature(radii, heights, course.field, folder / "fields" / "temperature.vtp")
    if scene.output.pictures:
        (folder / "figures").mkdir(exist_ok=True)

        def draw(path: Path) -> Path:
            return draw_temperature(
                radii, heights, course.field, path, course.time, course.maximum, scene.crown
            )

        draw_jobs({folder / "figures" / "temperature.png": draw})
