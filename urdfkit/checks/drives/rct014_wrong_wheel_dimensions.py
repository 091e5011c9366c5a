"""The wheel radius or separation of a drive plugin or controller differs from the model.

The drive computes wheel speeds and odometry from its own numbers. With a wrong radius the robot
drives too fast or too slow, and measures too little or too much; with a wrong separation it turns
by the wrong angle. The model says where the wheels are and, if their collision is a cylinder or a
sphere, how large. Write its values into the plugin or the parameter file, corrections into
multipliers, of which a controller's length is not reported. A separation larger than the track is
not reported where wheels slip in turns, nor any if the collision of a wheel is farther from its
joint than its diameter. Of several controllers of a file for the same wheels, those that fit best
are reported: the others may be for another robot.

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    AutonomyLab/create_robot#77: https://github.com/AutonomyLab/create_robot/issues/77
    ros-simulation/gazebo_ros_pkgs#317: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/317
"""

from __future__ import annotations

from itertools import chain

from urdfkit.core.spatial import Vector, dot, length, minus
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.rules import Finding, Findings, Location, Need, Severity, rule
from urdfkit.robot.values import number
from urdfkit.ros.gazebo.drives import DrivenWheel, Wheel, drive_of, metres, pairs, wheel_of, wheels
from urdfkit.ros.gazebo.samples import DRIVE, DRIVEN

if TYPE_CHECKING:
    from collections.abc import Iterable

    from urdfkit.lint.context import Context
    from urdfkit.ros.catalog.plugins import Drive
    from urdfkit.ros.catalog.ros_control import Measure
    from urdfkit.ros.controllers import Controller
    from urdfkit.ros.gazebo.plugins import PluginUse

#: Relative difference; real robots are calibrated within this.
TOLERANCE = 0.05
#: In m; wheels that are closer have no place of their own yet.
SAME_PLACE = 1e-3

BAD = DRIVEN
GOOD = BAD.replace("bad.yaml", "good.yaml")
FILES = {"config/bad.yaml": DRIVE.replace(b"0.3", b"0.2"), "config/good.yaml": DRIVE}

_MEASURED = {
    "diameter": "the wheels have a diameter of",
    "radius": "the wheels have a radius of",
    "separation": "the distance between the wheels is",
    "track": "the distance between the wheels is",
    "wheelbase": "the distance between the axles is",
}


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    for use in context.plugins:
        if kind := drive_of(use):
            yield from _of_plugin(use, kind, context)
    if not context.controllers:
        return
    from urdfkit.ros.controllers import by_file  # it reads YAML, which few robots have

    for file, controllers in by_file(context.controllers):
        for several in _by_wheels(controllers):
            found = [list(_of_controller(controller, context)) for controller in several]
            fewest = min(map(len, found))
            for finding in chain.from_iterable(one for one in found if len(one) == fewest):
                yield finding._replace(related=(file.note,))


def _of_plugin(use: PluginUse, kind: Drive, context: Context) -> Findings:
    driven = list(wheels(use, context.tree))
    size = "diameter" if kind.diameter else "radius"
    radius = _radius([one.wheel for one in driven])
    sizes = [2 * one if kind.diameter else one for one in radius]
    apart = _separations(driven)
    for name, measured, real in ((kind.size, size, sizes), (kind.separation, "separation", apart)):
        found = metres(use, name) if name else None
        if found is None or not real:
            continue
        at, value = found
        may_slip = kind.slips and measured == "separation" and value > real[0]
        if not may_slip and _differs(value, real):
            default = ", the default" if at is use.at else ""
            message = (
                f"{use.title}: <{name}> is {value:g} m{default}, but {_MEASURED[measured]} "
                f"{real[0]:.4g} m"
            )
            yield Finding(at, message, _help(real[0]), weight=abs(value - real[0]))


def _separations(driven: list[DrivenWheel]) -> list[float]:
    """How far the first pair of parallel wheels is apart, in m."""
    for left, right in ((left.wheel, right.wheel) for left, right in pairs(driven)):
        if left.is_parallel(right) and left.is_at_joint:
            return _distances(left, right, left.axis) if left.hub and right.hub else []
    return []


