"""Computes the measures of a mesh."""

import numpy as np

from urdfkit.core.spatial import vector
from urdfkit.mesh.components import Pieces, are_flat, inside_out, split_pieces
from urdfkit.mesh.convex_hull import arrays_of
from urdfkit.mesh.edges import Edges, have_distinct_corners
from urdfkit.mesh.geometry import Floats, Integers, Mesh
from urdfkit.mesh.measures import OVERLAP, Measures, Uniform
from urdfkit.mesh.overlap import most_overlap, overlap
from urdfkit.mesh.welding import close_seams, weld

#: Height of a triangle, or thickness of a piece or solid, that counts as zero; relative to the
#: diagonal of the mesh. Coordinates of 32 bits are rounded to 6e-8.
FLAT = 1e-7

#: Part of the volume of all pieces below which a piece does not matter.
SIGNIFICANT = 0.01

#: Most extreme vertices of a hull; a ball loses 1 % of its extent with so many.
MOST_POINTS = 200


@np.errstate(over="ignore", invalid="ignore")  # for absurdly large meshes
def measure(mesh: Mesh) -> Measures:
    """The measures of a mesh, which has triangles."""
    places, faces = weld(mesh.vertices, mesh.faces)
    faces, edges = close_seams(places, faces)
    sound = edges.faces
    low, high = places.min(axis=0), places.max(axis=0)
    diagonal = float(np.linalg.norm(high - low))
    height, areas = _heights(places, faces)
    open_edges = edges.count % 2 == 1
    flipped = ~open_edges & edges.is_unpaired
    is_closed = len(sound) > 0 and not edges.is_unpaired.any()
    pieces = split_pieces(places, edges)
    is_flat = are_flat(places, sound, areas[have_distinct_corners(faces)], pieces, FLAT * diagonal)
    pieces = pieces._replace(is_closed=pieces.is_closed & ~is_flat)
    # An inverted screw does not matter, least of all in a mesh that is open otherwise.
    least = SIGNIFICANT * float(np.abs(pieces.volumes).sum())
    solid, is_inverted = _solid(places, sound, low, high) if is_closed else (None, False)
    hull, points = _hull(places, low, high)
    return Measures(
        triangles=len(faces),
        vertices=int(np.count_nonzero(np.bincount(faces.reshape(-1)))),
        low=vector(low),
        high=vector(high),
        area=float(areas.sum()),
        solid=solid,
        hull=hull,
        points=tuple(vector(point) for point in points),
        inside_out=is_inverted,
        open_edges=int(open_edges.sum()),
        flipped_edges=int(flipped.sum()),
        degenerate=int((height <= FLAT * diagonal).sum()),
        bodies=len(pieces.volumes),
        overlap=_overlap(places, edges, pieces) if solid and not is_inverted else 0.0,
        inverted_bodies=int(inside_out(places, sound, pieces, least).sum()),
        unit=mesh.unit,
        up_axis=mesh.up_axis,
        losses=mesh.losses,
        extras=mesh.extras,
        textures=mesh.textures,
        no_materials=tuple(name for name in mesh.missing if name.lower().endswith(".mtl")),
    )


def uniform(vertices: Floats, faces: Integers, about: Floats) -> tuple[float, Floats, Floats]:
    """Signed volume, first and second moments about a point, of the inside of a closed surface.

    Each triangle forms a tetrahedron with the point; with its corners a, b, c, s = a + b + c, and
    det the volume times 6, the integrals are:

    - of x: det / 24 * s
    - of x x^T: det / 120 * (s s^T + a a^T + b b^T + c c^T)

    Source: J. Tonon, "Explicit Exact Formulas for the 3-D Tetrahedron Inertia Tensor in Terms of
    its Vertex Coordinates" (2004), with one corner at the origin.

    Returns:
        volume, (3,) first moments, (3, 3) second moments.
    """
    a, b, c = vertices.take(faces.T, axis=0) - about
    det = np.einsum("ij,ij->i", a, np.cross(b, c))
    s = a + b + c
    second = np.zeros((3, 3))
    for v in (s, a, b, c):
        second += (v.T * det) @ v
    return float(det.sum()) / 6, det @ s / 24, second / 120


