"""State of a run between increments: what a checkpoint holds, and what a step starts from."""

from __future__ import annotations

import json
import os
import zipfile
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from ..contact.contact import Contact
from ..output.summary import PhaseCost
from ..scene import SceneError
from ..system.constraints import Floats, Ints

FILE = "checkpoint.npz"
ARRAYS = ("q", "reference", "rest_tension", "previous", "stretches")
KEPT = (
    *("strain", "share", "tension"),
    *("travel", "pull", "run", "slope", "last_travel", "last_pull", "last_run", "sheave_angle"),
    *("furthest", "cycle_begin", "cycle_work", "energy"),
)  # by the steps that follow
CELL = ("cell", "released")  # models of one pitch


@dataclass(frozen=True)
class State:
    """State of a run after an increment.

    Attributes:
        q: Unknowns, shape (num_unknowns,); block of the model in use.
        model: While the rope is formed "cell" (one pitch), "released" (from the die) and "forming" (the whole rope,
            coming to rest), made of cables; then "cable" or "beam", or "bent" where it is clamped to be bent.
        reference: Unknowns of the reference state that strains are measured from, shape as q.
        rest_tension: Tension of the elements in the reference state, shape (num_elements,), N (cables).
        previous: Unknowns of a bent rope one increment before, shape as q; nothing at its start.
        stretches: What the yarns of a bent rope are modelled as (bending/stretches.py), shape (num_stretches, 4).
        contacts: Contact elements of all processes with their memory, as arrays.
        step: Number of the current step; `progress`: what the step has reached, its own numbers.
        increment: Increments so far, all steps.
        results: Results collected so far.
        costs: Cost per phase so far.
        stabilisation_work: Work that the stabilisation took since the reference state was set, mJ.
        stabilisation_residual: Part of it that is still in accepted states: of each increment what the stabilisation
            did not let go of, from where the rope is settled; mJ.
        friction_work: Work dissipated by friction in the whole sample since the start of the run, mJ.
    """

    q: Floats
    model: str
    reference: Floats
    rest_tension: Floats
    previous: Floats = field(default_factory=lambda: np.empty(0))
    stretches: Ints = field(default_factory=lambda: np.empty((0, 4), dtype=np.int64))
    contacts: dict[str, np.ndarray] = field(default_factory=dict)
    step: int = 0
    progress: dict[str, float] = field(default_factory=dict)
    increment: int = 0
    results: dict[str, Any] = field(default_factory=dict)
    costs: dict[str, PhaseCost] = field(default_factory=dict)
    stabilisation_work: float = 0.0
    stabilisation_residual: float = 0.0
    friction_work: float = 0.0

    @property
    def forms(self) -> bool:
        """Whether the rope is still being formed."""
        return self.model in (*CELL, "forming")

    def next_step(self) -> State:
        """The same state at the beginning of the step that follows."""
        kept = {name: self.progress[name] for name in KEPT if name in self.progress}
        return replace(self, step=self.step + 1, progress=kept)


def save(state: State, folder: Path) -> None:
    """Writes the checkpoint; an interruption leaves the one before whole."""
    arrays = {name: getattr(state, name) for name in ARRAYS}
    arrays |= {f"contacts_{name}": value for name, value in state.contacts.items()}
    numbers = {
        "model": state.model,
        "step": state.step,
        "progress": state.progress,
        "increment": state.increment,
        "results": state.results,
        "costs": {name: asdict(cost) for name, cost in state.costs.items()},
        "stabilisation_work": state.stabilisation_work,
        "stabilisation_residual": state.stabilisation_residual,
        "friction_work": state.friction_work,
    }
    part = folder / (FILE + ".part")
    with part.open("wb") as file:
        np.savez(file, numbers=np.array(json.dumps(numbers)), **arrays)
        file.flush()
        os.fsync(file.fileno())
    os.replace(part, folder / FILE)


def load(folder: Path) -> State | None:
    """The checkpoint of a folder, None if there is none yet.

    Raises:
        SceneError: If it cannot be read.
    """
    path = folder / FILE
    if not path.exists():
        return None
    try:
        with np.load(path) as data:
            numbers = json.loads(str(data["numbers"]))
            contacts = {
                name.removeprefix("contacts_"): data[name]
                for name in data
                if name.startswith("contacts_")
            }
            arrays = {name: data[name] for name in ARRAYS}
        numbers["costs"] = {name: PhaseCost(**cost) for name, cost in numbers["costs"].items()}
        return State(contacts=contacts, **arrays, **numbers)
    except (OSError, ValueError, LookupError, TypeError, zipfile.BadZipFile) as error:
        raise _broken(str(path), error) from None


def restore_contacts(contact: Contact, state: State) -> None:
    """Gives contact the history that a state has, if any.

    Raises:
        SceneError: If it fits neither itself nor the surfaces there are.
    """
    if not state.contacts:
        return
    try:
        contact.restore_arrays(state.contacts)
    except (ValueError, LookupError) as error:
        raise _broken(f"the contact history in {FILE}", error) from None


def _broken(what: str, error: Exception) -> SceneError:
    cure = f"{what} cannot be read ({error}); leave --resume out and choose another --out."
    return SceneError("--resume", cure)
