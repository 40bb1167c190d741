"""Write energy, forces, tangent and stresses of solids, summed over the ranks."""

import sys

import numpy as np
from example_solids import make_body, random_state
from mpi4py import MPI


def main(path: str) -> None:
    comm = MPI.COMM_WORLD
    results = {}
    for kind, degree in (("swept", 1), ("swept", 2), ("free", 1), ("tetrahedra", 2)):
        body = make_body(kind, degree, comm=comm)
        state = random_state(body)
        stresses = {"von Mises": body.von_mises(state), "fibre": body.fibre_stress(state)}
        if kind == "swept":
            stresses["axial"] = body.mean_axial_force(state, 1)
        for values in stresses.values():
            assert all(np.array_equal(values, other) for other in comm.allgather(values))
        rows, columns = body.tangent_pattern()
        tangent = np.zeros((body.num_unknowns, body.num_unknowns))
        np.add.at(tangent, (rows, columns), body.tangent_values())
        sums = {"energy": body.energy(), "residual": body.residual(), "tangent": tangent}
        for name, values in sums.items():
            results[f"{kind} {degree} {name}"] = comm.allreduce(values)
        results |= {f"{kind} {degree} {name}": values for name, values in stresses.items()}
    if comm.rank == 0:
        np.savez(path, **results)


if __name__ == "__main__":
    main(sys.argv[1])