def _solid(
    places: Floats, faces: Integers, low: Floats, high: Floats
) -> tuple[Uniform | None, bool]:
    """The solid that a closed surface encloses, and whether the surface faces inwards."""
    middle = (low + high) / 2
    volume, first, second = uniform(places, faces, middle)
    if abs(volume) <= FLAT * np.linalg.norm(high - low) ** 3:
        return None, False
    return _density_one(volume, first, second, middle), bool(volume < 0)


def _density_one(volume: float, first: Floats, second: Floats, about: Floats) -> Uniform | None:
    """Mass properties for density 1; None if the volume is 0 or a value overflows."""
    if not volume:
        return None
    sign = 1 if volume > 0 else -1
    center = first / volume
    central = (second - volume * np.outer(center, center)) * sign
    tensor = np.trace(central) * np.eye(3) - central
    if not np.isfinite(tensor).all():
        return None
    ixx, ixy, ixz, iyy, iyz, izz = (float(tensor[i, k]) for i in range(3) for k in range(i, 3))
    return Uniform(float(abs(volume)), vector(center + about), (ixx, ixy, ixz, iyy, iyz, izz))


def _overlap(places: Floats, edges: Edges, pieces: Pieces) -> float:
    """The overlap; 0 also if bounding boxes show that it is not significant."""
    if most_overlap(pieces) > OVERLAP or edges.is_non_manifold.any():
        return overlap(places, edges.faces, pieces)
    return 0.0


def _hull(places: Floats, low: Floats, high: Floats) -> tuple[Uniform | None, Floats]:
    """The convex hull as a solid, and its extreme vertices."""
    import manifold3d

    size = np.max(high - low)
    middle = (low + high) / 2
    if not size:
        return None, places[:1]
    # manifold3d partly computes with 32 bits: a part far from the origin, or in nanometres, would
    # lose its shape.
    scaled = (places - middle) / size
    corners, faces = arrays_of(manifold3d.Manifold.hull_points(scaled))
    if not len(corners):
        return None, _extreme(places)
    volume, first, second = uniform(corners, faces, np.zeros(3))
    points = _extreme(corners) * size + middle
    if volume <= FLAT:
        return None, points
    solid = _density_one(volume * size**3, first * size**4, second * size**5, np.zeros(3))
    if solid is None:
        return None, points
    return solid._replace(center=vector(np.array(solid.center) + middle)), points


def _extreme(points: Floats) -> Floats:
    """The extreme points along the axes and in evenly spread directions."""
    if len(points) <= MOST_POINTS:
        return points
    number = np.arange(MOST_POINTS - 6) + 0.5
    around, z = number * np.pi * (1 + 5**0.5), 1 - 2 * number / (MOST_POINTS - 6)
    across = np.sqrt(1 - z * z)
    spread = np.stack([across * np.cos(around), across * np.sin(around), z], axis=1)
    directions = np.concatenate([np.eye(3), -np.eye(3), spread])
    return np.asarray(points[np.unique(np.argmax(directions @ points.T, axis=1))])


def _heights(places: Floats, faces: Integers) -> tuple[Floats, Floats]:
    """The smallest height and the area of each triangle."""
    a, b, c = places.take(faces.T, axis=0)
    twice = _lengths(np.cross(b - a, c - a))
    longest = np.max([_lengths(side) for side in (b - a, c - b, a - c)], axis=0)
    return np.divide(twice, longest, out=np.zeros_like(twice), where=longest > 0), twice / 2


def _lengths(vectors: Floats) -> Floats:
    """(n,), as ``np.linalg.norm`` of (n, 3), which takes several times as long."""
    return np.asarray(np.sqrt(np.einsum("ij,ij->i", vectors, vectors)))
