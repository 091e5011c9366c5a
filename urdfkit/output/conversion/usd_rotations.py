"""Replaces the rotations in the converter's USD by the rotations of the robot.

The converter and USD compute the arc cosine of a number in single precision, with errors of small
rotations up to 5e-4 rad.
"""

from typing import Any

import numpy as np
from pxr import Gf, Sdf, Usd, UsdPhysics

from urdfkit.core.spatial import Rotation
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Floats
from urdfkit.output.conversion.usd_stage import Stage, rotation_of
from urdfkit.robot.joint import Joint
from urdfkit.robot.kinematics import direction

_ORIENT = "xformOp:orient"


def write_rotations(stage: Stage, robot: Context) -> None:
    """Write the rotations of links, visuals, collisions, and frames of joints."""
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
    """Set the rotation of a prim in double precision; returns the layer of the old rotation."""
    (old,) = prim.GetAttribute(_ORIENT).GetPropertyStack(Usd.TimeCode.Default())
    owner = old.owner
    owner.RemoveProperty(old)
    new = Sdf.AttributeSpec(owner, _ORIENT, Sdf.ValueTypeNames.Quatd)
    new.default = _quaternion(np.array(rotation))
    return owner.layer


def _turn_frames(stage: Stage, prim: Any, joint: Joint) -> set[Any]:
    """Rotate the frame of a joint in its child to the axis, and match the frame in its parent."""
    second = UsdPhysics.Joint(prim).GetLocalRot1Attr()
    in_child = rotation_of(second.Get())
    if joint.kind != "fixed":
        in_child = _shortest(stage.axis_in_child(joint), np.array(direction(joint))) @ in_child
    first = UsdPhysics.Joint(prim).GetLocalRot0Attr()
    layers = set()
    for attribute, rotation in (
        (second, in_child),
        (first, stage.relative_rotation(prim) @ in_child),
    ):
        (spec,) = attribute.GetPropertyStack(Usd.TimeCode.Default())
        spec.default = Gf.Quatf(_quaternion(rotation))
        layers.add(spec.layer)
    return layers


def _shortest(before: Floats, after: Floats) -> Floats:
    """The shortest rotation from a unit vector to another one near it, (3, 3)."""
    x, y, z = np.cross(before, after)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + cross + cross @ cross / (1 + before @ after))


def _quaternion(rotation: Floats) -> Any:
    return Gf.Matrix4d(Gf.Matrix3d(*rotation.T.ravel()), Gf.Vec3d()).ExtractRotationQuat()
