"""Puts this folder on the path, so that the cases find `support`."""
