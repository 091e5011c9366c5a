"""Groups whose solver needs a chain of joints, which they are not."""

from itertools import pairwise

from urdfkit.lint.rules import Context, Finding, Findings, Location, Related, Severity
from urdfkit.robot.model import Joint
from urdfkit.ros.moveit.config import group_entries
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.located_yaml import Value

#: Beginnings of the names of solvers that reject a group which is no chain.
_FOR_CHAINS = (
    "kdl_kinematics_plugin/", "lma_kinematics_plugin/", "trac_ik_kinematics_plugin/",
    "cached_ik_kinematics_plugin/CachedKDL", "cached_ik_kinematics_plugin/CachedTRAC",
)  # fmt: skip


def unsolvable_groups(context: Context, srdf: Srdf) -> Findings:
    """The groups that are given a solver for chains and are none."""
    for entry in group_entries(srdf, context.resolver):
        solver = entry.values.get("kinematics_solver")
        if not isinstance(solver, Value) or not solver.text.startswith(_FOR_CHAINS):
            continue
        group = srdf.groups_by_name.get(entry.name)
        if group and (joints := _branch(context, srdf.links_of(entry.name))):
            first, other = joints
            yield Finding(
                Location(entry.name.span),
                f"group '{entry.name}' is no chain, which solver '{solver.text}' needs: joint "
                f"'{other.name}' does not follow joint '{first.name}'",
                "define the group by one <chain>, or remove its solver",
                related=(Related(group[0].span, f"group '{entry.name}'"),),
                severity=Severity.WARNING,
            )


def _branch(context: Context, links: set[str]) -> tuple[Joint, Joint] | None:
    """Two moving joints of a group of which none follows the other; None if it is a chain."""
    paths: list[list[Joint]] = []
    for joint in context.model.joints:
        if joint.kind != "fixed" and joint.child_name in links:
            above = context.tree.path(joint.child_name)
            paths.append([one for one in above if one.kind != "fixed"])
    paths.sort(key=len)
    for before, path in pairwise(paths):
        if path[:-1] != before:
            return before[-1], path[-1]
    return None
