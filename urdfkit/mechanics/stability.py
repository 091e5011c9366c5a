"""Whether a robot that stands on the ground tips over: its centre of mass above what it stands on.

The ground is a plane across z of the root, through the lowest point of the robot. Lengths in m.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from math import atan2, cos, hypot, pi, sin

from urdfkit.mechanics.kinematics import frames
from urdfkit.mechanics.shapes import Primitive, primitive
from urdfkit.model import Body
from urdfkit.record import Record
from urdfkit.spatial import Frame, Vector
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

Point = tuple[float, float]

#: What is this near to the lowest point stands on the ground: wheels and casters of real models
#: differ by millimetres. A part of the robot's height, and at least so many m.
TOLERANCE, LEAST = 0.02, 0.003

#: Corners that stand for a circle.
_CORNERS = 32


class Stability(Record):
    """How a robot stands.

    Attributes:
        links: that touch the ground, in the order of the model.
        polygon: corners of the convex hull of all contacts seen from above, counter-clockwise.
        center: of mass, in the frame of the root.
        ground: height of the ground in that frame.
        margin: distance of the centre of mass from the nearest edge, seen from above; negative
            outside.
        angle: how far the ground may slope before it tips over that edge which gives way first,
            in rad; negative where it falls on level ground.
        direction: horizontal unit vector, outwards across that edge.
    """

    links: tuple[str, ...]
    polygon: tuple[Point, ...]
    center: Vector
    ground: float
    margin: float
    angle: float
    direction: Point

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


def stand(
    subject: Subject,
    pose: Mapping[str, float] | None = None,
    contacts: Collection[str] | None = None,
    *,
    payload: Mapping[str, float] | None = None,
    meshes: bool = True,
) -> Stability | None:
    """How a robot stands at a pose.

    Args:
        subject: the robot.
        pose: positions of joints in rad or m; the others are at 0.
        contacts: names of the links it stands on; those that reach the lowest point if None.
        payload: masses in kg that links carry at their origin.
        meshes: take meshes into account, which needs numpy and the readers of meshes.

    Returns:
        None without a mass, and where the contacts make no area: a robot that balances.

    Raises:
        ImportError: meshes are to be read, and the libraries are not installed.
    """
    placed = frames(subject.tree, pose or {})
    links = subject.model.links_by_name
    loads = [(mass, placed[name].position) for name, mass in (payload or {}).items()]
    for name, frame in placed.items():
        if inertial := links[name].inertial:
            loads.append((links[name].mass, frame.apply(inertial.origin.position)))
    mass = sum(load for load, _ in loads)
    points = {name: _points(subject, name, placed[name], meshes) for name in placed}
    if contacts is not None:
        points = {name: found for name, found in points.items() if name in contacts}
    heights = [z for found in points.values() for _, _, z in found]
    if mass <= 0 or not heights:
        return None
    ground = min(heights)
    near = ground + max(LEAST, TOLERANCE * (max(heights) - ground))
    standing = {name: [p for p in found if p[2] <= near] for name, found in points.items()}
    polygon = hull((x, y) for found in standing.values() for x, y, _ in found)
    if len(polygon) < 3:
        return None
    x, y, z = (sum(load * place[axis] for load, place in loads) / mass for axis in range(3))
    margin, angle, direction = _edges(polygon, (x, y), z - ground)
    touching = tuple(name for name in links if standing.get(name))
    return Stability(touching, polygon, (x, y, z), ground, margin, angle, direction)


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


def _points(subject: Subject, name: str, frame: Frame, meshes: bool) -> list[Vector]:
    """What may touch the ground of a link: of its collisions, else of its visuals."""
    link = subject.model.links_by_name[name]
    found: list[Vector] = []
    for body in link.collisions or link.visuals:
        if body.shape is None:
            continue
        if body.shape.filename is None:
            part = primitive(body)
            found += [frame.apply(point) for point in _of(part)] if part else []
            found += _lowest(part, frame) if part else []
        elif meshes:
            found += _of_mesh(subject, body, frame)
    return found


def _of(part: Primitive) -> list[Vector]:
    """Corners of a primitive in its link, as far as it has some."""
    if part.kind == "box":
        x, y, z = (edge / 2 for edge in part.size)
        corners = [(a * x, b * y, c * z) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)]
    elif part.kind == "cylinder":
        angles = [2 * pi * number / _CORNERS for number in range(_CORNERS)]
        corners = [
            (part.radius * cos(angle), part.radius * sin(angle), end * part.length / 2)
            for angle in angles
            for end in (-1, 1)
        ]
    else:
        corners = []
    return [part.origin.apply(corner) for corner in corners]


def _lowest(part: Primitive, frame: Frame) -> list[Vector]:
    """The lowest points of what is round: of each end of a cylinder or capsule, and of a ball."""
    if part.kind == "box":
        return []
    at = frame @ part.origin
    ends = [(0.0, 0.0, end * part.length / 2) for end in ((-1, 1) if part.length else (0,))]
    if part.kind != "cylinder":
        return [(x, y, z - part.radius) for x, y, z in map(at.apply, ends)]
    _, _, (gx, gy, _) = at.rotation  # how x and y of the cylinder rise
    steep = hypot(gx, gy)
    if steep < 1e-9:
        return []  # it stands on its end, whose corners are there
    down = (-gx / steep * part.radius, -gy / steep * part.radius)
    return [at.apply((down[0], down[1], z)) for _, _, z in ends]


def _of_mesh(subject: Subject, body: Body, frame: Frame) -> list[Vector]:
    """The lowest vertices of a mesh."""
    assert body.shape is not None
    vertices = subject.meshes.vertices(body.shape)
    if vertices is None or not len(vertices):
        return []
    at = frame @ body.origin
    heights = vertices @ at.rotation[2]
    low, high = float(heights.min()), float(heights.max())
    chosen = vertices[heights <= low + max(LEAST, TOLERANCE * (high - low))]
    return [at.apply((float(x), float(y), float(z))) for x, y, z in chosen]
