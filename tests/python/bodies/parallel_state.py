"""Write energy, residual, tangent and tension of the example bodies, summed over the ranks."""

import sys

import numpy as np
from example_bodies import make_body, random_state
from mpi4py import MPI


def main(path: str) -> None:
    comm = MPI.COMM_WORLD
    results = {}
    for model in ("cable", "beam"):
        for degree in (1, 2):
            body = make_body(model, degree, comm)
            state = random_state(body)
            tension = body.tension(state)
            assert all(np.array_equal(tension, other) for other in comm.allgather(tension))
            rows, columns = body.tangent_pattern()
            tangent = np.zeros((body.num_unknowns, body.num_unknowns))
            np.add.at(tangent, (rows, columns), body.tangent_values())
            name = f"{model} {degree} "
            results[name + "energy"] = comm.allreduce(body.energy())
            results[name + "residual"] = comm.allreduce(body.residual())
            results[name + "tangent"] = comm.allreduce(tangent)
            results[name + "tension"] = tension
    if comm.rank == 0:
        np.savez(path, **results)


if __name__ == "__main__":
    main(sys.argv[1])
