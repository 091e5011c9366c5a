"""Our parts as trimesh has them, for the formats that trimesh writes."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
import trimesh

from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.writers import UnwritableMesh
from urdfkit.mesh.writers.textures import texture_bytes


def as_trimesh(part: MeshPart) -> Any:
    """A part as a ``trimesh.Trimesh`` with its normals, material and colours."""
    mesh = trimesh.Trimesh(
        part.vertices, part.faces, vertex_normals=part.normals, process=False, validate=False
    )
    if part.material is not None:
        mesh.visual = trimesh.visual.TextureVisuals(uv=part.uv, material=_material(part))
    elif part.colors is not None:
        mesh.visual = trimesh.visual.ColorVisuals(mesh, vertex_colors=to_bytes(part.colors))
    return mesh


def as_scene(mesh: Mesh) -> Any:
    """A mesh as a ``trimesh.Scene``, its parts by stable names."""
    scene = trimesh.Scene()
    for number, part in enumerate(mesh.parts):
        name = f"part_{number + 1}"
        scene.add_geometry(as_trimesh(part), node_name=name, geom_name=name)
    return scene


def to_bytes(colors: Any) -> Any:
    """Colours from 0 to 1 as bytes."""
    return np.round(np.clip(colors, 0.0, 1.0) * 255).astype(np.uint8)


def _material(part: MeshPart) -> Any:
    assert part.material is not None
    opaque = part.material.rgba[3] >= 1.0
    return trimesh.visual.material.PBRMaterial(
        name=part.material.name or None,
        baseColorFactor=to_bytes(np.asarray(part.material.rgba)),
        baseColorTexture=_image(part),
        metallicFactor=0.0,
        roughnessFactor=0.6,
        alphaMode=None if opaque else "BLEND",
    )


def _image(part: MeshPart) -> Any:
    from PIL import Image

    data = texture_bytes(part.material)
    if data is None or part.uv is None:
        return None
    try:
        image = Image.open(io.BytesIO(data))
        image.load()
    except Exception as error:  # decoders of foreign bytes raise anything
        assert part.material is not None
        raise UnwritableMesh(f"texture of '{part.material.name}': {error}") from error
    return image
