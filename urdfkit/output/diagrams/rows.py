"""The kinematic tree as rows, parents before children, for all diagrams."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.robot.joint import DEGREES_OF_FREEDOM, Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.kinematics import direction
from urdfkit.robot.tree import KinematicTree


class TreeRow(Record):
    """A link, and one of its parent joints."""

    link: str  # name
    joint: Joint | None  # parent joint; None for a root
    parent: str  # the link above; empty for a root
    depth: int  # number of joints above
    is_last: bool  # True for the last child of its parent
    #: True if an earlier row has the link with its children: a loop, or a second parent.
    is_again: bool


def rows(tree: KinematicTree) -> Iterator[TreeRow]:
    """All links in document order; links that no root leads to come last."""
    visited: set[str] = set()
    for start in (*(root.name for root in tree.roots), *tree.children):
        if start in visited:
            continue
        stack: list[TreeRow] = [TreeRow(start, None, "", 0, True, False)]
        while stack:
            row = stack.pop()
            row = row._replace(is_again=row.link in visited)
            yield row
            if row.is_again:
                continue
            visited.add(row.link)
            below = tree.children[row.link]
            for index in range(len(below) - 1, -1, -1):
                joint, is_last = below[index], index == len(below) - 1
                stack.append(
                    TreeRow(joint.child_name, joint, row.link, row.depth + 1, is_last, False)
                )


def axis(joint: Joint) -> str:
    """The axis of a joint, such as ``z``, ``-y`` or ``0.6 0 0.8``; empty without an axis."""
    if joint.kind not in DEGREES_OF_FREEDOM or joint.kind == "floating":
        return ""
    vector = direction(joint)
    for index, name in enumerate("xyz"):
        if abs(vector[index]) == 1.0:
            return name if vector[index] > 0 else f"-{name}"
    return " ".join(f"{round(part, 6) + 0.0:.3g}" for part in vector)  # no -0 and no 1e-17


def limits(joint: Joint) -> list[str]:
    """The defined limits of a joint: position, effort and velocity."""
    texts: list[str] = []
    of, ends = joint.unit, bounds(joint)
    if ends:
        texts.append(f"{ends[0]:.4g} to {ends[1]:.4g} {of}")
    if joint.limit and joint.limit.effort and joint.kind in DEGREES_OF_FREEDOM:
        texts.append(f"{joint.limit.effort.value:.4g} {joint.effort_unit}")
    if joint.limit and joint.limit.velocity and joint.kind in DEGREES_OF_FREEDOM:
        texts.append(f"{joint.limit.velocity.value:.4g} {of}/s")
    return texts


def caption(joint: Joint) -> str:
    """Type, axis, limits and leader: ``revolute about y, -1.5 to 1.5 rad, 20 N·m, 2 rad/s``."""
    return ", ".join(captions(joint))


def captions(joint: Joint) -> list[str]:
    """The parts of `caption`."""
    along = axis(joint)
    preposition = {"prismatic": "along", "planar": "across"}.get(joint.kind, "about")
    parts = [f"{joint.kind or 'without type'}{f' {preposition} {along}' if along else ''}"]
    parts += limits(joint)
    if joint.mimic and joint.leader:
        multiplier, offset = joint.mimic.multiplier, joint.mimic.offset
        factor = f"{multiplier:.4g} x " if multiplier != 1 else ""
        shift = f" {offset:+.4g}" if offset else ""
        parts.append(f"follows {factor}{joint.leader}{shift}")
    return parts
