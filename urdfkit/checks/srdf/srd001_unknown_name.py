"""The SRDF names a link, joint or group that does not exist.

MoveIt drops the group or the state that refers to it, and planning then fails with "group not
found" or with joints that never move. The SRDF lags behind the robot, or the name is misspelt.

Sources:
    SRDF: https://wiki.ros.org/srdf
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Attribute

BAD = """\
<robot name="bad">
  <link name="forearm"/>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <group name="arm"><link name="forarm"/></group>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="arm"><link name="forearm"/></group>
</robot>
""",
}
FIXED_FILES = {"bad.srdf": FILES["good.srdf"].replace(b"good", b"bad", 1)}


#: How like another name a name must be for that to be offered: "amr" is like "arm".
_LIKE = 0.66


@rule(
    "SRD001",
    "unknown-name",
    Severity.ERROR,
    needs=(Need.MODEL, Need.SRDF),
    help="fix the name, or make the SRDF anew for this robot",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    for kind, attribute in srdf.references():
        known = srdf.known(kind)
        if attribute.value and attribute.value not in known and not _is_free_flyer(attribute):
            hint = Suggester(known, _LIKE).hint(attribute.value)
            message = f"there is no {kind} '{attribute.value}'{hint}"
            fix = _fix(attribute, known)
            yield Finding(attribute, message, fix=fix, alike=attribute.value if fix else kind)


def _is_free_flyer(attribute: Attribute) -> bool:
    """True for Pinocchio's floating base, which no URDF has: a position and a quaternion."""
    value = attribute.element.get("value") or ""
    return attribute.value == "root_joint" and len(value.split()) == 7


def _fix(attribute: Attribute, known: Collection[str]) -> Fix | None:
    suggested = Suggester(known).suggested(attribute.value)
    edits = replace_value(attribute, suggested) if suggested else None
    return Fix.of(f"rename it to '{suggested}'", edits)
