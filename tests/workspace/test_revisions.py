"""Files of git revisions; nothing that the repository's own configuration names is run."""

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


def test_a_pipe_in_place_of_a_file_of_git_ends_the_question(
    repository: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(revisions, "MAX_SECONDS_IGNORED", 0.2)
    os.mkfifo(repository / ".gitignore")
    assert not revisions.check_ignore(str(repository / "robot.urdf"))
