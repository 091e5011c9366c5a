"""Binary glTF of the surfaces of a robot, small enough to embed in a page.

Positions are 16-bit numbers in the box of each surface and normals 8-bit ones
(``KHR_mesh_quantization``), equal corners are merged, and equal surfaces share
their bytes. A node is a surface in the frame of its link, with ``link``, ``role`` and ``label``
among its extras; the file has no link poses, since joints move the links.
"""

import json
from collections.abc import Iterable
from struct import pack
from typing import Any

import numpy as np
from numpy.typing import NDArray

from urdfkit.core import disk
from urdfkit.render.scene import SceneItem
from urdfkit.render.textures import stripes
from urdfkit.render.textures import texture as read_image
from urdfkit.ros.surface_materials import STRIPES, SurfaceMaterial

_ARRAY, _ELEMENTS = 34962, 34963
_TYPES = {"i1": 5120, "u1": 5121, "u2": 5123, "u4": 5125, "f4": 5126}
_SHAPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}
#: Size in bytes above which a texture is compressed again.
MAX_TEXTURE = 4 * 1024 * 1024


class GltfWriter:
    """Collects surfaces; `data` returns the file."""

    def __init__(self) -> None:
        self._bytes = bytearray()
        self._nodes: list[dict[str, Any]] = []
        self._meshes: list[dict[str, Any]] = []
        self._accessors: list[dict[str, Any]] = []
        self._views: list[dict[str, Any]] = []
        self._images: list[dict[str, Any]] = []
        self._materials: list[dict[str, Any]] = []
        self._known: dict[object, int] = {}
        self.triangles = 0

    def add(self, item: SceneItem) -> None:
        """Add a surface; a surface without a finite extent is ignored."""
        corners = _corners(item)
        if corners is None:
            return
        faces, positions, low, size, normals, uv, colours = corners
        attributes = {"POSITION": self._accessor(positions, normalized=True, bounded=True)}
        if normals is not None:
            attributes["NORMAL"] = self._accessor(normals, normalized=True)
        if uv is not None:
            attributes["TEXCOORD_0"] = self._accessor(uv)
        if colours is not None:
            attributes["COLOR_0"] = self._accessor(colours, normalized=True)
        primitive = {
            "attributes": attributes,
            "indices": self._accessor(faces, target=_ELEMENTS),
            "material": self._material(item.material),
        }
        mesh = self._once(
            ("mesh", json.dumps(primitive)), self._meshes, {"primitives": [primitive]}
        )
        node = {
            "mesh": mesh,
            "translation": [float(value) for value in low],
            "scale": [float(size)] * 3,
            "extras": {"link": item.link, "role": item.role, "label": item.label},
        }
        self._nodes.append(node)
        self.triangles += len(faces) // 3

    @property
    def data(self) -> bytes:
        """Contents of the file; equal surfaces yield equal bytes."""
        document = {
            "asset": {"version": "2.0", "generator": "urdfkit"},
            "extensionsUsed": ["KHR_mesh_quantization"],
            "extensionsRequired": ["KHR_mesh_quantization"],
            "scene": 0,
            "scenes": [{"nodes": list(range(len(self._nodes)))} if self._nodes else {}],
            "buffers": [{"byteLength": len(self._bytes)}] if self._bytes else [],
            "nodes": self._nodes,
            "meshes": self._meshes,
            "accessors": self._accessors,
            "bufferViews": self._views,
            "materials": self._materials,
            "images": self._images,
            "textures": [{"source": number} for number in range(len(self._images))],
        }
        # glTF allows no empty lists.
        text = json.dumps({key: value for key, value in document.items() if value != []})
        head = text.encode()
        head += b" " * (-len(head) % 4)
        chunks = pack("<I4s", len(head), b"JSON") + head
        if self._bytes:
            chunks += pack("<I4s", len(self._bytes), b"BIN\0") + self._bytes
        return pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks

    def _once(self, key: object, place: list[dict[str, Any]], entry: dict[str, Any]) -> int:
        """Index of an entry, which is added if it does not exist."""
        if key not in self._known:
            self._known[key] = len(place)
            place.append(entry)
        return self._known[key]

    def _view(self, data: bytes, **more: int) -> int:
        key = ("view", data, *more.items())
        if key not in self._known:
            view = {"buffer": 0, "byteOffset": len(self._bytes), "byteLength": len(data), **more}
            self._known[key] = len(self._views)
            self._views.append(view)
            self._bytes += data + bytes(-len(data) % 4)
        return self._known[key]

    def _accessor(
        self,
        values: NDArray[Any],
        *,
        normalized: bool = False,
        bounded: bool = False,
        target: int = _ARRAY,
    ) -> int:
        """Index of an accessor of rows of numbers; each row is aligned to four bytes."""
        rows = values.reshape(len(values), -1)
        width = rows.shape[1]
        more: dict[str, int] = {"target": target}
        if target == _ARRAY:
            padding = -width * rows.itemsize % 4 // rows.itemsize
            rows = np.pad(rows, ((0, 0), (0, padding)))
            more["byteStride"] = rows.shape[1] * rows.itemsize
        entry: dict[str, Any] = {
            "bufferView": self._view(np.ascontiguousarray(rows).tobytes(), **more),
            "componentType": _TYPES[rows.dtype.str[1:]],
            "count": len(rows),
            "type": _SHAPES[width],
        }
        if normalized:
            entry["normalized"] = True
        if bounded:
            entry["min"] = values.min(axis=0).tolist()
            entry["max"] = values.max(axis=0).tolist()
        return self._once(("accessor", json.dumps(entry)), self._accessors, entry)

    def _material(self, material: SurfaceMaterial) -> int:
        rgba = [_linear(part) for part in material.rgba[:3]] + [material.rgba[3]]
        surface: dict[str, Any] = {
            "baseColorFactor": rgba,
            "metallicFactor": 0.0,
            "roughnessFactor": 0.75,
        }
        entry: dict[str, Any] = {"pbrMetallicRoughness": surface, "doubleSided": True}
        if material.rgba[3] < 1:
            entry["alphaMode"] = "BLEND"
        image = self._image(material.texture)
        if image is not None:
            surface["baseColorTexture"] = {"index": image}
        return self._once(("material", json.dumps(entry)), self._materials, entry)

    def _image(self, texture: str | bytes | None) -> int | None:
        """Index of an image that every browser shows; None if the texture is not an image."""
        if texture is None or ("image", texture) in self._known:
            return None if texture is None else self._known["image", texture]
        data = _shown(texture)
        if not data:
            return None
        entry = {"bufferView": self._view(data), "mimeType": _kind(data)}
        return self._once(("image", texture), self._images, entry)


