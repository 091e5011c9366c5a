"""The tree as JSON: flat lists, parents before children."""

from typing import Any

from urdfkit.core.strict_json import dumped
from urdfkit.output.diagrams.rows import rows
from urdfkit.robot.joint import DEGREES_OF_FREEDOM, Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.kinematics import direction
from urdfkit.robot.tree import KinematicTree

VERSION = 1


def render(tree: KinematicTree) -> str:
    """Links with their parents, and joints with type, axis, limits and origin."""
    tree_rows = list(rows(tree))
    links = tree.model.links_by_name
    document = {
        "version": VERSION,
        "name": tree.model.name,
        "roots": [root.name for root in tree.roots],
        "links": [
            {
                "name": row.link,
                "parent": row.parent or None,
                "depth": row.depth,
                "mass": links[row.link].mass,
            }
            for row in tree_rows
            if not row.is_again
        ],
        "joints": [_joint(row.joint, row.parent, row.link) for row in tree_rows if row.joint],
    }
    return dumped(document)


def _joint(joint: Joint, parent: str, child: str) -> dict[str, Any]:
    limit, mimic = joint.limit, joint.mimic
    moves = joint.kind in DEGREES_OF_FREEDOM
    return {
        "name": joint.name,
        "type": joint.kind,
        "parent": parent,
        "child": child,
        "position": list(joint.origin.position),
        "rotation": [list(row) for row in joint.origin.rotation],
        "axis": list(direction(joint)) if moves and joint.kind != "floating" else None,
        "limits": bounds(joint),
        "effort": limit.effort.value if limit and limit.effort else None,
        "velocity": limit.velocity.value if limit and limit.velocity else None,
        "mimic": {"joint": joint.leader, "multiplier": mimic.multiplier, "offset": mimic.offset}
        if mimic and joint.leader
        else None,
    }
