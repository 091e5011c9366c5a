"""The frame_id of a plugin or sensor is not a link of the robot, or is missing.

TF has no transform from such a frame: RViz shows "no transform from", navigation drops the scans,
and odometry is not found. tf2 rejects a frame that begins with a slash. Frames of the world, such
as `map` and `odom`, are published by others; of these only a slash is reported, and none of plugins
of ROS 1, which remove it. These also put the namespace, or the name of the model, in front: for
the link `uav/camera/left`, `camera/left` is right. A sensor that Gazebo drops with its block is not
reported (GAZ001).

A sensor of gz-sim without a frame publishes a name of Gazebo's own, such as
`robot/base_link/lidar`, which TF does not have. Write the link in `<gz_frame_id>`, which all
versions read. Only Fortress reads `<ignition_frame_id>`, too, and only Gazebo from Ionic on (Jetty)
reads `<frame_id>`. Images of a camera have the frame in the `<optical_frame_id>` of `<camera>`,
except in Jetty, which no longer reads it. Without ROS there is no TF, and a missing frame is an
info; so it is if a PosePublisher publishes the poses of the sensors under these names. The plugin
of a custom sensor, such as a lidar of RGL, has a parameter of its own for the frame. Next to a
drive, which publishes odometry, an OdometryPublisher gives the true pose: it may have other frames.

Sources:
    REP 105, frames: https://www.ros.org/reps/rep-0105.html
    gz-sensors, Sensor.cc: https://github.com/gazebosim/gz-sensors/blob/main/src/Sensor.cc
    gz-sensors, CameraSensor.cc: https://github.com/gazebosim/gz-sensors/blob/gz-sensors8/src/CameraSensor.cc
    gazebosim/gz-sensors#306: https://github.com/gazebosim/gz-sensors/issues/306
    measured: 13 of 676 public models name a frame that does not exist
"""

from collections.abc import Iterator
from itertools import chain

from urdfkit.core.suggest import Suggester
from urdfkit.core.words import more_like_this
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.sensors import types
from urdfkit.ros.gazebo.drives import drive_of
from urdfkit.ros.gazebo.plugins import PluginParameter, PluginUse
from urdfkit.ros.gazebo.samples import gazebo_xml, plugin_xml, sensor_xml, solid_xml
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.targets import ROS
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.grammar import is_expression

_PLUGIN = plugin_xml("driver", "libgazebo_ros_imu_sensor.so", "<frameName>camra</frameName>")
BAD = robot_xml(
    solid_xml("camera"), gazebo_xml(sensor_xml("imu", "imu", _PLUGIN), reference="camera")
)
FIXED = GOOD = BAD.replace("camra", "camera")

#: Tags of a sensor of gz-sim, and those that each version reads.
_TAGS = ("gz_frame_id", "frame_id", "ign_frame_id", "ignition_frame_id")
_READ = {
    "gz-fortress": ("gz_frame_id", "ignition_frame_id", "optical_frame_id"),
    "gz-harmonic": ("gz_frame_id", "optical_frame_id"),
    "gz-jetty": ("gz_frame_id", "frame_id"),
}
#: Types of sensors whose images have the frame in the ``<optical_frame_id>`` of ``<camera>``.
_OPTICAL = ("camera", "depth", "depth_camera", "rgbd", "rgbd_camera")
_POSES = "gz-sim-pose-publisher-system@gz"
_ODOMETRY = "gz-sim-odometry-publisher-system@gz"
#: Parts of the names of frames and parameters that are not links of the robot.
_ELSEWHERE = ("odom", "map", "world", "earth", "utm")


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO), reports_missing=True)
def check(context: Context) -> Findings:
    yield from _missing(context)
    if not context.is_part:
        yield from _unknown(context)


def _unknown(context: Context) -> Findings:
    known = context.model.links_by_name
    suggester = Suggester([link for link in known if not link.startswith("/")])
    own = _frames_of_truth(context)
    for who, at, name in _frames(context):
        bare = name.strip("/").rpartition("/")[2]
        if not bare or is_expression(name):
            continue
        if name.startswith("/"):
            message = f"{who}: frame_id '{name}' begins with a slash, which tf2 rejects"
            yield Finding(at, message, f"write {name.strip('/')}", fix_value(at, name.strip("/")))
        elif bare not in known and name not in known and not _is_of_the_world(name):
            suggested = suggester.suggested(name)
            if not suggested and any(at is each for each in own):
                continue
            help = f"did you mean '{suggested}'?" if suggested else "name a link of the robot"
            message = f"{who}: frame_id '{name}' is not a link of the robot"
            yield Finding(
                at, message, help, fix_value(at, suggested), confidence=Confidence.INFERRED
            )


def _frames_of_truth(context: Context) -> list[Element | Attribute]:
    """The frames of odometry next to that of a drive: those of a true pose, which may be others."""
    if not any(map(drive_of, context.plugins)):
        return []
    publishers = (use for use in context.plugins if use.plugin and use.plugin.id == _ODOMETRY)
    return [item.at for use in publishers for item in use.items]


