"""A visual is invisible.

Its colour has an alpha of 0, the fourth number of `rgba`: 0 is transparent, 1 is opaque. RViz shows
nothing. Write 1; or, if the link should be invisible, remove the `<visual>`, or call the material
`invisible`.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    RViz, robot_link.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_default_plugins/src/rviz_default_plugins/robot/robot_link.cpp
"""

from __future__ import annotations

import re

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.assets.colours import Colours
from urdfkit.text.diagnostic import Severity
from urdfkit.text.document import Attribute, Element

BAD = """\
<link name="base">
  <visual>
    <geometry><box size="0.1 0.1 0.1"/></geometry>
    <material name="grey"><color rgba="0.2 0.2 0.2 0"/></material>
  </visual>
</link>"""
GOOD = BAD.replace('0.2 0"', '0.2 1"')

_INTENDED = re.compile(r"invisible|transparent|hidden|none|clear|glass", re.IGNORECASE)


@rule(Severity.INFO, help="write 1 as the fourth number of rgba")
def check(subject: Subject) -> Findings:
    reported: set[Element | Attribute] = set()
    for link, _, material in Colours(subject.model).visuals():
        rgba, name = material.rgba, material.name.value if material.name else ""
        if rgba is None or material.texture or len(rgba.value) != 4 or rgba.value[3] > 0:
            continue
        if rgba.at not in reported and not _INTENDED.search(name):
            reported.add(rgba.at)
            called = f" '{name}'" if name else ""
            message = f"link '{link.name}': the material{called} of a visual has an alpha of 0"
            yield Finding(rgba, message)
