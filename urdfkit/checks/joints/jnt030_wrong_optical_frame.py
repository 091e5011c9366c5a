"""An optical frame is misrotated, or a camera does not use it as one.

The frame of a camera has x forward, y left and z up; its optical frame has z forward, x right and y
down: rpy="-pi/2 0 -pi/2" rotates the one into the other (REP 103).

- A joint rotates the optical frame differently: images, point clouds and detections appear next to,
  above or behind the robot; with rpy="pi/2 0 pi/2" they are upside down. This rpy is right if z of
  the camera's frame points down, as for a camera mounted upside down or an underwater vehicle.
  rpy="pi 0 0" is not reported in a robot without Gazebo tags: the frame of the camera may be that
  of MuJoCo, OpenGL or USD. Nor is an optical frame along whose z a camera of Gazebo looks, or that
  of a camera that looks straight down, with x to the right: rpy="pi 0 -pi/2".
- A camera of Gazebo is on an optical frame: a sensor looks along x of its link, so the camera looks
  to the right. Put it on the camera's own link.
- The images have the frame_id of the camera's own link, which is x-forward: objects straight ahead
  appear above the robot. Use an optical frame. An info; not if `<optical_frame_id>` names another.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    gazebo_ros_camera.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_camera.cpp
"""

from math import pi

from urdfkit.core.spatial import IDENTITY, Z_AXIS, Rotation, from_rpy, multiply, rotate
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.joint import Joint
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

#: The right rpy, and that for a camera's frame whose z points down.
_RIGHT, _RIGHT_DOWN = "-1.5707963 0 -1.5707963", "1.5707963 0 1.5707963"
#: Rotation from the frame of a camera to its optical frame; the columns are the optical axes.
_OPTICAL: Rotation = ((0.0, 0.0, 1.0), (-1.0, 0.0, 0.0), (0.0, -1.0, 0.0))
#: The same rotation if z of the camera's frame points down.
_OPTICAL_DOWN: Rotation = ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
#: The optical frame of a camera that is tilted by 90 degrees, so that it looks down.
_OPTICAL_TILTED: Rotation = ((0.0, -1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, -1.0))
#: From the frame of a camera in MuJoCo, OpenGL or USD, which looks along -z with y up.
_OPTICAL_OF_OPENGL: Rotation = ((1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0))
#: Beginnings of words in the names of cameras that do not look forward.
_ELSEWHERE = ("down", "bottom", "belly", "nadir", "overhead", "bird", "upward", "ceiling")
#: Beginnings of words in the names of sensors without an optical frame, and of what cameras see.
_NO_CAMERAS = (
    "lidar", "laser", "radar", "imu", "gyro", "accel",
    "tag", "apriltag", "aruco", "charuco", "marker",
)  # fmt: skip
#: Words in the link names of underwater vehicles, some of which have z down in all frames.
_UNDER_WATER = ("thruster", "dvl", "sonar", "ned", "auv", "rov", "uuv", "rexrov")
#: Cosine of the angle between two axes above which they are the same.
_ALONG = 0.99
#: Allows for pi with few digits.
_TOLERANCE = 0.01
#: Elements of a camera's plugin or sensor that contain the frame of its images.
_FRAME_IDS = ("frameName", "frame_name", "gz_frame_id", "frame_id", "ignition_frame_id")
#: Element of a camera in gz sim with a frame for the images alone.
_OF_IMAGES = "optical_frame_id"


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
            or any(word.startswith(_ELSEWHERE + _NO_CAMERAS) for word in optical.lower().split("_"))
            or not _is_square(rotation)
            or _is_near(rotation, _OPTICAL)
            or _is_near(rotation, _OPTICAL_TILTED)
            or (_is_near(rotation, _OPTICAL_OF_OPENGL) and not context.model.gazebo)
            or _is_near(_from_mount(context, camera, rotation), _OPTICAL)
            or _is_view_of_gazebo(context, optical)
        ):
            continue
        is_upside_down = _is_near(rotation, _OPTICAL_DOWN)
        if is_upside_down and _is_z_down(context, camera):
            continue
        where = "forward, but upside down," if is_upside_down else _forward(rotation)
        message = f"joint '{joint.name}': '{optical}' looks {where} from '{camera}'; an optical "
        message += "frame looks forward, its x to the right"
        help = f'write rpy="{_RIGHT}"'
        fix: Fix | None = None
        if _has_sensor(context, optical):
            help = f"put the sensor, which looks along x, on a link with x forward and z up; {help}"
            help += f" for '{optical}' as its child"
        elif _has_z_down(context, camera):
            help = f"write rpy=\"{_RIGHT_DOWN}\", as z of '{camera}' points down"
        else:
            fix = _fix(joint)
        at = joint.at.child_or_self("origin")
        yield Finding(at, message, help, fix, confidence=Confidence.INFERRED)
    if context.model.gazebo:
        yield from _gazebo_cameras(context)


def _has_misspelt_origin(joint: Joint) -> bool:
    """True if the rotation is in an element with a misspelt name, which URD001 reports."""
    tags = {child.tag for child in joint.at.children}
    return "origin" not in tags and any("origin" in tag for tag in tags)


