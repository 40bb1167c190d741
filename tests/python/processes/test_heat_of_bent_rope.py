"""Heat of a bent rope against a body of one temperature, whose course is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tiny_bent_rope import TINY

from braidx.geometry.bending_checks import outer_diameter
from braidx.output.interlacing_points import InterlacingPoints
from braidx.processes.bending.crossings import Crossings, read_crossings, write_crossings
from braidx.processes.bending.heat import rope_heat
from braidx.scene import Heat, OutputOptions, load_scene

WORK = np.array([3.0, 5.0, 0.0])  # mJ
HEAT = Heat(frequency=2.0, cycles=1200, conductivity_axial=1e7, conductivity_radial=1e7)


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "tiny.toml"
    path.write_text(TINY, "utf-8")
    return replace(load_scene(path), heat=HEAT, output=OutputOptions(fields=False, pictures=False))


@pytest.fixture
def crossings(scene):
    z = np.array([0.2, 0.5, 0.9]) * scene.length
    points = InterlacingPoints(
        yarn_a=np.array([0, 1, 1]),
        yarn_b=np.array([2, 2, 3]),
        s_a=z,
        s_b=z,
        position=np.stack([0 * z, np.array([-1.6, 1.6, 1.6]), z], axis=1),
        distance=np.full(3, 1.2),
    )
    return Crossings(points, np.array([0.1, np.nan, 0.3]), 10 * WORK, 4 * WORK, WORK)


def test_a_rope_that_conducts_perfectly_has_one_temperature(scene, crossings, tmp_path):
    results = rope_heat(scene, crossings, tmp_path)
    power = 2.0 * 8e-3  # W
    radius = outer_diameter(scene) / 2.0
    surface, volume = 2 * np.pi * radius * scene.length, np.pi * radius**2 * scene.length
    rise = power / (1e-6 * HEAT.convection * surface)
    lag = 1e-9 * HEAT.density * HEAT.heat_capacity * volume / (1e-6 * HEAT.convection * surface)
    assert results["heating_power"] == pytest.approx(power, rel=1e-12)
    assert results["temperature_steady_max"] - 20.0 == pytest.approx(rise, rel=1e-4)
    # Backward Euler, 100 steps of 6 s.
    course = 1.0 - (1.0 + 6.0 / lag) ** -100
    assert results["temperature_max"] - 20.0 == pytest.approx(rise * course, rel=1e-4)
    assert 0.2 < course < 0.99  # neither end of the course is tested by the other
    assert not (tmp_path / "figures").exists() and not (tmp_path / "fields").exists()


def test_picture_and_file_where_they_are_wanted(scene, crossings, tmp_path):
    shown = replace(scene, output=OutputOptions())
    rope_heat(shown, crossings, tmp_path)
    assert (tmp_path / "figures" / "temperature.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "fields" / "temperature.vtp").stat().st_size > 1000


def test_nothing_without_heat_or_without_a_whole_cycle(scene, crossings, tmp_path):
    assert rope_heat(replace(scene, heat=None), crossings, tmp_path) == {}
    assert rope_heat(scene, replace(crossings, cycle_work=None), tmp_path) == {}


def test_a_table_is_read_as_it_was_written(crossings, tmp_path):
    write_crossings(crossings, tmp_path / "c.csv")
    table = read_crossings(tmp_path / "c.csv")
    np.testing.assert_allclose(table["relative displacement (mm)"], [0.1, np.nan, 0.3])
    np.testing.assert_allclose(table["friction work per cycle (mJ)"], WORK)
    # The sheave is on the side of -y.
    np.testing.assert_allclose(table["angle (degrees)"], [0.0, -180.0, -180.0], atol=1e-6)
    write_crossings(replace(crossings, cycle_work=None), tmp_path / "c.csv")
    assert np.isnan(read_crossings(tmp_path / "c.csv")["friction work per cycle (mJ)"]).all()
