"""A plugin or sensor stamps its messages with a frame that the robot does not have.

TF has no way from such a frame to any other: RViz says "no transform from", navigation drops the
scans, and nobody finds the odometry. A frame that begins with a slash is refused by tf2 altogether.
Frames of the world, such as `map` and `odom`, come from elsewhere; of these only a slash is
reported, and none of plugins of ROS 1, which take it away.

Sources:
    REP 105, frames: https://www.ros.org/reps/rep-0105.html
    measured: 13 of 676 public models
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.text.diagnostic import Confidence, Fix, Severity
from urdfkit.text.editing.edits import rewrite
from urdfkit.text.grammar import is_expression

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.ros.gazebo.plugins import PluginUse
    from urdfkit.text.document import Attribute, Element

BAD = """\
<link name="camera">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="camera">
  <sensor name="imu" type="imu">
    <plugin name="driver" filename="libgazebo_ros_imu_sensor.so">
      <frameName>camra</frameName>
    </plugin>
  </sensor>
</gazebo>"""
FIXED = GOOD = BAD.replace("camra", "camera")

#: Tags of a sensor of gz-sim.
_TAGS = ("gz_frame_id", "frame_id", "ign_frame_id", "ignition_frame_id")
#: Parts of the names of frames, and of parameters, that are no links of the robot.
_ELSEWHERE = ("odom", "map", "world", "earth", "utm")


@rule("GAZ058", "frame-unknown", Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO), fixable=True)
def check(subject: Subject) -> Iterator[Finding]:
    if subject.is_part:
        return
    known = subject.model.links_by_name
    suggester = Suggester(known)
    for who, at, name in _frames(subject):
        bare = name.strip("/").rpartition("/")[2]
        if not bare or is_expression(name):
            continue
        if name.startswith("/"):
            message = f"{who} names frame '{name}': tf2 refuses the slash at its beginning"
            yield Finding(at, message, f"write {name.strip('/')}", _fix(at, name, name.strip("/")))
        elif bare not in known and name not in known and not _is_of_the_world(name):
            suggested = suggester.suggested(name)
            help = f"did you mean '{suggested}'?" if suggested else "name a link of the robot"
            yield Finding(
                at,
                f"{who} names frame '{name}', and the robot has no such link",
                help,
                _fix(at, name, suggested) if suggested else None,
                confidence=Confidence.INFERRED,
            )


def _frames(subject: Subject) -> Iterator[tuple[str, Element | Attribute, str]]:
    """Who names a frame, where and which."""
    for use in subject.plugins:
        for item in use.items:
            parameter = use.plugin.parameters.get(item.path) if use.plugin else None
            if parameter is None or parameter.type != "frame" or item.text in parameter.words:
                continue
            is_far = _is_of_the_world(item.path) or _is_of_the_world(item.text)
            if not is_far or (item.text.startswith("/") and not _is_of_ros1(use)):
                yield use.title, item.at, item.text
    for sensor in sensors(subject.model):
        for tag in _TAGS:
            for element in sensor.at.all(tag):
                yield sensor.who, element, element.text.strip()


def _is_of_the_world(name: str) -> bool:
    return any(word in name.lower() for word in _ELSEWHERE)


def _is_of_ros1(use: PluginUse) -> bool:
    return use.plugin is not None and use.plugin.generation == "classic-ros1"


def _fix(at: Element | Attribute, name: str, suggested: str) -> Fix | None:
    edits = rewrite(at, suggested)
    return Fix.of(f"rename '{name}' to '{suggested}'", edits)
