"""The commands. Exit codes: 0 done, 1 a result missed with --strict, 2 bad input, 3 not converged, 130 interrupted."""

from __future__ import annotations

import json
import os
import signal
from pathlib import Path
from typing import Annotated

import typer

from braidx import __version__
from braidx.cli.accuracy import tell_accuracy, with_accuracy
from braidx.output.console import make_console, rank
from braidx.cli.errors import (
    BAD_INPUT,
    INTERRUPTED,
    MISSED,
    NOT_CONVERGED,
    bad_input_stops,
    missed,
    require_solver,
    stop,
)
from braidx.cli.folder import RESULTS, agreed, choose_folder, create_folder
from braidx.cli.report import cost_table, results_table, scene_table
from braidx.cli.show import show_run, show_scene
from braidx.geometry import build_rope
from braidx.scene import Scene, SceneError, load_scene
from braidx.scene.reference import json_schema, markdown

app = typer.Typer(
    name="braidx",
    help="Mechanics of braided and twisted ropes at the scale of their yarns.",
    add_completion=False,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="In a checkout, ./braidx --ranks N COMMAND computes on N MPI processes; elsewhere mpirun -n N braidx.",
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

ScenePath = Annotated[Path, typer.Argument(metavar="SCENE.toml", help="The scene.")]
Overrides = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="TABLE.KEY=VALUE", help="Replace a value of the scene."),
]
Accuracy = Annotated[
    str | None,
    typer.Option(
        "--accuracy",
        metavar="PERCENT",
        help="Choose what the scene leaves open for an error of 5%, 1% or 0.1% (docs/accuracy.md).",
    ),
]
Out = Annotated[
    Path | None, typer.Option("--out", metavar="DIR", help="Output folder [results/NAME].")
]
Resume = Annotated[bool, typer.Option("--resume", help="Go on from the last checkpoint.")]
Strict = Annotated[
    bool, typer.Option("--strict", help="Exit code 1 if a result is not as the scene expects.")
]


def _refuse_ranks(count: int) -> int:
    """The launcher takes the option for itself, so that it arrives here only without it."""
    if count != 1:
        raise stop(
            f"--ranks is an option of ./braidx; without it: mpirun -n {count} braidx", BAD_INPUT
        )
    return count


Ranks = Annotated[
    int,
    typer.Option(
        "--ranks",
        metavar="N",
        help="MPI processes (with ./braidx).",
        callback=_refuse_ranks,
        show_default=False,
    ),
]


def _tell_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"braidx {__version__}")
        raise typer.Exit


@app.callback()
def options(
    version: Annotated[
        bool,
        typer.Option("--version", help="Print the version.", callback=_tell_version, is_eager=True),
    ] = False,
) -> None:
    """Mechanics of braided and twisted ropes at the scale of their yarns."""


@app.command()
def run(
    scene: ScenePath,
    out: Out = None,
    overrides: Overrides = None,
    resume: Resume = False,
    accuracy: Accuracy = None,
    strict: Strict = False,
    ranks: Ranks = 1,
) -> None:
    """Compute a scene."""
    with bad_input_stops(scene):
        loaded = load_scene(scene, with_accuracy(overrides, accuracy))
        tell_accuracy(loaded, make_console())
        _run(loaded, out, resume, strict)


@app.command()
def demo(
    out: Out = None,
    overrides: Overrides = None,
    resume: Resume = False,
    accuracy: Accuracy = None,
    strict: Strict = False,
    ranks: Ranks = 1,
) -> None:
    """Form and pull the rope of paper 1 (demos/tensile_test.toml)."""
    checkout = os.environ.get("BRAIDX_CHECKOUT") or Path(__file__).resolve().parents[3]
    scene = Path(checkout) / "demos" / "tensile_test.toml"
    run(scene, out, overrides, resume, accuracy, strict)


@app.command()
def check(scene: ScenePath, overrides: Overrides = None, accuracy: Accuracy = None) -> None:
    """Validate a scene and print what would be computed."""
    with bad_input_stops(scene):
        loaded = load_scene(scene, with_accuracy(overrides, accuracy))
        tell_accuracy(loaded, make_console())
        make_console().print(scene_table(loaded, build_rope(loaded)))


@app.command()
def show(
    path: Annotated[Path, typer.Argument(metavar="SCENE.toml|DIR", help="A scene or a run.")],
    out: Annotated[
        Path | None, typer.Option("--out", metavar="PNG", help="Picture of a scene's start.")
    ] = None,
    overrides: Overrides = None,
) -> None:
    """Draw a scene's start configuration, or print the results of a run."""
    with bad_input_stops(path):
        if path.is_dir():
            show_run(path, make_console())
        elif rank() == 0:
            scene = load_scene(path, overrides or [])
            picture = out or RESULTS / f"{scene.name}-start.png"
            show_scene(scene, picture, make_console())


@app.command()
def schema(
    as_markdown: Annotated[
        bool, typer.Option("--markdown", help="The scene reference instead.")
    ] = False,
) -> None:
    """Print the JSON schema of a scene."""
    if rank() == 0:
        typer.echo(markdown() if as_markdown else json.dumps(json_schema(), indent=2), nl=False)


@app.command(context_settings={"allow_extra_args": True, "ignore_unknown_options": True})
def test() -> None:
    """Run the tests (./braidx test [PYTEST ARGUMENTS])."""
    raise stop("the tests are started by the launcher of a checkout: ./braidx test", BAD_INPUT)


@app.command(context_settings={"allow_extra_args": True, "ignore_unknown_options": True})
def shell() -> None:
    """Open a shell in the environment (./braidx shell)."""
    raise stop("the shell is opened by the launcher of a checkout: ./braidx shell", BAD_INPUT)


def main() -> None:
    """Entry point of the command `braidx`."""
    app(prog_name="braidx")


def _run(scene: Scene, out: Path | None, resume: bool, strict: bool) -> None:
    """Check everything that is cheap to check, then compute."""
    build_rope(scene)
    if not scene.steps:
        raise SceneError("steps", "nothing to compute; add a table [[steps]] with a kind.")
    if rank() == 0:
        choose_folder(scene, out, resume)
    require_solver()

    def prepare() -> Path:
        folder = choose_folder(scene, out, resume)
        create_folder(folder, scene)
        return folder

    folder = agreed(prepare)
    from braidx import processes

    # mpirun and batch systems interrupt with SIGTERM, for which PETSc has a handler of its own.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        summary = processes.run(scene, folder, resume=resume)
    except MemoryError as error:
        raise stop(f"no memory left: {error} (state so far: {folder})", NOT_CONVERGED) from None
    except KeyboardInterrupt:
        again = "the same command with --resume goes on from the last increment"
        raise stop(f"interrupted: {again} (state so far: {folder})", INTERRUPTED) from None
    except processes.NotConverged as error:
        raise stop(f"{error} (state so far: {folder})", NOT_CONVERGED) from None
    console = make_console()
    console.print(results_table(summary))
    console.print(cost_table(summary))
    console.print(f"results: {folder}")
    names = missed(summary["results"])
    if strict and names:
        raise stop(f"not as expected: {names} (--strict)", MISSED)
