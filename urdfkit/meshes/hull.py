"""Convex hulls, and solids cut into convex pieces."""

from __future__ import annotations

import numpy as np

from urdfkit.errors import UrdfkitError
from urdfkit.meshes.edges import finite
from urdfkit.meshes.geometry import Floats, Integers, Material, Mesh, Part

#: The engines that cut into convex pieces.
ENGINES = ("vhacd", "coacd")
#: Corners of each piece: what physics engines take.
_MOST_CORNERS = 64
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
    if solid.is_empty() or not solid.volume() > 0:
        raise NoHull("all points lie in a plane, which has no hull")
    found = solid.to_mesh64()
    material = mesh.parts[0].material if mesh.parts else None
    part = Part(
        np.asarray(found.vert_properties[:, :3], dtype=np.float64),
        np.asarray(found.tri_verts, dtype=np.int64),
        material,
    )
    return mesh._replace(parts=(part,))


def decompose(mesh: Mesh, *, most: int = 16, engine: str = "vhacd") -> Mesh:
    """Convex pieces that together are nearly the mesh, each a part.

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
    from urdfkit.meshes.edges import welded

    hull(mesh)  # raises where there is no volume
    points, faces = welded(mesh.vertices, mesh.faces)
    pieces = _vhacd(points, faces, most) if engine == "vhacd" else _coacd(points, faces, most)
    if not pieces:
        return hull(mesh)
    parts = []
    for number, corners in enumerate(pieces):
        shell = hull(Mesh((Part(corners, np.arange(len(corners)).reshape(1, -1)),)))
        color = _COLORS[number % len(_COLORS)]
        parts.append(shell.parts[0]._replace(material=Material(f"piece_{number + 1}", color)))
    return mesh._replace(parts=tuple(parts))


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
