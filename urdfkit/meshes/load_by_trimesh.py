"""Reading PLY and glTF files with trimesh."""

from __future__ import annotations

import logging
from io import BytesIO
from typing import Any

import numpy as np

from urdfkit.meshes import facts
from urdfkit.meshes.assemble import Losses, Stream, assemble, counted_kinds, transformed
from urdfkit.meshes.check_gltf import check_gltf
from urdfkit.meshes.geometry import Floats, Material, Mesh, NoTriangles, Part

_TYPES = {facts.PLY: "ply", facts.GLB: "glb", facts.GLTF: "gltf"}


def read(data: bytes, form: str, folder: str) -> Mesh:
    """What a PLY or glTF file holds.

    Args:
        data: the file.
        form: the format, by content.
        folder: that the file lies in, and what it refers to.

    Raises:
        NoTriangles: it holds none, or trimesh cannot read it.
    """
    try:
        if form != facts.PLY:
            check_gltf(data, form)
        return _read(data, form, folder)
    except NoTriangles:
        raise
    except Exception as error:  # readers of foreign bytes raise anything, and some of it late
        raise NoTriangles(f"cannot be read: {type(error).__name__}: {error}") from error


def _read(data: bytes, form: str, folder: str) -> Mesh:
    import trimesh

    trimesh.util.log.setLevel(logging.CRITICAL)  # it logs tracebacks of what is told here
    resolver = trimesh.resolvers.FilePathResolver(folder)
    file = BytesIO(data)
    scene = trimesh.load_scene(file, file_type=_TYPES[form], resolver=resolver, process=False)
    losses = Losses()
    parts: list[Part] = []
    others = 0
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        geometry = scene.geometry[name]
        if not isinstance(geometry, trimesh.Trimesh):
            others += 1
            continue
        part = _part(geometry, losses)
        if part is not None:
            parts.append(transformed(part, np.asarray(matrix, dtype=np.float64)))
    if not parts:
        lost = "; ".join(losses.sentences())
        raise NoTriangles(f"holds no triangles{f' ({lost})' if lost else ''}")
    extras = counted_kinds({"line or point set": others})
    # So glTF has it, whatever the numbers are; PLY says nothing.
    up_axis = "" if form == facts.PLY else "Y_UP"
    return Mesh(tuple(parts), up_axis=up_axis, losses=losses.sentences(), extras=extras)


def _part(geometry: Any, losses: Losses) -> Part | None:
    index = np.asarray(geometry.faces, dtype=np.int64)
    vertices = np.asarray(geometry.vertices, dtype=np.float64)
    normals = geometry._cache.cache.get("vertex_normals")  # asked for, it would compute them
    visual = geometry.visual
    uv = getattr(visual, "uv", None)
    colors = visual.vertex_colors / 255.0 if visual.kind in ("vertex", "face") else None
    return assemble(
        Stream(vertices, index),
        losses,
        _material(getattr(visual, "material", None)),
        normals=_stream(normals, index, vertices),
        uv=_stream(uv, index, vertices),
        colors=_stream(colors, index, vertices),
    )


def _stream(values: Any, index: Any, vertices: Floats) -> Stream | None:
    if values is None or len(values) != len(vertices):
        return None
    return Stream(np.asarray(values, dtype=np.float64), index)


def _material(material: Any) -> Material | None:
    """A material of trimesh."""
    if material is None:
        return None
    image = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
    texture = None
    if image is not None:
        packed = BytesIO()
        image.save(packed, "PNG")
        texture = packed.getvalue()
    colour = getattr(material, "baseColorFactor", None)
    if colour is None:
        colour = (255, 255, 255, 255) if image is not None else material.main_color
    red, green, blue, alpha = (float(part) / 255 for part in colour)
    return Material(str(getattr(material, "name", None) or ""), (red, green, blue, alpha), texture)
