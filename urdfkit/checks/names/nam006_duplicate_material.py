"""Two materials below `<robot>` have the same name.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio) and Drake refuse the whole robot, even if both have the
same colour. It happens when two included files define the same palette. Keep one of them.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    IntelRealSense/realsense-ros#2282: https://github.com/IntelRealSense/realsense-ros/issues/2282
    ros-industrial/motoman#314: https://github.com/ros-industrial/motoman/issues/314
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Related, Severity
from urdfkit.text.document import Element

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<material name="blue"><color rgba="0 0 1 1"/></material>
<material name="blue"><color rgba="0 0 0.8 1"/></material>
<link name="base"/>"""
GOOD = """\
<material name="blue"><color rgba="0 0 1 1"/></material>
<link name="base"/>"""


@rule("NAM006", "duplicate-material", Severity.ERROR, help="keep one of them")
def check(subject: Subject) -> Iterator[Finding]:
    first: dict[str, Element] = {}
    for material in subject.model.materials:
        name = material.at.attributes.get("name")
        if name is None:
            continue
        if name.value in first:
            related = (Related(first[name.value].span, "the first"),)
            message = f"material '{name.value}' is defined again"
            yield Finding(name, message, related=related, alike="again")
        first.setdefault(name.value, material.at)
