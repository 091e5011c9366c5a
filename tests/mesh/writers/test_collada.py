"""COLLADA: valid by the schema, and alike in every library that reads it."""

import io
from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("PIL")
pytest.importorskip("collada")
pytest.importorskip("lxml")
pytest.importorskip("trimesh")

import collada
import numpy as np
import trimesh
from collada.schema import ColladaValidator
from lxml import etree
from PIL import Image

from tests.mesh.shapes_made import as_part
from tests.mesh.writers.test_writers import GLASS, PARTS
from urdfkit.mesh.geometry import Mesh, MeshMaterial
from urdfkit.mesh.parts import PARTS as REAL_PARTS
from urdfkit.mesh.parts import RealPart
from urdfkit.mesh.writers import encode, write


def picture(color: tuple[int, int, int]) -> bytes:
    file = io.BytesIO()
    Image.new("RGB", (2, 2), color).save(file, "PNG")
    return file.getvalue()


def textured(data: bytes, name: str = "photo") -> Mesh:
    part = as_part(trimesh.creation.box(), MeshMaterial(name, texture=data))
    return Mesh((part._replace(uv=part.vertices[:, :2] + 0.5),))


COLORED = Mesh(
    (
        as_part(trimesh.creation.box())._replace(colors=np.full((8, 4), 0.25)),
        textured(picture((255, 0, 0))).parts[0],
        *PARTS.parts,
    )
)


def assert_valid(data: bytes) -> None:
    validator = ColladaValidator()
    valid = validator.validate(etree.fromstring(data))
    assert valid, validator.COLLADA_SCHEMA_1_4_1_INSTANCE.error_log


@pytest.mark.parametrize("mesh", [PARTS, COLORED], ids=["plain", "textures and colours"])
def test_it_is_valid_and_pycollada_reads_it_without_an_error(mesh: Mesh) -> None:
    data = encode(mesh, "a.dae")["a.dae"]
    assert_valid(data)
    document = collada.Collada(io.BytesIO(data))
    assert document.errors == []
    assert (document.assetInfo.unitmeter, document.assetInfo.upaxis) == (1.0, "Z_UP")
    triangles = [
        primitive
        for geometry in document.scene.objects("geometry")
        for primitive in geometry.primitives()
    ]
    assert sum(len(primitive) for primitive in triangles) == len(mesh.faces)
    assert all(primitive.normal is not None for primitive in triangles)


def test_names_that_the_schema_forbids() -> None:
    names = ("1 red & <blue>", "ünï", "\x00", "-")
    parts = tuple(as_part(trimesh.creation.box(), MeshMaterial(name)) for name in names)
    assert_valid(encode(Mesh(parts), "a.dae")["a.dae"])


def test_normals_are_sharp_at_edges_and_smooth_between() -> None:
    cylinder = Mesh((as_part(trimesh.creation.cylinder(1.0, 2.0, sections=32)),))
    document = collada.Collada(io.BytesIO(encode(cylinder, "a.dae")["a.dae"]))
    (primitive,) = next(iter(document.scene.objects("geometry"))).primitives()
    normals = primitive.normal[primitive.normal_index]
    corners = primitive.vertex[primitive.vertex_index]
    ends = np.abs(normals[..., 2]) > 0.5
    assert np.abs(normals[ends][:, 2]) == pytest.approx(1.0)
    radial = corners[~ends][:, :2]
    assert normals[~ends][:, :2] == pytest.approx(radial, abs=1e-6)


def test_transparency_is_the_same_for_assimp() -> None:
    data = encode(Mesh((as_part(trimesh.creation.box(), GLASS),)), "a.dae")["a.dae"]
    (effect,) = collada.Collada(io.BytesIO(data)).effects
    assert effect.diffuse == pytest.approx(GLASS.rgba)
    assert (effect.opaque_mode, effect.transparent[3]) == ("A_ONE", 0.5)


def test_textures_lie_beside_it_each_once(tmp_path: Path) -> None:
    red, blue = picture((255, 0, 0)), picture((0, 0, 255))
    parts = [textured(data, name).parts[0] for data, name in ((red, "a"), (red, "b"), (blue, "c"))]
    paths = write(Mesh(tuple(parts)), tmp_path / "x.dae")
    assert [Path(path).name for path in paths] == ["x.dae", "x.png", "x_2.png"]
    assert Path(paths[1]).read_bytes() == red
    assert Path(paths[2]).read_bytes() == blue
    assert_valid(Path(paths[0]).read_bytes())
    scene = trimesh.load_scene(tmp_path / "x.dae")
    images = {
        geometry.visual.material.baseColorTexture.getpixel((0, 0))[:3]
        for geometry in scene.geometry.values()
    }
    assert images == {(255, 0, 0), (0, 0, 255)}


@pytest.mark.parametrize("part", REAL_PARTS, ids=lambda part: part.key)
def test_the_parts_are_valid(part: RealPart) -> None:
    data = encode(part.build(), "a.dae")["a.dae"]
    assert_valid(data)
    assert collada.Collada(io.BytesIO(data)).errors == []
