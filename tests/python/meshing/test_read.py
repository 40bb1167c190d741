"""Meshes from gmsh and meshio: volumes, parts, surfaces, order of nodes and of names, errors."""

import numpy as np
import pytest

from braidx.meshing import SolidMesh, from_gmsh, read_mesh, round_section, sweep
from braidx.meshing.reference import SOLID_CELLS

GEO = """
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 2, 0.5};
Physical Volume("core", 7) = {1};
Physical Surface("side", 3) = {1};
Physical Surface("top", 4) = {2};
Mesh.MeshSizeMax = 0.5;
Mesh.ElementOrder = %d;
"""


@pytest.fixture
def gmsh():
    module = pytest.importorskip("gmsh")
    module.initialize(interruptible=False)
    module.option.setNumber("General.Terminal", 0)
    yield module
    module.finalize()


def volume(mesh: SolidMesh) -> float:
    """Volume by Gauss quadrature of the isoparametric cells, mm^3; orders of nodes that are wrong change it."""
    abscissae, weights = np.polynomial.legendre.leggauss(4)
    at = np.stack(np.meshgrid(*[abscissae / 2.0 + 0.5] * 3), axis=-1).reshape(-1, 3)
    weight = np.einsum("i,j,k->ijk", *[weights / 2.0] * 3).ravel()
    if mesh.cell.is_simplex:  # the cube folded into a tetrahedron
        u, v, w = at.T
        weight = weight * (1.0 - v) * (1.0 - w) ** 2
        at = np.stack([u * (1.0 - v) * (1.0 - w), v * (1.0 - w), w], axis=1)
    jacobian = np.einsum("pdn,cni->cpid", mesh.cell.gradient(at), mesh.points[mesh.cells])
    return float(np.sum(np.linalg.det(jacobian) * weight))


def assert_straight_where_it_should_be(mesh: SolidMesh) -> None:
    """Nodes of cells that touch no curved surface are an affine image of the reference cell's."""
    vertices = SOLID_CELLS[4 if mesh.cell.is_simplex else 8].shape(mesh.cell.points)
    straight = np.einsum("nv,cvi->cni", vertices, mesh.points[mesh.cells[:, : vertices.shape[1]]])
    gap = np.abs(straight - mesh.points[mesh.cells]).max(axis=(1, 2))
    assert np.count_nonzero(gap < 1e-9) > 0.1 * len(gap)
    assert gap.max() < 0.1  # sagitta of the cylinder's edges; a wrong order is off by half a cell


@pytest.mark.parametrize("degree", [1, 2])
def test_geo_model_of_tetrahedra(gmsh, tmp_path, degree):
    path = tmp_path / "core.geo"
    path.write_text(GEO % degree)
    mesh = read_mesh(path)
    assert mesh.cell.name == "tetrahedron" and mesh.degree == degree
    assert mesh.part_names == ("core",) and set(mesh.facets) == {"side", "top"}
    assert volume(mesh) == pytest.approx(np.pi * 0.25 * 2.0, rel=0.06 if degree == 1 else 2e-3)
    top = mesh.points[mesh.facet_nodes("top")]
    assert top.shape[1] == (3 if degree == 1 else 6) and np.all(top[..., 2] == 2.0)
    a, b, c = top[:, 0], top[:, 1], top[:, 2]
    assert np.all(np.cross(b - a, c - a)[:, 2] > 0.0)
    assert_straight_where_it_should_be(mesh)


def box_of_hexahedra(gmsh, degree):
    """Two boxes side by side, each with hexahedra of its own."""
    gmsh.model.add("boxes")
    for i in range(2):
        face = gmsh.model.occ.addRectangle(2.0 * i, 0.0, 0.0, 1.0, 1.5)
        gmsh.model.occ.extrude([(2, face)], 0, 0, 2.0, numElements=[2], recombine=True)
    gmsh.model.occ.synchronize()
    for _, surface in gmsh.model.getEntities(2):
        gmsh.model.mesh.setTransfiniteSurface(surface)
        gmsh.model.mesh.setRecombine(2, surface)
    for _, curve in gmsh.model.getEntities(1):
        gmsh.model.mesh.setTransfiniteCurve(curve, 3)
    for _, body in gmsh.model.getEntities(3):
        gmsh.model.mesh.setTransfiniteVolume(body)
    bottom = [t for _, t in gmsh.model.getEntitiesInBoundingBox(-1, -1, -0.1, 9, 9, 0.1, 2)]
    gmsh.model.addPhysicalGroup(2, bottom, name="bottom")
    gmsh.model.addPhysicalGroup(3, [2], tag=5, name="right")
    gmsh.model.addPhysicalGroup(3, [1], tag=9, name="left")
    gmsh.model.mesh.generate(3)
    gmsh.model.mesh.setOrder(degree)


