"""The points of a robot that touch the ground.

The ground is a plane normal to z of the root, through the lowest point of the robot. Lengths in m.
"""

from collections.abc import Collection, Mapping
from itertools import product
from math import cos, hypot, pi, sin

from urdfkit.core.spatial import Transform, Vector
from urdfkit.robot import Robot
from urdfkit.robot.link import Body, Shape
from urdfkit.robot.shapes import primitive

#: Points this near to the lowest point touch the ground: wheels and casters of real models differ
#: by millimetres. A part of the size of the robot, and at least `MIN_TOLERANCE` m.
TOLERANCE, MIN_TOLERANCE = 0.02, 0.003

#: Sine of the angle up to which a cylinder is upright: it stands on its end, not on a line.
UPRIGHT = 0.1

#: Points of the unit circle.
_CIRCLE = tuple((cos(pi * number / 16), sin(pi * number / 16)) for number in range(32))


def lowest_points(
    robot: Robot,
    placed: Mapping[str, Transform],
    contacts: Collection[str] | None,
    *,
    visuals: bool,
    meshes: bool,
) -> dict[str, list[Vector]]:
    """The lowest points of each link, in the frame of the root."""
    lowest: dict[str, list[Vector]] = {}
    for name, link in robot.model.links_by_name.items():
        if name in placed and (contacts is None or name in contacts):
            bodies = link.collisions or (link.visuals if visuals else ())
            lowest[name] = [
                point for body in bodies for point in _lowest(robot, body, placed[name], meshes)
            ]
    return lowest


def touching_points(lowest: Mapping[str, list[Vector]]) -> dict[str, list[Vector]]:
    """The contact points of each link with the ground, of its lowest points."""
    points = [point for group in lowest.values() for point in group]
    if not points:
        return {}
    size = max(max(values) - min(values) for values in zip(*points, strict=True))
    limit = min(z for _, _, z in points) + max(MIN_TOLERANCE, TOLERANCE * size)
    touching = {name: [p for p in group if p[2] <= limit] for name, group in lowest.items()}
    return {name: group for name, group in touching.items() if group}


def _lowest(robot: Robot, body: Body, link: Transform, meshes: bool) -> list[Vector]:
    """The points of a shape that may touch the ground, from the frame of its link."""
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
    _, _, (gx, gy, _) = at.rotation  # slope of the x and y axes of the cylinder
    steep = hypot(gx, gy)
    rim = _CIRCLE
    if steep > UPRIGHT:  # it lies: the neighbours of its lowest line are only near to the ground
        rim = ((-gx / steep, -gy / steep),)
    return [at.apply((part.radius * x, part.radius * y, z)) for x, y in rim for z in ends]


def _of_mesh(robot: Robot, shape: Shape, at: Transform) -> list[Vector]:
    """The lowest vertices of a mesh."""
    vertices = robot.meshes.vertices(shape)
    if vertices is None or not len(vertices):
        return []
    heights = vertices @ at.rotation[2]
    low, high = float(heights.min()), float(heights.max())
    chosen = vertices[heights <= low + max(MIN_TOLERANCE, TOLERANCE * (high - low))]
    return [at.apply((float(x), float(y), float(z))) for x, y, z in chosen]
