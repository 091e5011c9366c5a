"""A robot in Pinocchio, built from our model, not from the text.

The root has a free-flyer joint, so that its mass counts: a Pinocchio model with a fixed base merges
it into the world. Every joint that moves is a joint of its own there, those with ``<mimic>``
included; what follows what is a constant matrix, so that leaders and followers may stand in any
order and on any branch. Results are for the joints that can be set, the root fixed.

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
from urdfkit.robot.kinematics import direction, laws
from urdfkit.robot.model import Joint, Link, Tensor
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.robot.tree import KinematicTree

#: Pinocchio's memory grows with the cube of the joints in a row: 150 take 300 MB, 600 take 15 GB.
MAX_JOINTS = 150

#: Numbers beyond this are no robot's, and their products leave the range of floating point.
LARGEST = 1e30


class Unsuitable(UrdfkitError):
    """A robot, or a question about it, that Pinocchio cannot be asked; the text says why."""


class Dynamics:
    """Kinematics and dynamics of a robot.

    Attributes:
        tree: of its model.
        model: Pinocchio's, with a free-flyer and every follower a joint of its own.
        columns: the coordinates, in the order of all vectors and matrices here: the name of each
            joint that can be set, or ``name[0]``, ``name[1]`` ... where it has several. These are
            of a planar joint two ways across its axis (x and y, where the axis is z) and the angle
            about it, of a floating one the linear and then the angular velocity of its child.
        payload: masses in kg that links carry at their origin, besides their own.

    Raises:
        Unsuitable: it is no single tree, has too many joints, or numbers that no robot has.
    """

    def __init__(self, tree: KinematicTree, payload: Mapping[str, float] | None = None) -> None:
        if not tree.is_sound:
            raise Unsuitable(tree.unsound)
        self.tree = tree
        self.payload = dict(payload or {})
        self._joints = [joint for joint in _downwards(tree) if joint.kind in _KINDS]
        if len(self._joints) > MAX_JOINTS:
            count = len(self._joints)
            raise Unsuitable(f"{count} joints move; Pinocchio has memory for {MAX_JOINTS}")
        for link, mass in self.payload.items():
            tree.model.require_link(link)
            if not abs(mass) < LARGEST:
                raise Unsuitable(f"no robot carries {mass:g} kg")
        self.model, self._numbers, self._frames = _build(tree, self.payload)
        self._laws = laws(tree.model.joints_by_name)
        self._columns = dict(_columns(self._joints))
        self.columns = tuple(
            name for joint in self._joints if not joint.mimic for name in self._columns[joint.name]
        )

    @property
    def nq(self) -> int:
        """Numbers of a configuration, followers not counted and the root fixed."""
        return sum(_KINDS[joint.kind].nq for joint in self._joints if not joint.mimic)

    @property
    def nv(self) -> int:
        """Numbers of a velocity: the degrees of freedom."""
        return len(self.columns)

    @cached_property
    def data(self) -> pin.Data:
        """What Pinocchio computes with; made when it is first asked for, since it is large."""
        return self.model.createData()

    @cached_property
    def selection(self) -> Floats:
        """Velocities of all joints of the model from those of ``columns``, (6 + n, nv)."""
        found = np.zeros((self.model.nv, self.nv))
        for joint in self._joints:
            start = self._joint(joint.name).idx_v
            if joint.mimic is None:
                for offset, name in enumerate(self._columns[joint.name]):
                    found[start + offset, self.columns.index(name)] = 1.0
                continue
            leader, factor, _ = self._laws[joint.name]
            if leader in self.columns and _KINDS[joint.kind].nv == 1:
                found[start, self.columns.index(leader)] = factor
        return found

    def configuration(self, pose: Mapping[str, float]) -> Floats:
        """Pinocchio's vector q of a pose; what follows, follows.

        Args:
            pose: positions of joints in rad or m; the others, and joints of several coordinates,
                are at 0.
        """
        x = np.array([pose.get(name, 0.0) for name in self.columns])
        q: Floats = pin.integrate(
            self.model, pin.neutral(self.model), self.selection @ x + self._shifts
        )
        return q

    @cached_property
    def _shifts(self) -> Floats:
        """Where the joints are with all leaders at zero, (6 + n,)."""
        found = np.zeros(self.model.nv)
        for joint in self._joints:
            if _KINDS[joint.kind].nv == 1:
                found[self._joint(joint.name).idx_v] = self._laws[joint.name].shift
        return found

    def mass_properties(self, pose: Mapping[str, float] | None = None) -> MassProperties:
        """Mass, centre and tensor of the whole robot in the frame of its root; 0 if massless."""
        q = self.configuration(pose or {})
        pin.ccrba(self.model, self.data, q, np.zeros(self.model.nv))
        whole = self.data.Ig
        if not whole.mass:  # Pinocchio divides by it
            return combined(())
        center: Floats = pin.centerOfMass(self.model, self.data, q)
        xx, xy, yy, xz, yz, zz = map(float, _lower(whole.inertia))
        x, y, z = map(float, center)
        return MassProperties(float(whole.mass), (x, y, z), Tensor(xx, xy, xz, yy, yz, zz))

    def placement(self, link: str, pose: Mapping[str, float]) -> Floats:
        """Where a link is in the frame of the root, as a homogeneous matrix, (4, 4)."""
        number = self._frames[self.tree.model.require_link(link).name]
        pin.framesForwardKinematics(self.model, self.data, self.configuration(pose))
        matrix: Floats = self.data.oMf[number].homogeneous
        return matrix

    def placements(self, pose: Mapping[str, float]) -> dict[str, Floats]:
        """Where each link is in the frame of the root, as homogeneous matrices, (4, 4)."""
        pin.framesForwardKinematics(self.model, self.data, self.configuration(pose))
        return {name: self.data.oMf[number].homogeneous for name, number in self._frames.items()}

    def jacobian(self, link: str, pose: Mapping[str, float]) -> Floats:
        """How the origin of a link moves with the coordinates, (6, nv).

        Three rows of linear velocity, then three of angular velocity, along the axes of the root.
        """
        number = self._frames[self.tree.model.require_link(link).name]
        q = self.configuration(pose)
        whole = pin.computeFrameJacobian(
            self.model, self.data, q, number, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        )
        found: Floats = whole @ self.selection
        return found

    def mass_matrix(self, pose: Mapping[str, float]) -> Floats:
        """The joint-space mass matrix, the root fixed, (nv, nv), in kg, kg m or kg·m²."""
        upper = np.triu(pin.crba(self.model, self.data, self.configuration(pose)))
        # With negative masses Pinocchio divides by nearly nothing.
        with np.errstate(over="ignore", invalid="ignore"):
            whole = upper + np.triu(upper, 1).T
            found: Floats = self.selection.T @ whole @ self.selection
        return found

    def gravity(self, pose: Mapping[str, float]) -> Floats:
        """What each coordinate must bear to hold the robot still, (nv,), in N·m or N."""
        q = self.configuration(pose)
        found: Floats = self.selection.T @ pin.computeGeneralizedGravity(self.model, self.data, q)
        return found

    def _joint(self, name: str) -> pin.JointModel:
        return self.model.joints[self._numbers[name]]


def _downwards(tree: KinematicTree) -> list[Joint]:
    """The joints depth first: Pinocchio takes the joints of a subtree for one run of numbers."""
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


def _lower(tensor: Floats) -> Sequence[float]:
    return tensor[0, 0], tensor[1, 0], tensor[1, 1], tensor[2, 0], tensor[2, 1], tensor[2, 2]


#: What Pinocchio makes of each type of joint.
_KINDS = {
    "revolute": pin.JointModelRX(),
    "continuous": pin.JointModelRUBX(),
    "prismatic": pin.JointModelPX(),
    "planar": pin.JointModelPlanar(),
    "floating": pin.JointModelFreeFlyer(),
}


def _joint_model(joint: Joint) -> tuple[pin.JointModel, Transform]:
    """Pinocchio's joint, and the frame in which it has its axis.

    The unbounded one takes no axis from Python, and the planar one has none: Pinocchio's own
    reader of URDF moves it across z, whatever its axis. Both have the z of a frame of their own.
    """
    axis = direction(joint)
    if joint.kind == "revolute":
        return pin.JointModelRevoluteUnaligned(np.array(axis)), Transform()
    if joint.kind == "prismatic":
        return pin.JointModelPrismaticUnaligned(np.array(axis)), Transform()
    if joint.kind == "continuous":
        return pin.JointModelRUBZ(), Transform(_with_z(axis))
    if joint.kind == "planar":
        return pin.JointModelPlanar(), Transform(_with_z(axis))
    return _KINDS[joint.kind], Transform()


def _with_z(axis: Vector) -> Rotation:
    """A rotation that takes z to a unit vector: the least one if that points up, as z itself."""
    x, y, z = axis
    if z < 0:
        (a, b, c), (d, e, f), (g, h, i) = _with_z((-x, -y, -z))
        return (a, -b, -c), (d, -e, -f), (g, -h, -i)
    k = 1 / (1 + z)  # Rodrigues' formula, with the sine and cosine of the angle in the axis
    return (1 - k * x * x, -k * x * y, x), (-k * x * y, 1 - k * y * y, y), (-x, -y, z)


def _build(
    tree: KinematicTree, payload: Mapping[str, float]
) -> tuple[pin.Model, dict[str, int], dict[str, int]]:
    """Pinocchio's model, and its numbers of our joints and links.

    Each link is a frame with its own inertia. Names do not lead back: a robot may have a link or
    a joint of the same name as one that every model of Pinocchio has.
    """
    model = pin.Model()
    base = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "root_joint")
    joints: dict[str, int] = {}
    at = {tree.roots[0].name: (base, Transform())}
    for joint in _downwards(tree):
        above, frame = at[joint.parent_name]
        frame = frame @ joint.origin
        if joint.kind in _KINDS:
            kind, turned = _joint_model(joint)
            above = model.addJoint(above, kind, _se3(frame @ turned), joint.name)
            frame = Transform(transposed(turned.rotation))
            joints[joint.name] = above
        at[joint.child_name] = above, frame
    links: dict[str, int] = {}
    for name, (number, frame) in at.items():
        inertia = _inertia(tree.model.links_by_name[name])
        body = pin.Frame(name, number, _se3(frame), pin.FrameType.BODY, inertia)
        links[name] = model.addFrame(body)
        if name in payload:
            point = pin.Inertia(payload[name], np.zeros(3), np.zeros((3, 3)))
            model.appendBodyToJoint(number, point, _se3(frame))
    return model, joints, links


def _inertia(link: Link) -> pin.Inertia:
    """Pinocchio's inertia of a link, in the frame of the link."""
    mass, center, moments = properties_of(link, Transform())
    tensor = np.array(moments.rows)
    if not max(abs(mass), np.abs(center).max(), np.abs(tensor).max()) < LARGEST:
        raise Unsuitable(f"link '{link.name}' has a mass, place or inertia beyond all robots")
    inertia = pin.Inertia.Zero()  # whose constructor rejects what Pinocchio's own parser accepts
    inertia.mass, inertia.lever, inertia.inertia = mass, np.array(center), tensor
    return inertia


def _se3(frame: Transform) -> pin.SE3:
    position = np.array(frame.position)
    if not np.abs(position).max() < LARGEST:
        raise Unsuitable("a joint is farther away than any robot is large")
    return pin.SE3(np.array(frame.rotation), position)
