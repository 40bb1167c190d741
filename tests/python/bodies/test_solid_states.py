"""Homogeneous states of solids against closed forms, rigid motion, prestress, errors."""

from dataclasses import replace

import numpy as np
import pytest
from example_solids import CASES, SOFT, YARN, arc, bar, cached_body, random_state
from mpi4py import MPI
from scipy.spatial.transform import Rotation

from braidx.bodies import SolidBody
from braidx.meshing import rectangle, round_section

TURN = Rotation.from_rotvec([0.7, -2.1, 1.3]).as_matrix()
KINDS = [(kind, degree) for kind, degree, law in CASES if law == "transversely isotropic"]


def elasticity(material, fibre):
    """Stiffness C of the strain tensor, shape (3, 3, 3, 3), MPa, from the compliance in the fibre's frame."""
    e_a, e_t, g_a, n_a, n_t = (getattr(material, name) for name in material.__dataclass_fields__)
    normal = [
        [1 / e_t, -n_t / e_t, -n_a / e_a],
        [-n_t / e_t, 1 / e_t, -n_a / e_a],
        [-n_a / e_a, -n_a / e_a, 1 / e_a],
    ]
    local = np.zeros((3, 3, 3, 3))
    for (i, j), value in np.ndenumerate(np.linalg.inv(normal)):
        local[i, i, j, j] = value
    for (i, j), shear in {(0, 1): e_t / 2 / (1 + n_t), (0, 2): g_a, (1, 2): g_a}.items():
        local[i, j, i, j] = local[i, j, j, i] = local[j, i, i, j] = local[j, i, j, i] = shear
    across = np.linalg.svd(fibre[None])[2][1:]
    frame = np.vstack([across, fibre])
    return np.einsum("abcd,ai,bj,ck,dl->ijkl", local, frame, frame, frame, frame)


@pytest.mark.parametrize("fibre", [(0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.6, 0.0, 0.8)])
@pytest.mark.parametrize("kind, degree", KINDS)
def test_energy_of_homogeneous_states_from_the_compliance(kind, degree, fibre):
    """Fibres along, across and askew of the strain, which is large."""
    mesh, direction = cached_body(kind, degree).mesh, np.array(fibre)
    mesh = replace(mesh, fibre=np.tile(direction, (mesh.num_cells, 1)))
    body = SolidBody(MPI.COMM_SELF, mesh, material=YARN)
    gradient = np.eye(3) + 0.1 * np.random.default_rng(3).standard_normal((3, 3))
    strain = 0.5 * (gradient.T @ gradient - np.eye(3))
    density = 0.5 * np.einsum("ij,ijkl,kl", strain, elasticity(YARN, direction), strain)
    body.set_state(body.rest @ gradient.T)
    # Volumes of curved cells of degree 2 are integrated with fewer points than their energy.
    accuracy = 1e-8 if (kind, degree) == ("swept", 2) else 1e-12
    assert body.energy() == pytest.approx(density * body.volumes().sum(), rel=accuracy)
    state = body.rest @ gradient.T
    assert body.energy_density(state) == pytest.approx(density, rel=1e-12)
    second = np.einsum("ijkl,kl->ij", elasticity(YARN, direction), strain)
    cauchy = gradient @ second @ gradient.T / np.linalg.det(gradient)
    deviator = cauchy - np.trace(cauchy) / 3.0 * np.eye(3)
    assert body.von_mises(state) == pytest.approx(np.sqrt(1.5 * np.sum(deviator**2)), rel=1e-12)
    along = gradient @ direction / np.linalg.norm(gradient @ direction)
    assert body.fibre_stress(state) == pytest.approx(along @ cauchy @ along, rel=1e-12)


@pytest.mark.parametrize("kind, degree, law", CASES)
def test_rigid_motion(kind, degree, law):
    body = cached_body(kind, degree, law)
    state = random_state(body)
    body.set_state(state)
    energy, force = body.energy(), body.residual().copy()
    turned = (force.reshape(-1, 3) @ TURN.T).ravel()
    body.set_state(state @ TURN.T + [3.0, -2.0, 5.0])
    assert body.energy() == pytest.approx(energy, rel=1e-12)
    assert np.abs(body.residual() - turned).max() < 1e-12 * np.abs(turned).max()
    assert np.abs(force.reshape(-1, 3).sum(axis=0)).max() < 1e-12 * np.abs(force).max()
    if kind != "swept" or law != "transversely isotropic":
        body.set_state(body.rest @ TURN.T)
        assert np.abs(body.residual()).max() < 1e-12 * np.abs(force).max()


