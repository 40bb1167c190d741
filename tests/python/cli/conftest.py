"""Calling the command line within the test's process."""

from dataclasses import dataclass

import pytest

from braidx.cli import app


@dataclass(frozen=True)
class Done:
    """What a command left behind."""

    code: int
    stdout: str
    stderr: str


@pytest.fixture
def braidx(capsys):
    """Call braidx with these words; gives exit code and output."""

    def call(*words: str) -> Done:
        with pytest.raises(SystemExit) as caught:
            app(list(words), prog_name="braidx")
        printed = capsys.readouterr()
        return Done(int(caught.value.code or 0), printed.out, printed.err)

    return call
