"""All scenes of the peers after each other: what was aimed at, what was reached, and the figures of each.

    OPENBLAS_NUM_THREADS=2 ./braidx shell python3 tests/benchmark/peers/compare.py [--figures docs/images]

K: a knot, T: twisted yarns, S: strands in bending. Seconds are wall clock, on two cores;
those of the peers are of other machines.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import knot
import numpy as np
import strand
import twisted_yarn

from braidx.output.figures.style import AMBER, BLUE, figure, panels, save, styled

CLOSE = 0.05  # of the mean force on a knot
LIMITS = {"K": 30.0, "T 19 x 80": 20.0, "S 91": 120.0}  # seconds aimed at
STRANDS = {7: 92.0, 19: 239.0, 37: 501.0, 61: 903.0, 91: 1476.0}  # wires; seconds of the peer
BACK = (7, 19)  # strands that are bent back, too, which does not count


@dataclass(frozen=True)
class Row:
    """A scene: seconds of braidx and of the peer (None where it does not come to an end), and what was found."""

    scene: str
    unknowns: int
    seconds: float
    peer: float | None
    found: str

    @property
    def aim(self) -> str:
        """What is asked for, and whether it was reached."""
        if self.scene not in LIMITS:
            return ""
        limit = LIMITS[self.scene]
        return f"{limit:g} s: {'reached' if self.seconds <= limit else 'MISSED'}"


def timed(work: Callable[[], Any]) -> tuple[Any, float]:
    """What it returns, and the seconds that passed."""
    begin = time.perf_counter()
    return work(), time.perf_counter() - begin


def rows(figures: Path | None) -> Iterator[Row]:
    """Scene after scene; figures are drawn once a scene is done."""
    tied, seconds = timed(knot.run)
    ratio = tied.force(knot.PEER[:, 0]) / knot.PEER[:, 1]
    within = "within" if abs(ratio.mean() - 1.0) <= CLOSE else "NOT within"
    found = f"mean force {ratio.mean():.3f} of the peer's, {within} {CLOSE:.0%}"
    found += f"; {ratio.min():.2f} to {ratio.max():.2f}"
    yield Row("K", tied.unknowns, seconds, knot.PEER_COST["seconds"], found)
    twisted = []
    for fibres, spans, turns in twisted_yarn.SCENES:
        yarn = twisted_yarn.yarn(fibres, spans)
        outcome, seconds = timed(lambda: twisted_yarn.twist(yarn, turns, 12))
        twisted.append(outcome)
        tension, torque = outcome.curve[-1, 1:] / twisted_yarn.helices(turns, outcome.radii)
        found = f"tension {tension:.2f}, torque {torque:.2f} of helices"
        peer = twisted_yarn.PEER.get((fibres, spans))
        yield Row(f"T {fibres} x {spans}", outcome.unknowns, seconds, peer, found)
    bent = []
    for wires, peer in STRANDS.items():
        outcome = strand.run(wires, back=wires in BACK)
        bent.append(outcome)
        end = int(outcome.angles.argmax())
        moment, slipping = outcome.moments[end], outcome.slipping[end]
        found = f"{moment / 1e3:.1f} N m, {moment / slipping:.3f} of wires that slip"
        yield Row(f"S {wires}", outcome.unknowns, outcome.wall, peer, found)
    if figures:
        twisted_yarn.draw(twisted, figures / "twisted_yarn_forces.png")
        strand.draw(bent, figures / "strand_bending.png")


@styled
def draw(found: Sequence[Row], path: Path) -> Path:
    """Seconds of braidx and of the peers, scene by scene."""
    page = figure(8.5, 3.6)
    (ax,) = panels(page, 1, 1)
    places = np.arange(len(found))
    ax.bar(places - 0.2, [row.seconds for row in found], 0.4, color=BLUE, label="braidx")
    peers = [row.peer or np.nan for row in found]
    ax.bar(places + 0.2, peers, 0.4, color=AMBER, label="peer, another machine")
    for place, row in zip(places, found, strict=True):
        if row.peer is None:
            ax.annotate("peer stalls", (place + 0.2, 1.2), ha="center", rotation=90, fontsize=8)
    aims = [LIMITS.get(row.scene, np.nan) for row in found]
    ax.hlines(aims, places - 0.45, places + 0.05, color="black", label="aim")
    ax.set(yscale="log", ylabel="seconds", title="Time of scenes, two cores")
    ax.set(xlim=(-0.6, len(found) - 0.4), ylim=(1.0, None))
    ax.set_xticks(places, [row.scene for row in found])
    ax.legend(fontsize=8)
    return save(page, path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--figures", type=Path, help="folder of the figures")
    words = parser.parse_args()
    print("| scene | unknowns | seconds | peer (s) | aim | found |")
    print("| --- | ---: | ---: | ---: | --- | --- |")
    found = []
    for row in rows(words.figures):
        peer = f"{row.peer:g}" if row.peer else "stalls"
        print(
            f"| {row.scene} | {row.unknowns:,} | {row.seconds:.1f} | {peer} | {row.aim} | {row.found} |",
            flush=True,
        )
        found.append(row)
    if words.figures:
        draw(found, words.figures / "peers.png")


if __name__ == "__main__":
    main()
