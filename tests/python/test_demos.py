"""What demos and documentation show is true: scenes load, pages run, quoted files are the real ones."""

import re
import runpy
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from braidx.geometry import build_rope
from braidx.scene import difference, load_scene, scene_from_dict

ROOT = Path(__file__).parents[2]
SCENES = sorted((ROOT / "demos").glob("*.toml"))
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def blocks(page: Path, language: str) -> list[str]:
    """Code blocks of a page that are marked with a language."""
    return re.findall(rf"^```{language}\n(.*?)^```", page.read_text("utf-8"), re.M | re.S)


def run_page(name, folder):
    """The names that a page leaves behind, run in an empty folder."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        return runpy.run_path(str(ROOT / "demos" / f"{name}.py"))


@pytest.fixture(scope="module")
def first_rope(tmp_path_factory):
    return run_page("demo_first_rope", tmp_path_factory.mktemp("demo"))


@pytest.fixture(scope="module")
def bent_braid(tmp_path_factory):
    folder = tmp_path_factory.mktemp("demo")
    return run_page("demo_core_filled_double_braid", folder) | {"ran_in": folder}


@pytest.fixture(scope="module")
def beam_and_solid(tmp_path_factory):
    folder = tmp_path_factory.mktemp("demo")
    return run_page("demo_beam_against_solid", folder) | {"ran_in": folder}


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_scenes_can_be_placed_and_say_what_to_expect(path):
    scene = load_scene(path)
    assert build_rope(scene).num_yarns > 1
    assert scene.steps and scene.expected
    assert all(expected.source for expected in scene.expected.values())


def test_the_first_rope_is_that_of_the_smallest_scene(first_rope):
    small = load_scene(ROOT / "demos" / "small_rope.toml")
    assert (
        difference(replace(small, rope=replace(small.rope, name="first_rope")), first_rope["scene"])
        == ""
    )


def test_the_first_rope_forms_and_is_pulled(first_rope):
    summary, rows = first_rope["summary"], first_rope["rows"]
    assert summary["converged"]
    assert summary["results"]["wrong_side_crossings"]["met"] is True
    assert summary["results"]["max_penetration_over_radius"]["value"] < 0.02
    assert rows["force (kN)"][-1] == pytest.approx(5.0, rel=0.01)
    assert min(first_rope["lengths"]) > first_rope["rope"].length


def test_the_bent_braid_keeps_its_motif_and_stays_out_of_itself(bent_braid):
    summary = bent_braid["summary"]
    assert summary["converged"]
    assert summary["results"]["wrong_side_crossings"]["met"] is True
    assert summary["results"]["max_penetration_over_radius"]["value"] < 0.02
    assert bent_braid["rows"]["travel (mm)"][-1] == pytest.approx(8.0)


def test_the_sheave_holds_what_the_ends_of_the_bent_braid_pull(bent_braid):
    assert bent_braid["pressed"] > 1.0
    assert bent_braid["pressed"] == pytest.approx(bent_braid["pulled"], rel=1e-3)


def test_yarns_of_the_bent_braid_slide_less_than_without_friction(bent_braid):
    """And most where the rope is bent, not at its clamped ends."""
    slid, wrapped = bent_braid["slid"], bent_braid["wrapped"]
    crown = slid.mean_at_crown(bent_braid["crown"])
    radius, angle = bent_braid["braid"].helix_radius, bent_braid["angle"]
    assert 0.0 < crown <= slid.maximum()
    assert slid.maximum() < bent_braid["frictionless_slip"](radius, angle, wrapped)
    _, mean, _ = slid.profile(width=bent_braid["rope"].length / 8)
    assert max(mean[0], mean[-1]) < crown
    assert np.all((bent_braid["ratios"] > 0.9) & (bent_braid["ratios"] <= 1.0))


def test_pages_draw_their_pictures(bent_braid, beam_and_solid):
    drawn = [
        bent_braid["folder"] / "figures" / "bent.png",
        bent_braid["folder"] / "figures" / "crown_section.png",
    ]
    assert all((bent_braid["ran_in"] / path).stat().st_size > 10_000 for path in drawn)
    error = beam_and_solid["ran_in"] / beam_and_solid["folder"] / "error.png"
    assert error.stat().st_size > 10_000


@pytest.mark.parametrize("model", ["beam", "half", "solid"])
def test_beam_and_solid_find_the_same_shape(beam_and_solid, model):
    """Errors fall as those of elements of degree 1 until that of the model is left."""
    table, counts = beam_and_solid["table"], beam_and_solid["COUNTS"]
    errors = [table[model, count][0] for count in counts]
    assert errors == sorted(errors, reverse=True)
    assert errors[0] / errors[1] > 2.5
    assert errors[-1] < 0.005


def test_beams_have_fewer_unknowns_than_solids(beam_and_solid):
    table, count = beam_and_solid["table"], beam_and_solid["COUNTS"][-1]
    beam, half, solid = (table[model, count][2] for model in ("beam", "half", "solid"))
    assert 5 * beam < half < solid / 1.5


def test_the_readme_quotes_the_first_scene():
    """Block by block, the whole of small_rope.toml without its heading."""
    text = (ROOT / "demos" / "small_rope.toml").read_text("utf-8")
    quoted = "\n".join(blocks(ROOT / "README.md", "toml"))
    assert quoted.split("\n\n") == text[text.index("[rope]") :].split("\n\n")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_scenes_on_pages_are_valid(page):
    for block in blocks(page, "toml"):
        tables = tomllib.loads(block)
        if "rope" in tables and "yarn" in tables:
            build_rope(scene_from_dict(tables, "page"))


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_code_on_pages_is_python(page):
    for block in blocks(page, "python"):
        compile(block, page.name, "exec")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_and_paths_on_pages_exist(page):
    text = page.read_text("utf-8")
    for target in re.findall(r"\]\((?!https?:|#)([^)#\s]+)", text):
        assert (page.parent / target).exists(), target
    quoted = re.findall(r"`((?:contact_engine|forms|python|demos|tests|docs)/[\w./-]+)`", text)
    for path in quoted:
        assert (ROOT / path).exists(), path
