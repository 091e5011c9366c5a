"""MoveIt has settings for a planning group that the SRDF does not have.

The real group is left without a solver ("No kinematics plugins defined"), or plans with defaults.
The group was renamed in one of the files, or the name is misspelt. Read are `kinematics.yaml` and
`ompl_planning.yaml`.

Sources:
    MoveIt, kinematics: https://moveit.picknik.ai/main/doc/examples/kinematics_configuration/kinematics_configuration_tutorial.html
    MoveIt, OMPL: https://moveit.picknik.ai/main/doc/examples/ompl_interface/ompl_interface_tutorial.html
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.ros.moveit.config import group_entries
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="bad">
  <link name="base"/>
  <link name="arm"/>
  <joint name="shoulder" type="continuous">
    <parent link="base"/>
    <child link="arm"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
_SRDF = b"""\
<robot name="bad">
  <group name="arm"><chain base_link="base" tip_link="arm"/></group>
</robot>
"""
FILES = {
    "bad.srdf": _SRDF,
    "good.srdf": _SRDF.replace(b'"arm"><', b'"manipulator"><').replace(b"bad", b"good"),
    "kinematics.yaml": b"""\
manipulator:
  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin
""",
}


@rule(
    "SRD020",
    "settings-of-unknown-group",
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="give the settings the name of a group of the SRDF",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    known = srdf.known("group")
    entries = list(group_entries(srdf, subject.resolver))
    for entry in entries:
        # Several groups none of which is there are those of another robot.
        is_ours = entry.is_alone or any(other.name in known for other in entries)
        if known and entry.name not in known and is_ours:
            message = f"the SRDF has no group '{entry.name}'{did_you_mean(entry.name, known)}"
            yield Finding(Location(entry.name.span), message)
