"""Reading of glTF 2.0 files and GLB, their binary form: the scene, its nodes and meshes.

trimesh is not used, because it silently misinterprets fans, sparse accessors and normalised
positions. Coordinates are not changed, with y upwards.
"""

import json
from collections.abc import Iterator, Sequence
from math import atan2
from struct import unpack_from

import numpy as np

from urdfkit.core.spatial import IDENTITY, length, rotation_about, unit, vector
from urdfkit.mesh.edges import have_distinct_corners
from urdfkit.mesh.geometry import Floats, Integers, Mesh, MeshPart, NoTriangles
from urdfkit.mesh.io import facts
from urdfkit.mesh.io.assemble import (
    MAX_NODES,
    MAX_TRIANGLES,
    LostData,
    Stream,
    assemble,
    at_most,
    counted_kinds,
    limited,
    mesh_of,
    transformed,
)
from urdfkit.mesh.io.gltf_accessors import Accessors, GltfObject
from urdfkit.mesh.io.gltf_materials import GltfMaterial, GltfMaterials
from urdfkit.mesh.io.polygons import fans, strips
from urdfkit.mesh.io.referenced_files import ReferencedFiles

_POINTS_AND_LINES = range(4)
_TRIANGLES, _STRIP, _FAN = 4, 5, 6
#: Extensions that compress triangles.
_COMPRESSED = {
    "KHR_draco_mesh_compression": "Draco",
    "EXT_meshopt_compression": "meshopt",
    "KHR_meshopt_compression": "meshopt",
}


def read(data: bytes, form: str, directory: str) -> Mesh:
    """The scene of a glTF file.

    Args:
        data: the file, with valid JSON.
        form: ``GLB`` or ``glTF``.
        directory: the directory of the file, for references.

    Raises:
        NoTriangles: the scene has none, or the file cannot be read.
    """
    text, binary = _chunks(data) if form == facts.GLB else (data, b"")
    try:
        root = json.loads(text, parse_constant=_reject)
        for extension in root.get("extensionsRequired", ()):
            if extension in _COMPRESSED:
                raise NoTriangles(f"uses unsupported compression: {_COMPRESSED[extension]}")
        return _GltfReader(root, binary, directory).mesh()
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise NoTriangles(f"is not valid glTF: {type(error).__name__}: {error}") from error


def _reject(word: str) -> None:
    raise ValueError(f"{word} is not a JSON number")


def _chunks(data: bytes) -> tuple[bytes, bytes]:
    """The JSON and the binary chunk of a GLB."""
    (size,) = unpack_from("<I", data, 12)
    return data[20 : 20 + size], data[28 + size :]


