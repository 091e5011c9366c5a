"""Overlays of a robot: frames, joints, masses, contacts, names.

Hidden overlays are drawn faintly. Their sizes are proportional to the robot.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from math import pi

import numpy as np

from urdfkit.core.grouping import by_key
from urdfkit.core.spatial import IDENTITY, Transform, Vector, basis, transposed, vector
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.render import primitives
from urdfkit.render.arrays import bounds as bounds_of
from urdfkit.render.arrays import single
from urdfkit.render.contacts import overlaps
from urdfkit.render.primitives import Triangles
from urdfkit.render.scene import Label, Scene, SceneItem, build, placed
from urdfkit.robot.composite_body import composite_body
from urdfkit.robot.inertia import uniform_solid
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.kinematics import direction, positions
from urdfkit.robot.link import Link
from urdfkit.ros.surface_materials import Colour, SurfaceMaterial

#: Colours of the overlays.
RED, GREEN, BLUE = (0.90, 0.16, 0.16, 1.0), (0.13, 0.68, 0.25, 1.0), (0.15, 0.40, 0.95, 1.0)
AXIS, RANGE, POSITION = (0.62, 0.18, 0.85, 1.0), (0.62, 0.18, 0.85, 0.35), (1.0, 0.62, 0.0, 1.0)
MASS, ROBOT, INERTIA = (0.98, 0.75, 0.08, 1.0), (0.90, 0.10, 0.45, 1.0), (0.20, 0.55, 0.95, 0.32)
OVERLAP, ADJACENT = (0.90, 0.10, 0.10, 0.45), (0.05, 0.60, 0.62, 0.35)
#: Lengths as parts of the size of the robot.
ARROW_LENGTH, ARC_RADIUS, BALL_RADIUS = 0.08, 0.075, 0.011
#: Corners of a full circle.
_STEPS = 72
#: Legends of the layers.
_LEGENDS = {
    "contacts": (
        ((*OVERLAP[:3], 1.0), "links overlap"),
        ((*ADJACENT[:3], 1.0), "adjacent links overlap"),
    ),
    "mass": ((MASS, "centres of mass"), (ROBOT, "that of the robot")),
    "inertia": (((*INERTIA[:3], 1.0), "boxes of the same inertia"),),
}
#: Reasons for empty layers.
_WHY_EMPTY = {
    "joints": "no joint moves",
    "mass": "no link has a mass",
    "inertia": "no link has a mass",
    "contacts": "no links overlap",
}
#: Most labels for inertias that are too large to be drawn.
_MAX_LABELS = 3


class NoSuchLayer(UrdfkitError):
    """An unknown layer."""


def with_layers(
    scene: Scene, context: Context, layers: Sequence[str], pose: Mapping[str, float] | None = None
) -> Scene:
    """A scene with overlays.

    Args:
        layers: names of `LAYERS`.
        pose: positions of joints, as for the scene.

    Raises:
        NoSuchLayer: a layer is unknown.
    """
    if not layers:
        return scene
    size = extent(scene)
    items: list[SceneItem] = []
    labels: list[Label] = []
    notes: list[str] = []
    legend: list[tuple[Colour, str]] = []
    for layer in layers:
        if layer not in LAYERS:
            hint = (
                did_you_mean(layer, list(LAYERS))
                or f"; there are visual, collision, {', '.join(LAYERS)}"
            )
            raise NoSuchLayer(f"unknown layer '{layer}'{hint}")
        drawn = list(LAYERS[layer](scene, context, size, pose or {}))
        items += (item for item in drawn if isinstance(item, SceneItem))
        labels += (item for item in drawn if isinstance(item, Label))
        if drawn:
            legend += _LEGENDS.get(layer, ())
        else:
            notes.append(f"layer '{layer}' is empty: {_WHY_EMPTY.get(layer, 'it has no links')}")
    return scene._replace(
        items=(*scene.items, *items),
        labels=(*scene.labels, *labels),
        notes=(*scene.notes, *notes),
        legend=(*scene.legend, *legend),
    )


def extent(scene: Scene) -> float:
    """The longest edge of the bounding box of a robot or its frames, in m; 1 without extent."""
    points = scene.points()
    if not len(points):
        points = single([frame.position for frame in scene.frames.values()])
    return (float(np.ptp(points, axis=0).max()) if len(points) else 0.0) or 1.0


Drawn = Iterator["SceneItem | Label"]


def _frames(scene: Scene, _context: Context, size: float, _pose: Mapping[str, float]) -> Drawn:
    """The x, y and z axes of every link in red, green and blue."""
    arrow = _arrow(ARROW_LENGTH * size)
    for name in scene.frames:
        for axis, colour in zip(IDENTITY, (RED, GREEN, BLUE), strict=True):
            yield overlay(name, "frames", arrow, Transform(transposed(basis(axis))), colour)


def _names(scene: Scene, context: Context, _size: float, _pose: Mapping[str, float]) -> Drawn:
    """The names of visible links, or of all links if no link has geometry."""
    of_link = any(not item.material.overlay for item in scene.items)
    for name in scene.frames:
        yield Label(name, name, middle(scene, name), of_link=of_link, is_optional=True)


def middle(scene: Scene, link: str) -> Vector:
    """The middle of the geometry of a link, in its frame; its origin without geometry."""
    vertices = [
        item.vertices for item in scene.items if item.link == link and not item.material.overlay
    ]
    if not vertices:
        return (0.0, 0.0, 0.0)
    points = np.concatenate(vertices)
    return vector((points.min(axis=0) + points.max(axis=0)) / 2)


def _joints(scene: Scene, context: Context, size: float, pose: Mapping[str, float]) -> Drawn:
    """The axis, name, range and position of every movable joint."""
    at = positions(context.tree, pose)
    for joint in context.model.joints_by_name.values():
        ends = context.tree.ends(joint)
        if ends is None or ends[1] not in scene.frames or joint.name not in at:
            continue
        frame = joint.origin @ Transform(transposed(basis(direction(joint))))
        yield overlay(ends[0], "joints", _arrow(ARROW_LENGTH * size, both=True), frame, AXIS)
        yield Label(joint.name, ends[0], joint.origin.position)
        if joint.is_rotational:
            yield from _revolute(ends[0], joint, frame, ARC_RADIUS * size, at[joint.name])
        elif joint.is_prismatic:
            yield from _prismatic(ends[0], joint, frame, BALL_RADIUS * size, at[joint.name])


def _revolute(parent: str, joint: Joint, frame: Transform, radius: float, position: float) -> Drawn:
    """The range of a revolute joint as a sector, and its position as a hand."""
    low, high = bounds(joint) or (-pi, pi)
    if high - low >= 2 * pi:
        low, high = -pi, pi
    yield overlay(parent, "joints", _sector(radius, low, high), frame, RANGE)
    hand = _sector(radius * 1.25, position - 0.035, position + 0.035)
    yield overlay(parent, "joints", hand, frame, POSITION)


def _prismatic(
    parent: str, joint: Joint, frame: Transform, radius: float, position: float
) -> Drawn:
    """The range of a prismatic joint as a rail, and its position as a ball."""
    ends = bounds(joint)
    if ends and ends[1] > ends[0]:
        rail = primitives.cylinder(radius * 0.45, ends[1] - ends[0])
        at = frame @ Transform(position=(0.0, 0.0, (ends[0] + ends[1]) / 2))
        yield overlay(parent, "joints", rail, at, RANGE)
    ball = primitives.sphere(radius)
    at = frame @ Transform(position=(0.0, 0.0, position))
    yield overlay(parent, "joints", ball, at, POSITION)


def _masses(scene: Scene, context: Context, size: float, _pose: Mapping[str, float]) -> Drawn:
    """Balls at the centres of mass of all links, sized by mass, and of the robot."""
    total = sum(link.mass for link in _with_mass(scene, context))
    if total <= 0:
        return
    for link in _with_mass(scene, context):
        assert link.inertial is not None
        radius = BALL_RADIUS * size * 2.2 * (link.mass / total) ** (1 / 3)
        ball = primitives.sphere(max(radius, BALL_RADIUS * size * 0.35))
        center = Transform(position=link.inertial.origin.position)
        yield overlay(link.name, "mass", ball, center, MASS)
    robot_body = composite_body(context.tree, scene.frames)
    if robot_body.properties:
        point = robot_body.properties.center
        ball = primitives.sphere(BALL_RADIUS * size * 1.3)
        yield overlay(robot_body.root, "mass", ball, Transform(position=point), ROBOT)
        yield Label(f"{robot_body.mass:.4g} kg", robot_body.root, point)


def _with_mass(scene: Scene, context: Context) -> list[Link]:
    links = context.model.links_by_name.values()
    return [link for link in links if link.name in scene.frames and link.mass > 0]


def _inertias(scene: Scene, context: Context, size: float, _pose: Mapping[str, float]) -> Drawn:
    """The box of uniform density with the mass and inertia of each link, as in Gazebo.

    A box that is larger than the robot (or half the robot, for a light link) would hide it, so it
    is replaced by a label.
    """
    total = sum(link.mass for link in _with_mass(scene, context))
    large: list[Label] = []
    for link in _with_mass(scene, context):
        inertial = link.inertial
        assert inertial is not None
        if inertial.tensor is None:
            continue
        edges, axes = uniform_solid(inertial.tensor.value, link.mass)
        longest, most = max(edges), size if link.mass > total / 10 else size / 2
        if scene.items and longest > most:
            text = f"{link.name}: inertia of {longest:.3g} m"
            large.append(Label(text, link.name, inertial.origin.position))
        elif longest > 0:
            box = primitives.box(*(max(edge, longest * 1e-3) for edge in edges))
            frame = inertial.origin @ Transform(axes)
            yield overlay(link.name, "inertia", box, frame, INERTIA)
    yield from large[:_MAX_LABELS]
    if len(large) > _MAX_LABELS:
        *_, last = large
        yield last._replace(text=f"and of {len(large) - _MAX_LABELS} more, too large to be drawn")


def _contacts(scene: Scene, context: Context, size: float, pose: Mapping[str, float]) -> Drawn:
    """The collision shapes and depths of overlapping links; red unless they are adjacent."""
    items = build(context, pose, ("collision",)).items
    shapes = by_key((item.link, item) for item in items)
    root = context.tree.roots[0].name
    colours: dict[str, Colour] = {}
    for pair in overlaps(context, pose):
        colour = ADJACENT if pair.is_adjacent else OVERLAP
        for link in (pair.first, pair.second):
            colours[link] = OVERLAP if colours.get(link) == OVERLAP else colour
        point = _between(scene, shapes[pair.first], shapes[pair.second])
        ball = primitives.sphere(BALL_RADIUS * size * 0.7)
        yield overlay(root, "contacts", ball, Transform(position=point), (*colour[:3], 1.0))
        yield Label(f"{pair.first}, {pair.second}: {1000 * pair.depth:.3g} mm", root, point)
    # Translucent colours would mix with opaque collision shapes.
    is_opaque = {item.role for item in scene.items} == {"collision"}
    for link, (*rgb, alpha) in colours.items():
        r, g, b = rgb
        material = SurfaceMaterial((r, g, b, 1.0 if is_opaque else alpha), overlay=not is_opaque)
        for item in shapes[link]:
            yield item._replace(role="contacts", material=material)


def _between(scene: Scene, first: Sequence[SceneItem], second: Sequence[SceneItem]) -> Vector:
    """The middle of the intersection of the bounding boxes of two links, in the world."""
    ends = [
        bounds_of(np.concatenate([placed(item.vertices, scene.frames[item.link]) for item in of]))
        for of in (first, second)
    ]
    lowest, highest = np.maximum(ends[0][0], ends[1][0]), np.minimum(ends[0][1], ends[1][1])
    return vector((lowest + highest) / 2)


#: Overlays by name.
LAYERS: dict[
    str, Callable[[Scene, Context, float, Mapping[str, float]], Iterator[SceneItem | Label]]
] = {
    "frames": _frames,
    "joints": _joints,
    "mass": _masses,
    "inertia": _inertias,
    "contacts": _contacts,
    "names": _names,
}


def overlay(link: str, layer: str, shape: Triangles, frame: Transform, colour: Colour) -> SceneItem:
    """A shape of a layer, in a frame of a link; hidden parts of it are drawn faintly."""
    vertices, faces, normals, _ = shape
    material = SurfaceMaterial(colour, overlay=True)
    return SceneItem(link, layer, layer, material, vertices, faces, normals).moved(frame)


def _arrow(length: float, *, both: bool = False) -> Triangles:
    """An arrow along z from the origin; ``both`` extends it backwards."""
    thin, thick = length * 0.028, length * 0.075
    start, neck = -0.75 * length if both else 0.0, length * 0.78
    return primitives.revolved((0.0, thin, thin, thick, 0.0), (start, start, neck, neck, length))


def _sector(radius: float, low: float, high: float) -> Triangles:
    """A sector of a disc about z between two angles, in rad from x."""
    count = max(2, int(_STEPS * min(high - low, 2 * pi) / (2 * pi)) + 1)
    angles = np.linspace(low, high, count)
    rim = np.stack((np.cos(angles), np.sin(angles), np.zeros(count)), axis=1) * radius
    vertices = np.concatenate((np.zeros((1, 3)), rim)).astype(np.float32)
    index = np.arange(1, count, dtype=np.int32)
    return Triangles(vertices, np.stack((np.zeros_like(index), index, index + 1), axis=1))
