"""The prims of a robot in a USD stage: their poses, masses and joints."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdPhysics

from urdfkit.core.spatial import X_AXIS, Y_AXIS, Z_AXIS, Transform
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Floats
from urdfkit.mesh.transforms import homogeneous
from urdfkit.output.conversion.usd_shapes import converted_shapes
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Body, Link

_AXES = {"X": X_AXIS, "Y": Y_AXIS, "Z": Z_AXIS}


class Stage:
    """A stage and the prims of a robot in it.

    Args:
        stage: the USD stage.
        robot: the robot that it was converted from.
    """

    def __init__(self, stage: Any, robot: Context) -> None:
        self._stage = stage  # keeps its prims alive
        self._poses: dict[Any, Floats] = {}  # in the world, (4, 4), by path
        root = stage.GetDefaultPrim()
        self.joints = {
            _name(prim): prim
            for prim in root.GetChild("Physics").GetChildren()
            if prim.IsA("PhysicsJoint")
        }  # by the names in the robot
        self.links: dict[str, Any] = {}  # prims of links, by name
        tree = robot.tree
        placed = tree.frames
        for name in tree.below(tree.roots[0].name):
            joint = next(iter(tree.parents[name]), None)
            parent = self.links.get(joint.parent_name) if joint else root.GetChild("Geometry")
            prim = self._child(parent, name, placed[name]) if parent else None
            if prim:
                self.links[name] = prim
        #: Prims of visuals and collisions.
        self.shapes = [pair for link in robot.model.links for pair in self._shapes(link)]
        meshes = sum(prim.IsA(UsdGeom.Gprim) for prim in Usd.PrimRange(root))
        self.counts = {"link": len(self.links), "joint": len(self.joints), "geom": meshes}

    def _child(self, parent: Any, name: str, at: Transform) -> Any:
        """Prim of a link; a visual may have the same name."""
        prims = [
            prim for prim in parent.GetChildren() if prim.IsA(UsdGeom.Xform) and _name(prim) == name
        ]
        return min(prims, key=lambda prim: self.difference(prim, at), default=None)

    def _shapes(self, link: Link) -> Iterator[tuple[Any, Body]]:
        prim, links = self.links.get(link.name), set(self.links.values())
        if prim is not None:
            # The order of children on the stage depends on several layers.
            stack = prim.GetPrimStack()
            written = next(spec for spec in stack if spec.specifier == Sdf.SpecifierDef)
            children = [prim.GetChild(spec.name) for spec in written.nameChildren]
            prims = [p for p in children if p.IsA(UsdGeom.Xformable) and p not in links]
            yield from zip(prims, converted_shapes(link), strict=False)

    def forget_placements(self) -> None:
        """Clear cached poses, after a change of the stage."""
        self._poses.clear()

    def difference(self, prim: Any, at: Transform) -> float:
        """Difference of a prim from a frame, in m or in entries of the rotation."""
        return float(np.abs(self._pose(prim) - homogeneous(*at)).max())

    def _pose(self, prim: Any) -> Floats:
        """Pose of a prim in the world, (4, 4)."""
        above = []
        while prim and prim.GetPath() not in self._poses:
            above.append(prim)
            prim = prim.GetParent()
        pose = self._poses[prim.GetPath()] if prim else np.eye(4)
        for prim in reversed(above):
            pose = pose @ _local_pose(prim)
            self._poses[prim.GetPath()] = pose
        return pose

    def inertia(self, prim: Any) -> tuple[float, Floats, Floats]:
        """Mass in kg, (3,) centre in m and (3, 3) tensor about that, in the frame of a prim."""
        api = UsdPhysics.MassAPI(prim)
        if not prim.HasAPI(UsdPhysics.MassAPI) or not prim.HasAPI(UsdPhysics.RigidBodyAPI):
            return 0.0, np.zeros(3), np.zeros((3, 3))
        axes = api.GetPrincipalAxesAttr().Get()
        rotation = rotation_of(axes) if axes else np.eye(3)
        moments = np.array(api.GetDiagonalInertiaAttr().Get() or (0, 0, 0), dtype=float)
        center = np.array(api.GetCenterOfMassAttr().Get() or (0, 0, 0), dtype=float)
        if not np.isfinite(center).all():  # not written in the stage
            center = np.zeros(3)
        return float(api.GetMassAttr().Get() or 0), center, rotation @ np.diag(moments) @ rotation.T

    def axis_in_child(self, joint: Joint) -> Floats:
        """Axis of a joint with a prim, a unit vector in the frame of the child."""
        prim = self.joints[joint.name]
        rotation = rotation_of(UsdPhysics.Joint(prim).GetLocalRot1Attr().Get())
        return np.asarray(rotation @ _AXES[_axis_token(prim)])

    def relative_rotation(self, prim: Any) -> Floats:
        """Rotation of the second body of a joint in the first body, (3, 3)."""
        return self._relative(prim)[:3, :3]

    def frame_difference(self, prim: Any) -> float:
        """Difference of the two frames of a joint, in entries of the rotation and in m.

        Lengths are relative to the distance of the parent if it is above 1 m.
        """
        joint = UsdPhysics.Joint(prim)
        first = _frame(joint.GetLocalPos0Attr(), joint.GetLocalRot0Attr())
        second = _frame(joint.GetLocalPos1Attr(), joint.GetLocalRot1Attr())
        differences = np.abs(self._relative(prim) @ second - first)
        differences[:3, 3] /= max(1.0, np.abs(first[:3, 3]).max())
        return float(differences.max())

    def _relative(self, prim: Any) -> Floats:
        """Pose of the second body of a joint in the first body, (4, 4)."""
        joint = UsdPhysics.Joint(prim)
        placed = []
        for relation in (joint.GetBody0Rel(), joint.GetBody1Rel()):
            bodies = [self._stage.GetPrimAtPath(path) for path in relation.GetTargets()]
            placed.append(self._pose(bodies[0]) if bodies else np.eye(4))
        return np.asarray(np.linalg.inv(placed[0]) @ placed[1])


def _local_pose(prim: Any) -> Floats:
    """Pose of a prim in its parent, (4, 4).

    USD computes rotations from their angle, the arc cosine of a number near 1 if it is small, with
    an error up to 1e-8 rad.
    """
    pose = np.eye(4)
    for op in UsdGeom.Xformable(prim).GetOrderedXformOps() if prim.IsA(UsdGeom.Xformable) else ():
        is_rotation = op.GetOpType() == UsdGeom.XformOp.TypeOrient
        transform = op.GetOpTransform(Usd.TimeCode.Default())
        pose = pose @ (
            homogeneous(rotation_of(op.Get()), (0, 0, 0)) if is_rotation else np.array(transform).T
        )
    return pose


def _axis_token(prim: Any) -> str:
    """Axis of a joint in its own frame; for a planar joint, the locked translation."""
    locked = (axis for axis in _AXES if prim.HasAPI("PhysicsLimitAPI", f"trans{axis}"))
    return prim.GetAttribute("physics:axis").Get() or next(locked, "X")


def _frame(position: Any, rotation: Any) -> Floats:
    return homogeneous(rotation_of(rotation.Get()), position.Get())


def rotation_of(quaternion: Any) -> Floats:
    """Rotation matrix of a quaternion, (3, 3); `Gf.Rotation` loses small rotations."""
    return np.asarray(np.array(Gf.Matrix3d(Gf.Quatd(quaternion).GetNormalized())).T)


def _name(prim: Any) -> str:
    """Name of a prim in the robot."""
    return str(prim.GetDisplayName() or prim.GetName())
