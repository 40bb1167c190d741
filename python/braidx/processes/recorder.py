"""What a run leaves behind: history, checkpoint, snapshots, fields, pictures, summary."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from mpi4py import MPI

from ..geometry import Rope
from ..output import figures, history, paraview, snapshot
from ..output.console import make_console
from ..output.history import History, HistoryRow
from ..output.log import LOGGER, close_log, open_log
from ..output.progress import Progress
from ..output.snapshot import Snapshot
from ..output.summary import PhaseCost, Summary, peak_memory_MB
from ..scene import Scene, Step, followed
from ..scene.results import RESULT_UNITS
from ..solver.blas import blas_warning
from . import state as checkpoint
from .bending.aftermath import after_bending
from .measurements import FIRST_PULL, OF_THE_RUN, final_results
from .recorded import RecordedModel
from .outcome import NotConverged, Outcome
from .state import State

SNAPSHOTS, STATES = "snapshots", "states"
HELD = (
    0.05  # stabilisation's work over the energy above which results are those of its viscosity, too
)
SHARE = "stabilisation_residual_share"
STATES_OF = "states"  # entry of a checkpoint's results: which state each is of
WEIGHTS = {"form": 4.0, "settle": 1.0, "pull": 4.0, "hold": 1.0, "cycle": 6.0}


class Recorder:
    """Writes on the first process only; the other processes take part in gathering."""

    def __init__(
        self, comm: MPI.Comm, scene: Scene, rope: Rope, folder: Path, resumed: State | None
    ) -> None:
        self.comm, self.scene, self.rope, self.folder = comm, scene, rope, folder
        self.first = comm.rank == 0
        self._results = (
            {name: resumed.results[name] for name in RESULT_UNITS if name in resumed.results}
            if resumed
            else {}
        )
        self._states: dict[str, str] = dict(resumed.results.get(STATES_OF, {})) if resumed else {}
        self._costs: Mapping[str, PhaseCost] = resumed.costs if resumed else {}
        self._unknowns = self._elements = 0
        self._threads = 1
        if not self.first:
            return
        console = make_console()
        open_log(folder, console, append=resumed is not None)
        after = resumed.increment if resumed else None
        self._history = History(folder / "history.csv", after)
        self._series = paraview.Series(folder / "fields", after) if scene.output.fields else None
        for kept in (SNAPSHOTS, STATES) if scene.output.states else (SNAPSHOTS,):
            (folder / kept).mkdir(exist_ok=True)
        names = [f"{i + 1} {step.kind}" for i, step in enumerate(scene.steps)]
        self._progress = Progress(
            names, [WEIGHTS.get(step.kind, 20.0) for step in scene.steps], console
        )
        slow = blas_warning()
        if slow:
            LOGGER.warning("%s", slow)
        if resumed is None:
            self._keep(start_snapshot(rope), 0)
        elif resumed.step < len(names):
            LOGGER.info("resumed after increment %d", resumed.increment)
            self._progress.resume(names[resumed.step], 0.0)

    def begin(self, step: Step, model: RecordedModel) -> None:
        """A step begins with a model."""
        self._unknowns = max(self._unknowns, model.system.num_free)
        self._threads = model.contact.num_threads

    def record(self, model: RecordedModel, step: Step, outcome: Outcome, seconds: float) -> None:
        """One more increment is accepted."""
        state, increment = outcome.state, outcome.increment
        self._elements = max(self._elements, increment.contact_elements)
        # A rope that is straight or slack again has hardly any energy left: the most that it had counts.
        energy = state.progress.get("energy") or model.internal_energy(state.q)
        counts = energy > 0 and not state.forms
        residual = state.stabilisation_residual / energy if counts else 0.0
        work = state.stabilisation_work / energy if counts else 0.0
        name = outcome.snapshot or step.kind
        picture = None
        if self._wanted(outcome):
            picture = replace(model.picture(state, name), force=outcome.force / 1e3)
        self._results["friction_work"] = state.friction_work
        if outcome.snapshot and picture is not None:
            found = model.results(state, picture)
            kept = [name for name in FIRST_PULL if name in self._results]
            found = {name: value for name, value in found.items() if name not in kept}
            self._results |= found  # of several pulls the first one counts
            self._states |= dict.fromkeys(found, picture.state)
        state.results.update(self._results)
        state.results[STATES_OF] = dict(self._states)
        self._costs = state.costs
        self.checkpoint(state)
        if not self.first:
            return
        row = HistoryRow(
            state.increment,
            outcome.strain,
            outcome.force / 1e3,
            outcome.cost[0],
            increment.contact_elements,
            increment.penetration,
            state.friction_work,
            seconds,
            f"{state.step + 1} {step.kind}",
            increment.penetration / float(self.rope.radius.min()),
            residual,
            outcome.cost[1],
            increment.updates,
            outcome.cuts,
            outcome.moment,
            outcome.travel,
            work,
            outcome.run,
        )
        self._history.append(row)
        self._progress.increment(row, outcome.share)
        if (
            picture is not None
            and self._series is not None
            and state.increment % self.scene.output.every == 0
        ):
            self._series.append(picture, state.increment)
        if picture is not None and outcome.snapshot:
            self._keep(picture, state.increment)
        if picture is not None and self.scene.output.states:
            self._keep(picture, state.increment, STATES)

    def checkpoint(self, state: State) -> None:
        """Writes the state to go on from."""
        if self.first:
            checkpoint.save(state, self.folder)

    def finish(self, converged: bool) -> dict[str, Any]:
        """Pictures, the table of time per phase and summary.json.

        Raises:
            NotConverged: If all steps found equilibria, but the results are those of the stabilisation, too.
        """
        contents: dict[str, Any] = {}
        memory = self.comm.allreduce(peak_memory_MB())
        if self.first:
            self._history.close()
            files = sorted((self.folder / SNAPSHOTS).glob("*.npz"))
            if self.scene.output.pictures:
                kept = [snapshot.load(path) for path in files]
                rows = self.folder / "history.csv"
                figures.draw_all(self.folder, kept, rows, self.scene.expected)
            self._results |= after_bending(self.scene, self.rope, self.folder, files)
            self._progress.finish(self._costs)
            contents = self._write_summary(converged, memory)
            close_log()
        contents = self.comm.bcast(contents)
        if converged and not contents["converged"]:
            raise NotConverged(_held(contents["results"][SHARE]["value"]))
        return contents

    def _write_summary(self, converged: bool, memory: float) -> dict[str, Any]:
        summary = Summary(self.scene.name, self.scene.expected)
        kept = followed(self.scene)
        summary.accuracy = None if kept is None else asdict(kept)
        rows = history.read(self.folder / "history.csv")
        values = {**self._results, **final_results(self.scene, self.rope, rows)}
        for name, unit in RESULT_UNITS.items():
            if name in values or name in self.scene.expected:
                of = OF_THE_RUN.get(name) or self._states.get(name)
                summary.set(name, values.get(name), unit, of)
        cost = summary.cost
        cost.phases = dict(self._costs)
        cost.peak_memory_MB = memory
        cost.unknowns, cost.contact_elements = self._unknowns, self._elements
        cost.ranks = self.comm.size
        cost.threads = self._threads
        share = values.get(SHARE, 0.0)
        summary.converged = converged and share <= HELD
        summary.write(self.folder / "summary.json")
        if share > HELD:
            LOGGER.warning("%s", _held(share))
        return summary.as_dict()

    def _wanted(self, outcome: Outcome) -> bool:
        fields = self.scene.output.fields and outcome.state.increment % self.scene.output.every == 0
        return fields or self.scene.output.states or outcome.snapshot is not None

    def _keep(self, picture: Snapshot, increment: int, place: str = SNAPSHOTS) -> None:
        name = picture.name.replace(" ", "_").replace(",", "").replace("%", "percent")
        snapshot.save(picture, self.folder / place / f"{increment:05d}_{name}.npz")


def _held(share: float) -> str:
    return (
        f"the stabilisation still did {100.0 * share:.0f} % as much work as there was energy in the states found: "
        "history.csv tells from which "
        "increment on results are not to be trusted; try more increments of the steps, or a lower "
        "solver.viscosity and solver.director_viscosity"
    )


def start_snapshot(rope: Rope) -> Snapshot:
    """The start configuration."""
    return Snapshot("start", rope.centre_lines, rope.radius, rope.strand)
