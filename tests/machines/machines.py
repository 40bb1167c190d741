"""Machines that this one can stand for: builds of the engine, instructions of the libraries, threads and ranks."""

from __future__ import annotations

import os
import platform
from dataclasses import dataclass

# Where the launcher built the engine, by the level of processors (python/braidx/cli/environment/run_tests.sh).
BUILDS = dict(pair.split("=", 1) for pair in os.environ.get("BRAIDX_BUILDS", "").split())
V3 = "x86-64-v3"  # AVX2 and fused multiplications
AVX512 = "AVX512F AVX512CD AVX512_SKX AVX512_CLX AVX512_CNL AVX512_ICL AVX512_SPR"

# What OpenBLAS, NumPy and the C library are told of the processor, which they would ask otherwise. A fused
# multiplication rounds once where two instructions round twice.
OLD = {
    "OPENBLAS_CORETYPE": "Prescott",
    "NPY_DISABLE_CPU_FEATURES": f"AVX2 FMA3 {AVX512}",
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F",
}
NEW = {
    "OPENBLAS_CORETYPE": "Haswell",
    "NPY_DISABLE_CPU_FEATURES": AVX512,
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX512F",
}


@dataclass(frozen=True)
class Machine:
    """A machine.

    Attributes:
        new: Whether its processor has the level x86-64-v3, where this one has.
        threads: Of the engine.
        ranks: MPI processes; 0 is one without mpirun.
    """

    new: bool = True
    threads: int = 1
    ranks: int = 0

    @property
    def variables(self) -> dict[str, str]:
        """Of the environment: what is found first is the build."""
        new = self.new and V3 in BUILDS
        build = BUILDS.get(V3 if new else "any", "")
        path = os.pathsep.join(filter(None, [build, os.environ.get("PYTHONPATH", "")]))
        libraries = (NEW if new else OLD) if platform.machine() == "x86_64" else {}
        return libraries | {"PYTHONPATH": path, "BRAIDX_THREADS": str(self.threads)}


FIRST = Machine(new=False)
OTHERS = {
    V3: Machine(),
    "2 threads": Machine(threads=2),
    "2 ranks": Machine(ranks=2),
}
