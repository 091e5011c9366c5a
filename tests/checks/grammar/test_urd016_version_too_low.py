from __future__ import annotations

import pytest

from tests.reported import messages, places, reported

CAPSULE = '<geometry><capsule radius="1" length="1"/></geometry>'
TURNED = '<origin quat_xyzw="0 0 0 1"/><geometry><sphere radius="1"/></geometry>'
ROBOT = '<robot name="r"{}>\n<link name="a"><visual>{}</visual></link></robot>'


@pytest.mark.parametrize("version", ["", ' version="1.0"'])
def test_features_of_1_1_in_1_0(version: str) -> None:
    assert messages("URD016", ROBOT.format(version, CAPSULE)) == [
        "link 'a': <capsule> came with URDF 1.1, and the robot is URDF 1.0"
    ]
    assert messages("URD016", ROBOT.format(version, TURNED)) == [
        "link 'a': quat_xyzw came with URDF 1.1, and the robot is URDF 1.0"
    ]
    assert places("URD016", ROBOT.format(version, TURNED)) == [(2, "0 0 0 1")]


@pytest.mark.parametrize("version", ["1.1", "1.2"])
@pytest.mark.parametrize("content", [CAPSULE, TURNED])
def test_with_the_version_they_are_read(version: str, content: str) -> None:
    robot = ROBOT.format(f' version="{version}"', content)
    assert [reported(code, robot) for code in ("URD016", "URD005", "URD006", "URD009")] == [[]] * 4


def test_a_quaternion_that_is_read_has_four_numbers() -> None:
    robot = ROBOT.format(' version="1.1"', TURNED.replace("0 0 0 1", "0 0 1"))
    assert messages("URD006", robot) == [
        "link 'a': quat_xyzw of <origin> has 3 numbers, not 4 (x y z w)"
    ]
