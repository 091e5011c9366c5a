"""The kinematic tree of a model, for any graph of links and joints.

Cycles, two parents, islands, unknown links and chains of 100 000 links are normal input: nothing
is recursive, and every walk visits a link once.
"""

from collections.abc import Callable, Iterable, Iterator
from functools import cached_property
from itertools import islice

from urdfkit.core.spatial import Transform
from urdfkit.core.static_typing import TypeVar
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link
from urdfkit.robot.model import RobotModel
from urdfkit.text.source import shown

#: Listed loops; a malicious graph has as many loops as joints, each as long as the robot.
MAX_LOOPS = 20

_DONE = -1

Edge = TypeVar("Edge")


class KinematicTree:
    """The parent and child joints of each link.

    Joints with a missing link, or from a link to itself, are ignored.
    """

    def __init__(self, model: RobotModel) -> None:
        self.model = model
        #: Joints by the name of their parent link.
        self.children: dict[str, list[Joint]] = {name: [] for name in model.links_by_name}
        #: Joints by the name of their child link; more than one joint of a link is a defect.
        self.parents: dict[str, list[Joint]] = {name: [] for name in model.links_by_name}
        for joint in model.joints:
            ends = self.ends(joint)
            if ends and ends[0] != ends[1]:
                self.children[ends[0]].append(joint)
                self.parents[ends[1]].append(joint)

    def ends(self, joint: Joint) -> tuple[str, str] | None:
        """Parent and child of a joint; None unless the model has both links."""
        parent, child = joint.parent_name, joint.child_name
        links = self.model.links_by_name
        return (parent, child) if parent in links and child in links else None

    def published_joint(self, link: str) -> Joint | None:
        """The joint above a link whose transform robot_state_publisher publishes; None if none.

        It leaves out floating joints, whose transform is not among the joint states.
        """
        joints = self.parents.get(link, ())
        return next((joint for joint in joints if joint.kind != "floating"), None)

    @cached_property
    def is_sound(self) -> bool:
        """True if all links and joints have unique names and form one tree."""
        model, links = self.model, len(self.parents)
        return (
            len(model.links) == links == len(model.joints) + 1
            and len(model.joints_by_name) == len(model.joints)
            and len(self.roots) == 1
            and len(self.below(self.roots[0].name)) == links
        )

    @property
    def unsound(self) -> str:
        """Error message of computations that require one tree."""
        place = self.model.place()
        defect = "links and joints do not form one tree"
        if not self.model.links:
            defect = "it has no link; it may be a macro file for other files to include"
        return f"{place}: {defect}; see 'urdfkit check {shown(place.source.path)}'"

    @cached_property
    def roots(self) -> tuple[Link, ...]:
        """The links without a parent joint, in document order."""
        links = self.model.links_by_name
        return tuple(links[name] for name, joints in self.parents.items() if not joints)

    @property
    def has_base(self) -> bool:
        """False if all roots are children of joints without a parent, as in a part of a robot."""
        children = {joint.child_name for joint in self.model.joints}
        return any(root.name not in children for root in self.roots)

    def below(self, name: str) -> list[str]:
        """A link and its descendants, depth first: a subtree is a contiguous part of the list."""
        descendants: dict[str, None] = {}
        stack = [name]
        while stack:
            link = stack.pop()
            if link not in descendants:
                descendants[link] = None
                below = [joint.child_name for joint in self.children[link]]
                stack.extend(reversed(below))
        return list(descendants)

    @property
    def cycles(self) -> tuple[tuple[Joint, ...], ...]:
        """The first ``MAX_LOOPS`` closed loops, each as its joints in order; no loop twice."""

        def below(name: str) -> Iterator[tuple[Joint, str]]:
            return ((joint, joint.child_name) for joint in self.children[name])

        return tuple(islice(closed_loops(self.children, below), MAX_LOOPS))

    @cached_property
    def spanning(self) -> tuple[Joint, ...]:
        """The joints of a spanning tree from the roots, parents before children.

        Of several joints with the same child, the first that the walk meets counts; links in a
        closed loop without a root have none.
        """
        joints: list[Joint] = []
        stack = [root.name for root in reversed(self.roots)]
        visited = set(stack)
        while stack:
            for joint in self.children[stack.pop()]:
                child = joint.child_name
                if child not in visited:
                    visited.add(child)
                    stack.append(child)
                    joints.append(joint)
        return tuple(joints)

    @cached_property
    def _above(self) -> dict[str, Joint]:
        return {joint.child_name: joint for joint in self.spanning}

    def path(self, link: str) -> list[Joint]:
        """The joints from the root to a link."""
        joints: list[Joint] = []
        while joint := self._above.get(link):
            joints.append(joint)
            link = joint.parent_name
        return joints[::-1]

    def branches(self, first: str, second: str) -> tuple[list[Joint], list[Joint]]:
        """The joints to two links from their last common ancestor, or from the root of each."""
        paths = self.path(first), self.path(second)
        shared = sum(a is b for a, b in zip(*paths, strict=False))
        return paths[0][shared:], paths[1][shared:]

    @cached_property
    def root_of(self) -> dict[str, str]:
        """The root of each link; links in a closed loop without a root are omitted."""
        roots = {root.name: root.name for root in self.roots}
        for joint in self.spanning:
            roots[joint.child_name] = roots[joint.parent_name]
        return roots

    @cached_property
    def frames(self) -> dict[str, Transform]:
        """The frame of each link with all joints at 0, in the frame of its root."""
        frames = {root.name: Transform() for root in self.roots}
        for joint in self.spanning:
            frames[joint.child_name] = frames[joint.parent_name] @ joint.origin
        return frames


def closed_loops(
    nodes: Iterable[str], edges: Callable[[str], Iterator[tuple[Edge, str]]]
) -> Iterator[tuple[Edge, ...]]:
    """The closed loops of a directed graph that a depth-first walk along all edges meets.

    Args:
        edges: the outgoing edges of a node, each with its end node.

    Yields:
        The edges of a loop, in order.
    """
    depths: dict[str, int] = {}  # of the nodes on the current path; `_DONE` for finished nodes
    for start in nodes:
        if start not in depths:
            yield from _loops_from(start, edges, depths)


def _loops_from(
    start: str, edges: Callable[[str], Iterator[tuple[Edge, str]]], depths: dict[str, int]
) -> Iterator[tuple[Edge, ...]]:
    path: list[Edge] = []
    stack = [(start, edges(start))]
    depths[start] = 0
    while stack:
        node, left = stack[-1]
        for edge, end in left:
            if end not in depths:
                depths[end] = len(stack)
                path.append(edge)
                stack.append((end, edges(end)))
                break
            if depths[end] != _DONE:
                yield (*path[depths[end] :], edge)
        else:
            depths[node] = _DONE
            stack.pop()
            del path[-1:]
