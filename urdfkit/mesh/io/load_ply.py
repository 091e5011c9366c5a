"""Reading of PLY files by trimesh."""

import re
from io import BytesIO
from typing import Any

import numpy as np

from urdfkit.mesh.geometry import Mesh, MeshMaterial, NoTriangles
from urdfkit.mesh.io.assemble import LostData, Stream, assemble, mesh_of
from urdfkit.mesh.io.ply import MAX_HEADER
from urdfkit.mesh.io.referenced_files import ReferencedFiles

#: The texture file of a mesh, as MeshLab writes it.
_TEXTURE = re.compile(rb"\ncomment TextureFile[ \t]+([^\r\n]+)")


def read(data: bytes, directory: str) -> Mesh:
    """Read a PLY file.

    Args:
        data: the file.
        directory: the directory of the file, for its texture.

    Raises:
        NoTriangles: the file has none, or trimesh cannot read it.
    """
    try:
        mesh = _read(data)
    except NoTriangles:
        raise
    except Exception as error:  # the reader raises anything for invalid bytes
        raise NoTriangles(f"cannot be read: {type(error).__name__}: {error}") from error
    texture = _TEXTURE.search(data[:MAX_HEADER])
    if texture is None:
        return mesh
    files = ReferencedFiles(directory)
    path = files.image(texture.group(1).decode("utf-8", "replace").strip())
    part = mesh.parts[0]._replace(material=MeshMaterial("", (1.0, 1.0, 1.0, 1.0), path))
    return files.added_to(mesh._replace(parts=(part,)))


def _read(data: bytes) -> Mesh:
    import trimesh
    from trimesh.exchange.ply import load_ply

    arguments = load_ply(BytesIO(data), skip_materials=True)
    if arguments.get("faces") is None:
        raise NoTriangles("contains no triangles")
    mesh = trimesh.Trimesh(**arguments, process=False)
    rows = np.asarray(mesh.faces, dtype=np.int64)

    def stream(values: Any) -> Stream | None:
        if values is None or len(values) != len(mesh.vertices):
            return None
        return Stream(np.asarray(values, dtype=np.float64), rows)

    visual: Any = mesh.visual
    colors = visual.vertex_colors / 255.0 if visual.kind in ("vertex", "face") else None
    losses = LostData()
    part = assemble(
        Stream(np.asarray(mesh.vertices, dtype=np.float64), rows),
        losses,
        normals=stream(arguments.get("vertex_normals")),
        uv=stream(getattr(visual, "uv", None)),
        colors=stream(colors),
    )
    return mesh_of([part], losses)
