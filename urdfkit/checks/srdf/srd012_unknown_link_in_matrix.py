"""The collision matrix names a link that the robot does not have.

MoveIt prints "Link is not known to URDF. Cannot disable collisions" and goes on; the line does
nothing, and the pair that it was meant for may be checked in vain. The matrix lags behind the
robot.

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
    moveit/moveit_tutorials#728: https://github.com/moveit/moveit_tutorials/issues/728
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
  <link name="hand"/>
  <joint name="wrist" type="fixed">
    <parent link="forearm"/>
    <child link="hand"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <disable_collisions link1="hand" link2="forarm" reason="Never"/>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <disable_collisions link1="hand" link2="forearm" reason="Never"/>
</robot>
""",
}
FIXED_FILES = {"bad.srdf": FILES["good.srdf"].replace(b"good", b"bad", 1)}


#: How like another name a name must be for that to be offered: "amr" is like "arm".
_LIKE = 0.66


@rule(
    "SRD012",
    "unknown-link-in-matrix",
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="compute the collision matrix anew, or fix the name",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    links = srdf.known("link")
    for pair in (*srdf.root.all("disable_collisions"), *srdf.root.all("enable_collisions")):
        for key in ("link1", "link2"):
            attribute = pair.attributes.get(key)
            if attribute is not None and attribute.value not in links:
                hint = Suggester(links, _LIKE).hint(attribute.value)
                message = f"there is no link '{attribute.value}'{hint}"
                fix = _fix(attribute, links)
                alike = attribute.value if fix else "link"
                yield Finding(attribute, message, fix=fix, alike=alike)


def _fix(attribute: Attribute, known: Collection[str]) -> Fix | None:
    suggested = Suggester(known).suggested(attribute.value)
    edits = replace_value(attribute, suggested) if suggested else None
    return Fix.of(f"rename it to '{suggested}'", edits)
