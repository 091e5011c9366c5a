"""The wheel radius or separation of a drive plugin or controller differs from the model.

The drive computes wheel speeds and odometry from its parameters. With a wrong radius the robot
drives too fast or too slow, and the odometry is too short or too long; with a wrong separation it
turns by the wrong angle. A mecanum drive has the sum of half of the wheelbase and half of the track
(`sum_of_robot_center_projection_on_X_Y_axis`) in place of a separation. The model defines the
positions of the wheels and, if their collision geometry is a cylinder or a sphere, their radius.
Use these values in the plugin or the parameter file; use multipliers for corrections.

A left and a right wheel with different radii are reported at the one that the drive does not have:
the robot leans, and drives in a curve.

An info: a separation larger than the track, if a side has several wheels. They slip in turns, and
the value may be calibrated.

Not reported: lengths with a multiplier, unless a separation is far too small with it, too; a
separation larger than the track for a plugin of skid-steered robots, a separation if the collision
geometry of a wheel is farther from its joint than its diameter, and the wheelbase of a car whose
driven wheels are the steered ones. If a file has several controllers for the same wheels, only
those with the fewest differences are reported: the others may be for another robot.

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    AutonomyLab/create_robot#77: https://github.com/AutonomyLab/create_robot/issues/77
    ros-simulation/gazebo_ros_pkgs#317: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/317
"""

from __future__ import annotations

from itertools import chain
from math import isclose

from urdfkit.core.spatial import Vector, dot, length, minus
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.rules import Finding, Findings, Need, Severity, rule
from urdfkit.robot.values import number
from urdfkit.ros.gazebo.drives import DrivenWheel, Wheel, drive_of, metres, pairs, wheel_of, wheels
from urdfkit.ros.gazebo.samples import DRIVE, DRIVEN
from urdfkit.text.diagnostic import Related

if TYPE_CHECKING:
    from collections.abc import Iterable

    from urdfkit.lint.context import Context
    from urdfkit.ros.catalog.plugins import Drive
    from urdfkit.ros.catalog.ros_control import Measure
    from urdfkit.ros.controllers import Controller
    from urdfkit.ros.gazebo.plugins import PluginUse
    from urdfkit.text.document import Element

#: Relative difference, within which real robots are calibrated.
TOLERANCE = 0.05
#: Wheels that slip in turns act as if they were further apart, up to this factor (Husky: 1.875).
MAX_SLIP = 2.5
#: No calibration makes a separation so much smaller.
LEAST = 0.7
#: Millimetres and centimetres in a metre: the model, which is too large, has another unit.
_UNITS = (1000.0, 100.0)
#: In m: the positions of wheels that are closer are not yet defined.
SAME_PLACE = 1e-3

BAD = DRIVEN
GOOD = BAD.replace("bad.yaml", "good.yaml")
FILES = {"config/bad.yaml": DRIVE.replace(b"0.3", b"0.2"), "config/good.yaml": DRIVE}

#: Least cosine of the angle between the axis of two wheels and the line between them.
_LATERAL = 0.5

_MEASURED = {
    "diameter": "the wheels have a diameter of",
    "radius": "the wheels have a radius of",
    "separation": "the distance between the wheels is",
    "track": "the distance between the wheels is",
    "wheelbase": "the distance between the axles is",
    "projection": "half of the wheelbase and half of the track are",
}


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    for use in context.plugins:
        if kind := drive_of(use):
            yield from _check_plugin(use, kind, context)
    if not context.controllers:
        return
    from urdfkit.ros.controllers import by_file  # it reads YAML, which few robots have

    for file, controllers in by_file(context.controllers):
        for alternatives in _by_wheels(controllers):
            findings = [list(_check_controller(controller, context)) for controller in alternatives]
            fewest = min(map(len, findings))
            for finding in chain.from_iterable(each for each in findings if len(each) == fewest):
                yield finding._replace(related=(*finding.related, file.note))


