"""What an SDF holds, read by the semantics of SDF 1.7 to 1.11, compared with the robot.

Nothing here knows how the file was made: frames come from ``relative_to`` and ``attached_to``,
bodies from what is attached to a link.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from random import Random

from urdfkit.core.record import Record
from urdfkit.core.spatial import (
    Transform,
    from_rpy,
    length,
    minus,
    rotation_about,
    times,
    unit,
)
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.conversion.sdf_values import SNAP
from urdfkit.robot.inertia import ZERO, MassProperties, combined
from urdfkit.robot.kinematics import SLIDING, TURNING, frames, positions
from urdfkit.robot.model import Joint, Tensor
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.robot.tree import KinematicTree
from urdfkit.robot.values import number, numbers, vector
from urdfkit.ros.gazebo.conversion import SdfConversion
from urdfkit.text.document import Element
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml

#: Random poses that the frames are compared at.
POSES = 20
#: Bounds: of frames and centres of mass in m, and of the others as a part of the largest entry.
LENGTH, PART = 1e-9, 1e-6
#: The same of inertia where sdformat takes a pitch near a right angle for one.
ROUNDED = 1e-2
#: Positions are drawn between these where no limit is nearer, in rad or m.
_REACH = 3.0


class SdfProof(Record):
    """The largest differences."""

    frames: float  # of the placement of a link, in m and of entries of its rotation
    masses: float  # of links that are merged, as a part of the mass
    centers: float  # of their centres of mass, in m
    inertia: float  # of their tensors, as a part of the largest entry
    joints: float  # of a limit, as a part of it; 1 for other ends or another kind
    shapes: float  # of the placement of a visual or collision, in m and of entries of its rotation
    missing: int  # visuals and collisions that should be there
    is_rounded: bool  # True if sdformat takes a pitch for a right angle in what it merges
    part: str  # whose frame differs most

    @property
    def holds(self) -> bool:
        """True within the bounds."""
        is_placed = max(self.frames, self.shapes) <= LENGTH and not self.missing
        away, part = (ROUNDED, ROUNDED) if self.is_rounded else (LENGTH, PART)
        is_heavy = self.masses <= PART and self.centers <= away and self.inertia <= part
        return is_placed and is_heavy and self.joints <= PART

    @property
    def agreed(self) -> str:
        """Who agrees, on what."""
        return "the SDF agrees with the robot on frames, shapes, masses, inertia, joints and limits"

    @property
    def differences(self) -> str:
        """In words."""
        return (
            f"frames {self.frames:.2g} m ('{self.part}'), masses {self.masses:.2g}, centres "
            f"{self.centers:.2g} m, inertia {self.inertia:.2g}, joints {self.joints:.2g}, "
            f"shapes {self.shapes:.2g} m, of which {self.missing} are missing"
        )


class Sdf:
    """The model in a file.

    Raises:
        UrdfkitError: it holds none.
    """

    def __init__(self, source: Source) -> None:
        document, _ = read_xml(source)
        model = document.root.child("model") if document else None
        if model is None:
            raise UrdfkitError(f"{source.path}: has no model")
        self.links, self.joints, self._frames = (
            {one.get("name") or "": one for one in model.all(tag)}
            for tag in ("link", "joint", "frame")
        )
        self._children = {_text(joint, "child"): joint for joint in self.joints.values()}
        self.counts = {
            "link": len(self.links),
            "joint": len(self.joints),
            "frame": len(self._frames),
            "sensor": sum(one.tag == "sensor" for one in model.walk()),
            "plugin": sum(one.tag == "plugin" for one in model.walk()),
        }

    def link_of(self, name: str) -> str:
        """The link that a link or frame belongs to; empty if there is none."""
        seen = set()
        while name in self._frames and name not in seen:
            seen.add(name)
            name = self._frames[name].get("attached_to") or ""
        return name if name in self.links else ""

    def placed(self, names: Iterable[str], moved: Mapping[str, float]) -> dict[str, Transform]:
        """Where links and frames are in the model.

        Args:
            moved: positions of joints in rad or m, by name.

        Raises:
            UrdfkitError: one of them is nowhere.
        """
        found: dict[str, Transform] = {"__model__": Transform(), "world": Transform()}
        known = {*self.links, *self._frames, *self.joints}
        for wanted in names:
            steps: list[tuple[str, Transform]] = []
            name = wanted
            while name not in found:
                if name not in known or len(steps) > len(known):
                    raise UrdfkitError(f"the SDF does not say where '{wanted}' is")
                before, step = self._step(name, moved)
                steps.append((name, step))
                name = before
            for one, step in reversed(steps):
                found[one] = found[name] @ step
                name = one
        return found

    def _step(self, name: str, moved: Mapping[str, float]) -> tuple[str, Transform]:
        """What a link, frame or joint is relative to, and where it is in that."""
        if name in self.joints:
            joint = self.joints[name]
            before, at = _pose(joint)
            axis = joint.child("axis")
            direction = vector(_text(axis, "xyz")) if axis else None
            motion = Transform()
            if direction is not None and joint.get("type") == "revolute":
                motion = Transform(rotation_about(unit(direction), moved.get(name, 0.0)))
            elif direction is not None:
                along = times(unit(direction), moved.get(name, 0.0))
                motion = Transform(position=along)
            return before or _text(joint, "child"), at @ motion
        element = self._frames.get(name) or self.links[name]
        before, at = _pose(element)
        return before or element.get("attached_to") or "__model__", at


def _text(element: Element, tag: str) -> str:
    child = element.child(tag)
    return child.text.strip() if child else ""


def _pose(element: Element) -> tuple[str, Transform]:
    pose = element.child("pose")
    if pose is None:
        return "", Transform()
    values = numbers(pose.text) or (0.0,) * 6
    x, y, z, roll, pitch, yaw = values
    return pose.get("relative_to") or "", Transform(from_rpy(roll, pitch, yaw), (x, y, z))


def prove(sdf: Sdf, robot: Context, conversion: SdfConversion) -> SdfProof:
    """Compare an SDF with a robot.

    Args:
        conversion: that says which links Gazebo drops.
    """
    tree, random = robot.tree, Random(0)
    kept = [name for name in tree.parents if name not in conversion.dropped and name != "world"]
    worst = (0.0, "")
    for number_of_pose in range(POSES):
        given = _drawn(tree, random) if number_of_pose else {}
        ours, theirs = frames(tree, given), sdf.placed(kept, positions(tree, given))
        root = ours[tree.roots[0].name]
        for name in kept:
            worst = max(worst, (_apart(root.inverse @ ours[name], theirs[name]), name))
    groups: dict[str, list[str]] = {}
    for name in kept:
        groups.setdefault(sdf.link_of(name), []).append(name)
    masses = [*_masses(sdf, tree, groups)]
    mass, center, tensor = (max((one[i] for one in masses), default=0.0) for i in range(3))
    shapes = [*_shapes(sdf, tree, groups)]
    return SdfProof(
        worst[0],
        mass,
        center,
        tensor,
        max(_joints(sdf, robot, conversion), default=0.0),
        max((far for far, _ in shapes), default=0.0),
        sum(missing for _, missing in shapes),
        _is_rounded(tree),
        worst[1],
    )


def _apart(one: Transform, other: Transform) -> float:
    pairs = [*zip(one.position, other.position, strict=True)]
    for rows in zip(one.rotation, other.rotation, strict=True):
        pairs += zip(*rows, strict=True)
    return max(abs(a - b) for a, b in pairs)


def _off(ours: Transform, theirs: Transform) -> float:
    """How far apart shapes are; less what urdfdom rounds."""
    is_rounded = abs(ours.rotation[2][0]) >= SNAP
    apart = _apart(ours, theirs)
    return (
        length(minus(ours.position, theirs.position)) if is_rounded and apart < ROUNDED else apart
    )


def _drawn(tree: KinematicTree, random: Random) -> dict[str, float]:
    """Positions within the limits."""
    found = {}
    for joint in tree.model.joints:
        limit = joint.limit if joint.kind != "continuous" else None
        lower = limit.lower.value if limit and limit.lower else -_REACH
        upper = limit.upper.value if limit and limit.upper else _REACH
        lower, upper = max(lower, -_REACH), min(upper, _REACH)
        found[joint.name] = random.uniform(lower, upper) if lower < upper else lower
    return found


def _masses(
    sdf: Sdf, tree: KinematicTree, groups: Mapping[str, list[str]]
) -> Iterator[tuple[float, float, float]]:
    """How much mass, centre and tensor of each link differ from those of what belongs to it.

    Args:
        groups: the links of the robot by the link of the SDF that they belong to.
    """
    at_zero, links = frames(tree, {}), tree.model.links_by_name
    for top, names in groups.items():
        if not top:
            yield 1.0, 1.0, 1.0
            continue
        back = at_zero[top].inverse
        ours = combined(properties_of(links[name], back @ at_zero[name]) for name in names)
        yield _different(ours, _inertia(sdf.links[top]))


def _shapes(
    sdf: Sdf, tree: KinematicTree, groups: Mapping[str, list[str]]
) -> Iterator[tuple[float, int]]:
    """How far visuals and collisions are from the robot's nearest, and how many are missing."""
    at_zero, links = frames(tree, {}), tree.model.links_by_name
    for top, names in groups.items():
        for kind in ("visual", "collision") if top else ():
            ours = [
                at_zero[top].inverse @ at_zero[name] @ body.origin
                for name in names
                for body in (links[name].visuals if kind == "visual" else links[name].collisions)
            ]
            theirs = [_pose(one)[1] for one in sdf.links[top].all(kind)]
            near = (min((_off(a, one) for a in ours), default=1.0) for one in theirs)
            yield max(near, default=0.0), abs(len(ours) - len(theirs))


