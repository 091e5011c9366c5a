"""Writing of GLB with all attributes, binary PLY and binary STL, by trimesh."""

import os
from typing import Any

import numpy as np
import trimesh

from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.normals import shaded
from urdfkit.mesh.writers import UnwritableMesh
from urdfkit.mesh.writers.textures import texture_bytes


def encode(mesh: Mesh, name: str) -> dict[str, bytes]:
    """The bytes of a GLB, PLY or STL file, by its suffix."""
    suffix = os.path.splitext(name)[1].lower()
    if suffix == ".glb":
        scene = trimesh.Scene()
        for number, part in enumerate(mesh.parts, 1):
            part_name = f"part_{number}"
            scene.add_geometry(_converted(shaded(part)), node_name=part_name, geom_name=part_name)
        return {name: bytes(scene.export(file_type="glb", include_normals=True))}
    whole = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False, validate=False)
    if suffix == ".stl":  # with an empty header, so that no reader interprets it as ASCII
        return {name: bytes(trimesh.exchange.stl.export_stl(whole))}
    if all(part.colors is not None for part in mesh.parts):
        colors = np.concatenate([np.asarray(part.colors) for part in mesh.parts])
        whole.visual = trimesh.visual.ColorVisuals(whole, vertex_colors=_to_bytes(colors))
    return {name: bytes(trimesh.exchange.ply.export_ply(whole, vertex_normal=False))}


def _converted(part: MeshPart) -> Any:
    """A part as a ``trimesh.Trimesh`` with its normals, material and colours."""
    mesh = trimesh.Trimesh(
        part.vertices, part.faces, vertex_normals=part.normals, process=False, validate=False
    )
    if part.material is not None:
        mesh.visual = trimesh.visual.TextureVisuals(uv=part.uv, material=_material(part))
    elif part.colors is not None:
        mesh.visual = trimesh.visual.ColorVisuals(mesh, vertex_colors=_to_bytes(part.colors))
    return mesh


def _to_bytes(colors: Any) -> Any:
    """Colours from 0 to 1 as bytes from 0 to 255."""
    return np.round(np.clip(colors, 0.0, 1.0) * 255).astype(np.uint8)


def _material(part: MeshPart) -> Any:
    assert part.material is not None
    return trimesh.visual.material.PBRMaterial(
        name=part.material.name or None,
        baseColorFactor=_to_bytes(np.asarray(part.material.rgba)),
        baseColorTexture=_image(part),
        metallicFactor=0.0,
        roughnessFactor=0.6,
        alphaMode=None if part.material.rgba[3] >= 1.0 else "BLEND",
    )


def _image(part: MeshPart) -> Any:
    from urdfkit.mesh.texture_image import opened

    data = texture_bytes(part.material)
    if data is None or part.uv is None:
        return None
    try:
        with opened(data) as image:
            return image.copy()
    except Exception as error:  # decoders of foreign bytes raise anything
        assert part.material is not None
        raise UnwritableMesh(f"texture of '{part.material.name}': {error}") from error
