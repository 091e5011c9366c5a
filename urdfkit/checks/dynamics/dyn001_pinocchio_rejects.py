"""Pinocchio rejects the robot.

Checked with `--target pinocchio`: Pinocchio itself reads the expanded URDF, in a separate process.
If it rejects the robot, `buildModelFromUrdf` raises a ValueError without the reason; the C++
library writes the reason to its standard error, and the message repeats it. It rejects several
roots, loops, duplicate and unknown names, and joints whose `<limit>` has no effort.

Sources:
    Pinocchio, URDF model: https://github.com/stack-of-tasks/pinocchio/blob/devel/src/parsers/urdf/model.cpp
    Pinocchio, URDF joints: https://github.com/stack-of-tasks/pinocchio/blob/devel/include/pinocchio/parsers/urdf/model.hxx
"""

import re

from urdfkit.lint.requirements import need_pinocchio
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import arm_xml
from urdfkit.text.document import Element

TARGETS = ("pinocchio",)
BAD = arm_xml("revolute", '<limit lower="-1" upper="1" velocity="2"/>')
GOOD = BAD.replace("velocity", 'effort="10" velocity')

_NAME = r"[\[']([^\]']+)[\]']"


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.DYNAMICS),
    help="correct what it complains about; the other findings may say more",
)
def check(context: Context) -> Findings:
    if "pinocchio" in context.targets.names and not context.is_part:
        need_pinocchio()
        from urdfkit.physics.dynamics.pinocchio_parser import why_rejected

        if text := why_rejected(context.text):
            reason, _, _ = text.partition(".  ")  # followed by advice
            yield Finding(_place(context.model, text), f"Pinocchio rejects the robot: {reason}")


def _place(model: RobotModel, reason: str) -> Element:
    """The joint or link that the reason names, otherwise the root element."""
    for name in re.findall(_NAME, reason):
        part = model.joints_by_name.get(name) or model.links_by_name.get(name)
        if part:
            return part.at
    return model.root