def _inertia(link: Element) -> MassProperties:
    inertial = link.child("inertial")
    inertia = inertial.child("inertia") if inertial else None
    if inertial is None or inertia is None:
        return MassProperties(0.0, (0.0, 0.0, 0.0), ZERO)
    _, at = _pose(inertial)
    tensor = Tensor(*(number(_text(inertia, name)) or 0.0 for name in Tensor._fields))
    own = MassProperties(number(_text(inertial, "mass")) or 0.0, (0.0, 0.0, 0.0), tensor)
    return own.moved(at)


def _different(ours: MassProperties, theirs: MassProperties) -> tuple[float, float, float]:
    mass = abs(ours.mass - theirs.mass) / (abs(ours.mass) or 1.0)
    away = max(abs(a - b) for a, b in zip(ours.center, theirs.center, strict=True))
    largest = max(map(abs, ours.tensor)) or 1.0
    tensors = zip(ours.tensor, theirs.tensor, strict=True)
    return mass, away, max(abs(a - b) for a, b in tensors) / largest


def _joints(sdf: Sdf, robot: Context, conversion: SdfConversion) -> Iterator[float]:
    """How much the joints differ: in their ends and kind by 1, in limits by a part."""
    for joint in robot.model.joints:
        if joint.child_name in conversion.dropped or joint.kind == "fixed":
            continue
        tag = sdf.joints.get(joint.name)
        kind = "prismatic" if joint.kind in SLIDING else "revolute"
        parent = joint.parent_name
        if (
            tag is None
            or tag.get("type") != kind
            or _text(tag, "child") != joint.child_name
            or _text(tag, "parent") != (parent if parent == "world" else sdf.link_of(parent))
        ):
            yield 1.0
        else:
            yield from _limits(tag, joint)


def _limits(tag: Element, joint: Joint) -> Iterator[float]:
    axis = tag.child("axis")
    limit = axis.child("limit") if axis else None
    if joint.limit is None or limit is None or joint.kind not in (*TURNING, *SLIDING):
        return
    ends = sorted(one.value if one else 0.0 for one in (joint.limit.lower, joint.limit.upper))
    wanted = dict(zip(("lower", "upper"), ends, strict=True)) if joint.kind != "continuous" else {}
    for name, one in (("effort", joint.limit.effort), ("velocity", joint.limit.velocity)):
        wanted[name] = one.value if one else 0.0
    for name, value in wanted.items():
        found = number(_text(limit, name))
        yield 1.0 if found is None else abs(found - value) / (abs(value) or 1.0)


def _is_rounded(tree: KinematicTree) -> bool:
    """True if a frame has a pitch that urdfdom takes for a right angle."""
    fixed = (joint.origin for joint in tree.model.joints if joint.kind == "fixed")
    own = (link.inertial.origin for link in tree.model.links if link.inertial)
    return any(abs(at.rotation[2][0]) >= SNAP for at in (*fixed, *own))
