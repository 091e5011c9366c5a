"""What trimesh would read wrongly of a glTF file, and say nothing of.

It takes positions that it cannot decompress for zeros, leaves out the changes of sparse lists and
the scale of normalised ones, and passes over fans.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from importlib.util import find_spec
from struct import unpack_from
from typing import Any

from urdfkit.meshes import facts
from urdfkit.meshes.geometry import NoTriangles

#: Numbers in one list; a list that only declares its length is allocated too.
MAX_ACCESSOR = 60_000_000

_DRACO = "KHR_draco_mesh_compression"
_MESHOPT = frozenset({"EXT_meshopt_compression", "KHR_meshopt_compression"})
_FAN = 6


def check_gltf(data: bytes, form: str) -> None:
    """Refuse what would be read wrongly.

    Args:
        data: the file, whose JSON is sound.
        form: ``GLB`` or ``glTF``.

    Raises:
        NoTriangles: there is such a thing.
    """
    text = data
    if form == facts.GLB:
        (size,) = unpack_from("<I", data, 12)
        text = data[20 : 20 + size]
    content = json.loads(text)
    accessors = content.get("accessors", [])
    counts = [one.get("count", 0) for one in accessors if isinstance(one, dict)]
    if any(not isinstance(count, int) or count > MAX_ACCESSOR for count in counts):
        raise NoTriangles(f"declares a list of more than {MAX_ACCESSOR} numbers")
    if _MESHOPT.intersection(content.get("extensionsUsed", ())):
        raise NoTriangles("is compressed with meshopt, which is not read")
    for primitive in _primitives(content):
        _check_primitive(primitive, accessors)


def _primitives(content: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for mesh in content.get("meshes", []):
        yield from mesh.get("primitives", [])


def _check_primitive(primitive: dict[str, Any], accessors: list[dict[str, Any]]) -> None:
    if _DRACO in primitive.get("extensions", {}) and find_spec("DracoPy") is None:
        raise NoTriangles("is compressed with Draco; to read it: pip install DracoPy")
    if primitive.get("mode") == _FAN:
        raise NoTriangles("holds triangle fans, which are not read")
    place = primitive.get("attributes", {}).get("POSITION")
    used = [accessors[i] for i in (place, primitive.get("indices")) if i is not None]
    if any("sparse" in accessor for accessor in used):
        raise NoTriangles("holds sparse lists, which are not read")
    if place is not None and accessors[place].get("normalized"):
        raise NoTriangles("holds positions as normalised whole numbers, which are not read")
