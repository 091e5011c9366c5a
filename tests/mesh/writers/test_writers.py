"""Every format: what is written is read back by other libraries, and is always the same."""

import os
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from tests.mesh.shapes_made import as_mesh, as_part, as_trimesh, cube
from urdfkit.mesh.geometry import Mesh, MeshMaterial
from urdfkit.mesh.io.load import load
from urdfkit.mesh.transforms import upright
from urdfkit.mesh.writers import SUFFIXES, UnwritableMesh, encode, losses, write

RED = MeshMaterial("red", (1.0, 0.0, 0.0, 1.0))
GLASS = MeshMaterial("clear glass", (0.2, 0.4, 0.6, 0.5))
PARTS = Mesh(
    (
        as_part(trimesh.creation.cylinder(0.1, 0.2, sections=24), RED),
        as_part(trimesh.creation.icosphere(2, 0.1).apply_translation((1, 2, 3)), GLASS),
    )
)


def read(path: Path) -> trimesh.Trimesh:
    """By trimesh, all parts welded."""
    loaded = trimesh.load_mesh(path, process=False)
    loaded.merge_vertices(merge_norm=True, merge_tex=True)
    return loaded


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_what_is_written_is_read_back(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"two parts{suffix}"
    assert write(PARTS, path)[0] == str(path)
    back, expected = read(path), as_trimesh(PARTS)
    assert len(back.faces) == len(expected.faces)
    assert back.is_volume
    assert back.volume == pytest.approx(expected.volume, rel=1e-6)
    assert back.bounds == pytest.approx(expected.bounds, abs=1e-6)
    assert sorted(os.listdir(tmp_path)) == sorted(encode(PARTS, path.name))


@pytest.mark.parametrize("suffix", [".dae", ".obj", ".glb"])
def test_glass_stays_as_clear_as_it_is(suffix: str, tmp_path: Path) -> None:
    mesh = PARTS
    for number in range(3):
        write(mesh, tmp_path / f"{number}{suffix}")
        mesh = load(tmp_path / f"{number}{suffix}")
    materials = sorted((part.material for part in mesh.parts if part.material), key=str)
    assert [material.rgba for material in materials] == [
        pytest.approx((0.2, 0.4, 0.6, 0.5), abs=3e-3),
        pytest.approx((1.0, 0.0, 0.0, 1.0), abs=3e-3),
    ]


@pytest.mark.parametrize("way", [(".glb", ".dae"), (".dae", ".glb"), (".glb", ".glb")])
def test_there_and_back_again_z_stays_upwards(way: tuple[str, str], tmp_path: Path) -> None:
    mesh = PARTS
    for number, suffix in enumerate(way):
        write(mesh, tmp_path / f"{number}{suffix}")
        mesh = load(tmp_path / f"{number}{suffix}")
        assert mesh.up_axis == ("Y_UP" if suffix == ".glb" else "Z_UP")
        assert mesh.vertices.max(axis=0) == pytest.approx(PARTS.vertices.max(axis=0), abs=1e-6)
        assert mesh.vertices.min(axis=0) == pytest.approx(PARTS.vertices.min(axis=0), abs=1e-6)


def test_upright_turns_gltf_as_the_standard_says(tmp_path: Path) -> None:
    write(PARTS, tmp_path / "a.glb")
    turned = upright(load(tmp_path / "a.glb"))
    x, y, _ = PARTS.vertices.max(axis=0)
    _, _, z = -PARTS.vertices.min(axis=0)
    assert turned.vertices.max(axis=0) == pytest.approx((x, z, y), abs=1e-6)
    assert turned.up_axis == "Z_UP"


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_the_same_mesh_gives_the_same_bytes(suffix: str) -> None:
    copy = Mesh(tuple(part._replace(vertices=part.vertices.copy()) for part in PARTS.parts))
    assert encode(PARTS, f"a{suffix}") == encode(copy, f"a{suffix}")


@pytest.mark.parametrize("suffix", [".dae", ".obj", ".glb"])
def test_materials_survive(suffix: str, tmp_path: Path) -> None:
    write(PARTS, tmp_path / f"a{suffix}")
    scene = trimesh.load_scene(tmp_path / f"a{suffix}", process=False)
    colors = sorted(_color(geometry) for geometry in scene.geometry.values())
    assert colors == [pytest.approx((0.2, 0.4, 0.6), abs=3e-3), pytest.approx((1, 0, 0), abs=3e-3)]


def _color(geometry: Any) -> tuple[float, ...]:
    return tuple(np.asarray(geometry.visual.material.main_color)[:3] / 255)


@pytest.mark.parametrize("scale", [1e-5, 1.0, 1e4])
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_size_does_not_matter(suffix: str, scale: float, tmp_path: Path) -> None:
    mesh = as_mesh(trimesh.creation.icosphere(2, scale))
    write(mesh, tmp_path / f"ball{suffix}")
    back = trimesh.load_mesh(tmp_path / f"ball{suffix}", process=False)
    volume = trimesh.Trimesh(back.vertices / scale, back.faces, process=False).volume
    assert volume == pytest.approx(as_trimesh(mesh).volume / scale**3, rel=1e-5)


def test_what_cannot_be_written_is_said() -> None:
    with pytest.raises(UnwritableMesh, match=r"a\.step: unsupported suffix"):
        encode(cube(), "a.step")
    with pytest.raises(UnwritableMesh, match="no triangles"):
        encode(Mesh(()), "a.stl")
    for number in (np.nan, np.inf, 1e40):  # the last is infinite where numbers have 32 bits
        broken = cube()
        broken.parts[0].vertices[0, 0] = number
        with pytest.raises(UnwritableMesh, match="not finite, or absurdly far away"):
            encode(broken, "a.stl")
    lost = cube()._replace(
        parts=(cube().parts[0]._replace(material=MeshMaterial("m", texture="/no/such.png")),)
    )
    with pytest.raises(UnwritableMesh, match=r"such\.png: cannot be read"):
        encode(lost, "a.dae")


def test_what_a_format_cannot_hold_is_reported() -> None:
    assert losses(PARTS, "a.stl") == ["materials"]
    assert losses(PARTS, "a.ply") == ["materials", "the division into parts"]
    assert losses(PARTS, "a.dae") == losses(PARTS, "a.obj") == losses(PARTS, "a.glb") == []


def test_missing_directories_are_made(tmp_path: Path) -> None:
    path = tmp_path / "new" / "directory" / "a.obj"
    mtl = str(path.with_suffix(".mtl"))
    assert write(PARTS, path) == [str(path), mtl]
    assert path.is_file()
