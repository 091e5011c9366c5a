"""More than one link has no parent.

A robot is one tree: every link except the root is the child of a joint. urdfdom (RViz, MoveIt,
Gazebo, Pinocchio) and PyBullet reject a robot with two roots. MuJoCo, Drake, Newton and yourdfpy
load the parts as separate bodies: a warning if they are the only targets. Connect each of the other
roots with a joint, or remove it.

Sources:
    URDF, robot: https://wiki.ros.org/urdf/XML/robot
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
"""

from collections.abc import Iterator

from urdfkit.core.suggest import Suggester
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.link import Link
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml
from urdfkit.robot.tree import KinematicTree

BAD = robot_xml(link_xml("base"), link_xml("arm"), link_xml("camera"), joint_xml("fixed"))
GOOD = robot_xml(BAD, joint_xml("fixed", name="camera_joint", parent="arm", child="camera"))

#: Number of roots that a message lists; the others are counted.
MAX_NAMED = 8


@rule(
    Severity.ERROR,
    help="connect each of the others to the robot with a joint, or remove it",
    reports_missing=True,
    depends_on_arguments=True,
)
def check(context: Context) -> Findings:
    # REF001 reports a child of a missing link, which is not a root, and a misspelt child.
    children = {joint.child_name for joint in context.model.joints}
    children |= set(_intended_children(context))
    joints = [*context.document.root.all("drake:joint")]
    if joints and context.targets.all_are("reads_drake_joints"):
        children |= {child.get("link") or "" for joint in joints for child in joint.all("child")}
    roots = [root for root in context.tree.roots if root.name not in children]
    if len(roots) < 2 or context.is_part:
        return
    main = _largest(context.tree, roots)
    others = [root for root in roots if root is not main]
    names = [f"'{root.name}'" for root in roots]
    yield Finding(
        others[0].at,
        f"{len(roots)} root links: {few(names, MAX_NAMED)}",
        related=tuple(
            Related(root.at.span, f"'{root.name}' has no parent")
            for root in (main, *others[1:MAX_NAMED])
        ),
    )


def _intended_children(context: Context) -> Iterator[str]:
    """The links whose names the joints misspell."""
    links = context.model.links_by_name
    suggester = Suggester(links)
    for joint in context.model.joints:
        if joint.child_name and joint.child_name not in links:
            intended = suggester.suggested(joint.child_name)
            if intended != joint.parent_name:
                yield intended


def _largest(tree: KinematicTree, roots: list[Link]) -> Link:
    """The root with the most links below it; a link below two roots counts for the first."""
    seen: set[str] = set()
    sizes: dict[str, int] = {}
    for root in roots:
        before = len(seen)
        queue = [root.name]
        while queue:
            name = queue.pop()
            if name not in seen:
                seen.add(name)
                queue += [joint.child_name for joint in tree.children[name]]
        sizes[root.name] = len(seen) - before
    return max(roots, key=lambda root: sizes[root.name])
