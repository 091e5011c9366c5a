"""Distance of convex hulls from the collision meshes that they replace."""

import posixpath
from collections.abc import Iterable

from urdfkit.core.grouping import by_key
from urdfkit.core.words import listed
from urdfkit.lint.context import Context
from urdfkit.output.conversion.losses import LossTable
from urdfkit.robot.link import Body

#: Number of points on a hull whose distance from the mesh is measured.
_SAMPLES = 500
#: Distance in m below which a mesh counts as convex.
_CONVEX = 1e-5
#: Most links that a note lists.
_NAMED = 3


def record_hulls(losses: LossTable, robot: Context, collisions: Iterable[Body]) -> None:
    """Record collisions that become convex hulls, and the distance from their meshes."""
    links = {body.at: link.name for link in robot.model.links for body in link.collisions}
    of_mesh = by_key(
        ((body.shape.filename.value, body.shape.scale), body)
        for body in collisions
        if body.shape is not None and body.shape.filename is not None
    )
    for (file, _), bodies in of_mesh.items():
        deviation = _deviation(robot, bodies[0])
        names = [repr(name) for name in dict.fromkeys(links[body.at] for body in bodies)]
        collide = "collides" if len(names) == 1 else "collide"
        where = f"link{'s' * (len(names) > 1)} {listed(names, _NAMED)} {collide}"
        note = f"{where} as the convex hull of {posixpath.basename(file)}"
        for body in bodies:
            assert body.shape is not None
            if deviation is None:
                losses.approximate(body.shape.at, note)
            elif deviation <= _CONVEX:
                losses.keep(body.shape.at, "collides as its convex hull, which equals the mesh")
            else:
                outside = f"about {deviation * 1e3:.3g} mm outside the mesh"
                losses.approximate(body.shape.at, f"{note}, {outside}")


def _deviation(robot: Context, body: Body) -> float | None:
    """Greatest distance in m of the hull of a mesh from the mesh; None without a hull."""
    # These libraries take longer to import than many robots to convert.
    from urdfkit.mesh.convex_hull import NoHull, hull
    from urdfkit.mesh.distance import sample_surface, to_surface
    from urdfkit.mesh.repair.soup import soup_of
    from urdfkit.robot.assets.geometry import body_mesh

    mesh = body_mesh(robot, body)
    if mesh is None or not len(mesh.faces):
        return None
    try:
        shell = hull(mesh)
    except NoHull:
        return None
    points, _ = sample_surface(shell.vertices[shell.faces], _SAMPLES)
    surface = soup_of(mesh)
    return float(to_surface(points, surface.points, surface.faces).max(initial=0.0))
