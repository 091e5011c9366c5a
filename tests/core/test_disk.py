"""The gate to the files that are read on behalf of a robot."""

import ast
import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import ROOT
from urdfkit.core import disk, file_log
from urdfkit.core.file_log import FileLog

PACKAGE = ROOT / "urdfkit"

#: What opens, asks for or lists files, besides ``open``.
_ASKS = {
    *("io.open", "os.open", "os.stat", "os.lstat", "os.listdir", "os.scandir", "os.walk"),
    *("os.readlink", "os.access", "np.load", "np.fromfile", "trimesh.load"),
    *(
        f"os.path.{name}"
        for name in "exists lexists isfile isdir islink realpath getsize getmtime samefile".split()
    ),
}
#: Modules that ask for files themselves, and why: none is named by a robot, or it is not read.
WITHOUT_GATE = {
    "core/cache_entries.py": "entries of the cache",
    "core/disk.py": "the gate",
    "core/file_log.py": "the gate, asked again",
    "core/atomic.py": "writes",
    "core/installation.py": "urdfkit's own",
    "core/limits.py": "the size of this process",
    "core/regular_file.py": "what the gate opens",
    "core/temporary.py": "its own directories",
    "cli": "files that the user names on the command line",
    "lint/discovery.py": "os.access of launch files",
    "lint/rule_examples.py": "writes examples",
    "lint/rule_index.py": "urdfkit's own",
    "lsp": "places of files that are open or were read",
    "output/comparison/states.py": "files that the user names on the command line",
    "output/formats/__init__.py": "urdfkit's own",
    "output/package_templates/__init__.py": "urdfkit's own, and its output",
    "output/report/html.py": "urdfkit's own",
    "mesh/parts": "urdfkit's own",
    "output/bundle/writing.py": "its own output",
    "output/conversion/usd.py": "its own temporary directory",
    "output/conversion/mjcf.py": "its own output",
    "output/conversion/text_reading.py": "the null device",
    "output/comparison/__init__.py": "its own temporary directory",
    "output/report/translations.py": "urdfkit's own",
    "ros/catalog/__init__.py": "urdfkit's own",
    "scan": "models that the user names, and its own output",
    "text/urdf_extensions.py": "urdfkit's own",
    "viewer/state.py": "times of files that were read",
    "workspace/revisions.py": "git",
    "workspace/ros_packages.py": "urdfkit's own",
    "workspace/snapshots.py": "git",
    "xacro/watchdog.py": "the size of this process",
}


