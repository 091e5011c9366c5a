"""Distance of convex hulls from the collision meshes that they replace."""

from collections.abc import Iterable

from urdfkit.lint.context import Context
from urdfkit.output.conversion.losses import LossTable
from urdfkit.robot.link import Body

#: Number of points on a hull whose distance from the mesh is measured.
_SAMPLES = 500
#: Distance in m below which a mesh counts as convex.
_CONVEX = 1e-5


def record_hulls(losses: LossTable, robot: Context, collisions: Iterable[Body]) -> None:
    """Record collisions that become convex hulls, and the distance from their meshes."""
    notes: dict[object, float | None] = {}
    for body in collisions:
        shape = body.shape
        if shape is None or shape.filename is None:
            continue
        key = shape.filename.value, shape.scale
        if key not in notes:
            notes[key] = _deviation(robot, body)
        deviation = notes[key]
        if deviation is None:
            losses.approximate(shape.at, "collides as its convex hull")
        elif deviation <= _CONVEX:
            losses.keep(shape.at, "collides as its convex hull, which equals the mesh")
        else:
            note = f"collides as its convex hull, about {deviation * 1e3:.3g} mm outside the mesh"
            losses.approximate(shape.at, note)


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
