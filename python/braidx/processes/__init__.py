"""Processes: what is done to a rope. Forming, settling, pulling, holding and cycling it."""

from .outcome import NotConverged
from .run import run

__all__ = ["NotConverged", "run"]
