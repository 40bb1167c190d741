"""The option --accuracy: what it chooses, and what it is told of that."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rich.console import Console

from braidx.scene import Scene, followed, level_of
from braidx.scene.accuracy import fraction


def with_accuracy(overrides: Sequence[str] | None, accuracy: str | None) -> list[str]:
    """Overrides of a scene with the accuracy asked for among them.

    Raises:
        SceneError: If there is no such accuracy.
    """
    asked = [] if accuracy is None else [f'solver.accuracy="{level_of(accuracy)}"']
    return [*(overrides or []), *asked]


def tell_accuracy(scene: Scene, console: Console) -> None:
    """Prints which options were chosen for the accuracy that a scene asks for, and which the scene states itself."""
    kept = followed(scene)
    if kept is None:
        return
    console.print(f"accuracy {kept.level}: chosen {_listed(kept.chosen) or 'nothing'}")
    if kept.stated:
        console.print(f"as the scene states: {_listed(kept.stated)}; no accuracy is known of these")
    if kept.reached > fraction(kept.level):
        console.print(
            f"{kept.level} was not reached where this was measured, but {100.0 * kept.reached:.2g}% (docs/accuracy.md)"
        )


def _listed(options: dict[str, Any]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in options.items())