def _by_wheels(controllers: Iterable[Controller]) -> Iterable[list[Controller]]:
    """The controllers that name the same joints together."""
    found: dict[frozenset[str], list[Controller]] = {}
    for controller in controllers:
        joints = controller.values(controller.kind.joints) if controller.kind else ()
        found.setdefault(frozenset(joint.text for joint in joints), []).append(controller)
    return found.values()


def _of_controller(controller: Controller, context: Context) -> Findings:
    kind = controller.kind
    for measure in kind.measures if kind else ():
        written = controller.values([measure.parameter])
        value = number(written[0].text) if written else None
        real = _real(measure, controller, context)
        if _is_multiplied(controller, measure.parameter):
            continue  # by who measured how the robot drives
        if value is not None and real and _differs(value, real):
            yield Finding(
                Location(written[0].span),
                f"controller '{controller.name}': {measure.parameter} is {value:g} m, but "
                f"{_MEASURED[measure.kind]} {real[0]:.4g} m",
                _help(real[0]),
                weight=abs(value - real[0]),
            )


def _is_multiplied(controller: Controller, parameter: str) -> bool:
    """True if the controller multiplies a length by another number than 1."""
    names = [f"{side}{parameter}_multiplier" for side in ("", "left_", "right_")]
    return any(number(one.text) not in (None, 1.0) for one in controller.values(names))


def _help(real: float) -> str:
    if real < SAME_PLACE:
        return "give the wheels' joints the <origin> where the wheels are"
    return f"write {real:.4g}"


def _differs(value: float, real: list[float]) -> bool:
    return all(abs(value - one) > TOLERANCE * one for one in real)


def _real(measure: Measure, controller: Controller, context: Context) -> list[float]:
    """What the model says, in m: from the tyres and from the joints. Empty if it says nothing."""
    sides = [_wheels(controller, names, context) for names in measure.sides]
    if not all(sides):
        return []
    if measure.kind == "radius":
        return _radius(sides[0])
    if measure.kind == "wheelbase":
        if max(map(len, sides)) > 2:  # not of one axle: see RCT034
            return []
        x, y, _ = minus(_centre(sides[0]), _centre(sides[1]))
        return [length((x, y, 0.0))]
    if measure.kind == "track":
        return _distances(sides[0][0], sides[0][1]) if len(sides[0]) == 2 else []
    left, right = sides[0][0], sides[1][0]
    # See RCT025 of flat ones, and GEO004 of a collision that is far from its joint.
    are_apart = left.is_parallel(right) and not left.is_flat and left.is_at_joint
    return _distances(left, right, left.axis) if are_apart else []


def _wheels(controller: Controller, names: tuple[str, ...], context: Context) -> list[Wheel]:
    """The wheels that some parameters name; empty if one of them is unknown."""
    joints = (context.model.joints_by_name.get(name.text) for name in controller.values(names))
    found = [wheel_of(joint, context.tree) if joint else None for joint in joints]
    known = [wheel for wheel in found if wheel]
    return known if len(known) == len(found) else []


def _radius(found: list[Wheel]) -> list[float]:
    """The radius of some wheels in m; empty if they have several, or if it is unknown."""
    radii = [wheel.radius for wheel in found if wheel.radius is not None]
    is_one = radii and max(radii) <= (1 + TOLERANCE) * min(radii)
    return radii[:1] if is_one else []


def _centre(found: list[Wheel]) -> Vector:
    x, y, z = (sum(part) / len(found) for part in zip(*(w.origin for w in found), strict=True))
    return x, y, z


def _distances(a: Wheel, b: Wheel, along: Vector | None = None) -> list[float]:
    """Between the tyres and between the joints of two wheels; along a direction if there is one."""
    apart = [minus(a.origin, b.origin)]
    if a.hub and b.hub:
        apart.insert(0, minus(a.hub, b.hub))
    return [abs(dot(way, along)) if along else length(way) for way in apart]
