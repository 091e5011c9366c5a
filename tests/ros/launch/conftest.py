"""A package whose launch files the tests write."""

from pathlib import Path

import pytest


@pytest.fixture
def package(tmp_path: Path) -> Path:
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "urdf").mkdir()
    (tmp_path / "urdf" / "arm.xacro").write_text("<robot name='r'/>")
    (tmp_path / "launch").mkdir()
    return tmp_path
