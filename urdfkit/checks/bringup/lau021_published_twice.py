"""Two programs of a launch file publish the same transform, joint states or estimate.

- A static_transform_publisher and robot_state_publisher both publish the transform of a link: tf
  keeps the last one, and the robot flickers if the two differ (an info if they are equal). Or it
  publishes the transform of the frame that odometry moves, such as map to base_link next to odom to
  base_link, or that of odom next to AMCL or slam_toolbox.
- joint_state_publisher and joint_state_broadcaster of ros2_control (joint_state_controller in
  ROS 1) publish on the same `joint_states`: the model jumps between the real positions and those of
  the sliders. The same holds for joint states that are bridged from Gazebo, and for
  joint_state_publisher and joint_state_publisher_gui.
- robot_localization and diff_drive_controller both publish the transform from odom to the robot,
  which jumps between the two: write `enable_odom_tf: false`. Or the `base_link_frame` of
  robot_localization is the child of a joint, which gives the link two parents. The same holds for
  the transforms of gz-sim's drives and OdometryPublisher if they are bridged, of the drives of
  Gazebo Classic, of rf2o, rtabmap and Cartographer. imu_filter_madgwick publishes the transform of
  the IMU, which has a joint.
- Two filters of robot_localization publish on the same topic: remap `odometry/filtered`. Or both
  publish the transform from odom: the `world_frame` of the global one is map.
- AMCL, slam_toolbox or a filter of robot_localization whose `world_frame` is the map publish the
  transform from map to odom, and another one of them does, too.
- There are two robot_state_publishers of one robot.

The robot of a launch file for navigation is that of the other launch files of the workspace.
Programs with a condition that is known only at run time are ignored.

Sources:
    robot_state_publisher: https://github.com/ros/robot_state_publisher/blob/rolling/README.md
    ros2_control, joint_state_broadcaster: https://control.ros.org/rolling/doc/ros2_controllers/joint_state_broadcaster/doc/userdoc.html
    Nav2, transforms: https://docs.nav2.org/setup_guides/transformation/setup_transforms.html
"""

from math import dist

from urdfkit.checks.bringup import duplicate_transforms
from urdfkit.checks.bringup.published_robots import (
    published_robots,
    runs_in_display_only,
    runs_in_simulation_only,
)
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.tree import KinematicTree
from urdfkit.ros.gazebo.topics import topics
from urdfkit.ros.launch.bridges import TO_GAZEBO, BridgedTopic, bridged_topics
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import manager_name, spawned_controllers, topic_name
from urdfkit.ros.launch.spawning import spawns_sdf
from urdfkit.ros.launch.transforms import StaticTransform, static_transform

NAME = "launch/robot.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [
    Node(package="joint_state_publisher", executable="joint_state_publisher"),
    Node(package="controller_manager", executable="spawner", arguments=["joint_state_broadcaster"]),
]
"""
GOOD = BAD.replace(BAD.splitlines(keepends=True)[3], "")

_PUBLISHERS = ("joint_state_publisher", "joint_state_publisher_gui")
_SLIDERS = "joint_state_publisher_gui/joint_state_publisher_gui"
_TOPIC = "joint_states"
_MESSAGE = "sensor_msgs/msg/JointState"
_BROADCASTERS = ("joint_state_broadcaster", "joint_state_controller")
#: In m: positions that are closer are equal.
_POSITION_TOLERANCE = 1e-3


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    launch = context.launch
    programs = [node for node in launch.programs if node.is_sure]
    yield from _transforms(context, programs)
    if not launch.has_scopes:  # which give them namespaces
        yield from _joint_states(context, programs)
    yield from duplicate_transforms.second_publisher(context, programs)
    yield from duplicate_transforms.second_odometry(context, programs)
    yield from duplicate_transforms.second_filter(context, programs)
    yield from duplicate_transforms.second_orientation(context, programs)
    yield from duplicate_transforms.second_parent(context, programs)
    yield from duplicate_transforms.static_odometry(context, programs)
    yield from duplicate_transforms.second_map(context, programs)
    yield from duplicate_transforms.second_global_filter(context, programs)


def _transforms(context: Context, programs: list[StartedProgram]) -> Findings:
    """Static transforms of links that robot_state_publisher of this or another file publishes."""
    published = [(node, transform) for node in programs if (transform := static_transform(node))]
    if not published or runs_in_simulation_only(context) or runs_in_display_only(context):
        return
    trees = [robot.tree for robot in published_robots(context)]
    for node, transform in published:
        child = transform.child
        joints = [tree.published_joint(child.name) for tree in trees]
        joint = joints[0] if joints and all(joints) else None
        if joint:
            is_equal = _repeats_joint(transform, joint, trees[0])
            yield Finding(
                Location(child.span, node.frame),
                f"the transform of '{child.name}' is published twice: by this node, and by "
                f"robot_state_publisher for joint '{joint.name}'",
                "remove the static_transform_publisher, or the joint",
                related=(Related(joint.at.span, f"joint '{joint.name}'"),),
                severity=Severity.INFO if is_equal else None,
            )


def _repeats_joint(transform: StaticTransform, joint: Joint, tree: KinematicTree) -> bool:
    """True if both are the same transform of a fixed link: it does not matter which one is used."""
    names = (transform.parent.name, transform.child.name)
    parent, child = (tree.frames.get(name) for name in names)
    if parent is None or child is None or joint.kind != "fixed":
        return False
    position = (parent.inverse @ child).position
    return dist(transform.position, position) < _POSITION_TOLERANCE


def _joint_states(context: Context, programs: list[StartedProgram]) -> Findings:
    """A joint_state_publisher on the topic of a broadcaster, of the bridge or of the sliders."""
    publishers = [
        (f"{name.rpartition('/')[0]}/{_TOPIC}", f"controller {spawned.name}", spawned.word.span)
        for spawned in spawned_controllers(programs)
        if spawned.is_activated and spawned.name in _BROADCASTERS
        if (name := manager_name(spawned.program))
    ]
    publishers += [
        (name, "the bridge", topic.span)
        for node in programs
        for topic in bridged_topics(node, context.resolver)
        if topic.ros_type == _MESSAGE and topic.direction != TO_GAZEBO
        if (name := topic_name(topic.ros_topic, node)) and _is_in_gazebo(topic, context)
    ]
    others = {name: (who, span) for name, who, span in reversed(publishers)}
    for node in programs:
        if node.key == _SLIDERS and (name := topic_name(_TOPIC, node)):
            others.setdefault(name, (node.package, node.span))
    for node in programs:
        other = others.get(topic_name(_TOPIC, node) or "") if node.package in _PUBLISHERS else None
        if other and other[1] != node.span and b"source_list" not in node.span.source.data:
            yield Finding(
                node.at,
                f"{node.package} and {other[0]} both publish the joint states",
                "start one of the two" if other[0] in _PUBLISHERS else f"remove {node.package}",
                related=(Related(other[1], "the other publisher"),),
            )


def _is_in_gazebo(topic: BridgedTopic, context: Context) -> bool:
    """False if the robot in Gazebo does not publish a topic, or is not the described one."""
    if any(map(spawns_sdf, context.launch.programs)):
        return False
    robots = [robot for description, robot in context.described_robots if description.is_whole]
    published = [gz for robot in robots for gz in topics(robot.model)]
    return not robots or any(gz.is_called(topic.topic) for gz in published)
