"""SRDF: MoveIt's groups, states and allowed collisions, read together with the robot.

Source of the grammar: srdfdom's parser, and MoveIt's RobotModel, which rejects elements that do not
match the robot.
"""

import os
from collections.abc import Iterator, Mapping
from functools import cached_property
from itertools import islice

from urdfkit.core.grouping import by_key
from urdfkit.core.suggest import nearest
from urdfkit.errors import UrdfkitError
from urdfkit.robot.joint import Joint
from urdfkit.robot.tree import KinematicTree
from urdfkit.ros import RosDescription
from urdfkit.text.comments import blank_comments
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.document import Attribute, Document, Element
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.srdf_files import (
    has_robot_name,
    is_of_namesake,
    other_srdf_files,
    srdf_files,
    srdf_in,
)

#: Most SRDFs of a directory that are read for one robot.
_MAX_READ = 32


class Srdf:
    """An SRDF and its robot."""

    def __init__(self, path: str, root: Element, tree: KinematicTree) -> None:
        self.path = path  # of the file
        self.root = root  # its ``<robot>`` element
        self.tree = tree
        #: True if a launch file passes it other arguments than this robot has.
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
        links = {one.get("link") or "" for one in self.root.all("disable_default_collisions")}
        enabled = {pair_of(one) for one in self.root.all("enable_collisions")}
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


def pair_of(element: Element) -> frozenset[str]:
    """The pair of links of an element of the collision matrix."""
    return frozenset((element.get("link1") or "", element.get("link2") or ""))


def _named(kind: str, element: Element, *keys: str) -> Iterator[tuple[str, Attribute]]:
    for key in keys:
        attribute = element.attributes.get(key)
        if attribute is not None:
            yield kind, attribute


def find(robot: RosDescription) -> Srdf | None:
    """The SRDF of a robot, if there is exactly one readable SRDF for it.

    An SRDF with another robot name is accepted if it references the links and joints of the robot;
    an SRDF in a MoveIt package for several robots, if it fits this robot. An SRDF with the same
    file name as another robot in the same directory belongs to that robot, and so does an SRDF with
    the robot name of another file, if this robot lacks links or joints of it. Of very many SRDFs,
    such as for each combination of two hands, only those with the name of the robot are read.
    """
    path, name, resolver = robot.source.path, robot.model.name, robot.resolver
    files = [one for one in srdf_files(path, resolver) if not is_of_namesake(one, path, resolver)]
    if len(files) > _MAX_READ:
        files = [one for one in files if _stem(one) in (_stem(path), name)]
    found = [srdf for one in files if (srdf := read(one, robot))]
    same = [srdf for srdf in found if srdf.root.get("name") == name]
    chosen = same or [
        srdf
        for srdf in found
        if srdf.refers_to_robot and not (srdf.unknown and _is_of_neighbour(srdf, path, resolver))
    ]
    if len(chosen) > 1:  # MoveIt's builder reads the SRDF with the file name of the robot
        chosen = [srdf for srdf in chosen if _stem(srdf.path) == _stem(path)]
    if not found:
        others = other_srdf_files(path, name, resolver)
        chosen = [srdf for one in others if (srdf := read(one, robot)) and srdf.fits_robot]
    return chosen[0] if len(chosen) == 1 else None


def _is_of_neighbour(srdf: Srdf, path: str, resolver: Resolver) -> bool:
    """True if another URDF beside a robot has the robot name of an SRDF."""
    name = srdf.root.get("name") or ""
    return name != "" and any(
        robot != os.path.basename(path) and has_robot_name(os.path.join(directory, robot), name)
        for directory in (os.path.dirname(os.path.abspath(path)),)
        for robot in resolver.directories.entries(directory) or ()
    )


def neighbours(srdf: Srdf, robot: RosDescription) -> Iterator[Srdf]:
    """The other SRDFs in the directory of an SRDF, without those after very many."""
    for path in islice(srdf_in([os.path.dirname(srdf.path)], robot.resolver), _MAX_READ):
        if path != srdf.path and (other := read(path, robot)):
            yield other


