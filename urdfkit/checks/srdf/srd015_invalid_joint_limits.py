"""A limit in MoveIt's joint_limits.yaml is invalid, missing, or wider than the robot's limit.

- The values override those of the URDF. With wider limits, MoveIt plans motions that the robot
  cannot follow: controllers abort with a path tolerance violation, or the hardware stops (warning).
  Limits of another robot of the same name that a launch file starts count, too: it may be the
  revision that the file is for.
- Parameters of ROS 2 are typed, and the limits are declared as `double`: an integer stops
  move_group ("parameter ... has invalid type: expected [double] got [integer]"). A number with a
  decimal comma is a string.
- A joint of a planning group has no acceleration limit, in ROS 2. The Setup Assistant writes
  `has_acceleration_limits: false`. Time parameterization and the Pilz planner fail: "No
  acceleration limit was defined for joint shoulder"; up to Humble the default is 1 rad/s².
- A maximum velocity, acceleration or jerk is not greater than zero, so that planning fails.
- The velocity of a joint looks like degrees per second: 45 or more, next to slow joints (warning).
- The name of a limit is misspelt, so that MoveIt ignores it.

Sources:
    MoveIt, joint limits: https://moveit.picknik.ai/main/doc/examples/time_parameterization/time_parameterization_tutorial.html
    agilexrobotics/piper_ros#17: https://github.com/agilexrobotics/piper_ros/issues/17
    MoveIt, robot_model_loader.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/robot_model_loader/src/robot_model_loader.cpp
    MoveIt, time parameterization: https://github.com/moveit/moveit2/blob/main/moveit_core/trajectory_processing/src/time_optimal_trajectory_generation.cpp
"""

from collections.abc import Iterator
from math import radians

from urdfkit.checks.srdf.namesakes import launched_namesakes
from urdfkit.core.suggest import CLOSE_TYPO, nearest
from urdfkit.core.words import few
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.samples import arm_xml
from urdfkit.ros.moveit.joint_limits import PlannedLimit, planned_limits
from urdfkit.ros.parameter_types import is_not_positive, type_of
from urdfkit.text.located_yaml import Key, Value
from urdfkit.workspace.manifest import manifest_of

BAD = arm_xml("prismatic", '<limit lower="0.1" upper="0.9" effort="500" velocity="0.1"/>')
GOOD = BAD.replace('velocity="0.1"', 'velocity="0.2"')
FILES = {
    "example.srdf": b'<robot name="example"/>',
    "joint_limits.yaml": b"joint_limits:\n  shoulder:\n    has_velocity_limits: true\n"
    b"    max_velocity: 0.2\n",
}

#: Relative: limits are often rounded to three digits.
TOLERANCE = 0.01
#: Velocities in rad/s: of motors in degrees per second, and of arms in radians.
_MIN_DEGREES, _MAX_SLOW = 45.0, 10.0
_POSITIVE = ("max_velocity", "max_acceleration", "max_jerk")
_LIMITS = ("min_position", "max_position", *_POSITIVE)
_OF_JOINT = ("position", "velocity", "acceleration", "deceleration", "jerk", "effort")
_KEYS = frozenset(
    f"{start}_{kind}{end}"
    for kind in _OF_JOINT
    for start, end in (("has", "_limits"), ("min", ""), ("max", ""))
)


@rule(Severity.WARNING, needs=(Need.MODEL, Need.SRDF))
def check(context: Context) -> Findings:
    yield from _missing_acceleration(context)
    wider: list[tuple[PlannedLimit, str, Finding]] = []
    for planned in planned_limits(context):
        if joint := context.model.joints_by_name.get(planned.joint):
            invalid = dict(_invalid(planned, context))
            yield from invalid.values()
            yield from _misspelt(planned)
            found = _wider(planned, joint)
            wider += [(planned, name, one) for name, one in found if name not in invalid]
    yield from _in_degrees(context)
    namesakes = list(launched_namesakes(context, context.required_srdf)) if wider else []
    for planned, name, finding in wider:
        if not any(_allows(robot, planned, name) for robot in namesakes):
            yield finding


def _allows(robot: Context, planned: PlannedLimit, name: str) -> bool:
    """True for another robot, which the file may be for, whose joint has this limit."""
    joint = robot.model.joints_by_name.get(planned.joint)
    return joint is not None and name not in dict(_wider(planned, joint))


def _missing_acceleration(context: Context) -> Findings:
    """Joints of groups without an acceleration limit, if the file contains limits."""
    srdf, planned = context.srdf, {limit.joint: limit for limit in planned_limits(context)}
    if srdf is None or not planned or _ros(context) != 2:
        return
    links = set().union(*map(srdf.links_of, srdf.groups_by_name))
    passive = {element.get("name") for element in srdf.root.all("passive_joint")}
    switch = "has_acceleration_limits"
    lacking = [
        joint
        for joint in context.model.joints
        if joint.is_single_dof and joint.child_name in links
        if joint.mimic is None and joint.name not in passive
        if not (joint.limit and joint.limit.at.get("acceleration"))
        if joint.name not in planned or not planned[joint.name].is_on(switch)
    ]
    if not lacking:
        return
    limit = next((planned[joint.name] for joint in lacking if joint.name in planned), None)
    at = limit.values.get(switch, limit.at) if limit else next(iter(planned.values())).at
    names = few([f"'{joint.name}'" for joint in lacking], 4)
    yield Finding(
        at.span,
        f"no acceleration limit for {'joint' if len(lacking) == 1 else 'joints'} {names}: MoveIt "
        "does not time a trajectory, or up to Humble takes 1 rad/s²",
        f"write {switch}: true and max_acceleration: VALUE for each",
    )


