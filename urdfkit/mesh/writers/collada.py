"""Writing of COLLADA 1.4.1 that all URDF parsers interpret in the same way.

Metres and z up, without node transforms: the only form on which RViz, Gazebo, MoveIt, Pinocchio and
Bullet agree. The dates that the schema requires are the epoch, so that equal meshes give equal
files.
"""

import re
from typing import NamedTuple

from lxml import etree

from urdfkit.mesh.geometry import Floats, Mesh, MeshMaterial, MeshPart
from urdfkit.mesh.normals import shaded
from urdfkit.mesh.writers.text import numbers, table
from urdfkit.mesh.writers.textures import texture_files

_NAMESPACE = "http://www.collada.org/2005/11/COLLADASchema"
_DATE = "1970-01-01T00:00:00Z"
#: Material of parts without one.
_PLAIN = MeshMaterial("plain")
_INDENT = "  "


def encode(mesh: Mesh, name: str) -> dict[str, bytes]:
    """The bytes of a COLLADA file and its textures."""
    texture_names, textures = texture_files(mesh, name)
    parts = [(number, shaded(part)) for number, part in enumerate(mesh.parts) if len(part.faces)]
    root = etree.Element("COLLADA", xmlns=_NAMESPACE, version="1.4.1")
    _asset(root)
    materials = _file_materials(parts, texture_names)
    _images(root, materials)
    _effects(root, materials)
    _materials(root, materials)
    geometries = etree.SubElement(root, "library_geometries")
    for number, part in parts:
        _geometry(geometries, f"part_{number + 1}", part)
    _scene(root, parts, materials)
    etree.indent(root, _INDENT)
    text = etree.tostring(root, encoding="utf-8", xml_declaration=True, pretty_print=True)
    return {name: text} | textures


class _Material(NamedTuple):
    """A material of the file; parts of equal appearance share it."""

    id: str
    material: MeshMaterial
    texture: str


def _file_materials(
    parts: list[tuple[int, MeshPart]], textures: dict[int, str]
) -> dict[int, _Material]:
    """The material of each part, by its number."""
    materials: dict[int, _Material] = {}
    known: dict[tuple[MeshMaterial, str], _Material] = {}
    for number, part in parts:
        material, texture = part.material or _PLAIN, textures.get(number, "")
        key = (material._replace(texture=None), texture)
        known.setdefault(key, _Material(f"material_{len(known) + 1}", material, texture))
        materials[number] = known[key]
    return materials


def _asset(root: etree._Element) -> None:
    asset = etree.SubElement(root, "asset")
    _text(etree.SubElement(asset, "contributor"), "authoring_tool", "urdfkit")
    _text(asset, "created", _DATE)
    _text(asset, "modified", _DATE)
    etree.SubElement(asset, "unit", name="meter", meter="1")
    _text(asset, "up_axis", "Z_UP")


def _images(root: etree._Element, materials: dict[int, _Material]) -> None:
    by_texture = {entry.texture: entry for entry in materials.values() if entry.texture}
    if not by_texture:
        return
    library = etree.SubElement(root, "library_images")
    for texture, entry in by_texture.items():
        image = etree.SubElement(library, "image", id=f"{entry.id}_image")
        _text(image, "init_from", texture)


def _effects(root: etree._Element, materials: dict[int, _Material]) -> None:
    images = {entry.texture: f"{entry.id}_image" for entry in materials.values() if entry.texture}
    library = etree.SubElement(root, "library_effects")
    for entry in dict.fromkeys(materials.values()):
        effect = etree.SubElement(library, "effect", id=f"{entry.id}_effect")
        profile = etree.SubElement(effect, "profile_COMMON")
        if entry.texture:
            _sampler(profile, entry.id, images[entry.texture])
        technique = etree.SubElement(profile, "technique", sid="common")
        shader = etree.SubElement(technique, "lambert")
        diffuse = etree.SubElement(shader, "diffuse")
        *rgb, alpha = entry.material.rgba
        if entry.texture:
            etree.SubElement(diffuse, "texture", texture=f"{entry.id}_sampler", texcoord="UV")
        else:
            _text(diffuse, "color", numbers([*rgb, alpha]), sid="diffuse")
        if alpha < 1:
            transparent = etree.SubElement(shader, "transparent", opaque="A_ONE")
            _text(transparent, "color", numbers([1, 1, 1, alpha]))
            _text(etree.SubElement(shader, "transparency"), "float", "1")


