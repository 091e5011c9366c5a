"""Simple collision shapes for visual meshes, and the edits that insert them."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable
from typing import TYPE_CHECKING

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector, rotate, to_rpy
from urdfkit.core.words import rounded
from urdfkit.robot.assets.geometry import body_mesh
from urdfkit.robot.kinematics import direction
from urdfkit.robot.link import Body, Link
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Attribute
from urdfkit.text.editing import rewriting
from urdfkit.text.editing.edits import escaped, from_macro, insert_after, remove_elements
from urdfkit.text.editing.rewriting import Rewrite
from urdfkit.workspace.resolve import OUTSIDE

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress
    from urdfkit.mesh.fitting import Fits
    from urdfkit.mesh.geometry import Mesh
    from urdfkit.robot import Robot

#: Largest error of a shape, as a part of the diagonal of the mesh.
MAX_RELATIVE_ERROR = 0.05


class CollisionProposal(Record):
    """The proposed collision of a link."""

    link: Link  # the link
    bodies: tuple[Body, ...]  # its visuals
    fits: tuple[Fits, ...]  # for each visual, the shapes that were fitted
    bounds: tuple[float, ...]  # for each visual, the largest error in m
    reason: str = ""  # why there is no proposal; empty if there is one


class Edited(Record):
    """The new contents of the robot's files, and the new meshes."""

    files: tuple[Rewrite, ...]  # the robot's files with the new collisions
    meshes: dict[str, Mesh]  # new mesh files, by path
    unchanged: dict[str, str]  # why a link is not changed, by its name

    def write(self) -> list[str]:
        """Write the meshes, and then the files that reference them.

        Raises:
            UrdfkitError: a file cannot be written; the robot's files are unchanged then.
        """
        from urdfkit.mesh.writers import write

        paths = [path for name, mesh in self.meshes.items() for path in write(mesh, name)]
        rewriting.write(self.files)
        return [*paths, *(file.path for file in self.files)]


def propose(
    robot: Robot,
    *,
    error: float | None = None,
    links: Collection[str] = (),
    most: int = 8,
    progress: Progress | None = None,
) -> tuple[CollisionProposal, ...]:
    """A simple collision for links whose collision is missing or is the visual mesh itself.

    Args:
        error: largest error of a shape in m; a twentieth of the diagonal of each mesh if None.
        links: names of links to process regardless of their collision.
        most: largest number of convex pieces per visual.
        progress: called with the number of finished links and the total number.

    Raises:
        UnknownLink: one of the links is not in the robot.
    """
    for name in links:
        robot.model.require_link(name)
    chosen = [
        link
        for link in robot.model.links_by_name.values()
        if (link.name in links if links else _has_mesh(link) and _lacks_shape(link))
    ]
    fitted: dict[tuple[object, ...], Fits] = {}
    proposals = []
    for number, link in enumerate(chosen):
        proposals.append(_proposal(robot, link, error, most, fitted))
        if progress:
            progress(number + 1, len(chosen))
    return tuple(proposals)


def _has_mesh(link: Link) -> bool:
    return any(body.is_mesh for body in link.visuals)


def _lacks_shape(link: Link) -> bool:
    """True without a collision, or if all collisions are visual meshes."""
    visual_meshes = {body.file.value for body in link.visuals if body.file}
    return all(body.file and body.file.value in visual_meshes for body in link.collisions)


def _proposal(
    robot: Robot, link: Link, error: float | None, most: int, fitted: dict[tuple[object, ...], Fits]
) -> CollisionProposal:
    """The collision of a link; ``fitted`` caches the results for meshes of other links."""
    from urdfkit.mesh.convex_hull import NoHull
    from urdfkit.mesh.fitting import fit, rolling
    from urdfkit.mesh.repair.soup import soup_of

    fits, bounds = [], []
    for body in link.visuals:
        mesh = body_mesh(robot, body)
        if mesh is None or body.shape is None:
            why = robot.meshes.reason(body.shape) if body.shape else ""
            return CollisionProposal(link, link.visuals, (), (), why or "a visual cannot be read")
        bound = MAX_RELATIVE_ERROR * soup_of(mesh).size if error is None else error
        key = (body.file.value, body.shape.scale) if body.file else (id(body),)
        try:
            if key not in fitted:
                fitted[key] = fit(mesh, bound, most=most)
        except NoHull as reason:
            return CollisionProposal(link, link.visuals, (), (), str(reason))
        axle = _axle(robot, link, body)
        fits.append(rolling(fitted[key], mesh, *axle) if axle else fitted[key])
        bounds.append(bound)
    if not fits:
        return CollisionProposal(link, (), (), (), "it has no visual")
    return CollisionProposal(link, link.visuals, tuple(fits), tuple(bounds))


