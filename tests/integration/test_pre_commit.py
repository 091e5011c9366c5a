"""The hook under the real pre-commit program, on a git repository made of robots.

pre-commit clones this repository at its last commit and installs it, so what is tested is what
is committed.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.conftest import MODELS, ROOT

pytestmark = pytest.mark.skipif(
    shutil.which("pre-commit") is None or shutil.which("git") is None,
    reason="pre-commit and git are not installed",
)

MACROS = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="arm" params="name">
    <link name="${name}"/>
  </xacro:macro>
</robot>
"""
ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="macros.xacro"/>
  <xacro:arm name="left"/>
</robot>
"""


class Repository:
    """A git repository whose commits pass the hook."""

    def __init__(self, folder: Path, home: Path) -> None:
        self.folder = folder
        self.environment = {
            **os.environ,
            "PRE_COMMIT_HOME": str(home),
            "GIT_CONFIG_GLOBAL": os.devnull,
            "GIT_AUTHOR_NAME": "a",
            "GIT_AUTHOR_EMAIL": "a@example.org",
            "GIT_COMMITTER_NAME": "a",
            "GIT_COMMITTER_EMAIL": "a@example.org",
        }

    def run(self, *words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            words,
            cwd=self.folder,
            env=self.environment,
            capture_output=True,
            text=True,
            check=False,
        )

    def commit(self) -> subprocess.CompletedProcess[str]:
        self.run("git", "add", "-A")
        return self.run("git", "commit", "-m", "change")


@pytest.fixture(scope="module")
def repository(tmp_path_factory: pytest.TempPathFactory) -> Repository:
    folder = tmp_path_factory.mktemp("robots")
    repository = Repository(folder, tmp_path_factory.mktemp("home"))
    repository.run("git", "init", "-q")
    head = subprocess.check_output(["git", "-C", str(ROOT), "rev-parse", "HEAD"], text=True)
    (folder / ".pre-commit-config.yaml").write_text(
        f"repos:\n- repo: {ROOT}\n  rev: {head.strip()}\n  hooks:\n  - id: urdfkit-check\n"
    )
    shutil.copytree(MODELS / "good", folder / "good")
    (folder / "two").mkdir()
    (folder / "two" / "macros.xacro").write_text(MACROS)
    (folder / "two" / "robot.xacro").write_text(ROBOT)
    installed = repository.run("pre-commit", "install", "--install-hooks")
    assert installed.returncode == 0, installed.stdout + installed.stderr
    return repository


def test_commits_pass_are_refused_and_pass_again_once_mended(repository):
    clean = repository.commit()
    assert clean.returncode == 0, clean.stdout + clean.stderr
    assert "urdfkit check" in clean.stderr

    macros = repository.folder / "two" / "macros.xacro"
    macros.write_text(MACROS.replace("${name}", "${nam}"))
    refused = repository.commit()
    assert refused.returncode == 1
    # Only the macro file changed; it is checked through the robot that includes it.
    assert "two/macros.xacro:3:17: error XAC001" in refused.stderr + refused.stdout
    assert refused.stderr.count("error XAC001") == 1

    macros.write_text(MACROS.replace("${name}", "${name}_arm"))
    mended = repository.commit()
    assert mended.returncode == 0, mended.stdout + mended.stderr


def test_other_files_do_not_start_the_hook(repository):
    (repository.folder / "notes.txt").write_text("nothing")
    done = repository.commit()
    assert done.returncode == 0
    assert "(no files to check)Skipped" in done.stderr
