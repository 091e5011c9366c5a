"""Meshes spoilt in known ways, for tests of the repair."""

from collections.abc import Callable
from typing import Any

import numpy as np
import trimesh

Arrays = tuple[np.ndarray, np.ndarray]


def shapes() -> dict[str, trimesh.Trimesh]:
    """Solids of different kinds: convex and not, with and without holes, one with two bodies."""
    make = trimesh.creation
    bracket: Any = trimesh.boolean.union(
        [
            make.box((0.2, 0.1, 0.02)),
            make.box((0.02, 0.1, 0.15)).apply_translation((-0.09, 0, 0.07)),
        ],
        engine="manifold",
    )
    plate: Any = trimesh.boolean.difference(
        [
            make.box((0.3, 0.2, 0.03)),
            make.cylinder(0.04, 0.1, sections=16).apply_translation((0.05, 0, 0)),
        ],
        engine="manifold",
    )
    two: Any = trimesh.util.concatenate(
        [
            make.icosphere(2, 0.05),
            make.box((0.05, 0.06, 0.07)).subdivide().apply_translation((0.3, 0, 0)),
        ]
    )
    return {
        "ball": make.icosphere(2, 0.1),
        "cylinder": make.cylinder(0.05, 0.2, sections=32),
        "torus": make.torus(0.1, 0.03, major_sections=24, minor_sections=12),
        "bracket": bracket.subdivide(),
        "plate": plate.subdivide(),
        "two bodies": two,
        "ring": make.annulus(0.03, 0.08, 0.05),
    }


def _raw(mesh: trimesh.Trimesh) -> Arrays:
    return np.array(mesh.vertices), np.array(mesh.faces)


def _some(rng: np.random.Generator, faces: np.ndarray, number: int) -> np.ndarray:
    return rng.choice(len(faces), min(number, len(faces) // 8), replace=False)


def _patch(rng: np.random.Generator, mesh: trimesh.Trimesh, number: int) -> np.ndarray:
    """Faces that hang together, around one of them."""
    start = int(rng.integers(len(mesh.faces)))
    near = np.linalg.norm(mesh.triangles_center - mesh.triangles_center[start], axis=1)
    normals = mesh.face_normals @ mesh.face_normals[start] > 0.5
    return np.argsort(np.where(normals, near, np.inf))[: min(number, len(mesh.faces) // 20)]


def unwelded(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    loose = vertices[faces].reshape(-1, 3)
    loose += rng.uniform(-1, 1, loose.shape) * 2e-6 * mesh.scale
    return loose, np.arange(len(loose)).reshape(-1, 3)


def cracked(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    for face in _some(rng, faces, 8):
        corner = int(rng.integers(3))
        moved = vertices[faces[face, corner]] + rng.uniform(-1, 1, 3) * 4e-6 * mesh.scale
        faces[face, corner] = len(vertices)
        vertices = np.vstack([vertices, moved])
    return vertices, faces


def one_hole(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    return vertices, np.delete(faces, int(rng.integers(len(faces))), axis=0)


def several_holes(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    return vertices, np.delete(faces, _some(rng, faces, 5), axis=0)


def large_hole(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    return vertices, np.delete(faces, _patch(rng, mesh, 12), axis=0)


def some_turned(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    turned = _some(rng, faces, len(faces) // 5)
    faces[turned] = faces[turned][:, ::-1]
    return vertices, faces


def all_turned(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    return vertices, faces[:, ::-1].copy()


def repeated(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    return vertices, np.vstack([faces, np.roll(faces[_some(rng, faces, 9)], 1, axis=1)])


def repeated_turned(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    return vertices, np.vstack([faces[_some(rng, faces, 9)][:, ::-1], faces])


def collapsed(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    chosen = faces[_some(rng, faces, 9)]
    return vertices, np.vstack([faces, chosen[:, [0, 1, 1]], chosen[:, [2, 2, 2]]])


def fins(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    for face in _some(rng, faces, 4):
        tip = mesh.triangles_center[face] + 0.2 * mesh.scale * mesh.face_normals[face]
        faces = np.vstack([faces, [[faces[face, 0], faces[face, 1], len(vertices)]]])
        vertices = np.vstack([vertices, tip])
    return vertices, faces


def scraps(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    for _ in range(3):
        corners = rng.uniform(-1, 1, (3, 3)) * 0.05 * mesh.scale + mesh.bounds[1]
        faces = np.vstack([faces, np.arange(3) + len(vertices)])
        vertices = np.vstack([vertices, corners])
    return vertices, faces


def not_finite(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    vertices, faces = _raw(mesh)
    bad = np.array([[np.nan, 0, 0], [0, np.inf, 0]])
    extra = np.array([[faces[0, 0], faces[0, 1], len(vertices)], [0, 1, len(vertices) + 1]])
    return np.vstack([vertices, bad]), np.vstack([faces, extra])


def junctions(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    """Faces cut in two at the middle of a side, and not those on its other side."""
    vertices, faces = _raw(mesh)
    for face in _some(rng, faces, 5):
        a, b, c = faces[face]
        middle = (vertices[a] + vertices[b]) / 2
        faces[face] = (a, len(vertices), c)
        faces = np.vstack([faces, [[len(vertices), b, c]]])
        vertices = np.vstack([vertices, middle])
    return vertices, faces


def wall(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    """A triangle inside that hangs on two of its sides: between three points of the surface."""
    vertices, faces = _raw(mesh)
    one = mesh.face_adjacency_edges[int(rng.integers(len(mesh.face_adjacency_edges)))]
    far = int(np.argmax(np.linalg.norm(vertices - vertices[one[0]], axis=1)))
    return vertices, np.vstack([faces, [[one[0], one[1], far]]])


def everything(rng: np.random.Generator, mesh: trimesh.Trimesh) -> Arrays:
    for spoil in (one_hole, repeated, some_turned, fins, collapsed):
        vertices, faces = spoil(rng, mesh)
        mesh = trimesh.Trimesh(vertices, faces, process=False)
    return _raw(mesh)


KINDS: tuple[Callable[[np.random.Generator, trimesh.Trimesh], Arrays], ...] = (
    unwelded,
    cracked,
    one_hole,
    several_holes,
    large_hole,
    some_turned,
    all_turned,
    repeated,
    repeated_turned,
    collapsed,
    fins,
    scraps,
    not_finite,
    junctions,
    wall,
    everything,
)
