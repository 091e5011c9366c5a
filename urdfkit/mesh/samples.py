"""Small mesh files for the examples of rules."""

from collections.abc import Iterable

from urdfkit.core.spatial import Vector

#: One triangle as a text STL.
PLATE = b"""\
solid plate
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid plate
"""

#: The triangles of a box, by its eight corners: bit 2 of a number is x, bit 1 is y, bit 0 is z.
BOX = (
    (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
    (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3),
)  # fmt: skip


def box(low: Vector, high: Vector, faces: Iterable[tuple[int, ...]] = BOX) -> list[list[Vector]]:
    """The triangles of a box, or some of them."""
    ends = (low, high)
    corners = [(ends[n >> 2][0], ends[n >> 1 & 1][1], ends[n & 1][2]) for n in range(8)]
    return [[corners[n] for n in face] for face in faces]


def stl(
    triangles: Iterable[list[Vector]], header: bytes = b"", colour: int = 0, copies: int = 1
) -> bytes:
    """A binary STL file with a number of copies of every triangle."""
    from struct import pack

    body = [
        pack("<12fH", 0, 0, 0, *(value for corner in triangle for value in corner), colour)
        for triangle in triangles
    ]
    return header.ljust(80, b"\0") + pack("<I", copies * len(body)) + copies * b"".join(body)


def collada(asset: str = "", effect: str = "", more: str = "") -> bytes:
    """A COLLADA file with one triangle.

    Args:
        asset: content of ``<asset>``.
        effect: content of the ``<lambert>`` of its material.
        more: further content of ``<mesh>``.
    """
    return f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset>{asset}</asset>
  <library_images><image id="image"><init_from>wood.png</init_from></image></library_images>
  <library_effects><effect id="effect"><profile_COMMON><technique sid="common">
    <lambert>{effect}</lambert></technique></profile_COMMON></effect></library_effects>
  <library_materials>
    <material id="wood"><instance_effect url="#effect"/></material>
  </library_materials>
  <library_geometries><geometry id="plate"><mesh>
    <source id="places"><float_array id="numbers" count="9">0 0 0 1 0 0 0 1 0</float_array>
      <technique_common><accessor source="#numbers" count="3" stride="3"/></technique_common>
    </source>
    <vertices id="corners"><input semantic="POSITION" source="#places"/></vertices>
    <triangles material="wood" count="1">
      <input semantic="VERTEX" source="#corners" offset="0"/><p>0 1 2</p>
    </triangles>{more}
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="scene">
    <node><instance_geometry url="#plate"><bind_material><technique_common>
      <instance_material symbol="wood" target="#wood"/>
    </technique_common></bind_material></instance_geometry></node>
  </visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
""".encode()