class _GltfReader:
    def __init__(self, root: GltfObject, binary: bytes, directory: str) -> None:
        self._root = root
        self._losses = LostData()
        self._files = ReferencedFiles(directory)
        self._accessors = Accessors(root, binary, self._files)
        self._materials = GltfMaterials(root, self._accessors, self._files)
        self._meshes: dict[int, list[MeshPart]] = {}
        self._non_surfaces = 0
        self._read = self._placed = 0

    def mesh(self) -> Mesh:
        mesh = mesh_of(self._placed_parts(), self._losses, self._files)
        return mesh._replace(up_axis="Y_UP", extras=self._extras())  # defined by glTF

    def _placed_parts(self) -> Iterator[MeshPart | None]:
        for node, matrix in at_most(MAX_NODES, "nodes", self._nodes()):
            for part in self._parts(node["mesh"]) if "mesh" in node else ():
                self._placed += len(part.faces)
                self._limit_triangles()
                yield transformed(part, matrix, self._losses)

    def _nodes(self) -> Iterator[tuple[GltfObject, Floats]]:
        """The nodes of the scene and their transforms; further parents of a node are ignored."""
        stack = [(index, np.eye(4)) for index in reversed(self._roots())]
        visited: set[int] = set()
        while stack:
            index, parent_matrix = stack.pop()
            if index in visited:
                self._losses.add("node* with two parents")
                continue
            visited.add(index)
            node = self._root["nodes"][index]
            matrix = parent_matrix @ _matrix(node)
            yield node, matrix
            stack += [(child, matrix) for child in reversed(node.get("children", ()))]

    def _roots(self) -> list[int]:
        if "scenes" in self._root:
            roots: list[int] = self._root["scenes"][self._root.get("scene", 0)].get("nodes", [])
            return roots
        nodes = self._root.get("nodes", ())
        children = {child for node in nodes for child in node.get("children", ())}
        return [index for index in range(len(nodes)) if index not in children]

    def _parts(self, index: int) -> list[MeshPart]:
        """The surfaces of a mesh, before node transforms."""
        if index not in self._meshes:
            parts = map(self._part, self._root["meshes"][index].get("primitives", ()))
            self._meshes[index] = list(limited(parts))
        return self._meshes[index]

    def _part(self, primitive: GltfObject) -> MeshPart | None:
        mode = primitive.get("mode", _TRIANGLES)
        if mode in _POINTS_AND_LINES:
            self._non_surfaces += 1
            return None
        attributes = primitive["attributes"]
        if "POSITION" not in attributes:
            self._losses.add("surface* without positions")
            return None
        positions = self._accessors.floats(attributes["POSITION"])
        if positions.shape[1] != 3:
            raise NoTriangles("is not valid glTF: positions are not three numbers")
        if "indices" in primitive:
            corners = self._accessors.indices(primitive["indices"])
        else:
            corners = np.arange(len(positions))
        rows = _triangles(corners, mode)
        self._read += len(rows)
        self._limit_triangles()
        material = GltfMaterial()
        if "material" in primitive:
            material = self._materials.material(primitive["material"])
        uv = self._values(attributes, f"TEXCOORD_{material.coordinates}", 2)
        normals = self._values(attributes, "NORMAL", 3)
        colors = self._values(attributes, "COLOR_0", 4)
        return assemble(
            Stream(positions, rows),
            self._losses,
            material.material,
            normals=None if normals is None else Stream(normals, rows),
            uv=None if uv is None else Stream(material.image_coordinates(uv), rows),
            colors=None if colors is None else Stream(colors, rows),
        )

    def _limit_triangles(self) -> None:
        """Reject a short file that repeats triangles again and again."""
        if max(self._read, self._placed) > MAX_TRIANGLES:
            raise NoTriangles(f"has more than {MAX_TRIANGLES} triangles")

    def _values(self, attributes: GltfObject, name: str, most: int) -> Floats | None:
        """(n, k), an attribute of the vertices; None if it is missing."""
        return self._accessors.floats(attributes[name])[:, :most] if name in attributes else None

    def _extras(self) -> tuple[str, ...]:
        nodes = self._root.get("nodes", ())
        return counted_kinds(
            {
                "line or point set": self._non_surfaces,
                "camera": sum("camera" in node for node in nodes),
                "animation": len(self._root.get("animations", ())),
                "skin": sum("skin" in node for node in nodes),
            }
        )


def _matrix(node: GltfObject) -> Floats:
    """(4, 4), transform from a node to its parent."""
    if "matrix" in node:
        return np.asarray(np.array(node["matrix"], dtype=float).reshape(4, 4, order="F"))
    matrix = np.eye(4)
    matrix[:3, :3] = _rotation(node.get("rotation", (0.0, 0.0, 0.0, 1.0)))
    matrix[:3, :3] *= node.get("scale", (1.0, 1.0, 1.0))
    matrix[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return matrix


def _rotation(quaternion: Sequence[float]) -> Floats:
    """(3, 3), of a quaternion x, y, z, w; the identity for the zero quaternion."""
    *axis, w = quaternion
    sine = length(vector(axis))
    return np.array(rotation_about(unit(vector(axis)), 2 * atan2(sine, w)) if sine else IDENTITY)


def _triangles(corners: Integers, mode: int) -> Integers:
    """(m, 3), the corners of each triangle, as indices of vertices."""
    number = np.array([len(corners)])
    if mode == _STRIP:
        triangles = corners[strips(number)]
    elif mode == _FAN:
        triangles = corners[fans(number)]
    elif mode == _TRIANGLES:
        return corners[: len(corners) // 3 * 3].reshape(-1, 3)
    else:
        raise NoTriangles(f"is not valid glTF: unknown mode {mode}")
    return triangles[have_distinct_corners(triangles)]  # strips contain collapsed triangles
