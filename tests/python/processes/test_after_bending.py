"""A tiny rope bent, straightened and bent again: its table of crossings, and its heat."""

from __future__ import annotations

import csv

import numpy as np
import pytest
from tiny_bent_rope import TINY

from braidx.processes.bending.crossings import COLUMNS, read_crossings
from braidx.scene import load_scene


@pytest.fixture(scope="module")
def bent(run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("bent")
    scene = folder / "tiny.toml"
    scene.write_text(TINY, "utf-8")
    # Its few increments go far, and turn sections by much.
    finished = run(folder / "run", "--set", "solver.director_viscosity=100", scene=scene)
    assert finished.code == 0, finished.stderr
    return finished


def test_the_table_agrees_with_the_summary(bent):
    table, values = read_crossings(bent.folder / "crossings.csv"), bent.values
    assert len(table["z (mm)"]) == values["crossing_points"] > 0
    slid = table["relative displacement (mm)"]
    assert np.nanmax(slid) == pytest.approx(values["relative_displacement_max"], rel=1e-8)
    crown = load_scene(bent.folder / "scene.toml").crown
    far = np.round(np.abs(table["z (mm)"] - crown), 1)
    mean = values["relative_displacement"]
    four = np.lexsort((-np.abs(table["angle (degrees)"]), far))[:4]
    assert slid[four].mean() == pytest.approx(mean, rel=1e-8)
    assert (table["normal force (N)"] >= 0.0).all() and table["normal force (N)"].max() > 0.0
    assert set(table["yarn a"]) == {0.0, 1.0} and set(table["yarn b"]) == {2.0, 3.0}


def test_work_at_crossings_is_part_of_all_friction(bent):
    table = read_crossings(bent.folder / "crossings.csv")
    work, cycle = table["friction work (mJ)"], table["friction work per cycle (mJ)"]
    rows = bent.history
    whole = rows["friction work (mJ)"]
    assert 0.0 < work.sum() <= whole[-1] * (1 + 1e-9)
    first = int(np.flatnonzero(rows["travel (mm)"] == 1.0)[0])
    assert 0.0 < cycle.sum() <= (whole[-1] - whole[first]) * (1 + 1e-9)
    assert (cycle <= work * (1 + 1e-8)).all()


def test_the_heat_is_that_of_the_last_cycle(bent):
    table, values = read_crossings(bent.folder / "crossings.csv"), bent.values
    power = 1e-3 * 0.5 * table["friction work per cycle (mJ)"].sum()
    assert values["heating_power"] == pytest.approx(power, rel=1e-6)
    assert 20.0 < values["temperature_max"] <= values["temperature_steady_max"] + 1e-9
    # Neither pictures nor fields were asked for.
    assert not (bent.folder / "figures").exists() and not (bent.folder / "fields").exists()


def test_columns_of_the_file(bent):
    with (bent.folder / "crossings.csv").open(newline="", encoding="utf-8") as stream:
        assert tuple(next(csv.reader(stream))) == COLUMNS