def write(items: Iterable[SceneItem]) -> tuple[bytes, int]:
    """A glTF file of surfaces, and its number of triangles."""
    writer = GltfWriter()
    for item in items:
        writer.add(item)
    return writer.data, writer.triangles


def _corners(item: SceneItem) -> tuple[NDArray[Any], ...] | None:
    """Quantized arrays: faces, positions, offset and size, normals, uv, colours.

    Positions are in units of 1/65535 of the surface's longest edge: a uniform scale does not
    change normals.
    """
    finite = np.asarray(np.isfinite(item.vertices).all(axis=1))
    triangles = item.faces[finite[item.faces].all(axis=1)]
    if not len(triangles):
        return None
    is_used = np.zeros(len(finite), dtype=bool)
    is_used[triangles] = True
    used = np.flatnonzero(is_used)
    points = item.vertices[used].astype(np.float64)
    low = points.min(axis=0)
    size = max(float((points - low).max()), 1e-9)
    columns = [np.rint((points - low) * (65535 / size)).astype(np.uint16)]
    for values, factor, kind in (
        (item.normals, 127, np.int8),
        (item.uv if item.material.texture else None, 1, np.float32),
        (item.colors, 255, np.uint8),
    ):
        columns.append(_column(values, used, factor, kind))
    present = [column for column in columns if column is not None]
    rows = np.concatenate([column.view(np.uint8).reshape(len(used), -1) for column in present], 1)
    _, first, number = np.unique(
        rows.view(f"V{rows.shape[1]}").reshape(-1), return_index=True, return_inverse=True
    )
    unique = [None if column is None else column[first] for column in columns]
    narrow = np.uint16 if len(first) < 65536 else np.uint32
    faces = number.reshape(-1)[(np.cumsum(is_used) - 1)[triangles.reshape(-1)]]
    return faces.astype(narrow), unique[0], low, np.float64(size), *unique[1:]


def _column(
    values: NDArray[Any] | None, index: NDArray[Any], factor: float, kind: Any
) -> NDArray[Any] | None:
    if values is None:
        return None
    chosen = np.nan_to_num(values[index], nan=0.0, posinf=0.0, neginf=0.0)
    if kind is np.float32:
        flipped = chosen * (1, -1) + (0, 1)  # glTF counts from the upper edge
        return np.ascontiguousarray(flipped, dtype=np.float32)
    clipped = np.clip(np.rint(chosen * factor), -127 if kind is np.int8 else 0, factor)
    return np.ascontiguousarray(clipped, dtype=kind)


def _linear(part: float) -> float:
    """sRGB to linear; IEC 61966-2-1."""
    return part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4


def _shown(texture: str | bytes) -> bytes:
    """A PNG or JPEG unchanged, another image as a JPEG; empty if it is not an image."""
    if texture == STRIPES:
        return stripes()
    data = texture if isinstance(texture, bytes) else _file(texture)
    if _kind(data) and len(data) <= MAX_TEXTURE:
        return data
    image = read_image(texture)
    return b"" if image is None else image.jpeg()


def _file(path: str) -> bytes:
    """Contents of a file, if it is small enough to embed."""
    try:
        if disk.state(path).st_size > MAX_TEXTURE:
            return b""
        return disk.read(path)
    except (OSError, ValueError):  # missing, or not a file name
        return b""


def _kind(data: bytes) -> str:
    """Media type of an image that every browser shows; empty for other data."""
    if data.startswith(b"\x89PNG\r\n\x1a\n"):
        return "image/png"
    return "image/jpeg" if data.startswith(b"\xff\xd8\xff") else ""
