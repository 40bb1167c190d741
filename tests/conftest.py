"""What holds for all tests."""

from __future__ import annotations

from hypothesis import settings

# Tests are never timed: a loaded machine is no defect of what they test.
settings.register_profile("untimed", deadline=None)
settings.load_profile("untimed")
