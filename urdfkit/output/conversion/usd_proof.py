"""What a stage of USD holds, compared with the robot that it was made from."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import Any

import numpy as np
from pxr import Gf, Usd, UsdGeom, UsdPhysics

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Floats
from urdfkit.output.conversion.body_inertia import (
    difference,
    homogeneous,
    of_link,
    pseudo_inertia,
)
from urdfkit.robot.kinematics import SLIDING, TURNING, direction
from urdfkit.robot.model import Joint
from urdfkit.robot.rigid_bodies import rigid_bodies

#: Bounds: of frames in m, and of the others as a part of the largest number: USD has single
#: precision for masses.
LENGTH, PART = 1e-9, 1e-5
#: Of an axis: the converter takes one that is as near to x, y or z for it.
AXIS = 1e-3

_AXES = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}
_TYPES = {
    "revolute": "PhysicsRevoluteJoint",
    "continuous": "PhysicsRevoluteJoint",
    "prismatic": "PhysicsPrismaticJoint",
    "fixed": "PhysicsFixedJoint",
    "planar": "PhysicsJoint",
}


class UsdProof(Record):
    """The largest differences between a stage and the robot."""

    frames: float  # of the placement of a link at zero, in m and of entries of its rotation
    masses: float  # of links that are fixed together, and of their tensors, as a part of the most
    axes: float  # of a unit vector
    joints: float  # of a limit, as a part of it; 1 for another kind of joint
    part: str  # that differs most: a link or joint

    @property
    def holds(self) -> bool:
        is_placed = self.frames <= LENGTH and self.axes <= AXIS
        return is_placed and max(self.masses, self.joints) <= PART

    @property
    def agreed(self) -> str:
        return "the stage agrees with the robot on frames, masses, inertia, axes and limits"

    @property
    def disagreed(self) -> str:
        return (
            "the USD does not agree with the robot: "
            f"frames {self.frames:.2g} m, masses {self.masses:.2g}, axes {self.axes:.2g}, "
            f"joints {self.joints:.2g}; most at '{self.part}'"
        )


class Stage:
    """A stage and the prims of a robot in it.

    Args:
        stage: of USD.
        robot: that it was made from.
    """

    def __init__(self, stage: Any, robot: Context) -> None:
        self._stage = stage  # whose prims end with it
        self._cache = UsdGeom.XformCache()
        root = stage.GetDefaultPrim()
        self.joints = {
            _name(prim): prim
            for prim in root.GetChild("Physics").GetChildren()
            if prim.IsA("PhysicsJoint")
        }  # by the names of the robot
        self.links: dict[str, Any] = {}  # those that have a prim, by name
        self._robot = robot
        tree = robot.tree
        placed = tree.frames
        for name in tree.below(tree.roots[0].name):
            joint = next(iter(tree.parents[name]), None)
            parent = self.links.get(joint.parent_name) if joint else root.GetChild("Geometry")
            prim = self._child(parent, name, placed[name]) if parent else None
            if prim:
                self.links[name] = prim
        meshes = sum(prim.IsA(UsdGeom.Gprim) for prim in Usd.PrimRange(root))
        self.counts = {"link": len(self.links), "joint": len(self.joints), "geom": meshes}

    def _child(self, parent: Any, name: str, at: Transform) -> Any:
        """The prim of a link; a visual may have the same name."""
        found = [
            prim for prim in parent.GetChildren() if prim.IsA(UsdGeom.Xform) and _name(prim) == name
        ]
        return min(found, key=lambda prim: self.difference(prim, at), default=None)

    def difference(self, prim: Any, at: Transform) -> float:
        """How far a prim is from a frame, in m or of entries of its rotation."""
        found = np.array(self._cache.GetLocalToWorldTransform(prim)).T
        return float(np.abs(found - homogeneous(at)).max())

    def inertia(self, prim: Any) -> tuple[float, Floats, Floats]:
        """Mass in kg, (3,) centre in m and (3, 3) tensor about that, in the frame of a prim."""
        api = UsdPhysics.MassAPI(prim)
        if not prim.HasAPI(UsdPhysics.MassAPI) or not prim.HasAPI(UsdPhysics.RigidBodyAPI):
            return 0.0, np.zeros(3), np.zeros((3, 3))
        axes = api.GetPrincipalAxesAttr().Get()
        turned = np.array(Gf.Matrix3d(Gf.Rotation(Gf.Quatd(axes)))).T if axes else np.eye(3)
        moments = np.array(api.GetDiagonalInertiaAttr().Get() or (0, 0, 0), dtype=float)
        center = np.array(api.GetCenterOfMassAttr().Get() or (0, 0, 0), dtype=float)
        if not np.isfinite(center).all():  # what is not written
            center = np.zeros(3)
        return float(api.GetMassAttr().Get() or 0), center, turned @ np.diag(moments) @ turned.T

    def axis_difference(self, joint: Joint) -> float:
        """How far the axis of a joint that has a prim is off, both as unit vectors."""
        prim = self.joints[joint.name]
        turn = Gf.Rotation(Gf.Quatd(UsdPhysics.Joint(prim).GetLocalRot1Attr().Get()))
        token = prim.GetAttribute("physics:axis").Get() or "X"
        found = np.array(turn.TransformDir(Gf.Vec3d(*_AXES[token])))
        return float(np.abs(found - direction(joint)).max())


def _name(prim: Any) -> str:
    """What the robot calls a prim."""
    return str(prim.GetDisplayName() or prim.GetName())


@np.errstate(over="ignore", invalid="ignore")  # of numbers that USD has no room for
def prove(stage: Stage, robot: Context) -> UsdProof:
    """Compare a stage with a robot."""
    placed = robot.tree.frames
    far = max((stage.difference(prim, placed[name]), name) for name, prim in stage.links.items())
    masses = max(_masses(stage, robot), default=(0.0, ""))
    axes = max(_axes(stage, robot), default=(0.0, ""))
    joints = max(_joints(stage, robot), default=(0.0, ""))
    bounds = zip((far, masses, axes, joints), (LENGTH, PART, AXIS, PART), strict=True)
    worst = max((difference / bound, name) for (difference, name), bound in bounds)
    return UsdProof(far[0], masses[0], axes[0], joints[0], worst[1])


def _masses(stage: Stage, robot: Context) -> Iterator[tuple[float, str]]:
    """How much the inertia of links that are fixed together differs, as a part of it."""
    for group in rigid_bodies(robot.tree):
        ours = sum((of_link(*one) for one in group.links), np.zeros((4, 4)))
        theirs = np.zeros((4, 4))
        for link, frame in group.links:
            if link.name in stage.links:
                theirs = theirs + pseudo_inertia(*stage.inertia(stage.links[link.name]), frame)
        yield difference(ours, theirs), group.top.name


def _axes(stage: Stage, robot: Context) -> Iterator[tuple[float, str]]:
    """How much the axes of the joints that have a prim differ."""
    for joint in robot.model.joints:
        if joint.name in stage.joints and joint.kind in (*TURNING, *SLIDING):
            yield stage.axis_difference(joint), joint.name


def _joints(stage: Stage, robot: Context) -> Iterator[tuple[float, str]]:
    """How much the joints differ: in kind and ends by all, in limits by a part."""
    for joint in robot.model.joints:
        prim = stage.joints.get(joint.name)
        if prim is None:
            moves = joint.kind not in ("fixed", "floating")
            yield (1.0 if moves and joint.name else 0.0), joint.name
        elif prim.GetTypeName() != _TYPES.get(joint.kind) or not _joins(stage, prim, joint):
            yield 1.0, joint.name
        elif joint.kind in (*TURNING, *SLIDING):
            yield max(_limits(prim, joint)), joint.name


def _joins(stage: Stage, prim: Any, joint: Joint) -> bool:
    """True if a joint moves its child."""
    child = stage.links.get(joint.child_name)
    targets = UsdPhysics.Joint(prim).GetBody1Rel().GetTargets()
    return child is not None and targets == [child.GetPath()]


def _limits(prim: Any, joint: Joint) -> Iterator[float]:
    """How much the limits differ, as a part of the larger one."""
    yield 0.0
    if joint.kind == "continuous" or joint.limit is None:
        return
    ends = [one.value if one else 0.0 for one in (joint.limit.lower, joint.limit.upper)]
    largest = max(*map(abs, ends), 1e-9)
    for name, ours in zip(("lower", "upper"), ends, strict=True):
        theirs = float(prim.GetAttribute(f"physics:{name}Limit").Get())
        if joint.kind == "prismatic":
            yield abs(theirs - ours) / largest
        else:
            yield abs(theirs - degrees(ours)) / degrees(largest)
