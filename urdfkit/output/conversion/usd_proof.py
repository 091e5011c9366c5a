"""Compares a USD stage with the robot that it was converted from."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import Any

import numpy as np
from pxr import UsdPhysics

from urdfkit.lint.context import Context
from urdfkit.output.conversion.body_inertia import difference, of_link, pseudo_inertia
from urdfkit.output.conversion.result import Proof
from urdfkit.output.conversion.usd_shapes import converted_shapes, shape_difference
from urdfkit.output.conversion.usd_stage import Stage
from urdfkit.robot.joint import Joint
from urdfkit.robot.kinematics import direction
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.values import number

#: Bounds: of frames in m, and of other differences relative to the largest number: USD stores
#: masses in single precision.
MAX_OFFSET, MAX_ERROR = 1e-9, 1e-5
#: The converter's attributes of a joint, by the paths of URDF's attributes, with the power of
#: degrees in their units.
RESISTANCE = {
    "limit@velocity": ("velocityLimit", 1),
    "dynamics@damping": ("damping", -1),
    "dynamics@friction": ("friction", 0),
}
#: Numbers below this are rounding errors.
_ZERO = 1e-9
#: Difference of a part that is missing or of another type.
_WHOLE = 1.0

_TYPES = {
    "revolute": "PhysicsRevoluteJoint",
    "continuous": "PhysicsRevoluteJoint",
    "prismatic": "PhysicsPrismaticJoint",
    "fixed": "PhysicsFixedJoint",
    "planar": "PhysicsJoint",
}


@np.errstate(over="ignore", invalid="ignore")  # numbers that are out of range in USD
def prove(stage: Stage, robot: Context) -> Proof:
    """Compare a stage with a robot."""
    placed = robot.tree.frames
    frame = max((stage.difference(prim, placed[name]), name) for name, prim in stage.links.items())
    masses = max(_masses(stage, robot), default=(0.0, ""))
    axes = max(_axes(stage, robot), default=(0.0, ""))
    joints = max(_joints(stage, robot), default=(0.0, ""))
    shapes = max(_shape_differences(stage, robot), default=(0.0, ""))
    relative = (masses[0], axes[0], joints[0], shapes[0])
    bounds = zip((frame, masses, axes, joints, shapes), (MAX_OFFSET, *[MAX_ERROR] * 4), strict=True)
    _, worst = max((difference / bound, name) for (difference, name), bound in bounds)
    return Proof(
        frame[0] <= MAX_OFFSET and max(relative) <= MAX_ERROR,
        "the stage agrees with the robot on frames, masses, inertia, joints and shapes",
        f"the USD does not agree with the robot: frames {frame[0]:.2g} m, "
        f"masses {masses[0]:.2g}, axes {axes[0]:.2g}, joints {joints[0]:.2g}, "
        f"shapes {shapes[0]:.2g}; most at '{worst}'",
        {
            "frames": frame[0],  # of link poses at zero, in m and in entries of the rotation
            "masses": masses[0],  # and tensors of links that are fixed together, relative
            "axes": axes[0],  # unit vectors, and the frames of joints in parent and child
            "joints": joints[0],  # of limits or mimic, relative; 1 for another joint type
            "shapes": shapes[0],  # pose or size of visuals and collisions, relative to the size
            "part": worst,
        },
    )


def _masses(stage: Stage, robot: Context) -> Iterator[tuple[float, str]]:
    """Relative differences of the inertia of links that are fixed together."""
    for group in rigid_bodies(robot.tree):
        ours = sum((of_link(*member) for member in group.links), np.zeros((4, 4)))
        theirs = np.zeros((4, 4))
        for link, frame in group.links:
            if link.name in stage.links:
                theirs = theirs + pseudo_inertia(*stage.inertia(stage.links[link.name]), frame)
        yield difference(ours, theirs), group.top.name


def _axes(stage: Stage, robot: Context) -> Iterator[tuple[float, str]]:
    """Differences of axes and frames of the joints with a prim."""
    for joint in robot.model.joints:
        if joint.name in stage.joints:
            yield stage.frame_difference(stage.joints[joint.name]), joint.name
            if joint.kind != "fixed":
                differences = np.abs(stage.axis_in_child(joint) - direction(joint))
                yield float(differences.max()), joint.name


def _shape_differences(stage: Stage, robot: Context) -> Iterator[tuple[float, str]]:
    """Differences of visuals and collisions of the links with a prim."""
    prims = {id(body.at): prim for prim, body in stage.shapes}
    for link in robot.model.links:
        for body in converted_shapes(link) if link.name in stage.links else ():
            prim = prims.get(id(body.at))
            yield (shape_difference(prim, robot, body) if prim else _WHOLE), link.name


def _joints(stage: Stage, robot: Context) -> Iterator[tuple[float, str]]:
    """Differences of the joints: 1 for another type, parent or child, else relative."""
    for joint in robot.model.joints:
        prim = stage.joints.get(joint.name)
        if prim is None:
            moves = joint.kind not in ("fixed", "floating")
            yield (_WHOLE if moves and joint.name else 0.0), joint.name
        elif prim.GetTypeName() != _TYPES.get(joint.kind) or not _joins(stage, prim, joint):
            yield _WHOLE, joint.name
        elif joint.is_single_dof:
            parts = (*_limits(prim, joint), *_resistance(prim, joint), *_mimic(stage, prim, joint))
            yield max(parts), joint.name


def _joins(stage: Stage, prim: Any, joint: Joint) -> bool:
    """True if the prim joins the links of a joint."""
    child = stage.links.get(joint.child_name)
    targets = UsdPhysics.Joint(prim).GetBody1Rel().GetTargets()
    return child is not None and targets == [child.GetPath()]


def _limits(prim: Any, joint: Joint) -> Iterator[float]:
    """Differences of the limits, relative to the larger one."""
    yield 0.0
    if joint.kind == "continuous" or joint.limit is None:
        return
    bounds = joint.limit.ends
    largest = max(*map(abs, bounds), 1e-9)
    for name, ours in zip(("lower", "upper"), bounds, strict=True):
        theirs = float(prim.GetAttribute(f"physics:{name}Limit").Get())
        if joint.is_prismatic:
            yield abs(theirs - ours) / largest
        else:
            yield abs(theirs - degrees(ours)) / degrees(largest)


def _resistance(prim: Any, joint: Joint) -> Iterator[float]:
    """Relative differences of velocity limit, damping and friction."""
    per_degree = 1.0 if joint.is_prismatic else degrees(1.0)
    for path, (name, power) in RESISTANCE.items():
        tag, _, written = path.partition("@")
        element = joint.at.child(tag)
        value = number(element.get(written)) if element is not None else None
        if value is not None:
            ours = value * per_degree**power
            theirs = prim.GetAttribute(f"newton:{name}").Get()
            yield _WHOLE if theirs is None else abs(theirs - ours) / max(abs(ours), _ZERO)


def _mimic(stage: Stage, prim: Any, joint: Joint) -> Iterator[float]:
    """Differences of the mimic of a joint, if the converter has written it."""
    if joint.mimic is None or not prim.HasAPI("NewtonMimicAPI"):
        return
    leader = stage.joints.get(joint.mimic.joint.value) if joint.mimic.joint else None
    targets = prim.GetRelationship("newton:mimicJoint").GetTargets()
    yield 0.0 if leader is not None and targets == [leader.GetPath()] else _WHOLE
    offset = joint.mimic.offset if joint.is_prismatic else degrees(joint.mimic.offset)
    for name, ours in (("mimicCoef0", offset), ("mimicCoef1", joint.mimic.multiplier)):
        theirs = float(prim.GetAttribute(f"newton:{name}").Get())
        yield abs(theirs - ours) / max(abs(ours), 1.0)
