"""Small robots for the tests of collisions: links with shapes, joints between them."""

from pathlib import Path

from urdfkit.lint.context import Context
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver


def link(name: str, *shapes: str) -> str:
    """A link; a shape is what stands in ``<geometry>``, after ``@`` comes its origin."""
    bodies = []
    for shape in shapes:
        geometry, _, origin = shape.partition("@")
        placed = f'<origin xyz="{origin}"/>' if origin else ""
        bodies.append(f"<collision>{placed}<geometry>{geometry}</geometry></collision>")
    return f'<link name="{name}">{"".join(bodies)}</link>'


def joint(
    parent: str, child: str, kind: str = "fixed", origin: str = "0 0 0", more: str = ""
) -> str:
    """A joint named ``parent_child``."""
    return (
        f'<joint name="{parent}_{child}" type="{kind}"><parent link="{parent}"/>'
        f'<child link="{child}"/><origin xyz="{origin}"/>{more}</joint>'
    )


def revolute(lower: float, upper: float, axis: str = "0 0 1") -> str:
    """What a revolute or prismatic joint has besides."""
    return f'<axis xyz="{axis}"/><limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/>'


def box(x: float, y: float, z: float) -> str:
    return f'<box size="{x} {y} {z}"/>'


def sphere(radius: float) -> str:
    return f'<sphere radius="{radius}"/>'


def cylinder(radius: float, length: float) -> str:
    return f'<cylinder radius="{radius}" length="{length}"/>'


def mesh(path: Path, scale: str = "1 1 1") -> str:
    return f'<mesh filename="file://{path}" scale="{scale}"/>'


def robot(*parts: str, directory: Path | None = None) -> Context:
    """The robot of some links and joints."""
    path = str(directory / "r.urdf") if directory else "r.urdf"
    text = f'<robot name="r">{"".join(parts)}</robot>'
    resolver = Resolver(environment={})
    resolver.admit(path, trust=True)  # meshes of a test lie in its own directory
    return Context(Source(path, text.encode()), resolver)


def stl(path: Path, triangles: list[list[list[float]]]) -> Path:
    """Write triangles as ASCII STL."""
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in triangle)
        + "endloop\nendfacet\n"
        for triangle in triangles
    )
    path.write_text(f"solid s\n{facets}endsolid s\n")
    return path


def cube(path: Path, half: float, faces: int = 6) -> Path:
    """A cube as STL; with fewer faces it is open."""
    quads = []
    for axis in range(3):
        for sign in (-half, half):
            a, b = [0.0] * 3, [0.0] * 3
            a[(axis + 1) % 3], b[(axis + 2) % 3] = half, half
            centre = [0.0] * 3
            centre[axis] = sign
            corners = [
                [c + u * p + v * q for c, p, q in zip(centre, a, b, strict=True)]
                for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))
            ]
            quads.append(corners if sign > 0 else corners[::-1])
    triangles = [t for q in quads[:faces] for t in ([q[0], q[1], q[2]], [q[0], q[2], q[3]])]
    return stl(path, triangles)
