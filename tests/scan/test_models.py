"""What the sources of a scan stand for."""

import errno
import re
import shutil
import tarfile
import zipfile
from pathlib import Path
from types import SimpleNamespace

import pytest

from tests.workspaces import add_files
from urdfkit.errors import UnreadableFile, UnwritableFile
from urdfkit.scan.models import Extraction, models, require_sources


@pytest.fixture
def zoo(tmp_path: Path) -> Path:
    names = ("b/x.urdf", "a/y.URDF", "a/z.urdf.xacro", "a/mesh.stl", ".git/old.urdf")
    add_files(tmp_path / "zoo", dict.fromkeys(names, "<robot/>"))
    return tmp_path / "zoo"


def names(*sources: Path | str, below: Path) -> list[str]:
    return [model.name.removeprefix(f"{below}/") for model in models(map(str, sources))]


def problem(source: Path) -> str:
    """Why a source cannot be read."""
    (model,) = models([str(source)])
    assert model.name == str(source) or "contains itself" in model.problem
    return model.problem


def test_a_directory_stands_for_its_descriptions(zoo: Path) -> None:
    assert names(zoo, below=zoo) == ["a/y.URDF", "a/z.urdf.xacro", "b/x.urdf"]


def test_a_xacro_file_of_a_directory_is_a_robot_if_it_has_a_name(zoo: Path) -> None:
    space = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    (zoo / "robot.xacro").write_text(f'<?xml version="1.0"?>\n<robot {space}\n  name="r"/>')
    (zoo / "macros.xacro").write_text(f'<robot {space}><link name="a"/></robot>')
    found = sorted(names(zoo, below=zoo))
    assert found == ["a/y.URDF", "a/z.urdf.xacro", "b/x.urdf", "robot.xacro"]


def test_a_file_counts_whatever_it_is_called(zoo: Path) -> None:
    assert names(zoo / "a" / "mesh.stl", below=zoo) == ["a/mesh.stl"]


def test_a_glob(zoo: Path) -> None:
    assert names(f"{zoo}/**/*.urdf", below=zoo) == ["b/x.urdf"]
    assert sorted(names(f"{zoo}/*", below=zoo)) == ["a/y.URDF", "a/z.urdf.xacro", "b/x.urdf"]


def test_a_list_has_sources_relative_to_itself(zoo: Path) -> None:
    (zoo / "some.txt").write_text("# chosen\nb/x.urdf\n\na\n")
    assert names(zoo / "some.txt", below=zoo) == ["b/x.urdf", "a/y.URDF", "a/z.urdf.xacro"]


@pytest.mark.parametrize("suffix", [".zip", ".tar", ".tar.gz"])
def test_an_archive_is_extracted_when_a_model_is_wanted(zoo: Path, suffix: str) -> None:
    archive = zoo.parent / f"zoo{suffix}"
    if suffix == ".zip":
        with zipfile.ZipFile(archive, "w") as packed:
            for file in ("a/y.URDF", "a/mesh.stl", "b/x.urdf"):
                packed.write(zoo / file, file)
    else:
        with tarfile.open(archive, "w:gz" if suffix.endswith("gz") else "w") as tar:
            tar.add(zoo, "./")
    found = [model for model in models([str(archive)]) if not model.name.endswith("xacro")]
    ours = [model for model in found if "/." not in model.name.removeprefix(str(archive))]
    assert [model.name for model in ours] == [f"{archive}/a/y.URDF", f"{archive}/b/x.urdf"]
    with Extraction() as extraction:
        path = Path(extraction.on_disk(ours[0]).path)
        assert path.read_text() == "<robot/>"
        assert path.with_name("mesh.stl").exists()
    assert not path.exists()


