"""A robot as MJCF: bodies, joints and equalities, built with MuJoCo's `MjSpec`."""

from collections.abc import Container, Iterable, Iterator, Mapping
from typing import Any

import mujoco
import numpy as np

from urdfkit.core.spatial import AXES, Rotation, Transform, basis, cross, rotation
from urdfkit.lint.context import Context
from urdfkit.output.bundle.meshes import FreeNames
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.mjcf_geoms import Geoms
from urdfkit.output.conversion.mjcf_pieces import WrittenShape, quaternion
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.robot.inertia import MassProperties, combined, principal_moments
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_loads import effort
from urdfkit.robot.kinematics import direction, laws
from urdfkit.robot.link import Link, Tensor
from urdfkit.robot.rigid_bodies import RigidBody, properties_of, rigid_bodies
from urdfkit.robot.tree import KinematicTree
from urdfkit.robot.values import number
from urdfkit.ros.gazebo.sensors import sensors

#: Least range of a joint that MuJoCo accepts, in rad or m.
NARROWEST = 1e-6

_HINGE, _SLIDE = mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE
_BALL = mujoco.mjtJoint.mjJNT_BALL


class MjcfRobot:
    """The MuJoCo specification of a robot, built from urdfkit's model.

    Args:
        robot: a robot with a valid tree.
        files: path of each mesh and texture file, by the ``id`` of the reference.
        directory: base of the paths.
        is_free: True if the root floats, False if it is welded to the world.

    Raises:
        UrdfkitError: a joint or a shape is invalid.
    """

    def __init__(
        self,
        robot: Context,
        files: Mapping[int, str],
        directory: str,
        options: ConversionOptions,
        *,
        is_free: bool,
    ) -> None:
        tree = robot.tree
        self.losses = LossTable()  # result for each part
        self.spec = _empty(tree.model.name, directory)  # MuJoCo's
        self.bodies: dict[str, Any] = {}  # by link; merged links share a body
        self.frames: dict[str, Transform] = {}  # of the links, in their bodies
        self.geoms: dict[str, list[Any]] = {}  # colliding geoms, by link
        self.devices = FreeNames()  # names of sites, sensors and cameras
        self._joint_names = FreeNames()
        for joint in tree.model.joints:
            self._joint_names.take(joint.name)
        self._tree = tree
        self._merged = mergeable_joints(robot) if options.fixed == "merge" else frozenset()
        self._inertials = dict(_inertials(tree, self._merged))
        self._geoms = Geoms(self.spec, robot, files, directory, self.losses, options)
        self.mesh_places = self._geoms.meshes.places  # source locations of meshes, by name
        self.hulls = self._geoms.collisions.hulls  # collisions that become convex hulls
        self._build(tree, is_free)
        self._couple(tree)

    @property
    def shapes(self) -> dict[int, WrittenShape]:
        """The geoms of visuals and collisions, by the ``id`` of the element; after compilation."""
        simpler = self._geoms.collisions.simpler
        return {
            key: WrittenShape(tuple(geom.id for geom in geoms), key not in simpler)
            for key, geoms in self._geoms.shapes.items()
        }

    def _build(self, tree: KinematicTree, is_free: bool) -> None:
        model = tree.model
        self.losses.keep(model.root, "model")
        for name in tree.below(tree.roots[0].name):
            link = model.links_by_name[name]
            joint = tree.parents[name][0] if tree.parents[name] else None
            self.frames[name] = Transform()
            if joint is not None and joint.name in self._merged:
                self._merge(link, joint)
            elif joint is None and name == "world":
                self.bodies[name] = self.spec.worldbody
            else:
                self.bodies[name] = self._body(link, joint)
            if joint is None and is_free:
                self.bodies[name].add_freejoint(name=self._joint_names.take(f"{name}_free"))
            self._fill(link)

    def _merge(self, link: Link, joint: Joint) -> None:
        """Add a merged link: a site at its frame."""
        parent = joint.parent_name
        self.bodies[link.name] = self.bodies[parent]
        self.frames[link.name] = frame = self.frames[parent] @ joint.origin
        self.bodies[parent].add_site(
            name=self.devices.take(link.name), pos=frame.position, quat=quaternion(frame.rotation)
        )
        note = f"merged into body '{self.bodies[parent].name}'"
        self.losses.keep(joint.at, note, "origin", "parent", "child")

    def _body(self, link: Link, joint: Joint | None) -> Any:
        parent, frame = self.spec.worldbody, Transform()
        if joint is not None:
            parent_name = joint.parent_name
            parent, frame = self.bodies[parent_name], self.frames[parent_name] @ joint.origin
        body = parent.add_body(name=link.name, pos=frame.position, quat=quaternion(frame.rotation))
        if joint is not None:
            self._joint(body, joint)
        return body

    def _joint(self, body: Any, joint: Joint) -> None:
        keep = self.losses.keep
        at, what = joint.at, f"joint '{joint.name}'"
        keep(at, what if joint.kind != "fixed" else "body without a joint")
        for tag in ("origin", "parent", "child"):
            keep(at.child(tag), "pose of the body")
        if joint.is_single_dof:
            kind = _SLIDE if joint.is_prismatic else _HINGE
            mj_joint = body.add_joint(name=joint.name, type=kind, axis=direction(joint))
            keep(at.child("axis"), "axis")
            self._limits(mj_joint, joint)
            self._damping(mj_joint, joint)
        elif joint.kind == "floating":
            motions = (*((_SLIDE, axis) for axis in AXES), (_BALL, None))
            self._add_joints(body, joint, motions)
            self._lose(joint, ("axis", "limit", "dynamics"), "a floating joint has none")
        elif joint.kind == "planar":
            normal = direction(joint)
            _, first, _ = basis(normal)
            motions = ((_SLIDE, first), (_SLIDE, cross(normal, first)), (_HINGE, normal))
            self._add_joints(body, joint, motions)
            keep(at.child("axis"), "axes")
            why = "a planar joint has three motions, and URDF does not define which one this limits"
            self._lose(joint, ("limit", "dynamics"), why)
        else:
            self._lose(joint, ("axis", "limit", "dynamics", "mimic"), "a fixed joint does not move")

    def _lose(self, joint: Joint, tags: Iterable[str], reason: str) -> None:
        for tag in tags:
            self.losses.lose(joint.at.child(tag), reason)

    def _add_joints(self, body: Any, joint: Joint, motions: Iterable[tuple[Any, Any]]) -> None:
        """Add several MuJoCo joints for a joint with several coordinates."""
        for n, (kind, axis) in enumerate(motions):
            mj_joint = body.add_joint(name=self._joint_names.take(f"{joint.name}[{n}]"), type=kind)
            if axis is not None:
                mj_joint.axis = axis

    def _limits(self, mj_joint: Any, joint: Joint) -> None:
        limit = joint.limit
        if limit is None:
            return
        attributes = limit.at.attributes
        self.losses.keep(limit.at, "range")
        lower, upper = limit.ends
        if joint.kind == "continuous":
            reason = "a continuous joint has no range"
            self.losses.lose(attributes.get("lower"), reason)
            self.losses.lose(attributes.get("upper"), reason)
        else:
            mj_joint.limited, mj_joint.range = True, (lower, max(upper, lower + NARROWEST))
            if lower == upper:
                self.losses.approximate(limit.at, f"range of {NARROWEST:g}")
        if bound := effort(joint):
            mj_joint.actfrclimited, mj_joint.actfrcrange = True, (-bound, bound)
            self.losses.keep(attributes.get("effort"), "actuatorfrcrange")
        else:
            self.losses.lose(attributes.get("effort"), "an effort of 0 or less is not a limit")
        self.losses.lose(attributes.get("velocity"), "MuJoCo does not limit velocities")

    def _damping(self, mj_joint: Any, joint: Joint) -> None:
        dynamics = joint.at.child("dynamics")
        if dynamics is None:
            return
        self.losses.keep(dynamics, "joint")
        for name, field in (("damping", "damping"), ("friction", "frictionloss")):
            attribute = dynamics.attributes.get(name)
            value = number(attribute.value) if attribute else None
            if value is not None and value >= 0:
                # MuJoCo's damping has three coefficients; the first one is URDF's.
                setattr(mj_joint, field, (value, 0.0, 0.0) if field == "damping" else value)
                self.losses.keep(attribute, field)
            else:
                self.losses.lose(attribute, f"a {name} must be a number of at least 0")

    def _fill(self, link: Link) -> None:
        """Add the contents of a link to its body."""
        body = self.bodies[link.name]
        is_own = body.name == link.name
        self.losses.keep(link.at, f"body '{body.name}'" if is_own else f"site of '{body.name}'")
        if body is self.spec.worldbody:
            self.losses.lose(link.inertial.at if link.inertial else None, "the world does not move")
        else:
            self._inertial(body, link)
        self.geoms[link.name] = self._geoms.add(body, self.frames[link.name], link)

    def _inertial(self, body: Any, link: Link) -> None:
        inertial = self._inertials.get(link.name)
        if inertial is not None and (link.inertial or inertial.mass):
            moments, axes = _principal(inertial.tensor)
            body.explicitinertial = True
            body.mass, body.ipos, body.inertia = inertial.mass, inertial.center, moments
            body.iquat = quaternion(axes)
        if link.inertial is None:
            return
        note = f"part of the inertial of body '{self._top(link.name)}'"
        note = "inertial" if inertial else note
        self.losses.keep(link.inertial.at, note, "mass", "inertia", "origin")

    def _top(self, link: str) -> str:
        """The link that has the inertia of another link."""
        while link not in self._inertials:
            joint = self._tree.parents[link][0]
            link = joint.parent_name
        return link

    def _couple(self, tree: KinematicTree) -> None:
        """Add equalities for mimic joints."""
        joints = tree.model.joints_by_name
        couplings = laws(joints)
        for joint in tree.model.joints:
            mimic = joint.mimic
            if mimic is None:
                continue
            leader, factor, shift = couplings[joint.name]
            if not (joint.is_single_dof and leader and joints[leader].is_single_dof):
                self._lose_mimic(joint, leader)
                continue
            equality = self.spec.add_equality(
                name=f"{joint.name}_mimic",
                type=mujoco.mjtEq.mjEQ_JOINT,
                objtype=mujoco.mjtObj.mjOBJ_JOINT,
                name1=joint.name,
                name2=leader,
            )
            equality.data[:5] = (shift, factor, 0.0, 0.0, 0.0)
            self.losses.keep(mimic.at, "equality")

    def _lose_mimic(self, joint: Joint, leader: str) -> None:
        """Record why a ``<mimic>`` is lost; ``leader`` is empty if the leader does not exist."""
        if joint.kind == "fixed":
            return
        if not joint.is_single_dof:
            why = f"a {joint.kind} joint cannot follow another joint"
        elif leader:
            kind = self._tree.model.joints_by_name[leader].kind
            why = f"'{leader}' is a {kind} joint, which cannot lead a mimic joint"
        else:
            why = "no independent joint leads it"
        free = " and has no actuator" if joint.is_single_dof else ""
        self.losses.lose(joint.at.child("mimic"), f"{why}: the joint moves freely{free}")


