"""Draw the figures of a finished run again: python -m braidx.output.figures OUT_DIR."""

from __future__ import annotations

import sys
from pathlib import Path

from braidx.output import snapshot
from braidx.output.figures import draw_all
from braidx.output.summary import read_references


def main(out_dir: Path) -> int:
    """Draw from snapshots/*.npz (in the order of their names), history.csv and summary.json."""
    if not out_dir.is_dir():
        print(f"{out_dir}: no such folder; name the output folder of a run.", file=sys.stderr)
        return 2
    snapshots = [snapshot.load(path) for path in sorted((out_dir / "snapshots").glob("*.npz"))]
    summary = out_dir / "summary.json"
    references = read_references(summary) if summary.exists() else {}
    for path in draw_all(out_dir, snapshots, out_dir / "history.csv", references):
        print(path)
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python -m braidx.output.figures OUT_DIR")
    sys.exit(main(Path(sys.argv[1])))
