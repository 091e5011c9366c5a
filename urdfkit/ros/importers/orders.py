"""The orders in which programs number the joints of a URDF."""

from collections import deque
from collections.abc import Callable, Iterable

from urdfkit.robot.model import Joint
from urdfkit.robot.tree import KinematicTree

#: The name of the world, in every program.
WORLD = "world"

#: Takes a link, and returns the joints below it.
Below = Callable[[str], Iterable["Joint"]]


def ordered(tree: KinematicTree, walk: str, siblings: str, *, merged: bool) -> list[Joint]:
    """The joints of a robot, fixed ones included, in the order of a program.

    Args:
        tree: of the robot; what no root leads to is left out.
        walk: ``depth``, ``breadth`` or ``file``.
        siblings: ``file``, ``joint`` or ``link``.
        merged: True if fixed joints are merged before the walk. That changes an order by breadth:
            what is below a fixed joint is one level higher then.
    """
    if walk == "file":
        return list(tree.model.joints)
    sort = _sorter(tree, siblings)
    if walk == "breadth":
        below = _without_fixed(tree, sort) if merged else lambda link: sort(tree.children[link])
        found = _breadth_first(tree, below)
        return found + [joint for joint in tree.spanning if joint.kind == "fixed" and merged]
    return _depth_first(tree, lambda link: sort(tree.children[link]))


def free_trees(tree: KinematicTree, order: Iterable[Joint]) -> list[Joint | None]:
    """The joints by the trees that floating joints cut a robot into; None is a free root.

    What is connected to the world comes first; then come the trees whose root has most joints, of
    equal ones in the order of the links in the document.

    Args:
        order: of the joints, depth first.
    """
    base_of: dict[str, str] = {}  # the root of the tree of each link
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
    """Orders the joints below one link; those of a model are in the order of the document."""
    if siblings == "joint":
        return lambda joints: sorted(joints, key=lambda joint: joint.name)
    if siblings == "link":
        place = {name: index for index, name in enumerate(tree.model.links_by_name)}
        return lambda joints: sorted(joints, key=lambda joint: place[joint.child_name])
    place = {joint.name: index for index, joint in enumerate(tree.model.joints)}
    return lambda joints: sorted(joints, key=lambda joint: place[joint.name])


def _depth_first(tree: KinematicTree, below: Below) -> list[Joint]:
    found: list[Joint] = []
    seen = {root.name for root in tree.roots}
    stack = [joint for root in tree.roots for joint in below(root.name)][::-1]
    while stack:
        joint = stack.pop()
        if joint.child_name not in seen:
            seen.add(joint.child_name)
            found.append(joint)
            stack += reversed(list(below(joint.child_name)))
    return found


def _breadth_first(tree: KinematicTree, below: Below) -> list[Joint]:
    found: list[Joint] = []
    seen = {root.name for root in tree.roots}
    queue = deque(root.name for root in tree.roots)
    while queue:
        for joint in below(queue.popleft()):
            if joint.child_name not in seen:
                seen.add(joint.child_name)
                found.append(joint)
                queue.append(joint.child_name)
    return found


def _without_fixed(tree: KinematicTree, sort: Callable[[Iterable[Joint]], list[Joint]]) -> Below:
    """The moving joints below a link and all that is fixed to it."""

    def below(link: str) -> list[Joint]:
        moving: list[Joint] = []
        seen = {link}
        group = [link]
        for name in group:  # grows while it is walked
            for joint in tree.children[name]:
                if joint.kind != "fixed":
                    moving.append(joint)
                elif joint.child_name not in seen:
                    seen.add(joint.child_name)
                    group.append(joint.child_name)
        return sort(moving)

    return below
