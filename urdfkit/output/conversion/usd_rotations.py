"""Rotations of the converter to USD, written again from those of the robot.

The converter computes with the arc cosine of a single precision number, as USD does with what it
writes: small rotations are up to 5e-4 rad off then.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from pxr import Gf, Sdf, Usd, UsdPhysics

from urdfkit.core.spatial import Rotation
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Floats
from urdfkit.output.conversion.usd_proof import Stage, rotation_of
from urdfkit.robot.kinematics import direction
from urdfkit.robot.model import Joint

_ORIENT = "xformOp:orient"


def write_rotations(stage: Stage, robot: Context) -> None:
    """Write the rotations of links, of visuals and collisions, and of the frames of joints."""
    layers = set()
    for name, prim in stage.links.items():
        for joint in robot.tree.parents[name]:
            layers.add(_orient(prim, joint.origin.rotation))
    for prim, body in stage.shapes:
        layers.add(_orient(prim, body.origin.rotation))
    stage.forget_placements()
    for joint in robot.model.joints:
        prim = stage.joints.get(joint.name)
        if prim is not None:
            layers |= _turn_frames(stage, prim, joint)
    for layer in layers:
        layer.Save()


def _orient(prim: Any, rotation: Rotation) -> Any:
    """Give a prim a rotation in double precision; returns the layer of the old one."""
    (old,) = prim.GetAttribute(_ORIENT).GetPropertyStack(Usd.TimeCode.Default())
    owner = old.owner
    owner.RemoveProperty(old)
    new = Sdf.AttributeSpec(owner, _ORIENT, Sdf.ValueTypeNames.Quatd)
    new.default = _quaternion(np.array(rotation))
    return owner.layer


def _turn_frames(stage: Stage, prim: Any, joint: Joint) -> set[Any]:
    """Let the frame of a joint in its child have the axis, and that in its parent equal it."""
    second = UsdPhysics.Joint(prim).GetLocalRot1Attr()
    turned = rotation_of(second.Get())
    if joint.kind != "fixed":
        turned = _shortest(stage.axis_in_child(joint), np.array(direction(joint))) @ turned
    first = UsdPhysics.Joint(prim).GetLocalRot0Attr()
    layers = set()
    for attribute, rotation in (
        (second, turned),
        (first, stage.relative_rotation(prim) @ turned),
    ):
        (spec,) = attribute.GetPropertyStack(Usd.TimeCode.Default())
        spec.default = Gf.Quatf(_quaternion(rotation))
        layers.add(spec.layer)
    return layers


def _shortest(before: Floats, after: Floats) -> Floats:
    """The shortest rotation from one unit vector to another near it, (3, 3)."""
    x, y, z = np.cross(before, after)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    found: Floats = np.eye(3) + cross + cross @ cross / (1 + before @ after)
    return found


def _quaternion(rotation: Floats) -> Any:
    return Gf.Matrix4d(Gf.Matrix3d(*rotation.T.ravel()), Gf.Vec3d()).ExtractRotationQuat()
