"""Tip-over stability: the centre of mass of a robot above its support polygon.

The ground is a plane normal to z of the root, through the lowest point of the robot. Lengths in m.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector, rotate
from urdfkit.robot import Robot
from urdfkit.robot.contact_points import lowest_points, touching_points
from urdfkit.robot.joint_limits import BOUNDED
from urdfkit.robot.kinematics import direction, frames
from urdfkit.robot.link import Shape
from urdfkit.robot.model import RobotModel
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.rotors import is_carried_by_rotors
from urdfkit.robot.support_polygon import Point, hull, weakest_edge, width
from urdfkit.robot.tree import KinematicTree

#: In m: contacts that are narrower are on a line, apart from rounding.
MIN_WIDTH = 1e-3
#: A joint whose axis rises less, per m, slides along the ground.
_MAX_SLOPE = 0.1

#: Descriptions of the verdicts, by their machine-readable names.
VERDICTS = {
    "fixed": "fixed to the world: cannot tip over",
    "stands": "stands",
    "tips": "tips over",
    "tips-unless-bolted": "tips over unless fixed to the ground",
    "carried": "carried by rotors or thrusters: does not stand on the ground",
    "no-area": "the ground contacts span no area",
    "no-contact": "no collision geometry in contact with the ground",
    "no-mass": "no mass",
    "unknown": "not known: collision meshes that may touch the ground cannot be read",
}


class Stability(Record):
    """Stability of a robot on the ground."""

    links: tuple[str, ...]  # in contact with the ground, in the order of the model
    #: The support polygon: convex hull of all contacts seen from above, counter-clockwise.
    polygon: tuple[Point, ...]
    center: Vector  # centre of mass in the frame of the root
    ground: float  # height of the ground in the frame of the root
    #: Distance of the centre of mass from the nearest edge, seen from above; negative outside.
    margin: float
    #: Slope of the ground in rad at which it tips over the weakest edge; negative if it tips over
    #: on level ground.
    angle: float
    direction: Point  # horizontal unit vector, outwards across the weakest edge

    @property
    def tips(self) -> bool:
        """True if it tips over on level ground."""
        return self.margin < 0

    @property
    def tip_direction(self) -> str:
        """The direction of tipping over, such as ``forwards (+x)`` or ``to its left (+y)``."""
        x, y = self.direction
        if abs(x) >= abs(y):
            return "forwards (+x)" if x > 0 else "backwards (-x)"
        return "to its left (+y)" if y > 0 else "to its right (-y)"


class StandingVerdict(Record):
    """The verdict on a robot on the ground, for ``urdfkit statics`` and the report."""

    verdict: str  # one of ``VERDICTS``
    links: tuple[str, ...] = ()  # in contact with the ground, in the order of the model
    stability: Stability | None = None  # None unless it stands or tips over
    #: Links whose visual touches the ground and that have no collision.
    visual_only: tuple[str, ...] = ()
    visuals: bool = False  # True if ``visual_only`` links count as contacts
    #: Links with a collision mesh that is missing or cannot be read; it may reach lower.
    unread: tuple[str, ...] = ()

    def facts(self) -> dict[str, object]:
        """The result for JSON; lengths in m, angles in rad, None for values without a result."""
        numbers = dict.fromkeys(Stability._fields) if self.stability is None else {}
        return {
            "verdict": self.verdict,
            "tips": self.verdict.startswith("tips"),
            **numbers,
            **(self.stability._asdict() if self.stability else {}),
            "links": self.links,
            "visual_only": self.visual_only,
            "visuals": self.visuals,
            "unread": self.unread,
        }


def standing_verdict(
    robot: Robot,
    pose: Mapping[str, float] | None = None,
    contacts: Collection[str] | None = None,
    *,
    payload: Mapping[str, float] | None = None,
    visuals: bool = False,
) -> StandingVerdict:
    """The verdict on a robot at a pose; only primitives count if the mesh libraries are missing.

    Args:
        pose: positions of joints in rad or m; the others are at 0.
        contacts: names of the links it stands on; those that reach the lowest point if None.
        payload: masses in kg that links carry at their origin.
        visuals: a link without collision stands on its visual.
    """
    tree = robot.tree
    root = rigid_bodies(tree)[0]
    leaving = (joint for name in root.names for joint in tree.children[name])
    if root.is_ground and not any(joint.kind == "floating" for joint in leaving):
        return StandingVerdict("fixed")
    placed = frames(tree, pose or {})
    try:
        lowest = lowest_points(robot, placed, contacts, visuals=True, meshes=True)
        unread = _unread(robot, lowest)
    except ImportError:
        lowest = lowest_points(robot, placed, contacts, visuals=True, meshes=False)
        unread = ()
    if unread:
        return StandingVerdict("unknown", unread=unread)
    by_name = tree.model.links_by_name
    with_visuals = touching = touching_points(lowest)
    if not visuals:
        solid = {name: points for name, points in lowest.items() if by_name[name].collisions}
        touching = touching_points(solid)
    visual_only = tuple(name for name in with_visuals if not by_name[name].collisions)
    loads = _loads(robot, placed, payload or {})
    result = _stability(loads, touching)
    if result is not None:
        bolted = "-unless-bolted" if set(root.names).issuperset(touching) else ""
        verdict = f"tips{bolted}" if result.tips else "stands"
        if result.tips and contacts is None and is_carried_by_rotors(tree.model):
            return StandingVerdict("carried", visuals=visuals)
    elif not touching:
        verdict = "no-contact"
    else:
        verdict = "no-area" if sum(mass for mass, _ in loads) > 0 else "no-mass"
    return StandingVerdict(verdict, tuple(touching), result, visual_only, visuals)


def _unread(robot: Robot, names: Collection[str]) -> tuple[str, ...]:
    """The links among these with a collision mesh that is missing or cannot be read."""
    by_name = robot.model.links_by_name
    return tuple(
        name
        for name in names
        if any(
            body.shape and body.file and robot.meshes.mesh(body.shape) is None
            for body in by_name[name].collisions
        )
    )


def stand(
    robot: Robot,
    contacts: Collection[str] | None = None,
    *,
    meshes: bool = True,
    visuals: bool = False,
) -> Stability | None:
    """The stability of a robot with all joints at 0.

    Args:
        robot: the robot.
        contacts: names of the links it stands on; those that reach the lowest point if None.
        meshes: include meshes, which requires numpy and the mesh readers.
        visuals: a link without collision stands on its visual.

    Returns:
        None without a mass, or if the contacts span no area: a balancing robot.

    Raises:
        ImportError: ``meshes`` is set and the libraries are not installed.
    """
    placed = frames(robot.tree, {})
    lowest = lowest_points(robot, placed, contacts, visuals=visuals, meshes=meshes)
    return _stability(_loads(robot, placed, {}), touching_points(lowest))


def lowest_links(robot: Robot) -> tuple[str, ...]:
    """The links whose collisions touch the ground, with all joints at 0.

    Raises:
        ImportError: the robot has meshes and the libraries are not installed.
    """
    placed = frames(robot.tree, {})
    return tuple(touching_points(lowest_points(robot, placed, None, visuals=False, meshes=True)))


def _loads(
    robot: Robot, placed: Mapping[str, Transform], payload: Mapping[str, float]
) -> list[tuple[float, Vector]]:
    """The masses of links and payload, with their positions."""
    loads = [(mass, placed[name].position) for name, mass in payload.items()]
    for name, frame in placed.items():
        link = robot.model.links_by_name[name]
        if link.inertial:
            loads.append((link.mass, frame.apply(link.inertial.origin.position)))
    return loads


def _stability(
    loads: list[tuple[float, Vector]], touching: Mapping[str, list[Vector]]
) -> Stability | None:
    """The stability of masses on the contact points of links."""
    mass = sum(load for load, _ in loads)
    polygon = hull((x, y) for points in touching.values() for x, y, _ in points)
    if mass <= 0 or len(polygon) < 3 or width(polygon) < MIN_WIDTH:
        return None
    ground = min(z for points in touching.values() for _, _, z in points)
    x, y, z = (sum(load * place[axis] for load, place in loads) / mass for axis in range(3))
    margin, angle, direction = weakest_edge(polygon, (x, y), z - ground)
    return Stability(tuple(touching), polygon, (x, y, z), ground, margin, angle, direction)


def collision_meshes(model: RobotModel) -> list[Shape]:
    """The meshes of collisions, which may touch the ground."""
    return [body.shape for body in model.collisions if body.shape and body.file]


def is_freestanding(tree: KinematicTree, links: Collection[str]) -> bool:
    """True for a robot on wheels or casters; False if its base alone, legs or fingers touch it.

    Args:
        links: in contact with the ground.
    """
    root = rigid_bodies(tree)[0]
    return (
        not root.is_ground
        and not set(root.names).issuperset(links)
        and not any(_is_leg(tree, name) or _is_finger(tree, name) for name in links)
    )


def _is_leg(tree: KinematicTree, link: str) -> bool:
    """True for the end of a leg; a wheel may have a joint for steering and one for suspension."""
    return sum(joint.kind in BOUNDED for joint in tree.path(link)) > 2


def _is_finger(tree: KinematicTree, link: str) -> bool:
    """True for a link that slides along the ground, as the fingers of a gripper do."""
    path = tree.path(link)
    if not path or path[-1].kind != "prismatic":
        return False
    return abs(rotate(tree.frames[link].rotation, direction(path[-1]))[2]) < _MAX_SLOPE
