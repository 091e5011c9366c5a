"""The wheel radius or separation of a wheel controller differs from the model.

The controller computes wheel speeds and odometry from its own numbers. With a wrong radius the
robot drives too fast or too slow, and measures too little or too much; with a wrong distance it
turns by the wrong angle. The model says where the wheels are and, if their collision is a cylinder
or a sphere, how large. Write its values into the parameter file, corrections into
multipliers.

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
"""

from __future__ import annotations

from collections.abc import Callable

from urdfkit.core.spatial import Vector, dot, minus
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, rule
from urdfkit.robot.model import length, number
from urdfkit.ros.catalog.ros_control import Measure
from urdfkit.ros.catalog.ros_control import controllers as catalogue
from urdfkit.ros.controllers import Controller, controllers
from urdfkit.ros.gazebo.drives import DrivenWheel, rolling
from urdfkit.ros.gazebo.samples import DRIVE, DRIVEN
from urdfkit.text.diagnostic import Severity

#: Relative difference; real robots are calibrated within this.
TOLERANCE = 0.05

BAD = DRIVEN
GOOD = BAD.replace("bad.yaml", "good.yaml")
FILES = {
    "config/bad.yaml": DRIVE.replace(b"0.3", b"0.2"),
    "config/good.yaml": DRIVE,
}


@rule(Severity.WARNING)
def check(subject: Subject) -> Findings:
    for file, found in controllers(subject):
        for controller in found:
            kind = catalogue().get(controller.type)
            for measure in kind.measures if kind else ():
                said = controller.values([measure.parameter])
                value = number(said[0].text) if said else None
                real = _real(measure, controller, subject)
                if value is None or not real or any(map(_near(value), real)):
                    continue
                yield Finding(
                    Location(said[0].span),
                    f"controller '{controller.name}': {measure.parameter} is {value:g} m, but "
                    f"{real[0]:.4g} m in the model",
                    f"write {real[0]:.4g}",
                    related=(file.note,),
                    weight=abs(value - real[0]),
                )


def _near(value: float) -> Callable[[float], bool]:
    return lambda real: abs(value - real) <= TOLERANCE * real


def _real(measure: Measure, controller: Controller, subject: Subject) -> list[float]:
    """What the model says, in m: from the tyres and from the joints. Empty if it says nothing."""
    sides = [_wheels(controller, names, subject) for names in measure.sides]
    if not all(sides):
        return []
    if measure.kind == "radius":
        radii = [wheel.radius for wheel in sides[0] if wheel.radius is not None]
        alike = radii and max(radii) <= (1 + TOLERANCE) * min(radii)
        return radii[:1] if alike else []
    if measure.kind == "wheelbase":
        x, y, _ = minus(_centre(sides[0]), _centre(sides[1]))
        return [length((x, y, 0.0))]
    if measure.kind == "track":
        return _distances(sides[0][0], sides[0][1]) if len(sides[0]) == 2 else []
    left, right = sides[0][0], sides[1][0]
    return _distances(left, right, left.axis) if left.is_parallel(right) else []


def _wheels(controller: Controller, names: tuple[str, ...], subject: Subject) -> list[DrivenWheel]:
    """The wheels that some parameters name; empty if one of them is unknown."""
    wheels: list[DrivenWheel] = []
    for value in controller.values(names):
        joint = subject.model.joints_by_name.get(value.text)
        wheel = rolling(joint, subject.tree) if joint else None
        if wheel is None:
            return []
        wheels.append(wheel)
    return wheels


def _centre(wheels: list[DrivenWheel]) -> Vector:
    x, y, z = (sum(part) / len(wheels) for part in zip(*(w.origin for w in wheels), strict=True))
    return x, y, z


def _distances(a: DrivenWheel, b: DrivenWheel, along: Vector | None = None) -> list[float]:
    """Between the tyres and between the joints of two wheels; along a direction if there is one."""
    apart = [minus(a.origin, b.origin)]
    if a.hub and b.hub:
        apart.insert(0, minus(a.hub, b.hub))
    return [abs(dot(way, along)) if along else length(way) for way in apart]
