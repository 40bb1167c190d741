"""Runs of the smallest braid through the command line, as a user starts them."""

import json
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


def command(folder, *words, scene=SMALL):
    """The words that start a run."""
    program = [sys.executable, "-m", "braidx", "run", str(scene), "--out", str(folder), *QUICK]
    return [*program, *words]
