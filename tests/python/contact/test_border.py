"""What the contact engine refuses: arrays of wrong shapes, numbers that fit nothing, states that are no numbers."""

from __future__ import annotations

from typing import Any

import braidx_engine as engine
import numpy as np
import pytest

X, Z = np.array([1.0, 0, 0]), np.array([0, 0, 1.0])


def tubes_of(count: int = 2, **changed: Any) -> Any:
    """Parallel cables of three elements, at a distance of 1.9 radii."""
    given: dict[str, Any] = {
        "first_unknown": 12 * np.arange(count),
        "num_elements": np.full(count, 3, np.int32),
        "degree": np.ones(count, np.int32),
        "block": np.full(count, 3, np.int32),
        "radius": np.ones(count),
        "element_length": np.ones(count),
        "body": np.arange(count, dtype=np.int32),
        "is_image": np.zeros(count, bool),
        "smooth": True,
    }
    return engine.make_tubes(**given | changed)


def state() -> np.ndarray[Any, np.dtype[np.float64]]:
    lines = [np.linspace(Z * 0 + x * X, x * X + 3 * Z, 4) for x in (0.0, 1.9)]
    return np.concatenate(lines).ravel()


def crossings(**changed: Any) -> Any:
    given: dict[str, Any] = {
        "tubes": np.array([[0, 1]], np.int32),
        "windows": np.array([[0, 3.0, 0, 3.0]]),
        "order": np.array([1], np.int32),
        "axis": np.array([0 * Z, Z]),
    }
    return engine.make_crossings(**given | changed)


def found(q: Any = None, **changed: Any) -> Any:
    """Contact elements of the two cables."""
    q = state() if q is None else q
    given: dict[str, Any] = {
        "surfaces": tubes_of(),
        "crossings": crossings(
            tubes=np.empty((0, 2), np.int32),
            windows=np.empty((0, 4)),
            order=np.empty(0, np.int32),
        ),
        "rigid": [],
        "q": q,
        "q_start": q,
        "previous": engine.ContactElements(),
        "options": engine.PairingOptions(),
    }
    return engine.make_contact_elements(**given | changed)


def laws(**changed: Any) -> Any:
    out = engine.ContactLaws()
    out.num_bodies, out.friction = 2, [0.1] * 4
    for name, value in changed.items():
        setattr(out, name, value)
    return out


def with_options(**changed: Any) -> Any:
    options = engine.PairingOptions()
    for name, value in changed.items():
        setattr(options, name, value)
    return found(options=options)


def with_columns(**changed: Any) -> Any:
    arrays = found().arrays() | changed
    elements = engine.ContactElements.from_arrays(
        {k: v for k, v in arrays.items() if v is not None}
    )
    return engine.make_pattern(tubes_of(), elements)


def forces(**changed: Any) -> None:
    q = state()
    given = {"q": q, "q_start": q, "laws": laws(), "residual": np.zeros(24), "elements": found()}
    engine.add_residual(surfaces=tubes_of(), **given | changed)


def energy(lagged: Any) -> Any:
    return engine.contact_energy(tubes_of(), found(), state(), state(), laws(), lagged)


def tangent(values: Any, fresh: bool = False) -> None:
    q, elements = state(), found()
    pattern = engine.make_pattern(tubes_of(), engine.ContactElements() if fresh else elements)
    engine.add_tangent(tubes_of(), elements, pattern, q, q, laws(), True, values)


def skin(**changed: Any) -> Any:
    given = {
        "facets": np.array([[0, 3, 6]]),
        "body": 0,
        "radius": 1.0,
        "group": -1,
        "rest": np.array([0, 0, 0, 1.0, 0, 0, 0, 1, 0]),
        "dense": False,
        "smooth": True,
        "offset": np.empty(0),
    }
    return engine.make_skin(**given | changed)


