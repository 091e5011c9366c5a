"""The transform of odometry that a system of Gazebo publishes and the bridge passes on to tf.

Source: ``DiffDrive.cc`` and ``OdometryPublisher.cc`` of gz-sim.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.lint.rules import Context
from urdfkit.ros.gazebo.topics import of_plugin
from urdfkit.ros.launch.bridges import TO_GAZEBO, bridged_topics
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.text.document import Element

_MESSAGE = "Pose_V"
#: The tags for the frame of the odometry, and for that of the robot.
_PARENTS, _CHILDREN = ("frame_id", "odom_frame"), ("child_frame_id", "robot_base_frame")


class BridgedOdometry(Record):
    """A transform on its way from Gazebo to tf."""

    bridge: StartedProgram  # that passes it on
    who: str  # publishes it, for messages
    odometry: str  # its parent; empty if the plugin does not name it
    child: Element  # that names its child

    @property
    def base(self) -> str:
        return self.child.text.strip().strip("/")


def bridged_odometry(
    context: Context, started: list[StartedProgram], robot: Context
) -> Iterator[BridgedOdometry]:
    """The transforms of odometry of a robot that bridges pass on to ``/tf``."""
    for one in started:
        for topic in bridged_topics(one, context.resolver):
            if topic.direction == TO_GAZEBO or topic.ros_topic.strip("/") != "tf":
                continue
            for use in robot.plugins:
                child = _first(use.at, _CHILDREN)
                sends = any(
                    found.message == _MESSAGE and found.is_called(topic.topic)
                    for found in of_plugin(use.at)
                )
                if child is not None and sends and one.is_sure and not one.is_remapped:
                    parent = _first(use.at, _PARENTS)
                    odometry = parent.text.strip().strip("/") if parent is not None else ""
                    yield BridgedOdometry(one, use.title, odometry, child)


def _first(plugin: Element, tags: tuple[str, ...]) -> Element | None:
    return next((found for tag in tags if (found := plugin.child(tag)) is not None), None)
