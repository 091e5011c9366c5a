"""The base_frame_id of a wheel controller is not the root link of the robot.

`base_frame_id` is the child of the transform that the odometry sends. A name that is not a link
leaves the robot without a way to `odom` ("no transform from [base_link] to [odom]"); a link with
a parent link gets two parents, and the robot jumps between them.

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
"""

from __future__ import annotations

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, rule
from urdfkit.ros.controllers import Controller, controllers
from urdfkit.ros.gazebo.samples import DRIVE, DRIVEN
from urdfkit.text.diagnostic import Severity
from urdfkit.text.grammar import is_expression
from urdfkit.text.located_yaml import Value

BAD = DRIVEN
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = DRIVE + b"    base_frame_id: base\n"
FILES = {
    "config/bad.yaml": _YAML.replace(b"_id: base", b"_id: base_link"),
    "config/good.yaml": _YAML,
}


@rule(Severity.WARNING)
def check(subject: Subject) -> Findings:
    if subject.is_part or len(subject.tree.roots) != 1:
        return
    root = subject.tree.roots[0].name
    for file, found in controllers(subject):
        for controller in found:
            value = _frame(controller)
            if value is None or value.text.strip("/") == root:
                continue
            name = value.text.strip("/")
            if name not in subject.model.links_by_name:
                hint = did_you_mean(name, subject.model.links_by_name)
                message = f"the robot has no link '{name}'{hint}"
            else:
                above = subject.tree.parents[name][0].parent
                parent = above.value if above else root
                message = f"'{name}' is a child of '{parent}'; a frame has one parent"
            yield Finding(
                Location(value.span),
                f"controller '{controller.name}' publishes the transform to '{name}': {message}",
                f"name the root link '{root}'",
                related=(file.note,),
            )


def _frame(controller: Controller) -> Value | None:
    """The frame whose pose it sends, if it sends one and says which."""
    if "drive" not in controller.type and "steering" not in controller.type:
        return None
    sends = controller.values(["enable_odom_tf"])
    prefixed = controller.values(["tf_frame_prefix"])
    frame = controller.values(["base_frame_id"])
    if not frame or (sends and sends[0].text.lower() == "false") or prefixed:
        return None
    return None if is_expression(frame[0].text) or not frame[0].text else frame[0]
