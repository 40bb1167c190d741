"""A beam pressed across two cables, or on a solid, with friction.

As a script it writes what it finds, for any number of processes.
"""

import sys

import numpy as np
from mpi4py import MPI

from braidx.rods import Beam, Cable, Rods, Solid, YarnMaterial, straight


def pressed():
    """The beam's clamped ends go down by 0.6 mm and along by 0.2 mm."""
    across = straight((0, -8, 1.9), (0, 8, 1.9), 16)
    parts = [Beam(across, 1.0, YarnMaterial.isotropic(2e3, 0.3))]
    for y in (-2.5, 2.5):
        parts.append(Cable(straight((-8, y, 0), (8, y, 0), 16), 1.0, 1e4, tension=200.0))
    rods = Rods(parts, friction=0.2, tolerance=1e-10)
    rods.clamp(0, [0, -1])
    for cable in (1, 2):
        rods.pin(cable, [0, -1])
    rods.move(0, [0, -1], by=(0.2, 0.0, -0.6))
    rods.solve(increments=3)
    return rods


def pressed_on_solid():
    """The beam's clamped ends go down by 0.3 mm and along by 0.2 mm, askew across a bar of hexahedra."""
    material = YarnMaterial.isotropic(2e3, 0.3)
    across = straight((-0.7, -6, 2.0), (0.4, 6, 2.0), 12)
    below = straight((-6, 0, 0), (6, 0, 0), 12)
    parts = [Beam(across, 1.0, material), Solid(below, 1.0, material, degree=1)]
    rods = Rods(parts, friction=0.2, tolerance=1e-10)
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    rods.move(0, [0, -1], by=(0.2, 0.0, -0.3))
    rods.solve(increments=2)
    return rods


def joined():
    """A beam with a cable hinged between two nodes, a welded bracket and a rigid end, under loads that follow."""
    material = YarnMaterial.isotropic(2e3, 0.3)
    beam = Beam(straight((0, 0, 0), (20, 0, 0), 8), 1.0, material)
    stay = Cable(straight((6.2, 0, 0), (6.2, 12, 3), 4), 0.2, 1e4)
    bracket = Beam(straight((15, 0, 0), (15, 0, 8), 4), 0.5, material)
    rods = Rods([beam, stay, bracket], tolerance=1e-10)
    rods.clamp(0, 0)
    rods.pin(1, -1)
    rods.hinge((1, 0), (0, 2.48))
    rods.tie((2, 0), (0, 6))
    end = rods.rigid([(0, -1)], centre=(20, 2, 0))
    rods.force(end, 0, (1.0, 0.0, 0.5))
    rods.couple(end, 0, (5.0, 0.0, 0.0))
    rods.follower_force(2, -1, (0.1, 0.2, 0.3))
    rods.pressure(0, -0.2)
    rods.line_load(1, (0.01, 0.0, 0.0), at_once=True)
    rods.solve(increments=2)
    return rods


def results():
    """What processes have to agree on."""
    found = {}
    scenes = {"cables": pressed(), "solid": pressed_on_solid(), "joints": joined()}
    for name, rods in scenes.items():
        found |= {
            f"{name}: q": rods.q,
            f"{name}: reaction": np.concatenate(rods.reaction(0, 0)),
            f"{name}: tension": rods.tension(1),
            f"{name}: energy": [rods.elastic_energy()],
            f"{name}: friction work": [rods.friction_work],
        }
    return found


def main(path):
    found = results()
    if MPI.COMM_WORLD.rank == 0:
        np.savez(path, **found)


if __name__ == "__main__":
    main(sys.argv[1])
