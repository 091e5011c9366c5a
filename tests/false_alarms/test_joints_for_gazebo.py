"""JNT003, JNT026: joints that are as they are for Gazebo, or for a plugin of the robot."""

import pytest

from tests.gazebos import block, plugin
from tests.jointed import joint, limit, mimic, robot
from tests.reported import reported

LOCKED = robot(joint("wrist", "revolute", limit("0", "0")))
ROCKERS = robot(
    joint("left", "revolute", limit("-1", "1")),
    joint("right", "revolute", limit("-1", "1") + mimic("left")),
)
JOINTS = "<jointA>{}</jointA><jointB>{}</jointB>"


@pytest.mark.parametrize(
    ("tags", "severity"),
    [
        ("<provideFeedback>true</provideFeedback>", "info"),
        ('<sensor name="ft" type="force_torque"/>', "info"),
        ("<provideFeedback>false</provideFeedback>", "warning"),
        ("<implicitSpringDamper>true</implicitSpringDamper>", "warning"),
    ],
)
def test_a_joint_that_cannot_move_is_where_gazebo_measures_its_force(
    tags: str, severity: str
) -> None:
    """The wrist of a service robot: Gazebo Classic would merge a fixed joint."""
    (found,) = reported("JNT003", LOCKED + block(tags, "wrist"))
    assert found.severity.value == severity


@pytest.mark.parametrize(
    ("library", "named", "count"),
    [
        ("librover_differential_plugin.so", ("left", "right"), 0),
        ("librover_differential_plugin.so", ("right", "other"), 1),
        ("libgazebo_ros_joint_state_publisher.so", ("left", "right"), 1),
    ],
)
def test_a_plugin_of_the_robot_couples_the_rockers(
    library: str, named: tuple[str, str], count: int
) -> None:
    """A rover: the differential between its rockers is a plugin of its own."""
    robot = ROCKERS + plugin("libgazebo_ros_control.so") + plugin(library, JOINTS.format(*named))
    assert len(reported("JNT026", robot)) == count
