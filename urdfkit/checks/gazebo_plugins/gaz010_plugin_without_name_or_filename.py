"""A plugin has no `name`, or no `filename`.

SDF requires both: up to SDF 1.9 Gazebo refuses the whole model without them. The file name is that
of the library; the name is free in Gazebo Classic and the class in gz-sim.

Sources:
    sdformat, Plugin.cc: https://github.com/gazebosim/sdformat/blob/main/src/Plugin.cc
    moveit/moveit#3572: https://github.com/moveit/moveit/issues/3572
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Edit, Fix, Severity
from urdfkit.text.source import Span

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.ros.gazebo.plugins import PluginUse

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin filename="libgazebo_ros_planar_move.so"/>
</gazebo>"""
GOOD = BAD.replace("<plugin", '<plugin name="drive"')
FIXED = BAD.replace("<plugin", '<plugin name="gazebo_ros_planar_move"')


@rule(
    "GAZ010",
    "plugin-without-name-or-filename",
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        for attribute, what in (("name", "its name"), ("filename", "the file name of its library")):
            if not (use.at.get(attribute) or "").strip():
                other = use.filename if attribute == "name" else use.name and f"'{use.name}'"
                who = f"plugin {other}" if other else "a plugin"
                message = f"{who} has no {attribute}: Gazebo refuses the model"
                fix = _named(subject, use) if attribute == "name" else None
                yield Finding(use.at, message, f'add {attribute}="...", {what}', fix)


def _named(subject: Subject, use: PluginUse) -> Fix | None:
    """The name of the library for a plugin that has no attribute of that name, if it is free."""
    name = use.filename.removeprefix("lib").removesuffix(".so")
    taken = {other.name for other in subject.plugins}
    if "name" in use.at.attributes or not re.fullmatch(r"[a-z]\w*", name) or name in taken:
        return None
    source, _, end = use.at.tag_at.name_span
    return Fix(f'add name="{name}"', (Edit(Span(source, end, end), f' name="{name}"'),))
