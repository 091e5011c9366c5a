"""Names that look wrong and do no harm."""

import pytest

from tests.gazebos import BASE, block, child, plugin, sensor
from tests.reported import reported
from tests.xacros import xacro
from urdfkit.text.diagnostic import Severity

KEPT = block("<preserveFixedJoint>true</preserveFixedJoint>", "hand")


def shared(kind: str, name: str = "hand") -> str:
    """A robot whose joint has the name of a link."""
    return BASE + child("hand", kind).replace("hand_joint", name)


@pytest.mark.parametrize(
    ("robot", "severity"),
    [  # libsdformat 12.3, which has no frames of merged links, calls the first two valid
        (shared("fixed"), Severity.INFO),
        (shared("fixed", "arm") + child("arm"), Severity.INFO),
        (shared("fixed") + KEPT, Severity.WARNING),
        (shared("continuous"), Severity.WARNING),
        (shared("fixed").replace('"base"', '"world"'), Severity.WARNING),
    ],
)
def test_a_fixed_joint_that_gazebo_merges_may_have_the_name_of_a_link(
    robot: str, severity: Severity
) -> None:
    (found,) = reported("NAM003", robot, targets=("classic-ros2",))
    assert found.severity is severity


def test_a_plugin_of_ros_1_puts_the_namespace_before_the_frame() -> None:
    """UUV simulator: `sonar_link` of the robot `rexrov` is the frame of `rexrov/sonar_link`."""
    robot = BASE.replace('"base"', '"rexrov/sonar_link"')
    laser = plugin("libgazebo_ros_gpu_laser.so", "<frameName>sonar_link</frameName>")
    assert reported("GAZ058", robot + laser) == []
    assert len(reported("GAZ058", robot + laser.replace("sonar_link", "sonar"))) == 1
    gz = sensor("imu", "<gz_frame_id>sonar_link</gz_frame_id>", "rexrov/sonar_link")
    assert len(reported("GAZ058", robot + gz)) == 1


@pytest.mark.parametrize(("name", "count"), [("none", 0), ("None", 0), ("nonne", 1)])
def test_a_material_called_none(name: str, count: int) -> None:
    """Techman's arms, whose meshes have colours of their own."""
    shape = '<visual><geometry><mesh filename="a.dae"/></geometry><material name="{}"/></visual>'
    robot = f'<link name="a">{shape.format(name)}</link>'
    assert len(reported("REF003", robot)) == count


@pytest.mark.parametrize(
    ("link", "severity"), [("left/hand", Severity.INFO), ("hand", Severity.WARNING)]
)
def test_a_namespace_of_link_and_joint(link: str, severity: Severity) -> None:
    """Trossen's and the UUV simulator's robots."""
    arm = child("hand").replace('"hand_joint"', '"left/joint_1"').replace('"hand"', f'"{link}"')
    (found,) = reported("NAM004", BASE + arm)
    assert found.severity is severity


@pytest.mark.parametrize(
    ("robot", "content"),
    [
        ("frame", ""),  # surface_robotics_mockups_description
        ("r", '<visual name="frame"><geometry><box size="1 1 1"/></geometry></visual>'),
        ("r", '<visual><material name="frame"><color rgba="1 1 1 1"/></material></visual>'),
    ],
)
def test_what_is_called_like_a_link_with_a_prefix(robot: str, content: str) -> None:
    name = f' name="{robot}"'
    text = f'<xacro:arg name="prefix" default=""/><link name="$(arg prefix)frame">{content}</link>'
    sensor = '<gazebo reference="$(arg prefix)frame"><sensor name="frame" type="imu"/></gazebo>'
    assert reported("XAC024", xacro(text + sensor, name).encode(), "r.xacro") == []
    block = '<ros2_control name="c" type="system"><joint name="frame"/></ros2_control>'
    assert len(reported("XAC024", xacro(text + block, name).encode(), "r.xacro")) == 1
