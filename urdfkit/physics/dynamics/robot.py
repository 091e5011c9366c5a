"""A robot in Pinocchio, built from the robot model instead of the URDF text.

The root has a free-flyer joint, so that its mass counts: a Pinocchio model with a fixed base merges
it into the world. Every movable joint is a separate joint in Pinocchio, also with ``<mimic>``; a
constant matrix couples them, so that leaders and followers may be in any order and on any branch.
Results are for independent joints with a fixed root.

Lengths in m, angles in rad, masses in kg, forces in N; gravity is 9.81 m/s^2 along -z of the root.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

import numpy as np
import pinocchio as pin

from urdfkit.core.spatial import Rotation, Transform, Vector, transposed
from urdfkit.errors import UrdfkitError
from urdfkit.mesh.geometry import Floats
from urdfkit.robot.inertia import MassProperties, combined
from urdfkit.robot.joint import Joint
from urdfkit.robot.kinematics import direction, laws
from urdfkit.robot.link import Link, Tensor
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.robot.tree import KinematicTree

#: Pinocchio's memory grows with the cube of the joints in a row: 150 take 300 MB, 600 take 15 GB.
MAX_JOINTS = 150

#: Largest plausible number; products of larger numbers may overflow.
MAX_NUMBER = 1e30


class Unsuitable(UrdfkitError):
    """A robot or query that Pinocchio does not support; the text states why."""


class Dynamics:
    """Kinematics and dynamics of a robot.

    Attributes:
        tree: the kinematic tree.
        model: Pinocchio's model, with a free-flyer and a separate joint for each follower.
        columns: the coordinates, in the order of all vectors and matrices: the name of each
            independent joint, or ``name[0]``, ``name[1]`` ... if it has several: of a planar joint,
            two displacements perpendicular to its axis (x and y if the axis is z) and the angle
            about it; of a floating joint, the linear and then the angular velocity of its child.
        payload: additional masses in kg at the origins of links.

    Raises:
        Unsuitable: the robot is not a single tree, has too many joints, or implausible numbers.
    """

    def __init__(self, tree: KinematicTree, payload: Mapping[str, float] | None = None) -> None:
        if not tree.is_sound:
            raise Unsuitable(tree.unsound)
        self.tree = tree
        self.payload = dict(payload or {})
        self._joints = [joint for joint in _downwards(tree) if joint.kind in _KINDS]
        if len(self._joints) > MAX_JOINTS:
            count = len(self._joints)
            raise Unsuitable(f"too many movable joints for Pinocchio: {count} > {MAX_JOINTS}")
        for link, mass in self.payload.items():
            tree.model.require_link(link)
            if not abs(mass) < MAX_NUMBER:
                raise Unsuitable(f"payload of link '{link}' is implausible: {mass:g} kg")
        self.model, self._numbers, self._frames = _build(tree, self.payload)
        self._laws = laws(tree.model.joints_by_name)
        self._columns = dict(_columns(self._joints))
        self.columns = tuple(
            name for joint in self._joints if not joint.mimic for name in self._columns[joint.name]
        )

    @property
    def nq(self) -> int:
        """Size of a configuration, without followers and with a fixed root."""
        return sum(_KINDS[joint.kind].nq for joint in self._joints if not joint.mimic)

    @property
    def nv(self) -> int:
        """Size of a velocity: the degrees of freedom."""
        return len(self.columns)

    @cached_property
    def data(self) -> pin.Data:
        """Pinocchio's workspace, created on first use because it is large."""
        return self.model.createData()

    @cached_property
    def selection(self) -> Floats:
        """(6 + n, nv), maps velocities of ``columns`` to velocities of all joints of the model."""
        matrix = np.zeros((self.model.nv, self.nv))
        for joint in self._joints:
            start = self._joint(joint.name).idx_v
            if joint.mimic is None:
                for offset, name in enumerate(self._columns[joint.name]):
                    matrix[start + offset, self.columns.index(name)] = 1.0
                continue
            leader, factor, _ = self._laws[joint.name]
            if leader in self.columns and _KINDS[joint.kind].nv == 1:
                matrix[start, self.columns.index(leader)] = factor
        return matrix

    def configuration(self, pose: Mapping[str, float]) -> Floats:
        """Pinocchio's vector q of a pose, with followers.

        Args:
            pose: positions of joints in rad or m; other joints, and joints of several coordinates,
                are at 0.
        """
        x = np.array([pose.get(name, 0.0) for name in self.columns])
        q: Floats = pin.integrate(
            self.model, pin.neutral(self.model), self.selection @ x + self._shifts
        )
        return q

    @cached_property
    def _shifts(self) -> Floats:
        """(6 + n,), positions of the joints with all leaders at zero."""
        shifts = np.zeros(self.model.nv)
        for joint in self._joints:
            if _KINDS[joint.kind].nv == 1:
                shifts[self._joint(joint.name).idx_v] = self._laws[joint.name].shift
        return shifts

    def mass_properties(self, pose: Mapping[str, float] | None = None) -> MassProperties:
        """Mass, centre of mass and inertia tensor of the robot in the root frame; 0 if massless."""
        q = self.configuration(pose or {})
        pin.ccrba(self.model, self.data, q, np.zeros(self.model.nv))
        total = self.data.Ig
        if not total.mass:  # Pinocchio divides by it
            return combined(())
        center: Floats = pin.centerOfMass(self.model, self.data, q)
        xx, xy, yy, xz, yz, zz = map(float, total.inertia[np.tril_indices(3)])
        x, y, z = map(float, center)
        return MassProperties(float(total.mass), (x, y, z), Tensor(xx, xy, xz, yy, yz, zz))

    def placement(self, link: str, pose: Mapping[str, float]) -> Floats:
        """(4, 4), homogeneous matrix of a link in the root frame."""
        number = self._frames[self.tree.model.require_link(link).name]
        pin.framesForwardKinematics(self.model, self.data, self.configuration(pose))
        matrix: Floats = self.data.oMf[number].homogeneous
        return matrix

    def placements(self, pose: Mapping[str, float]) -> dict[str, Floats]:
        """(4, 4), homogeneous matrices of all links in the root frame."""
        pin.framesForwardKinematics(self.model, self.data, self.configuration(pose))
        return {name: self.data.oMf[number].homogeneous for name, number in self._frames.items()}

    def jacobian(self, link: str, pose: Mapping[str, float]) -> Floats:
        """(6, nv), Jacobian of the origin of a link.

        Three rows of linear velocity, then three of angular velocity, along the axes of the root.
        """
        number = self._frames[self.tree.model.require_link(link).name]
        q = self.configuration(pose)
        jacobian = pin.computeFrameJacobian(
            self.model, self.data, q, number, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        )
        return np.asarray(jacobian @ self.selection)

    def mass_matrix(self, pose: Mapping[str, float]) -> Floats:
        """(nv, nv), joint-space mass matrix with a fixed root, in kg, kg m or kg·m²."""
        upper = np.triu(pin.crba(self.model, self.data, self.configuration(pose)))
        # With negative masses Pinocchio divides by nearly zero.
        with np.errstate(over="ignore", invalid="ignore"):
            full = upper + np.triu(upper, 1).T
            return np.asarray(self.selection.T @ full @ self.selection)

    def gravity(self, pose: Mapping[str, float]) -> Floats:
        """(nv,), efforts that hold the robot still, in N·m or N."""
        torques = pin.computeGeneralizedGravity(self.model, self.data, self.configuration(pose))
        return np.asarray(self.selection.T @ torques)

    def _joint(self, name: str) -> pin.JointModel:
        return self.model.joints[self._numbers[name]]


