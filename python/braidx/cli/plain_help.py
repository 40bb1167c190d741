"""Help as plain text."""

from __future__ import annotations

from collections.abc import Sequence

import click


class PlainHelp(click.HelpFormatter):
    """Writes brackets as they are: Typer escapes them for rich's markup even where that is switched off."""

    def write_dl(
        self, rows: Sequence[tuple[str, str]], col_max: int = 30, col_spacing: int = 2
    ) -> None:
        """Write a list of terms, each with its text."""
        plain = [(term, text.replace("\\[", "[")) for term, text in rows]
        super().write_dl(plain, col_max, col_spacing)


def use_plain_help() -> None:
    """All commands of this process write their help so."""
    click.Context.formatter_class = PlainHelp
