import pytest

from tests.naming import naming
from tests.reported import messages, places, reported
from tests.xacros import NAMESPACE


def test_the_robot_is_the_place() -> None:
    robot = '<!-- empty -->\n<robot name="r">\n<joint name="j" type="fixed"/></robot>'
    assert messages("TRE001", robot) == [naming("robot")]
    assert places("TRE001", robot) == [(2, '<robot name="r">')]


@pytest.mark.parametrize(
    ("robot", "path"),
    [
        (f'<robot {NAMESPACE}><xacro:macro name="m" params=""/></robot>', "macros.xacro"),
        ('<sdf version="1.6"/>', "model.sdf"),  # URD015
        ('<robot name="r"><link/></robot>', "robot.urdf"),  # URD003
    ],
)
def test_a_library_and_what_other_rules_tell(robot: str, path: str) -> None:
    assert reported("TRE001", robot, path) == []


def test_the_settings_of_the_webots_driver_are_no_robot() -> None:
    webots = '<webots><plugin type="webots_ros2_control::Ros2Control"/></webots>'
    assert reported("TRE001", webots) == reported("URD001", webots) == []
