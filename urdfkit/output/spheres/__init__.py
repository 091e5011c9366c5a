"""Collision spheres for the links of a robot, as motion planners use."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from urdfkit.core.progress import Progress, silent
from urdfkit.core.record import Record
from urdfkit.core.words import few
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.robot.assets.geometry import body_mesh
from urdfkit.text.source import shown

if TYPE_CHECKING:
    from collections.abc import Mapping

    from urdfkit.mesh.geometry import Floats, Mesh
    from urdfkit.mesh.sphere_fitting import Spheres
    from urdfkit.mesh.sphere_quality import SphereQuality
    from urdfkit.robot.model import Link


class LinkSpheres(Record):
    """The spheres of a link."""

    link: str
    spheres: Spheres  # in the frame of the link, in m
    quality: SphereQuality


class RobotSpheres(Record):
    """The spheres of a robot."""

    links: tuple[LinkSpheres, ...]  # of links with geometry, in document order
    total: SphereQuality
    #: Sentences on geometry that is omitted or replaced by its hull, with the reason.
    left_out: tuple[str, ...]
    replaced: tuple[str, ...]

    @property
    def facts(self) -> dict[str, object]:
        """The spheres for JSON."""
        return {
            "version": 1,
            "links": [
                {
                    "link": link.link,
                    **link.quality.facts,
                    "centers": link.spheres.centers.tolist(),
                    "radii": link.spheres.radii.tolist(),
                }
                for link in self.links
            ],
            "total": self.total.facts,
            "left_out": list(self.left_out),
            "replaced": list(self.replaced),
        }


def fit_spheres(
    robot: Context | str | os.PathLike[str],
    *,
    most: int = 100,
    margin: float = 0.01,
    coverage: float = 0.99,
    visual: bool = False,
    progress: Progress | None = None,
) -> RobotSpheres:
    """Cover the links of a robot with spheres.

    Args:
        robot: a URDF or xacro file, or the result of `urdfkit.read`.
        most: maximum number of spheres, unless there are more links.
        margin: how far a sphere may protrude, in m; exceeded if ``most`` requires it.
        coverage: part of the volume of each link that is covered by spheres, from 0 to 1.
        visual: True to cover the visual geometry instead of the collision geometry.
        progress: called with the number of finished steps and of all steps.

    Raises:
        UrdfkitError: there is no geometry to cover.
    """
    from urdfkit.mesh.sphere_fitting import Covering, fit
    from urdfkit.mesh.sphere_quality import measure, total

    context = robot if isinstance(robot, Context) else read(robot)
    left_out: list[str] = []
    replaced: list[str] = []
    solids = _solids(context, visual, left_out, replaced)
    if not solids:
        why = _why_nothing(context, visual, left_out)
        raise UrdfkitError(f"{shown(context.source.path)}: no link has geometry to cover{why}")
    report = progress or silent
    exact = {name: found for name in solids if (found := _exact(context, name, visual))}
    coverings = {}
    for number, (name, triangles) in enumerate(solids.items(), 1):
        if name not in exact:
            coverings[name] = Covering(triangles, coverage)
        report(number, 2 * len(solids))
    left = most - sum(len(one.radii) for one in exact.values())
    fitted = fit(
        [*coverings.values()],
        margin,
        left,
        lambda done: report(len(solids) + done, 2 * len(solids)),
    )
    every = {**exact, **dict(zip(coverings, fitted, strict=True))}
    links = [
        LinkSpheres(name, every[name], measure(triangles, every[name]))
        for name, triangles in solids.items()
    ]
    whole = total([one.quality for one in links])
    return RobotSpheres(tuple(links), whole, tuple(left_out), tuple(replaced))


def _why_nothing(robot: Context, visual: bool, left_out: list[str]) -> str:
    if left_out:
        return f": {few(left_out, 1)}"
    is_seen = any(link.visuals for link in robot.model.links)
    if is_seen and not visual:
        return "; only visual geometry, which --visual (visual=True in Python) covers"
    return ""


def _exact(robot: Context, name: str, visual: bool) -> Spheres | None:
    """The geometry of a link that consists only of spheres, otherwise None."""
    from numpy import array

    from urdfkit.mesh.sphere_fitting import Spheres
    from urdfkit.robot.shapes import primitive

    link = robot.model.links_by_name[name]
    bodies = link.visuals if visual else link.collisions
    shapes = [primitive(body) for body in bodies]
    if not all(one and one.kind == "sphere" for one in shapes):
        return None
    centers = array([body.origin.position for body in bodies])
    return Spheres(centers, array([one.radius for one in shapes if one]))


def _solids(
    robot: Context, visual: bool, left_out: list[str], replaced: list[str]
) -> Mapping[str, Floats]:
    """Triangles (m, 3, 3) of each link with geometry, in its frame."""
    from urdfkit.mesh.geometry import Mesh

    found = {}
    for link in robot.model.links_by_name.values():
        meshes = _meshes(robot, link, visual, left_out, replaced)
        if meshes:
            whole = Mesh(tuple(part for mesh in meshes for part in mesh.parts))
            found[link.name] = whole.vertices[whole.faces]
    return found


def _meshes(
    robot: Context, link: Link, visual: bool, left_out: list[str], replaced: list[str]
) -> list[Mesh]:
    from urdfkit.mesh.convex_hull import NoHull
    from urdfkit.mesh.inside import closed
    from urdfkit.mesh.transforms import moved

    found = []
    for number, body in enumerate(link.visuals if visual else link.collisions, 1):
        what = f"{'visual' if visual else 'collision'} {number} of link '{link.name}'"
        mesh = body_mesh(robot, body)
        if mesh is None:
            why = robot.meshes.reason(body.shape) if body.shape else ""
            left_out.append(f"{what} is left out: {why or 'it has no shape'}")
            continue
        try:
            solid = closed(mesh)
        except NoHull as reason:
            left_out.append(f"{what} is left out: {reason}")
            continue
        if solid is not mesh:
            replaced.append(f"{what} is not closed; its convex hull is covered")
        found.append(moved(solid, body.origin))
    return found
