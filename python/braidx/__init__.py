"""braidx: mechanics of braided and twisted ropes at the scale of their yarns."""

__version__ = "0.1.0"