def _axle(robot: Robot, link: Link, body: Body) -> tuple[Vector, Vector] | None:
    """The axis of the continuous parent joint and a point on it, in the frame of a shape."""
    joints = robot.tree.parents.get(link.name, [])
    turning = [joint for joint in joints if joint.kind == "continuous"]
    if not turning:
        return None
    back = body.origin.inverse
    return rotate(back.rotation, direction(turning[0])), back.position


def edited(robot: Robot, proposals: Iterable[CollisionProposal]) -> Edited:
    """The edited files and the mesh files of the proposals; nothing is written."""
    changes: list[Edit] = []
    meshes: dict[str, Mesh] = {}
    unchanged: dict[str, str] = {}
    for proposal in proposals:
        reason = _why_not(robot, proposal)
        if reason:
            unchanged[proposal.link.name] = reason
            continue
        lines: list[str] = []
        needed: dict[str, Mesh] = {}
        for body, fits in zip(proposal.bodies, proposal.fits, strict=True):
            lines += _collision(robot, body, fits, needed)
        if taken := next((path for path in needed if _exists_otherwise(path, needed[path])), ""):
            unchanged[proposal.link.name] = f"{taken} exists and is another mesh"
            continue
        if outside := next((path for path in needed if not robot.files.resolver.admits(path)), ""):
            unchanged[proposal.link.name] = f"{outside} {OUTSIDE}: not written"
            continue
        meshes |= needed
        elements = [body.at for body in proposal.link.collisions]
        changes += insert_after(proposal.bodies[-1].at, lines)
        changes += remove_elements(elements)
    return Edited(rewriting.rewrites(changes), meshes, unchanged)


def _exists_otherwise(path: str, mesh: Mesh) -> bool:
    """True if the file exists and is not the mesh to write."""
    from urdfkit.mesh.writers import encode

    existing = disk.contents(path)
    name = os.path.basename(path)
    return existing is not None and existing != encode(mesh, name)[name]


def _why_not(robot: Robot, proposal: CollisionProposal) -> str:
    """The reason why a proposal cannot be written; empty if it can."""
    if proposal.reason:
        return proposal.reason
    if from_macro(proposal.link.at):
        return "a macro creates it; put the collision into the macro"
    for body, fits in zip(proposal.bodies, proposal.fits, strict=True):
        if fits.best.kind in ("hull", "pieces") and _visual_mesh(robot, body) is None:
            return "its shape needs a mesh file, and there is no visual mesh to put it next to"
    return ""


def _visual_mesh(robot: Robot, body: Body) -> tuple[str, str] | None:
    """The reference of the visual mesh as XML, and its path, both without the suffix."""
    path = robot.files.path(body.shape) if body.shape else None
    if path is None or body.shape is None or body.shape.filename is None:
        return None
    at, (stem, suffix) = body.shape.filename.at, os.path.splitext(body.shape.filename.value)
    reference = escaped(stem)
    # The source text is kept: the value of $(find) is a path of this machine.
    if isinstance(at, Attribute) and at.span.text.endswith(suffix):
        reference = at.span.text.removesuffix(suffix).replace('"', "&quot;")
    return reference, os.path.splitext(path)[0]


def _collision(robot: Robot, body: Body, fits: Fits, meshes: dict[str, Mesh]) -> list[str]:
    """The lines of the collisions of a visual; required meshes are added to ``meshes``."""
    from urdfkit.mesh.geometry import Mesh

    best = fits.best
    if best.kind not in ("hull", "pieces"):
        return _element(body.origin @ best.frame, _primitive(best.kind, best.size))
    place = _visual_mesh(robot, body)
    assert place is not None
    reference, path = place
    lines: list[str] = []
    # The new meshes are scaled already; another scale needs another file.
    assert body.shape is not None
    x, y, z = body.shape.scale
    scale = "" if x == y == z == 1 else f"_{x:g}_{y:g}_{z:g}"
    for number, part in enumerate(best.mesh.parts, start=1):
        end = f"{scale}_collision{'' if best.kind == 'hull' else f'_{number}'}.stl"
        meshes[path + end] = Mesh((part,))
        lines += _element(body.origin, f'<mesh filename="{reference}{end}"/>')
    return lines


def _primitive(kind: str, size: tuple[float, float, float]) -> str:
    if kind == "box":
        return f'<box size="{rounded(size, 6)}"/>'
    if kind == "cylinder":
        return f'<cylinder radius="{size[0]:.6g}" length="{size[1]:.6g}"/>'
    return f'<sphere radius="{size[0]:.6g}"/>'


def _element(origin: Transform, shape: str) -> list[str]:
    lines = ["<collision>"]
    xyz, rpy = rounded(origin.position, 6), rounded(to_rpy(origin.rotation), 6)
    if (xyz, rpy) != ("0 0 0", "0 0 0"):
        lines.append(f'  <origin xyz="{xyz}" rpy="{rpy}"/>')
    return [*lines, "  <geometry>", f"    {shape}", "  </geometry>", "</collision>"]
