"""Solids in contact: sheets of facets, tubes and rigid surfaces, and the border of the engine."""

from dataclasses import replace

import braidx_engine as engine
import numpy as np
import pytest
from mpi4py import MPI
from sheets import KINDS, NO_TUBES, contact_of, residual, sheet, skins_of, tangent

from braidx.contact.contact import Contact
from braidx.contact.skins import SkinLayout
from braidx.contact.tubes import TubeLayout

SIZE = (6.0, 4.0)


def two_sheets(kind_a, kind_b, depth=0.01):
    """Positions, shape (num_nodes, 3), and facets of two sheets of equal size, b on top of a and into it."""
    a, facets_a = sheet(kind_a, (3, 2), SIZE, up=True)
    b, facets_b = sheet(kind_b, (4, 5), SIZE, up=False, first=a.size)
    b[:, 2] -= depth
    return np.concatenate([a, b]), [facets_a, facets_b]


@pytest.mark.parametrize("kind_a", KINDS)
@pytest.mark.parametrize("kind_b", KINDS)
def test_tangent_is_the_derivative_of_the_residual(kind_a, kind_b):
    rest, facets = two_sheets(kind_a, kind_b)
    contact = contact_of(rest, facets, friction=0.2)
    rng = np.random.default_rng(0)
    q = rest + 0.002 * rng.standard_normal(rest.shape)
    q[len(q) // 2 :, 0] += 0.01
    contact.update(q.ravel())
    step = 1e-7 * rng.standard_normal(q.shape)
    change = residual(contact, q + step) - residual(contact, q - step)
    error = change - 2 * tangent(contact, q) @ step.ravel()
    assert np.linalg.norm(error) < 1e-6 * np.linalg.norm(change)


@pytest.mark.parametrize("kind", KINDS)
def test_block_on_a_rigid_plane(kind):
    """Uniform penetration: forces of nodes are those of a uniform pressure, exactly."""
    rest, facets = sheet(kind, (3, 2), SIZE, up=False)
    contact = contact_of(rest, [facets], friction=0.2)
    contact.rigid = [engine.make_plane(np.zeros(3), np.array([0, 0, 1.0]), 1)]
    q = rest - [0, 0, 0.02]
    contact.update(q.ravel())
    pressure = 1000 * (0.02 - 0.5 * contact.laws.regularisation)
    results = contact.results(q.ravel())
    assert np.all(results["per_area"])
    assert results["normal_force"] / results["weight"] == pytest.approx(pressure)
    forces = -residual(contact, q).reshape(-1, 3)
    assert forces.sum(axis=0) == pytest.approx([0, 0, pressure * SIZE[0] * SIZE[1]])
    moment = np.cross(q, forces).sum(axis=0)
    centre = np.array([SIZE[0] / 2, SIZE[1] / 2, 0])
    assert moment == pytest.approx(
        np.cross(centre, forces.sum(axis=0)), abs=1e-9 * abs(moment).max()
    )
    assert contact.rigid_share(q.ravel()) == pytest.approx(1)


def test_surfaces_are_offset_from_their_nodes():
    """Two sheets that overlap, whose surfaces are below their nodes by more, and the upper one against a plane."""
    rest, facets = two_sheets(9, 4, depth=0.01)
    layout = replace(skins_of(facets), offset=np.array([-0.02, -0.03]))
    contact = Contact(
        MPI.COMM_SELF, NO_TUBES, smooth=True, symmetric=True, skins=layout, rest=rest.ravel()
    )
    contact.rigid = [engine.make_plane(np.zeros(3), np.array([0, 0, 1.0]), 1)]
    contact.pairing.search.margin = 0.2
    contact.update(rest.ravel())
    contact.start = rest.ravel()
    results = contact.results(rest.ravel())
    on_plane = results["tubes"][:, 1] < 0
    assert results["gap"][~on_plane] == pytest.approx(-0.01 + 0.05)
    upper = on_plane & (results["tubes"][:, 0] == 1)
    assert results["gap"][upper] == pytest.approx(-0.01 + 0.03)
    assert upper.any() and not on_plane.all()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("block", [3, 9], ids=["cable", "beam"])
def test_tube_lying_on_a_skin(kind, block):
    """A straight tube pressed on a flat skin: its line load times its length reaches the skin."""
    radius, nodes, depth = 0.5, 9, 0.02
    line = np.linspace([0.5, 1.9, radius - depth], [5.3, 2.2, radius - depth], nodes)
    frames = np.broadcast_to([1.0, 0, 0, 0, 1.0, 0], (nodes, 6))[:, : block - 3]
    flat, facets = sheet(kind, (4, 3), SIZE, up=True, first=nodes * block)
    q = np.concatenate([np.hstack([line, frames]).ravel(), flat.ravel()])
    length = np.linalg.norm(line[-1] - line[0])
    tubes = TubeLayout(
        first_unknown=np.array([0]),
        num_elements=np.array([nodes - 1]),
        degree=np.array([1]),
        block=np.array([block]),
        radius=np.array([radius]),
        element_length=np.array([length / (nodes - 1)]),
        body=np.array([0]),
    )
    contact = contact_of(q, [facets], tubes)
    if block == 9:  # sections square to the line
        along = (line[-1] - line[0]) / length
        q[: nodes * block].reshape(nodes, 9)[:, 3:] = [0, 0, 1, *np.cross([0, 0, 1], along)]
    contact.update(q)
    line_load = 1000 * (depth - 0.5 * contact.laws.regularisation)
    results = contact.results(q)
    assert not results["per_area"].any() and results["weight"].sum() == pytest.approx(length)
    assert results["normal_force"] / results["weight"] == pytest.approx(line_load)
    assert results["position"][:, 2] == pytest.approx(0, abs=1e-9)
    forces = -residual(contact, q)
    on_skin = forces[nodes * block :].reshape(-1, 3).sum(axis=0)
    on_tube = forces[: nodes * block].reshape(nodes, block)[:, :3].sum(axis=0)
    assert on_skin == pytest.approx([0, 0, -line_load * length], abs=1e-9 * line_load)
    assert on_tube == pytest.approx(-on_skin, abs=1e-9 * line_load)


def test_contact_elements_of_skins_survive_a_round_trip():
    rest, facets = two_sheets(9, 3)
    contact = contact_of(rest, facets, friction=0.2)
    q = rest + 0.002 * np.random.default_rng(0).standard_normal(rest.shape)
    contact.update(q.ravel())
    contact.commit(q.ravel())
    arrays, before = contact.arrays(), residual(contact, q)
    assert np.abs(arrays["slip"]).max() > 0 and arrays["facet"].min() >= 0
    contact.restore_arrays(arrays)
    for name, values in contact.arrays().items():
        np.testing.assert_array_equal(values, arrays[name], err_msg=name)
    np.testing.assert_array_equal(residual(contact, q), before)


def test_every_process_takes_back_its_own_pairs():
    """Both passes of a pair of skins belong to one process, and a restored state is divided as a new one."""
    rest, facets = two_sheets(4, 4)
    shared = contact_of(rest, facets)
    shared.update(rest.ravel())
    arrays = shared.arrays()
    whole, parts, owners = residual(shared, rest), np.zeros(rest.size), 0
    for part in range(2):
        contact = contact_of(rest, facets)
        contact.pairing.part, contact.pairing.num_parts = part, 2
        contact.update(rest.ravel())
        made = len(contact.elements)
        contact.restore_arrays(arrays)
        assert len(contact.elements) == made
        parts += residual(contact, rest)
        owners += made > 0
    assert owners == 1
    np.testing.assert_allclose(parts, whole, atol=1e-12 * abs(whole).max())


def test_states_saved_before_solids_could_touch_are_read():
    contact = contact_of(*two_sheets(4, 4))
    empty = {name: v[:0] for name, v in contact.arrays().items() if name != "facet"}
    contact.restore_arrays(empty)
    assert len(contact.elements) == 0


def test_penalties_per_length_and_per_area_have_their_own_mean():
    rest, facets = two_sheets(4, 4)
    contact = contact_of(rest, facets)
    contact.pairing.stiffness, contact.pairing.area_stiffness = 70.0, 500.0
    contact.update(rest.ravel())
    contact.scale_stiffness(3.0)
    contact.adopt_stiffness()
    assert contact.pairing.area_stiffness == pytest.approx(1500)
    assert contact.pairing.stiffness == 70.0
    assert contact.adapt_stiffness(rest.ravel(), 0.005) == 1
    stiffness = contact.arrays()["stiffness"]
    assert stiffness == pytest.approx(1500 * 3)  # 1.6 x 2, but no more than threefold
    assert contact.deepest_penetration(rest.ravel()) == pytest.approx(0.01)


def test_bodies_and_groups_are_kept_apart():
    rest, facets = two_sheets(4, 4)
    contact = contact_of(rest, facets)
    contact.pairing.num_bodies, contact.pairing.may_touch = 2, [1, 0, 0, 1]
    contact.update(rest.ravel())
    assert len(contact.elements) == 0
    layout = SkinLayout(tuple(facets), np.arange(2), np.array([4, 4]), np.full(2, 0.5))
    grouped = Contact(
        MPI.COMM_SELF, NO_TUBES, smooth=True, symmetric=True, skins=layout, rest=rest.ravel()
    )
    grouped.update(rest.ravel())
    assert len(grouped.elements) == 0


@pytest.mark.parametrize(
    "change, message",
    [
        ({"rest": None}, "rest is None: skins need"),
        ({"facets": np.zeros((4, 5), int)}, r"facets of skin 0 have shape \(4, 5\)"),
        ({"facets": np.full((1, 4), 10_000)}, "facets of skin 0 name unknowns 10000 to 10000"),
    ],
)
def test_bad_skins_are_refused(change, message):
    rest, facets = sheet(4, (2, 2), SIZE, up=True)
    layout = skins_of([change.get("facets", facets)])
    with pytest.raises(ValueError, match=message):
        Contact(
            MPI.COMM_SELF,
            NO_TUBES,
            smooth=True,
            symmetric=True,
            skins=layout,
            rest=change.get("rest", rest.ravel()),
        )


def test_periodic_samples_have_no_skins():
    rest, facets = sheet(4, (2, 2), SIZE, up=True)
    ones = np.ones(1, int)
    tubes = TubeLayout(0 * ones, 4 * ones, ones, 3 * ones, 1.0 * ones, 1.0 * ones, ones, beyond=2)
    with pytest.raises(ValueError, match="layout.beyond = 2"):
        Contact(
            MPI.COMM_SELF,
            tubes,
            smooth=True,
            symmetric=True,
            skins=skins_of([facets]),
            rest=rest.ravel(),
        )
