"""Gazebo's conversion of a robot: merged links, dropped links, and new names.

Gazebo converts URDF to SDF: it merges the child of every fixed joint into the parent, drops links
without mass together with everything below them, and renames collisions and visuals. Plugins and
sensors see the result, not the URDF.

Source: ``parser_urdf.cc`` of gazebosim/sdformat, versions 9 to 16; the tests compare with
libsdformat 12.3.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from urdfkit.core.record import Record
from urdfkit.robot.inertia import MassProperties
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Body, Link
from urdfkit.robot.model import RobotModel
from urdfkit.robot.rigid_bodies import KEEPING_TAGS, NO_MASS, RigidBody, rigid_bodies
from urdfkit.robot.tree import KinematicTree
from urdfkit.ros.gazebo.values import is_true
from urdfkit.text.document import Element

#: SDF's type for each joint type; URDF's other types have no counterpart.
JOINT_TYPES = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
}
#: The link of the ground; Gazebo never creates it.
WORLD = "world"
#: Separator between the name of a link and the name of a merged collision or visual.
LUMP = "_fixed_joint_lump__"


class Converter(Record):
    """Rules by which a generation of sdformat drops links."""

    name: str  # range of versions
    least_mass: float  # a link of this mass in kg or less counts as massless
    stops_at_merged: bool  # True if a merged massless link loses the joints below it
    has_frames: bool  # True if merged links and joints remain as frames


OLD = Converter("sdformat before 9.10.1 and 12.7.2", NO_MASS, True, False)
NEW = Converter("sdformat from 9.10.1 and 12.7.2", 0.0, False, True)


def children_by_name(tree: KinematicTree, link: str) -> list[Joint]:
    """The child joints of a link in urdfdom's order, by name."""
    return sorted(tree.children[link], key=lambda joint: joint.name)


class SimulatedLink:
    """A link in Gazebo."""

    def __init__(self, body: RigidBody, tree: KinematicTree) -> None:
        self.body = body  # the links of the URDF that it consists of
        self._tree = tree

    @property
    def name(self) -> str:
        return self.body.top.name

    @cached_property
    def properties(self) -> MassProperties:
        return self.body.properties

    @cached_property
    def collisions(self) -> tuple[tuple[str, Element], ...]:
        """Gazebo's name of each collision, and its element."""
        return tuple(_named(self._merging_order, "collision"))

    @cached_property
    def visuals(self) -> tuple[tuple[str, Element], ...]:
        """Gazebo's name of each visual, and its element."""
        return tuple(_named(self._merging_order, "visual"))

    @cached_property
    def _merging_order(self) -> list[Link]:
        """The links of the body in the order in which shapes are merged: by joint name."""
        left = set(self.body.names)  # prevents an endless loop
        order: list[Link] = []
        stack = [self.name]
        while stack:
            name = stack.pop()
            if name not in left:
                continue
            left.remove(name)
            order.append(self._tree.model.links_by_name[name])
            joints = children_by_name(self._tree, name)
            stack += [joint.child_name for joint in reversed(joints)]
        return order


class SimulatedJoint(Record):
    """A joint in Gazebo: its SDF type and its links."""

    joint: Joint
    type: str
    parent: str
    child: str