def _downwards(tree: KinematicTree) -> list[Joint]:
    """The joints depth first: Pinocchio requires consecutive numbers in a subtree."""
    return [tree.parents[link][0] for link in tree.below(tree.roots[0].name)[1:]]


def _columns(joints: Sequence[Joint]) -> Iterator[tuple[str, list[str]]]:
    """The names of the coordinates of each joint; another joint may be called ``name[0]``."""
    taken = {joint.name for joint in joints}
    for joint in joints:
        count = _KINDS[joint.kind].nv
        names = [f"{joint.name}[{index}]" for index in range(count)]
        while taken.intersection(names):
            names = [f"{name}_" for name in names]
        yield joint.name, [joint.name] if count == 1 else names


#: Pinocchio's joint for each type of joint.
_KINDS = {
    "revolute": pin.JointModelRX(),
    "continuous": pin.JointModelRUBX(),
    "prismatic": pin.JointModelPX(),
    "planar": pin.JointModelPlanar(),
    "floating": pin.JointModelFreeFlyer(),
}


def _joint_model(joint: Joint) -> tuple[pin.JointModel, Transform]:
    """Pinocchio's joint, and the frame that defines its axis.

    In Python, the unbounded joint accepts no axis, and the planar joint has none: Pinocchio's URDF
    parser moves it perpendicular to z, whatever its axis. Both use the z axis of an own frame.
    """
    axis = direction(joint)
    if joint.kind == "revolute":
        return pin.JointModelRevoluteUnaligned(np.array(axis)), Transform()
    if joint.is_prismatic:
        return pin.JointModelPrismaticUnaligned(np.array(axis)), Transform()
    if joint.kind == "continuous":
        return pin.JointModelRUBZ(), Transform(_with_z(axis))
    if joint.kind == "planar":
        return pin.JointModelPlanar(), Transform(_with_z(axis))
    return _KINDS[joint.kind], Transform()


