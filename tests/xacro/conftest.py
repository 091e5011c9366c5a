"""What the tests of models that nobody vouches for share."""

from pathlib import Path

import pytest

from tests.xacro.strangers import SECRET


@pytest.fixture
def outside(tmp_path: Path) -> Path:
    """A file that does not belong to the workspace of the models."""
    file = tmp_path / "outside" / "secret.yaml"
    file.parent.mkdir()
    file.write_text(SECRET, encoding="utf-8")
    return file


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """The directory of a package in a workspace."""
    directory = tmp_path / "a" / "workspace" / "src" / "robot"
    directory.mkdir(parents=True)
    (directory / "package.xml").write_text(
        "<package><name>robot</name></package>", encoding="utf-8"
    )
    return directory
