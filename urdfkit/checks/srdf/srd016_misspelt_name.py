"""An element or attribute of the SRDF is misspelt.

srdfdom passes over what it does not know. A group loses its chain, a pair of links is checked for
collisions again, and MoveIt says nothing, or complains of something else.

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.ros.moveit.srdf_grammar import mistakes
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import rename_attribute, rename_element

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="bad">
  <link name="base"/>
  <link name="arm"/>
  <joint name="shoulder" type="fixed">
    <parent link="base"/>
    <child link="arm"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <disable_collision link1="base" link2="arm" reason="Adjacent"/>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <disable_collisions link1="base" link2="arm" reason="Adjacent"/>
</robot>
""",
}
FIXED_FILES = {"bad.srdf": FILES["good.srdf"].replace(b"good", b"bad", 1)}


@rule(
    "SRD016",
    "misspelt-name",
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="fix the name",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    if subject.srdf is None:
        return
    for mistake in mistakes(subject.srdf.root):
        if isinstance(mistake.at, Element):
            what, edits = f"element <{mistake.name}>", rename_element(mistake.at, mistake.suggested)
        else:
            what, edits = (
                f"attribute '{mistake.name}'",
                rename_attribute(mistake.at, mistake.suggested),
            )
        message = (
            f"unknown {what} in <{mistake.parent.tag}> (ignored); "
            f"did you mean '{mistake.suggested}'?"
        )
        fix = Fix.of(f"rename it to {mistake.suggested}", edits)
        at = Location(edits[0].span) if edits else mistake.at
        yield Finding(at, message, fix=fix)