class SdfConversion:
    """A robot after Gazebo's conversion.

    Attributes:
        model: the URDF.
        converter: the generation of sdformat.
        links: links in Gazebo, parents before children.
        joints: joints in Gazebo.
        dropped: reasons by name of a dropped link; merged links are excluded.
        massless: bodies that are dropped because they have no mass, not with another body.
        kept: names of fixed joints that are not merged.
        stranded: bodies that are dropped with a merged link without mass.
        added_links, added_joints: SDF elements from ``<gazebo>`` tags.
    """

    def __init__(self, tree: KinematicTree, converter: Converter = NEW) -> None:
        self.model = model = tree.model
        self.converter = converter
        self.tree = tree
        self.preserved = frozenset(_preserved(model))
        self.kept = self.preserved | {joint.name for joint in tree.children.get(WORLD, ())}
        self._bodies = rigid_bodies(tree, self.kept)
        self._body_of = {name: body for body in self._bodies for name in body.names}
        self.dropped: dict[str, str] = {}
        self.massless: list[RigidBody] = []
        self.stranded: list[RigidBody] = []
        survivors = [body for body in self._bodies if self._survives(body)]
        self.links = tuple(SimulatedLink(body, tree) for body in survivors)
        self.joints = tuple(self._joints(survivors))
        self.added_links = tuple(_added(model, "link"))
        self.added_joints = tuple(_added(model, "joint"))

    @property
    def added(self) -> frozenset[str]:
        """Names of the links and joints that ``<gazebo>`` tags add as SDF."""
        return frozenset(tag.get("name") or "" for tag in self.added_links + self.added_joints)

    def lost_joint_ends(self) -> Iterator[tuple[Element, Element, str]]:
        """Ends of added joints that are not links: joint, end, and the link that it is merged into.

        The last is empty for a name that is not in the converted model.
        """
        frames = {"world", *self.joint_names, *self.added, *(link.name for link in self.links)}
        frames |= {
            frame.get("name") or "" for block in self.model.gazebo for frame in block.all("frame")
        }
        for joint in self.added_joints:
            for end in filter(None, (joint.child("parent"), joint.child("child"))):
                name = end.text.strip()
                if name and "::" not in name and name not in frames:
                    yield joint, end, self.merged.get(name, "")

    @cached_property
    def survivor(self) -> dict[str, str]:
        """Gazebo's link for each link of the URDF, which may be merged into it, by name."""
        return {name: link.name for link in self.links for name in link.body.names}

    @cached_property
    def joint_names(self) -> frozenset[str]:
        """Names of the joints in Gazebo."""
        return frozenset(simulated.joint.name for simulated in self.joints)

    @property
    def merged(self) -> dict[str, str]:
        """The link that each merged link is merged into."""
        return {name: into for name, into in self.survivor.items() if name != into}

    def merged_joints(self) -> Iterator[Joint]:
        """The joints whose links sdformat merges, deepest first; of a robot that is one tree."""
        stack: list[tuple[str, Joint | None, bool]] = [(self.tree.roots[0].name, None, False)]
        while stack:
            name, joint, is_done = stack.pop()
            children = [
                (child.child_name, child, False)
                for child in reversed(children_by_name(self.tree, name))
                if self.merges(child) != is_done
            ]
            if not is_done:
                stack.append((name, joint, True))
            elif joint is not None and self.merges(joint):
                yield joint
            stack += children

    def undefined_centers(self) -> Iterator[Joint]:
        """The merged joints of two links with a total mass of 0, by which sdformat divides.

        Source: ``dMassAdd`` in its parser_urdf.cc, in all versions.
        """
        masses = {link.name: link.mass for link in self.model.links if link.inertial}
        for joint in self.merged_joints() if self.tree.is_sound else ():
            link, into = joint.child_name, joint.parent_name
            if link in masses and link in self.survivor:
                masses[into] = masses.get(into, 0.0) + masses[link]
                if masses[into] == 0:
                    yield joint

    def merges(self, joint: Joint) -> bool:
        """True if the child of a joint is merged into its parent, or dropped with it."""
        return (
            joint.kind == "fixed"
            and joint.name not in self.preserved
            and joint.parent_name not in ("", WORLD)
        )

    def _survives(self, body: RigidBody) -> bool:
        """True if Gazebo creates a link for a body; parents come before their children."""
        if body.top.name == WORLD:
            return False
        reason = self._lost_with_parent(body)
        if reason is None and self._is_massless(body.mass):
            reason = "no inertial" if body.top.inertial is None else f"mass {body.mass:g} kg"
            self.massless.append(body)
        if reason is None:
            return True
        self.dropped.update(dict.fromkeys(body.names, reason))
        return False

    def _is_massless(self, mass: float) -> bool:
        least = self.converter.least_mass
        return abs(mass) <= least if least else mass <= 0

    def _lost_with_parent(self, body: RigidBody) -> str | None:
        """Why a body is dropped with its parent; None if it is not."""
        if body.joint is None:
            return None
        parent = body.joint.parent_name
        if parent in self.dropped:
            return f"child of '{parent}', which is dropped"
        if self.converter.stops_at_merged:
            for link in self._merged_above(parent):
                if self._is_massless(self._mass_below(link)):
                    self.stranded.append(body)
                    return f"child of '{link.name}', which is merged and has no mass"
        return None

    def _merged_above(self, name: str) -> Iterator[Link]:
        """A link and its ancestors below the link that it is merged into."""
        body = self._body_of[name]
        visited: set[str] = set()  # links may form a loop: TRE003
        while name != body.top.name and name not in visited:
            visited.add(name)
            yield self.model.links_by_name[name]
            name = self.tree.parents[name][0].parent_name

    def _mass_below(self, link: Link) -> float:
        """Mass of a link and of all links that are merged into it."""
        total = 0.0
        queue, visited = [link.name], {link.name}
        for name in queue:  # extended in the loop
            total += self.model.links_by_name[name].mass
            for joint in self.tree.children[name]:
                if self.merges(joint) and joint.child_name not in visited:  # links may form a loop
                    visited.add(joint.child_name)
                    queue.append(joint.child_name)
        return total

    def _joints(self, survivors: list[RigidBody]) -> Iterator[SimulatedJoint]:
        for body in survivors:
            joint = body.joint
            if joint is None or joint.kind not in JOINT_TYPES:
                continue
            parent = joint.parent_name
            parent = parent if parent == WORLD else self.survivor[parent]
            yield SimulatedJoint(joint, JOINT_TYPES[joint.kind], parent, body.top.name)


def _preserved(model: RobotModel) -> Iterator[str]:
    """Names of the fixed joints that ``<gazebo>`` tags preserve."""
    for gazebo in model.gazebo:
        reference = gazebo.get("reference")
        if reference and any(
            child.tag in KEEPING_TAGS and is_true(child) for child in gazebo.children
        ):
            yield reference


def _added(model: RobotModel, kind: str) -> Iterator[Element]:
    """SDF elements in ``<gazebo>`` tags without a reference, which are copied unchanged."""
    for gazebo in model.gazebo:
        if not gazebo.get("reference"):
            yield from (child for child in gazebo.all(kind) if child.get("name"))


def _named(order: list[Link], kind: str) -> Iterator[tuple[str, Element]]:
    """Names of a link's collisions or visuals, with those of the links merged into it."""
    number = 0
    for link in order:
        for part in link.collisions if kind == "collision" else link.visuals:
            suffix = f"_{number}" if number else ""
            yield f"{_stem(order[0], link, part, kind)}{suffix}", part.at
            number += 1


def _stem(top: Link, link: Link, part: Body, kind: str) -> str:
    name = part.at.get("name") or ("" if link is top else link.name)
    if not name:
        return f"{top.name}_{kind}"
    if name.startswith(top.name):
        return f"{name}_{kind}"
    return f"{top.name}{LUMP}{name}_{kind}"