def _frames(context: Context) -> Iterator[tuple[str, Element | Attribute, str]]:
    """Each frame that is named: by whom, where, its name."""
    for use in context.plugins:
        if not _is_dropped(use.at, context.model):
            strips = _strips_slash(use)
            yield from (
                (use.title, item.at, item.text.lstrip("/") if strips else item.text)
                for item in use.items
                if _is_frame_of_robot(use, item, context.model)
            )
    for sensor in sensors(context.model):
        if not _is_dropped(sensor.at, context.model):
            for element in (*chain.from_iterable(map(sensor.at.all, _TAGS)), *_optical(sensor)):
                yield sensor.who, element, element.text.strip()


def _is_frame_of_robot(use: PluginUse, item: PluginParameter, model: RobotModel) -> bool:
    """True for a parameter that names a link of the robot, and not another frame."""
    parameter = use.plugin.parameters.get(item.path) if use.plugin else None
    if parameter is None or parameter.type != "frame" or item.text in parameter.words:
        return False
    is_of_ros1 = _is_of_ros1(use)
    if is_of_ros1 and any(link.endswith(f"/{item.text}") for link in model.links_by_name):
        return False  # the plugin puts the namespace, perhaps the model's name, in front of it
    is_far = _is_of_the_world(item.path) or _is_of_the_world(item.text)
    return not is_far or (item.text.startswith("/") and not is_of_ros1)


def _is_dropped(element: Element, model: RobotModel) -> bool:
    """True in a ``<gazebo>`` with an unknown reference, which GAZ001 reports."""
    block: Element | None = element
    while block is not None and block.tag != "gazebo":
        block = block.parent
    name = block.get("reference") if block is not None else None
    return bool(name) and name not in model.links_by_name and name not in model.joints_by_name


def _controlled(model: RobotModel) -> set[str]:
    """Names of sensors that ``<ros2_control>`` reads, whose broadcasters have frames.

    One of its sensors may read several of Gazebo, by interfaces of their names.
    """
    if not model.ros2_controls:
        return set()
    from urdfkit.ros.ros_control import components

    parts = [part for block in components(model) for part in block.parts if part.kind == "sensor"]
    several = {interface.name for part in parts for interface in part.interfaces}
    return several.union(part.name for part in parts)


def _missing(context: Context) -> Findings:
    """One finding for all sensors: usually all of them lack it."""
    targets = context.targets
    if targets.names and not targets.any_of(_READ):
        return
    readers = [tags for target, tags in _READ.items() if targets.any_of((target,))]
    controlled = _controlled(context.model)
    without = [
        sensor
        for sensor in sensors(context.model)
        if sensor.name not in controlled and _has_no_frame(sensor, readers)
    ]
    if not without:
        return
    first = without[0]
    tags = _given(first)
    lack = f"has only <{tags[0]}> as its frame" if tags else "has no <gz_frame_id>"
    is_for_ros = any(names.any_of(ROS) for names in (targets, context.inferred_targets))
    is_published = any(map(_publishes_sensors, context.plugins))
    readers_for_ros = targets.among(_READ) if is_for_ros and not is_published else ()
    yield Finding(
        first.at,
        f"{first.who} {lack}{more_like_this(len(without) - 1)}",
        "add <gz_frame_id>LINK</gz_frame_id> to the sensor",
        severity=Severity.WARNING if readers_for_ros else Severity.INFO,
        targets=readers_for_ros,
    )


def _publishes_sensors(use: PluginUse) -> bool:
    """True for a plugin that publishes the poses of the sensors under Gazebo's own names."""
    is_publisher = use.plugin is not None and use.plugin.id == _POSES
    return is_publisher and use.value("publish_sensor_pose").lower() in ("true", "1")


def _has_no_frame(sensor: Sensor, readers: list[tuple[str, ...]]) -> bool:
    """True if one of the readers finds no frame for the sensor."""
    if sensor.type == "contact":  # publishes which bodies touch, not where it is
        return False
    if sensor.type == "custom" and "dvl" not in map(sensor.at.get, ("gz:type", "ignition:type")):
        return False  # a plugin publishes it, with a frame of its own
    kind = types().get(sensor.type)
    if kind is None or not kind.gz:
        return False
    given = _given(sensor)
    return not given or any(set(tags).isdisjoint(given) for tags in readers)


def _given(sensor: Sensor) -> list[str]:
    """The tags of a frame that it has."""
    known = dict.fromkeys(tag for tags in _READ.values() for tag in tags)
    given = {tag for tag in known if sensor.at.child(tag) is not None}
    given.update(element.tag for element in _optical(sensor))
    return [tag for tag in known if tag in given]


def _optical(sensor: Sensor) -> list[Element]:
    """The frame of a camera's images."""
    camera = sensor.at.child("camera") if sensor.type in _OPTICAL else None
    return camera.all("optical_frame_id") if camera is not None else []


def _is_of_the_world(name: str) -> bool:
    return any(word in name.lower() for word in _ELSEWHERE)


def _strips_slash(use: PluginUse) -> bool:
    """True if a plugin passes its frames through ``tf::resolve`` of ROS 1, as all but IMUs do."""
    is_resolved = use.plugin is not None and use.plugin.package == "gazebo_plugins"
    return is_resolved and _is_of_ros1(use) and "imu" not in use.filename


def _is_of_ros1(use: PluginUse) -> bool:
    return use.plugin is not None and use.plugin.generation == "classic-ros1"