def _wider(planned: PlannedLimit, joint: Joint) -> Iterator[tuple[str, Finding]]:
    for name, value, allowed, measure in _compared(planned, joint):
        if _is_wider(name, value, allowed):
            limit, at = joint.limit, planned.values[name].span
            message = f"joint '{joint.name}': {name} {value:g} {measure} exceeds the limit of the "
            message += f"robot, {allowed:g} {measure}"
            related = (Related(limit.at.span, "limit of the robot"),) if limit else ()
            help, key = "use the narrower limit in both files", f"{name} {value:g} {allowed:g}"
            yield name, Finding(at, message, help, None, related, group_key=key)


def _invalid(planned: PlannedLimit, context: Context) -> Iterator[tuple[str, Finding]]:
    for name in _LIMITS:
        is_on = planned.is_on(f"has_{name[4:]}_limits")
        value = planned.values.get(name) if is_on else None
        if value is not None and (invalid := _error_in(name, value, _ros(context))):
            message, help = invalid
            message = f"joint '{planned.joint}': {message}"
            at = value.span
            yield name, Finding(at, message, help, severity=Severity.ERROR)


def _in_degrees(context: Context) -> Findings:
    """Velocities in degrees per second, next to joints whose velocities are in radians."""
    speeds = [
        (planned, speed)
        for planned in planned_limits(context)
        if (joint := context.model.joints_by_name.get(planned.joint)) and joint.is_rotational
        if not (joint.limit and joint.limit.velocity and joint.limit.velocity.value > 0)  # wider
        if (speed := planned.bound("max_velocity", "has_velocity_limits"))
    ]
    fast = [(planned, speed) for planned, speed in speeds if speed >= _MIN_DEGREES]
    slow = [speed for _, speed in speeds if speed < _MIN_DEGREES]
    if len(slow) < 2 or max(slow) > _MAX_SLOW:
        return
    for planned, speed in fast:
        yield Finding(
            planned.values["max_velocity"].span,
            f"joint '{planned.joint}': max_velocity {speed:g} rad/s looks like degrees per second; "
            f"the other joints have at most {max(slow):g} rad/s",
            f"write {radians(speed):.4g}, if it is in degrees per second",
            confidence=Confidence.INFERRED,
        )


def _misspelt(planned: PlannedLimit) -> Findings:
    """Names that MoveIt does not read, and that are almost one that it reads."""
    for name in planned.values:
        suggested = None if name in _KEYS else nearest(name, _KEYS, CLOSE_TYPO)
        if suggested and suggested not in planned.values and isinstance(name, Key):
            message = f"joint '{planned.joint}': {name} is not read; did you mean '{suggested}'?"
            yield Finding(name.span, message, f"write {suggested}")


def _compared(planned: PlannedLimit, joint: Joint) -> Iterator[tuple[str, float, float, str]]:
    """Name, value, value in the URDF, and unit of each limit that both files have."""
    velocity = planned.bound("max_velocity", "has_velocity_limits")
    limit = joint.limit
    if velocity is not None and limit and limit.velocity and limit.velocity.value > 0:
        yield "max_velocity", velocity, limit.velocity.value, f"{joint.unit}/s"
    for name, allowed in zip(("min_position", "max_position"), bounds(joint) or (), strict=False):
        position = planned.bound(name, "has_position_limits")
        if position is not None:
            yield name, position, allowed, joint.unit


def _is_wider(name: str, planned: float, allowed: float) -> bool:
    excess = allowed - planned if name.startswith("min") else planned - allowed
    return excess > TOLERANCE * max(abs(allowed), 0.01)


def _ros(context: Context) -> int | None:
    """ROS version of the package of the SRDF, otherwise of the robot."""
    places = (context.srdf.path if context.srdf else "", context.source.path)
    manifests = (manifest_of(context.resolver, place) for place in places if place)
    return next((manifest.ros for manifest in manifests if manifest), None)


def _error_in(name: str, value: Value, ros: int | None) -> tuple[str, str] | None:
    kind = type_of(value)
    if kind in ("string", "bool"):
        return f"{name} is '{value.text}', not a number", "write a number"
    if kind == "int" and ros == 2:
        message = f"{name} is {value.text}, an integer; MoveIt 2 requires a double"
        return message, f"write {value.text}.0"
    if name in _POSITIVE and is_not_positive(value):
        return f"{name} is {value.text}, must be > 0", "write a positive number"
    return None
