"""A robot as MuJoCo's MJCF: bodies, joints, geoms and their meshes, by MuJoCo's own `MjSpec`."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from itertools import chain, count
from typing import Any

import mujoco
import numpy as np

from urdfkit.core.spatial import Rotation, Transform, vector
from urdfkit.errors import UrdfkitError
from urdfkit.output.conversion.losses import LossTable
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.inertia import MassProperties, combined, principal_moments
from urdfkit.robot.kinematics import SLIDING, TURNING, direction, laws
from urdfkit.robot.model import Body, Inertial, Joint, Link, Material, Shape, Tensor
from urdfkit.robot.rigid_bodies import properties_of, rigid_bodies
from urdfkit.robot.tree import KinematicTree

#: The least range that MuJoCo accepts of a joint, in rad or m.
NARROWEST = 1e-6
#: The groups that MuJoCo's viewer shows and hides: visuals, collisions.
VISUALS, COLLISIONS = 2, 3

_HINGE, _SLIDE = mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE
_BALL = mujoco.mjtJoint.mjJNT_BALL
_GEOMS = {
    "box": mujoco.mjtGeom.mjGEOM_BOX,
    "sphere": mujoco.mjtGeom.mjGEOM_SPHERE,
    "cylinder": mujoco.mjtGeom.mjGEOM_CYLINDER,
    "capsule": mujoco.mjtGeom.mjGEOM_CAPSULE,
    "mesh": mujoco.mjtGeom.mjGEOM_MESH,
}
#: Joints that one number moves.
_ONE_WAY = (*TURNING, *SLIDING)
_AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class MjcfRobot:
    """The specification of a robot, built from the model that a check reads.

    Args:
        tree: of the robot, sound.
        files: where the file of each mesh and texture lies, by the ``id`` of the reference.
        directory: that the paths of the files begin in.
        is_free: the root floats, and is not welded to the world.

    Raises:
        UrdfkitError: a joint or a shape has no meaning.
    """

    def __init__(
        self, tree: KinematicTree, files: Mapping[int, str], directory: str, *, is_free: bool
    ) -> None:
        self.losses = LossTable()  # what became of each part
        self.bodies: dict[str, Any] = {}  # of the links, by name
        self.excluded: set[frozenset[str]] = set()  # pairs of links that do not collide
        self._files = files
        self._colours = Colours(tree.model)
        self._inertials = dict(_inertials(tree))
        self._meshes: dict[tuple[str, tuple[float, ...], bool], str] = {}
        self._names: set[str] = set()
        self.spec = _empty(tree.model.name, directory)  # MuJoCo's
        self._build(tree, is_free)
        self._couple(tree)

    def _build(self, tree: KinematicTree, is_free: bool) -> None:
        model = tree.model
        self.losses.keep(model.root, "model")
        for name in tree.below(tree.roots[0].name):
            link = model.links_by_name[name]
            joint = tree.parents[name][0] if tree.parents[name] else None
            if joint is None and name == "world":
                self.bodies[name] = self.spec.worldbody
            else:
                self.bodies[name] = self._body(link, joint)
            if joint is None and is_free:
                self.bodies[name].add_freejoint(name=f"{name}_free")
            self._fill(link)

    def _body(self, link: Link, joint: Joint | None) -> Any:
        parent, frame = self.spec.worldbody, Transform()
        if joint is not None:
            assert joint.parent is not None
            parent, frame = self.bodies[joint.parent.value], joint.origin
        body = parent.add_body(name=link.name, pos=frame.position, quat=quaternion(frame.rotation))
        if joint is not None:
            self._joint(body, joint)
        return body

    def _joint(self, body: Any, joint: Joint) -> None:
        keep = self.losses.keep
        at, what = joint.at, f"joint '{joint.name}'"
        keep(at, what if joint.kind != "fixed" else "body without a joint")
        for tag in ("origin", "parent", "child"):
            keep(at.child(tag), "place of the body")
        if joint.kind in _ONE_WAY:
            kind = _SLIDE if joint.kind == "prismatic" else _HINGE
            made = body.add_joint(name=joint.name, type=kind, axis=direction(joint))
            keep(at.child("axis"), "axis")
            self._limits(made, joint)
            self._damping(made, joint)
        elif joint.kind == "floating":
            for number, axis in enumerate(_AXES):
                body.add_joint(name=f"{joint.name}[{number}]", type=_SLIDE, axis=axis)
            body.add_joint(name=f"{joint.name}[3]", type=_BALL)
        elif joint.kind == "planar":
            first, second, normal = _plane(direction(joint))
            for number, (kind, axis) in enumerate(
                ((_SLIDE, first), (_SLIDE, second), (_HINGE, normal))
            ):
                body.add_joint(name=f"{joint.name}[{number}]", type=kind, axis=axis)
            keep(at.child("axis"), "axes")
        elif joint.kind != "fixed":
            raise UrdfkitError(f"{at.span}: joint '{joint.name}' has the type '{joint.kind}'")

    def _limits(self, made: Any, joint: Joint) -> None:
        limit = joint.limit
        if limit is None:
            return
        attributes = limit.at.attributes
        self.losses.keep(limit.at, "range")
        lower, upper = (one.value if one else 0.0 for one in (limit.lower, limit.upper))
        if joint.kind == "continuous":
            reason = "a continuous joint has no range"
            self.losses.lose(attributes.get("lower"), reason)
            self.losses.lose(attributes.get("upper"), reason)
        elif lower > upper:
            raise UrdfkitError(f"{limit.at.span}: joint '{joint.name}': lower is over upper")
        else:
            made.limited, made.range = True, (lower, max(upper, lower + NARROWEST))
            if lower == upper:
                self.losses.approximate(limit.at, f"range of {NARROWEST:g}")
        if limit.effort and limit.effort.value > 0:
            made.actfrclimited, made.actfrcrange = True, (-limit.effort.value, limit.effort.value)
            self.losses.keep(attributes.get("effort"), "actuatorfrcrange")
        else:
            self.losses.lose(attributes.get("effort"), "an effort that is not over 0 is no limit")
        self.losses.lose(attributes.get("velocity"), "MuJoCo does not limit velocities")

    def _damping(self, made: Any, joint: Joint) -> None:
        dynamics = joint.at.child("dynamics")
        if dynamics is None:
            return
        self.losses.keep(dynamics, "joint")
        for name, field in (("damping", "damping"), ("friction", "frictionloss")):
            attribute = dynamics.attributes.get(name)
            value = _positive(attribute.value) if attribute else None
            if value is not None:
                # A damping has three coefficients, of which the first is URDF's.
                setattr(made, field, (value, 0.0, 0.0) if field == "damping" else value)
                self.losses.keep(attribute, field)

    def _fill(self, link: Link) -> None:
        """What a link holds, in its body."""
        body = self.bodies[link.name]
        self.losses.keep(link.at, f"body '{body.name}'")
        if link.inertial and body is self.spec.worldbody:
            self.losses.lose(link.inertial.at, "the world does not move")
        elif link.inertial:
            self._inertial(body, link, link.inertial)
        for geometry in link.visuals:
            self._geom(body, geometry, is_visual=True)
        for geometry in link.collisions:
            self._geom(body, geometry, is_visual=False)

    def _inertial(self, body: Any, link: Link, inertial: Inertial) -> None:
        what = "inertial"
        if link.name in self._inertials:
            found = self._inertials[link.name]
            moments, axes = _principal(found.tensor)
            body.explicitinertial = True
            body.mass, body.ipos, body.inertia = found.mass, found.center, moments
            body.iquat = quaternion(axes)
        else:
            what = "part of the inertial of the link that it is fixed to"
        self.losses.keep(inertial.at, what)
        for tag in ("mass", "inertia", "origin"):
            self.losses.keep(inertial.at.child(tag), what)

    def _geom(self, body: Any, geometry: Body, *, is_visual: bool) -> None:
        shape = geometry.shape
        if shape is None or shape.kind not in _GEOMS:
            return
        size = _size(shape)
        if size is None:
            raise UrdfkitError(f"{shape.at.span}: <{shape.kind}> has no size that is over 0")
        made = body.add_geom(
            type=_GEOMS[shape.kind],
            pos=geometry.origin.position,
            quat=quaternion(geometry.origin.rotation),
            size=size,
            group=VISUALS if is_visual else COLLISIONS,
        )
        what = "visual geom" if is_visual else "collision geom"
        self.losses.keep(geometry.at, what)
        for tag in ("origin", "geometry"):
            self.losses.keep(geometry.at.child(tag), what)
        self.losses.keep(shape.at, what)
        if shape.filename is not None:
            made.meshname = self._mesh(shape, is_visual)
            if not is_visual:
                self.losses.approximate(shape.at, "MuJoCo collides with its convex hull")
        if is_visual:
            made.contype = made.conaffinity = 0
            self._color(made, geometry)

    def _mesh(self, shape: Shape, is_visual: bool) -> str:
        assert shape.filename is not None
        file = self._files[id(shape.filename)]
        key = (file, shape.scale, is_visual)
        if key not in self._meshes:
            stem = os.path.splitext(os.path.basename(file))[0]
            number = sum(one[0] == file for one in self._meshes)
            self._meshes[key] = f"{stem}_{number + 1}" if number else stem
            made = self.spec.add_mesh(name=self._meshes[key], file=file, scale=shape.scale)
            if is_visual:  # which may be flat
                made.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
        return self._meshes[key]

    def _color(self, made: Any, geometry: Body) -> None:
        material = self._colours.of(geometry)
        if material is None:
            return
        self.losses.lose(material.at.child("texture"), "textures are not converted")
        if material.rgba and len(material.rgba.value) == 4:
            made.rgba = material.rgba.value
            for one in (material.at, material.at.child("color"), geometry.material):
                self.losses.keep(one.at if isinstance(one, Material) else one, "rgba of the geom")

    def free_name(self, name: str) -> str:
        """A name for a device: the same, or with a number if it is taken."""
        numbered = (f"{name}_{number}" for number in count(2))
        free = next(one for one in chain((name,), numbered) if one not in self._names)
        self._names.add(free)
        return free

    def _couple(self, tree: KinematicTree) -> None:
        """Equalities for what follows another joint."""
        joints = tree.model.joints_by_name
        known = laws(joints)
        for joint in tree.model.joints:
            mimic = joint.mimic
            if mimic is None:
                continue
            leader, factor, shift = known[joint.name]
            if not {joint.kind, joints[leader].kind if leader else ""} <= set(_ONE_WAY):
                continue
            made = self.spec.add_equality(
                name=f"{joint.name}_mimic",
                type=mujoco.mjtEq.mjEQ_JOINT,
                objtype=mujoco.mjtObj.mjOBJ_JOINT,
                name1=joint.name,
                name2=leader,
            )
            made.data[:5] = (shift, factor, 0.0, 0.0, 0.0)
            self.losses.keep(mimic.at, "equality")


def _inertials(tree: KinematicTree) -> Iterator[tuple[str, MassProperties]]:
    """The inertia of each body, about its own frame.

    MuJoCo rejects a tensor that no body has, of a fixed link, too. What is fixed together then
    has its inertia at its top, where the sum counts.
    """
    for group in rigid_bodies(tree):
        own = {link.name: properties_of(link, Transform()) for link, _ in group.links}
        top, has_sound_top = group.top.name, _is_physical(own[group.top.name].tensor)
        summed = [properties_of(group.top, Transform())]
        for link, frame in group.links[1:]:
            if has_sound_top and _is_physical(own[link.name].tensor):
                yield link.name, own[link.name]
            else:
                summed.append(properties_of(link, frame))
        yield top, combined(summed) if len(summed) > 1 else own[top]


def _is_physical(tensor: Tensor) -> bool:
    least, middle, most = principal_moments(tensor)
    return least >= 0 and least + middle >= most


def _principal(tensor: Tensor) -> tuple[Any, Rotation]:
    """The principal moments, and their axes as a rotation."""
    xx, xy, xz, yy, yz, zz = tensor
    moments, axes = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    axes[:, 0] *= np.sign(np.linalg.det(axes))
    first, second, third = (vector(row) for row in axes)
    return moments, (first, second, third)


def _empty(name: str, directory: str) -> Any:
    spec = mujoco.MjSpec()
    spec.modelname = name or "robot"
    spec.modelfiledir = directory
    spec.compiler.degree = False
    spec.compiler.saveinertial = True
    spec.compiler.inertiafromgeom = mujoco.mjtInertiaFromGeom.mjINERTIAFROMGEOM_FALSE
    return spec


def quaternion(rotation: Rotation) -> tuple[float, float, float, float]:
    """The unit quaternion of a rotation, its real part first."""
    found = np.zeros(4)
    mujoco.mju_mat2Quat(found, np.array(rotation).ravel())
    w, x, y, z = map(float, found)
    return w, x, y, z


def _plane(normal: tuple[float, float, float]) -> tuple[Any, Any, Any]:
    """Two unit vectors across a third, right-handed, and that."""
    least = np.eye(3)[np.argmin(np.abs(normal))]
    first = np.cross(normal, least)
    first /= np.linalg.norm(first)
    return first, np.cross(normal, first), np.array(normal)


def _size(shape: Shape) -> tuple[float, ...] | None:
    """MuJoCo's: half the edges of a box, radius and half the length of what has them."""
    if shape.kind == "mesh":
        return (0.0, 0.0, 0.0)
    if shape.kind == "box":
        written: tuple[float | None, ...] = shape.size or (None,)
    else:
        written = (shape.radius,) if shape.kind == "sphere" else (shape.radius, shape.length)
    sizes = [one for one in written if one is not None and one > 0]
    if len(sizes) < len(written):
        return None
    if shape.kind == "box":
        return tuple(edge / 2 for edge in sizes)
    radius, *length = sizes
    return (radius, length[0] / 2 if length else 0.0, 0.0)


def _positive(text: str) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if value > 0 else None