@pytest.mark.parametrize("degree", [1, 2])
def test_pulled_bar_contracts_freely(degree):
    section = round_section(0.5, 8, degree=degree)
    body = SolidBody(MPI.COMM_SELF, bar(section, 2.0, 2), material=YARN, fibre_stress=0.5)
    stretch = 1.2
    strain = 0.5 * (stretch**2 - 1.0)
    across = np.sqrt(1.0 - 2.0 * YARN.axial_poisson * strain)
    state = body.rest * [across, across, stretch]
    body.set_state(state)
    forces = body.residual().reshape(-1, 3)
    expected = section.moments()[0] * stretch * (YARN.axial_modulus * strain + 0.5)
    layers = body.mesh.sweeps[0].layers
    assert forces[layers[-1], 2].sum() == pytest.approx(expected, rel=1e-12)
    assert np.abs(forces[layers[1:-1]]).max() < 1e-12 * expected
    assert np.abs(forces[:, :2]).max() < 1e-12 * expected
    assert body.mean_axial_force(state) == pytest.approx(np.full(2, expected), rel=1e-12)
    true_stress = expected / section.moments()[0] / across**2
    assert body.fibre_stress(state) == pytest.approx(true_stress, rel=1e-12)
    assert body.von_mises(state) == pytest.approx(true_stress, rel=1e-12)


@pytest.mark.parametrize("degree", [1, 2])
def test_neo_hooke_in_shear_and_swelling(degree):
    body = cached_body("swept", degree, "neo-Hooke")
    shear, bulk = 50.0 / 2.6, 50.0 / 1.2
    gradient = np.eye(3)
    gradient[0, 1] = 0.4
    state = body.rest @ gradient.T
    assert body.energy_density(state) == pytest.approx(0.5 * shear * 0.4**2, rel=1e-12)
    assert body.von_mises(state) == pytest.approx(shear * 0.4 * np.sqrt(3.16), rel=1e-12)
    swollen, volume = 1.1 * body.rest, 1.1**3
    expected = bulk * np.log(volume) / volume
    assert body.fibre_stress(swollen) == pytest.approx(expected, rel=1e-12)
    assert body.energy_density(swollen) == pytest.approx(0.5 * bulk * np.log(volume) ** 2)
    assert np.abs(body.von_mises(swollen)).max() < 1e-6 * expected


def test_saint_venant_kirchhoff_is_the_isotropic_case_of_the_yarns_law():
    # Of cells that follow no line, where both laws are integrated in full.
    both = [
        SolidBody(MPI.COMM_SELF, replace(arc(2), sweeps={}), material=SOFT, law=law)
        for law in ("transversely isotropic", "Saint-Venant-Kirchhoff")
    ]
    state = random_state(both[0])
    first, second = [body.set_state(state) or body.residual().copy() for body in both]
    assert np.abs(first - second).max() < 1e-12 * np.abs(first).max()


def test_materials_and_prestress_per_part_and_cell():
    body = cached_body("swept", 1)
    assert body.fibre_stress(body.rest) == pytest.approx(np.where(body.mesh.cell_part, 0.0, 1.5))
    values = np.arange(body.num_elements, dtype=float)
    body.set_fibre_stress(values)
    assert body.fibre_stress(body.rest) == pytest.approx(values)
    body.set_fibre_stress([1.5, 0.0])
    state = body.rest * [1.0, 1.0, 1.1]
    stress = body.von_mises(state)
    assert stress[body.cells_of(1)].max() > 1.1 * SOFT.axial_modulus * 0.05
    assert np.array_equal(body.facet_nodes("end", 1), body.mesh.facet_nodes("end", 1))


def test_errors():
    mesh = bar(rectangle(1.0, 1.0), 1.0, 1)

    def make(**options):
        return SolidBody(MPI.COMM_SELF, mesh, **{"material": SOFT, **options})

    for options, message in (
        ({"law": "rubber"}, 'law is "rubber": give one of'),
        ({"law": "neo-Hooke", "material": YARN}, "material of part 0 is not isotropic"),
        ({"material": [SOFT, SOFT]}, r"material has 2 items: give one, or one per part \(1\)"),
        ({"fibre_stress": [1.0, 2.0]}, "fibre_stress has shape"),
        ({"law": "neo-Hooke", "fibre_stress": 1.0}, 'law "neo-Hooke" has none'),
    ):
        with pytest.raises(ValueError, match=message):
            make(**options)
    with pytest.raises(ValueError, match="part 2 has no centre line: swept parts are 0"):
        make().mean_axial_force(mesh.points, part=2)
