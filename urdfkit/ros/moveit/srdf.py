"""SRDF: MoveIt's groups, states and allowed collisions, read together with the robot.

Source of the grammar: srdfdom's parser, and MoveIt's RobotModel, which rejects elements that do not
match the robot.
"""

from collections.abc import Iterator
from functools import cached_property

from urdfkit.core.grouping import by_key
from urdfkit.core.suggest import nearest
from urdfkit.robot.joint import Joint
from urdfkit.robot.tree import KinematicTree
from urdfkit.text.document import Attribute, Element


class Srdf:
    """An SRDF and its robot."""

    def __init__(self, path: str, root: Element, tree: KinematicTree) -> None:
        self.path = path  # of the file
        self.root = root  # its ``<robot>`` element
        self.tree = tree
        #: True if it is for another robot, too: a launch file passes it other arguments than this
        #: robot has, or a URDF next to this robot has its robot name.
        self.is_shared = False
        #: groups, states, end_effectors, virtual_joints: elements.
        self.groups = tuple(root.all("group"))
        self.states = tuple(root.all("group_state"))
        self.end_effectors = tuple(root.all("end_effector"))
        self.virtual_joints = tuple(root.all("virtual_joint"))

    @cached_property
    def groups_by_name(self) -> dict[str, list[Element]]:
        """The elements of each group; MoveIt merges groups with the same name."""
        return by_key((group.get("name") or "", group) for group in self.groups)

    @cached_property
    def disabled(self) -> dict[frozenset[str], Element]:
        """The pairs of links that are disabled individually, each with its first element."""
        pairs: dict[frozenset[str], Element] = {}
        for element in self.root.all("disable_collisions"):
            pairs.setdefault(pair_of(element), element)
        return pairs

    def disables(self, pair: frozenset[str]) -> bool:
        """True if the collisions of two links are not checked.

        ``disable_default_collisions`` applies to all pairs of a link that are not enabled again
        (MoveIt 2.5).
        """
        if pair in self.disabled:
            return True
        links = {
            (element.get("link") or "").strip()
            for element in self.root.all("disable_default_collisions")
        }
        enabled = {pair_of(element) for element in self.root.all("enable_collisions")}
        return not links.isdisjoint(pair) and pair not in enabled

    def references(self) -> Iterator[tuple[str, Attribute]]:
        """References to a ``link``, ``joint`` or ``group``, except in the collision matrix."""
        for group in self.groups:
            for child in group.children:
                if child.tag in ("link", "joint", "group"):
                    yield from _named(child.tag, child, "name")
                elif child.tag == "chain":
                    yield from _named("link", child, "base_link", "tip_link")
        for state in self.states:
            yield from _named("group", state, "group")
            for joint in state.all("joint"):
                yield from _named("joint", joint, "name")
        for effector in self.end_effectors:
            yield from _named("group", effector, "group", "parent_group")
            yield from _named("link", effector, "parent_link")
        for virtual in self.virtual_joints:
            yield from _named("link", virtual, "child_link")
        for passive in self.root.all("passive_joint"):
            yield from _named("joint", passive, "name")

    @cached_property
    def named(self) -> set[str]:
        """Names of all referenced links and joints, including the collision matrix."""
        pairs = (*self.root.all("disable_collisions"), *self.root.all("enable_collisions"))
        references = [name for kind, name in self.references() if kind != "group"]
        names = {name.value for name in references if not is_free_flyer(name)}
        return names.union(*map(pair_of, pairs)) - {""}

    @cached_property
    def unknown(self) -> set[str]:
        """Referenced names that the robot does not have."""
        return self.named - self.known("link") - self.known("joint")

    @cached_property
    def refers_to_robot(self) -> bool:
        """True if the robot has at least half of the referenced links and joints."""
        named = [(kind, name.value) for kind, name in self.references() if kind != "group"]
        known = {kind: self.known(kind) for kind in ("link", "joint")}
        return 2 * sum(name in known[kind] for kind, name in named) >= len(named)

    @cached_property
    def fits_robot(self) -> bool:
        """True if it is for this variant of the robot: except typos, one name may be unknown."""
        unknown = {
            name.value
            for kind, name in self.references()
            if name.value not in (known := self.known(kind)) and not nearest(name.value, known)
        }
        return self.refers_to_robot and len(unknown) <= 1

    def known(self, kind: str) -> frozenset[str]:
        """The names of a kind that the robot or this file defines."""
        return self._known[kind]

    @cached_property
    def _known(self) -> dict[str, frozenset[str]]:
        virtual = {joint.get("name") or "" for joint in self.virtual_joints}
        return {
            "group": frozenset(self.groups_by_name),
            "link": frozenset(self.tree.model.links_by_name),
            "joint": frozenset(virtual.union(self.tree.model.joints_by_name)),
        }

    def joints_between(self, base: str, tip: str) -> list[Joint] | None:
        """The joints from a link down to another; None if the second is not below the first."""
        joints = self.tree.path(tip)
        if base == tip:
            return []
        parents = [joint.parent_name for joint in joints]
        return joints[parents.index(base) :] if base in parents else None

    def links_of(self, name: str, seen: frozenset[str] = frozenset()) -> set[str]:
        """The links of a group and its subgroups; circular subgroups are ignored."""
        links: set[str] = set()
        if name in seen:
            return links
        for group in self.groups_by_name.get(name, ()):
            for child in group.children:
                links |= self._links_of_part(child, seen | {name})
        return links

    def _links_of_part(self, part: Element, seen: frozenset[str]) -> set[str]:
        name = part.get("name") or ""
        if part.tag == "link":
            return {name}
        if part.tag == "joint":
            joint = self.tree.model.joints_by_name.get(name)
            return {joint.child_name} - {""} if joint else set()
        if part.tag == "group":
            return self.links_of(name, seen)
        if part.tag == "chain":
            joints = self.joints_between(part.get("base_link") or "", part.get("tip_link") or "")
            return {joint.child_name for joint in joints or ()}
        return set()


def is_free_flyer(attribute: Attribute) -> bool:
    """True for Pinocchio's floating base, which is not in the URDF: position and quaternion."""
    value = attribute.element.get("value") or ""
    return attribute.value == "root_joint" and len(value.split()) == 7


def is_srdf(root: Element) -> bool:
    """True for the root of an SRDF; the root of a URDF is also a ``<robot>``, but has links."""
    return root.tag == "robot" and root.child("link") is None


def pair_of(element: Element) -> frozenset[str]:
    """The pair of links of an element of the collision matrix; srdfdom trims the names."""
    return frozenset((element.get(key) or "").strip() for key in ("link1", "link2"))


def _named(kind: str, element: Element, *keys: str) -> Iterator[tuple[str, Attribute]]:
    for key in keys:
        attribute = element.attributes.get(key)
        if attribute is not None:
            yield kind, attribute
