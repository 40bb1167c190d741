"""How many threads the contact engine uses."""

import pytest
from mpi4py import MPI

from braidx.processes import threads
from braidx.scene import SceneError


class Node:
    """A machine on which so many processes run."""

    def __init__(self, processes):
        self.size = processes

    def Split_type(self, kind):
        assert kind == MPI.COMM_TYPE_SHARED
        return self

    def Free(self):
        pass


@pytest.mark.parametrize("cores, processes, expected", [(8, 1, 8), (8, 3, 2), (2, 2, 1), (1, 4, 1)])
def test_processes_share_the_cores(monkeypatch, cores, processes, expected):
    monkeypatch.delenv(threads.VARIABLE, raising=False)
    monkeypatch.setattr(threads, "available_cores", lambda: cores)
    assert threads.num_threads(Node(processes)) == expected


def test_there_is_a_core():
    assert threads.available_cores() >= 1


def test_the_variable_wins(monkeypatch):
    monkeypatch.setenv(threads.VARIABLE, "5")
    assert threads.num_threads(Node(9)) == 5


@pytest.mark.parametrize("given", ["0", "-2", "two", "1.5"])
def test_nonsense_is_refused(monkeypatch, given):
    monkeypatch.setenv(threads.VARIABLE, given)
    with pytest.raises(SceneError, match=f"BRAIDX_THREADS.*{given}.*whole number"):
        threads.num_threads(Node(1))
