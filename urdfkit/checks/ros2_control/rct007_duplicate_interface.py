"""An interface of a joint, or the name of a `<ros2_control>` block, is declared twice.

From ROS 2 Jazzy on, the controller manager stops at the second interface: "Tried to insert
CommandInterface with already existing key". In Humble only one of the two is used. Usually the
blocks for the real hardware and for the simulation are both active: choose one with a xacro
argument.

A joint that is declared twice in one block is often the copy of another one, whose name was not
changed.

Two blocks have the same name (warning): the controller manager reports "Hardware name is
duplicated" and starts without the second; the control plugins of Gazebo do not check this. A macro
that is called for two arms must also add its prefix to the name of the block.

Sources:
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
"""

from __future__ import annotations

from itertools import chain

from urdfkit.core.grouping import repeated
from urdfkit.core.record import Record
from urdfkit.core.suggest import nearest
from urdfkit.core.words import few
from urdfkit.lint.empty_arguments import prefixes_to_pass
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.gazebo.samples import SHOULDER, control_xml, driven_xml
from urdfkit.ros.ros_control import Component, ControlPart, Interface, components
from urdfkit.text.grammar import is_expression

BAD = robot_xml(
    SHOULDER,
    control_xml("mock_components/GenericSystem", driven_xml("shoulder")),
    control_xml("mock_components/GenericSystem", driven_xml("shoulder"), name="arm_sim"),
)
GOOD = BAD[: BAD.index('<ros2_control name="arm_sim"')]

#: Joints that a message names.
_MAX_NAMED = 3


@rule(Severity.ERROR, help="keep one of the two")
def check(context: Context) -> Findings:
    blocks, to_pass = components(context.model), prefixes_to_pass(context)
    undeclared = _undeclared(context, blocks)
    for finding in chain(_duplicate_names(blocks), _duplicate_interfaces(blocks, undeclared)):
        if to_pass:
            yield finding._replace(help=to_pass, severity=Severity.WARNING)
        else:
            yield finding


def _duplicate_names(blocks: list[Component]) -> Findings:
    keyed = ((block.name, block) for block in blocks)
    for block, first in repeated(pair for pair in keyed if pair[0] and not is_expression(pair[0])):
        yield Finding(
            block.at.attributes["name"],
            f"duplicate <ros2_control> name '{block.name}'",
            "give each <ros2_control> a unique name",
            related=(Related(first.at.span, "first defined here"),),
            severity=Severity.WARNING,
        )


def _undeclared(context: Context, blocks: list[Component]) -> set[str]:
    """The names of the joints that move by themselves and are in no block."""
    moving = {joint.name for joint in context.model.joints if joint.is_single_dof}
    followers = {joint.name for joint in context.model.joints if joint.mimic}
    return moving - followers - {part.name for block in blocks for part in block.joints}


def _duplicate_interfaces(blocks: list[Component], undeclared: set[str]) -> Findings:
    """One finding for two blocks, or for each joint with a duplicate interface in one block."""
    first: dict[tuple[str, ...], tuple[int, Interface]] = {}
    duplicates: dict[tuple[int, int], dict[str, _Duplicate]] = {}
    for number, component in enumerate(blocks):
        for part in component.parts:
            for interface in part.interfaces if part.name else ():
                # Drivers distinguish a <sensor> and a <gpio> of the same name.
                key = (part.kind, part.name, interface.direction, interface.name)
                before, known = first.setdefault(key, (number, interface))
                if interface.name and known is not interface:
                    duplicate = _Duplicate(part, interface, known)
                    duplicates.setdefault((number, before), {}).setdefault(part.name, duplicate)
    for (number, before), parts in duplicates.items():
        if number != before and len(parts) > 1:
            yield _duplicate_block(blocks[number], blocks[before], list(parts))
        else:
            for name, duplicate in parts.items():
                # A block that was copied within its component, and not renamed.
                is_copy = number == before and duplicate.part.kind == "joint"
                intended = nearest(name, undeclared) if is_copy else None
                yield _duplicate(duplicate, blocks[before], intended)


class _Duplicate(Record):
    part: ControlPart
    interface: Interface
    first: Interface


def _duplicate_block(block: Component, first: Component, names: list[str]) -> Finding:
    shown = few([f"'{name}'" for name in names], _MAX_NAMED)
    return Finding(
        block.at,
        f"{block.called} declares interfaces of {shown} that are already declared",
        "keep one of the two blocks, chosen by a xacro argument",
        related=(Related(first.at.span, f"first declared here, in {first.called}"),),
    )


def _duplicate(duplicate: _Duplicate, first: Component, intended: str | None) -> Finding:
    part, interface = duplicate.part, duplicate.interface
    return Finding(
        interface.at,
        f"{part.kind} '{part.name}': {interface.direction} interface '{interface.name}' is "
        "declared twice",
        f"name one of the two '{intended}', which is not declared" if intended else "",
        related=(Related(duplicate.first.at.span, f"first declared here, in {first.called}"),),
        group_key=first.called,
    )
