"""The URDF version does not exist, is too new for older parsers, or too low for the elements used.

`version` is the version of the format, not of your robot: 1.0, 1.1 or 1.2; the default is 1.0.
urdfdom (RViz, MoveIt, Gazebo, Pinocchio) rejects any other text.

Version 1.1 brought capsules and quaternions, 1.2 more joint limits. urdfdom 6 reads them; urdfdom
3.0.1, the version in Debian 12, rejects the robot: a warning. In a robot of version 1.0 a
`<capsule>` is not a shape, and urdfdom drops every visual and collision of the link; `quat_xyzw` is
ignored, and the part is not rotated. Build the capsule from a cylinder and two spheres and write
`rpy`, which every parser reads, or declare the version. MuJoCo, Drake and PyBullet read a
`<capsule>` in any version; if they are the only targets, it is not reported.

In version 1.1 and later, urdfdom rejects an `<origin>` with both `rpy` and `quat_xyzw`. MuJoCo,
Drake, PyBullet, Newton and yourdfpy ignore `quat_xyzw` in any version: an error for these targets.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    ros/urdfdom#238: https://github.com/ros/urdfdom/issues/238
    gazebosim/sdformat#1654: https://github.com/gazebosim/sdformat/issues/1654
    Drake, geometry of URDF: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_geometry.cc
    MuJoCo, xml_urdf.cc: https://github.com/google-deepmind/mujoco/blob/main/src/xml/xml_urdf.cc
"""

from urdfkit.core.spatial import from_quaternion, to_rpy
from urdfkit.core.words import listed, rounded
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.values import numbers
from urdfkit.ros.targets import facts_of
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.grammar import owner, version_of
from urdfkit.text.schema import VERSIONS

BAD = '<robot name="cart" version="2.3">\n  <link name="base"/>\n</robot>\n'
GOOD = BAD.replace(' version="2.3"', "")
FIXED = BAD.replace("2.3", "1.0")

_WITH_ORIGIN = ("inertial", "visual", "collision", "joint")


@rule(Severity.ERROR)
def check(context: Context) -> Findings:
    version = version_of(context.document.root)
    for element, attribute, _, since in context.deviations.get("URD011", ()):
        if not since:
            assert attribute is not None
            yield _declared(attribute, version)
            if version in VERSIONS:
                yield from _quaternions(context)
        elif element.tag != "capsule" or not context.targets.all_are("reads_capsules"):
            what = f"<{element.tag}>" if attribute is None else attribute.name
            help = f'use what URDF 1.0 has, or write <robot version="{since}">'
            if element.tag == "capsule" and "length" not in element.attributes:
                help = "build it from a cylinder and two spheres"  # no version has this capsule
            message = (
                f"{owner(element)}: {what} needs URDF {since}, and the robot is URDF {version}"
            )
            yield Finding(attribute or element, message, help, group_key=f"{what} {help}")


def _declared(attribute: Attribute, version: str) -> Finding:
    """A version that does not exist, or that some parsers reject."""
    if version in VERSIONS:
        message = f"URDF version {version} is rejected by older parsers"
        help = 'write version="1.0" unless the robot needs more'
        return Finding(attribute, message, help, severity=Severity.WARNING)
    message = f"URDF version '{attribute.value}' does not exist; there are {', '.join(VERSIONS)}"
    help = 'leave it out, or write version="1.0"'
    return Finding(attribute, message, help, fix_value(attribute, VERSIONS[0]))


def _quaternions(context: Context) -> Findings:
    """Quaternions that urdfdom rejects, or that a target ignores."""
    titles = [facts_of(name).title for name in context.targets.that("ignores_quaternions")]
    for origin in context.document.root.walk():
        quaternion = origin.attributes.get("quat_xyzw") if origin.tag == "origin" else None
        if quaternion is None or origin.parent is None or origin.parent.tag not in _WITH_ORIGIN:
            continue
        what = f"{owner(origin)}: quat_xyzw of <origin>"
        if "rpy" in origin.attributes and not context.targets.all_are("ignores_quaternions"):
            message = f"{what} stands next to rpy, which urdfdom rejects"
            yield Finding(quaternion, message, "remove one of them")
        elif titles and "rpy" not in origin.attributes:
            values = numbers(quaternion.value) or ()
            rpy = rounded(to_rpy(from_quaternion(*values)), 9) if len(values) == 4 else "..."
            message = f"{what} is ignored by {listed(titles)}"
            yield Finding(quaternion, message, f'write rpy="{rpy}", which every parser reads')
