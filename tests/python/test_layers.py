"""The layers of the program: who may import what, and how long a file may get."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "python" / "braidx"
SOURCES = {".py", ".cpp", ".h", ".toml", ".sh"}
FOLDERS = ("contact_engine", "forms", "python", "demos", "tests", "docs")


def python_files(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.py"))


def imported(path: Path) -> set[str]:
    """Top-level names of the packages that a file imports; relative imports give "."."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add("." if node.level else str(node.module).split(".")[0])
    return names


def identifier(path: Path) -> str:
    return str(path.relative_to(ROOT))


def module_of(path: Path) -> str:
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts).removesuffix(".__init__")


MODULES = {module_of(path): path for path in python_files(PACKAGE)}


def imports(path: Path) -> set[str]:
    """Full names of the modules that a file imports, but not of those that only its type hints name."""
    tree = ast.parse(path.read_text())
    hints = {
        id(inner)
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)
        for inner in ast.walk(node)
    }
    names = set()
    for node in ast.walk(tree):
        if id(node) in hints:
            continue
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            package = path.relative_to(PACKAGE.parent).parts[: -node.level] if node.level else ()
            base = ".".join([*package, *([node.module] if node.module else [])])
            full = {f"{base}.{alias.name}" for alias in node.names}
            names |= {name if name in MODULES else base for name in full}
    return names


def rows() -> dict[str, set[str]]:
    """Of the table of layers in docs/architecture.md: what each layer below python/braidx may import."""
    text = (ROOT / "docs" / "architecture.md").read_text()
    found = {}
    for line in text.splitlines():
        row = re.match(r"\| `python/braidx/(\S+)/` \|(.*?)\|", line)
        if row:
            found[row[1]] = {name.rstrip("/") for name in re.findall(r"`(.+?)`", row[2])}
    found["processes/bending"] |= found["processes"]
    return found


def layer_of(module: str) -> str:
    """Layer of a module of braidx, or the package that another one belongs to."""
    first, *rest = module.split(".")
    if first != "braidx" or not rest:
        return first
    return "processes/bending" if rest[:2] == ["processes", "bending"] else rest[0]


@pytest.mark.parametrize("layer", rows())
def test_a_layer_imports_what_the_table_allows(layer):
    allowed = rows()[layer] | {layer, "compat", "braidx"} | set(sys.stdlib_module_names)
    own = [path for name, path in MODULES.items() if layer_of(name) == layer]
    assert own
    forbidden = {
        identifier(path): names
        for path in own
        if (names := {name for name in imports(path) if layer_of(name) not in allowed})
    }
    assert forbidden == {}


def test_every_folder_has_a_row():
    own = (path for path in PACKAGE.iterdir() if not path.is_symlink())
    folders = {path.name for path in own if any(path.glob("*.py"))}
    assert folders == {layer for layer in rows() if "/" not in layer}


def test_no_module_imports_itself_in_a_circle():
    graph = {name: imports(path) & MODULES.keys() - {name} for name, path in MODULES.items()}
    while ends := {name for name, needs in graph.items() if not needs & graph.keys()}:
        graph = {name: needs for name, needs in graph.items() if name not in ends}
    assert graph == {}


@pytest.mark.parametrize("path", python_files(ROOT / "forms"), ids=identifier)
def test_forms_import_ufl_only(path):
    assert imported(path) <= {"ufl", "typing", "."}


@pytest.mark.parametrize("package", ["scene", "geometry"])
def test_scene_and_geometry_run_without_dolfinx(package):
    """In a Python where these packages cannot be imported at all."""
    forbidden = ["dolfinx", "petsc4py", "mpi4py", "ufl", "basix", "braidx_engine"]
    modules = [
        ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts)
        for path in python_files(PACKAGE / package)
    ]
    code = (
        "import sys, importlib\n"
        f"sys.modules.update(dict.fromkeys({forbidden}))\n"
        f"for name in {modules}: importlib.import_module(name.removesuffix('.__init__'))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=PACKAGE.parent, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    "path", [p for p in python_files(PACKAGE) if p.name != "compat.py"], ids=identifier
)
def test_only_compat_knows_releases_of_dolfinx(path):
    if "dolfinx" in imported(path):
        text = path.read_text()
        assert "hasattr(" not in text and "__version__" not in text
        assert "except (ImportError" not in text and "except ImportError" not in text


@pytest.mark.parametrize(
    "path",
    sorted(
        p
        for p in (ROOT / "contact_engine").rglob("*")
        if p.suffix in {".h", ".cpp"} and "bindings" not in (p.stem, p.parent.name)
    ),
    ids=identifier,
)
def test_engine_needs_the_standard_library_and_eigen_only(path):
    for system, own in re.findall(r'^\s*#include\s+(?:<(.+?)>|"(.+?)")', path.read_text(), re.M):
        if own:
            folders = (path.parent, ROOT / "contact_engine")
            assert any((folder / own).is_file() for folder in folders), own
        else:
            assert system.startswith("Eigen/") or re.fullmatch(r"[a-z_]+", system), system


def test_no_file_is_longer_than_300_lines():
    files = (p for folder in FOLDERS for p in (ROOT / folder).rglob("*") if p.suffix in SOURCES)
    lengths = {identifier(p): len(p.read_text().splitlines()) for p in files if p.is_file()}
    assert {name: length for name, length in lengths.items() if length > 300} == {}
