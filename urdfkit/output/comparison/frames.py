"""Links whose poses differ between two states."""

from __future__ import annotations

from math import dist

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform
from urdfkit.output.comparison.differences import RenamedParts, Tolerances, angle_between
from urdfkit.robot.kinematics import frames
from urdfkit.robot.tree import KinematicTree


class MovedLink(Record):
    """A link with another pose."""

    link: str  # name in the state after
    distance: float  # between its origins, in m, in the frame of the root
    angle: float  # of its rotation, in rad
    carried: bool  # True if only its parent moved


def moved_frames(
    before: KinematicTree, after: KinematicTree, allowed: Tolerances, names: RenamedParts
) -> tuple[MovedLink, ...]:
    """Links of both robots with another pose when all joints are at zero.

    Returns:
        Links that moved relative to their parents before links that moved with them, the
        farthest first.
    """
    old, new = frames(before, {}), frames(after, {})
    found = []
    for name in old:
        now = names.links.get(name, name)
        if now not in new:
            continue
        distance, angle = _apart(old[name], new[now])
        if distance > allowed.position or angle > allowed.rotation:
            parents = _parent(before, name), _parent(after, now)
            shift, turn = _apart(_within(old, name, parents[0]), _within(new, now, parents[1]))
            stays = shift <= allowed.position and turn <= allowed.rotation
            is_same = names.links.get(parents[0], parents[0]) == parents[1]
            found.append(MovedLink(now, distance, angle, bool(parents[0]) and is_same and stays))
    return tuple(sorted(found, key=lambda m: (m.carried, -m.distance, -m.angle, m.link)))


def _apart(before: Transform, after: Transform) -> tuple[float, float]:
    """Distance in m and angle in rad."""
    return dist(before.position, after.position), angle_between(before, after)


def _parent(tree: KinematicTree, name: str) -> str:
    joints = tree.parents[name]
    return joints[0].parent_name if joints else ""


def _within(places: dict[str, Transform], name: str, parent: str) -> Transform:
    """The frame of a link in its parent; in the root if it has no parent."""
    if parent not in places:
        return places[name]
    return places[parent].inverse @ places[name]
