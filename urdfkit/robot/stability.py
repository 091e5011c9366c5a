"""Whether a robot that stands on the ground tips over: its centre of mass above what it stands on.

The ground is a plane across z of the root, through the lowest point of the robot. Lengths in m.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from itertools import product
from math import atan2, cos, hypot, pi, sin

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector
from urdfkit.robot import Robot
from urdfkit.robot.joints import BOUNDED
from urdfkit.robot.kinematics import frames
from urdfkit.robot.model import Body, Shape
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.shapes import primitive
from urdfkit.robot.tree import KinematicTree

Point = tuple[float, float]

#: What is this near to the lowest point stands on the ground: wheels and casters of real models
#: differ by millimetres, by which it tilts a little. A part of its size, and at least so many m.
TOLERANCE, LEAST = 0.02, 0.003

#: Corners that stand for a circle.
_CIRCLE = tuple((cos(pi * number / 16), sin(pi * number / 16)) for number in range(32))

#: What can be said of a robot on the ground, by the word for programs.
VERDICTS = {
    "fixed": "fixed to the world: cannot tip over",
    "stands": "stands",
    "tips": "tips over",
    "tips-unless-bolted": "tips over unless fixed to the ground",
    "no-area": "the ground contacts span no area",
    "no-contact": "no collision geometry in contact with the ground",
    "no-mass": "no mass",
}


class Stability(Record):
    """How a robot stands."""

    links: tuple[str, ...]  # that touch the ground, in the order of the model
    #: Corners of the convex hull of all contacts seen from above, counter-clockwise.
    polygon: tuple[Point, ...]
    center: Vector  # of mass, in the frame of the root
    ground: float  # height of the ground in that frame
    #: Distance of the centre of mass from the nearest edge, seen from above; negative outside.
    margin: float
    #: How far the ground may slope before it tips over that edge which gives way first, in rad;
    #: negative where it falls on level ground.
    angle: float
    direction: Point  # horizontal unit vector, outwards across that edge

    @property
    def tips(self) -> bool:
        """True if it falls on level ground."""
        return self.margin < 0

    @property
    def way(self) -> str:
        """Where it tips: ``forwards (+x)``, ``to its left (+y)`` and so on."""
        x, y = self.direction
        if abs(x) >= abs(y):
            return "forwards (+x)" if x > 0 else "backwards (-x)"
        return "to its left (+y)" if y > 0 else "to its right (-y)"


class Standing(Record):
    """Whether a robot stands on the ground: what ``urdfkit statics`` and the report print."""

    verdict: str  # one of ``VERDICTS``
    links: tuple[str, ...] = ()  # that touch the ground, in the order of the model
    stability: Stability | None = None  # how safely; None unless it stands or tips over
    #: Links that reach the ground with a visual, and have no collision.
    visual_only: tuple[str, ...] = ()
    visuals: bool = False  # True if these count as contacts

    def facts(self) -> dict[str, object]:
        """The result for JSON; lengths in m, angles in rad, None where the verdict has none."""
        numbers = dict.fromkeys(Stability._fields) if self.stability is None else {}
        return {
            "verdict": self.verdict,
            "tips": self.verdict.startswith("tips"),
            **numbers,
            **(self.stability._asdict() if self.stability else {}),
            "links": self.links,
            "visual_only": self.visual_only,
            "visuals": self.visuals,
        }


def standing(
    robot: Robot,
    pose: Mapping[str, float] | None = None,
    contacts: Collection[str] | None = None,
    *,
    payload: Mapping[str, float] | None = None,
    visuals: bool = False,
) -> Standing:
    """The verdict on a robot at a pose; without the mesh libraries, by its primitives alone.

    Args:
        pose: positions of joints in rad or m; the others are at 0.
        contacts: names of the links it stands on; those that reach the lowest point if None.
        payload: masses in kg that links carry at their origin.
        visuals: a link without collision stands on its visual.
    """
    tree = robot.tree
    root = rigid_bodies(tree)[0]
    if root.is_ground:
        return Standing("fixed")
    placed = frames(tree, pose or {})
    meshes = True
    try:
        seen = _touching(robot, placed, contacts, visuals=True, meshes=True)
    except ImportError:
        meshes = False
        seen = _touching(robot, placed, contacts, visuals=True, meshes=False)
    touching = _touching(robot, placed, contacts, visuals=visuals, meshes=meshes)
    by_name = tree.model.links_by_name
    visual_only = tuple(name for name in seen if not by_name[name].collisions)
    loads = _loads(robot, placed, payload or {})
    found = _stability(loads, touching)
    if found is not None:
        fixed = {link.name for link, _ in root.links}
        bolted = "-unless-bolted" if fixed.issuperset(touching) else ""
        verdict = f"tips{bolted}" if found.tips else "stands"
    elif not touching:
        verdict = "no-contact"
    else:
        verdict = "no-area" if sum(mass for mass, _ in loads) > 0 else "no-mass"
    return Standing(verdict, tuple(touching), found, visual_only, visuals)


def stand(
    robot: Robot,
    pose: Mapping[str, float] | None = None,
    contacts: Collection[str] | None = None,
    *,
    payload: Mapping[str, float] | None = None,
    meshes: bool = True,
    visuals: bool = False,
) -> Stability | None:
    """How a robot stands at a pose.

    Args:
        robot: the robot.
        pose: positions of joints in rad or m; the others are at 0.
        contacts: names of the links it stands on; those that reach the lowest point if None.
        payload: masses in kg that links carry at their origin.
        meshes: take meshes into account, which needs numpy and the readers of meshes.
        visuals: a link without collision stands on its visual.

    Returns:
        None without a mass, and where the contacts make no area: a robot that balances.

    Raises:
        ImportError: meshes are to be read, and the libraries are not installed.
    """
    placed = frames(robot.tree, pose or {})
    touching = _touching(robot, placed, contacts, visuals=visuals, meshes=meshes)
    return _stability(_loads(robot, placed, payload or {}), touching)


def lowest_links(robot: Robot) -> tuple[str, ...]:
    """The links whose collisions reach the lowest point of a robot with all joints at 0.

    Raises:
        ImportError: meshes are to be read, and the libraries are not installed.
    """
    return tuple(_touching(robot, frames(robot.tree, {}), None, visuals=False, meshes=True))


def _loads(
    robot: Robot, placed: Mapping[str, Transform], payload: Mapping[str, float]
) -> list[tuple[float, Vector]]:
    """The masses of links and payload, and where they are."""
    loads = [(mass, placed[name].position) for name, mass in payload.items()]
    for name, frame in placed.items():
        link = robot.model.links_by_name[name]
        if link.inertial:
            loads.append((link.mass, frame.apply(link.inertial.origin.position)))
    return loads


def _stability(
    loads: list[tuple[float, Vector]], touching: Mapping[str, list[Vector]]
) -> Stability | None:
    """How loads stand on points of links."""
    mass = sum(load for load, _ in loads)
    polygon = hull((x, y) for found in touching.values() for x, y, _ in found)
    if mass <= 0 or len(polygon) < 3:
        return None
    ground = min(z for found in touching.values() for _, _, z in found)
    x, y, z = (sum(load * place[axis] for load, place in loads) / mass for axis in range(3))
    margin, angle, direction = _edges(polygon, (x, y), z - ground)
    return Stability(tuple(touching), polygon, (x, y, z), ground, margin, angle, direction)


def is_freestanding(tree: KinematicTree, links: Collection[str]) -> bool:
    """True for what stands by itself: not on its base alone, which is bolted down, nor on legs.

    Args:
        links: that touch the ground.
    """
    root = rigid_bodies(tree)[0]
    fixed = {link.name for link, _ in root.links}
    return (
        not root.is_ground
        and not fixed.issuperset(links)
        and not any(_is_leg(tree, name) for name in links)
    )


def _is_leg(tree: KinematicTree, link: str) -> bool:
    """True for the end of a leg; a wheel may be steered and sprung, and then turn."""
    return sum(joint.kind in BOUNDED for joint in tree.path(link)) > 2


def _edges(polygon: tuple[Point, ...], over: Point, height: float) -> tuple[float, float, Point]:
    """The margin, the smallest angle at which it tips, and the way there."""
    found: list[tuple[float, Point]] = []
    for (ax, ay), (bx, by) in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
        size = hypot(bx - ax, by - ay)
        outwards = ((by - ay) / size, (ax - bx) / size)
        inside = (ax - over[0]) * outwards[0] + (ay - over[1]) * outwards[1]
        found.append((inside, outwards))
    margin, direction = min(found)
    # All edges are under the same height, so that the nearest one gives way first.
    return margin, atan2(margin, max(height, 0.0)), direction


def hull(points: Iterable[Point]) -> tuple[Point, ...]:
    """The corners of the convex hull, counter-clockwise; fewer than three make no area.

    Source: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions" (1979).
    """
    every = sorted(set(points))
    if len(every) < 3:
        return tuple(every)
    size = max(every[-1][0] - every[0][0], max(y for _, y in every) - min(y for _, y in every))
    least = 1e-9 * size * size  # a corner that turns by rounding only is none
    lower, upper = _chain(every, least), _chain(every[::-1], least)
    return (*lower[:-1], *upper[:-1])


def _chain(points: list[Point], least: float) -> list[Point]:
    chain: list[Point] = []
    for point in points:
        while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= least:
            chain.pop()
        chain.append(point)
    return chain


def _turn(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _touching(
    robot: Robot,
    placed: Mapping[str, Transform],
    contacts: Collection[str] | None,
    *,
    visuals: bool,
    meshes: bool,
) -> dict[str, list[Vector]]:
    """The points of each link that touch the ground, in the frame of the root."""
    reaching: dict[str, list[Vector]] = {}
    for name, link in robot.model.links_by_name.items():
        if name in placed and (contacts is None or name in contacts):
            bodies = link.collisions or (link.visuals if visuals else ())
            reaching[name] = [
                point for body in bodies for point in _lowest(robot, body, placed[name], meshes)
            ]
    points = [point for found in reaching.values() for point in found]
    if not points:
        return {}
    size = max(max(values) - min(values) for values in zip(*points, strict=True))
    near = min(z for _, _, z in points) + max(LEAST, TOLERANCE * size)
    touching = {name: [p for p in found if p[2] <= near] for name, found in reaching.items()}
    return {name: found for name, found in touching.items() if found}


def _lowest(robot: Robot, body: Body, link: Transform, meshes: bool) -> list[Vector]:
    """What of a shape may touch the ground, given the frame of its link."""
    if body.shape is None:
        return []
    at = link @ body.origin
    if body.shape.filename is not None:
        return _of_mesh(robot, body.shape, at) if meshes else []
    part = primitive(body)
    if part is None:
        return []
    if part.kind == "box":
        x, y, z = (edge / 2 for edge in part.size)
        return [at.apply(corner) for corner in product((-x, x), (-y, y), (-z, z))]
    ends = dict.fromkeys((-part.length / 2, part.length / 2))
    if part.kind != "cylinder":
        balls = (at.apply((0.0, 0.0, z)) for z in ends)
        return [(x, y, z - part.radius) for x, y, z in balls]
    _, _, (gx, gy, _) = at.rotation  # how x and y of the cylinder rise
    steep = hypot(gx, gy) or 1.0
    rim = ((part.radius * x, part.radius * y) for x, y in (*_CIRCLE, (-gx / steep, -gy / steep)))
    return [at.apply((x, y, z)) for x, y in rim for z in ends]


def _of_mesh(robot: Robot, shape: Shape, at: Transform) -> list[Vector]:
    """The lowest vertices of a mesh."""
    vertices = robot.meshes.vertices(shape)
    if vertices is None or not len(vertices):
        return []
    heights = vertices @ at.rotation[2]
    low, high = float(heights.min()), float(heights.max())
    chosen = vertices[heights <= low + max(LEAST, TOLERANCE * (high - low))]
    return [at.apply((float(x), float(y), float(z))) for x, y, z in chosen]
