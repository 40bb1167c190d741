"""Snapshots: saving, loading, checking."""

from __future__ import annotations

from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest
from rope_example import rope

from braidx.output import ContactTable, Snapshot, snapshot


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
        replace(contacts, slip=np.zeros(3))
