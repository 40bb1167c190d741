"""What the recording of a run asks of a model."""

from __future__ import annotations

from typing import Protocol

from ..contact.contact import Contact
from ..output.snapshot import Snapshot
from ..system.constraints import Floats
from ..system.global_system import GlobalSystem
from .state import State


class RecordedModel(Protocol):
    """A rope that is being computed.

    Attributes:
        copies: How often what is solved for occurs in the sample.
    """

    system: GlobalSystem
    contact: Contact

    @property
    def copies(self) -> int: ...

    def internal_energy(self, q: Floats) -> float:
        """Elastic energy of all processes, mJ."""
        ...

    def picture(self, state: State, name: str) -> Snapshot:
        """A state of the whole sample, gathered from all processes."""
        ...

    def results(self, state: State, picture: Snapshot) -> dict[str, float]:
        """Results of a state worth a picture, by name (measurements.py)."""
        ...
