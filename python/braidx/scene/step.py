"""What all steps of a programme have in common."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from braidx.scene.fields import Table


@dataclass(frozen=True)
class Step(Table):
    """What all steps have in common."""

    kind: ClassVar[str] = ""
