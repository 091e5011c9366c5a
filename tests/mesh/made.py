"""Small meshes of every format, made here."""

import json
import struct
from base64 import b64encode
from collections.abc import Sequence

Triangle = tuple[tuple[float, ...], ...]

TETRAHEDRON: list[Triangle] = [
    ((0, 0, 0), (0, 1, 0), (1, 0, 0)),
    ((0, 0, 0), (1, 0, 0), (0, 0, 1)),
    ((0, 0, 0), (0, 0, 1), (0, 1, 0)),
    ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
]


def binary_stl(triangles: list[Triangle] = TETRAHEDRON, header: bytes = b"made here") -> bytes:
    body = b"".join(
        struct.pack("<12fH", 0, 0, 0, *(number for corner in triangle for number in corner), 0)
        for triangle in triangles
    )
    return header.ljust(80, b"\0") + struct.pack("<I", len(triangles)) + body


def ascii_stl(
    triangles: Sequence[Sequence[Sequence[float]]] = TETRAHEDRON, name: str = "part"
) -> bytes:
    lines = [f"solid {name}"]
    for triangle in triangles:
        lines += ["  facet normal 0 0 0", "    outer loop"]
        lines += ["      vertex " + " ".join(map(str, corner)) for corner in triangle]
        lines += ["    endloop", "  endfacet"]
    return "\n".join([*lines, f"endsolid {name}", ""]).encode()


def obj() -> bytes:
    return (
        b"# made here\nmtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1/1 2/1 4/1\n"
    )


def collada(numbers: str = "0 0 0 1 0 0 0 1 0", faces: int = 1) -> bytes:
    return f"""<?xml version="1.0" encoding="utf-8"?>
<!-- a > b -->
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries>
    <geometry id="part">
      <mesh>
        <source id="positions">
          <float_array id="numbers" count="9">{numbers}</float_array>
          <technique_common><accessor source="#numbers" count="3" stride="3"/></technique_common>
        </source>
        <source id="normals">
          <float_array id="normal_numbers" count="3">nan nan nan</float_array>
          <technique_common>
            <accessor source="#normal_numbers" count="1" stride="3"/>
          </technique_common>
        </source>
        <vertices id="corners"><input semantic="POSITION" source="#positions"/></vertices>
        <triangles count="{faces}">
          <input semantic="VERTEX" source="#corners" offset="0"/>
          <p>0 1 2</p>
        </triangles>
      </mesh>
    </geometry>
  </library_geometries>
  <library_visual_scenes>
    <visual_scene id="scene"><node><instance_geometry url="#part"/></node></visual_scene>
  </library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
""".encode()


PLY_HEADER = """ply
format {} 1.0
comment made here
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
"""


def ascii_ply(first: str = "0 0 0") -> bytes:
    return f"{PLY_HEADER.format('ascii')}{first}\n1 0 0\n0 1 0\n3 0 1 2\n".encode()


def binary_ply(order: str = "<", first: tuple[float, ...] = (0, 0, 0)) -> bytes:
    name = "binary_little_endian" if order == "<" else "binary_big_endian"
    body = struct.pack(f"{order}9fB3i", *first, 1, 0, 0, 0, 1, 0, 3, 0, 1, 2)
    return PLY_HEADER.format(name).encode() + body


def gltf(**more: object) -> bytes:
    content = {"asset": {"version": "2.0"}, "meshes": [{"primitives": [{"attributes": {}}]}]}
    return json.dumps(content | more).encode()


def whole_gltf() -> bytes:
    """A glTF file with one triangle and embedded data."""
    numbers = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    uri = f"data:application/octet-stream;base64,{b64encode(numbers).decode()}"
    places = {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
    content = {
        "asset": {"version": "2.0"},
        "buffers": [{"uri": uri, "byteLength": len(numbers)}],
        "bufferViews": [{"buffer": 0, "byteLength": len(numbers)}],
        "accessors": [{**places, "min": [0, 0, 0], "max": [1, 1, 0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "scene": 0,
    }
    return json.dumps(content).encode()


def glb(text: bytes | None = None, binary: bytes = b"abcd") -> bytes:
    text = gltf() if text is None else text
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(binary), 0x4E4942) + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


#: One of each that is in order, by suffix and name.
SOUND = {
    ("binary STL", ".stl"): binary_stl(),
    ("ASCII STL", ".stl"): ascii_stl(),
    ("OBJ", ".obj"): obj(),
    ("COLLADA", ".dae"): collada(),
    ("PLY", ".ply"): ascii_ply(),
    ("GLB", ".glb"): glb(),
    ("glTF", ".gltf"): gltf(),
}
