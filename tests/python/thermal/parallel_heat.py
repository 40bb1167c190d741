"""Write the temperature of an example, computed on all ranks."""

import sys

import numpy as np
from mpi4py import MPI

from braidx.thermal import RopeHeat, ThermalMaterial


def main(path: str) -> None:
    comm = MPI.COMM_WORLD
    material = ThermalMaterial(10.0, 0.3, 700.0, 1800.0, 25.0)
    model = RopeHeat(comm, np.linspace(0.0, 6.0, 4), np.linspace(0.0, 40.0, 8), material)
    model.set_source(np.random.default_rng(3).uniform(0.0, 1e-4, model.num_cells))
    history = model.run(500.0, 5)
    assert all(np.array_equal(history.field, other) for other in comm.allgather(history.field))
    if comm.rank == 0:
        np.save(path, history.field)


if __name__ == "__main__":
    main(sys.argv[1])
