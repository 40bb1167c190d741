"""The command `braidx`."""

from braidx.cli.commands import app, main

__all__ = ["app", "main"]
