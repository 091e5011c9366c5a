import shutil
import subprocess
from pathlib import Path

import pytest

from tests.meshed import SOUND, link, mesh, messages
from tests.naming import naming

OBJ = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    if shutil.which("git") is None:
        pytest.skip("git is not installed")
    subprocess.run(["git", "init", "-q", str(tmp_path)], check=True)
    return tmp_path


@pytest.mark.parametrize(
    "pattern",
    [
        "*.obj",
        "*.OBJ\n*.obj",
        "meshes/",
        "/meshes/a.obj",
        "meshes/a*j",
        "a*",
        "?.[n-p]bj",
        "a\\.obj",
    ],
)
def test_what_git_ignores(repository: Path, pattern: str) -> None:
    files = {".gitignore": f"# of compilers\n{pattern}\n".encode(), "meshes/a.obj": OBJ}
    assert messages(repository, "MSH003", link(mesh("meshes/a.obj")), files) == [
        naming("arm", "collision", "meshes/a.obj", "ignored")
    ]


@pytest.mark.parametrize("pattern", ["*.o", "*.obj\n!meshes/*.obj", "build/", "# *.obj", "/a.obj"])
def test_what_git_takes(repository: Path, pattern: str) -> None:
    files = {".gitignore": f"{pattern}\n".encode(), "meshes/a.obj": OBJ}
    assert messages(repository, "MSH003", link(mesh("meshes/a.obj")), files) == []


def test_the_list_of_the_repository_itself(repository: Path) -> None:
    (repository / ".git" / "info").mkdir(exist_ok=True)
    (repository / ".git" / "info" / "exclude").write_text("*.obj\n")
    assert len(messages(repository, "MSH003", link(mesh("a.obj")), {"a.obj": OBJ})) == 1


def test_what_was_added_all_the_same(repository: Path) -> None:
    files = {".gitignore": b"*.obj\n", "a.obj": OBJ}
    assert len(messages(repository, "MSH003", link(mesh("a.obj")), files)) == 1
    subprocess.run(["git", "-C", str(repository), "add", "-f", "a.obj"], check=True)
    assert messages(repository, "MSH003", link(mesh("a.obj")), files) == []


def test_outside_of_repositories(tmp_path: Path) -> None:
    files = {".gitignore": b"*.stl\n", "a.stl": SOUND}
    assert messages(tmp_path, "MSH003", link(mesh("a.stl")), files) == []
