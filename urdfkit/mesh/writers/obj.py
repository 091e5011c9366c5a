"""Writing of OBJ and its MTL file with materials.

trimesh's exporter rounds to 8 decimals, too coarse for 10-micrometre parts, and silently drops what
it cannot convert.
"""

import os
from collections.abc import Iterator

from urdfkit.mesh.geometry import Floats, Mesh, MeshMaterial, MeshPart
from urdfkit.mesh.normals import shaded
from urdfkit.mesh.writers.text import Table, numbers, printed, table
from urdfkit.mesh.writers.textures import texture_files


def encode(mesh: Mesh, name: str) -> dict[str, bytes]:
    """The bytes of an OBJ file, its MTL file if there are materials, and its textures."""
    texture_names, textures = texture_files(mesh, name)
    library = os.path.splitext(name)[0] + ".mtl"
    material_names = _material_names(mesh)
    lines = [f"mtllib {library}"] if material_names else []
    starts = {"v": 1, "vt": 1, "vn": 1}
    for number, part in enumerate(mesh.parts):
        if not len(part.faces):
            continue
        if number in material_names:
            lines.append(f"usemtl {material_names[number]}")
        lines += _part(shaded(part), starts)
    files = {name: ("\n".join(lines) + "\n").encode()}
    if material_names:
        files[library] = _library(mesh, material_names, texture_names)
    return files | textures


def _part(part: MeshPart, starts: dict[str, int]) -> Iterator[str]:
    """The lines of one part; ``starts`` are the first indices of its rows, and are updated."""
    import numpy as np

    tables: dict[str, Table] = {"v": table(_positions(part), part.faces)}
    if part.uv is not None:
        tables["vt"] = table(part.uv, part.faces)
    if part.normals is not None:
        tables["vn"] = table(part.normals, part.faces)
    for key, (rows, _) in tables.items():
        yield from printed(f"{key}{' %.9g' * rows.shape[1]}", rows)
    corner = "/".join("%d" if key in tables else "" for key in starts).rstrip("/")
    columns = [tables[key].corners + starts[key] for key in starts if key in tables]
    yield from printed(f"f {corner} {corner} {corner}", np.stack(columns, axis=-1))
    for key, (rows, _) in tables.items():
        starts[key] += len(rows)


def _positions(part: MeshPart) -> Floats:
    """Positions, followed by vertex colours, an extension that most readers support."""
    import numpy as np

    if part.colors is None:
        return part.vertices
    return np.column_stack([part.vertices, part.colors[:, :3]])


def _material_names(mesh: Mesh) -> dict[int, str]:
    """Names for the materials of parts; parts with equal materials share a name."""
    names: dict[int, str] = {}
    materials: dict[str, MeshMaterial] = {}
    for number, part in enumerate(mesh.parts):
        if part.material is None:
            continue
        stem = "_".join(part.material.name.split()) or "material"
        name, count = stem, 1
        while materials.get(name, part.material) != part.material:
            count += 1
            name = f"{stem}_{count}"
        materials[name] = part.material
        names[number] = name
    return names


def _library(mesh: Mesh, names: dict[int, str], textures: dict[int, str]) -> bytes:
    lines = []
    done = set()
    for number, name in names.items():
        material = mesh.parts[number].material
        if name in done or material is None:
            continue
        done.add(name)
        *rgb, alpha = material.rgba
        lines += [f"newmtl {name}", f"Kd {numbers(rgb)}", f"d {numbers([alpha])}"]
        if number in textures:
            lines.append(f"map_Kd {textures[number]}")
    return ("\n".join(lines) + "\n").encode()