SHAPES = {
    r"point is an array of shape \(2,\); \(3,\) is wanted": lambda: engine.make_plane(X[:2], Z, 0),
    r"normal is an array of shape \(1, 3\); \(3,\)": lambda: engine.make_plane(X, Z[None], 0),
    r"normal is 0 0 0; a vector with a direction": lambda: engine.make_plane(X, 0 * Z, 0),
    r"point is *nan .*; a finite vector": lambda: engine.make_plane(np.nan * X, Z, 0),
    r"axis is an array of shape \(4,\)": lambda: engine.make_cylinder(X, np.ones(4), 1, True, 0),
    r"radius is 0; a length above 0": lambda: engine.make_cylinder(X, Z, 0.0, True, 0),
    r"groove_radius is nan": lambda: engine.make_sheave(X, Z, 9.0, np.nan, 0),
    r"rotation is an array of shape \(0,\)": lambda: engine.moved(
        engine.make_plane(X, Z, 0), X, np.empty(0), X
    ),
    r"points is an array of shape \(3,\); \(n, 3\)": lambda: engine.make_plane(X, Z, 0).distances(
        X
    ),
    r"tubes is an array of shape \(2,\); \(n, 2\)": lambda: crossings(
        tubes=np.array([0, 1], np.int32)
    ),
    r"windows is an array of shape \(2, 4\); \(1, 4\)": lambda: crossings(windows=np.ones((2, 4))),
    r"order is an array of shape \(0,\); \(1,\)": lambda: crossings(order=np.empty(0, np.int32)),
    r"axis is an array of shape \(6,\); \(2, 3\)": lambda: crossings(axis=np.ones(6)),
    r"a tube of crossings is 2; a number from 0, below 2": lambda: found(
        crossings=crossings(tubes=np.array([[0, 2]], np.int32))
    ),
    r"lagged is an array of shape \(0,\); one of \d+ forces": lambda: energy(np.empty(0)),
    r"degree is an array of shape \(3,\); \(2,\)": lambda: tubes_of(degree=np.ones(3, np.int32)),
    r"group is a list of 1; one of 2": lambda: tubes_of(group=[0]),
    r"degree\[1\] is 3; 1 or 2": lambda: tubes_of(degree=np.array([1, 3], np.int32)),
    r"block\[0\] is 6; 3 \(cable\) or 9": lambda: tubes_of(block=np.array([6, 3], np.int32)),
    r"num_elements\[0\] is 0": lambda: tubes_of(num_elements=np.array([0, 3], np.int32)),
    r"radius\[1\] is nan": lambda: tubes_of(radius=np.array([1.0, np.nan])),
    r"element_length\[0\] is inf": lambda: tubes_of(element_length=np.array([np.inf, 1.0])),
    r"first_unknown\[0\] is 0; one that leaves room": lambda: tubes_of(beyond=1),
    r"facets is an array of shape \(1, 5\)": lambda: skin(facets=np.zeros((1, 5), np.int64)),
    r"an unknown in facets is 7; one of three in a row of 9": lambda: skin(
        facets=np.array([[0, 3, 7]])
    ),
    r"offset is an array of shape \(2,\); \(1,\)": lambda: skin(offset=np.zeros(2)),
    r"q is an array of shape \(23,\); \(n,\) with n at least 24": lambda: found(state()[:23]),
    r"q_start is an array of shape \(0,\)": lambda: found(q_start=np.empty(0)),
    r"q is an array of shape \(8, 3\)": lambda: found(state().reshape(8, 3)),
    r"options.spacing is 0; a length above 0": lambda: with_options(spacing=0.0),
    r"options.num_parts is 0": lambda: with_options(num_parts=0),
    r"options.may_touch is 3 numbers; num_bodies x num_bodies": lambda: with_options(
        num_bodies=2, may_touch=[1, 1, 1]
    ),
    r"options.may_touch is 1 numbers; .* at least 2, the bodies": lambda: with_options(
        num_bodies=1, may_touch=[1]
    ),
    r"laws.friction is 1 numbers; .* at least 2": lambda: forces(
        laws=laws(num_bodies=1, friction=[0.1])
    ),
    r"residual is an array of shape \(25,\); \(24,\)": lambda: forces(residual=np.zeros(25)),
    r"q is an array of shape \(12,\)": lambda: forces(q=np.zeros(12)),
    r"elements: number 0 is between surfaces 0 and 1, .*; there are 1 tubes": lambda: (
        engine.deepest_penetration(tubes_of(1), found(), state())
    ),
    r"values is an array of shape \(5,\)": lambda: tangent(np.zeros(5)),
    r"pattern is one of 0 elements": lambda: tangent(np.zeros(0), fresh=True),
    r"held is an array of shape \(3,\); \(24,\)": lambda: engine.adapt_stiffness(
        tubes_of(), found(), state(), 0.1, 2.0, held=np.zeros(3, bool)
    ),
    r"slip is missing": lambda: with_columns(slip=None),
    r"weight is missing": lambda: with_columns(weight=None),
    r"normal is an array of shape \(1, 3\)": lambda: with_columns(normal=np.ones((1, 3))),
    r"zone is no array of the right type": lambda: with_columns(zone=np.ones(len(found()))),
    r"elements: number 0 is between surfaces 0 and 7": lambda: with_columns(
        tubes=np.array([[0, 7]] * len(found()), np.int32)
    ),
    r"facets 4 and -1; there are 2 tubes": lambda: with_columns(
        facet=np.array([[4, -1]] * len(found()), np.int32)
    ),
    r"station is an array of shape \(1,\); \(2,\)": lambda: engine.set_rest_overlaps(
        engine.PairingOptions(), np.zeros(2, np.int32), np.zeros(1, np.int64), np.zeros(2)
    ),
    r"other is an array of shape \(1,\); \(2,\)": lambda: engine.is_own(
        engine.PairingOptions(), np.zeros(2, np.int64), np.zeros(1, np.int64)
    ),
    r"a tube is 2; a number from 0, below 2": lambda: engine.cell_lengths(
        tubes_of(), np.array([0]), np.array([2]), 1.0
    ),
    r"q is an array of shape \(3,\); \(n,\) with n at least 24": lambda: engine.close_pairs(
        tubes_of(), np.zeros(3), engine.SearchOptions()
    ),
}


@pytest.mark.parametrize("message", SHAPES)
def test_what_does_not_fit_is_named(message: str) -> None:
    with pytest.raises(ValueError, match=message):
        SHAPES[message]()


def test_results_are_never_written_to_a_copy() -> None:
    with pytest.raises(TypeError, match="residual"):
        forces(residual=np.zeros(24, np.float32))


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e300])
def test_contact_is_not_looked_for_where_unknowns_are_no_places(value: float) -> None:
    q = state()
    q[14] = value
    for given in ({"q": q, "q_start": state()}, {"q": state(), "q_start": q}):
        with pytest.raises(ValueError, match="unknown 14 of 24 is .*: contact needs finite"):
            found(**given)


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_forces_of_a_state_that_diverged_are_no_numbers(value: float) -> None:
    q, residual = state(), np.zeros(24)
    q[12::3] = value
    forces(q=q, residual=residual)
    assert np.isnan(residual).any()
