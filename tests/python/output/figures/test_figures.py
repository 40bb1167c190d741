"""All figures of a small synthetic run."""

from __future__ import annotations

import logging
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread
from rope_example import rope

from braidx.output import snapshot as snapshots_io
from braidx.output.figures import __main__ as again
from braidx.output.figures import curves, draw_all, rope as pictures, style
from braidx.output.core_line import CoreLine
from braidx.output.figures.shapes import CORE_COLOUR, scale_of, shapes
from braidx.output.history import History, HistoryRow, read
from braidx.output.measures import extent
from braidx.output.summary import Reference

REFERENCES = {"rope_axial_stiffness": Reference(9512.0, "paper 1, table 2", 0.1)}


def write_history(path: Path) -> None:
    with History(path) as history:
        for i in range(1, 6):
            row = HistoryRow(i, None, None, 3, 900, 0.1 / i, 0.0, 1.0, "form", 0.1 / i, 0.01)
            history.append(row)
        for i in range(8):
            strain = 0.001 * i
            force = 9000 * max(strain - 0.002, 0.0)
            row = HistoryRow(6 + i, strain, force, 4, 800, 0.01, 0.1 * i, 2.0, "pull", 0.01, 0.001)
            history.append(row)


@pytest.fixture(autouse=True)
def coarse(monkeypatch: pytest.MonkeyPatch) -> None:
    """Small pictures: the tests look at what is drawn, not at how finely."""
    monkeypatch.setattr(style, "DPI", 40)
    monkeypatch.setattr(pictures, "PIXELS_ACROSS", 200)


def test_every_figure_is_drawn_and_not_blank(tmp_path: Path) -> None:
    options = {"pitches": 0.5, "nodes": 21, "strands": 4}
    run = [rope("start", lift=0.0, **options), rope("formed", **options)]
    run.append(rope("70 kN", stressed=True, **options))
    write_history(tmp_path / "history.csv")
    drawn = draw_all(tmp_path, run, tmp_path / "history.csv", REFERENCES)
    assert {path.stem for path in drawn} == {
        "rope",
        "forming",
        "forming_sections",
        "formed_section",
        "loaded_section",
        "yarn_stress",
        "yarn_stress_histogram",
        "force_strain",
        "course",
    }
    for path in drawn:
        assert imread(path)[..., :3].std() > 0.02, path.name


def test_a_figure_that_fails_is_reported_and_the_rest_is_drawn(
    tmp_path: Path, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(logging.getLogger("braidx"), "propagate", True)
    (tmp_path / "history.csv").write_text("")  # no increment yet
    drawn = draw_all(tmp_path, [], tmp_path / "history.csv")
    assert "force_strain left out" in caplog.text
    assert "force_strain" not in {path.stem for path in drawn}


def test_figures_can_be_drawn_again_from_the_files(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "snapshots").mkdir()
    one = rope("formed", pitches=0.25, nodes=7, strands=2)
    snapshots_io.save(one, tmp_path / "snapshots" / "00001.npz")
    assert again.main(tmp_path) == 0
    assert "formed_section.png" in capsys.readouterr().out
    assert again.main(tmp_path / "nothing") == 2


def test_only_increments_that_pull_are_in_the_force_strain_curve(tmp_path: Path) -> None:
    write_history(tmp_path / "history.csv")
    strain, force = curves.pulled(read(tmp_path / "history.csv"))
    assert strain == pytest.approx(0.001 * np.arange(8))
    assert force[-1] == pytest.approx(45.0)


def test_stages_end_with_the_formed_rope() -> None:
    one = rope(nodes=5, strands=2)
    names = ["start", "form 5", "form 10", "form 15", "form 20", "formed", "35 kN", "70 kN"]
    run = [replace(one, name=name) for name in names]
    assert [s.name for s in style.stages(run)] == ["start", "form 10", "form 15", "formed"]
    assert style.formed(run).name == "formed" and style.loaded(run) is None


def test_the_loaded_rope_is_that_of_the_first_pull_as_in_the_results() -> None:
    one = rope(nodes=5, strands=2, stressed=True)
    run = [replace(one, name=name) for name in ("settled", "70 kN", "held", "100 kN", "unloaded")]
    found = style.loaded(run)
    assert found is not None and found.name == "70 kN"
    last = style.loaded(run[:1] + run[-1:])
    assert last is not None and last.name == "unloaded"


def test_hue_tells_layers_apart_and_a_single_strand_its_yarns() -> None:
    colours = style.yarn_colours(rope(nodes=9))
    assert (colours[:42, 2] > colours[:42, 0]).all() and (colours[42:, 2] < colours[42:, 0]).all()
    single = replace(rope(nodes=9), strand=np.zeros(84, dtype=np.int64))
    assert len(np.unique(style.yarn_colours(single), axis=0)) == 3


def test_colours_of_stresses_span_a_tenth_of_their_mean() -> None:
    narrow = scale_of(np.linspace(307.0, 315.0, 101), "a state")
    assert narrow.vmax - narrow.vmin == pytest.approx(0.1 * 311.0)
    assert 0.5 * (narrow.vmax + narrow.vmin) == pytest.approx(311.0)
    wide = scale_of(np.linspace(-100.0, 300.0, 101), "a state")
    assert (wide.vmin, wide.vmax) == pytest.approx((-96.0, 296.0))
    same = scale_of(np.zeros(5), "a state")
    assert same.vmin < 0.0 < same.vmax
    with pytest.raises(ValueError, match="a state has no stress"):
        scale_of(np.empty(0), "a state")


def test_the_core_is_drawn_in_straight_ropes() -> None:
    one = rope("formed", pitches=0.25, nodes=9, strands=4)
    low, high = extent(one)
    line = np.array([[0.0, 0.0, low], [0.0, 0.0, high]])
    with_core = replace(one, core=CoreLine(line, 1.0))
    assert len(shapes(with_core)) == len(shapes(one)) + 1
    core = shapes(with_core)[0]
    np.testing.assert_allclose(np.unique(core.colour, axis=0), [CORE_COLOUR])
    assert np.hypot(core.points[:, 0], core.points[:, 1]).max() == pytest.approx(1.0)
    assert len(shapes(with_core, yarns=[0])) == 1


def test_titles_name_the_force_on_the_rope() -> None:
    one = rope(nodes=5, strands=2)
    assert replace(one, name="settled", force=2.0).state == "settled, 2 kN"
    assert replace(one, name="5 kN", force=5.002).state == "5.002 kN"
    assert replace(one, name="start").state == "start"
