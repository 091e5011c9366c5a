"""Simpler shapes for a collision mesh, and their deviation from it."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.lint.context import Context
from urdfkit.mesh.containment import protrusion
from urdfkit.mesh.convex_decomposition import decompose
from urdfkit.mesh.convex_hull import NoHull
from urdfkit.mesh.fitting import fit
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.repair.soup import soup_of
from urdfkit.output.conversion.mjcf_pieces import Piece, halved
from urdfkit.robot.assets.collision_shapes import MAX_RELATIVE_ERROR
from urdfkit.robot.assets.geometry import body_mesh
from urdfkit.robot.link import Body


class SimplerCollision(Record):
    """A primitive or convex meshes."""

    note: str  # the kind of shape, and its greatest distance outside of the mesh
    primitive: Piece | None = None
    meshes: tuple[Mesh, ...] = ()


def simplified(robot: Context, geometry: Body, method: str) -> SimplerCollision | None:
    """Simpler shapes for the mesh of a collision; None if the mesh is flat or missing.

    Args:
        method: ``decompose`` or ``primitives``, of `urdfkit.output.conversion.options.COLLISIONS`.
    """
    mesh = body_mesh(robot, geometry)
    if mesh is None:
        return None
    try:
        return _primitive(mesh) if method == "primitives" else _pieces(mesh)
    except NoHull:
        return None


def _primitive(mesh: Mesh) -> SimplerCollision:
    best = fit(mesh, MAX_RELATIVE_ERROR * soup_of(mesh).size).best
    note = _note(str(best), best.error)
    if best.kind in ("box", "sphere", "cylinder"):
        return SimplerCollision(note, Piece(best.kind, halved(best.kind, best.size), best.frame))
    return SimplerCollision(note, meshes=_separate(best.mesh))


def _pieces(mesh: Mesh) -> SimplerCollision:
    parts = decompose(mesh)
    count = len(parts.parts)
    shapes = "its convex hull" if count == 1 else f"{count} convex pieces"
    return SimplerCollision(_note(shapes, protrusion(parts, mesh)), meshes=_separate(parts))


def _separate(mesh: Mesh) -> tuple[Mesh, ...]:
    return tuple(mesh._replace(parts=(part,)) for part in mesh.parts)


def _note(shapes: str, error: float) -> str:
    return f"{shapes}, up to {error * 1e3:.3g} mm outside the mesh"
