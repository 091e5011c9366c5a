import json
import os
import struct
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from threading import Thread

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.mesh import made
from tests.mesh.made import whole_gltf
from urdfkit.core import cache_directory
from urdfkit.mesh import measure_cache
from urdfkit.mesh.io import facts
from urdfkit.mesh.measure_cache import Store
from urdfkit.mesh.measures import Measures


@pytest.fixture
def mesh(tmp_path: Path) -> Path:
    path = tmp_path / "part.stl"
    path.write_bytes(made.binary_stl())
    return path


@pytest.fixture
def cache(tmp_path: Path) -> Path:
    return tmp_path / "cache"


def entries(cache: Path) -> list[Path]:
    return [path for path in sorted(cache.rglob("*")) if path.is_file()]


def measured(cache: Path | None, path: Path, form: str = facts.BINARY_STL) -> Measures | str:
    return Store(str(cache) if cache else None).measures(str(path), form)


@pytest.fixture
def forbid(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """From now on nothing may be measured."""

    def fail(*_: object) -> None:
        pytest.fail("measured again")

    return lambda: monkeypatch.setattr(measure_cache, "_measured", fail)


def test_the_second_run_measures_nothing(
    mesh: Path, cache: Path, forbid: Callable[[], None]
) -> None:
    first = measured(cache, mesh)
    assert isinstance(first, Measures)
    assert first.triangles == 4
    forbid()
    copy = mesh.with_name("elsewhere.stl")
    copy.write_bytes(mesh.read_bytes())
    assert measured(cache, mesh) == measured(cache, copy) == first
    assert len(entries(cache)) == 1


def test_one_process_measures_a_file_once(mesh: Path, forbid: Callable[[], None]) -> None:
    one = Store(None)
    first = one.measures(str(mesh), facts.BINARY_STL)
    forbid()
    assert one.measures(str(mesh), facts.BINARY_STL) is first
    copy = mesh.with_name("copy.stl")
    copy.write_bytes(mesh.read_bytes())
    assert one.measures(str(copy), facts.BINARY_STL) is first


def test_other_content_is_another_entry(mesh: Path, cache: Path) -> None:
    first = measured(cache, mesh)
    mesh.write_bytes(made.binary_stl([made.TETRAHEDRON[0]]))
    second = measured(cache, mesh)
    assert isinstance(second, Measures)
    assert second != first
    assert second.triangles == 1
    assert len(entries(cache)) == 2


def test_the_reason_of_an_unloadable_mesh_is_kept(
    mesh: Path, cache: Path, forbid: Callable[[], None]
) -> None:
    mesh.write_bytes(b"ISO-10303-21;")
    assert measured(cache, mesh) == "is STEP, which is not supported"
    forbid()
    assert measured(cache, mesh) == "is STEP, which is not supported"


@pytest.mark.parametrize(
    "content", [b"", b"{", b"[]", b"{}", b"7", b'{"triangles": 1}', b"\xff", b"[" * 100_000]
)
def test_a_broken_entry_is_measured_again(mesh: Path, cache: Path, content: bytes) -> None:
    first = measured(cache, mesh)
    (entry,) = entries(cache)
    entry.write_bytes(content)
    assert measured(cache, mesh) == first
    assert json.loads(entry.read_bytes())["triangles"] == 4


def test_a_directory_that_cannot_be_written(mesh: Path, cache: Path) -> None:
    cache.write_text("a file in the way")
    assert isinstance(measured(cache, mesh), Measures)


def test_without_a_directory_nothing_is_written(
    mesh: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = entries(tmp_path)
    assert isinstance(measured(None, mesh), Measures)
    assert entries(tmp_path) == before
    monkeypatch.setenv(cache_directory.VARIABLE, "")
    assert measure_cache.default_directory() is None
    monkeypatch.setenv(cache_directory.VARIABLE, "/somewhere")
    assert measure_cache.default_directory() == "/somewhere/meshes"
    monkeypatch.delenv(cache_directory.VARIABLE)
    assert "urdfkit" in str(measure_cache.default_directory())


def test_a_full_directory_loses_its_older_half(
    mesh: Path, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    measured(cache, mesh)
    (entry,) = entries(cache)
    monkeypatch.setattr(measure_cache, "MAX_DIRECTORY", 10 * 64)
    for number in range(10):
        other = entry.with_name(f"{number}.json")
        other.write_bytes(b"1" * 64)
        os.utime(other, (number, number))
    entry.unlink()
    measured(cache, mesh)
    left = {path.name for path in entries(cache)}
    assert left == {entry.name, *(f"{number}.json" for number in range(5, 10))}


def test_runs_at_the_same_time(mesh: Path, cache: Path) -> None:
    found: list[Measures | str] = []
    threads = [Thread(target=lambda: found.append(measured(cache, mesh))) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 8
    assert len({json.dumps(str(one)) for one in found}) == 1
    assert len(entries(cache)) == 1


def test_materials_belong_to_an_obj_file(tmp_path: Path, cache: Path) -> None:
    path = tmp_path / "part.obj"
    path.write_bytes(made.obj())
    (tmp_path / "a.mtl").write_text("newmtl a\n")
    measured(cache, path, facts.OBJ)
    (tmp_path / "a.mtl").write_text("newmtl b\n")
    measured(cache, path, facts.OBJ)
    assert len(entries(cache)) == 2


def test_buffers_belong_to_a_gltf_file(tmp_path: Path, cache: Path) -> None:
    content = json.loads(whole_gltf())
    content["buffers"][0]["uri"] = "the%20numbers.bin"
    path = tmp_path / "part.gltf"
    path.write_text(json.dumps(content))
    buffer = tmp_path / "the numbers.bin"
    areas = []
    for size in (1.0, 2.0):
        buffer.write_bytes(struct.pack("<9f", 0, 0, 0, size, 0, 0, 0, 1, 0))
        found = measured(cache, path, facts.GLTF)
        assert isinstance(found, Measures)
        areas.append(found.area)
    assert areas == [0.5, 1.0]


def test_a_warm_cache_needs_neither_numpy_nor_trimesh(mesh: Path, cache: Path) -> None:
    measured(cache, mesh)
    code = (
        "import sys; from urdfkit.mesh.measure_cache import Store\n"
        f"found = Store({str(cache)!r}).measures({str(mesh)!r}, 'binary STL')\n"
        "assert found.triangles == 4\n"
        "assert not {'numpy', 'lxml', 'trimesh', 'manifold3d'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
