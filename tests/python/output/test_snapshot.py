"""Snapshots: saving, loading, checking."""

from __future__ import annotations

from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest
from bent_example import LAYER, bent_rope, tube_skin
from rope_example import rope

from braidx.output import ContactTable, CoreLine, SheavePicture, SkinPicture, Snapshot, snapshot
from braidx.output.measures import contact_statistics, layers


def test_saved_and_loaded_is_equal(tmp_path: Path) -> None:
    one = rope("70 kN", nodes=9, stressed=True)
    directors = tuple(np.random.default_rng(0).normal(size=(9, 2, 3)) for _ in one.centre_lines)
    one = replace(one, directors=directors)
    snapshot.save(one, tmp_path / "a.npz")
    two = snapshot.load(tmp_path / "a.npz")
    assert two.name == one.name
    for key in ("centre_lines", "directors", "tension", "axial_stress"):
        for a, b in zip(getattr(one, key), getattr(two, key), strict=True):
            np.testing.assert_array_equal(a, b)
    assert one.contacts is not None and two.contacts is not None
    for field in fields(ContactTable):
        np.testing.assert_array_equal(
            getattr(one.contacts, field.name), getattr(two.contacts, field.name)
        )
    assert [path.name for path in tmp_path.iterdir()] == ["a.npz"]


def test_yarns_of_different_node_counts(tmp_path: Path) -> None:
    lines = tuple(np.random.default_rng(n).normal(size=(n, 3)) for n in (2, 5, 3))
    tension = tuple(np.arange(n - 1.0) for n in (2, 5, 3))
    one = Snapshot("x", lines, np.ones(3), np.zeros(3, dtype=np.int64), tension=tension)
    snapshot.save(one, tmp_path / "a.npz")
    two = snapshot.load(tmp_path / "a.npz")
    assert two.contacts is None and two.directors is None and two.tension is not None
    assert [len(line) for line in two.centre_lines] == [2, 5, 3]
    np.testing.assert_array_equal(two.tension[1], tension[1])


def test_arrays_that_do_not_fit_are_named() -> None:
    lines = (np.zeros((4, 3)),)
    with pytest.raises(ValueError, match="radii"):
        Snapshot("x", lines, np.ones(2), np.zeros(1, dtype=np.int64))
    with pytest.raises(ValueError, match="axial_stress"):
        Snapshot("x", lines, np.ones(1), np.zeros(1, dtype=np.int64), axial_stress=(np.ones(4),))
    contacts = rope(nodes=9).contacts
    assert contacts is not None
    with pytest.raises(ValueError, match="slip"):
        replace(contacts, reversible_slip=np.zeros(3))


def test_core_skins_and_sheave_are_saved(tmp_path: Path) -> None:
    one = bent_rope(pitches=0.5, nodes=13, solids=True, groove=7.0)
    snapshot.save(one, tmp_path / "a.npz")
    two = snapshot.load(tmp_path / "a.npz")
    assert len(two.skins) == 13 and two.core is not None and two.sheave is not None
    pairs = [*zip(one.skins, two.skins), (one.core, two.core), (one.sheave, two.sheave)]
    for a, b in [*pairs, (one.contacts, two.contacts)]:
        for field in fields(a):
            np.testing.assert_array_equal(getattr(a, field.name), getattr(b, field.name))
    assert isinstance(two.sheave.radius, float)
    snapshot.save(replace(one, sheave=replace(one.sheave, groove_radius=None)), tmp_path / "a.npz")
    assert snapshot.load(tmp_path / "a.npz").sheave.groove_radius is None


def test_files_without_the_later_columns_can_be_read(tmp_path: Path) -> None:
    one = rope(nodes=9)
    snapshot.save(one, tmp_path / "a.npz")
    with np.load(tmp_path / "a.npz") as data:
        later = ("contacts_kind", "contacts_measure", "contacts_per_area")
        older = {name: data[name] for name in data if name not in later}
    np.savez_compressed(tmp_path / "old.npz", **older)
    two = snapshot.load(tmp_path / "old.npz")
    assert two.core is None and two.sheave is None and two.skins == ()
    assert (two.contacts.kind == 0).all() and not two.contacts.per_area.any()
    assert np.isnan(two.contacts.measure).all()


