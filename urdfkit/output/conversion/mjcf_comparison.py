"""Differences of inertia, limits and shapes between MuJoCo's model and the robot."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import mujoco
import numpy as np

from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Floats
from urdfkit.mesh.transforms import homogeneous
from urdfkit.output.conversion.body_inertia import about_center, difference, of_link, pseudo_inertia
from urdfkit.output.conversion.mjcf_geoms import COLLISION_GROUP, KINDS, VISUAL_GROUP
from urdfkit.output.conversion.mjcf_meshes import has_few_vertices
from urdfkit.output.conversion.mjcf_pieces import WrittenShape
from urdfkit.output.conversion.mjcf_robot import NARROWEST
from urdfkit.output.conversion.text_reading import TextReading
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_loads import effort
from urdfkit.robot.kinematics import laws
from urdfkit.robot.link import Body, Shape
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.values import number

#: Entries below this, in N·m, kg or kg·m², are rounding errors.
ZERO = 1e-9
#: Difference of a part that is missing or of another type.
WHOLE = 1.0


def relative(ours: Floats, theirs: Floats, least: float = ZERO) -> float:
    """The largest difference, relative to the largest entry or ``least``."""
    largest = max(float(np.abs(ours).max(initial=0.0)), least)
    return float(np.abs(ours - theirs).max(initial=0.0)) / largest


def names(model: Any, kind: str) -> dict[str, int]:
    """Indices of bodies (``nbody``) or joints (``njnt``), by name."""
    part = model.body if kind == "nbody" else model.joint
    return {part(number).name: number for number in range(getattr(model, kind))}


def inertias(
    model: Any, robot: Context, reading: TextReading | None
) -> Iterator[tuple[float, str]]:
    """Relative differences of the inertia of links that are fixed together."""
    bodies = names(model, "nbody")
    for group in rigid_bodies(robot.tree):
        if group.is_ground:
            continue
        written = [link.inertial for link, _ in group.links if link.inertial]
        # urdfdom drops an <inertial> without mass or tensor.
        is_complete = all(inertial.mass and inertial.tensor for inertial in written)
        if reading is not None and is_complete:
            ours = reading.inertia(group)
        else:
            ours = sum((of_link(*member) for member in group.links), np.zeros((4, 4)))
        theirs = np.zeros((4, 4))
        for link, frame in group.links:
            if link.name in bodies:
                theirs = theirs + pseudo_inertia(*_inertia(model, bodies[link.name]), frame)
        yield difference(*about_center(ours, theirs)), group.top.name


def _inertia(model: Any, body: int) -> tuple[float, Floats, Floats]:
    """Mass, centre and tensor of a body, in its frame."""
    axes = np.zeros(9)
    mujoco.mju_quat2Mat(axes, model.body_iquat[body])
    turned = axes.reshape(3, 3)
    tensor = turned @ np.diag(model.body_inertia[body]) @ turned.T
    return float(model.body_mass[body]), model.body_ipos[body], tensor


def joints(model: Any, robot: Context) -> Iterator[tuple[float, str]]:
    """Relative differences of the joints in range, effort, damping and friction."""
    indices, by_name = names(model, "njnt"), robot.model.joints_by_name
    followed, coupled = laws(by_name), 0
    for joint in by_name.values():
        if joint.is_single_dof:
            leader = by_name.get(followed[joint.name].leader) if joint.mimic else None
            coupled += leader is not None and leader.is_single_dof
            index = indices.get(joint.name)
            yield (WHOLE if index is None else _joint(model, index, joint)), joint.name
    yield (WHOLE if coupled != model.neq else 0.0), ""


def _joint(model: Any, at: int, joint: Joint) -> float:
    limit, effort_limit, dof = joint.limit, effort(joint), model.jnt_dofadr[at]
    limits = force = None
    if limit is not None and joint.kind != "continuous":
        lower, upper = limit.ends
        limits = lower, max(upper, lower + NARROWEST)
    if effort_limit is not None:
        force = -effort_limit, effort_limit
    dynamics = joint.at.child("dynamics")
    written = [number(dynamics.get(name)) if dynamics else 0 for name in ("damping", "friction")]
    ours = np.array([max(value or 0.0, 0.0) for value in written])
    theirs = np.array([model.dof_damping[dof], model.dof_frictionloss[dof]])
    return max(
        _ends(limits, model.jnt_range[at] if model.jnt_limited[at] else None),
        _ends(force, model.jnt_actfrcrange[at] if model.jnt_actfrclimited[at] else None),
        relative(ours, theirs),
    )


def _ends(ours: tuple[float, float] | None, theirs: Floats | None) -> float:
    if ours is None or theirs is None:
        return WHOLE if ours or theirs is not None else 0.0
    return relative(np.array(ours), theirs)


def residual(data: Any) -> float:
    """Deviation of mimic joints from their leaders, in rad or m."""
    rows = data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY
    return float(np.abs(data.efc_pos[rows]).max(initial=0.0))


def shapes(
    data: Any, robot: Context, placed: Mapping[str, Floats], written: Mapping[int, WrittenShape]
) -> Iterator[tuple[float, str]]:
    """Differences of visuals and collisions in kind, pose and size, relative to their size.

    Args:
        placed: frames of the links at the pose of ``data``.
        written: the geoms by the ``id`` of the element.
    """
    for link in robot.model.links:
        for body in link.bodies:
            if body.shape is not None and body.shape.kind in KINDS:
                place = placed[link.name] @ homogeneous(*body.origin)
                yield _shape(data, robot, body, place, written.get(id(body.at))), link.name


def _shape(
    data: Any, robot: Context, body: Body, place: Floats, geoms_of_shape: WrittenShape | None
) -> float:
    shape, model = body.shape, data.model
    assert shape is not None
    extents = shape.half_extents
    if geoms_of_shape is None:
        is_empty = min(extents) <= 0 if extents else has_few_vertices(robot, shape)
        return 0.0 if is_empty and body.at.tag == "visual" else WHOLE
    geoms, back = list(geoms_of_shape.geoms), np.linalg.inv(place)
    group = VISUAL_GROUP if body.at.tag == "visual" else COLLISION_GROUP
    if set(model.geom_group[geoms]) != {group}:
        return WHOLE
    frames = [
        back @ homogeneous(data.geom_xmat[geom].reshape(3, 3), data.geom_xpos[geom])
        for geom in geoms
    ]
    if extents is None:
        return _mesh(model, robot, shape, geoms_of_shape, frames)
    if set(model.geom_type[geoms]) != {int(KINDS[shape.kind])}:
        return WHOLE
    largest = max(extents)
    distances = np.abs(frames[0] - np.eye(4)) / [1, 1, 1, largest]
    sizes = np.abs(model.geom_aabb[geoms[0], 3:] - extents) / largest
    return float(max(distances.max(), sizes.max()))


def _mesh(
    model: Any, robot: Context, shape: Shape, written: WrittenShape, frames: Sequence[Floats]
) -> float:
    """Deviation of the bounding boxes of meshes, or of simpler shapes outside of the mesh."""
    mesh = robot.meshes.mesh(shape)
    if mesh is None or not len(mesh.faces):
        return 0.0
    ours = mesh.vertices[np.unique(mesh.faces)] * np.multiply(shape.scale, mesh.unit)
    low, high = ours.min(axis=0), ours.max(axis=0)
    if written.is_exact:
        corners = [_vertices(model, geom) for geom in written.geoms]
        moved = [
            at @ frame[:3, :3].T + frame[:3, 3] for at, frame in zip(corners, frames, strict=True)
        ]
        theirs = np.concatenate(moved)
        distances = np.abs([theirs.min(axis=0) - low, theirs.max(axis=0) - high])
    else:
        centers = np.array([frame[:3, 3] for frame in frames])
        distances = np.maximum(low - centers, centers - high).clip(0)
    return float(distances.max() / max(np.abs(ours).max(), ZERO))


def _vertices(model: Any, geom: int) -> Floats:
    """The vertices of the faces of a geom's mesh, (n, 3), in the frame of the geom."""
    mesh = model.geom_dataid[geom]
    first, count = model.mesh_faceadr[mesh], model.mesh_facenum[mesh]
    used = np.unique(model.mesh_face[first : first + count]) + model.mesh_vertadr[mesh]
    return np.asarray(model.mesh_vert[used].astype(float))
