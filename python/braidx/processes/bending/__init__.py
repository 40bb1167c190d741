"""A rope bent over a sheave (paper 2): yarns of any model about a core, clamped together at both ends."""
