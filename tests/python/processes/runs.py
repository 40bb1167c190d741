"""Runs of the smallest braid through the command line, as a user starts them."""

import json
import os
import sys
from dataclasses import dataclass
from pathlib import Path

from braidx.output import history

SMALL = Path(__file__).parents[3] / "demos" / "small_rope.toml"
QUICK = ["--set", "output.pictures=false", "--set", "output.fields=false"]


@dataclass(frozen=True)
class Run:
    """A run that has ended, or that was ended."""

    folder: Path
    code: int
    stderr: str

    @property
    def summary(self):
        return json.loads((self.folder / "summary.json").read_text("utf-8"))

    @property
    def values(self):
        return {name: result["value"] for name, result in self.summary["results"].items()}

    @property
    def history(self):
        return history.read(self.folder / "history.csv")


def command(folder, *words, scene=SMALL, ranks=1):
    """The words that start a run."""
    mpirun = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
    program = [sys.executable, "-m", "braidx", "run", str(scene), "--out", str(folder), *QUICK]
    return [*mpirun, *program, *words]


def environment():
    """That of this process; ranks on one machine, and one thread each, so that they do not fight."""
    return os.environ | {
        "OMPI_MCA_btl": "self,sm",
        "OMPI_MCA_mpi_yield_when_idle": "1",
        "OPENBLAS_NUM_THREADS": "1",
        "BRAIDX_THREADS": "1",
    }
