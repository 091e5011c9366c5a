"""An optical frame is misrotated, or a camera does not use it as one.

The frame of a camera has x forward, y left and z up; its optical frame has z forward, x right and y
down: rpy="-pi/2 0 -pi/2" rotates the one into the other (REP 103).

- A joint rotates the optical frame otherwise: images, point clouds and detections appear beside,
  above or behind the robot; with rpy="pi/2 0 pi/2" they are upside down. That one is right where z
  of the camera's frame points down: a camera mounted upside down, and a vehicle under water.
- A camera of Gazebo is on an optical frame: a sensor looks along x of its link, so the camera looks
  to the right. Put it on the camera's own link.
- The images have the frame_id of the camera's own link, which is x-forward: what is straight ahead
  appears above the robot. Name an optical frame. An info.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    gazebo_ros_camera.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_camera.cpp
"""

from urdfkit.core.spatial import Rotation, multiply, rotate
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.model import Joint
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml
from urdfkit.robot.values import numbers
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_value

_RPY = '<origin rpy="1.5707963 0 -1.5707963"/>'
BAD = robot_xml(
    link_xml("camera_link"),
    link_xml("camera_optical_frame"),
    joint_xml("fixed", _RPY, parent="camera_link", child="camera_optical_frame"),
)
FIXED = GOOD = BAD.replace('"1.5707963 0 -1.5707963"', '"-1.5707963 0 -1.5707963"')

#: From the frame of a camera to its optical frame; its columns are the optical axes.
_OPTICAL: Rotation = ((0.0, 0.0, 1.0), (-1.0, 0.0, 0.0), (0.0, -1.0, 0.0))
#: The same where z points down.
_OPTICAL_DOWN: Rotation = ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
#: Beginnings of words in the names of cameras that do not look forward, whatever their frame does.
_ELSEWHERE = ("down", "bottom", "belly", "nadir", "upward", "ceiling")
#: Words in the names of links of vehicles under water, some of which have z down everywhere.
_UNDER_WATER = ("thruster", "dvl", "sonar", "ned", "auv", "rov", "uuv", "rexrov")
#: People write pi with four digits.
_TOLERANCE = 0.01
#: Where a camera's plugin or sensor names the frame of its images.
_FRAME_IDS = ("frameName", "frame_name", "gz_frame_id", "frame_id", "ignition_frame_id")


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        if joint.kind != "fixed" or joint.parent is None or joint.child is None:
            continue
        camera, optical = joint.parent_name, joint.child_name
        rotation = joint.origin.rotation
        if (
            not _is_of_one_camera(camera.lower(), optical.lower())
            or _has_misspelt_origin(joint)
            or any(word.startswith(_ELSEWHERE) for word in optical.lower().split("_"))
            or not _is_square(rotation)
            or _is_near(rotation, _OPTICAL)
            or _is_near(_from_mount(context, camera, rotation), _OPTICAL)
        ):
            continue
        is_upside_down = _is_near(rotation, _OPTICAL_DOWN)
        if is_upside_down and _is_z_down(context, camera):
            continue
        where = "forward, but upside down," if is_upside_down else _forward(rotation)
        yield Finding(
            joint.at.child("origin") or joint.at,
            f"joint '{joint.name}': '{optical}' looks {where} from '{camera}'; an optical frame "
            "looks forward, its x to the right",
            'write rpy="-1.5707963 0 -1.5707963"',
            None if _has_sensor(context, optical) else _fix(joint),
            confidence=Confidence.INFERRED,
        )
    if context.model.gazebo:
        yield from _of_gazebo(context)


def _has_misspelt_origin(joint: Joint) -> bool:
    """True if the rotation stands in an element that is no origin, as URD001 reports."""
    tags = {child.tag for child in joint.at.children}
    return "origin" not in tags and any("origin" in tag for tag in tags)