def read(path: str, robot: RosDescription) -> Srdf | None:
    """An SRDF file of a robot; None if it cannot be read.

    A xacro is expanded with the arguments of the robot that have the same names, and with the
    arguments from launch files, unless it then fits the robot worse. Where both pass an argument
    that changes no link and no joint, such as the name of a group, the launch file decides.
    """
    srdf, names = _expanded(path, robot, robot.arguments)
    others = names - robot.arguments.keys()
    for arguments in _launched(path, robot, others) if others else ():
        launched, _ = _expanded(path, robot, {**arguments, **robot.arguments})
        if launched and (srdf is None or len(launched.unknown) <= len(srdf.unknown)):
            srdf = launched
            break
    shared = names & robot.arguments.keys()
    for arguments in _launched(path, robot, shared) if srdf and shared else ():
        launched, _ = _expanded(path, robot, {**robot.arguments, **arguments})
        if launched and srdf and launched.named == srdf.named:
            launched.is_shared = any(robot.arguments[key] != arguments[key] for key in arguments)
            return launched
    return srdf


def read_named(path: str, robot: RosDescription) -> Srdf:
    """An SRDF file that the user names.

    Raises:
        UrdfkitError: it cannot be read, or is not an SRDF.
    """
    robot.resolver.admit_and_read(path)
    srdf = read(path, robot)
    if srdf is None or not is_srdf(srdf.root):
        raise UrdfkitError(f"{path}: not an SRDF file")
    return srdf


def _expanded(
    path: str, robot: RosDescription, arguments: Mapping[str, str]
) -> tuple[Srdf | None, set[str]]:
    """An SRDF file with arguments, and the names of its arguments."""
    document, names = _parsed(path, robot.resolver, robot.trust, arguments)
    if document is None or document.root.tag != "robot":
        return None, names
    if path.endswith(".xacro") and not document.root.children:
        return None, set()  # only macros for other files
    return Srdf(path, document.root, robot.tree), names


def _launched(path: str, robot: RosDescription, names: set[str]) -> Iterator[dict[str, str]]:
    """The arguments that launch files pass to an SRDF: all of them, and all but one.

    The robot may be checked with the default of an argument such as a prefix.
    """
    from urdfkit.ros.launch.robot_arguments import passed_arguments

    for launched in passed_arguments(path, (), robot.resolver):
        whole = {name: value for name, value in launched.arguments.items() if name in names}
        if launched.frame:
            yield whole
            yield from ({name: whole[name] for name in whole if name != one} for one in whole)


def is_srdf(root: Element) -> bool:
    """True for the root of an SRDF; the root of a URDF is also a ``<robot>``, but has links."""
    return root.tag == "robot" and root.child("link") is None


def unreadable(path: str, name: str, resolver: Resolver) -> Iterator[Problem]:
    """Why the SRDF of a robot cannot be read: the only SRDF, or an SRDF with the robot's name.

    A xacro is ignored: a launch file may pass its required arguments.
    """
    paths = srdf_files(path, resolver)
    for candidate in paths:
        if len(paths) == 1 or _stem(candidate) in (name, _stem(path)):
            source = resolver.readable(candidate)
            if source is None or is_xacro(source):
                continue
            document, problems = read_xml(source)
            if document is None and _read(source) is None:
                yield from problems
            elif document is None:  # xacro, which MoveIt's builder of ROS 2 uses, rejects it
                manifest = manifest_of(resolver, candidate)
                severity = Severity.WARNING if manifest and manifest.ros == 1 else None
                yield from (problem._replace(severity=severity) for problem in problems)


def _stem(path: str) -> str:
    return os.path.basename(path).partition(".")[0]


def _parsed(
    path: str, resolver: Resolver, trust: bool, arguments: Mapping[str, str]
) -> tuple[Document | None, set[str]]:
    """The document of a file, if it can be read, and the names of its xacro arguments."""
    source = resolver.readable(path)
    if source is None:
        return None, set()
    if is_xacro(source):
        from urdfkit.xacro import expand

        xacro = expand(source, resolver, arguments, trust=trust)
        return xacro.document, set(xacro.defaults)
    return _read(source), set()


def _read(source: Source) -> Document | None:
    """The document of a file, read as by TinyXML, MoveIt's parser; None if it is not well-formed.

    TinyXML ends a comment at the first ``-->``, whatever the comment contains.
    """
    document = read_xml(source)[0]
    if document is None and b"<!--" in source.data:
        document = read_xml(Source(source.path, blank_comments(source.data)))[0]
    return document
