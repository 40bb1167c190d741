"""summary.json: its exact shape, and when a result is met."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from braidx.output.summary import (
    PhaseCost,
    Reference,
    Summary,
    is_met,
    peak_memory_MB,
    read_references,
)

EXPECTED = {
    "rope_axial_stiffness": Reference(9512.0, "paper 1, table 2", 0.1),
    "wrong_side_crossings": Reference(0.0, "topology of the braid", 0.0),
    "efficiency": Reference(0.699, "paper 1, 4.4", None),
    "outer_diameter_formed": Reference(20.0, "paper 1, table 3", 0.05),
}


def test_shape_is_the_contract(tmp_path: Path) -> None:
    summary = Summary("tensile_test", EXPECTED)
    summary.converged = True
    summary.set("rope_axial_stiffness", np.float64(9900.0), "kN", "first loading")
    summary.set("wrong_side_crossings", np.int64(0), "count")
    summary.set("efficiency", 0.5, "-")
    summary.set("friction_work", 3.0, "mJ")
    summary.cost.phases["form"] = PhaseCost(1.5, 30, 90, np.int64(95))  # type: ignore[arg-type]
    summary.write(tmp_path / "summary.json")
    read = json.loads((tmp_path / "summary.json").read_text())
    assert list(read) == ["scene", "converged", "results", "cost"]
    assert read["results"]["rope_axial_stiffness"] == {
        "value": 9900.0,
        "unit": "kN",
        "reference": 9512.0,
        "source": "paper 1, table 2",
        "tolerance": 0.1,
        "met": True,
        "state": "first loading",
    }
    assert read["results"]["wrong_side_crossings"]["met"] is True
    assert read["results"]["efficiency"]["met"] is None
    assert read["results"]["friction_work"]["met"] is None
    assert read["results"]["outer_diameter_formed"]["met"] is False  # never set
    assert not summary.all_met
    assert read["cost"]["phases"]["form"] == {
        "seconds": 1.5,
        "increments": 30,
        "newton_iterations": 90,
        "linear_solves": 95,
    }
    assert set(read["cost"]) == {
        "phases",
        "peak_memory_MB",
        "unknowns",
        "contact_elements",
        "ranks",
        "threads",
    }
    assert read_references(tmp_path / "summary.json") == EXPECTED


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, None])
def test_not_finite_is_written_as_null_and_not_met(tmp_path: Path, value: float | None) -> None:
    summary = Summary("x", EXPECTED)
    summary.set("rope_axial_stiffness", value, "kN")
    summary.set("free", value, "count")
    summary.cost.phases["pull"] = PhaseCost(seconds=float("nan"))
    summary.write(tmp_path / "summary.json")
    text = (tmp_path / "summary.json").read_text()
    assert "NaN" not in text and "Infinity" not in text
    results = json.loads(text)["results"]
    assert results["rope_axial_stiffness"]["value"] is None
    assert results["rope_axial_stiffness"]["met"] is False
    assert results["free"]["met"] is None


def test_tolerance_is_relative_but_absolute_about_zero() -> None:
    assert is_met(10.9, 10.0, 0.1) and not is_met(11.1, 10.0, 0.1)
    assert is_met(-9.1, -10.0, 0.1) and not is_met(9.9, -10.0, 0.1)
    assert is_met(0.019, 0.0, 0.02) and not is_met(0.021, 0.0, 0.02)


def test_peak_memory_is_plausible() -> None:
    assert 10.0 < peak_memory_MB() < 1e5
