"""What this Python lacks to run braidx: one line on standard output, empty when nothing is missing.

Run by the launcher with Pythons it knows nothing about, so: no import of braidx, old syntax, and
packages are looked up rather than imported (an import of DOLFINx would cost every start a second).
"""

import sys

MODULES = ("petsc4py", "mpi4py", "numpy", "scipy", "matplotlib", "nanobind", "typer", "rich")


def lacks():
    """Names of what is missing, a list of str; versions are those of pyproject.toml."""
    if sys.version_info < (3, 11):
        return ["Python>=3.11"]
    from importlib.metadata import PackageNotFoundError, version
    from importlib.util import find_spec

    missing = [name for name in MODULES if find_spec(name) is None]
    try:
        release = version("fenics-dolfinx").split(".")[:2]
        too_old = tuple(int(part) for part in release) < (0, 9)
    except (PackageNotFoundError, ValueError):
        too_old = True
    if too_old or find_spec("dolfinx") is None:
        missing.insert(0, "DOLFINx>=0.9")
    return missing


if __name__ == "__main__":
    print(" ".join(lacks()))