def _with_z(axis: Vector) -> Rotation:
    """A rotation that maps z to a unit vector; the smallest rotation if the vector points up."""
    x, y, z = axis
    if z < 0:
        (a, b, c), (d, e, f), (g, h, i) = _with_z((-x, -y, -z))
        return (a, -b, -c), (d, -e, -f), (g, -h, -i)
    k = 1 / (1 + z)  # Rodrigues' formula, with the sine and cosine of the angle in the axis
    return (1 - k * x * x, -k * x * y, x), (-k * x * y, 1 - k * y * y, y), (-x, -y, z)


def _build(
    tree: KinematicTree, payload: Mapping[str, float]
) -> tuple[pin.Model, dict[str, int], dict[str, int]]:
    """Pinocchio's model, and its numbers of the joints and links.

    Each link is a frame with an inertia. Numbers are needed because a robot may use a name that
    every Pinocchio model has.
    """
    model = pin.Model()
    base = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "root_joint")
    joints: dict[str, int] = {}
    placed = {tree.roots[0].name: (base, Transform())}
    for joint in _downwards(tree):
        parent, frame = placed[joint.parent_name]
        frame = frame @ joint.origin
        if joint.kind in _KINDS:
            kind, axis_frame = _joint_model(joint)
            parent = model.addJoint(parent, kind, _se3(frame @ axis_frame), joint.name)
            frame = Transform(transposed(axis_frame.rotation))
            joints[joint.name] = parent
        placed[joint.child_name] = parent, frame
    links: dict[str, int] = {}
    for name, (number, frame) in placed.items():
        inertia = _inertia(tree.model.links_by_name[name])
        body = pin.Frame(name, number, _se3(frame), pin.FrameType.BODY, inertia)
        links[name] = model.addFrame(body)
        if name in payload:
            point = pin.Inertia(payload[name], np.zeros(3), np.zeros((3, 3)))
            model.appendBodyToJoint(number, point, _se3(frame))
    return model, joints, links


def _inertia(link: Link) -> pin.Inertia:
    """Pinocchio's inertia of a link, in the link frame."""
    mass, center, moments = properties_of(link, Transform())
    tensor = np.array(moments.rows)
    if not max(abs(mass), np.abs(center).max(), np.abs(tensor).max()) < MAX_NUMBER:
        raise Unsuitable(f"link '{link.name}' has an implausible mass, position or inertia")
    inertia = pin.Inertia.Zero()  # other constructors reject values that Pinocchio's parser accepts
    inertia.mass, inertia.lever, inertia.inertia = mass, np.array(center), tensor
    return inertia


def _se3(frame: Transform) -> pin.SE3:
    position = np.array(frame.position)
    if not np.abs(position).max() < MAX_NUMBER:
        raise Unsuitable("the origin of a joint is implausibly far away")
    return pin.SE3(np.array(frame.rotation), position)