def test_a_sample_with_core_and_skins_is_repeated() -> None:
    one = replace(bent_rope(share=0.0, pitches=1.0, nodes=37, solids=True), sheave=None)
    two = snapshot.repeated(one, 3)
    length = one.core.line[-1, 2]
    assert len(two.core.line) == 3 * 36 + 1 and two.core.line[-1, 2] == pytest.approx(3 * length)
    assert len(two.skins) == 39
    assert max(skin.points[:, 2].max() for skin in two.skins) > 2.9 * length


def test_layers_are_told_in_a_bent_rope_too() -> None:
    np.testing.assert_array_equal(layers(bent_rope()), LAYER)


def test_penetration_is_measured_by_the_yarn_that_touches_the_sheave() -> None:
    one = bent_rope()
    found = contact_statistics(one)
    assert found.max_penetration_over_radius == pytest.approx(0.015)  # 150 N on a radius of 1 mm
    core_on_sheave = replace(one.contacts, yarn_a=np.full_like(one.contacts.yarn_a, -1))
    found = contact_statistics(replace(one, contacts=core_on_sheave))
    assert found.max_penetration_over_radius == pytest.approx(0.0075)  # the core has 2 mm
    assert len(one.contacts.of(2).gap) == (one.contacts.kind == 2).sum() > 0


def test_skins_of_triangles_and_quadrilaterals() -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]], dtype=float)
    faces = np.array([[0, 1, 2, 3], [1, 4, 2, 2]])
    skin = SkinPicture(corners, faces, np.zeros(2, dtype=np.int64), np.zeros(2), np.ones(2))
    triangles, face = skin.triangles()
    a, b, c = corners[triangles].transpose(1, 0, 2)
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    assert len(area) == 3 and area.sum() == pytest.approx(1.5)
    np.testing.assert_array_equal(face, [0, 1, 0])


def test_bad_pictures_are_named() -> None:
    line = np.zeros((5, 3))
    with pytest.raises(ValueError, match="inner radius 2.5 mm"):
        CoreLine(line, 2.0, 2.5)
    with pytest.raises(ValueError, match="CoreLine.line"):
        CoreLine(line[:, :2], 2.0)
    with pytest.raises(ValueError, match="positive radii"):
        SheavePicture(np.zeros(3), np.array([1.0, 0, 0]), -1.0)
    with pytest.raises(ValueError, match="SheavePicture.axis"):
        SheavePicture(np.zeros(3), np.zeros(2), 1.0)
    skin = tube_skin(np.linspace([0, 0, 0], [0, 0, 5], 4), 0, 1.0)
    with pytest.raises(ValueError, match="corners 0 to 99"):
        replace(skin, faces=np.where(skin.faces == 5, 99, skin.faces))
    with pytest.raises(ValueError, match="von_mises"):
        replace(skin, von_mises=np.zeros(1))
    with pytest.raises(ValueError, match="skin of yarn 12"):
        one = bent_rope(pitches=0.5, nodes=13)
        replace(one, skins=(replace(skin, owner=np.full(36, 12)),))
    with pytest.raises(ValueError, match="ContactTable.kind"):
        replace(one.contacts, kind=np.full(len(one.contacts.gap), 7))


def test_the_profile_of_a_groove() -> None:
    sheave = SheavePicture(np.zeros(3), np.array([1.0, 0, 0]), 20.0, 7.0)
    np.testing.assert_allclose(sheave.profile(np.array([0.0, 7.0])), [20.0, 27.0])
    assert np.isnan(sheave.profile(np.array([7.1])))[0]
    flat = SheavePicture(np.zeros(3), np.array([1.0, 0, 0]), 20.0)
    np.testing.assert_array_equal(flat.profile(np.array([0.0, 30.0])), 20.0)
