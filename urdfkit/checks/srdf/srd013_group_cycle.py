"""Planning groups contain one another in a circle.

MoveIt cannot resolve them and leaves all of them out.

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.ros.moveit.srdf import Srdf

BAD = """\
<robot name="bad">
  <link name="arm"/>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <group name="a"><group name="b"/></group>
  <group name="b"><group name="a"/></group>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="a"><group name="b"/></group>
  <group name="b"><link name="arm"/></group>
</robot>
""",
}


@rule(
    "SRD013",
    "group-cycle",
    Severity.ERROR,
    needs=(Need.MODEL, Need.SRDF),
    help="take one of the subgroups out",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    for name, elements in srdf.groups_by_name.items():
        way = _circle(name, srdf)
        # A circle is reported once, at the first of its groups.
        if way and name == min(way):
            yield Finding(elements[0], "groups contain one another: " + " -> ".join((*way, name)))


def _circle(name: str, srdf: Srdf) -> tuple[str, ...]:
    """The groups on a way from a group through its subgroups back to it; empty without one."""
    stack: list[tuple[str, ...]] = [(name,)]
    seen: set[str] = set()
    while stack:
        way = stack.pop()
        for element in srdf.groups_by_name.get(way[-1], ()):
            for child in element.all("group"):
                inner = child.get("name") or ""
                if inner == name:
                    return way
                if inner not in seen:
                    seen.add(inner)
                    stack.append((*way, inner))
    return ()
