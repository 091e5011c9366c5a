"""Summary of a robot in one configuration.

Only meshes need large libraries; if these are missing, the properties of meshes are omitted, with
a note.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform
from urdfkit.lint.context import Context
from urdfkit.robot.bounding_box import extent_of, without_meshes
from urdfkit.robot.composite_body import CompositeBody, composite_body
from urdfkit.robot.joint_limits import driven
from urdfkit.robot.kinematics import frames
from urdfkit.robot.link import Shape
from urdfkit.robot.model import RobotModel
from urdfkit.robot.reach import Reach, reach
from urdfkit.robot.shapes import BoundingBox
from urdfkit.robot.tree import KinematicTree
from urdfkit.ros.gazebo.sensors import Sensor, sensors

#: Size of each type of joint in Pinocchio's configuration q and velocity v; an angle without
#: limits is stored as cosine and sine, a rotation as a quaternion.
COORDINATES = {
    "revolute": (1, 1),
    "continuous": (2, 1),
    "prismatic": (1, 1),
    "planar": (4, 3),
    "floating": (7, 6),
}


class Structure(Record):
    """Counts of links and joints."""

    links: int  # number of links
    joints: dict[str, int]  # number of joints of each type, in document order
    roots: tuple[str, ...]  # links without a parent
    depth: int  # number of joints on the longest path from a root
    deepest: str  # the link at its end
    free: dict[str, str]  # types of the independent joints, by name
    followers: dict[str, str]  # leaders of mimic joints, by name
    #: nq and nv: size of configuration and velocity with a fixed root; see `COORDINATES`.
    nq: int
    nv: int
    driven: tuple[str, ...]  # joints that a transmission or ros2_control drives


class Weight(Record):
    """The mass of all links."""

    by_link: dict[str, float]  # masses above 0 in kg, the heaviest first
    whole: CompositeBody  # as one rigid body at the configuration


class Shapes(Record):
    """Visuals, collisions and their files."""

    #: visuals and collisions: number of each kind of shape.
    visuals: dict[str, int]
    collisions: dict[str, int]
    files: dict[str, int]  # number of existing mesh files of each format
    size: int  # of these files, in bytes
    missing: tuple[str, ...]  # mesh references without a usable file
    #: Number of triangles of all uses of meshes, by role; None if not counted.
    triangles: dict[str, int] | None
    #: Bounding box of all shapes in the frame of the root; None without shapes.
    box: BoundingBox | None
    measured: int  # number of links with a shape in ``box``
    left_out: dict[str, str]  # reasons for excluded shapes, by link

    @property
    def robot_box(self) -> BoundingBox | None:
        """The bounding box of the robot; None if it lacks the shapes of most links."""
        return self.box if len(self.left_out) <= self.measured else None


class Overview(Record):
    """Summary of a robot."""

    name: str  # of the robot
    file: str  # path as passed
    is_xacro: bool  # True unless it is plain URDF
    targets: tuple[str, ...]  # target programs, and the evidence
    evidence: tuple[str, ...]
    #: structure, weight, shapes: see there.
    structure: Structure
    weight: Weight
    shapes: Shapes
    reach: Reach | None  # of the longest chain; None without moving joints
    sensors: tuple[Sensor, ...]  # in ``<gazebo>`` tags
    plugins: tuple[tuple[str, str], ...]  # file and name of each Gazebo plugin
    pose: dict[str, float]  # positions of joints, as passed
    skipped: tuple[str, ...]  # missing properties, with the reason


def summarise(context: Context, pose: Mapping[str, float] | None = None) -> Overview:
    """Summarise a robot.

    >>> from urdfkit.lint.loading import read
    >>> arm = summarise(read("models/good/two_link_arm/urdf/two_link_arm.urdf"))
    >>> round(arm.weight.whole.mass, 9), list(arm.structure.free)
    (5.2, ['shoulder', 'elbow'])

    Args:
        context: the robot.
        pose: positions of joints in rad or m; the others are at 0.
    """
    model, positions = context.model, dict(pose or {})
    placed = frames(context.tree, positions)
    shapes, skipped = _shapes(context, placed)
    return Overview(
        model.name,
        context.source.path,
        context.reading.xacro is not None,
        context.targets.names,
        context.targets.evidence,
        structure(context.tree),
        Weight(_masses(model), composite_body(context.tree, placed)),
        shapes,
        reach(context.tree),
        tuple(sensors(model)),
        tuple((use.filename, use.name) for use in context.plugins),
        positions,
        skipped,
    )


def structure(tree: KinematicTree) -> Structure:
    """Links, joints and degrees of freedom."""
    model = tree.model
    free = {
        joint.name: joint.kind
        for joint in model.joints
        if joint.kind in COORDINATES and not joint.mimic
    }
    sizes = [COORDINATES[kind] for kind in free.values()]
    depths = _depths(tree)
    deepest = max(depths, key=lambda name: depths[name], default="")
    return Structure(
        len(model.links),
        dict(Counter(joint.kind for joint in model.joints)),
        tuple(root.name for root in tree.roots),
        depths.get(deepest, 0),
        deepest,
        free,
        {joint.name: joint.leader for joint in model.joints if joint.leader},
        sum(nq for nq, _ in sizes),
        sum(nv for _, nv in sizes),
        tuple(sorted(driven(model) & model.joints_by_name.keys())),
    )


def _depths(tree: KinematicTree) -> dict[str, int]:
    """Joints between each link and its root."""
    depths = {root.name: 0 for root in tree.roots}
    queue = list(depths)
    for name in queue:  # extended in the loop
        for joint in tree.children[name]:
            if joint.child_name not in depths:
                depths[joint.child_name] = depths[name] + 1
                queue.append(joint.child_name)
    return depths


def _masses(model: RobotModel) -> dict[str, float]:
    """Masses of the links in kg, without zeros, the heaviest first."""
    masses = {link.name: link.mass for link in model.links if link.mass}
    return dict(sorted(masses.items(), key=lambda item: -item[1]))


def _shapes(context: Context, placed: Mapping[str, Transform]) -> tuple[Shapes, tuple[str, ...]]:
    model = context.model
    found = {mesh.located.path: mesh.facts for mesh in context.files.meshes if mesh.located.path}
    usable = [facts for facts in found.values() if facts and not facts.defect]
    missing = [
        mesh.at.value
        for mesh in context.files.meshes
        if mesh.facts is None or mesh.facts.defect is not None
    ]
    skipped: tuple[str, ...] = ()
    bodies = {"visual": model.visuals, "collision": model.collisions}
    try:
        triangles: dict[str, int] | None = {
            role: sum(_count(context, body.shape) for body in some if body.shape)
            for role, some in bodies.items()
        }
    except ImportError:
        triangles, skipped = None, (f"triangles: {without_meshes()}",)
    kinds = {
        role: dict(Counter(body.shape.kind for body in some if body.shape))
        for role, some in bodies.items()
    }
    extent = extent_of(context, placed)
    return Shapes(
        kinds["visual"],
        kinds["collision"],
        dict(Counter(facts.format for facts in usable)),
        sum(facts.size for facts in usable),
        tuple(dict.fromkeys(missing)),
        triangles,
        extent.box,
        extent.measured,
        extent.left_out,
    ), skipped


def _count(context: Context, shape: Shape) -> int:
    mesh = context.meshes.mesh(shape) if shape.filename else None
    return sum(len(part.faces) for part in mesh.parts) if mesh else 0
