"""The model in a page: what the file holds is what the robot is made of."""

import json
from io import BytesIO
from pathlib import Path
from typing import Any

import pytest

from tests.shipped import ARM, MISSION
from urdfkit.lint.loading import read

np = pytest.importorskip("numpy")
trimesh = pytest.importorskip("trimesh")

from PIL import Image

from urdfkit.output.report import gltf, scene
from urdfkit.render import scene as pictured

KINDS = {5120: "i1", 5121: "u1", 5123: "u2", 5125: "u4", 5126: "f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def opened(data: bytes) -> tuple[dict[str, Any], bytes]:
    assert data[:4] == b"glTF"
    assert int.from_bytes(data[4:8], "little") == 2
    assert int.from_bytes(data[8:12], "little") == len(data)
    length = int.from_bytes(data[12:16], "little")
    assert data[16:20] == b"JSON"
    assert length % 4 == 0
    return json.loads(data[20 : 20 + length]), data[28 + length :]


def values(document: dict[str, Any], data: bytes, number: int) -> Any:
    """The rows of an accessor, by the words of the specification."""
    accessor = document["accessors"][number]
    view = document["bufferViews"][accessor["bufferView"]]
    kind = np.dtype(KINDS[accessor["componentType"]])
    width = WIDTHS[accessor["type"]]
    stride = view.get("byteStride", width * kind.itemsize)
    assert stride % 4 == 0 or "byteStride" not in view
    raw = data[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    assert len(raw) == view["byteLength"] == stride * accessor["count"]
    rows = np.frombuffer(raw, np.uint8).reshape(accessor["count"], stride)
    found = np.ascontiguousarray(rows[:, : width * kind.itemsize]).view(kind)
    if accessor.get("normalized"):
        found = found / {"i1": 127, "u1": 255, "u2": 65535}[kind.str[1:]]
    return found


@pytest.mark.parametrize("robot", [MISSION, ARM], ids=["mission", "arm"])
def test_the_surfaces_are_those_of_the_robot(robot: str) -> None:
    items = pictured.build(read(robot), roles=("visual", "collision")).items
    data, triangles = gltf.write(items)
    document, binary = opened(data)
    assert triangles == sum(len(item.faces) for item in items)
    assert len(document["nodes"]) == len(items)
    for node, item in zip(document["nodes"], items, strict=True):
        assert (node["extras"]["link"], node["extras"]["role"]) == (item.link, item.role)
        (primitive,) = document["meshes"][node["mesh"]]["primitives"]
        scale, low = node["scale"][0], np.array(node["translation"])
        points = values(document, binary, primitive["attributes"]["POSITION"]) * scale + low
        faces = values(document, binary, primitive["indices"]).reshape(-1, 3)
        assert faces.max() == len(points) - 1
        expected = item.vertices[item.faces]
        assert np.abs(points[faces] - expected).max() <= scale / 65535
        if item.normals is not None:
            normals = values(document, binary, primitive["attributes"]["NORMAL"])[faces]
            assert np.abs(normals - item.normals[item.faces]).max() <= 1 / 127


def test_surfaces_that_are_alike_share_their_bytes() -> None:
    items = pictured.build(read(MISSION)).items
    document, _ = opened(gltf.write(items)[0])
    wheels = {n["mesh"] for n in document["nodes"] if n["extras"]["link"].startswith("wheel")}
    assert len(wheels) == 1


def test_a_second_reader_takes_it(tmp_path: Path) -> None:
    file = tmp_path / "robot.glb"
    items = pictured.build(read(MISSION)).items
    file.write_bytes(gltf.write(items)[0])
    loaded = trimesh.load_scene(file)
    assert sum(len(mesh.faces) for mesh in loaded.geometry.values()) > 0
    document, _ = opened(file.read_bytes())
    from trimesh.exchange.gltf import validate

    pytest.importorskip("jsonschema")
    validate(document)


def test_colours_are_linear() -> None:
    """sRGB 0.5 is linear 0.2140 (IEC 61966-2-1)."""
    assert gltf._linear(0.5) == pytest.approx(0.21404, abs=1e-5)
    assert gltf._linear(0.04) == pytest.approx(0.04 / 12.92)


def test_textures_travel_along_and_other_files_do_not(tmp_path: Path) -> None:
    from urdfkit.ros.surface_materials import SurfaceMaterial

    item = pictured.build(read(MISSION)).items[0]
    png = b"\x89PNG\r\n\x1a\n" + bytes(20)
    (tmp_path / "a.png").write_bytes(png)
    (tmp_path / "secret").write_bytes(b"password")
    uv = np.zeros((len(item.vertices), 2), np.float32)
    for texture, images in (
        (str(tmp_path / "a.png"), 1),
        (png, 1),
        (str(tmp_path / "secret"), 0),
        (str(tmp_path / "none"), 0),
    ):
        material = SurfaceMaterial((1.0, 1.0, 1.0, 1.0), texture)
        data = gltf.write([item._replace(material=material, uv=uv)])[0]
        assert len(opened(data)[0].get("images", ())) == images
        assert b"password" not in data


@pytest.mark.parametrize("suffix", ["bmp", "tga", "tiff", "webp"])
def test_what_no_browser_shows_travels_as_a_jpeg(suffix: str, tmp_path: Path) -> None:
    from urdfkit.ros.surface_materials import SurfaceMaterial

    path = tmp_path / f"a.{suffix}"
    Image.new("RGB", (64, 32), (200, 100, 0)).save(path)
    item = pictured.build(read(MISSION)).items[0]
    uv = np.zeros((len(item.vertices), 2), np.float32)
    data = gltf.write(
        [item._replace(material=SurfaceMaterial((1.0, 1.0, 1.0, 1.0), str(path)), uv=uv)]
    )[0]
    document, chunk = opened(data)
    view = document["bufferViews"][document["images"][0]["bufferView"]]
    file = chunk[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    with Image.open(BytesIO(file)) as image:
        assert (image.format, image.size) == ("JPEG", (64, 32))
        red, green, blue = np.asarray(image.convert("RGB"))[5, 5]
    assert red > green > blue


def test_points_that_are_not_finite_are_left_out() -> None:
    item = pictured.build(read(MISSION)).items[0]
    vertices = item.vertices.copy()
    vertices[item.faces[0, 0]] = np.nan
    _, triangles = gltf.write([item._replace(vertices=vertices)])
    assert 0 < triangles < len(item.faces)
    assert gltf.write([item._replace(vertices=vertices * np.nan)])[1] == 0


def test_nothing_is_a_file_too() -> None:
    document, _ = opened(gltf.write([])[0])
    assert document["scenes"] == [{}]
    assert scene.nothing().robot["links"] == []
