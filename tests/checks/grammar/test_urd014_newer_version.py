from __future__ import annotations

import pytest

from tests.reported import messages, places


@pytest.mark.parametrize("version", ["1.1", "1.2"])
def test_versions_that_older_readers_refuse(version: str) -> None:
    robot = f'<robot name="r" version="{version}"><link name="a"/></robot>'
    assert messages("URD014", robot) == [f"version {version} of URDF is refused by older readers"]
    assert places("URD014", robot) == [(1, version)]


@pytest.mark.parametrize("version", ["", ' version="1.0"', ' version="3.7"'])
def test_the_first_version_and_unknown_ones(version: str) -> None:
    assert messages("URD014", f'<robot name="r"{version}><link name="a"/></robot>') == []
