"""The command `braidx`."""

from braidx.cli.commands import app, main
from braidx.cli.plain_help import use_plain_help

use_plain_help()

__all__ = ["app", "main"]
