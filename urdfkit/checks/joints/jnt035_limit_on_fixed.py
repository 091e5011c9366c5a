"""A fixed joint has a range to move in.

It does not move, whatever its `<limit>` says. Either the joint was to be revolute or prismatic, or
the limit is left over.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="tray"/>
<joint name="slide" type="fixed">
  <parent link="base"/>
  <child link="tray"/>
  <axis xyz="1 0 0"/>
  <limit lower="0" upper="0.3" effort="10" velocity="0.1"/>
</joint>"""
GOOD = BAD.replace("fixed", "prismatic")


@rule(
    "JNT035",
    "limit-on-fixed",
    Severity.INFO,
    help="let it move (type revolute or prismatic), or remove the <limit>",
)
def check(subject: Subject) -> Iterator[Finding]:
    for joint in subject.model.joints:
        limit = joint.limit
        if joint.kind != "fixed" or limit is None:
            continue
        lower, upper = (end.value if end else 0.0 for end in (limit.lower, limit.upper))
        if lower < upper:
            message = f"joint '{joint.name}' is fixed, and its limits are {lower:g} to {upper:g}"
            yield Finding(limit.at, message)
