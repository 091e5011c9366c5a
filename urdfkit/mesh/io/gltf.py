"""Validation of the bytes of glTF 2.0 files: JSON, or the binary container GLB."""

from struct import unpack_from
from typing import Any

from urdfkit.core.words import counted
from urdfkit.mesh.io.facts import Defect, empty, not_a_mesh, truncated, unreadable

_HEADER = 12
_CHUNK_HEADER = 8
_JSON_CHUNK = 0x4E4F534A


def validate_glb(data: bytes) -> tuple[Defect | None, str]:
    if len(data) < _HEADER + _CHUNK_HEADER:
        return truncated(f"ends after {counted(len(data), 'byte')}, inside its header"), ""
    version, length = unpack_from("<II", data, 4)
    if version != 2:
        return unreadable(f"is GLB version {version}; parsers support version 2"), ""
    if length > len(data):
        return truncated(f"declares {length} bytes and has {len(data)}"), ""
    size, kind = unpack_from("<II", data, _HEADER)
    start = _HEADER + _CHUNK_HEADER
    if kind != _JSON_CHUNK:
        return unreadable("does not begin with a JSON chunk"), ""
    if start + size > len(data):
        return truncated(f"declares {size} bytes of JSON and has {len(data) - start}"), ""
    return validate_json(data[start : start + size])


def validate_json(data: bytes) -> tuple[Defect | None, str]:
    """The defect of the JSON of a glTF file."""
    import json  # 3 ms, and few robots have glTF

    try:
        content = json.loads(data)
    except json.JSONDecodeError as error:
        if error.pos >= len(error.doc.rstrip()):
            return truncated("ends inside its JSON"), ""
        if error.msg.startswith("Unterminated"):
            return truncated("ends inside a text of its JSON"), ""
        return unreadable(f"is not JSON: {error.msg} in line {error.lineno}"), ""
    except (ValueError, RecursionError):
        return unreadable("is not JSON"), ""
    if not isinstance(content, dict) or "asset" not in content:
        return not_a_mesh("is JSON, but not glTF"), ""
    version = content["asset"].get("version") if isinstance(content["asset"], dict) else None
    if version == "1.0" or isinstance(content.get("meshes"), dict):
        return unreadable("is glTF version 1.0; parsers support version 2"), ""
    return (None if _has_primitives(content) else empty("contains no triangles")), ""


def _has_primitives(content: dict[str, Any]) -> bool:
    meshes = content.get("meshes")
    return isinstance(meshes, list) and any(
        isinstance(mesh, dict) and mesh.get("primitives") for mesh in meshes
    )
