"""Convex hulls, and solids cut into convex pieces."""

from __future__ import annotations

import numpy as np

from urdfkit.errors import UrdfkitError
from urdfkit.mesh.containment import grown, half_spaces
from urdfkit.mesh.distance import one_way
from urdfkit.mesh.geometry import Floats, Integers, Mesh, MeshMaterial, MeshPart
from urdfkit.mesh.welding import finite, weld

#: The engines that cut into convex pieces.
ENGINES = ("vhacd", "coacd")
#: Corners of a hull or piece: what physics engines take.
_MOST_CORNERS = 64
#: Degrees between the faces of a hull with few corners; the first that leaves few enough is taken.
_APART = (3, 6, 9, 12, 15, 20, 25, 30, 40, 50)
#: A volume that is so small against the cube of the longest edge is none.
_ROUNDING = 1e-14
#: A mesh is convex if its hull sticks out by no more than this part of the longest edge.
_CONVEX = 1e-3
#: In which vhacd looks at the mesh; four times as many take four times as long.
_VOXELS = 50_000


class NoHull(UrdfkitError):
    """All points lie in a plane."""


class NoEngine(UrdfkitError):
    """A library is not installed."""


def hull(mesh: Mesh) -> Mesh:
    """The convex hull of all parts, with the material of the first.

    Raises:
        NoHull: all points lie in a plane.
    """
    from manifold3d import Manifold

    points = mesh.vertices[np.unique(mesh.faces)]
    points = points[finite(points)]
    solid = Manifold.hull_points(points)
    if solid.is_empty() or not solid.volume() > _ROUNDING * np.ptp(points, axis=0).max() ** 3:
        raise NoHull("all points lie in a plane, which has no hull")
    found = solid.to_mesh64()
    part = MeshPart(
        np.array(found.vert_properties[:, :3], dtype=np.float64),  # manifold3d's is read-only
        np.asarray(found.tri_verts, dtype=np.int64),
        _material(mesh),
    )
    return mesh._replace(parts=(part,))


def with_few_corners(shell: Mesh) -> Mesh:
    """A convex solid of at most `_MOST_CORNERS` corners around another one, close to it.

    Of its faces the large ones stay, and of those that look nearly the same way one, moved outwards
    until all lies behind it. Where that gives no fewer corners, the solid itself.

    Args:
        shell: a convex hull.
    """
    from scipy.spatial import HalfspaceIntersection, QhullError

    points = shell.vertices
    if len(points) <= _MOST_CORNERS:
        return shell
    size, middle = float(np.ptp(points, axis=0).max()), points.mean(axis=0)
    scaled = (points - middle) / size
    every = _normals(scaled, shell.faces)
    for degrees in _APART:
        normals = _spread_out(every, degrees)
        reach = (normals @ scaled.T).max(axis=1)
        try:
            corners = HalfspaceIntersection(
                np.column_stack([normals, -reach]), np.zeros(3)
            ).intersections
        except QhullError:  # so flat that no inside is left
            continue
        around = hull(_loose(corners * size + middle))
        if len(around.vertices) <= _MOST_CORNERS:
            return shell._replace(parts=(around.parts[0]._replace(material=_material(shell)),))
    return shell


def _normals(points: Floats, faces: Integers) -> Floats:
    """Of triangles, those of the largest first."""
    a, b, c = (points[faces[:, corner]] for corner in range(3))
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    order = np.argsort(-lengths[lengths > 0], kind="stable")
    found: Floats = (normals[lengths > 0] / lengths[lengths > 0][:, None])[order]
    return found


def _spread_out(normals: Floats, degrees: float) -> Floats:
    """The first of some normals, the next that is not near it, and so on."""
    chosen: list[Floats] = []
    while len(normals):
        chosen.append(normals[0])
        normals = normals[normals @ normals[0] < np.cos(np.radians(degrees))]
    return np.array(chosen)


def _material(mesh: Mesh) -> MeshMaterial | None:
    return mesh.parts[0].material if mesh.parts else None


def _loose(corners: Floats) -> Mesh:
    """Points without a surface, to take the hull of."""
    return Mesh((MeshPart(corners, np.arange(len(corners)).reshape(1, -1)),))


