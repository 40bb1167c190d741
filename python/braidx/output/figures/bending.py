"""All figures of a rope bent over a sheave."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from braidx.output.bending_measures import crown_of
from braidx.output.figures import animation, bent, contact_map, cross_section_bent, slip_map
from braidx.output.figures.shapes import Colouring
from braidx.output.figures.jobs import draw_jobs
from braidx.output.interlacing import relative_displacement
from braidx.output.measures import layers
from braidx.output.snapshot import Snapshot


def draw_bending(
    out_dir: Path,
    snapshots: Sequence[Snapshot],
    reference: Snapshot | None = None,
    movie: bool = True,
) -> list[Path]:
    """Draw every figure of bending that the states allow into `out_dir/figures`.

    Args:
        out_dir: Output folder of the run.
        snapshots: States of the bending in the order of the run; pictures show the last one.
        reference: The straight rope that slip is counted from; the first of `snapshots` if None.
        movie: Whether to make the animation too.
    Returns:
        The files written. A figure that cannot be drawn is reported in the log and left out.
    """
    if not snapshots:
        return []
    folder = out_dir / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    last = snapshots[-1]
    straight = snapshots[0] if reference is None else reference

    def slip(path: Path) -> Path:
        result = relative_displacement(
            straight.centre_lines, last.centre_lines, straight.radius, layers(straight)
        )
        return slip_map.draw_slip_map(result, crown_of(last), path, last.state)

    jobs: dict[str, Callable[[Path], Path]] = {
        "bent.png": lambda path: bent.draw_bent(last, path),
        "bent_aslant.png": lambda path: bent.draw_aslant(last, path),
        "crown_section.png": lambda path: cross_section_bent.draw_crown_section(last, path),
    }
    if last.axial_stress is not None:
        jobs["bent_stress.png"] = lambda path: bent.draw_bent(last, path, Colouring.STRESS)
        jobs["bent_stress_aslant.png"] = lambda path: bent.draw_aslant(last, path, Colouring.STRESS)
    if last.contacts is not None:
        jobs["contact_map.png"] = lambda path: contact_map.draw_contact_map(last, path)
    if last is not straight:
        jobs["slip_map.png"] = slip
    if movie and len(snapshots) > 1:
        jobs["bending.gif"] = lambda path: animation.draw_bending_movie(snapshots, path)
    return draw_jobs({folder / name: job for name, job in jobs.items()})