@pytest.mark.parametrize("suffix", [".zip", ".tar.xz"])
def test_a_xacro_file_of_an_archive_is_a_robot_if_it_has_a_name(
    tmp_path: Path, suffix: str
) -> None:
    folder = tmp_path / "in"
    folder.mkdir()
    (folder / "robot.xacro").write_text('<?xml version="1.0"?>\n<robot\n  name="r"/>')
    (folder / "macros.xacro").write_text('<robot><link name="a"/></robot>')
    packing = "zip" if suffix == ".zip" else "xztar"
    archive = shutil.make_archive(str(tmp_path / "zoo"), packing, folder)
    assert names(archive, below=tmp_path) == [f"zoo{suffix}/robot.xacro"]


def test_an_archive_names_no_file_outside_of_it(tmp_path: Path) -> None:
    (tmp_path / "secret.urdf").write_text("<robot/>")
    with zipfile.ZipFile(tmp_path / "a.zip", "w") as packed:
        for name in (f"../..{tmp_path}/secret.urdf", str(tmp_path / "secret.urdf"), "..b.urdf"):
            packed.writestr(name, "<robot/>")
    found = list(models([str(tmp_path / "a.zip")]))
    assert [model.name for model in found] == [f"{tmp_path}/a.zip/..b.urdf"]


@pytest.mark.parametrize("text", ["some.txt\n", "*.txt\n", "a\0b\n"])
def test_a_list_that_has_no_end_or_is_none(zoo: Path, text: str) -> None:
    (zoo / "some.txt").write_text(text)
    assert re.search("contains itself|not a list", problem(zoo / "some.txt"))


def test_entries_of_a_list_that_cannot_be_read_are_rows(zoo: Path) -> None:
    (zoo / "some.txt").write_text("none.urdf\nnone*\nb/x.urdf\n")
    missing, no_match, model = models([str(zoo / "some.txt")])
    assert "file not found" in missing.problem
    assert "no file matches" in no_match.problem
    assert (model.path, model.problem) == (str(zoo / "b" / "x.urdf"), "")


@pytest.mark.parametrize("suffix", [".zip", ".tar.gz"])
def test_a_bomb_is_not_extracted(
    suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("urdfkit.scan.archives._LARGE", 10**6)
    (tmp_path / "zeros").write_bytes(bytes(2 * 10**6))
    archive = tmp_path / f"bomb{suffix}"
    if suffix == ".zip":
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
            packed.write(tmp_path / "zeros")
    else:
        with tarfile.open(archive, "w:gz") as tar:
            tar.add(tmp_path / "zeros")
    assert "over 100 times" in problem(archive)


def test_holes_of_a_sparse_tar_count_as_bytes(tmp_path: Path) -> None:
    """A member of 3 GB takes 10 kB in the archive; what it becomes is what fills a disk."""
    size = 3 * 10**9
    header = tarfile.TarInfo("a.urdf")
    header.size = 0
    header.pax_headers = {
        "GNU.sparse.map": f"{size},0", "GNU.sparse.size": str(size), "GNU.sparse.name": "a.urdf"
    }  # fmt: skip
    with tarfile.open(tmp_path / "sparse.tar", "w", format=tarfile.PAX_FORMAT) as tar:
        tar.addfile(header)
    assert "more than 2.0 GB when extracted" in problem(tmp_path / "sparse.tar")


@pytest.mark.parametrize("name", ["{}.txt", "{}/a/a/a/a/a/a/a/a/a/a/a.txt"])
@pytest.mark.parametrize("suffix", [".zip", ".tar.gz"])
def test_an_archive_of_empty_files_is_not_extracted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, suffix: str
) -> None:
    monkeypatch.setattr("urdfkit.scan.archives._MAX_MEMBERS", 100)
    number = 400 if name == "{}.txt" else 40
    archive = tmp_path / f"many{suffix}"
    if suffix == ".zip":
        with zipfile.ZipFile(archive, "w") as packed:
            for index in range(number):
                packed.writestr(name.format(index), "")
    else:
        with tarfile.open(archive, "w:gz") as tar:
            for index in range(number):
                tar.addfile(tarfile.TarInfo(name.format(index)))
    assert "files and directories" in problem(archive)