@pytest.mark.parametrize("degree", [1, 2])
def test_model_of_hexahedra_and_its_file(gmsh, tmp_path, degree):
    box_of_hexahedra(gmsh, degree)
    mesh = from_gmsh(gmsh.model, fibre=lambda x: np.stack([0 * x[:, 0], x[:, 0], 0 * x[:, 0]], 1))
    assert mesh.cell.name == "hexahedron" and mesh.degree == degree and not mesh.is_swept
    assert mesh.num_cells == 16 and mesh.part_names == ("right", "left")
    assert volume(mesh) == pytest.approx(6.0, rel=1e-12)
    assert mesh.points[mesh.cells[mesh.cells_of(0)]][..., 0].min() == pytest.approx(2.0)
    assert np.all(mesh.fibre == [0.0, 1.0, 0.0])
    assert mesh.facet_nodes("bottom").shape == (8, 4 if degree == 1 else 9)
    assert np.all(mesh.points[mesh.facet_nodes("bottom")][..., 2] == 0.0)
    assert_straight_where_it_should_be(mesh)
    path = tmp_path / "boxes.msh"
    gmsh.write(str(path))
    again = read_mesh(path)
    assert again.points[again.cells] == pytest.approx(mesh.points[mesh.cells], abs=1e-12)
    assert np.array_equal(again.facets["bottom"], mesh.facets["bottom"])


def test_models_that_cannot_be_taken(gmsh):
    box_of_hexahedra(gmsh, 1)
    gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 1)
    gmsh.model.mesh.setOrder(2)
    with pytest.raises(ValueError, match="16 Hexahedron 20: only hexahedra with 8 or 27 nodes"):
        from_gmsh(gmsh.model)
    gmsh.model.add("empty")
    with pytest.raises(ValueError, match="the gmsh model has no volume cells"):
        from_gmsh(gmsh.model)


def vtk_order(mesh: SolidMesh) -> list[int]:
    """Nodes of a cell in the order of VTK's documentation."""
    if mesh.cell.is_simplex:
        return [0, 1, 2, 3, 9, 6, 8, 7, 5, 4][: mesh.cell.num_nodes]
    edges = [8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 15, 14]
    return ([0, 1, 3, 2, 4, 5, 7, 6] + edges + [22, 23, 21, 24, 20, 25, 26])[: mesh.cell.num_nodes]


@pytest.mark.parametrize("degree", [1, 2])
def test_file_of_meshio(tmp_path, degree):
    meshio = pytest.importorskip("meshio")
    line = np.stack(
        [0.3 * np.linspace(0, 1, 5) ** 2, np.zeros(5), np.linspace(0.0, 2.0, 5)], axis=1
    )
    mesh = sweep(line, round_section(0.5, 8, degree=degree))
    faces = mesh.facet_nodes("end")[:, [0, 1, 3, 2]]
    kind = "hexahedron" if degree == 1 else "hexahedron27"
    number = [np.arange(mesh.num_cells) % 2 + 3, np.full(len(faces), 8)]
    file = meshio.Mesh(
        np.vstack([mesh.points, [7.0, 7.0, 7.0]]),
        [(kind, mesh.cells[:, vtk_order(mesh)]), ("quad", faces)],
        cell_data={"part": number},
    )
    meshio.write(tmp_path / "yarn.vtu", file)
    again = read_mesh(tmp_path / "yarn.vtu", fibre=mesh.fibre)
    assert again.points[again.cells] == pytest.approx(mesh.points[mesh.cells], abs=1e-14)
    assert again.num_parts == 2 and again.num_nodes == mesh.num_nodes
    assert np.array_equal(again.facet_nodes("8"), mesh.facet_nodes("end"))


def test_files_that_cannot_be_read(tmp_path):
    with pytest.raises(ValueError, match="nothing.msh: there is no such file"):
        read_mesh(tmp_path / "nothing.msh")
    meshio = pytest.importorskip("meshio")
    points = np.vstack([np.zeros(3), np.eye(3), np.ones(3)])
    mixed = [("tetra", np.array([[0, 1, 2, 3]])), ("pyramid", np.array([[0, 1, 2, 3, 4]]))]
    meshio.write(tmp_path / "mixed.vtu", meshio.Mesh(points, mixed))
    with pytest.raises(ValueError, match="1 pyramid, 1 tetra: only hexahedra"):
        read_mesh(tmp_path / "mixed.vtu")
    meshio.write(
        tmp_path / "stray.vtu",
        meshio.Mesh(points, [mixed[0], ("triangle", [[1, 2, 4]])], cell_data={"part": [[0], [1]]}),
    )
    with pytest.raises(ValueError, match='surface "1" has 1 faces that bound no cell'):
        read_mesh(tmp_path / "stray.vtu")
