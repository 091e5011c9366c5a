"""Differences between two states of a robot above tolerances.

Compared are names, masses, centres of mass, inertia tensors, shapes, and types, links, origins,
axes, limits and mimics of joints. Formatting of the file, colours, and elements for single programs
are ignored.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import asin, dist
from types import MappingProxyType

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector
from urdfkit.core.words import counted
from urdfkit.robot.inertia import rotated
from urdfkit.robot.joint import Joint, Limit
from urdfkit.robot.kinematics import direction
from urdfkit.robot.link import Body, Inertial, Link, Shape, Tensor
from urdfkit.robot.model import RobotModel
from urdfkit.text.source import shown_text

#: Kinds of differences. ``links`` and ``joints``: added or removed; ``names``: renamed; ``joints``:
#: also types, links, axes and mimics; ``masses``: also centres of mass; ``shapes``: also origins;
#: ``frames``: origins of joints.
KINDS = ("links", "joints", "names", "frames", "limits", "masses", "inertias", "shapes")

ComparedValue = float | str | tuple[float, ...] | None
#: Kind, text, and the values before and after.
Change = tuple[str, str, ComparedValue, ComparedValue]

#: Entries of a tensor below this part of the greatest entry are rounding errors of a rotation.
_ROUNDING = 1e-6
_NONE: Mapping[str, str] = MappingProxyType({})


class Tolerances(Record):
    """Largest differences between two states that are ignored.

    Attributes:
        mass: relative, per link.
        position: of origins and centres of mass, and of the sizes of shapes, in m.
        rotation: of origins and axes, in rad.
        inertia: of the tensor, relative to its greatest entry.
        limit: of joint limits, relative.
        links, joints: True if links or joints may be added, removed or renamed.
    """

    mass: float = 1e-3
    position: float = 1e-4
    rotation: float = 1e-4
    inertia: float = 1e-3
    limit: float = 1e-6
    links: bool = False
    joints: bool = False


class RenamedParts(Record):
    """Renamed links and joints: the name after, by the name before."""

    links: Mapping[str, str]
    joints: Mapping[str, str]


_SAME = RenamedParts(_NONE, _NONE)


class Difference(Record):
    """A difference between two models."""

    kind: str  # one of `KINDS`
    what: str  # ``link`` or ``joint``
    name: str  # of the link or joint, in the state after if it exists there
    text: str  # the difference, without the name
    #: before and after: values of the model, for programs; None if missing.
    before: ComparedValue = None
    after: ComparedValue = None

    def __str__(self) -> str:
        """The difference in one line."""
        return f"{self.what} '{self.name}': {self.text}"


def differences(
    before: RobotModel, after: RobotModel, allowed: Tolerances, names: RenamedParts = _SAME
) -> list[Difference]:
    """Differences between two models above the tolerances.

    Args:
        allowed: the tolerances.
        names: renamed links and joints, from `urdfkit.output.comparison.renames`.
    """
    found: list[Difference] = []
    if not allowed.links:
        found += _names("link", before.links_by_name, after.links_by_name, names.links)
    if not allowed.joints:
        found += _names("joint", before.joints_by_name, after.joints_by_name, names.joints)
    for name, link in before.links_by_name.items():
        if new_link := after.links_by_name.get(names.links.get(name, name)):
            changes = of_link(link, new_link, allowed)
            found += (Difference(c[0], "link", new_link.name, *c[1:]) for c in changes)
    for name, joint in before.joints_by_name.items():
        if new_joint := after.joints_by_name.get(names.joints.get(name, name)):
            changes = _of_joint(joint, new_joint, allowed, names)
            found += (Difference(c[0], "joint", new_joint.name, *c[1:]) for c in changes)
    return found


def _names(
    what: str, before: Iterable[str], after: Iterable[str], renamed: Mapping[str, str]
) -> Iterator[Difference]:
    old, new, kind = set(before), set(after), f"{what}s"
    for name in sorted(old - new - renamed.keys()):
        yield Difference(kind, what, name, "removed", True, False)
    for name in sorted(new - old - set(renamed.values())):
        yield Difference(kind, what, name, "added", False, True)
    for name, other in sorted(renamed.items()):
        yield Difference("names", what, name, f"renamed to '{other}'", name, other)


def of_link(before: Link, after: Link, allowed: Tolerances) -> Iterator[Change]:
    """Differences between two links, ignoring their names."""
    old, new = before.mass, after.mass
    if abs(new - old) > allowed.mass * max(abs(old), abs(new)):
        yield "masses", f"mass {old:g} kg -> {new:g} kg", old, new
    if old or new:  # without mass there is no centre
        centers = _center(before.inertial), _center(after.inertial)
        moved = dist(*centers)
        if moved > allowed.position:
            yield "masses", f"its centre of mass moved by {moved:.4g} m", *centers
    tensors = _tensor(before.inertial), _tensor(after.inertial)
    scale = max(abs(entry) for tensor in tensors for entry in tensor)
    if dist(*tensors) > allowed.inertia * scale:
        yield "inertias", f"inertia {_entries(*tensors, allowed.inertia * scale)} kg·m²", *tensors
    for kind in ("visuals", "collisions"):
        yield from _of_bodies(kind, getattr(before, kind), getattr(after, kind), allowed)


def _center(inertial: Inertial | None) -> Vector:
    return inertial.origin.position if inertial else (0.0, 0.0, 0.0)


def _tensor(inertial: Inertial | None) -> tuple[float, ...]:
    """Along the axes of the link."""
    if inertial is None or inertial.tensor is None:
        return (0.0,) * 6
    return rotated(inertial.tensor.value, inertial.origin.rotation)


def _entries(before: Sequence[float], after: Sequence[float], allowed: float) -> str:
    """Entries of a tensor that differ by more than rounding, before and after."""
    rows = zip(Tensor._fields, _without_noise(before), _without_noise(after), strict=True)
    # Six entries that differ by a third of what is allowed differ by less than that together.
    changed = [(key, x, y) for key, x, y in rows if abs(x - y) > allowed / 3]
    return ", ".join(f"{key} {x:g} -> {y:g}" for key, x, y in changed)


def _without_noise(tensor: Sequence[float]) -> list[float]:
    """The entries, those that come from the rounding of a rotation as 0."""
    noise = _ROUNDING * max(map(abs, tensor))
    return [0.0 if abs(entry) <= noise else entry for entry in tensor]


def _of_bodies(
    kind: str, before: Sequence[Body], after: Sequence[Body], allowed: Tolerances
) -> Iterator[Change]:
    if len(before) != len(after):
        counts = len(before), len(after)
        yield "shapes", f"{counted(counts[0], kind.removesuffix('s'))} -> {counts[1]}", *counts
        return
    for number, (old, new) in enumerate(zip(before, after, strict=True), 1):
        name = kind[:-1] if len(before) == 1 else f"{kind[:-1]} {number}"
        (old_kind, old_size), (new_kind, new_size) = _shape(old.shape), _shape(new.shape)
        if old_kind != new_kind:
            # A mesh that xacro finds has an absolute path.
            text = shown_text(f"{name} {old_kind} -> {new_kind}")
            yield "shapes", text, old_kind, new_kind
        elif len(old_size) != len(new_size) or dist(old_size, new_size) > allowed.position:
            texts = [" x ".join(f"{value:g}" for value in size) for size in (old_size, new_size)]
            text = f"{name} {old_kind}: {texts[0] or 'no size'} -> {texts[1] or 'no size'}"
            yield "shapes", text, old_size, new_size
        yield from of_frames("shapes", name, old.origin, new.origin, allowed)


def _shape(shape: Shape | None) -> tuple[str, tuple[float, ...]]:
    if shape is None:
        return "nothing", ()
    if shape.filename:
        return f"mesh {shape.filename.value}", shape.scale
    lengths = (*(shape.size or ()), shape.radius, shape.length)
    return shape.kind, tuple(value for value in lengths if value is not None)


def of_frames(
    kind: str, name: str, before: Transform, after: Transform, allowed: Tolerances
) -> Iterator[Change]:
    """Translation and rotation of a frame."""
    moved = dist(before.position, after.position)
    if moved > allowed.position:
        text = f"the origin of its {name} moved by {moved:.4g} m"
        yield kind, text, before.position, after.position
    turned = angle_between(before, after)
    if turned > allowed.rotation:
        text = f"the origin of its {name} turned by {turned:.4g} rad"
        yield kind, text, _flat(before), _flat(after)


def angle_between(before: Transform, after: Transform) -> float:
    """Angle between two frames, in rad, from 0 to pi."""
    half = dist(_flat(before), _flat(after)) / 8**0.5  # |R - R'| = sqrt(8) sin(angle / 2)
    return 2 * asin(min(1.0, half))


def _flat(frame: Transform) -> tuple[float, ...]:
    """The rotation, row by row."""
    return tuple(entry for row in frame.rotation for entry in row)


def _of_joint(
    before: Joint, after: Joint, allowed: Tolerances, names: RenamedParts
) -> Iterator[Change]:
    renamed = names.links
    for what, old, new in (
        ("type", before.kind, after.kind),
        ("parent", renamed.get(before.parent_name, before.parent_name), after.parent_name),
        ("child", renamed.get(before.child_name, before.child_name), after.child_name),
        ("mimic", _mimic(before, names.joints), _mimic(after)),
    ):
        if old != new:
            yield "joints", f"{what} {old or 'none'} -> {new or 'none'}", old, new
    yield from of_frames("frames", "frame", before.origin, after.origin, allowed)
    if after.kind != "fixed":
        axes = direction(before), direction(after)
        turned = 2 * asin(min(1.0, dist(*axes) / 2))
        if turned > allowed.rotation:
            yield "joints", f"its axis turned by {turned:.4g} rad", *axes
    for key in ("lower", "upper", "velocity", "effort"):
        limits = _limit(before.limit, key), _limit(after.limit, key)
        if not _is_close(*limits, allowed.limit):
            yield "limits", f"{key} {_text(limits[0])} -> {_text(limits[1])}", *limits


def _mimic(joint: Joint, renamed: Mapping[str, str] = _NONE) -> str:
    mimic, leader = joint.mimic, joint.leader
    if mimic is None or not leader:
        return ""
    return f"{renamed.get(leader, leader)} x {mimic.multiplier:g} + {mimic.offset:g}"


def _limit(limit: Limit | None, key: str) -> float | None:
    placed = getattr(limit, key) if limit else None
    return placed.value if placed else None


def _is_close(old: float | None, new: float | None, tolerance: float) -> bool:
    if old is None or new is None:
        return old is new
    return abs(new - old) <= tolerance * max(abs(old), abs(new))


def _text(value: float | None) -> str:
    return "none" if value is None else f"{value:g}"