def _calls(path: Path) -> Iterator[str]:
    """Where a module asks for files by itself."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Call):
            is_asking = isinstance(node.func, ast.Name) and node.func.id == "open"
        else:
            is_asking = isinstance(node, ast.Attribute) and ast.unparse(node) in _ASKS
        if is_asking and isinstance(node, ast.expr):
            yield f"{path.relative_to(PACKAGE)}:{node.lineno}: {ast.unparse(node)}"


def test_nothing_is_read_past_the_gate() -> None:
    exempt = [PACKAGE / one for one in WITHOUT_GATE]
    modules = [
        path
        for path in sorted(PACKAGE.rglob("*.py"))
        if not any(path == one or one in path.parents for one in exempt)
    ]
    assert [call for path in modules for call in _calls(path)] == []


#: Modules that read a file by the gate, and who has seen that it may be read: a module that is new
#: here reads what a model names only after ``Resolver`` or ``referenced_files`` has admitted it.
ADMITTED = "Resolver.locate"
IN_PACKAGE = "found by its name in a package or workspace"
NAMED = "named by the user"
READERS = {
    "checks/bringup/published_frames.py": IN_PACKAGE,
    "checks/gazebo/gaz007_unknown_material.py": "Resolver.allows",
    "checks/mesh_contents/msh007_unsupported_format.py": ADMITTED,
    "checks/package/build_files.py": IN_PACKAGE,
    "checks/package/component_names.py": ADMITTED,
    "checks/package/pkg005_invalid_package.py": IN_PACKAGE,
    "checks/worlds/model_paths.py": IN_PACKAGE,
    "cli/collisions/__init__.py": NAMED,
    "cli/expand.py": NAMED,
    "cli/init.py": NAMED,
    "core/atomic.py": "what is about to be replaced",
    "lint/argument_values.py": IN_PACKAGE,
    "lint/baseline.py": NAMED,
    "lint/config_reader.py": "named by the user, or the nearest above a file",
    "lint/discovery.py": IN_PACKAGE,
    "lint/fix_reasons.py": "a source that was read before",
    "lint/formatting.py": "Ownership",
    "lint/parameter_files.py": "Resolver.admits",
    "lint/settings_table.py": "config_reader, for the line of an error",
    "mesh/io/load.py": ADMITTED,
    "mesh/io/referenced_files.py": "itself",
    "mesh/io/sniff.py": ADMITTED,
    "mesh/measure_cache.py": ADMITTED,
    "mesh/writers/textures.py": "referenced_files",
    "output/bundle/__init__.py": ADMITTED,
    "output/bundle/meshes.py": ADMITTED,
    "output/comparison/states.py": NAMED,
    "output/comparison/surfaces.py": ADMITTED,
    "output/conversion/sdf.py": "its own output",
    "output/report/gltf.py": ADMITTED,
    "physics/poses.py": NAMED,
    "render/textures.py": ADMITTED,
    "robot/assets/collision_shapes.py": "next to a mesh that was read before",
    "robot/assets/mesh_files.py": ADMITTED,
    "ros/gazebo/paths.py": IN_PACKAGE,
    "ros/launch/known_packages.py": IN_PACKAGE,
    "ros/moveit/srdf_variant.py": IN_PACKAGE,
    "testing/__init__.py": NAMED,
    "text/editing/rewriting.py": "a source that was read before",
    "text/source.py": "who calls Source.read",
    "workspace/cmake.py": "who calls cmake_text",
    "workspace/config_file.py": "the nearest above a file",
    "workspace/environment_hooks.py": IN_PACKAGE,
    "workspace/executables.py": IN_PACKAGE,
    "workspace/file_head.py": "who calls read_head",
    "workspace/gitignore.py": IN_PACKAGE,
    "workspace/includes.py": IN_PACKAGE,
    "workspace/install_rules.py": IN_PACKAGE,
    "workspace/installs.py": IN_PACKAGE,
    "workspace/manifest.py": IN_PACKAGE,
    "workspace/package_directories.py": IN_PACKAGE,
    "workspace/plugin_descriptions.py": IN_PACKAGE,
    "workspace/python_installs.py": IN_PACKAGE,
    "workspace/resolve.py": "itself",
    "workspace/srdf_files.py": IN_PACKAGE,
    "workspace/program_strings.py": ADMITTED,
    "workspace/submodules.py": IN_PACKAGE,
    "xacro/file_reader.py": "Resolver.allows",
    "xacro/fragment.py": IN_PACKAGE,
}


def _readers() -> set[str]:
    """Modules that read files by the gate."""
    calls = ("disk.read", "disk.contents", "read_head", "head_text", "cmake_text", "Source.read")
    found = set()
    for path in sorted(PACKAGE.rglob("*.py")):
        text = path.read_text()
        if not any(call in text for call in calls):  # most: parsing them takes 2 s
            continue
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.Call) and ast.unparse(node.func) in calls:
                found.add(path.relative_to(PACKAGE).as_posix())
    return found


def test_a_new_reader_says_who_has_admitted_its_files() -> None:
    assert _readers() == set(READERS)


@pytest.fixture
def log() -> Iterator[FileLog]:
    log = FileLog()
    disk.log_to(log)
    yield log
    disk.log_to(None)


def test_what_is_asked_for_is_noted(
    log: FileLog, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ARM", "left")
    Path("a.stl").write_bytes(b"solid")
    Path("to").symlink_to("a.stl")
    assert disk.read("a.stl", 3) == b"sol"
    with pytest.raises(FileNotFoundError):
        disk.read("b.stl")
    assert disk.state("to").st_size == 5
    assert (disk.exists("a.stl"), disk.is_file("b.stl"), disk.is_directory(".")) == (
        True,
        False,
        True,
    )
    assert (disk.is_link("to"), disk.has_name("b.stl")) == (True, False)
    assert sorted(disk.names(".")) == ["a.stl", "to"]
    assert [sorted(inside) for _, _, inside in disk.walk(".")] == [["a.stl", "to"]]
    assert disk.real("to") == str(tmp_path / "a.stl")
    assert disk.Environment().get("ARM") == "left"
    assert disk.Environment().get("LEG") is None
    assert log.is_complete
    assert list(log.answers) == [
        ("r3", "a.stl"),
        ("r-1", "b.stl"),
        ("s", "to"),
        ("k", "a.stl"),
        ("k", "b.stl"),
        ("k", "."),
        ("l", "to"),
        ("l", "b.stl"),
        ("d", "."),
        ("k", "./to"),
        ("p", "to"),
        ("v", "ARM"),
        ("v", "LEG"),
    ]


def test_a_name_with_a_nul_is_no_file(log: FileLog) -> None:
    assert not disk.exists("a\0b")
    assert not disk.has_name("a\0b")
    with pytest.raises(ValueError, match="null"):
        disk.read("a\0b")
    assert log.answers == {}


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
def test_only_regular_files_are_opened(log: FileLog, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "device").symlink_to("/dev/zero")
    for name, reason in (("pipe", "is a pipe"), ("device", "is a device"), ("", "directory")):
        with pytest.raises(OSError, match=reason):
            disk.read(tmp_path / name)
        assert log.answers["r-1", str(tmp_path / name)] == file_log.NOTHING


@pytest.mark.skipif(not os.path.exists("/dev/fd"), reason="needs /dev/fd")
def test_a_pipe_of_the_shell_is_read_to_its_end_and_once(log: FileLog) -> None:
    reading, writing = os.pipe()
    with open(writing, "wb") as file:
        file.write(b"data")
    assert disk.read(f"/dev/fd/{reading}") == b"data"
    os.close(reading)
    assert not log.is_complete


def test_a_whole_file_is_no_longer_than_the_limit(tmp_path: Path) -> None:
    with (tmp_path / "long").open("wb") as file:
        file.truncate(disk.MAX_BYTES + 1)
    with pytest.raises(OSError, match="larger than 128 MiB"):
        disk.read(tmp_path / "long")
    assert disk.read(tmp_path / "long", 3) == bytes(3)


def test_another_process_may_have_noted_more(log: FileLog) -> None:
    other = FileLog()
    other.variable("ARM", "left")
    other.is_complete = False
    log.add(other)
    assert log.answers == {("v", "ARM"): "=left"}
    assert not log.is_complete


def test_so_many_answers_are_not_kept(log: FileLog, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(file_log, "MAX_ANSWERS", 10)
    for number in range(11):
        disk.exists(f"/none/{number}")
    assert not log.is_complete
    assert log.answers == {}


def test_what_changes_in_between_has_no_one_answer(log: FileLog, tmp_path: Path) -> None:
    path = str(tmp_path / "a")
    assert not disk.exists(path)
    Path(path).touch()
    assert disk.exists(path)
    assert not log.is_complete


def test_the_names_in_a_directory_that_may_be_missing(tmp_path: Path) -> None:
    (tmp_path / "a.stl").write_text("")
    assert disk.names_or_empty(str(tmp_path)) == ["a.stl"]
    assert disk.names_or_empty(str(tmp_path / "none")) == disk.names_or_empty("\0") == []