def _sampler(profile: etree._Element, name: str, image: str) -> None:
    surface = etree.SubElement(
        etree.SubElement(profile, "newparam", sid=f"{name}_surface"), "surface", type="2D"
    )
    _text(surface, "init_from", image)
    sampler = etree.SubElement(
        etree.SubElement(profile, "newparam", sid=f"{name}_sampler"), "sampler2D"
    )
    _text(sampler, "source", f"{name}_surface")


def _materials(root: etree._Element, materials: dict[int, _Material]) -> None:
    library = etree.SubElement(root, "library_materials")
    for entry in dict.fromkeys(materials.values()):
        name = entry.material.name or entry.id
        material = etree.SubElement(library, "material", id=entry.id, name=_as_name(name))
        etree.SubElement(material, "instance_effect", url=f"#{entry.id}_effect")


def _geometry(library: etree._Element, name: str, part: MeshPart) -> None:
    mesh = etree.SubElement(etree.SubElement(library, "geometry", id=name, name=name), "mesh")
    layers: list[tuple[str, str, Floats, str]] = [("VERTEX", "positions", part.vertices, "XYZ")]
    if part.normals is not None:
        layers.append(("NORMAL", "normals", part.normals, "XYZ"))
    if part.uv is not None:
        layers.append(("TEXCOORD", "uv", part.uv, "ST"))
    if part.colors is not None:
        layers.append(("COLOR", "colors", part.colors, "RGBA"))
    columns = []
    for _, suffix, rows, axes in layers:
        unique, corners = table(rows, part.faces)
        columns.append(corners.reshape(-1))
        _source(mesh, f"{name}_{suffix}", unique, axes)
    vertices = etree.SubElement(mesh, "vertices", id=f"{name}_vertices")
    etree.SubElement(vertices, "input", semantic="POSITION", source=f"#{name}_positions")
    triangles = etree.SubElement(mesh, "triangles", material="surface", count=str(len(part.faces)))
    for offset, (semantic, suffix, _, _) in enumerate(layers):
        source = f"#{name}_{'vertices' if semantic == 'VERTEX' else suffix}"
        reference = etree.SubElement(
            triangles, "input", semantic=semantic, source=source, offset=str(offset)
        )
        if semantic in ("TEXCOORD", "COLOR"):
            reference.set("set", "0")
    corners_in_rows = zip(*(column.tolist() for column in columns), strict=True)
    _text(triangles, "p", " ".join(str(index) for row in corners_in_rows for index in row))


def _source(mesh: etree._Element, name: str, rows: Floats, axes: str) -> None:
    source = etree.SubElement(mesh, "source", id=name)
    _text(source, "float_array", numbers(rows), id=f"{name}_array", count=str(rows.size))
    accessor = etree.SubElement(
        etree.SubElement(source, "technique_common"),
        "accessor",
        source=f"#{name}_array",
        count=str(len(rows)),
        stride=str(len(axes)),
    )
    for axis in axes:
        etree.SubElement(accessor, "param", name=axis, type="float")


def _scene(
    root: etree._Element, parts: list[tuple[int, MeshPart]], materials: dict[int, _Material]
) -> None:
    scenes = etree.SubElement(root, "library_visual_scenes")
    visual_scene = etree.SubElement(scenes, "visual_scene", id="scene")
    for number, part in parts:
        name = f"part_{number + 1}"
        node = etree.SubElement(visual_scene, "node", id=f"{name}_node", name=name)
        instance = etree.SubElement(node, "instance_geometry", url=f"#{name}")
        binding = etree.SubElement(etree.SubElement(instance, "bind_material"), "technique_common")
        material = etree.SubElement(
            binding, "instance_material", symbol="surface", target=f"#{materials[number].id}"
        )
        if part.uv is not None:
            etree.SubElement(
                material,
                "bind_vertex_input",
                semantic="UV",
                input_semantic="TEXCOORD",
                input_set="0",
            )
    scene = etree.SubElement(root, "scene")
    etree.SubElement(scene, "instance_visual_scene", url="#scene")


def _text(parent: etree._Element, tag: str, text: str, **attributes: str) -> None:
    etree.SubElement(parent, tag, **attributes).text = text


def _as_name(text: str) -> str:
    """A valid name for the schema: letters, digits and ``_.-``, a letter first."""
    name = re.sub(r"[^\w.-]", "_", text)
    return name if re.match(r"[^\W\d]", name) else f"_{name}"
