"""A planning group is empty, or groups contain one another in a cycle.

MoveIt prints "Group is empty" and ignores the group, so that whatever refers to it fails. It cannot
resolve groups that contain one another, and ignores all of them (error).

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.diagnostic import Severity

BAD = """\
<robot name="bad">
  <link name="arm"/>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <group name="arm"/>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="arm"><link name="arm"/></group>
</robot>
""",
}


@rule(Severity.WARNING, needs=(Need.MODEL, Need.SRDF), reports_missing=True)
def check(subject: Subject) -> Findings:
    srdf = subject.srdf
    for name, elements in srdf.groups_by_name.items() if srdf else ():
        if not any(element.children for element in elements):
            help = "add links, joints or a chain, or delete the group"
            yield Finding(elements[0], f"group '{name}' is empty", help)
        cycle = _cycle(name, srdf) if srdf else ()
        # A cycle is reported once, at the first of its groups.
        if cycle and name == min(cycle):
            yield Finding(
                elements[0],
                "groups contain one another: " + " -> ".join((*cycle, name)),
                "remove one of the subgroups",
                severity=Severity.ERROR,
            )


def _cycle(name: str, srdf: Srdf) -> tuple[str, ...]:
    """The groups on a path from a group through its subgroups back to it; empty without one."""
    stack: list[tuple[str, ...]] = [(name,)]
    seen: set[str] = set()
    while stack:
        path = stack.pop()
        for element in srdf.groups_by_name.get(path[-1], ()):
            for child in element.all("group"):
                inner = child.get("name") or ""
                if inner == name:
                    return path
                if inner not in seen:
                    seen.add(inner)
                    stack.append((*path, inner))
    return ()
