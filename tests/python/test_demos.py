"""What demos and documentation show is true: scenes load, pages run, quoted files are the real ones."""

import re
import runpy
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

from braidx.geometry import build_rope
from braidx.scene import difference, load_scene, scene_from_dict

ROOT = Path(__file__).parents[2]
SCENES = sorted((ROOT / "demos").glob("*.toml"))
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def blocks(page: Path, language: str) -> list[str]:
    """Code blocks of a page that are marked with a language."""
    return re.findall(rf"^```{language}\n(.*?)^```", page.read_text("utf-8"), re.M | re.S)


@pytest.fixture(scope="module")
def first_rope(tmp_path_factory):
    """The names that the page leaves behind, run in an empty folder."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("demo"))
        return runpy.run_path(str(ROOT / "demos" / "demo_first_rope.py"))


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
