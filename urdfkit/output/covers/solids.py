"""The solids of a robot that spheres or capsules cover."""

from __future__ import annotations

from typing import TYPE_CHECKING

from urdfkit.core.record import Record
from urdfkit.core.words import few
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.robot.assets.geometry import body_mesh
from urdfkit.robot.shapes import Primitive, primitive
from urdfkit.text.source import shown

if TYPE_CHECKING:
    from urdfkit.mesh.geometry import Floats, Mesh
    from urdfkit.robot.link import Link


class Solids(Record):
    """The geometry of the links of a robot."""

    triangles: dict[str, Floats]  # (m, 3, 3) of each link with geometry, in its frame, in m
    #: Shapes of the links that consist only of primitives of the kinds asked for.
    exact: dict[str, list[Primitive]]
    #: Sentences on geometry that is omitted or replaced by its hull, with the reason.
    left_out: list[str]
    replaced: list[str]


def solids(robot: Context, kinds: tuple[str, ...], *, visual: bool) -> Solids:
    """The geometry to cover.

    Args:
        kinds: of primitives that need no cover, such as ``sphere``.
        visual: True for the visual geometry instead of the collision geometry.

    Raises:
        UrdfkitError: there is none.
    """
    from urdfkit.mesh.geometry import Mesh

    found = Solids({}, {}, [], [])
    for link in robot.model.links_by_name.values():
        meshes = _meshes(robot, link, visual, found)
        if not meshes:
            continue
        whole = Mesh(tuple(part for mesh in meshes for part in mesh.parts))
        found.triangles[link.name] = whole.vertices[whole.faces]
        bodies = link.visuals if visual else link.collisions
        shapes = [shape for body in bodies if (shape := primitive(body)) and shape.kind in kinds]
        if len(shapes) == len(bodies):
            found.exact[link.name] = shapes
    if not found.triangles:
        why = _why_nothing(robot, visual, found.left_out)
        raise UrdfkitError(f"{shown(robot.source.path)}: no link has geometry to cover{why}")
    return found


def _why_nothing(robot: Context, visual: bool, left_out: list[str]) -> str:
    if left_out:
        return f": {few(left_out, 1)}"
    is_seen = any(link.visuals for link in robot.model.links)
    if is_seen and not visual:
        return "; only visual geometry, which --visual (visual=True in Python) covers"
    return ""


def _meshes(robot: Context, link: Link, visual: bool, found: Solids) -> list[Mesh]:
    """The meshes of a link, closed and in its frame."""
    from urdfkit.mesh.convex_hull import NoHull
    from urdfkit.mesh.inside import closed
    from urdfkit.mesh.transforms import moved

    meshes = []
    for number, body in enumerate(link.visuals if visual else link.collisions, 1):
        what = f"{'visual' if visual else 'collision'} {number} of link '{link.name}'"
        mesh = body_mesh(robot, body)
        if mesh is None:
            why = robot.meshes.reason(body.shape) if body.shape else ""
            found.left_out.append(f"{what} is left out: {why or 'no shape'}")
            continue
        try:
            solid = closed(mesh)
        except NoHull as reason:
            found.left_out.append(f"{what} is left out: {reason}")
            continue
        if solid is not mesh:
            found.replaced.append(f"{what} is not closed; its convex hull is covered")
        meshes.append(moved(solid, body.origin))
    return meshes
