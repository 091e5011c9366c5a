"""Convex decomposition of meshes."""

import numpy as np

from urdfkit.core.installation import needing
from urdfkit.mesh.containment import grow_pieces
from urdfkit.mesh.convex_hull import (
    MOST_CORNERS,
    NoHull,
    half_spaces,
    hull,
    points_only,
    with_few_corners,
)
from urdfkit.mesh.distance import directed_distance
from urdfkit.mesh.geometry import Floats, Integers, Mesh, MeshMaterial, MeshPart
from urdfkit.mesh.repair.soup import soup_of

#: Supported decomposition programs.
ENGINES = ("vhacd", "coacd")
#: A mesh is convex if its hull protrudes by no more than this part of the longest edge.
_CONVEX = 1e-3
#: Resolution of vhacd; four times as many voxels take four times as long.
_VOXELS = 50_000


def decompose(mesh: Mesh, *, most: int = 16, engine: str = "vhacd") -> Mesh:
    """Convex pieces that together contain the surface of a mesh, each a part.

    The only piece of a convex mesh is its hull.

    Args:
        most: greatest number of pieces.
        engine: as for `cut`.

    Raises:
        MissingLibrary: its library is not installed.
        NoHull: all points lie in a plane.
    """
    shell = hull(mesh)
    sound = soup_of(mesh)
    beyond = directed_distance(shell.vertices, shell.faces, sound.points, sound.faces)
    if most == 1 or beyond <= _CONVEX * np.ptp(shell.vertices, axis=0).max():
        return shell
    return cut(mesh, most=most, engine=engine)


def cut(mesh: Mesh, *, most: int = 16, engine: str = "vhacd") -> Mesh:
    """A mesh cut into convex pieces that together contain its surface, each a part.

    The engines do not bound how far the surface lies outside of the pieces, so the pieces are grown
    until they contain it.

    Args:
        most: greatest number of pieces.
        engine: ``vhacd`` (K. Mamou's V-HACD 4), fast; or ``coacd`` (X. Wei et al., "Approximate
            Convex Decomposition for 3D Meshes with Collision-Aware Concavity", 2022), which keeps
            openings better and takes longer.

    Raises:
        MissingLibrary: its library is not installed.
        NoHull: all points lie in a plane.
    """
    shell = hull(mesh)  # raises NoHull before an engine starts
    sound = soup_of(mesh)  # V-HACD does not terminate if a coordinate is not finite
    points, faces = sound.points, sound.faces
    pieces = _vhacd(points, faces, most) if engine == "vhacd" else _coacd(points, faces, most)
    pieces = [corners for corners in pieces if _has_inside(corners)]
    parts: list[MeshPart] = []
    for corners in grow_pieces(pieces, points, faces):
        part = with_few_corners(hull(points_only(corners))).parts[0]
        number, color = len(parts) + 1, _COLORS[len(parts) % len(_COLORS)]
        parts.append(part._replace(material=MeshMaterial(f"piece_{number}", color)))
    return mesh._replace(parts=tuple(parts)) if parts else shell


def _has_inside(corners: Floats) -> bool:
    """False for a film that was cut from a thin sheet."""
    from scipy.spatial import QhullError

    try:
        half_spaces(corners)
        hull(points_only(corners))
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


def _vhacd(points: Floats, faces: Integers, most: int) -> list[Floats]:
    with needing("vhacd", "meshes"):
        from vhacdx import compute_vhacd
    # Faces in the format of VTK, each after its number of corners.
    vtk_faces = np.column_stack([np.full(len(faces), 3), faces]).astype(np.uint32)
    pieces = compute_vhacd(
        points,
        vtk_faces,
        maxConvexHulls=most,
        resolution=_VOXELS,
        maxNumVerticesPerCH=MOST_CORNERS,
        asyncACD=False,
    )
    return [np.asarray(corners, dtype=np.float64) for corners, _ in pieces]


def _coacd(points: Floats, faces: Integers, most: int) -> list[Floats]:
    with needing("coacd", "decompose"):
        import coacd
    coacd.set_log_level("error")
    pieces = coacd.run_coacd(
        coacd.Mesh(points, faces),
        max_convex_hull=most,
        max_ch_vertex=MOST_CORNERS,
        decimate=True,
        seed=0,
    )
    return [np.asarray(corners, dtype=np.float64) for corners, _ in pieces]
