"""A few kills at random instants; ``benchmarks/kills.py`` does as many as one likes."""

import os

import pytest

from benchmarks import kills


@pytest.mark.skipif(not hasattr(os, "killpg"), reason="needs process groups")
@pytest.mark.parametrize("name", ["fix", "cache", "scan"])
def test_a_kill_tears_and_loses_nothing(name: str) -> None:
    _, faults = kills.run(2, 1, {name: kills.CASES[name]})
    assert faults == []
