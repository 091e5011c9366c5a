"""The robot itself blocks the view of a planar lidar or a camera.

- Many beams of a planar lidar hit the robot in the zero pose: it is mounted at the height of the
  deck, of an arm or of wheels. Navigation reads these hits as obstacles that move with the robot.
  It is an info from a tenth of the beams on, a warning from three tenths on. The `ray` of Gazebo
  Classic hits collision shapes, also from inside; a `gpu_lidar` detects visuals from outside.
  Shapes nearer than the minimum range are not detected.
- The whole image of a camera is covered by parts of the robot nearer than half a metre: it looks
  into its housing, or backwards into the body. A fisheye camera of 180 degrees or more is not
  checked: it has no flat image.
- The minimum range of a lidar is inside a collision shape of its own link: every ray of Gazebo
  Classic returns the distance of the housing. Raise the minimum range, or make the shape smaller.

Raise the sensor, rotate it, or limit the angles of a lidar to the unblocked range.

Sources:
    gazebo-classic, RaySensor: https://github.com/gazebosim/gazebo-classic/blob/gazebo11/gazebo/sensors/RaySensor.cc
    gz-sensors, GpuLidarSensor: https://github.com/gazebosim/gz-sensors/blob/main/src/GpuLidarSensor.cc
    gazebosim/gazebo-classic#1564: https://github.com/gazebosim/gazebo-classic/issues/1564
    gazebosim/gazebo-classic#2187: https://github.com/gazebosim/gazebo-classic/issues/2187
    SDF, lidar: http://sdformat.org/spec?ver=1.9&elem=sensor
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from math import dist

from urdfkit.core.record import Record
from urdfkit.core.spatial import IDENTITY, Transform, Vector, vector
from urdfkit.lint.context import Context
from urdfkit.lint.rules import Finding, Findings, Related, Severity, rule
from urdfkit.robot.link import Body
from urdfkit.robot.ray_casting import Scan, beams_on, crosses_plane, intervals, shape_of
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml, visual_xml
from urdfkit.robot.shapes import Primitive
from urdfkit.ros.gazebo.samples import SCANNER, solid_xml
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.gazebo.views import frame_of, image_rays, is_camera, planar_scan

#: Blocked part of the beams of a lidar, from which it is an info and a warning.
BLOCKED_INFO, BLOCKED_WARNING = 0.1, 0.3
#: In m: a camera is intended to see parts farther away, such as the hand of its robot.
MAX_RANGE = 0.5
_CLIP = 0.1

_DECK = '<origin xyz="0.3 0 0"/>'
BAD = robot_xml(
    solid_xml("base", visual_xml('<box size="0.2 2 0.2"/>', _DECK)),
    link_xml("scanner"),
    joint_xml("fixed", '<origin xyz="0 0 0.05"/>', name="mount", child="scanner"),
    SCANNER,
)
GOOD = BAD.replace("0 0 0.05", "0 0 0.25")


class _Obstacle(Record):
    """A shape of the robot that may be in the way."""

    link: str
    body: Body  # a visual or collision
    #: The same, or the box around a mesh, in the frame of the root or of a sensor.
    shape: Primitive

    @property
    def is_mesh(self) -> bool:
        return self.body.shape is not None and bool(self.body.shape.filename)


@rule(Severity.WARNING, help="raise or turn the sensor, or scan the angles that are free")
def check(context: Context) -> Findings:
    for sensor in sensors(context.model):
        yield from _of_housing(context, sensor)
    if not context.tree.is_sound:
        return

    @cache
    def obstacles(*, visuals: bool) -> list[_Obstacle]:
        return list(_obstacles(context, visuals=visuals))

    for sensor in sensors(context.model):
        frame = frame_of(sensor, context.tree)
        if frame is None:
            continue
        if scan := planar_scan(sensor):
            near = _near(obstacles(visuals=sensor.type.startswith("gpu")), frame, scan.high)
            yield from _of_lidar(context, sensor, frame, scan, near)
        elif is_camera(sensor):
            near = _near(obstacles(visuals=True), frame, MAX_RANGE)
            yield from _of_camera(context, sensor, frame, near)


def _of_housing(context: Context, sensor: Sensor) -> Findings:
    """A minimum range inside of the shapes of the link of a lidar that does not render."""
    link = context.model.links_by_name.get(sensor.reference)
    least = sensor.number(f"{sensor.lidar}/range/min") if sensor.lidar else None
    if link is None or least is None or sensor.type.startswith("gpu") or sensor.find("pose"):
        return
    reach = max(map(_around_origin, link.collisions), default=0.0)
    if least.value < reach:
        message = f"{sensor.who}: minimum range {least.value:g} m is inside the collision of "
        help = "raise the minimum range, or make the collision shape smaller"
        yield Finding(least, f"{message}link '{link.name}', which reaches {reach:g} m", help)


def _around_origin(body: Body) -> float:
    """Least horizontal distance from the origin to the surface of a primitive; 0 if outside."""
    extents = body.shape.half_extents if body.shape else None
    if extents is None or body.origin.rotation != IDENTITY:
        return 0.0
    x, y, z = (abs(place) for place in body.origin.position)
    if z >= extents[2]:
        return 0.0
    return max(min(extents[0] - x, extents[1] - y), 0.0)


def _of_lidar(
    context: Context, sensor: Sensor, frame: Transform, scan: Scan, near: list[_Obstacle]
) -> Findings:
    sees_inside = not sensor.type.startswith("gpu")
    directions = scan.directions
    blocked: dict[str, set[int]] = {}
    for obstacle in near:
        if not crosses_plane(obstacle.shape) or (obstacle.link == sensor.reference and sees_inside):
            continue  # see _of_housing
        if obstacle.is_mesh:
            ends = {"low": scan.low, "high": scan.high}
            found = _on_mesh(context, obstacle, frame, directions, **ends, both_sides=sees_inside)
        else:
            found = set(beams_on(obstacle.shape, scan, directions, sees_inside=sees_inside))
        if found:
            blocked.setdefault(obstacle.link, set()).update(found)
    part = len(set().union(*blocked.values())) / scan.samples
    if part >= BLOCKED_INFO:
        yield _finding(
            context,
            sensor,
            f"{sensor.who}: {100 * part:.0f} % of its beams end at the robot itself",
            blocked,
        )._replace(severity=None if part >= BLOCKED_WARNING else Severity.INFO)


def _of_camera(
    context: Context, sensor: Sensor, frame: Transform, near: list[_Obstacle]
) -> Findings:
    rays = image_rays(sensor)
    if not rays:
        return
    clip = sensor.number("camera/clip/near")
    low = clip.value if clip else _CLIP
    # One ray that passes all shapes, and the boxes around meshes, is enough: nothing is loaded.
    by_ray = zip(*(_hits(obstacle, rays, low) for obstacle in near), strict=True)
    if not all(any(hits) for hits in by_ray):
        return
    blocked: dict[str, set[int]] = {}
    for obstacle in near:
        if obstacle.is_mesh:
            found = _on_mesh(
                context, obstacle, frame, rays, low=low, high=MAX_RANGE, both_sides=False
            )
        else:
            found = {number for number, hit in enumerate(_hits(obstacle, rays, low)) if hit}
        if found:
            blocked.setdefault(obstacle.link, set()).update(found)
    if blocked and len(set().union(*blocked.values())) == len(rays):
        message = f"{sensor.who} sees nothing but the robot itself"
        yield _finding(context, sensor, message, blocked)


def _hits(obstacle: _Obstacle, rays: list[Vector], low: float) -> Iterator[bool]:
    """Whether each ray meets a shape near the camera; of a mesh, whether it meets its box."""
    for found in intervals(obstacle.shape, rays):
        if found is None:
            yield False
            continue
        enters, leaves = found
        yield enters <= MAX_RANGE and (leaves if obstacle.is_mesh else enters) >= low


def _finding(
    context: Context, sensor: Sensor, message: str, blocked: dict[str, set[int]]
) -> Finding:
    worst = sorted(blocked, key=lambda name: -len(blocked[name]))[:3]
    links = context.model.links_by_name
    return Finding(
        sensor.at,
        f"{message}: at {', '.join(worst)}",
        related=tuple(Related(links[name].at.span, f"link '{name}'") for name in worst),
    )


def _obstacles(context: Context, *, visuals: bool) -> Iterator[_Obstacle]:
    """The visuals or collisions of all links whose size is known, in the frame of the root."""
    for name, link in context.model.links_by_name.items():
        if name not in context.tree.frames:
            continue
        at = context.tree.frames[name]
        for body in link.visuals if visuals else link.collisions:
            if shape := shape_of(body, at) or _box(context, body, at):
                yield _Obstacle(name, body, shape)


def _near(obstacles: list[_Obstacle], frame: Transform, reach: float) -> list[_Obstacle]:
    """Those within reach of a sensor, in m, in its frame."""
    inverse = frame.inverse
    return [
        obstacle._replace(shape=obstacle.shape._replace(origin=inverse @ obstacle.shape.origin))
        for obstacle in obstacles
        if dist(obstacle.shape.origin.position, frame.position) - obstacle.shape.longest <= reach
    ]


def _box(context: Context, body: Body, at: Transform) -> Primitive | None:
    """The box around a mesh in the parent of the frame of its link; None if it was not measured."""
    measures = context.measures(body.shape) if body.shape and body.file else ""
    if body.shape is None or isinstance(measures, str):
        return None
    ends = zip(measures.low, measures.high, body.shape.scale, strict=True)
    factor = measures.unit
    pairs = [sorted((low * scale * factor, high * scale * factor)) for low, high, scale in ends]
    size = vector(high - low for low, high in pairs)
    center = vector((high + low) / 2 for low, high in pairs)
    return Primitive("box", size, 0.0, 0.0, at @ body.origin @ Transform(IDENTITY, center))


def _on_mesh(
    context: Context,
    obstacle: _Obstacle,
    frame: Transform,
    directions: list[Vector],
    *,
    low: float,
    high: float,
    both_sides: bool,
) -> set[int]:
    """The numbers of the rays from a frame that meet a mesh; none if it cannot be loaded."""
    from urdfkit.mesh.ray_casting import rays_that_hit  # with numpy: few robots get here

    body = obstacle.body
    assert body.shape is not None
    mesh, vertices = context.meshes.mesh(body.shape), context.meshes.vertices(body.shape)
    if mesh is None or vertices is None:
        return set()
    return rays_that_hit(
        vertices,
        mesh.faces,
        frame.inverse @ context.tree.frames[obstacle.link] @ body.origin,
        directions,
        low=low,
        high=high,
        both_sides=both_sides,
    )