def _from_mount(context: Context, camera: str, rotation: Rotation) -> Rotation:
    """The rotation of an optical frame from what the frame of its camera is fixed to."""
    for joint in context.tree.parents.get(camera, ()):
        if joint.kind == "fixed":
            return multiply(joint.origin.rotation, rotation)
    return rotation


def _of_gazebo(context: Context) -> Findings:
    from urdfkit.ros.gazebo.sensors import sensors

    for sensor in sensors(context.model):
        if "camera" not in sensor.type and sensor.type not in ("depth", "rgbd"):
            continue
        link = sensor.reference
        if "optical" in link:
            if _looks_aside(context, link) and not _is_rotated(sensor.find("pose")):
                message = f"{sensor.who} looks along x of '{link}', to the robot's right"
                help = "refer to the camera's link, and name the optical frame in the plugin"
                yield Finding(sensor.at, message, help, group_key="optical")
            continue
        parents = (sensor.at, *sensor.plugins)
        for frame in (one for parent in parents for tag in _FRAME_IDS for one in parent.all(tag)):
            if frame.text.strip() == link:
                yield Finding(
                    frame,
                    f"{sensor.who}: images are published with frame_id '{link}', which is "
                    "x-forward",
                    "name an optical frame: a child link with rpy -1.5708 0 -1.5708",
                    group_key="not optical",
                    severity=Severity.INFO,
                )


def _looks_aside(context: Context, optical: str) -> bool:
    """True if z of an optical frame points forward, so that x does not."""
    joints = context.tree.parents.get(optical, ())
    return any(rotate(joint.origin.rotation, (0.0, 0.0, 1.0))[0] > 0.99 for joint in joints)


def _is_rotated(pose: Element | None) -> bool:
    values = numbers(pose.text) if pose else None
    return values is not None and any(abs(angle) > 1e-6 for angle in values[3:])


def _is_z_down(context: Context, camera: str) -> bool:
    """True if z of a camera's frame points down: it is mounted so, or all frames may be."""
    frame = context.tree.frames.get(camera)
    if frame is not None and frame.rotation[2][2] < 0:
        return True
    words = {word for name in context.model.links_by_name for word in name.lower().split("_")}
    return any(word.rstrip("0123456789") in _UNDER_WATER for word in words)


def _has_sensor(context: Context, link: str) -> bool:
    """True if a sensor of Gazebo is on a link: it looks along x, and would be rotated away."""
    blocks = (block for block in context.model.gazebo if block.get("reference") == link)
    return any(block.child("sensor") for block in blocks)


def _is_of_one_camera(camera: str, optical: str) -> bool:
    """True for ``camera_link`` and ``camera_optical_frame``: one name without its last words."""
    stem, word, _ = optical.partition("optical")
    stem = stem.rstrip("_")
    if not word or not stem or "optical" in camera:
        return False
    return camera.startswith(stem) or stem == camera.removesuffix("_link").removesuffix("_frame")


def _is_square(rotation: Rotation) -> bool:
    """True if every axis lies on an axis: a camera that is tilted may be tilted here."""
    return all(min(abs(v), abs(1 - abs(v))) < _TOLERANCE for row in rotation for v in row)


def _is_near(one: Rotation, other: Rotation) -> bool:
    rows = zip(one, other, strict=True)
    pairs = (pair for row, line in rows for pair in zip(row, line, strict=True))
    return all(abs(a - b) < _TOLERANCE for a, b in pairs)


def _forward(rotation: Rotation) -> str:
    """Where z of a square rotation points, in the frame of the camera."""
    z = tuple(row[2] for row in rotation)
    axis = max(range(3), key=lambda i: abs(z[i]))
    names = ("backward", "to the right", "down"), ("forward, but rotated,", "to the left", "up")
    return names[z[axis] > 0][axis]


def _fix(joint: Joint) -> Fix | None:
    origin = joint.at.child("origin")
    rpy = origin.attributes.get("rpy") if origin else None
    return fix_value(rpy, "-1.5707963 0 -1.5707963") if rpy else None
