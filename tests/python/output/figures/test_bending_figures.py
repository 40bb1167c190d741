"""All figures of a small bent rope."""

from __future__ import annotations

import logging
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from bent_example import YARN, bent_rope, tube_skin
from matplotlib.image import imread
from PIL import Image

from braidx.output.figures import animation, bent, draw_all, style
from braidx.output.figures.bending import draw_bending
from braidx.output.figures.shapes import STRESS_MAP, Colouring, shapes, stress_scale, stresses
from braidx.output.figures.cross_section_bent import crown_outlines
from braidx.output.figures.unrolled import from_sheave


@pytest.fixture(autouse=True)
def coarse(monkeypatch: pytest.MonkeyPatch) -> None:
    """Small pictures: the tests look at what is drawn, not at how finely."""
    monkeypatch.setattr(style, "DPI", 40)
    monkeypatch.setattr(bent, "PIXELS_ACROSS", 150)
    monkeypatch.setattr(animation, "WIDTH", 120)


def small(share: float, **options: object):
    return bent_rope(share, f"{share}", pitches=2.0, nodes=49, **options)


ALL = {
    "bent",
    "bent_aslant",
    "bent_stress",
    "bent_stress_aslant",
    "crown_section",
    "contact_map",
    "slip_map",
    "bending",
}


@pytest.mark.parametrize("solids, groove", [(False, None), (True, 7.0)])
def test_every_figure_is_drawn_and_not_blank(
    tmp_path: Path, solids: bool, groove: float | None
) -> None:
    run = [small(share, solids=solids, groove=groove) for share in (0.0, 1.0)]
    drawn = draw_all(tmp_path, run, tmp_path / "history.csv")
    assert {path.stem for path in drawn} == ALL
    for path in drawn:
        if path.suffix == ".png":
            assert imread(path)[..., :3].std() > 0.02, path.name


def test_a_figure_that_fails_is_reported_and_the_rest_is_drawn(
    tmp_path: Path, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(logging.getLogger("braidx"), "propagate", True)
    one = small(1.0)
    idle = replace(one.contacts, normal_force=0.0 * one.contacts.normal_force)
    other_mesh = bent_rope(0.0, pitches=2.0, nodes=25)
    last = replace(one, contacts=idle, axial_stress=None, tension=None)
    drawn = draw_bending(tmp_path, [last], reference=other_mesh)
    assert "contact_map left out" in caplog.text and "slip_map left out" in caplog.text
    assert {path.stem for path in drawn} == {"bent", "bent_aslant", "crown_section"}
    assert draw_bending(tmp_path, []) == []


def test_the_movie_has_a_frame_per_state_and_one_size(tmp_path: Path) -> None:
    run = [small(share) for share in (0.0, 0.5, 1.0)]
    path = animation.draw_bending_movie(run, tmp_path / "a.gif", width=120)
    with Image.open(path) as movie:
        assert movie.n_frames == 3 and movie.size[0] == 120 and movie.info["loop"] == 0
        frames = []
        for number in range(3):
            movie.seek(number)
            frames.append(np.asarray(movie.convert("RGB"), dtype=float))
    assert np.abs(frames[1] - frames[0]).mean() > 2.0
    assert np.abs(frames[2] - frames[1]).mean() > 2.0
    with pytest.raises(ValueError, match="two or more"):
        animation.draw_bending_movie(run[:1], tmp_path / "b.gif")


def test_a_yarn_is_a_tube_only_where_it_has_no_skin() -> None:
    whole = small(1.0)
    line = whole.centre_lines[0]
    mixed = replace(whole, skins=(tube_skin(line[20:31], 0, YARN),), core=None)
    parts = shapes(mixed)
    assert len(parts) == 2 + 11 + 1  # two ends of yarn 0, eleven yarns, one skin
    ends = [part.points[-2:] for part in parts[:2]]  # middles of the lids
    np.testing.assert_allclose(ends[0], line[[0, 20]], atol=1e-12)
    np.testing.assert_allclose(ends[1], line[[30, 48]], atol=1e-12)
    assert len(stresses(mixed)) == 12 * 48 - 10 + 10 * 12  # ten segments give way to ten rings
    solid = small(1.0, solids=True)
    assert len(shapes(solid)) == 13  # twelve yarns and the core, all skins
    assert len(shapes(whole)) == 14  # the core is a tube with a bore


def test_the_section_at_the_crown_has_every_yarn_once() -> None:
    tubes, owners = crown_outlines(small(1.0), small(1.0).sheave.centre[2])
    assert sorted(owners) == list(range(12))
    skins, owners = crown_outlines(small(1.0, solids=True), small(1.0).sheave.centre[2])
    assert sorted(owners) == list(range(-1, 12))


def test_stress_that_is_missing_is_named(tmp_path: Path) -> None:
    bare = replace(small(1.0), axial_stress=None)
    with pytest.raises(ValueError, match="has no stress"):
        bent.draw_bent(bare, tmp_path / "a.png", Colouring.STRESS)


def test_angles_are_counted_from_the_sheave() -> None:
    angle = np.deg2rad([-90.0, 0.0, 90.0, 180.0])
    np.testing.assert_allclose(from_sheave(angle), [0.0, 90.0, -180.0, -90.0])


def test_stress_is_shown_with_its_sign() -> None:
    one = replace(small(1.0), core=None)
    signed = tuple(np.where(np.arange(len(s)) % 2, -50.0, 150.0) for s in one.axial_stress)
    scale = stress_scale(replace(one, axial_stress=signed))
    assert (scale.vmin, scale.vmax) == (-50.0, 150.0)
    pulled = tuple(np.full(len(s), 150.0) for s in one.axial_stress)
    pushed = tuple(np.full(len(s), -50.0) for s in one.axial_stress)
    for stress, value in ((pulled, 1.0), (pushed, 0.0)):
        for part in shapes(replace(one, axial_stress=stress), scale):
            np.testing.assert_allclose(part.colour, [STRESS_MAP(value)[:3]] * len(part.colour))
