"""The commands. Exit codes: 0 done, 2 bad input, 3 not converged."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from braidx.cli.accuracy import tell_accuracy, with_accuracy
from braidx.cli.errors import (
    BAD_INPUT,
    NOT_CONVERGED,
    bad_input_stops,
    rank,
    require_solver,
    stop,
)
from braidx.cli.folder import RESULTS, agreed, choose_folder, create_folder
from braidx.cli.report import cost_table, results_table, scene_table
from braidx.cli.show import show_run, show_scene
from braidx.geometry import build_rope
from braidx.scene import Scene, SceneError, load_scene
from braidx.scene.reference import json_schema, markdown

FILE_WIDTH = 120  # columns of what is printed into files and pipes

app = typer.Typer(
    name="braidx",
    help="Mechanics of braided and twisted ropes at the scale of their yarns.",
    add_completion=False,
    no_args_is_help=True,
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


@app.command()
def run(
    scene: ScenePath,
    out: Out = None,
    overrides: Overrides = None,
    resume: Resume = False,
    accuracy: Accuracy = None,
) -> None:
    """Compute a scene."""
    with bad_input_stops(scene):
        loaded = load_scene(scene, with_accuracy(overrides, accuracy))
        tell_accuracy(loaded, _console())
        _run(loaded, out, resume)


@app.command()
def demo(out: Out = None, overrides: Overrides = None, resume: Resume = False) -> None:
    """Form and pull the rope of paper 1 (demos/tensile_test.toml)."""
    checkout = os.environ.get("BRAIDX_CHECKOUT") or Path(__file__).resolve().parents[3]
    run(Path(checkout) / "demos" / "tensile_test.toml", out, overrides, resume)


@app.command()
def check(scene: ScenePath, overrides: Overrides = None, accuracy: Accuracy = None) -> None:
    """Validate a scene and print what would be computed."""
    with bad_input_stops(scene):
        loaded = load_scene(scene, with_accuracy(overrides, accuracy))
        tell_accuracy(loaded, _console())
        _console().print(scene_table(loaded, build_rope(loaded)))


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
            show_run(path, _console())
        elif rank() == 0:
            scene = load_scene(path, overrides or [])
            picture = out or RESULTS / f"{scene.name}-start.png"
            show_scene(scene, picture, _console())


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
    app()


def _run(scene: Scene, out: Path | None, resume: bool) -> None:
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

    try:
        summary = processes.run(scene, folder, resume=resume)
    except processes.NotConverged as error:
        raise stop(f"{error} (state so far: {folder})", NOT_CONVERGED) from None
    console = _console()
    console.print(results_table(summary))
    console.print(cost_table(summary))
    console.print(f"results: {folder}")


def _console() -> Console:
    console = Console(quiet=rank() != 0)
    if not console.is_terminal:
        console.width = FILE_WIDTH
    return console
