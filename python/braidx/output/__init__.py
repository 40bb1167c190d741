"""Results of a run: numbers, tables, files for ParaView and pictures. NumPy only, no DOLFINx."""

from braidx.output.snapshot import ContactTable, Snapshot

__all__ = ["ContactTable", "Snapshot"]
