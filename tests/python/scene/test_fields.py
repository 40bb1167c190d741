"""Types, ranges and choices of single values."""

import pytest

from braidx.scene import (
    ContactOptions,
    Pull,
    RopeRecipe,
    SceneError,
    SolverOptions,
    StrandRecipe,
    YarnModel,
)


def message(make, **values):
    with pytest.raises(SceneError) as caught:
        make(**values)
    text = str(caught.value)
    assert "\n" not in text
    return text


@pytest.mark.parametrize("pitch", [0.0, -3.0, float("inf"), float("nan")])
def test_a_length_is_positive_and_finite(pitch):
    text = message(RopeRecipe, pitch=pitch)
    assert text.startswith(f"rope.pitch = {pitch!r}") and "above 0 mm" in text


@pytest.mark.parametrize("pitches", [1.5, True, "2", [2]])
def test_a_number_of_things_is_a_whole_number(pitches):
    assert "whole number" in message(RopeRecipe, pitch=1.0, pitches=pitches)


def test_a_choice_names_the_nearest_one():
    assert "'beam'" in message(YarnModel, radius=1.0, model="bean")


@pytest.mark.parametrize("yarn_pitch", ["pitch/0", "pitch/1.5", "pitch", "twisted", ""])
def test_a_text_has_its_pattern(yarn_pitch):
    assert '"pitch/4"' in message(StrandRecipe, yarn_pitch=yarn_pitch)


def test_whole_numbers_become_floats_and_lists_tuples():
    assert isinstance(RopeRecipe(pitch=3).pitch, float)
    assert StrandRecipe(rings=[1, 6]).rings == (1, 6)


@pytest.mark.parametrize("rings", [[], [0], [1, -6], [[1]], 7, [1.0]])
def test_entries_of_a_list_are_checked(rings):
    assert "strand.rings" in message(StrandRecipe, rings=rings)


def test_a_pull_ends_at_a_force_or_at_a_strain():
    assert "neither" in message(Pull)
    assert "both" in message(Pull, to_force=1.0, to_strain=0.1)


def test_a_material_is_stable():
    assert "Poisson" in message(YarnModel, radius=1.0, transverse_modulus=1e9)


def test_friction_may_be_zero():
    assert ContactOptions(friction=0).friction == 0.0


def test_petsc_options_are_single_values():
    assert SolverOptions(petsc={"pc_type": "lu", "mat_mumps_icntl_14": 80}).petsc["pc_type"] == "lu"
    assert "solver.petsc" in message(SolverOptions, petsc={"pc_type": [1]})
