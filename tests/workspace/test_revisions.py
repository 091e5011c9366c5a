"""Files of git revisions; nothing that the repository's own configuration names is run."""

import hashlib
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from urdfkit.errors import UrdfkitError
from urdfkit.workspace import revisions

pytestmark = [
    pytest.mark.skipif(shutil.which("git") is None, reason="git is not installed"),
    pytest.mark.skipif(os.name == "nt", reason="the programs are shell scripts"),
]


def git(directory: Path, *words: str) -> str:
    author = ("-c", "user.name=a", "-c", "user.email=a@b.c")
    command = ["git", *author, "-C", str(directory), *words]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """A repository with ``robot.urdf`` and a program that notes its runs."""
    top = tmp_path / "repository"
    top.mkdir()
    git(top, "init", "-q")
    (top / "robot.urdf").write_text("<robot name='old'/>")
    (top / ".gitattributes").write_text("*.urdf filter=own\n")
    git(top, "add", ".")
    git(top, "commit", "-qm", "robot")
    program = tmp_path / "program"
    program.write_text(f"#!/bin/sh\necho $0 >> {tmp_path / 'runs'}\ncat\n")
    program.chmod(0o755)
    return top


def old_files(repository: Path) -> Path:
    directory = repository.parent / "old"
    directory.mkdir()
    revisions.check_out(str(repository / "robot.urdf"), "HEAD", str(directory))
    return directory


def test_filters_and_hooks_of_the_repository_are_not_run(repository: Path, tmp_path: Path) -> None:
    program = tmp_path / "program"
    for setting in ("filter.own.smudge", "filter.own.process", "core.fsmonitor"):
        git(repository, "config", setting, str(program))
    shutil.copy(program, repository / ".git" / "hooks" / "post-index-change")
    assert (old_files(repository) / "robot.urdf").read_text() == "<robot name='old'/>"
    assert not (tmp_path / "runs").exists()


def test_no_program_fetches_a_missing_object(repository: Path, tmp_path: Path) -> None:
    blob = git(repository, "rev-parse", "HEAD:robot.urdf")
    (repository / ".git" / "objects" / blob[:2] / blob[2:]).unlink()
    for setting, value in {
        "core.repositoryformatversion": "1",
        "extensions.partialClone": "own",
        "remote.own.promisor": "true",
        "remote.own.url": f"ext::{tmp_path / 'program'}",
        "protocol.ext.allow": "always",
    }.items():
        git(repository, "config", setting, value)
    with pytest.raises(UrdfkitError, match=r"robot\.urdf"):
        old_files(repository)
    assert not (tmp_path / "runs").exists()


def test_files_of_git_lfs_are_those_that_have_been_fetched(repository: Path) -> None:
    oid, lines = (
        hashlib.sha256(b"solid").hexdigest(),
        "version https://git-lfs.github.com/spec/v1\n",
    )
    for name, known in (("fetched.stl", oid), ("other.stl", "0" * 64)):
        (repository / name).write_text(f"{lines}oid sha256:{known}\nsize 5\n")
    (repository / "link.stl").symlink_to(repository / "other.stl")
    git(repository, "add", ".")
    git(repository, "commit", "-qm", "meshes")
    store = repository / ".git" / "lfs" / "objects" / oid[:2] / oid[2:4]
    store.mkdir(parents=True)
    (store / oid).write_text("solid")
    old = old_files(repository)
    assert (old / "fetched.stl").read_text() == "solid"
    assert (old / "other.stl").read_text() == (repository / "other.stl").read_text()
    assert (old / "link.stl").is_symlink()


def test_a_pipe_in_place_of_a_file_of_git_ends_the_question(
    repository: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(revisions, "MAX_SECONDS_IGNORED", 0.2)
    os.mkfifo(repository / ".gitignore")
    assert not revisions.check_ignore(str(repository / "robot.urdf"))
