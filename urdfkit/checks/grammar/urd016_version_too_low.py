"""The robot uses what a later version of URDF brought, without asking for that version.

A `<capsule>` then counts as no shape, and urdfdom (RViz, MoveIt, Gazebo, Pinocchio) drops every
visual and collision of the link; a `quat_xyzw` is passed over, and the part is not turned. Build
the capsule from a cylinder and two spheres and write `rpy`, which every reader knows, or ask for
the version, which urdfdom 3 refuses. MuJoCo and Drake read a `<capsule>` of any version, and where
they are the only targets it is not reported.

Sources:
    ros/urdfdom#238: https://github.com/ros/urdfdom/issues/238
    gazebosim/sdformat#1654: https://github.com/gazebosim/sdformat/issues/1654
    Drake, geometry of URDF: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_geometry.cc
    MuJoCo, xml_urdf.cc: https://github.com/google-deepmind/mujoco/blob/main/src/xml/xml_urdf.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity
from urdfkit.text.grammar import owner, version_of

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <collision>
    <geometry><capsule radius="0.05" length="0.3"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace("capsule", "cylinder")


@rule("URD016", "version-too-low", Severity.ERROR)
def check(subject: Subject) -> Iterator[Finding]:
    version = version_of(subject.document.root)
    for element, attribute, _, since in subject.deviations.get("URD016", ()):
        if element.tag == "capsule" and subject.targets.are_only("mujoco", "drake"):
            continue
        what = f"<{element.tag}>" if attribute is None else attribute.name
        yield Finding(
            attribute or element,
            f"{owner(element)}: {what} came with URDF {since}, and the robot is URDF {version}",
            f'use what URDF 1.0 has, or write <robot version="{since}">',
        )
