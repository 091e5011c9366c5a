"""A planning group is empty or no chain, or groups contain one another in a cycle.

- MoveIt prints "Group is empty" and ignores the group (warning), so that whatever refers to it
  fails.
- A chain goes from a base link down the tree to a tip link. MoveIt rejects any other chain, and the
  group has no joints. Base and tip are swapped, or one of them is on another branch.
- `kinematics.yaml` gives KDL, LMA or TRAC-IK to a group whose joints do not follow one another:
  "Group 'arm' is not a chain", and the group cannot be moved to a pose.
- MoveIt cannot resolve groups that contain one another, and ignores all of them.

Sources:
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
    MoveIt, kdl_kinematics_plugin.cpp: https://github.com/moveit/moveit2/blob/main/moveit_kinematics/kdl_kinematics_plugin/src/kdl_kinematics_plugin.cpp
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
"""

from collections.abc import Iterator

from urdfkit.checks.srdf.solvable_groups import unsolvable_groups
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.samples import arm_xml
from urdfkit.robot.tree import closed_loops
from urdfkit.ros.moveit.samples import named_xml, srdf_files
from urdfkit.ros.moveit.srdf import Srdf

BAD = named_xml("bad", arm_xml("fixed"))
GOOD = BAD.replace('"bad"', '"good"')
FILES = srdf_files('<group name="g"/>', '<group name="g"><link name="arm"/></group>')


@rule(Severity.ERROR, needs=(Need.MODEL, Need.SRDF), reports_missing=True)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    for name, elements in srdf.groups_by_name.items():
        if not any(element.children for element in elements):
            help = "add links, joints or a chain, or delete the group"
            message = f"group '{name}' is empty"
            yield Finding(elements[0], message, help, severity=Severity.WARNING)
    for cycle in _cycles(srdf):
        message = "groups contain one another: " + " -> ".join((*cycle, cycle[0]))
        place = srdf.groups_by_name[cycle[0]][0]
        yield Finding(place, message, "remove one of the subgroups")
    yield from _chains(srdf)
    yield from unsolvable_groups(context, srdf)


def _chains(srdf: Srdf) -> Findings:
    links = srdf.known("link")
    for group in srdf.groups:
        for chain in group.all("chain"):
            base, tip = chain.get("base_link") or "", chain.get("tip_link") or ""
            if base in links and tip in links and srdf.joints_between(base, tip) is None:
                who = f"group '{group.get('name')}'"
                message = f"{who}: tip link '{tip}' is not a descendant of base link '{base}'"
                yield Finding(chain, message, "swap base and tip, or name links of one branch")


def _cycles(srdf: Srdf) -> Iterator[list[str]]:
    """The groups of each cycle from the first name on; one cycle for each first name."""
    reported: set[str] = set()
    for cycle in closed_loops(srdf.groups_by_name, lambda name: _subgroups(name, srdf)):
        first = min(cycle)
        if first not in reported:
            reported.add(first)
            at = cycle.index(first)
            yield [*cycle[at:], *cycle[:at]]


def _subgroups(name: str, srdf: Srdf) -> Iterator[tuple[str, str]]:
    """The subgroups of a group, each also as the edge of the graph that leads to it."""
    for element in srdf.groups_by_name.get(name, ()):
        for child in element.all("group"):
            inner = child.get("name") or ""
            yield inner, inner