def _check_plugin(use: PluginUse, kind: Drive, context: Context) -> Findings:
    driven = list(wheels(use, context.tree))
    size = "diameter" if kind.diameter else "radius"
    sizes = [(2 if kind.diameter else 1) * radius for radius in _radius([d.wheel for d in driven])]
    track = _separations(driven)
    written = metres(use, kind.size) if kind.size else None
    expected = written[1] / (2 if kind.diameter else 1) if written else 0.0
    sides = [(left.wheel, right.wheel) for left, right in pairs(driven)]
    yield from _unequal(sides, expected, context, use.title)
    for name, measured, real in ((kind.size, size, sizes), (kind.separation, "separation", track)):
        parameter = metres(use, name) if name else None
        if parameter is None or not real:
            continue
        at, value = parameter
        may_slip = kind.slips and measured == "separation" and value > real[0]
        if not may_slip and _differs(value, real):
            default = ", the default" if at is use.at else ""
            message = f"{use.title}: <{name}> is {value:g} m{default}, but {_MEASURED[measured]} "
            message += f"{real[0]:.4g} m"
            is_info = measured == "separation" and len(driven) > 2 and _may_slip(value, real)
            severity = Severity.INFO if is_info else None
            weight = abs(value - real[0])
            yield Finding(at, message, _help(real[0], value), weight=weight, severity=severity)


def _unequal(
    sides: Iterable[tuple[Wheel, Wheel]], expected: float, context: Context, title: str
) -> Findings:
    """The first left and right wheel of a drive whose radii differ.

    Args:
        expected: the radius according to the drive, in m.
    """
    for left, right in sides:
        if not left.radius or not right.radius or _radius([left, right]):
            continue
        wrong, other = sorted((left, right), key=lambda each: -abs((each.radius or 0) - expected))
        at, right_at = (_shape(wheel, context) for wheel in (wrong, other))
        yield Finding(
            at,
            f"{title}: wheel '{wrong.joint.child_name}' has a radius of {wrong.radius:.4g} m, "
            f"wheel '{other.joint.child_name}' {other.radius:.4g} m",
            "write the same radius for both",
            related=(Related(right_at.span, f"wheel '{other.joint.child_name}'"),),
        )
        return


def _shape(wheel: Wheel, context: Context) -> Element:
    """The shape of a wheel of known radius, which is its only collision."""
    shape = context.model.links_by_name[wheel.joint.child_name].collisions[0].shape
    assert shape is not None
    return shape.at


def _separations(driven: list[DrivenWheel]) -> list[float]:
    """Distances of the first pair of parallel wheels in m: of the tyres, and of the joints."""
    for left, right in ((left.wheel, right.wheel) for left, right in pairs(driven)):
        if left.is_parallel(right) and left.is_at_joint:
            return _distances(left, right, left.axis) if left.hub and right.hub else []
    return []


def _by_wheels(controllers: Iterable[Controller]) -> Iterable[list[Controller]]:
    """The controllers, grouped by their joints."""
    groups: dict[frozenset[str], list[Controller]] = {}
    for controller in controllers:
        joints = controller.values(controller.kind.joints) if controller.kind else ()
        groups.setdefault(frozenset(joint.text for joint in joints), []).append(controller)
    return groups.values()


def _check_controller(controller: Controller, context: Context) -> Findings:
    kind = controller.kind
    for measure in kind.measures if kind else ():
        if measure.kind == "separation":
            left, right = (_wheels(controller, names, context) for names in measure.sides)
            radii = [number(value.text) for value in controller.values(["wheel_radius"])]
            sides, expected = zip(left, right, strict=False), radii[0] if radii else None
            yield from _unequal(sides, expected or 0.0, context, controller.title)
        values = controller.values([measure.parameter])
        value = number(values[0].text) if values else None
        real = _lengths_in_model(measure, controller, context)
        factors = _multipliers(controller, measure.parameter)
        if factors and not (value and real and _is_far_too_small(measure, value, factors, real)):
            continue  # the drive is calibrated
        if value is not None and real and _differs(value, real):
            is_info = _slips(measure, controller) and _may_slip(value, real)
            yield Finding(
                values[0].span,
                f"{controller.title}: {measure.parameter} is {value:g} m, but "
                f"{_MEASURED[measure.kind]} {real[0]:.4g} m",
                _help(real[0], value) + f", and calibrate {measure.parameter}_multiplier" * is_info,
                weight=abs(value - real[0]),
                severity=Severity.INFO if is_info else None,
            )


def _may_slip(value: float, real: list[float]) -> bool:
    return real[0] < value <= MAX_SLIP * real[0]


def _slips(measure: Measure, controller: Controller) -> bool:
    """True for a separation of sides with several wheels, which slip in turns."""
    numbers = (len(controller.values(names)) for names in measure.sides)
    return measure.kind == "separation" and max(numbers) > 1


