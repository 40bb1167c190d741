"""Figures of a run. A figure that cannot be drawn is reported and left out; a run goes on."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from braidx.output.figures import curves, rope, sections
from braidx.output.figures.bending import draw_bending
from braidx.output.figures.jobs import draw_jobs
from braidx.output.figures.style import formed, loaded, stages
from braidx.output.snapshot import Snapshot
from braidx.output.summary import Expected

__all__ = ["draw_all"]


def draw_all(
    out_dir: Path,
    snapshots: Sequence[Snapshot],
    history_path: Path,
    references: Mapping[str, Expected] | None = None,
) -> list[Path]:
    """Draw every figure that the results allow into `out_dir/figures`.

    Args:
        out_dir: Output folder of the run.
        snapshots: States in the order of the run; the formed rope is named "formed", the loaded
            rope is the end of the first pull, as in the results. Those with a sheave are of the rope being bent.
        history_path: history.csv of the run.
        references: Expected value per result name; `rope_axial_stiffness` (kN) is drawn.
    Returns:
        The files written.
    """
    folder = out_dir / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    bent = [picture for picture in snapshots if picture.sheave is not None]
    snapshots = [picture for picture in snapshots if picture.sheave is None]
    stiffness = (references or {}).get("rope_axial_stiffness")
    jobs: dict[str, Callable[[Path], Path]] = {}
    if snapshots:
        jobs["rope"] = lambda path: rope.draw_oblique(formed(snapshots), path)
        jobs["forming"] = lambda path: rope.draw_forming(stages(snapshots), path)
        jobs["forming_sections"] = lambda path: sections.draw_steps(stages(snapshots), path)
        jobs["formed_section"] = lambda path: sections.draw_section(formed(snapshots), path)
        last = loaded(snapshots)
        if last is not None:
            jobs["loaded_section"] = lambda path: sections.draw_section(last, path)
            jobs["yarn_stress"] = lambda path: rope.draw_stress(last, path)
            jobs["yarn_stress_histogram"] = lambda path: curves.draw_stress_histogram([last], path)
    if history_path.exists():
        if not bent:
            jobs["force_strain"] = lambda path: curves.draw_force_strain(
                history_path, path, stiffness
            )
        jobs["course"] = lambda path: curves.draw_course(history_path, path)
    drawn = draw_jobs({folder / f"{name}.png": job for name, job in jobs.items()})
    return drawn + draw_bending(out_dir, bent)
