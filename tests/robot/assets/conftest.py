from pathlib import Path

import pytest

from tests.workspaces import add_package


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package; so deep that the neighbours of one test are not those of another."""
    return add_package(tmp_path / "a" / "b" / "c" / "d" / "arm_description", "arm")
