"""The orders in which programs number the joints of a URDF."""

from collections import deque
from collections.abc import Callable, Iterable

from urdfkit.robot.joint import Joint
from urdfkit.robot.tree import KinematicTree

#: Name of the world in all programs.
WORLD = "world"

#: Returns the child joints of a link.
Below = Callable[[str], list[Joint]]


def ordered(tree: KinematicTree, walk: str, siblings: str, *, merged: bool) -> list[Joint]:
    """The joints of a robot, including fixed joints, in the order of a program.

    Args:
        tree: of the robot; links that no root leads to are ignored.
        walk: ``depth``, ``breadth`` or ``file``.
        siblings: ``file``, ``joint`` or ``link``.
        merged: True if fixed joints are merged before the walk. This changes a breadth-first
            order: joints below a fixed joint are one level higher.
    """
    if walk == "file":
        return list(tree.model.joints)
    sort = _sorter(tree, siblings)
    if walk == "breadth":
        below = _without_fixed(tree, sort) if merged else lambda link: sort(tree.children[link])
        order = _walk(tree, below, is_depth_first=False)
        return order + [joint for joint in tree.spanning if joint.kind == "fixed" and merged]
    return _walk(tree, lambda link: sort(tree.children[link]), is_depth_first=True)


def free_trees(tree: KinematicTree, order: Iterable[Joint]) -> list[Joint | None]:
    """The joints by the trees into which floating joints split a robot; None is a free root.

    The tree of the world comes first, then the trees by number of joints of their roots,
    descending; equal trees are in the order of the links in the document.

    Args:
        order: of the joints, depth first.
    """
    base_of: dict[str, str] = {}  # root of the tree of each link
    trees: dict[str, list[Joint | None]] = {root.name: [None] for root in tree.roots}
    for joint in order:
        is_cut = joint.kind == "floating"
        base = joint.child_name if is_cut else base_of.get(joint.parent_name, joint.parent_name)
        base_of[joint.child_name] = base
        trees.setdefault(base, []).append(joint)
    place = {name: index for index, name in enumerate(tree.model.links_by_name)}

    def rank(base: str) -> tuple[bool, int, int]:
        joints = sum(joint.kind != "floating" for joint in tree.children[base])
        return base != WORLD, -joints, place[base]

    bases = sorted(trees, key=rank)
    return [joint for base in bases for joint in trees[base]]


def _sorter(tree: KinematicTree, siblings: str) -> Callable[[Iterable[Joint]], list[Joint]]:
    """A function that sorts the child joints of a link; joints of a model are in document order."""
    if siblings == "joint":
        return lambda joints: sorted(joints, key=lambda joint: joint.name)
    if siblings == "link":
        place = {name: index for index, name in enumerate(tree.model.links_by_name)}
        return lambda joints: sorted(joints, key=lambda joint: place[joint.child_name])
    place = {joint.name: index for index, joint in enumerate(tree.model.joints)}
    return lambda joints: sorted(joints, key=lambda joint: place[joint.name])


def _walk(tree: KinematicTree, below: Below, *, is_depth_first: bool) -> list[Joint]:
    order: list[Joint] = []
    visited = {root.name for root in tree.roots}
    waiting = deque(joint for root in tree.roots for joint in below(root.name))
    while waiting:
        joint = waiting.popleft()
        if joint.child_name not in visited:
            visited.add(joint.child_name)
            order.append(joint)
            if is_depth_first:
                waiting.extendleft(reversed(below(joint.child_name)))
            else:
                waiting.extend(below(joint.child_name))
    return order


def _without_fixed(tree: KinematicTree, sort: Callable[[Iterable[Joint]], list[Joint]]) -> Below:
    """The moving joints below a link and the links fixed to it."""

    def below(link: str) -> list[Joint]:
        moving: list[Joint] = []
        visited = {link}
        group = [link]
        for name in group:  # extended in the loop
            for joint in tree.children[name]:
                if joint.kind != "fixed":
                    moving.append(joint)
                elif joint.child_name not in visited:
                    visited.add(joint.child_name)
                    group.append(joint.child_name)
        return sort(moving)

    return below
