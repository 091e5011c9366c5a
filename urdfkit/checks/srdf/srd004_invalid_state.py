"""A named state sets a joint outside its limits or a fixed joint, or has a duplicate name.

- MoveIt does not plan to a state outside the limits: "goal state is out of bounds". The limits were
  changed after the state was written, or the value is in degrees. Limits of another robot of the
  same name that a launch file starts count, too. A warning if the SRDF has no groups: Pinocchio,
  which alone reads such a state, compares nothing.
- A fixed joint has no position: MoveIt and Pinocchio ignore the value, and set the other joints of
  the state (warning). Mimic joints are not reported: a state may repeat their values.
- One of three or more states of a group does not set a joint that all others set (warning): the
  joint keeps its position, or is at 0, so that the pose is another one.
- If two states of a group have the same name, MoveIt silently keeps the last (warning).

Sources:
    SRDF: https://wiki.ros.org/srdf
    MoveIt, URDF and SRDF: https://moveit.picknik.ai/main/doc/examples/urdf_srdf/urdf_srdf_tutorial.html
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from collections.abc import Iterable

from urdfkit.checks.srdf.namesakes import launched_namesakes
from urdfkit.core.grouping import by_key, repeated
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.values import number
from urdfkit.ros.gazebo.samples import SHOULDER
from urdfkit.ros.moveit.samples import named_xml, srdf_files
from urdfkit.text.document import Element

_STATE = """\
<group name="arm"><joint name="shoulder"/></group>
<group_state name="up" group="arm"><joint name="shoulder" value="VALUE"/></group_state>"""
BAD = named_xml("bad", SHOULDER)
GOOD = BAD.replace('"bad"', '"good"')
FILES = srdf_files(_STATE.replace("VALUE", "1.57"), _STATE.replace("VALUE", "0.9"))

#: MoveIt's own tolerance is larger; rounded values such as 1.57 for pi/2 pass.
_ROUNDING = 1e-3

#: Least number of complete states of a group next to one that lacks a joint.
_CONSISTENT_STATES = 2


@rule(Severity.ERROR, needs=(Need.MODEL, Need.SRDF))
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    found = [
        (element, finding)
        for state in srdf.states
        for element in state.all("joint")
        for finding in _value(f"state '{state.get('name')}'", element, context)
    ]
    namesakes = list(launched_namesakes(context, srdf)) if found else []
    for element, finding in found:
        if not any(_fits(element, robot) for robot in namesakes):
            # Only Pinocchio reads the states of an SRDF without groups, with any values.
            yield finding if srdf.groups else finding._replace(severity=Severity.WARNING)
    yield from _duplicates(srdf.states)
    yield from _incomplete(srdf.states)


def _fits(element: Element, robot: Context) -> bool:
    """True for another robot, which the state may be for, whose joint takes this value."""
    is_there = element.get("name") in robot.model.joints_by_name
    return is_there and not any(_value("", element, robot))


def _value(state: str, element: Element, robot: Context) -> Findings:
    joint = robot.model.joints_by_name.get(element.get("name") or "")
    if joint is None:
        return  # SRD001
    who, value = f"{state}: joint '{joint.name}'", number(element.get("value"))
    if joint.kind == "fixed":
        yield Finding(
            element, f"{who} is fixed", "remove the joint from the state", severity=Severity.WARNING
        )
    limit = joint.limit if joint.kind in ("revolute", "prismatic") else None
    if value is None or limit is None or limit.lower is None or limit.upper is None:
        return
    lower, upper = limit.lower.value, limit.upper.value
    if not lower - _ROUNDING <= value <= upper + _ROUNDING:
        yield Finding(
            element,
            f"{who}: {value:g} {joint.unit} is outside its limits "
            f"[{lower:g}, {upper:g}] {joint.unit}",
            "write a value within the limits",
        )


def _incomplete(states: Iterable[Element]) -> Findings:
    """The only state of a group that lacks one of the joints that all others set."""
    for of_group in by_key((state.get("group"), state) for state in states).values():
        names = [{joint.get("name") for joint in state.all("joint")} for state in of_group]
        every = set().union(*names)
        lacking = [(state, every - own) for state, own in zip(of_group, names, strict=True)]
        lacking = [(state, missing) for state, missing in lacking if missing]
        if len(of_group) <= _CONSISTENT_STATES or len(lacking) != 1 or len(lacking[0][1]) != 1:
            continue
        ((state, (name,)),) = lacking
        yield Finding(
            state,
            f"state '{state.get('name')}' does not set joint '{name}', which the other "
            f"{len(of_group) - 1} states of group '{state.get('group')}' set",
            "add the joint",
            severity=Severity.WARNING,
        )


def _duplicates(states: Iterable[Element]) -> Findings:
    named = (((state.get("name"), state.get("group")), state) for state in states)
    for state, before in repeated(entry for entry in named if entry[0][0]):
        yield Finding(
            state,
            f"duplicate state '{state.get('name')}' of group '{state.get('group')}': MoveIt keeps "
            "the last",
            "give each state a unique name",
            related=(Related(before.span, "first defined here"),),
            severity=Severity.WARNING,
        )
