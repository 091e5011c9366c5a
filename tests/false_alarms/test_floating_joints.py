"""Transforms of links below a floating joint, which robot_state_publisher does not publish."""

from pathlib import Path

import pytest

from tests.gazebos import BASE, child, plugin
from tests.launched import reported
from tests.reported import messages

ROBOT = """<robot name="r"><link name="base"/><link name="body"/>
<joint name="j" type="{}"><parent link="base"/><child link="body"/></joint></robot>"""
PROGRAMS = """\
Node(package='robot_state_publisher', executable='robot_state_publisher')
Node(package='tf2_ros', executable='static_transform_publisher',
     arguments=['0', '0', '1', '0', '0', '0', 'base', 'body'])
"""


@pytest.mark.parametrize(("kind", "count"), [("floating", 0), ("revolute", 1)])
def test_a_static_transform(tmp_path: Path, kind: str, count: int) -> None:
    """A hexapod whose body floats above `base`, where a program may place it."""
    text = f"open('{tmp_path}/r.urdf')\n{PROGRAMS}"
    files = {"r.urdf": ROBOT.format(kind)}
    assert len(reported(tmp_path, "LAU021", "a.launch.py", text, files)) == count


@pytest.mark.parametrize(("kind", "count"), [("floating", 0), ("fixed", 1)])
def test_the_odometry_of_a_drive(kind: str, count: int) -> None:
    frame = "<robotBaseFrame>body</robotBaseFrame>"
    robot = BASE + child("body", kind) + plugin("libgazebo_ros_planar_move.so", frame)
    assert len(messages("RCT029", robot)) == count
