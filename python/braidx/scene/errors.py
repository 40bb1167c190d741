"""The one error for everything a user can write wrongly in a scene."""

from __future__ import annotations

from difflib import get_close_matches
from collections.abc import Iterable

LONG = 128  # bits, 39 digits: longer numbers are refused by all options, and Python writes out no very long ones
NO_VALUE = ...  # keeps its identity when an error is sent to another process


class SceneError(ValueError):
    """Bad input: names the key, its value and the cure, in one line.

    Args:
        key: Dotted name in the scene, for example "rope.pitch".
        cure: What is wrong and what to write instead.
        value: The value found; left out where there is none.
        source: File the scene comes from.
    """

    def __init__(self, key: str, cure: str, value: object = NO_VALUE, source: str = "") -> None:
        self.key, self.cure, self.value, self.source = key, cure, value, source
        super().__init__(key, cure)

    def __str__(self) -> str:
        head = self.key if self.value is NO_VALUE else f"{self.key} = {toml_text(self.value)}"
        parts = [part for part in (self.source, head, self.cure) if part]
        return " ".join(": ".join(parts).split())

    def renamed(self, key: str) -> SceneError:
        """The same error under another key."""
        return type(self)(key, self.cure, self.value, self.source)

    def within(self, source: str) -> SceneError:
        """The same error naming the file, unless it names one already."""
        return type(self)(self.key, self.cure, self.value, self.source or source)


def nearest(name: str, known: Iterable[str]) -> str:
    """Cure for an unknown name: the nearest known one, else all of them."""
    names = sorted(known)
    close = get_close_matches(str(name), names, n=1, cutoff=0.5)
    return f"did you mean '{close[0]}'?" if close else f"known: {', '.join(names) or 'none'}."


def toml_text(value: object, depth: int = 4) -> str:
    """A value as it is written in TOML, shortened where it is long or nested deeper than a scene's tables are."""
    if isinstance(value, bool):
        text = "true" if value else "false"
    elif isinstance(value, (list, tuple)):
        entries = [toml_text(entry, depth - 1) for entry in value] if depth else ["..."]
        text = f"[{', '.join(entries)}]"
    elif isinstance(value, dict):
        pairs = [f"{key} = {toml_text(each, depth - 1)}" for key, each in value.items() if depth]
        text = f"{{ {', '.join(pairs) or '...'} }}" if value else "{}"
    elif isinstance(value, str):
        text = f'"{value}"'
    elif isinstance(value, int) and value.bit_length() > LONG:
        text = f"a whole number of {value.bit_length()} bits"
    else:
        text = f"{value!r}"
    return text if len(text) <= 60 else text[:57] + "..."
