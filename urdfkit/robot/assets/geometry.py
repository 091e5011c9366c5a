"""Triangle meshes of visuals and collisions."""

from urdfkit.mesh.geometry import Mesh
from urdfkit.robot import Robot
from urdfkit.robot.link import Body
from urdfkit.robot.shapes import Primitive, primitive


def body_mesh(robot: Robot, body: Body) -> Mesh | None:
    """The triangles of a shape in m, in the frame of its visual or collision.

    Returns:
        None if the shape is neither a known primitive nor a loadable mesh.
    """
    if body.shape is None:
        return None
    part = primitive(body)
    if part is not None:
        return _primitive(part)
    mesh = robot.meshes.mesh(body.shape)
    if mesh is None or not all(body.shape.scale):
        return None
    from urdfkit.mesh.transforms import scaled

    x, y, z = (factor * mesh.unit for factor in body.shape.scale)
    return scaled(mesh, (x, y, z))._replace(unit=1.0)


def _primitive(part: Primitive) -> Mesh:
    from urdfkit.mesh import solids

    if part.kind == "box":
        return solids.as_mesh(solids.box(part.size))
    if part.kind == "cylinder":
        half = part.length / 2
        return solids.as_mesh(solids.cylinder(part.radius, -half, half))
    if part.kind == "sphere":
        return solids.as_mesh(solids.ball(part.radius))
    end = solids.ball(part.radius).translate((0.0, 0.0, part.length / 2))
    return solids.as_mesh((end + end.mirror((0, 0, 1))).hull())
