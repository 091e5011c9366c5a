"""The gate to the files that are read on behalf of a robot."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import ROOT
from urdfkit.core import disk

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
    "core/disk.py": "the gate",
    "core/atomic.py": "writes",
    "cli": "files that the user names on the command line",
    "lint/discovery.py": "os.access of launch files",
    "lint/rule_examples.py": "writes examples",
    "lint/rule_index.py": "urdfkit's own",
    "lsp": "places of files that are open or were read",
    "mesh/measure_cache.py": "entries of the cache",
    "output/comparison/states.py": "files that the user names on the command line",
    "output/formats/__init__.py": "urdfkit's own",
    "output/report/html.py": "urdfkit's own",
    "output/report/translations.py": "urdfkit's own",
    "ros/catalog/__init__.py": "urdfkit's own",
    "text/urdf_extensions.py": "urdfkit's own",
    "viewer/state.py": "times of files that were read",
    "workspace/revisions.py": "git",
    "workspace/snapshots.py": "git",
}


def _calls(path: Path) -> Iterator[str]:
    """Where a module asks for files by itself."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Call):
            is_asking = ast.unparse(node.func) == "open"
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


class _Log:
    def __init__(self) -> None:
        self.calls: list[tuple[object, ...]] = []

    def read(self, path: str, most: int, data: bytes | None, state: os.stat_result | None) -> None:
        self.calls.append(("read", path, most, data, state and state.st_size))

    def state(self, path: str, state: os.stat_result | None) -> None:
        self.calls.append(("state", path, state is not None))

    def link(self, path: str, state: os.stat_result | None) -> None:
        self.calls.append(("link", path, state is not None))

    def listed(self, folder: str, names: list[str] | None) -> None:
        self.calls.append(("listed", folder, names and sorted(names)))

    def real(self, path: str, real: str) -> None:
        self.calls.append(("real", path, real))

    def variable(self, name: str, value: str | None) -> None:
        self.calls.append(("variable", name, value))


@pytest.fixture
def log() -> Iterator[_Log]:
    log = _Log()
    disk.log_to(log)
    yield log
    disk.log_to(None)


def test_what_is_asked_for_is_noted(
    log: _Log, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ARM", "left")
    Path("a.stl").write_bytes(b"solid")
    Path("to").symlink_to("a.stl")
    assert disk.read("a.stl", 3) == b"sol"
    with pytest.raises(FileNotFoundError):
        disk.read("b.stl")
    assert (disk.exists("a.stl"), disk.is_file("b.stl"), disk.is_folder(".")) == (True, False, True)
    assert (disk.is_link("to"), disk.has_name("b.stl")) == (True, False)
    assert sorted(disk.names(".")) == ["a.stl", "to"]
    assert [sorted(inside) for _, _, inside in disk.walk(".")] == [["a.stl", "to"]]
    assert disk.real("to") == str(tmp_path / "a.stl")
    assert disk.Environment().get("ARM") == "left"
    assert disk.Environment().get("LEG") is None
    assert log.calls == [
        ("read", "a.stl", 3, b"sol", 5),
        ("read", "b.stl", -1, None, None),
        ("state", "a.stl", True),
        ("state", "b.stl", False),
        ("state", ".", True),
        ("link", "to", True),
        ("link", "b.stl", False),
        ("listed", ".", ["a.stl", "to"]),
        ("listed", ".", ["a.stl", "to"]),
        ("real", "to", str(tmp_path / "a.stl")),
        ("variable", "ARM", "left"),
        ("variable", "LEG", None),
    ]


def test_a_name_with_a_nul_is_no_file() -> None:
    assert not disk.exists("a\0b")
    assert not disk.has_name("a\0b")
    with pytest.raises(ValueError, match="null"):
        disk.read("a\0b")
