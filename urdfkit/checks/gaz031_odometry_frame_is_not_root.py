"""The frame that a plugin's odometry moves is not the root of the robot.

The plugin sends a transform from its odometry frame to that link, and robot_state_publisher sends
one from the link's parent: tf has one parent for a frame, and the robot jumps between the two. Name
the root link, or remove the link above it.

Sources:
    REP 105, frames of mobile robots: http://www.ros.org/reps/rep-0105.html
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Fix, Severity
from urdfkit.editing.edits import rewrite
from urdfkit.rules import Finding, Need, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.document import Attribute, Element
    from urdfkit.gazebo.plugins import Item, Use
    from urdfkit.subject import Subject

BAD = """\
<link name="base_footprint">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="base_link">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<joint name="base_joint" type="fixed">
  <parent link="base_footprint"/>
  <child link="base_link"/>
</joint>
<gazebo>
  <plugin name="drive" filename="libgazebo_ros_planar_move.so">
    <robotBaseFrame>base_link</robotBaseFrame>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("Frame>base_link<", "Frame>base_footprint<")
FIXED = GOOD

_FRAMES = ("robotBaseFrame", "robot_base_frame")
_ODOMETRY = ("odometryFrame", "odometry_frame")
#: What switches the transform off; the names in the catalogue give the defaults.
_SWITCHES = ("publishTf", "publishOdomTF", "publish_odom_tf", "publishOdometryTf")


@rule(
    "GAZ031",
    "odometry-frame-is-not-root",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        if use.plugin is None or use.plugin.generation == "gz" or not _sends(use):
            continue
        parameter = next((name for name in _FRAMES if name in use.plugin.parameters), None)
        if parameter is None:
            continue
        written = use.values(parameter)
        name = written[0].text if written else use.plugin.parameters[parameter].default or ""
        above = subject.tree.parents.get(name.lstrip("/"), [])
        if len(above) != 1 or above[0].parent is None:
            continue
        parent = above[0].parent.value
        frame = _odometry(use)
        if parent == frame.lstrip("/"):
            continue
        root = subject.tree.roots[0].name if len(subject.tree.roots) == 1 else parent
        yield Finding(
            _place(use, written),
            f"{use.title} sends the transform {frame} -> {name}, and robot_state_publisher "
            f"{parent} -> {name}: a frame has one parent",
            f"name the root link '{root}', or remove the links above '{name}'",
            _fix(written, root) if len(subject.tree.roots) == 1 else None,
        )


def _fix(written: list[Item], root: str) -> Fix | None:
    edits = rewrite(written[0].at, root) if written else None
    return Fix.of(f"name the root link '{root}'", edits)


def _place(use: Use, written: list[Item]) -> Element | Attribute:
    return written[0].at if written else use.at


def _sends(use: Use) -> bool:
    """True if the plugin sends the transform of its odometry."""
    assert use.plugin is not None
    parameters = use.plugin.parameters
    if not any(name in parameters for name in _ODOMETRY):
        return False
    for switch in _SWITCHES:
        if switch in parameters:
            written = use.values(switch)
            value = written[0].text if written else parameters[switch].default or ""
            if value.lower() not in ("true", "1"):
                return False
    return True


def _odometry(use: Use) -> str:
    assert use.plugin is not None
    for name in _ODOMETRY:
        if name in use.plugin.parameters:
            written = use.values(name)
            return written[0].text if written else use.plugin.parameters[name].default or "odom"
    return "odom"
