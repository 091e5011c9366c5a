"""A part of a parameter file of controllers is not read.

The file is not YAML, `ros__parameters` is misspelt (two underscores), or parameters stand under a
name that no controller has. The controller then starts without its joints, and stops: "parameter
'joints' was not set".

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, rule
from urdfkit.ros.controllers import lost, unparsed
from urdfkit.ros.gazebo.samples import ARM, CONTROL
from urdfkit.text.diagnostic import Severity

BAD = ARM + CONTROL
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = b"""\
controller_manager:
  ros__parameters:
    arm:
      type: position_controllers/JointGroupPositionController
arm:
  ros__parameters:
    joints: [shoulder]
"""
FILES = {
    "config/bad.yaml": _YAML.replace(b"arm:\n  ros__parameters", b"arm:\n  ros_parameters"),
    "config/good.yaml": _YAML,
}


@rule(Severity.ERROR, help="fix the parameter file")
def check(subject: Subject) -> Findings:
    for file, span, reason in unparsed(subject):
        yield Finding(Location(span), f"invalid YAML: {reason}", related=(file.note,))
    for file, found in lost(subject):
        for span, message, help in found:
            yield Finding(Location(span), message, help, related=(file.note,))
