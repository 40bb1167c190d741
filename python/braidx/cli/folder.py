"""The output folder of a run: a new one, or one to go on in; never another run's."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from braidx.scene import Scene, SceneError, difference, load_scene, to_toml

SCENE_COPY = "scene.toml"
RESULTS = Path("results")


def choose_folder(scene: Scene, out: Path | None, resume: bool) -> Path:
    """The folder a run will write to; nothing is created or changed.

    Without `out` it is results/NAME, numbered where that exists; a run that is resumed goes on in
    the newest of them.

    Raises:
        SceneError: If the folder holds something else, cannot be written, or cannot be resumed.
    """
    if resume:
        folder = out or _numbered(scene.name)[0]
        if folder is None or not (folder / SCENE_COPY).is_file():
            found = folder or RESULTS / scene.name
            raise SceneError("--resume", f"no run in {found}; leave --resume out to start one.")
        changed = difference(scene, load_scene(folder / SCENE_COPY))
        if changed:
            raise SceneError(
                "--resume",
                f"{folder} holds another scene ({changed}); resume with its own scene, "
                f"{folder / SCENE_COPY}, or leave --resume out and choose another --out.",
            )
    else:
        folder = out or _numbered(scene.name)[1]
        if folder.is_dir() and any(folder.iterdir()):
            kind = "holds a run" if (folder / SCENE_COPY).exists() else "is not empty"
            cure = "add --resume to go on with it, or " if kind == "holds a run" else ""
            raise SceneError("--out", f"{folder} {kind}; {cure}choose a new folder.")
    _check_writable(folder)
    return folder


def create_folder(folder: Path, scene: Scene) -> None:
    """Create the folder with a copy of the scene, as it is computed, unless it has one."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        copy = folder / SCENE_COPY
        if not copy.exists():
            part = copy.with_name(copy.name + ".part")
            header = (
                "# The scene as it was computed: every default and every --set written out.\n\n"
            )
            part.write_text(header + to_toml(scene), "utf-8")
            os.replace(part, copy)
    except OSError as error:
        raise _unwritable(folder, error.strerror or str(error)) from None


def agreed(prepare: Callable[[], Path]) -> Path:
    """What `prepare` gives on the first MPI process, or its error, on every one of them."""
    from mpi4py import MPI

    result: Path | SceneError | None = None
    if MPI.COMM_WORLD.rank == 0:
        try:
            result = prepare()
        except SceneError as error:
            result = error
    result = MPI.COMM_WORLD.bcast(result)
    if isinstance(result, SceneError):
        raise result
    assert result is not None
    return result


def _numbered(name: str) -> tuple[Path | None, Path]:
    """The newest folder of a scene, if any, and the next free one."""
    newest, free, number = None, RESULTS / name, 1
    while free.exists():
        newest, number = free, number + 1
        free = RESULTS / f"{name}-{number}"
    return newest, free


def _check_writable(folder: Path) -> None:
    existing = folder
    while not existing.exists() and existing != existing.parent:
        existing = existing.parent
    if not existing.is_dir():
        raise _unwritable(folder, f"{existing} is a file")
    if not os.access(existing, os.W_OK | os.X_OK):
        raise _unwritable(folder, f"no permission to write in {existing}")


def _unwritable(folder: Path, reason: str) -> SceneError:
    return SceneError("--out", f"cannot write to {folder} ({reason}); choose another folder.")
