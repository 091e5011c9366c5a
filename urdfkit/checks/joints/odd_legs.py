"""Joints of one leg or wheel that differ from the same joint of all other legs."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.checks.joints.fingers import OddJoint
from urdfkit.core.spatial import Vector, dot, rotate
from urdfkit.core.words import rounded
from urdfkit.lint.context import Context
from urdfkit.robot.fingers import odd_one
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.kinematics import direction
from urdfkit.robot.legs import legs
from urdfkit.robot.symmetry import on_separate_branches

#: Cosine of the angle between two axes above which they are parallel.
_PARALLEL = 0.99

#: Least difference of a coordinate of an origin, in m: robots are not quite symmetric.
_OTHER_NUMBER = 1e-3

#: Most joints of a leg that may turn the other way by mistake.
_MAX_ODD = 3

#: Decimals of a coordinate that are compared, in m.
_DECIMALS = 4


def odd_legs(context: Context) -> Iterator[OddJoint]:
    series = _series(context)
    yield from _axes(series, context)
    for joints in series:
        yield from _origins(list(joints.values()))


def _series(context: Context) -> list[dict[str, Joint]]:
    """The same joint of several legs, by corner; they are on different branches."""
    joints = {joint.name: joint for joint in context.model.joints if joint.is_single_dof}
    series = [{corner: joints[name] for corner, name in leg.items()} for leg in legs(joints)]
    ends = [[joint.child_name for joint in each.values()] for each in series]
    pairs = [(first, other) for first, *others in ends for other in others]
    parents = {link: above[0].parent_name for link, above in context.tree.parents.items() if above}
    separate = set(on_separate_branches(pairs, parents))
    return [
        each
        for each, (first, *others) in zip(series, ends, strict=True)
        if all((first, other) in separate for other in others)
    ]


def _axes(series: list[dict[str, Joint]], context: Context) -> Iterator[OddJoint]:
    """The joint that turns the other way than the same joint of all other legs.

    If two of four legs are mounted the other way round, it turns like those; the other joints with
    this axis show it.
    """
    known = [(joints, axes) for joints in series if (axes := _axes_of(joints, context))]
    odd = [(each, alone) for each in known if (alone := odd_one(_turns(each[1])))]
    for (joints, axes), alone in odd if len(odd) <= _MAX_ODD else ():
        turns = _turns(axes)
        axis = axes[alone[0]]
        others = [
            each for _, each in known if abs(dot(next(iter(each.values())), axis)) > _PARALLEL
        ]
        patterns = [pattern for pattern in map(_turns, others) if odd_one(pattern) is None]
        flipped = [corner for corner in turns if _differ_in(corner, turns, patterns)]
        corner = flipped[0] if len(flipped) == 1 else alone[0]
        joint = joints[corner]
        other = next(one for one in joints.values() if one is not joint)
        difference = f"turns about {rounded(axes[corner], 2)} in the root frame, so that the same "
        difference += f"joint turns one way in {len(turns) - 1} legs and the other way in one"
        at = joint.at.child_or_self("axis")
        yield OddJoint(joint, at, difference, "invert its <axis>", other)


def _axes_of(joints: dict[str, Joint], context: Context) -> dict[str, Vector]:
    """The axes in the root frame; empty unless all joints have one range, and parallel axes.

    Wheels may turn either way: RCT025 knows their drive.
    """
    axes = {}
    for corner, joint in joints.items():
        frame = context.tree.frames.get(joint.child_name)
        if joint.kind == "revolute" and frame:
            axes[corner] = rotate(frame.rotation, direction(joint))
    if len(axes) != len(joints) or len(set(map(bounds, joints.values()))) != 1:
        return {}
    first = next(iter(axes.values()))
    return axes if all(abs(dot(first, axis)) > _PARALLEL for axis in axes.values()) else {}


def _turns(axes: dict[str, Vector]) -> dict[str, bool]:
    """Whether each joint turns like the first one, by its corner."""
    first = next(iter(axes.values()))
    return {corner: dot(first, axis) > 0 for corner, axis in axes.items()}


def _differ_in(corner: str, turns: dict[str, bool], patterns: list[dict[str, bool]]) -> bool:
    """True if other joints of the legs turn as these would with the other axis in one leg."""
    corrected = {**turns, corner: not turns[corner]}
    opposite = {key: not value for key, value in corrected.items()}
    return corrected in patterns or opposite in patterns


def _origins(joints: list[Joint]) -> Iterator[OddJoint]:
    """The joint whose origin differs from all others in one number, whatever its sign."""
    sizes = {
        joint.name: tuple(round(abs(part), _DECIMALS) for part in joint.origin.position)
        for joint in joints
    }
    if (odd := odd_one(sizes)) is None:
        return
    joint = next(joint for joint in joints if joint.name == odd[0])
    other = next(other for other in joints if other is not joint)
    own, common = sizes[joint.name], odd[1]
    changed = [index for index in range(3) if own[index] != common[index]]
    if len(changed) == 1 and abs(own[changed[0]] - common[changed[0]]) >= _OTHER_NUMBER:
        (index,) = changed
        difference = f"has {joint.origin.position[index]:g} m as the {'xyz'[index]} of its origin, "
        difference += f"all other legs have {common[index]:g} m or its negative"
        at = joint.at.child_or_self("origin")
        yield OddJoint(joint, at, difference, f"write {common[index]:g} with its sign", other)
