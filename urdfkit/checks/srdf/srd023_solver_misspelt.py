"""The kinematics solver of a group is misspelt.

MoveIt loads no such plugin: "The kinematics plugin (arm) failed to load", and the group cannot be
moved to a pose. Solvers that urdfkit does not know are assumed to be in the workspace.

Sources:
    MoveIt, kinematics: https://moveit.picknik.ai/main/doc/examples/kinematics_configuration/kinematics_configuration_tutorial.html
"""

from __future__ import annotations

from urdfkit.core.suggest import nearest
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, Need, rule
from urdfkit.ros.moveit.config import group_entries
from urdfkit.text.diagnostic import Severity
from urdfkit.text.located_yaml import Value

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
arm:
  kinematics_solver: kdl_kinematics_plugin/KDLKinematicPlugin
manipulator:
  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin
""",
}

_KNOWN = (
    "bio_ik/BioIKKinematicsPlugin",
    "cached_ik_kinematics_plugin/CachedKDLKinematicsPlugin",
    "cached_ik_kinematics_plugin/CachedSrvKinematicsPlugin",
    "cached_ik_kinematics_plugin/CachedTRACKinematicsPlugin",
    "cached_ik_kinematics_plugin/CachedUR10KinematicsPlugin",
    "cached_ik_kinematics_plugin/CachedUR3KinematicsPlugin",
    "cached_ik_kinematics_plugin/CachedUR5KinematicsPlugin",
    "kdl_kinematics_plugin/KDLKinematicsPlugin",
    "lma_kinematics_plugin/LMAKinematicsPlugin",
    "pick_ik/PickIkPlugin",
    "prbt_manipulator/IKFastKinematicsPlugin",
    "srv_kinematics_plugin/SrvKinematicsPlugin",
    "trac_ik_kinematics_plugin/TRAC_IKKinematicsPlugin",
    "ur_kinematics/UR10KinematicsPlugin",
    "ur_kinematics/UR3KinematicsPlugin",
    "ur_kinematics/UR5KinematicsPlugin",
)
#: The plugins of IKFast are named after the robot, and are similar.
_OF_ROBOTS = "IKFast"
_TYPO = 0.93


@rule(Severity.ERROR, needs=(Need.MODEL, Need.SRDF))
def check(subject: Subject) -> Findings:
    srdf = subject.srdf
    for entry in group_entries(srdf, subject.resolver) if srdf else ():
        solver = entry.values.get("kinematics_solver")
        if srdf is None or entry.name not in srdf.known("group") or not isinstance(solver, Value):
            continue
        if solver.text in _KNOWN or _OF_ROBOTS in solver.text:
            continue
        if suggested := nearest(solver.text, _KNOWN, _TYPO):
            message = (
                f"group '{entry.name}': unknown solver '{solver.text}'; did you mean '{suggested}'?"
            )
            yield Finding(Location(solver.span), message, f"write {suggested}")
