from __future__ import annotations

import pytest

from tests.reported import messages, places, reported

ROBOT = '<robot name="r" version="{}"><link name="a"><visual>{}</visual></link></robot>'
SPHERE = '<origin xyz="0 0 0"/><geometry><sphere radius="1"/></geometry>'


@pytest.mark.parametrize("version", ["1", "2.0", "1.3", "foo", "", "1.0.0", "-1.0"])
def test_versions_that_urdfdom_refuses(version: str) -> None:
    robot = ROBOT.format(version, SPHERE)
    assert messages("URD011", robot) == [
        f"version '{version}' of URDF does not exist; 1.0, 1.1, 1.2 do"
    ]
    assert places("URD011", robot) == [(1, version)]
    assert reported("URD016", robot) == [], "an unknown version is one finding"


@pytest.mark.parametrize("version", ["1.0", "01.00", "1.1", "1.2"])
def test_versions_that_exist(version: str) -> None:
    assert reported("URD011", ROBOT.format(version, SPHERE)) == []