def mergeable_joints(robot: Context) -> frozenset[str]:
    """Names of fixed joints whose links can be merged; a force-torque sensor needs a body."""
    joints = {sensor.reference for sensor in sensors(robot.model) if sensor.type == "force_torque"}
    fixed = {joint.name for joint in robot.model.joints if joint.kind == "fixed"}
    return frozenset(fixed - joints)


def _inertials(
    tree: KinematicTree, merged_joints: frozenset[str]
) -> Iterator[tuple[str, MassProperties]]:
    """The inertia of each body, about its own frame.

    MuJoCo rejects an invalid tensor, also of a fixed link. The topmost of the links that are
    fixed together then has their summed inertia.
    """
    fixed = {joint.name for joint in tree.model.joints if joint.kind == "fixed"}
    for group in rigid_bodies(tree, frozenset(fixed - merged_joints if merged_joints else ())):
        own = {link.name: properties_of(link, Transform()) for link, _ in group.links}
        sound = {name for name, properties in own.items() if _is_physical(properties.tensor)}
        top = group.top.name
        separate = sound - {top} if top in sound and not merged_joints else set()
        summed = _summed(group, separate)
        if separate and not _is_physical(summed.tensor):  # the sum of the other links is invalid
            separate, summed = set(), _summed(group, set())
        yield top, summed
        for name in separate:
            yield name, own[name]


def _summed(group: RigidBody, excluded: Container[str]) -> MassProperties:
    """The inertia of a body without some of its links, in the frame of the topmost link."""
    parts = [properties_of(link, frame) for link, frame in group.links if link.name not in excluded]
    return combined(parts) if len(parts) > 1 else parts[0]


def _is_physical(tensor: Tensor) -> bool:
    least, middle, most = principal_moments(tensor)
    return least >= 0 and least + middle >= most


def _principal(tensor: Tensor) -> tuple[Any, Rotation]:
    """Principal moments, and their axes as a rotation."""
    moments, axes = np.linalg.eigh(tensor.rows)
    axes[:, 0] *= np.sign(np.linalg.det(axes))
    return moments, rotation(axes)


def _empty(name: str, directory: str) -> Any:
    spec = mujoco.MjSpec()
    spec.modelname = name or "robot"
    spec.modelfiledir = directory
    spec.compiler.degree = False
    spec.compiler.saveinertial = True
    spec.compiler.inertiafromgeom = mujoco.mjtInertiaFromGeom.mjINERTIAFROMGEOM_FALSE
    return spec
