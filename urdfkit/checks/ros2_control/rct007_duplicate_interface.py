"""An interface of a joint, or the name of a `<ros2_control>` block, is declared twice.

From ROS 2 Jazzy on the controller manager stops at the second interface: "Tried to insert
CommandInterface with already existing key". In Humble one of the two wins. Usually the block for
the real hardware and the one for the simulation are both active: choose one by a xacro argument.

Of two blocks with one name (warning) the controller manager reports "Hardware name is duplicated"
and starts without the second; only the control plugins of Gazebo do not check this. A macro that is
called for two arms must use its prefix in the name of the block, too.

Sources:
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.gazebo.samples import SHOULDER, control_xml, driven_xml
from urdfkit.ros.ros_control import Component, components
from urdfkit.text.grammar import is_expression

BAD = robot_xml(
    SHOULDER,
    control_xml("mock_components/GenericSystem", driven_xml("shoulder")),
    control_xml("mock_components/GenericSystem", driven_xml("shoulder"), name="arm_sim"),
)
GOOD = BAD[: BAD.index('<ros2_control name="arm_sim"')]


@rule(Severity.ERROR, help="keep one of them")
def check(context: Context) -> Findings:
    blocks = components(context.model)
    yield from _duplicate_names(blocks)
    yield from _duplicate_interfaces(blocks)


def _duplicate_names(blocks: list[Component]) -> Findings:
    first: dict[str, Component] = {}
    for component in blocks:
        name = component.name
        if not name or is_expression(name):
            continue
        if first.setdefault(name, component) is not component:
            yield Finding(
                component.at.attributes["name"],
                f"duplicate <ros2_control> name '{name}'",
                "give each <ros2_control> a unique name",
                related=(Related(first[name].at.span, "first defined here"),),
                severity=Severity.WARNING,
            )


def _duplicate_interfaces(blocks: list[Component]) -> Findings:
    """One finding for each joint: with two blocks, all of its interfaces are there twice."""
    first: dict[tuple[str, ...], Related] = {}
    reported: set[tuple[int, str]] = set()
    named = (
        (number, component, part, interface)
        for number, component in enumerate(blocks)
        for part in component.parts
        for interface in part.interfaces
        if part.name and interface.name
    )
    for number, component, part, interface in named:
        # Of one name, <sensor> and <gpio> are two things to the drivers that have both.
        key = (part.kind, part.name, interface.direction, interface.name)
        if key not in first:
            note = f"first declared here, in {component.called}"
            first[key] = Related(interface.at.span, note)
        elif (number, part.name) not in reported:
            reported.add((number, part.name))
            yield Finding(
                interface.at,
                f"{part.kind} '{part.name}': {interface.direction} interface "
                f"'{interface.name}' is declared twice",
                related=(first[key],),
                group_key=component.called,
            )
