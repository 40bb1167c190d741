"""Swept meshes: placement, surfaces turned outward, joining, and what is refused."""

import numpy as np
import pytest

from braidx.meshing import SolidMesh, join, rectangle, round_section, sweep
from braidx.meshing.reference import QUADS

Z = np.linspace(0.0, 6.0, 13)
HELIX = np.stack([2.0 * np.cos(0.5 * Z), 2.0 * np.sin(0.5 * Z), Z], axis=1)
SECTIONS = {
    "o-grid": {"seeds": 8},
    "wedge": {"seeds": 8, "template": "wedge"},
    "hollow": {"seeds": 8, "inner_radius": 0.2},
}


def make(name="o-grid", degree=1):
    return sweep(HELIX, round_section(0.5, degree=degree, **SECTIONS[name]))


def surface_integrals(mesh, tags):
    """Integrals of the outward normal, shape (3,), and of x . n / 3 over surfaces."""
    abscissae, weights = np.polynomial.legendre.leggauss(4)
    at = np.stack(np.meshgrid(abscissae, abscissae), axis=-1).reshape(-1, 2) / 2.0 + 0.5
    weight = np.outer(weights, weights).ravel() / 4.0
    normal, volume = np.zeros(3), 0.0
    quad = QUADS[mesh.degree]
    for tag in tags:
        nodes = mesh.points[mesh.facet_nodes(tag)]
        du, dv = np.einsum("pdn,fni->dfpi", quad.gradient(at), nodes)
        area = np.cross(du, dv) * weight[:, None]
        normal += area.sum(axis=(0, 1))
        volume += np.sum(np.einsum("pn,fni->fpi", quad.shape(at), nodes) * area) / 3.0
    return normal, volume


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("name", SECTIONS)
def test_surfaces_enclose_the_volume_and_look_outward(name, degree):
    mesh = make(name, degree)
    normal, volume = surface_integrals(mesh, mesh.facets)
    area, length = mesh.sweeps[0].area, 6.0 * np.sqrt(2.0)
    assert np.abs(normal).max() < 1e-12
    assert volume == pytest.approx(area * length, rel=0.02)
    assert ("inner" in mesh.facets) == (name == "hollow")


@pytest.mark.parametrize("degree", [1, 2])
def test_nodes_of_layers_are_where_section_and_directors_say(degree):
    mesh = make(degree=degree)
    swept = mesh.sweeps[0]
    assert swept.layers.shape == (13, len(swept.section))
    assert swept.line == pytest.approx(HELIX)
    placed = swept.line[:, None] + np.einsum("ja,lai->lji", swept.section, swept.directors)
    assert mesh.points[swept.layers] == pytest.approx(placed, abs=1e-14)
    assert swept.cells.shape[0] == 12 // degree
    start = set(mesh.facet_nodes("start").ravel().tolist())
    assert start == set(swept.layers[0].tolist())
    tangent = HELIX[degree] - HELIX[0]
    assert mesh.fibre[0] == pytest.approx(tangent / np.linalg.norm(tangent))


def test_join_numbers_parts_nodes_and_cells_through():
    one, two = make("o-grid"), make("hollow")
    both = join([one, two, one])
    assert both.num_parts == 3 and both.is_swept
    assert both.num_nodes == 2 * one.num_nodes + two.num_nodes
    assert both.points[both.sweeps[1].layers] == pytest.approx(two.points[two.sweeps[0].layers])
    assert np.array_equal(both.cells_of(1), both.sweeps[1].cells.ravel())
    assert (
        len(both.facets_of("inner")) == len(both.facets_of("inner", 1)) == len(two.facets["inner"])
    )
    third = both.facet_nodes("lateral", 2) - one.num_nodes - two.num_nodes
    assert np.array_equal(third, one.facet_nodes("lateral"))


def test_bends_that_turn_cells_inside_out_are_named():
    angle = np.linspace(0.0, np.pi, 9)
    bend = 0.4 * np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=1)
    with pytest.raises(ValueError, match="part 0 is inside out .*radius of 0.4.*reaches 0.5 mm"):
        sweep(bend, round_section(0.5, 8))


def test_errors_of_the_sweep():
    with pytest.raises(ValueError, match="line has 12 points: give 2 n"):
        sweep(HELIX[:-1], round_section(0.5, 8, degree=2))
    with pytest.raises(ValueError, match="join"):
        join([])
    with pytest.raises(ValueError, match="one mesh takes one kind of cell"):
        join([make(degree=1), make(degree=2)])


def test_errors_of_the_mesh():
    mesh = sweep(HELIX, rectangle(0.3, 0.3))
    with pytest.raises(ValueError, match='no surface "laterel".*did you mean "lateral"'):
        mesh.facet_nodes("laterel")
    with pytest.raises(ValueError, match="part 1: the mesh has the parts 0 to 0"):
        mesh.cells_of(1)
    good = {"points": mesh.points, "cells": mesh.cells, "cell_part": mesh.cell_part}
    good |= {"fibre": mesh.fibre, "facets": {}}
    for wrong, message in (
        ({"points": np.vstack([mesh.points, [9.0, 9.0, 9.0]])}, "belong to no cell.*node 52"),
        ({"cells": mesh.cells[:, :6]}, "cells has shape .*8 or 27"),
        ({"cells": mesh.cells + 1}, "cells name the nodes 1 to 52"),
        ({"cells": mesh.cells[:, [1, 0, 2, 3, 4, 5, 6, 7]]}, "inside out.*mesh it anew"),
        ({"fibre": 2.0 * mesh.fibre}, "unit vectors"),
        ({"fibre": mesh.fibre[:3]}, "fibre has shape"),
        ({"points": mesh.points * np.nan}, "points is not finite"),
        ({"facets": {"top": np.array([[0, 6]])}}, 'surface "top": give pairs'),
    ):
        with pytest.raises(ValueError, match=message):
            SolidMesh(**(good | wrong))
