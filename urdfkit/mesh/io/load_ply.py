"""Reading PLY files with trimesh."""

import re
from io import BytesIO
from typing import Any

import numpy as np

from urdfkit.mesh.geometry import Mesh, MeshMaterial, NoTriangles
from urdfkit.mesh.io.assemble import LostData, Stream, assemble, mesh_of
from urdfkit.mesh.io.ply import MAX_HEADER
from urdfkit.mesh.io.referenced_files import ReferencedFiles

#: How MeshLab and its like name the image on a mesh.
_TEXTURE = re.compile(rb"\ncomment TextureFile[ \t]+([^\r\n]+)")


def read(data: bytes, directory: str) -> Mesh:
    """Read a PLY file.

    Args:
        data: the file.
        directory: that it lies in, and its image.

    Raises:
        NoTriangles: it holds none, or trimesh cannot read it.
    """
    try:
        mesh = _read(data)
    except NoTriangles:
        raise
    except Exception as error:  # readers of foreign bytes raise anything, and some of it late
        raise NoTriangles(f"cannot be read: {type(error).__name__}: {error}") from error
    named = _TEXTURE.search(data[:MAX_HEADER])
    if named is None:
        return mesh
    files = ReferencedFiles(directory)
    path = files.image(named.group(1).decode("utf-8", "replace").strip())
    part = mesh.parts[0]._replace(material=MeshMaterial("", (1.0, 1.0, 1.0, 1.0), path))
    return files.added_to(mesh._replace(parts=(part,)))


def _read(data: bytes) -> Mesh:
    import trimesh
    from trimesh.exchange.ply import load_ply

    given = load_ply(BytesIO(data), skip_materials=True)
    if given.get("faces") is None:
        raise NoTriangles("holds no triangles")
    found = trimesh.Trimesh(**given, process=False)
    rows = np.asarray(found.faces, dtype=np.int64)

    def stream(values: Any) -> Stream | None:
        if values is None or len(values) != len(found.vertices):
            return None
        return Stream(np.asarray(values, dtype=np.float64), rows)

    visual: Any = found.visual
    colors = visual.vertex_colors / 255.0 if visual.kind in ("vertex", "face") else None
    losses = LostData()
    part = assemble(
        Stream(np.asarray(found.vertices, dtype=np.float64), rows),
        losses,
        normals=stream(given.get("vertex_normals")),
        uv=stream(getattr(visual, "uv", None)),
        colors=stream(colors),
    )
    return mesh_of([part], losses)
