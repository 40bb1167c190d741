"""A pitch too short for its yarns ends with a message that says so."""


def test_yarns_that_hook_into_each_other_are_told(run, tmp_path):
    failed = run(tmp_path / "out", "--set", "rope.pitch=16")
    assert failed.code == 3
    assert "forming stopped" in failed.stderr and "times its radius, hooked" in failed.stderr
    assert "deepest contacts between yarns none" not in failed.stderr
    assert "try a longer rope.pitch" in failed.stderr
