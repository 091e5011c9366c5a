"""Meshes cut into convex pieces."""

import numpy as np

from urdfkit.core.installation import install_command
from urdfkit.errors import UrdfkitError
from urdfkit.mesh.containment import grown
from urdfkit.mesh.convex_hull import (
    MOST_CORNERS,
    NoHull,
    half_spaces,
    hull,
    points_only,
    with_few_corners,
)
from urdfkit.mesh.distance import one_way
from urdfkit.mesh.geometry import Floats, Integers, Mesh, MeshMaterial, MeshPart
from urdfkit.mesh.repair.soup import soup_of

#: The engines that cut into convex pieces.
ENGINES = ("vhacd", "coacd")
#: A mesh is convex if its hull sticks out by no more than this part of the longest edge.
_CONVEX = 1e-3
#: The resolution of vhacd; four times as many voxels take four times as long.
_VOXELS = 50_000


class NoEngine(UrdfkitError):
    """A library is not installed."""


def decompose(mesh: Mesh, *, most: int = 16, engine: str = "vhacd") -> Mesh:
    """Convex pieces that together contain the surface of a mesh, each a part.

    Of a convex mesh, its hull.

    Args:
        most: pieces at most.
        engine: as for `cut`.

    Raises:
        NoEngine: its library is not installed.
        NoHull: all points lie in a plane.
    """
    shell = hull(mesh)
    sound = soup_of(mesh)
    beyond = one_way(shell.vertices, shell.faces, sound.points, sound.faces)
    if most == 1 or beyond <= _CONVEX * np.ptp(shell.vertices, axis=0).max():
        return shell
    return cut(mesh, most=most, engine=engine)


def cut(mesh: Mesh, *, most: int = 16, engine: str = "vhacd") -> Mesh:
    """A mesh cut into convex pieces that together contain its surface, each a part.

    An engine does not say how far the surface may lie outside of what it cuts: where it does, the
    pieces are grown.

    Args:
        most: pieces at most.
        engine: ``vhacd`` (K. Mamou's V-HACD 4), quick; or ``coacd`` (X. Wei et al., "Approximate
            Convex Decomposition for 3D Meshes with Collision-Aware Concavity", 2022), which keeps
            openings better and takes longer.

    Raises:
        NoEngine: its library is not installed.
        NoHull: all points lie in a plane.
    """
    shell = hull(mesh)  # raises where there is no volume
    sound = soup_of(mesh)  # V-HACD does not end where a corner is not finite
    points, faces = sound.points, sound.faces
    pieces = _vhacd(points, faces, most) if engine == "vhacd" else _coacd(points, faces, most)
    pieces = [corners for corners in pieces if _has_inside(corners)]
    parts: list[MeshPart] = []
    for corners in grown(pieces, points, faces):
        part = with_few_corners(hull(points_only(corners))).parts[0]
        number, color = len(parts) + 1, _COLORS[len(parts) % len(_COLORS)]
        parts.append(part._replace(material=MeshMaterial(f"piece_{number}", color)))
    return mesh._replace(parts=tuple(parts)) if parts else shell


def _has_inside(corners: Floats) -> bool:
    """False for a film that was cut off a thin sheet."""
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
    try:
        from vhacdx import compute_vhacd
    except ImportError as error:
        raise NoEngine(f"vhacd needs {error.name}: {install_command('meshes')}") from error
    # It takes faces as VTK has them, each behind the number of its corners.
    counted = np.column_stack([np.full(len(faces), 3), faces]).astype(np.uint32)
    found = compute_vhacd(
        points,
        counted,
        maxConvexHulls=most,
        resolution=_VOXELS,
        maxNumVerticesPerCH=MOST_CORNERS,
        asyncACD=False,
    )
    return [np.asarray(corners, dtype=np.float64) for corners, _ in found]


def _coacd(points: Floats, faces: Integers, most: int) -> list[Floats]:
    try:
        import coacd
    except ImportError as error:
        raise NoEngine(f"coacd needs {error.name}: {install_command('decompose')}") from error
    coacd.set_log_level("error")
    found = coacd.run_coacd(
        coacd.Mesh(points, faces),
        max_convex_hull=most,
        max_ch_vertex=MOST_CORNERS,
        decimate=True,
        seed=0,
    )
    return [np.asarray(corners, dtype=np.float64) for corners, _ in found]
