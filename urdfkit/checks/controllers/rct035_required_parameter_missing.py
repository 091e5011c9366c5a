"""A controller lacks a parameter without which it does not start.

A drive controller needs the names of its wheels, a trajectory controller its joints and interfaces.
Without them it is not configured: "'joints' parameter was empty". Only controllers are reported
whose parameters stand in a file that is at hand.

Sources:
    ros2_controllers: https://github.com/ros-controls/ros2_controllers
    ros_controllers: https://github.com/ros-controls/ros_controllers
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, Location, rule
from urdfkit.ros.catalog.controllers import parameters_of
from urdfkit.ros.controllers import Controller, Section, controllers, named_sections
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
      type: forward_command_controller/ForwardCommandController
arm:
  ros__parameters:
    joints: [shoulder]
    interface_name: position
"""
FILES = {
    "config/bad.yaml": _YAML.replace(b"    interface_name: position\n", b""),
    "config/good.yaml": _YAML,
}

#: How like a name another must be to be a slip of it, which is RCT027.
_TYPO = 0.88


@rule("RCT035", "required-parameter-missing", Severity.ERROR)
def check(subject: Subject) -> Iterator[Finding]:
    everywhere = named_sections(subject)
    for file, found in controllers(subject):
        names = {one.name for one in found}
        for one in found:
            own = everywhere.get(one.name, one.section)
            if reported := _reported(
                one, own, {n: s for n, s in everywhere.items() if n not in names}
            ):
                at, message, help = reported
                yield Finding(Location(at), message, help, related=(file.note,))


def _reported(
    controller: Controller, own: Section, others: dict[str, Section]
) -> tuple[Span, str, str] | None:
    """Place, message and remedy for a controller that lacks parameters."""
    known = parameters_of(controller.type, controller.ros)
    required = known.required if known else ()
    missing = [name for name in required if name not in own.places]
    lacks = [name for name in missing if not nearest(name, own.places, _TYPO)]
    who = f"controller '{controller.name}' ({controller.type}) lacks {', '.join(lacks)}"
    if lacks and own.at:
        return own.at, who, "add " + " and ".join(f"{name}: ..." for name in lacks)
    if lacks:  # it has no parameters at all: they may stand in another file, or under another name
        homeless = [n for n, section in others.items() if section.places.keys() >= set(required)]
        if len(homeless) == 1 and (at := others[homeless[0]].at):
            message = f"{who}; '{homeless[0]}' has them, and is no controller"
            return at, message, f"rename it to {controller.name}, or the controller"
    return None
