"""A continuous joint has no effort and velocity limit, while another one beside it has.

A continuous joint may do without `<limit>`; it is then without limit for every reader. Where one
wheel of a body has limits and the others have none, a simulation drives them differently as soon
as a controller asks for more than the limit. Give all of them one, or none.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint, Limit

BAD = """\
<link name="base"/>
<link name="left_wheel"/>
<link name="right_wheel"/>
<joint name="left_axle" type="continuous">
  <parent link="base"/>
  <child link="left_wheel"/>
  <axis xyz="0 1 0"/>
  <limit effort="5" velocity="20"/>
</joint>
<joint name="right_axle" type="continuous">
  <parent link="base"/>
  <child link="right_wheel"/>
  <axis xyz="0 1 0"/>
</joint>"""
GOOD = BAD.replace('  <limit effort="5" velocity="20"/>\n', "")


@rule(
    "JNT021",
    "no-limit-on-continuous",
    Severity.INFO,
    help="give all continuous joints a <limit> with effort and velocity, or none",
)
def check(subject: Subject) -> Iterator[Finding]:
    limited: dict[str, tuple[Joint, Limit]] = {}
    joints = [joint for joint in subject.model.joints if joint.kind == "continuous"]
    for joint in joints:
        if joint.parent and joint.limit and joint.limit.effort and joint.limit.velocity:
            limited.setdefault(joint.parent.value, (joint, joint.limit))
    for joint in joints:
        parent = joint.parent.value if joint.parent else ""
        if joint.limit or joint.mimic or parent not in limited:
            continue
        other, limit = limited[parent]
        assert limit.effort is not None
        assert limit.velocity is not None
        yield Finding(
            joint.at,
            f"joint '{joint.name}' has no effort and velocity limit; '{other.name}' beside it has "
            f"{limit.effort.value:g} N m and {limit.velocity.value:g} rad/s",
            related=(Related(limit.at.span, f"the limit of '{other.name}'"),),
            alike=other.name,
        )
