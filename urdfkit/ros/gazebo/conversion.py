"""What Gazebo makes of a robot: which links merge, which are dropped, and what things are called.

Gazebo converts URDF to SDF. On the way it merges the child of every fixed joint into the parent,
drops links without mass together with everything below them, and gives collisions and
visuals names of its own. Every plugin and sensor sees the result, not the URDF.

Source: ``parser_urdf.cc`` of gazebosim/sdformat, versions 9 to 16; the tests compare with
libsdformat 12.3.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from urdfkit.core.record import Record
from urdfkit.robot.inertia import MassProperties
from urdfkit.robot.model import Body, Joint, Link, RobotModel
from urdfkit.robot.rigid_bodies import KEEPING_TAGS, NO_MASS, RigidBody, rigid_bodies
from urdfkit.robot.tree import KinematicTree
from urdfkit.ros.gazebo.values import is_true
from urdfkit.text.document import Element

#: What SDF has for each type of joint; URDF's other types have no counterpart.
JOINT_TYPES = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
}
#: The link of the ground; Gazebo never creates it.
WORLD = "world"
#: Between the names of a link and of what is merged into it.
LUMP = "_fixed_joint_lump__"


class Converter(Record):
    """How a generation of sdformat drops links."""

    name: str  # of its versions
    least_mass: float  # a link of this mass in kg or less counts as massless
    stops_at_merged: bool  # True if a massless link that is merged loses the joints below it
    has_frames: bool  # True if merged links and joints leave frames of their names


OLD = Converter("sdformat before 9.10.1 and 12.7.2", NO_MASS, True, False)
NEW = Converter("sdformat from 9.10.1 and 12.7.2", 0.0, False, True)


class SimulatedLink:
    """A link as Gazebo has it."""

    def __init__(self, body: RigidBody, tree: KinematicTree) -> None:
        self.body = body  # the links of the URDF that it is made of
        self._tree = tree

    @property
    def name(self) -> str:
        return self.body.top.name

    @cached_property
    def properties(self) -> MassProperties:
        return self.body.properties

    @cached_property
    def collisions(self) -> tuple[tuple[str, Element], ...]:
        """What Gazebo calls each collision, and its element."""
        return tuple(_named(self._merging_order, "collision"))

    @cached_property
    def visuals(self) -> tuple[tuple[str, Element], ...]:
        """What Gazebo calls each visual, and its element."""
        return tuple(_named(self._merging_order, "visual"))

    @cached_property
    def _merging_order(self) -> list[Link]:
        """The links of the body as their shapes are merged: by the names of their joints."""
        left = {link.name for link, _ in self.body.links}  # a loop of joints ends there
        order: list[Link] = []
        stack = [self.name]
        while stack:
            name = stack.pop()
            if name not in left:
                continue
            left.remove(name)
            order.append(self._tree.model.links_by_name[name])
            joints = sorted(self._tree.children[name], key=lambda one: one.name, reverse=True)
            stack += [joint.child_name for joint in joints]
        return order


class SimulatedJoint(Record):
    """A joint as Gazebo has it: its type in SDF, and the links between which it is."""

    joint: Joint
    type: str
    parent: str
    child: str


class SdfConversion:
    """A robot after Gazebo's conversion.

    Attributes:
        model: the URDF.
        converter: the generation of sdformat.
        links: that Gazebo has, parents before children.
        joints: that Gazebo has.
        dropped: reasons by the name of a link that Gazebo does not have, merged ones aside.
        massless: the bodies that are dropped for their own lack of mass, not with another one.
        kept: names of the fixed joints that are not merged.
        stranded: the bodies that are dropped with a link without mass that is merged.
        added_links, added_joints: SDF elements that ``<gazebo>`` tags bring in.
    """

    def __init__(self, tree: KinematicTree, converter: Converter = NEW) -> None:
        self.model = model = tree.model
        self.converter = converter
        self.tree = tree
        self.preserved = frozenset(_preserved(model))
        self.kept = self.preserved | {joint.name for joint in tree.children.get(WORLD, ())}
        self._bodies = rigid_bodies(tree, self.kept)
        self._body_of = {link.name: body for body in self._bodies for link, _ in body.links}
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
        """Names of the links and joints that ``<gazebo>`` tags bring in as SDF."""
        return frozenset(one.get("name") or "" for one in self.added_links + self.added_joints)

    def lost_joint_ends(self) -> Iterator[tuple[Element, Element, str]]:
        """Ends of the added joints that are no link: the joint, the end, what it is merged into.

        The last is empty for a name that the converted model does not have in any way.
        """
        frames = {"world", *self.joint_names, *self.added, *(link.name for link in self.links)}
        frames |= {
            one.get("name") or "" for block in self.model.gazebo for one in block.all("frame")
        }
        for joint in self.added_joints:
            for end in filter(None, (joint.child("parent"), joint.child("child"))):
                name = end.text.strip()
                if name and "::" not in name and name not in frames:
                    yield joint, end, self.merged.get(name, "")

    @cached_property
    def survivor(self) -> dict[str, str]:
        """The link of Gazebo that a link of the URDF is, or is merged into, by name."""
        return {
            link.name: simulated.name
            for simulated in self.links
            for link, _ in simulated.body.links
        }

    @cached_property
    def joint_names(self) -> frozenset[str]:
        """The names of the joints that Gazebo has."""
        return frozenset(simulated.joint.name for simulated in self.joints)

    @property
    def merged(self) -> dict[str, str]:
        """The link that each merged link became part of."""
        return {name: into for name, into in self.survivor.items() if name != into}

    def merges(self, joint: Joint) -> bool:
        """True if the child of a joint becomes part of its parent, or is dropped with it."""
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
        for link, _ in body.links:
            self.dropped[link.name] = reason
        return False

    def _is_massless(self, mass: float) -> bool:
        least = self.converter.least_mass
        return abs(mass) <= least if least else mass <= 0

    def _lost_with_parent(self, body: RigidBody) -> str | None:
        """Why a body is dropped with its parent, or None."""
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
        """The link and those between it and the one that it is merged into."""
        body = self._body_of[name]
        seen: set[str] = set()  # links may stand in a circle: TRE003
        while name != body.top.name and name not in seen:
            seen.add(name)
            yield self.model.links_by_name[name]
            name = self.tree.parents[name][0].parent_name

    def _mass_below(self, link: Link) -> float:
        """The mass of a link and of all that is merged into it."""
        total = 0.0
        queue, seen = [link.name], {link.name}
        for name in queue:  # grows while it is walked
            total += self.model.links_by_name[name].mass
            for joint in self.tree.children[name]:
                is_merged = joint.kind == "fixed" and joint.name not in self.preserved
                if is_merged and joint.child_name not in seen:  # there may be a circle: TRE003
                    seen.add(joint.child_name)
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
    """Names of the fixed joints that the model preserves in Gazebo."""
    for gazebo in model.gazebo:
        reference = gazebo.get("reference")
        if reference and any(
            child.tag in KEEPING_TAGS and is_true(child) for child in gazebo.children
        ):
            yield reference


def _added(model: RobotModel, kind: str) -> Iterator[Element]:
    """What is written as SDF in ``<gazebo>`` tags without a reference is copied unchanged."""
    for gazebo in model.gazebo:
        if not gazebo.get("reference"):
            yield from (child for child in gazebo.all(kind) if child.get("name"))


def _named(order: list[Link], kind: str) -> Iterator[tuple[str, Element]]:
    """The names of a link's collisions or visuals, with those of the links merged into it."""
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
