"""Writing binary STL: positions only."""

from __future__ import annotations

from urdfkit.mesh.geometry import Mesh


def encode(mesh: Mesh, name: str) -> dict[str, bytes]:
    """The bytes of a binary STL; its header is empty, so that no reader takes it for ASCII."""
    import trimesh

    whole = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False, validate=False)
    return {name: bytes(trimesh.exchange.stl.export_stl(whole))}
