"""An optical frame does not look where its camera looks.

The frame of a camera has x forwards, y to the left and z up; its optical frame has z forwards, x to
the right and y down. The way from the one to the other is rpy="-pi/2 0 -pi/2". With another one
images, point clouds and detections appear beside, above or behind the robot; with rpy="pi/2 0 pi/2"
they are upside down. That one is right where z of the camera's frame points down: a camera mounted
head down, and a vehicle under water.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from urdfkit.core.spatial import Rotation
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.model import Joint
from urdfkit.text.diagnostic import Confidence, Fix, Severity
from urdfkit.text.editing.edits import replace_value

BAD = """\
<link name="camera_link"/>
<link name="camera_optical_frame"/>
<joint name="optical_joint" type="fixed">
  <parent link="camera_link"/>
  <child link="camera_optical_frame"/>
  <origin rpy="1.5707963 0 -1.5707963"/>
</joint>"""
FIXED = GOOD = BAD.replace('"1.5707963 0 -1.5707963"', '"-1.5707963 0 -1.5707963"')

#: From the frame of a camera to its optical frame; its columns are the optical axes.
_OPTICAL: Rotation = ((0.0, 0.0, 1.0), (-1.0, 0.0, 0.0), (0.0, -1.0, 0.0))
#: The same where z points down, as vehicles under water have it, or a camera mounted head down.
_OPTICAL_DOWN: Rotation = ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
#: Words in the names of cameras that do not look forwards, whatever their frame does.
_ELSEWHERE = ("down", "bottom", "belly", "nadir", "upward", "ceiling")
#: Words in the names of links of vehicles under water, some of which have z down everywhere.
_UNDER_WATER = ("thruster", "dvl", "sonar", "ned", "auv", "rov", "uuv", "rexrov")
#: People write pi with four digits.
_TOLERANCE = 0.01


@rule(Severity.WARNING)
def check(subject: Subject) -> Findings:
    for joint in subject.model.joints:
        if joint.kind != "fixed" or joint.parent is None or joint.child is None:
            continue
        above, below = joint.parent.value.lower(), joint.child.value.lower()
        # Between two optical frames, and on a link that is no frame of a camera, anything goes.
        if "optical" not in below or "optical" in above or not _is_of_one_camera(above, below):
            continue
        rotation = joint.origin.rotation
        is_turned_over = _is_near(rotation, _OPTICAL_DOWN)
        is_meant = _is_near(rotation, _OPTICAL) or (
            is_turned_over and _is_z_down(subject, joint.parent.value)
        )
        if _is_square(rotation) and not is_meant and not _looks_elsewhere(below):
            origin = joint.at.child("origin")
            way = "forwards, but upside down," if is_turned_over else _way(rotation)
            yield Finding(
                origin or joint.at,
                f"joint '{joint.name}': '{joint.child.value}' looks {way} from "
                f"'{joint.parent.value}'; an optical frame looks forwards, its x to the right",
                'write rpy="-1.5707963 0 -1.5707963"',
                None if _sees_along(joint.child.value, subject) else _fix(joint),
                confidence=Confidence.INFERRED,
            )


def _looks_elsewhere(name: str) -> bool:
    return any(word.startswith(_ELSEWHERE) for word in name.split("_"))


def _is_z_down(subject: Subject, camera: str) -> bool:
    """True if z of a camera's frame points down: it hangs so, or all frames of the robot may."""
    frame = subject.tree.frames.get(camera)
    if frame is not None and frame.rotation[2][2] < 0:
        return True
    words = {word for name in subject.model.links_by_name for word in name.lower().split("_")}
    return any(word.rstrip("0123456789") in _UNDER_WATER for word in words)


def _sees_along(link: str, subject: Subject) -> bool:
    """True if a sensor of Gazebo is on a link: it looks along x, and would be turned away."""
    blocks = (block for block in subject.model.gazebo if block.get("reference") == link)
    return any(block.child("sensor") for block in blocks)


def _is_of_one_camera(above: str, below: str) -> bool:
    """True for ``camera_link`` and ``camera_optical_frame``: one name without its last words."""
    stem = below.partition("optical")[0].rstrip("_")
    trunk = above.removesuffix("_link").removesuffix("_frame")
    return bool(stem) and (stem == trunk or above.startswith(stem))


def _is_square(rotation: Rotation) -> bool:
    """True if every axis lies on an axis: a camera that is tilted may be tilted here."""
    return all(min(abs(v), abs(1 - abs(v))) < _TOLERANCE for row in rotation for v in row)


def _is_near(one: Rotation, other: Rotation) -> bool:
    rows = zip(one, other, strict=True)
    pairs = (pair for row, line in rows for pair in zip(row, line, strict=True))
    return all(abs(a - b) < _TOLERANCE for a, b in pairs)


def _way(rotation: Rotation) -> str:
    """Where its z points, in the frame of the camera."""
    z = tuple(row[2] for row in rotation)
    axis = max(range(3), key=lambda i: abs(z[i]))
    sign = z[axis] > 0
    ways = ("backwards", "to the right", "down"), ("forwards, but turned,", "to the left", "up")
    return ways[sign][axis]


def _fix(joint: Joint) -> Fix | None:
    origin = joint.at.child("origin")
    rpy = origin.attributes.get("rpy") if origin else None
    edits = replace_value(rpy, "-1.5707963 0 -1.5707963") if rpy else None
    return Fix.of("turn it as an optical frame", edits)
