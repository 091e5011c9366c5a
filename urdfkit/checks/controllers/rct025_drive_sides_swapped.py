"""Left and right of a wheel controller are swapped, or the wheel axes point in opposite directions.

The controller rolls both sides forwards by turning their joints in the positive sense, and takes
the first list for the left. With the lists interchanged the robot turns to the wrong side and its
odometry with it; with axes that point in opposite directions it spins instead of going straight.

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, rule
from urdfkit.ros.controllers import controllers
from urdfkit.ros.gazebo.drives import DrivenWheel, rolling, wrong_sides
from urdfkit.ros.gazebo.samples import DRIVE, DRIVEN
from urdfkit.text.diagnostic import Severity
from urdfkit.text.located_yaml import Value

BAD = DRIVEN
GOOD = BAD.replace("bad.yaml", "good.yaml")
FILES = {
    "config/bad.yaml": DRIVE.replace(b"left_joint", b"?")
    .replace(b"right_joint", b"left_joint")
    .replace(b"?", b"right_joint"),
    "config/good.yaml": DRIVE,
}

_LEFT = ("left_wheel_names", "left_wheel")
_RIGHT = ("right_wheel_names", "right_wheel")


@rule(Severity.WARNING)
def check(subject: Subject) -> Findings:
    for file, found in controllers(subject):
        for controller in found:
            left, right = controller.values(_LEFT)[:1], controller.values(_RIGHT)[:1]
            if "diff_drive" not in controller.type or not left or not right:
                continue
            wheels = [_wheel(value, subject) for value in (*left, *right)]
            if wheels[0] and wheels[1] and (wrong := wrong_sides(wheels[0], wheels[1])):
                message, help = wrong
                yield Finding(
                    Location(left[0].span),
                    f"controller '{controller.name}': {message}",
                    help,
                    related=(file.note,),
                )


def _wheel(value: Value, subject: Subject) -> DrivenWheel | None:
    joint = subject.model.joints_by_name.get(value.text)
    return rolling(joint, subject.tree) if joint else None
