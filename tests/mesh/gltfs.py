"""A tetrahedron in glTF, for the tests of its reader."""

import json
from base64 import b64encode
from typing import Any

import numpy as np

from urdfkit.mesh.io.load import load_bytes

Content = dict[str, Any]
#: A tetrahedron with its corner in the origin.
CORNERS = np.array([(0, 0, 0), (2, 0, 0), (0, 3, 0), (0, 0, 5)])
FACES = np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
#: Bytes of an image, which nobody decodes here.
PIXEL = b"\x89PNG\r\n\x1a\n" + bytes(20)


def uri(data: bytes) -> str:
    return f"data:application/octet-stream;base64,{b64encode(data).decode()}"


def tetrahedron(places: bytes, component: int, **accessor: object) -> Content:
    """A tetrahedron whose corners are given in some number format."""
    faces = FACES.astype("<u2").tobytes()
    places += b"\0" * (-len(places) % 4)
    return {
        "asset": {"version": "2.0"},
        "buffers": [{"uri": uri(places + faces), "byteLength": len(places + faces)}],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(places)},
            {"buffer": 0, "byteOffset": len(places), "byteLength": len(faces)},
        ],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": component,
                "count": 4,
                "type": "VEC3",
                "min": CORNERS.min(axis=0).tolist(),
                "max": CORNERS.max(axis=0).tolist(),
                **accessor,
            },
            {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "scene": 0,
    }


def volume_and_middle(content: Content) -> tuple[float, list[float]]:
    mesh = load_bytes(json.dumps(content).encode(), "a.gltf")
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    middle = (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0)) / 2
    return float((a * np.cross(b, c)).sum()) / 6, middle.tolist()


def floats() -> Content:
    return tetrahedron(CORNERS.astype("<f4").tobytes(), 5126)
