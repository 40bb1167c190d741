"""Numbers read off a bent rope, and slices of surfaces."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bent_example import CORE, YARN, bent_rope, straight_lines, tube_skin

from braidx.output import CoreLine, Snapshot
from braidx.output.bending_measures import (
    core_pressure_max,
    crown_of,
    nominal_pressure,
    section_ratios,
    sheave_force,
    sheave_force_total,
    von_mises_max,
    work_per_cycle,
    yarn_sheave_force_max,
)
from braidx.output.bending_results import BENDING_RESULTS, bending_results
from braidx.output.contact_table import YARN_CORE
from braidx.output.cuts import frames, node_tangents
from braidx.output.slices import section_ratio, slice_skin


def test_forces_on_the_sheave() -> None:
    one = bent_rope()
    sheave = one.contacts.kind == 2
    assert yarn_sheave_force_max(one) == pytest.approx(150.0)
    assert sheave_force_total(one) == pytest.approx(150.0 * sheave.sum())
    expected = np.array([15.0, 150.0, 0.0]) * sheave.sum()  # normals along y, friction along x
    np.testing.assert_allclose(sheave_force(one), expected)
    core_on_it = np.where(sheave, 3, one.contacts.kind)
    other = replace(one, contacts=replace(one.contacts, kind=core_on_it))
    assert yarn_sheave_force_max(other) == 0.0
    assert sheave_force_total(other) == pytest.approx(150.0 * sheave.sum())


def test_pressure_by_area_and_by_line() -> None:
    one = bent_rope()  # 8 N on 0.5 mm of a yarn of 2 mm
    assert core_pressure_max(one) == pytest.approx(8.0 / (0.5 * 2 * YARN))
    area = replace(one.contacts, per_area=np.ones(len(one.contacts.gap), dtype=bool))
    assert core_pressure_max(replace(one, contacts=area)) == pytest.approx(8.0 / 0.5)
    thin = replace(one, core=CoreLine(one.core.line, 0.5))
    np.testing.assert_allclose(nominal_pressure(thin, YARN_CORE), 8.0 / (0.5 * 1.0))
    unknown = replace(one.contacts, measure=np.empty(0))
    assert np.isnan(core_pressure_max(replace(one, contacts=unknown)))
    with pytest.raises(ValueError, match="no contacts"):
        core_pressure_max(replace(one, contacts=None))


def test_largest_von_mises_stress() -> None:
    assert von_mises_max(bent_rope(solids=True)) == pytest.approx(200.0)
    assert np.isnan(von_mises_max(bent_rope()))


def test_work_of_each_cycle() -> None:
    work = [0.0, 1.0, 3.0, 4.0, 6.0, 6.5, 9.0]
    np.testing.assert_allclose(work_per_cycle(work, 3), [4.0, 5.0])
    np.testing.assert_allclose(work_per_cycle(work, 4), [6.0])
    for per_cycle in (7, 0):
        with pytest.raises(ValueError, match="at least one whole cycle"):
            work_per_cycle(work, per_cycle)


def test_sections_of_solids_at_the_crown() -> None:
    one = bent_rope(solids=True)
    np.testing.assert_allclose(section_ratios(one, crown_of(one)), 0.88 / 1.12, rtol=3e-3)


def test_sections_of_beams_and_cables() -> None:
    one = bent_rope()
    np.testing.assert_array_equal(section_ratios(one, crown_of(one)), 1.0)
    shape = np.array([[0.9, 0.0], [0.15, 1.1]])  # sheared and stretched
    pairs = tuple(
        np.einsum("ij,njc->nic", shape, frames(node_tangents(line))) for line in one.centre_lines
    )
    least, most = np.sort(np.linalg.svd(shape, compute_uv=False))
    found = section_ratios(replace(one, directors=pairs), crown_of(one))
    np.testing.assert_allclose(found, least / most, rtol=0.02)
    assert np.isnan(section_ratios(one, 1e3)).all()


def test_the_crown_is_above_the_sheave_or_in_the_middle() -> None:
    one = bent_rope()
    assert crown_of(one) == pytest.approx(0.5 * straight_lines()[0][-1, 2])
    lines = tuple(straight_lines())
    other = Snapshot("x", lines, np.ones(12), np.arange(12))
    assert crown_of(other) == pytest.approx(crown_of(one))


@pytest.mark.parametrize("flatten", [0.0, 0.2])
def test_a_slice_of_a_tube_has_its_area_and_shape(flatten: float) -> None:
    skin = tube_skin(np.linspace([0.0, 0, -5], [0.0, 0, 5], 20), 3, CORE, flatten)
    (piece,) = slice_skin(skin, np.array([0.0, 0.0, 0.3]), np.array([0.0, 0.0, 1.0]))
    assert piece.owner == 3
    p, q = piece.outline, np.roll(piece.outline, -1, axis=0)
    area = 0.5 * abs((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum())
    expected = 6 * np.sin(np.pi / 6) * CORE**2 * (1 - flatten**2)
    assert area == pytest.approx(expected)
    assert section_ratio(piece.outline) == pytest.approx((1 - flatten) / (1 + flatten))
    shifted = piece.outline @ np.linalg.qr(np.arange(9).reshape(3, 3) + np.eye(3))[0] + 7.0
    assert section_ratio(shifted[::-1]) == pytest.approx((1 - flatten) / (1 + flatten))


def test_a_plane_through_corners_or_open_ends() -> None:
    line = np.linspace([0.0, 0, 0], [0.0, 0, 10], 11)
    skin, up = tube_skin(line, 0, 1.0), np.array([0.0, 0.0, 1.0])
    (piece,) = slice_skin(skin, np.array([0.0, 0.0, 5.0]), up)  # exactly in a ring of corners
    np.testing.assert_allclose(np.hypot(*piece.outline[:, :2].T).max(), 1.0)
    assert slice_skin(skin, np.array([0.0, 0.0, 20.0]), up) == []
    aslant = np.array([1.0, 0.0, 0.02])
    assert slice_skin(skin, np.array([0.0, 0.0, 5.0]), aslant) == []  # leaves through both ends


def test_results_for_the_summary() -> None:
    straight, bent = bent_rope(0.0), bent_rope(1.0)
    found = bending_results(straight, bent)
    assert set(found) == set(BENDING_RESULTS) - {"von_mises_max"}
    assert found["crossing_points"] == 294 and found["relative_displacement"] < 1e-4
    assert found["yarn_sheave_force_max"] == pytest.approx(150.0)
    solids = bending_results(straight, bent_rope(1.0, solids=True))
    assert set(solids) == set(BENDING_RESULTS)
    assert solids["section_ratio_min"] == pytest.approx(0.88 / 1.12, rel=3e-3)
    bare = bending_results(straight, replace(bent, contacts=None))
    assert "core_pressure_max" not in bare and "relative_displacement_max" in bare
