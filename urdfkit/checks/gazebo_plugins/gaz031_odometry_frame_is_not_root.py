"""The frame that a plugin's odometry moves is not the root of the robot.

The plugin sends a transform from its odometry frame to that link, and robot_state_publisher sends
one from the link's parent: tf has one parent for a frame, and the robot jumps between the two. Name
the root link, or remove the link above it.

Sources:
    REP 105, frames of mobile robots: http://www.ros.org/reps/rep-0105.html
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.ros.gazebo.plugins import PluginParameter, PluginUse
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rewrite

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


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO))
def check(subject: Subject) -> Findings:
    for use in subject.plugins:
        if use.plugin is None or use.plugin.generation == "gz" or not _sends(use):
            continue
        parameter = next((name for name in _FRAMES if name in use.plugin.parameters), None)
        if parameter is None:
            continue
        written, name = use.values(parameter), use.value(parameter)
        above = subject.tree.parents.get(name.lstrip("/"), [])
        if len(above) != 1 or above[0].parent is None:
            continue
        parent = above[0].parent.value
        frame = _odometry(use)
        if parent == frame.lstrip("/"):
            continue
        root = subject.tree.roots[0].name if len(subject.tree.roots) == 1 else parent
        yield Finding(
            written[0].at if written else use.at,
            f"{use.title} sends the transform {frame} -> {name}, and robot_state_publisher "
            f"{parent} -> {name}: a frame has one parent",
            f"name the root link '{root}', or remove the links above '{name}'",
            _fix(written, root) if len(subject.tree.roots) == 1 else None,
        )


def _fix(written: list[PluginParameter], root: str) -> Fix | None:
    edits = rewrite(written[0].at, root) if written else None
    return Fix.of(f"name the root link '{root}'", edits)


def _odometry(use: PluginUse) -> str:
    """The frame in which the plugin tells where the robot is."""
    assert use.plugin is not None
    named = (use.value(name) for name in _ODOMETRY if name in use.plugin.parameters)
    return next(named, "") or "odom"


def _sends(use: PluginUse) -> bool:
    """True if the plugin sends the transform of its odometry."""
    assert use.plugin is not None
    parameters = use.plugin.parameters
    if not any(name in parameters for name in _ODOMETRY):
        return False
    switches = [use.value(name) for name in _SWITCHES if name in parameters]
    return all(value.lower() in ("true", "1") for value in switches)
