"""Writing binary PLY: positions, normals and colours of vertices."""

from __future__ import annotations

from urdfkit.mesh.geometry import Mesh


def encode(mesh: Mesh, name: str) -> dict[str, bytes]:
    """The bytes of a binary PLY (little endian)."""
    import numpy as np
    import trimesh

    from urdfkit.mesh.writers.bridge import to_bytes

    whole = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False, validate=False)
    if all(part.colors is not None for part in mesh.parts):
        colors = np.concatenate([np.asarray(part.colors) for part in mesh.parts])
        whole.visual = trimesh.visual.ColorVisuals(whole, vertex_colors=to_bytes(colors))
    return {name: bytes(trimesh.exchange.ply.export_ply(whole, vertex_normal=False))}
