"""What --help prints."""

import pytest


@pytest.mark.parametrize("command", ["run", "check", "show"])
def test_help_has_no_escapes_of_a_markup_that_is_off(braidx, command):
    done = braidx(command, "--help")
    assert done.code == 0
    assert "[required]" in done.stdout
    assert "\\" not in done.stdout and "\x1b" not in done.stdout
