"""The meshes of real robots as trimesh reads them, where it is right."""

import hashlib
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
trimesh = pytest.importorskip("trimesh")

import numpy as np

from tests.conftest import CORPUS, needs_corpus
from urdfkit.mesh.geometry import Floats, Integers, MeshMaterial
from urdfkit.mesh.io.load import load

SUFFIXES = {".stl", ".dae", ".obj", ".ply", ".glb"}


def files() -> Iterator[Path]:
    """One of every content."""
    seen = set()
    for directory, _, names in sorted(os.walk(CORPUS)):
        for path in (Path(directory, name) for name in sorted(names)):
            if path.suffix.lower() in SUFFIXES:
                digest = hashlib.sha256(path.read_bytes()).digest()
                if digest not in seen:
                    seen.add(digest)
                    yield path


def as_trimesh_reads(path: Path) -> tuple[Floats, Integers]:
    """Vertices and faces, node transforms applied; a mirrored part is turned inside out."""
    vertices, faces, start = [], [], 0
    scene = trimesh.load_scene(path, process=False)
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        geometry = scene.geometry[name]
        if isinstance(geometry, trimesh.Trimesh):
            moved = trimesh.transform_points(geometry.vertices, matrix)
            turn = -1 if np.linalg.det(matrix) < 0 else 1
            vertices.append(moved)
            faces.append(np.asarray(geometry.faces)[:, ::turn] + start)
            start += len(moved)
    return np.concatenate(vertices), np.concatenate(faces)


def volume(vertices: Floats, faces: Integers) -> float:
    a, b, c = (vertices[faces[:, i]] for i in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6


@needs_corpus
def test_triangles_bounds_and_volumes_are_those_of_trimesh() -> None:
    compared = 0
    for path in files():
        mesh = load(path)
        vertices, faces = as_trimesh_reads(path)
        assert len(mesh.faces) == len(faces), path
        assert mesh.losses == (), path
        used = vertices[np.unique(faces)]
        size = float(np.prod(np.ptp(used, axis=0)))
        np.testing.assert_allclose(mesh.vertices.min(axis=0), used.min(axis=0), atol=1e-7)
        np.testing.assert_allclose(mesh.vertices.max(axis=0), used.max(axis=0), atol=1e-7)
        difference = volume(mesh.vertices, mesh.faces) - volume(vertices, faces)
        assert abs(difference) <= 1e-6 * size, path
        compared += 1
    assert compared > 160


@needs_corpus
@pytest.mark.filterwarnings("ignore::PendingDeprecationWarning")
def test_colours_and_textures_are_those_of_pycollada() -> None:
    collada = pytest.importorskip("collada")
    compared = 0
    for path in files():
        if path.suffix.lower() != ".dae":
            continue
        theirs = []
        scene = collada.Collada(str(path), ignore=[collada.common.DaeError]).scene
        for geometry in scene.objects("geometry"):
            for surface in geometry.primitives():
                triangles = getattr(surface, "triangleset", lambda same=surface: same)()
                if isinstance(triangles, collada.triangleset.BoundTriangleSet):
                    theirs.append((len(triangles), _look(surface.material)))
        mine = []
        for part in load(path).parts:
            texture = part.material.texture if part.material else None
            look: object = os.path.basename(str(texture)) if texture else None
            if look is None and part.material:
                look = tuple(round(value, 6) for value in part.material.rgba[:3])
            mine.append((len(part.faces), look))
        assert sorted(mine, key=str) == sorted(theirs, key=str), path
        compared += 1
    assert compared > 50


def _look(material: Any) -> object:
    """The texture or the colour of a material of pycollada."""
    if material is None:
        return None
    effect = material.effect
    base = effect.emission if effect.shadingtype == "constant" else effect.diffuse
    if base is None:
        return MeshMaterial().rgba[:3]
    if not isinstance(base, tuple):
        return os.path.basename(base.sampler.surface.image.path)
    return tuple(round(min(value, 1), 6) for value in base[:3])