def decompose(mesh: Mesh, *, most: int = 16, engine: str = "vhacd") -> Mesh:
    """Convex pieces that together contain the surface of a mesh, each a part.

    Of a convex mesh, its hull.

    Args:
        mesh: best a solid.
        most: pieces at most.
        engine: as for `cut`.

    Raises:
        NoEngine: its library is not installed.
        NoHull: all points lie in a plane.
    """
    shell = hull(mesh)
    beyond = one_way(shell.vertices, shell.faces, mesh.vertices, mesh.faces)
    if most == 1 or beyond <= _CONVEX * np.ptp(shell.vertices, axis=0).max():
        return shell
    return cut(mesh, most=most, engine=engine)


def cut(mesh: Mesh, *, most: int = 16, engine: str = "vhacd") -> Mesh:
    """A mesh cut into convex pieces that together contain its surface, each a part.

    An engine does not say how far the surface may lie outside of what it cuts: where it does, the
    pieces are grown.

    Args:
        mesh: best a solid.
        most: pieces at most.
        engine: ``vhacd`` (K. Mamou's V-HACD 4), quick; or ``coacd`` (X. Wei et al., "Approximate
            Convex Decomposition for 3D Meshes with Collision-Aware Concavity", 2022), which keeps
            openings better and takes longer.

    Raises:
        NoEngine: its library is not installed.
        NoHull: all points lie in a plane.
    """
    shell = hull(mesh)  # raises where there is no volume
    points, faces = weld(mesh.vertices, mesh.faces)
    pieces = _vhacd(points, faces, most) if engine == "vhacd" else _coacd(points, faces, most)
    pieces = [corners for corners in pieces if _has_inside(corners)]
    parts: list[MeshPart] = []
    for corners in grown(pieces, points, faces):
        part = with_few_corners(hull(_loose(corners))).parts[0]
        number, color = len(parts) + 1, _COLORS[len(parts) % len(_COLORS)]
        parts.append(part._replace(material=MeshMaterial(f"piece_{number}", color)))
    return mesh._replace(parts=tuple(parts)) if parts else shell


def _has_inside(corners: Floats) -> bool:
    """False for a film that was cut off a thin sheet."""
    from scipy.spatial import QhullError

    try:
        half_spaces(corners)
        hull(_loose(corners))
    except (QhullError, NoHull):
        return False
    return True


_COLORS = (
    (0.90, 0.45, 0.25, 1.0),
    (0.30, 0.60, 0.85, 1.0),
    (0.45, 0.75, 0.40, 1.0),
    (0.85, 0.70, 0.25, 1.0),
    (0.60, 0.45, 0.80, 1.0),
    (0.35, 0.75, 0.75, 1.0),
    (0.85, 0.50, 0.65, 1.0),
    (0.60, 0.60, 0.60, 1.0),
)

_Pieces = list[Floats]


def _vhacd(points: Floats, faces: Integers, most: int) -> _Pieces:
    try:
        from vhacdx import compute_vhacd
    except ImportError as error:
        raise NoEngine(f"vhacd needs {error.name}: pip install 'urdfkit[meshes]'") from error
    # It takes faces as VTK has them, each behind the number of its corners.
    counted = np.column_stack([np.full(len(faces), 3), faces]).astype(np.uint32)
    found = compute_vhacd(
        points,
        counted,
        maxConvexHulls=most,
        resolution=_VOXELS,
        maxNumVerticesPerCH=_MOST_CORNERS,
        asyncACD=False,
    )
    return [np.asarray(corners, dtype=np.float64) for corners, _ in found]


def _coacd(points: Floats, faces: Integers, most: int) -> _Pieces:
    try:
        import coacd
    except ImportError as error:
        raise NoEngine(f"coacd needs {error.name}: pip install 'urdfkit[decompose]'") from error
    coacd.set_log_level("error")
    found = coacd.run_coacd(
        coacd.Mesh(points, faces),
        max_convex_hull=most,
        max_ch_vertex=_MOST_CORNERS,
        decimate=True,
        seed=0,
    )
    return [np.asarray(corners, dtype=np.float64) for corners, _ in found]
