"""Puts this folder on the path, so that the tests below it find `rope_example` too."""