def _from_mount(context: Context, camera: str, rotation: Rotation) -> Rotation:
    """The rotation of an optical frame relative to the link that its camera is fixed to."""
    for joint in context.tree.parents.get(camera, ()):
        if joint.kind == "fixed":
            return multiply(joint.origin.rotation, rotation)
    return rotation


def _gazebo_cameras(context: Context) -> Findings:
    from urdfkit.ros.gazebo.sensors import sensors

    for sensor in sensors(context.model):
        if "camera" not in sensor.type and sensor.type not in ("depth", "rgbd"):
            continue
        link = sensor.reference
        if "optical" in link:
            where = _where_x_points(context, link)
            if where and not _is_rotated(sensor.find("pose")):
                message = f"{sensor.who} looks along x of '{link}', {where}"
                help = "refer to the camera's link, and name the optical frame in the plugin"
                yield Finding(sensor.at, message, help)
            continue
        if any(part.tag == _OF_IMAGES and part.text.strip() != link for part in sensor.at.walk()):
            continue
        parents = (sensor.at, *sensor.plugins)
        for frame in (at for parent in parents for tag in _FRAME_IDS for at in parent.all(tag)):
            if frame.text.strip() == link:
                yield Finding(
                    frame,
                    f"{sensor.who}: images are published with frame_id '{link}', which is "
                    "x-forward",
                    "name an optical frame: a child link with rpy -1.5708 0 -1.5708",
                    severity=Severity.INFO,
                )


def _where_x_points(context: Context, optical: str) -> str:
    """Where a sensor on an optical frame looks; empty if the frame is not turned as one."""
    for joint in context.tree.parents.get(optical, ()):
        rotation = joint.origin.rotation
        if rotate(rotation, Z_AXIS)[0] > _ALONG:
            return "to the robot's right"
        if _is_square(rotation) and rotation[0][0] < _ALONG:
            return "not along z, as an optical frame does"
    return ""


def _is_rotated(pose: Element | None) -> bool:
    values = numbers(pose.text) if pose else None
    return values is not None and any(abs(angle) > 1e-6 for angle in values[3:])


def _is_z_down(context: Context, camera: str) -> bool:
    """True if z of a camera's frame points down, or may do so as in all frames of the vehicle."""
    if _has_z_down(context, camera):
        return True
    words = {word for name in context.model.links_by_name for word in name.lower().split("_")}
    return any(word.rstrip("0123456789") in _UNDER_WATER for word in words)


def _has_z_down(context: Context, camera: str) -> bool:
    frame = context.tree.frames.get(camera)
    return frame is not None and frame.rotation[2][2] < 0


def _has_sensor(context: Context, link: str) -> bool:
    """True if a sensor of Gazebo is on a link: it looks along x, and a fix would rotate it."""
    blocks = (block for block in context.model.gazebo if block.get("reference") == link)
    return any(block.child("sensor") for block in blocks)


def _is_view_of_gazebo(context: Context, optical: str) -> bool:
    """True if a camera of Gazebo is rotated on an optical frame so that it looks along its z."""
    from urdfkit.ros.gazebo.sensors import sensors

    poses = (one.find("pose") for one in sensors(context.model) if one.reference == optical)
    turns = (values[3:] for pose in poses if pose and (values := numbers(pose.text)))
    return any(
        len(turn) == 3 and _is_near(multiply(from_rpy(*turn), _OPTICAL), IDENTITY) for turn in turns
    )


def _is_of_one_camera(camera: str, optical: str) -> bool:
    """True if two names differ only in the last words, as camera_link, camera_optical_frame."""
    stem, word, _ = optical.partition("optical")
    stem = stem.rstrip("_")
    if not word or not stem or "optical" in camera:
        return False
    return camera.startswith(stem) or stem == camera.removesuffix("_link").removesuffix("_frame")


def _is_square(rotation: Rotation) -> bool:
    """True for multiples of 90 degrees; other angles may be the tilt of the camera."""
    return all(min(abs(v), abs(1 - abs(v))) < _TOLERANCE for row in rotation for v in row)


def _is_near(one: Rotation, other: Rotation) -> bool:
    rows = zip(one, other, strict=True)
    pairs = (pair for row, line in rows for pair in zip(row, line, strict=True))
    return all(abs(a - b) < _TOLERANCE for a, b in pairs)


def _forward(rotation: Rotation) -> str:
    """Direction of z of a square rotation, in the frame of the camera."""
    z = tuple(row[2] for row in rotation)
    axis = max(range(3), key=lambda i: abs(z[i]))
    names = ("backward", "to the right", "down"), ("forward, but rotated,", "to the left", "up")
    return names[z[axis] > 0][axis]


def _fix(joint: Joint) -> Fix | None:
    origin = joint.at.child("origin")
    rpy = origin.attributes.get("rpy") if origin else None
    if rpy is None:
        return None
    # The digits of the file, if it has a right angle with as many.
    written = (value.lstrip("+-") for value in rpy.value.split())
    angle = next((text for text in written if abs(float(text) - pi / 2) < 1e-7), "1.5707963")
    return fix_value(rpy, f"-{angle} 0 -{angle}")
