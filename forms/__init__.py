"""Energies of the bodies in the Unified Form Language; only `ufl` is imported here."""
