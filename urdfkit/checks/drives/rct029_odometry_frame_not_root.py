"""The robot frame of a drive's odometry is not the root link of the robot.

A drive plugin or wheel controller publishes the transform from its odometry frame to this link, and
robot_state_publisher the transform from the link's parent: a frame has one parent in tf, and the
robot jumps between the two. If the name is not a link, the robot has no transform to `odom` ("no
transform from [base_link] to [odom]"). Use the root link, or remove the links above it. An
`odom_frame_id` that is a link of the robot is also reported.

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    REP 105, frames of mobile robots: http://www.ros.org/reps/rep-0105.html
"""

from __future__ import annotations

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Findings, Need, Severity, rule
from urdfkit.robot.samples import joint_xml, robot_xml
from urdfkit.ros.gazebo.samples import gazebo_xml, plugin_xml, solid_xml
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.grammar import is_expression

if TYPE_CHECKING:
    from collections.abc import Collection

    from urdfkit.lint.context import Context
    from urdfkit.ros.controllers import Controller
    from urdfkit.ros.gazebo.plugins import PluginUse
    from urdfkit.text.located_yaml import Value

BAD = robot_xml(
    solid_xml("base_footprint"),
    solid_xml("base_link"),
    joint_xml("fixed", name="base_joint", parent="base_footprint", child="base_link"),
    gazebo_xml(
        plugin_xml(
            "drive", "libgazebo_ros_planar_move.so", "<robotBaseFrame>base_link</robotBaseFrame>"
        )
    ),
)
FIXED = GOOD = BAD.replace("Frame>base_link<", "Frame>base_footprint<")

#: Parameters of plugins for the robot frame and the odometry frame.
_FRAMES = ("robotBaseFrame", "robot_base_frame")
_ODOMETRY = ("odometryFrame", "odometry_frame")
#: Links of some robots that are global frames.
_WORLDS = ("world", "map", "odom")
#: Parameters that enable the transform; the catalogue contains their defaults.
_SWITCHES = ("publishTf", "publishOdomTF", "publish_odom_tf", "publishOdometryTf")
#: The parameter without which a drive publishes the transform.
_OFF = "enable_odom_tf: false"


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO), reports_missing=True)
def check(context: Context) -> Findings:
    for use in context.plugins:
        yield from _check_plugin(use, context)
    if context.is_part or len(context.tree.roots) != 1:
        return
    for file, controller in context.controllers:
        yield from _moving_odometry(controller, context)
        if frame := _frame(controller):
            for finding in _check_controller(controller, frame, context):
                yield finding._replace(related=(file.note,))


def _check_plugin(use: PluginUse, context: Context) -> Findings:
    frames = _published_frames(use)
    if frames is None:
        return
    parameter, frame = frames
    values, name = use.values(parameter), use.value(parameter)
    above = context.tree.parents.get(name.lstrip("/"), [])
    if len(above) != 1 or above[0].parent is None or above[0].kind == "floating":
        return
    parent = above[0].parent_name
    if parent == frame.lstrip("/"):
        return
    roots = context.tree.roots
    root = roots[0].name if len(roots) == 1 else parent
    moves, remove = root not in _WORLDS, f"remove the links above '{name}'"
    yield Finding(
        values[0].at if values else use.at,
        f"{use.title} publishes the transform {frame} -> {name}, and robot_state_publisher "
        f"{parent} -> {name}: a frame has one parent",
        f"name the root link '{root}', or {remove}" if moves else remove,
        fix_value(values[0].at, root) if values and len(roots) == 1 and moves else None,
    )


def _published_frames(use: PluginUse) -> tuple[str, str] | None:
    """Parameter for the child frame, and parent frame, of the transform that a plugin publishes."""
    parameters = use.plugin.parameters if use.plugin and use.plugin.generation != "gz" else {}
    child = next((name for name in _FRAMES if name in parameters), None)
    parent = next((name for name in _ODOMETRY if name in parameters), None)
    switches = [use.value(name) for name in _SWITCHES if name in parameters]
    is_published = all(value.lower() in ("true", "1") for value in switches)
    return (child, use.value(parent) or "odom") if child and parent and is_published else None


def _check_controller(controller: Controller, frame: Value, context: Context) -> Findings:
    root, name = context.tree.roots[0].name, frame.text.strip("/")
    links = context.model.links_by_name
    if name == root:
        return
    if name not in links:
        message = f"the robot has no link '{name}'{did_you_mean(name, links)}"
    else:
        joint = context.tree.published_joint(name)
        if joint is None:
            return
        parent = joint.parent_name or root
        message = f"'{name}' is a child of '{parent}'; a frame has one parent"
    yield Finding(
        frame.span,
        f"{controller.title} publishes the transform to '{name}': {message}",
        _help(name, root, links),
    )


def _help(name: str, root: str, links: Collection[str]) -> str:
    """What to do about the frame of a controller; a world does not move with the robot."""
    if root not in _WORLDS:
        return f"name the root link '{root}', or write {_OFF} if another node publishes it"
    return f"remove the links above '{name}'" if name in links else "name a link of the robot"


def _moving_odometry(controller: Controller, context: Context) -> Findings:
    """An odometry frame that is a link, which moves with the robot, and frames with a slash."""
    is_drive = "drive" in controller.type or "steering" in controller.type
    for odometry in controller.values(["odom_frame_id"]) if is_drive else ():
        name = odometry.text.strip("/")
        if name in context.model.links_by_name and name not in _WORLDS:
            message = f"{controller.title}: odom_frame_id '{name}' is a link of the "
            message += "robot, which moves with it"
            yield Finding(odometry.span, message, "write odom_frame_id: odom")
    for frame in controller.values(["odom_frame_id", "base_frame_id"]) if is_drive else ():
        if frame.text.startswith("/") and controller.ros == 2:
            name = frame.text.lstrip("/")
            message = f"{controller.title}: tf2 rejects '{frame.text}': the name of a "
            message += "frame has no leading slash"
            yield Finding(frame.span, message, f"write {name}")


def _frame(controller: Controller) -> Value | None:
    """The robot frame whose transform a controller publishes; None if there is none."""
    if "drive" not in controller.type and "steering" not in controller.type:
        return None
    switch = controller.values(["enable_odom_tf"])
    prefixed = controller.values(["tf_frame_prefix"])
    frame = controller.values(["base_frame_id"])
    if not frame or (switch and switch[0].text.lower() == "false") or prefixed:
        return None
    return None if is_expression(frame[0].text) or not frame[0].text else frame[0]
