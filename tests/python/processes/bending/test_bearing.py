"""A sheave that turns as the rope takes it along."""

from pathlib import Path

SCENE = Path(__file__).parent / "small_bend.toml"


def test_a_rope_over_a_free_sheave(run, tmp_path):
    """Both ends move alike: the sheave turns a little, as the helices of the two directions are not mirror images."""
    words = ["sheave.motion=free", "steps.bend.travel=2"]
    free = run(tmp_path / "free", *(part for w in words for part in ("--set", w)), scene=SCENE)
    assert free.code == 0, free.stderr
    assert 0.0 < abs(free.values["sheave_angle"]) < 5.0
    assert free.values["relative_displacement"] > 0.05
