"""A robot in MuJoCo, ready to be simulated. Lengths in m, angles in rad."""

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any

import mujoco
import numpy as np

from urdfkit.core import temporary
from urdfkit.core.spatial import Transform, rotation, vector
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Floats
from urdfkit.output.bundle.consumers import CONSUMERS
from urdfkit.output.bundle.writing import write_collisions
from urdfkit.output.conversion.mjcf_assembly import assembled, compiled, floats, ignore_warning
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_loads import GRAVITY, STEP
from urdfkit.robot.kinematics import laws
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.moveit.srdf_reader import read_named
from urdfkit.text.document import Element

#: A finer step than `STEP`, in s: a robot that is calm with it shows an integration error.
FINE_STEP = 0.0005
#: Depth in m above which overlapping links push each other away.
OVERLAP = 1e-3

_BAD = (
    mujoco.mjtWarning.mjWARN_BADQPOS,
    mujoco.mjtWarning.mjWARN_BADQVEL,
    mujoco.mjtWarning.mjWARN_BADQACC,
)


class SimulatedRobot:
    """A robot in MuJoCo.

    Raises:
        UrdfkitError: as for `urdfkit.output.conversion.convert`.
    """

    robot: Context  # the original
    srdf: Srdf | None  # pairs of links that it disables do not collide
    model: Any  # MuJoCo's, with a floor under a floating robot
    is_free: bool  # True if the root floats
    leaders: list[Joint]  # joints with one degree of freedom and without <mimic>
    followers: dict[str, str]  # leaders of mimic joints, by joint
    neighbours: set[frozenset[str]]  # pairs of links with a joint between them

    def __init__(self, robot: Context, base: str, srdf: str | None = None) -> None:
        mujoco.set_mju_user_warning(ignore_warning)
        self.robot = robot
        self.srdf = read_named(srdf, robot) if srdf else robot.srdf
        self.is_free = floats(robot, base)
        joints = robot.model.joints_by_name
        couplings = laws(joints)
        #: Laws of the revolute, continuous and prismatic joints.
        self._laws = {name: couplings[name] for name in joints if joints[name].is_single_dof}
        self.leaders = [joints[name] for name, law in self._laws.items() if law.leader == name]
        self.followers = {
            name: law.leader for name, law in self._laws.items() if law.leader not in (name, "")
        }
        self.neighbours = {frozenset(robot.tree.ends(joint) or ()) for joint in robot.model.joints}
        self.model = self._compiled()
        self.model.opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
        self.model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
        self.set_up()

    def _compiled(self) -> Any:
        options = ConversionOptions(visuals=False, srdf=self.srdf)
        with temporary.scratch() as directory:
            files = write_collisions(self.robot, CONSUMERS["mujoco"], directory)
            made = assembled(self.robot, files, directory, options, is_free=self.is_free)
            if not self.is_free:
                return compiled(made, self.robot)
            for joint in self.leaders:
                _add_lock(made, joint)
            self.model = compiled(made, self.robot)
            heights = [float(low[2]) for low, _ in self._boxes(self.started())]
            if heights:
                plane = mujoco.mjtGeom.mjGEOM_PLANE
                made.spec.worldbody.add_geom(type=plane, size=(0, 0, 1), pos=(0, 0, min(heights)))
            return compiled(made, self.robot)

    @property
    def weight(self) -> float:
        """Weight of the robot in N."""
        return float(self.model.body_mass.sum()) * GRAVITY

    def set_up(self, step: float = STEP, *, gravity: bool = True, contacts: bool = True) -> None:
        """Set step, gravity and contacts of all following steps; drives are never simulated."""
        flags = int(mujoco.mjtDisableBit.mjDSBL_ACTUATION)
        flags |= 0 if gravity else int(mujoco.mjtDisableBit.mjDSBL_GRAVITY)
        flags |= 0 if contacts else int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
        self.model.opt.disableflags = flags
        self.model.opt.timestep = step

    def started(self) -> Any:
        """Initial state: joints at zero, or at the end of their range nearest to zero.

        Mimic joints are where their leaders move them.
        """
        data = mujoco.MjData(self.model)
        for index in np.flatnonzero(self.model.jnt_limited):
            at = self.model.jnt_qposadr[index]
            data.qpos[at] = np.clip(data.qpos[at], *self.model.jnt_range[index])
        self.place(data, {joint.name: self.position(data, joint.name) for joint in self.leaders})
        mujoco.mj_forward(self.model, data)
        return data

    def place(self, data: Any, pose: Mapping[str, float]) -> None:
        """Set the positions of joints and of their mimic joints; 0 for other joints."""
        leaders, coordinates, factors, shifts = self._linkage
        with np.errstate(over="ignore", invalid="ignore"):
            values = factors * [pose.get(leader, 0.0) for leader in leaders] + shifts
        data.qpos[coordinates] = np.where(np.isfinite(values), values, 0.0)

    @cached_property
    def _linkage(self) -> tuple[list[str], list[int], Floats, Floats]:
        """Leader, coordinate, factor and shift of each revolute, continuous or prismatic joint."""
        moving = self._laws.values()
        return (
            [law.leader for law in moving],
            [self._coordinates[name] for name in self._laws],
            np.array([law.factor for law in moving]),
            np.array([law.shift for law in moving]),
        )

    def position(self, data: Any, joint: str) -> float:
        """Position of a revolute, continuous or prismatic joint, in rad or m."""
        return float(data.qpos[self._coordinates[joint]])

    @cached_property
    def _coordinates(self) -> dict[str, int]:
        """Index of the position of each MuJoCo joint; cached, as look-ups by name are slow."""
        model = self.model
        return {model.joint(index).name: int(at) for index, at in enumerate(model.jnt_qposadr)}

    def dof(self, joint: str) -> int:
        """Index of velocity and force of a joint."""
        return int(self.model.jnt_dofadr[self.model.joint(joint).id])

    def range(self, joint: str) -> tuple[float, float] | None:
        """Position limits of a joint, in rad or m; None if it has none."""
        index = self.model.joint(joint).id
        if not self.model.jnt_limited[index]:
            return None
        lower, upper = self.model.jnt_range[index]
        return float(lower), float(upper)

    def extent(self) -> float:
        """Diagonal in m of the bounding box of all collisions and link frames at the start."""
        data = self.started()
        corners = [corner for box in self._boxes(data) for corner in box]
        points = np.array([*data.xpos[1:], *corners])
        return float(np.linalg.norm(np.ptp(points, axis=0))) if len(points) else 0.0

    def _boxes(self, data: Any) -> Iterator[tuple[Floats, Floats]]:
        """Lowest and highest coordinates of each collision in the world; without the floor."""
        model = self.model
        for index in np.flatnonzero(model.geom_contype):
            if model.geom_type[index] != mujoco.mjtGeom.mjGEOM_PLANE:
                turn, box = data.geom_xmat[index].reshape(3, 3), model.geom_aabb[index]
                centre, half = data.geom_xpos[index] + turn @ box[:3], np.abs(turn) @ box[3:]
                yield centre - half, centre + half

    def overlaps(self, data: Any) -> dict[tuple[str, str], float]:
        """Depth in m of overlapping pairs of links; the floor is ignored."""
        deepest: dict[tuple[str, str], float] = {}
        for pair, depth in self.contacts(data):
            if depth > OVERLAP and "world" not in pair:
                deepest[pair] = max(depth, deepest.get(pair, 0.0))
        return deepest

    def contacts(self, data: Any) -> Iterator[tuple[tuple[str, str], float]]:
        """Pairs of links in contact, and the depth in m; the floor is a part of the world."""
        for contact in data.contact:
            first, second = sorted(
                self.model.body(self.model.geom_bodyid[geom]).name
                for geom in (contact.geom1, contact.geom2)
            )
            yield (first, second), -float(contact.dist)

    def frames(self, data: Any) -> dict[str, Transform]:
        """Poses of the links in the world."""
        return {
            name: Transform(rotation(data.xmat[index].reshape(3, 3)), vector(data.xpos[index]))
            for name in self.robot.tree.below(self.robot.tree.roots[0].name)
            for index in [self.model.body(name).id]
        }

    def has_mesh(self, *links: str) -> bool:
        """True if one of the links collides with the convex hull of a mesh."""
        return any(
            body.is_mesh
            for link in links
            if (element := self.robot.model.links_by_name.get(link))
            for body in element.collisions
        )

    def collision(self, link: str) -> Element | None:
        """The first collision of a link."""
        element = self.robot.model.links_by_name.get(link)
        return element.collisions[0].at if element and element.collisions else None

    def joint(self, name: str) -> Element | None:
        """The element of a joint."""
        joint = self.robot.model.joints_by_name.get(name)
        return joint.at if joint else None


def diverged(data: Any) -> int | None:
    """Index of a coordinate without a finite or plausible value; None if there is none."""
    for kind in _BAD:
        if data.warning[kind].number:
            return int(data.warning[kind].lastinfo)
    return None


def _add_lock(made: MjcfRobot, joint: Joint) -> None:
    """Add an inactive equality that locks a joint."""
    made.spec.add_equality(
        type=mujoco.mjtEq.mjEQ_JOINT,
        objtype=mujoco.mjtObj.mjOBJ_JOINT,
        name1=joint.name,
        active=False,
    )
