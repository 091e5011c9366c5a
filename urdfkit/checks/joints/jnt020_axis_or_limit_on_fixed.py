"""A fixed joint has an axis or position limits.

An axis and limits have no effect on a fixed joint: URDF parsers ignore them. They are left over
from a joint that once moved, or the joint should be revolute or prismatic. Limits of zero, as
exporters write them, are not reported.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    measured: in 143 of 676 public models
"""

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.samples import arm_xml
from urdfkit.text.editing.edits import remove_element

BAD = arm_xml("fixed", '<axis xyz="0 1 0"/>')
FIXED = GOOD = BAD.replace('  <axis xyz="0 1 0"/>\n', "")


@rule(Severity.INFO)
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        if joint.kind != "fixed":
            continue
        axis, limit = joint.at.child("axis"), joint.limit
        ends = (limit.lower, limit.upper) if limit else (None, None)
        lower, upper = (end.value if end else 0.0 for end in ends)
        is_limited = lower < upper
        if axis is not None:
            message = f"joint '{joint.name}' is fixed; its <axis> has no effect"
            # With limits it is needed again as soon as the joint gets the right type.
            fix = Fix("remove the axis", remove_element(axis), safe=not is_limited)
            yield Finding(axis, message, "remove the axis", fix, group_key="axis")
        if limit is not None and is_limited:
            yield Finding(
                limit.at,
                f"joint '{joint.name}' is fixed; its limits [{lower:g}, {upper:g}] have no effect",
                'write type="revolute" or "prismatic", or remove the <limit>',
            )
