"""The judge of ropes finds what is wrong: folders of a right run are spoilt, each in one way."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from braidx.cli.folder import create_folder
from braidx.output import history, snapshot
from braidx.output.snapshot import Snapshot
from braidx.scene import Scene
from braidx.scene.build import scene_from_dict
from judge import CONVERGED, WRONG, Outcome
from rope_recipes import small_braid
from rope_work import Taken
from ropes import computed, judged

QUIET = {"pictures": False, "fields": False, "states": True}
Right = tuple[Scene, Path]


@pytest.fixture(scope="module")
def right(tmp_path_factory: pytest.TempPathFactory) -> tuple[Scene, Path]:
    pull = {"kind": "pull", "to_force": 3.0}
    scene = scene_from_dict({**small_braid("cable", 1.0, pull), "output": QUIET}, "rope")
    folder = tmp_path_factory.mktemp("judge") / "right"
    create_folder(folder, scene)
    assert not computed(scene, folder)
    return scene, folder


@pytest.fixture
def folder(right: Right, tmp_path: Path) -> Path:
    return Path(shutil.copytree(right[1], tmp_path / "spoilt"))


def verdict(right: Right, folder: Path) -> Outcome:
    return judged((0.0,), right[0], folder, "")


def spoil_last(folder: Path, change: Callable[[Snapshot], Snapshot]) -> None:
    last = max((folder / "snapshots").iterdir())
    snapshot.save(change(snapshot.load(last)), last)


def spoil_history(folder: Path, column: str, factor: float) -> None:
    path, at = folder / "history.csv", history.COLUMNS.index(column)
    head, *rows = [line.split(",") for line in path.read_text("utf-8").splitlines()]
    for row in rows[-3:]:
        row[at] = str(float(row[at]) * factor)
    path.write_text("\n".join(",".join(row) for row in (head, *rows)) + "\n", "utf-8")


def test_a_right_run_is_right(right: Right, folder: Path) -> None:
    found = verdict(right, folder)
    assert found.status == CONVERGED, found.why
    assert found.force_error < 1e-3 and abs(found.energy_error) < 0.02


def test_forces_that_tensions_do_not_have_are_found(right: Right, folder: Path) -> None:
    spoil_history(folder, "force (kN)", 1.02)
    assert "the force is off by 2.0%" in verdict(right, folder).why


def test_work_that_is_nowhere_is_found(right: Right, folder: Path) -> None:
    spoil_history(folder, "rope strain (-)", 1.1)
    assert "energy lost" in verdict(right, folder).why


def test_contacts_that_press_too_little_are_found(right: Right, folder: Path) -> None:
    def weaker(picture: Snapshot) -> Snapshot:
        assert picture.contacts is not None
        force = 0.9 * picture.contacts.normal_force
        return replace(picture, contacts=replace(picture.contacts, normal_force=force))

    spoil_last(folder, weaker)
    assert "contacts push outwards" in verdict(right, folder).why


def test_yarns_that_changed_sides_are_found(right: Right, folder: Path) -> None:
    """A yarn is moved to where it lies inside all others."""

    def inside(picture: Snapshot) -> Snapshot:
        first, *others = picture.centre_lines
        thinner = first * [0.3, 0.3, 1.0]
        return replace(picture, centre_lines=(thinner, *others))

    spoil_last(folder, inside)
    found = verdict(right, folder)
    assert found.status == WRONG
    assert "crossings on the wrong side" in found.why or "yarns passed each other" in found.why


def test_overlaps_that_are_not_told_are_found(right: Right, folder: Path) -> None:
    def thicker(picture: Snapshot) -> Snapshot:
        lines = tuple(line * [0.95, 0.95, 1.0] for line in picture.centre_lines)
        return replace(picture, centre_lines=lines)

    spoil_last(folder, thicker)
    assert "hidden overlap" in verdict(right, folder).why


def test_friction_work_that_no_friction_did_is_found() -> None:
    told = Taken(10.0, 5.0, 0.0, 4.0, 6.0, 0.0, 0.5, 5.0, 10.0)
    assert told.lost == pytest.approx(0.0) and told.untold == 0.0
    assert replace(told, told=8.5).untold == pytest.approx(0.2)
    assert replace(told, told=2.5).untold == pytest.approx(-0.1)


def test_windings_are_whole_numbers_and_change_by_passing() -> None:
    from rope_lines import windings

    z = np.linspace(0.0, 10.0, 200)
    turn = 2.0 * np.pi * z / 10.0
    straight = np.stack([0.0 * z, 0.0 * z, z], axis=1)
    around = np.stack([np.cos(turn), np.sin(turn), z], axis=1)
    beside = around + [2.0, 0.0, 0.0]
    found = windings([straight, around, beside])
    assert found[0, 1] == pytest.approx(1.0, abs=1e-3)
    assert found[0, 2] == pytest.approx(0.0, abs=1e-3)
