"""Puts this folder on the path, so that the cases find its modules, and has them state their results."""

from pathlib import Path

import pytest
from record import FAMILIES, Recorder, Records

FOLDER = Path(__file__).parent
DOCS = FOLDER.parents[1] / "docs"
RECORDS = pytest.StashKey[Records]()
CHOSEN = pytest.StashKey[bool]()  # whether a part of the tests only was to run


def pytest_addoption(parser):
    parser.addoption("--papers", action="store_true", help="ropes of the papers, too: minutes")


def pytest_configure(config):
    config.stash[RECORDS], config.stash[CHOSEN] = Records(), False


def pytest_deselected(items):
    if items:
        items[0].config.stash[CHOSEN] = True


@pytest.fixture
def record(request):
    """Takes down what a case expects and computes, see Recorder."""
    return Recorder(request.config.stash[RECORDS], FAMILIES[request.path.parent.name])


def pytest_sessionfinish(session, exitstatus):
    """A page of all cases, or none: a part of them must not take the place of the whole."""
    config = session.config
    if hasattr(config, "workerinput") or config.getoption("numprocesses", None):
        return  # processes that share the tests each know their part of the results only
    asked = {Path(config.invocation_params.dir, argument).resolve() for argument in config.args}
    whole = FOLDER in asked and exitstatus == pytest.ExitCode.OK and not config.stash[CHOSEN]
    skipped = config.pluginmanager.getplugin("terminalreporter").stats.get("skipped")
    if whole and not skipped and not config.option.collectonly:
        from record_page import write  # draws, which takes a while to import

        write(config.stash[RECORDS], DOCS)
