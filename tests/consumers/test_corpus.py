"""Real robots: what a program rejects has an error about the cause, what it takes has none."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.consumers.comparison import PROGRAMS, has, robots, verdict


@pytest.mark.parametrize(("path", "arguments"), robots())
@pytest.mark.parametrize("name", PROGRAMS)
def test_a_real_robot(name: str, path: Path, arguments: dict[str, str]) -> None:
    if not has(name):
        pytest.skip(f"{name} is not installed")
    found = verdict(name, path, arguments)
    if found is None:
        pytest.skip("not a whole robot")
    if found.refusal:
        assert found.is_told, found
    else:
        assert found.errors == ()
