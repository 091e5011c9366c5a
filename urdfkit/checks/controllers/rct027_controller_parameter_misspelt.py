"""The type of a controller or the name of one of its parameters is misspelt.

The controller manager does not find the class, or the controller takes a default for what the
parameter was meant to set: a robot whose `wheel_seperation` is never read turns by the wrong angle.
Only slips of names that urdfkit knows are reported.

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, Location, rule
from urdfkit.ros.catalog.ros_control import controllers as catalogue
from urdfkit.ros.catalog.ros_control import parameters
from urdfkit.ros.controllers import Controller, controllers
from urdfkit.ros.gazebo.samples import ARM, CONTROL
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Span

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

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
    "config/bad.yaml": _YAML.replace(b"Position", b"Positon"),
    "config/good.yaml": _YAML,
}

#: How like a name a word must be to be taken for a slip of it.
_TYPO = 0.88


@rule("RCT027", "controller-parameter-misspelt", Severity.WARNING)
def check(subject: Subject) -> Iterator[Finding]:
    for file, found in controllers(subject):
        for controller in found:
            for span, word, suggested in _mistakes(controller):
                yield Finding(
                    Location(span),
                    f"controller '{controller.name}': '{word}' is nearly '{suggested}'",
                    f"write {suggested}",
                    related=(file.note,),
                )


def _mistakes(controller: Controller) -> Iterator[tuple[Span, str, str]]:
    known = catalogue()
    if controller.type not in known:
        suggested = nearest(controller.type, known, 0.93)
        if suggested:
            yield controller.type_at, controller.type, suggested
        return
    names = parameters(controller.type)
    for name in controller.parameters:
        suggested = nearest(name, names, _TYPO) if name not in names else None
        if suggested and suggested not in controller.parameters and len(suggested) > 4:
            yield controller.places[name], name, suggested