def _multipliers(controller: Controller, parameter: str) -> list[float]:
    """The numbers other than 1 by which the controller multiplies a length."""
    names = [f"{side}{parameter}_multiplier" for side in ("", "left_", "right_")]
    factors = (number(value.text) for value in controller.values(names))
    return [factor for factor in factors if factor not in (None, 1.0)]


def _is_far_too_small(
    measure: Measure, value: float, factors: list[float], real: list[float]
) -> bool:
    """True for a separation that is far smaller than the real one, also with its multiplier."""
    largest = value * max(1.0, *factors)
    return measure.kind == "separation" and largest < LEAST * min(real)


def _help(real: float, value: float) -> str:
    if real > value and any(isclose(real, factor * value, rel_tol=TOLERANCE) for factor in _UNITS):
        return "write the length in the model in m, not in another unit"
    if real < SAME_PLACE:
        return "write the positions of the wheels into the <origin> of their joints"
    return f"write {real:.4g}"


def _differs(value: float, real: list[float]) -> bool:
    return all(abs(value - each) > TOLERANCE * each for each in real)


def _lengths_in_model(measure: Measure, controller: Controller, context: Context) -> list[float]:
    """Lengths in the model in m, by the tyres and by the joints; empty if they are unknown."""
    sides = [_wheels(controller, names, context) for names in measure.sides]
    if not all(sides):
        return []
    if measure.kind == "radius":
        return _radius(sides[0])
    if measure.kind == "wheelbase":
        if max(map(len, sides)) > 2:  # more than one axle: see RCT034
            return []
        if _are_steered(sides[0], sides[1], context) or _are_steered(sides[1], sides[0], context):
            return []
        x, y, _ = minus(_centre(sides[0]), _centre(sides[1]))
        return [length((x, y, 0.0))]
    if measure.kind == "projection":
        return _projections(sides[0][0], sides[1][0])
    if measure.kind == "track":
        return _distances(sides[0][0], sides[0][1]) if len(sides[0]) == 2 else []
    left, right = sides[0][0], sides[1][0]
    # RCT025 reports flat wheels, and GEO004 a collision that is far from its joint.
    is_pair = left.is_parallel(right) and not left.is_flat and left.is_at_joint
    return _distances(left, right, left.axis) if is_pair else []


def _projections(a: Wheel, b: Wheel) -> list[float]:
    """Half of the distances along x and y of two wheels of a mecanum drive, by tyres and joints."""
    offsets = [minus(a.origin, b.origin)]
    if a.hub and b.hub:
        offsets.insert(0, minus(a.hub, b.hub))
    sums = [(abs(offset[0]) + abs(offset[1])) / 2 for offset in offsets]
    return [each for each in sums if each > SAME_PLACE]


def _are_steered(wheels: list[Wheel], steering: list[Wheel], context: Context) -> bool:
    """True for wheels that steering joints turn: front-wheel drive, without a rear axle."""
    steers = {wheel.joint.name for wheel in steering}
    paths = (context.tree.path(wheel.joint.parent_name) for wheel in wheels)
    return any(joint.name in steers for path in paths for joint in path)


def _wheels(controller: Controller, names: tuple[str, ...], context: Context) -> list[Wheel]:
    """The wheels that some parameters name; empty if one of them is unknown."""
    joints = (context.model.joints_by_name.get(name.text) for name in controller.values(names))
    candidates = [wheel_of(joint, context.tree) if joint else None for joint in joints]
    known = [wheel for wheel in candidates if wheel]
    return known if len(known) == len(candidates) else []


def _radius(wheels: list[Wheel]) -> list[float]:
    """The common radius of some wheels in m; empty if it is unknown or differs."""
    radii = [wheel.radius for wheel in wheels if wheel.radius is not None]
    is_common = radii and max(radii) <= (1 + TOLERANCE) * min(radii)
    return radii[:1] if is_common else []


def _centre(wheels: list[Wheel]) -> Vector:
    x, y, z = (sum(part) / len(wheels) for part in zip(*(w.origin for w in wheels), strict=True))
    return x, y, z


def _distances(a: Wheel, b: Wheel, along: Vector | None = None) -> list[float]:
    """Distances of two wheels in m, of the tyres if known and of the joints; ``along`` an axis."""
    offsets = [minus(a.origin, b.origin)]
    if a.hub and b.hub:
        offsets.insert(0, minus(a.hub, b.hub))
    if along and abs(dot(offsets[-1], along)) < _LATERAL * length(offsets[-1]):
        return []  # the axis is wrong, not the distance
    return [abs(dot(offset, along)) if along else length(offset) for offset in offsets]