def test_nothing_of_an_archive_is_written_elsewhere(tmp_path: Path) -> None:
    """Neither by its names nor through its links."""
    outside = tmp_path / "outside"
    outside.mkdir()
    with tarfile.open(tmp_path / "a.tar", "w") as tar:
        tar.addfile(tarfile.TarInfo("a.urdf"))
        link = tarfile.TarInfo("link")
        link.type, link.linkname = tarfile.SYMTYPE, str(outside)
        tar.addfile(link)
        tar.addfile(tarfile.TarInfo("link/b.urdf"))
    with zipfile.ZipFile(tmp_path / "a.zip", "w") as packed:
        for name in ("a.urdf", "../../outside/b.urdf", f"{outside}/c.urdf"):
            packed.writestr(name, "<robot/>")
    for name in ("a.tar", "a.zip"):
        with Extraction() as extraction:
            found = list(models([str(tmp_path / name)]))
            for model in found:
                extraction.on_disk(model)
                if name == "a.tar":
                    assert Path(extraction.on_disk(model).path).is_file()  # without the link
    assert list(outside.iterdir()) == []


def test_a_damaged_archive_is_a_model_with_a_problem(tmp_path: Path) -> None:
    (tmp_path / "a.zip").write_bytes(b"PK\3\4 no archive")
    assert "not a readable archive" in problem(tmp_path / "a.zip")


def test_a_missing_source_is_an_error(zoo: Path) -> None:
    require_sources([str(zoo), str(zoo / "b" / "x.urdf"), f"{zoo}/*"])
    with pytest.raises(UnreadableFile, match=r"file not found; did you mean 'x\.urdf'"):
        require_sources([str(zoo / "b" / "xx.urdf")])
    with pytest.raises(UnreadableFile, match="no file matches"):
        require_sources([f"{zoo}/none*"])


@pytest.mark.parametrize("full", [True, False], ids=["too large", "full meanwhile"])
def test_a_full_disk_ends_the_scan(zoo: Path, full: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """A row would be kept, and the archive not checked when there is room."""
    archive = shutil.make_archive(str(zoo), "zip", zoo)
    model, *_ = models([archive])

    def extract(*_: object) -> None:
        raise OSError(errno.ENOSPC, "no space left")

    monkeypatch.setattr("shutil.disk_usage", lambda _: SimpleNamespace(free=0 if full else 10**9))
    monkeypatch.setattr("zipfile.ZipFile.extractall", extract)
    with Extraction() as extraction, pytest.raises(UnwritableFile, match=r"are free|no space"):
        extraction.on_disk(model)


@pytest.mark.parametrize("kind", [tarfile.GNUTYPE_LONGNAME, tarfile.XHDTYPE])
def test_headers_of_a_tar_do_not_fill_the_memory(kind: bytes, tmp_path: Path) -> None:
    header = tarfile.TarInfo("header")
    header.type, header.size = kind, 2**20 + 1
    archive = tmp_path / "a.tar"
    archive.write_bytes(header.tobuf(tarfile.GNU_FORMAT) + bytes(2**21))
    assert "it has a header of 1,048,577 bytes" in problem(archive)


def test_a_name_with_a_nul_is_not_extracted(tmp_path: Path) -> None:
    with tarfile.open(tmp_path / "a.tar", "w", format=tarfile.PAX_FORMAT) as tar:
        tar.addfile(member := tarfile.TarInfo("a.urdf"))
        member.pax_headers = {"path": "b\0.urdf"}
        tar.addfile(member)
    _cannot_be_extracted(tmp_path / "a.tar")


def test_damaged_lzma_is_an_error(tmp_path: Path) -> None:
    pytest.importorskip("lzma")
    archive = tmp_path / "a.zip"
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_LZMA) as packed:
        packed.writestr("a.urdf", "<robot/>" * 100)
    data = bytearray(archive.read_bytes())
    data[45:60] = b"\xff" * 15
    archive.write_bytes(data)
    _cannot_be_extracted(archive)


def _cannot_be_extracted(archive: Path) -> None:
    with Extraction() as extraction:
        first, *_ = models([str(archive)])
        for _ in range(2):  # it is not tried again
            assert "cannot be extracted" in extraction.on_disk(first).problem
