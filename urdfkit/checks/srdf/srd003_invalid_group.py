"""A planning group is empty or not a chain, mixes sides, or groups contain one another.

- MoveIt prints "Group is empty" and ignores the group (warning), so that references to it fail.
- The base link of a chain is below its tip link (warning): they are swapped. MoveIt takes the
  joints between them and the one above the tip link. Or the two are on different branches (info):
  the group has the joints of both, as of a robot and its positioner.
- The solver in `kinematics.yaml` is KDL, LMA or TRAC-IK, but the joints of the group are not a
  chain: "Group 'arm' is not a chain", and the group cannot be moved to a pose.
- Groups contain one another in a cycle: MoveIt ignores all of them.
- The left arm has one joint of the right arm, and not its counterpart, a copy that was not adapted
  (warning).

Sources:
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
    MoveIt, kdl_kinematics_plugin.cpp: https://github.com/moveit/moveit2/blob/main/moveit_kinematics/kdl_kinematics_plugin/src/kdl_kinematics_plugin.cpp
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
"""

from collections.abc import Iterator
from itertools import pairwise

from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.samples import arm_xml
from urdfkit.robot.tree import closed_loops
from urdfkit.ros.catalog import data
from urdfkit.ros.moveit.samples import named_xml, srdf_files
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.parameter_types import type_of
from urdfkit.text.located_yaml import Value, scalar
from urdfkit.workspace.manifest import manifest_of

BAD = named_xml("bad", arm_xml("fixed"))
GOOD = BAD.replace('"bad"', '"good"')
FILES = srdf_files('<group name="g"/>', '<group name="g"><link name="arm"/></group>')


#: The settings of a solver that are doubles.
_DOUBLES = ("kinematics_solver_search_resolution", "kinematics_solver_timeout")


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
    yield from _other_sides(context, srdf)
    if len(context.tree.roots) == 1:  # the cause of several trees is reported once
        yield from _chains(srdf)
    yield from _unsolvable(context, srdf)
    yield from _integers(context, srdf)


def _integers(context: Context, srdf: Srdf) -> Findings:
    """Settings of solvers that ROS 2 declares as doubles."""
    manifest = manifest_of(context.resolver, srdf.path)
    for entry in context.moveit_config.group_entries() if manifest and manifest.ros == 2 else ():
        for name in _DOUBLES:
            value = entry.values.get(name)
            if isinstance(value, Value) and type_of(value) == "int":
                message = f"group '{entry.name}': {name} is an integer, must be a number with a "
                message += "decimal point"
                help = f"write {value.text}.0"
                yield Finding(value.span, message, help, severity=Severity.WARNING)


def _other_sides(context: Context, srdf: Srdf) -> Findings:
    """The one joint of a group whose counterpart is on the side of all others."""
    sides = [(left.name, right.name) for left, right in context.symmetric_joints]
    for name, elements in srdf.groups_by_name.items():
        parts = [part for element in elements for part in element.all("joint")]
        named = {part.get("name") or "": part for part in parts}
        alone = [pair for pair in sides if len(named.keys() & set(pair)) == 1]
        by_side = [[pair for pair in alone if pair[side] in named] for side in (0, 1)]
        few, many = sorted(by_side, key=len)
        if len(few) == 1 and len(many) > 1:
            wrong, right = sorted(few[0], key=lambda joint: joint not in named)
            yield Finding(
                named[wrong],
                f"group '{name}' has joint '{wrong}' of the other side, and not '{right}'",
                f"write '{right}'",
                severity=Severity.WARNING,
            )


def _chains(srdf: Srdf) -> Findings:
    links = srdf.known("link")
    for group in srdf.groups:
        for chain in group.all("chain"):
            base, tip = chain.get("base_link") or "", chain.get("tip_link") or ""
            if base not in links or tip not in links or srdf.joints_between(base, tip) is not None:
                continue
            message = f"group '{group.get('name')}': tip link '{tip}' is not a descendant of base "
            message += f"link '{base}'"
            if srdf.joints_between(tip, base) is not None:
                yield Finding(chain, message, "swap base and tip", severity=Severity.WARNING)
            else:
                help = "name links of one branch, unless the group has the joints of both"
                yield Finding(chain, message, help, severity=Severity.INFO)


def _cycles(srdf: Srdf) -> Iterator[list[str]]:
    """The groups of each cycle, from the first by name on; one cycle for each first group."""
    reported: set[str] = set()
    for cycle in closed_loops(srdf.groups_by_name, lambda name: _subgroups(name, srdf)):
        first = min(cycle)
        if first not in reported:
            reported.add(first)
            at = cycle.index(first)
            yield [*cycle[at:], *cycle[:at]]


def _subgroups(name: str, srdf: Srdf) -> Iterator[tuple[str, str]]:
    """The subgroups of a group, each as edge and node of the graph."""
    for element in srdf.groups_by_name.get(name, ()):
        for child in element.all("group"):
            inner = child.get("name") or ""
            yield inner, inner


def _unsolvable(context: Context, srdf: Srdf) -> Findings:
    """Groups that are not a chain, with a solver that requires one."""
    for_chains = tuple(data("moveit")["for_chains"])
    for entry in context.moveit_config.group_entries():
        solver = scalar(entry.values, "kinematics_solver")
        if solver is None or not solver.text.startswith(for_chains):
            continue
        group = srdf.groups_by_name.get(entry.name)
        if group and (reason := _why_no_chain(context, srdf.links_of(entry.name))):
            yield Finding(
                entry.name.span,
                f"group '{entry.name}' is not a chain, which solver '{solver.text}' requires: "
                f"{reason}",
                "define the group by one <chain>, or remove its solver",
                related=(Related(group[0].span, f"group '{entry.name}'"),),
                severity=Severity.WARNING,
            )


def _why_no_chain(context: Context, links: set[str]) -> str:
    """Why the moving joints of a group are not a chain; empty if they are one."""
    paths: list[list[Joint]] = []
    for joint in context.model.joints:
        if joint.kind != "fixed" and joint.child_name in links:
            above = context.tree.path(joint.child_name)
            paths.append([joint for joint in above if joint.kind != "fixed"])
    paths.sort(key=len)
    for before, path in pairwise(paths):
        if path[:-1] != before:
            return f"joint '{path[-1].name}' does not follow joint '{before[-1].name}'"
    is_known = bool(links) and links <= context.model.links_by_name.keys()
    return "none of its joints moves" if is_known and not paths else ""
