"""The hook under the real pre-commit program, on git repositories made of robots.

pre-commit clones a git repository and installs it. It is given a copy of this checkout as it is,
so that what is tested is what is here, committed or not.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.conftest import CORPUS, MODELS, ROOT, needs_corpus

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
    """A git repository."""

    def __init__(self, directory: Path, home: Path) -> None:
        self.directory = directory
        self.environment = {
            **os.environ,
            "PRE_COMMIT_HOME": str(home),
            "GIT_CONFIG_GLOBAL": os.devnull,
            "GIT_AUTHOR_NAME": "a",
            "GIT_AUTHOR_EMAIL": "a@example.org",
            "GIT_COMMITTER_NAME": "a",
            "GIT_COMMITTER_EMAIL": "a@example.org",
        }
        self.run("git", "init", "-q")

    def run(self, *words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            words,
            check=False,
            cwd=self.directory,
            env=self.environment,
            capture_output=True,
            text=True,
        )

    def commit(self) -> subprocess.CompletedProcess[str]:
        self.run("git", "add", "-A")
        return self.run("git", "commit", "-m", "change")

    def use(self, hooks: Repository, options: str = "", name: str = "urdfkit-check") -> None:
        """Let a hook run at every commit."""
        head = hooks.run("git", "rev-parse", "HEAD").stdout.strip()
        hook = f"{{id: {name}, args: [{options}]}}"
        (self.directory / ".pre-commit-config.yaml").write_text(
            f"repos:\n- {{repo: {hooks.directory}, rev: {head}, hooks: [{hook}]}}\n"
        )
        installed = self.run("pre-commit", "install", "--install-hooks")
        assert installed.returncode == 0, installed.stdout + installed.stderr


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where pre-commit keeps what it installs."""
    return tmp_path_factory.mktemp("home")


@pytest.fixture(scope="module")
def hooks(tmp_path_factory: pytest.TempPathFactory, home: Path) -> Repository:
    """This checkout, in a repository of its own."""
    directory = tmp_path_factory.mktemp("hooks")
    for name in ("pyproject.toml", "README.md", "LICENSE", ".pre-commit-hooks.yaml", ".gitignore"):
        shutil.copy(ROOT / name, directory)
    shutil.copytree(
        ROOT / "urdfkit", directory / "urdfkit", ignore=shutil.ignore_patterns("__pycache__")
    )
    repository = Repository(directory, home)
    assert repository.commit().returncode == 0
    return repository


@pytest.fixture
def repository(tmp_path: Path, hooks: Repository, home: Path) -> Repository:
    repository = Repository(tmp_path, home)
    shutil.copytree(MODELS / "good", tmp_path / "good")
    (tmp_path / "two").mkdir()
    (tmp_path / "two" / "macros.xacro").write_text(MACROS)
    (tmp_path / "two" / "robot.xacro").write_text(ROBOT)
    repository.use(hooks)
    clean = repository.commit()
    assert clean.returncode == 0, clean.stdout + clean.stderr
    assert "urdfkit check" in clean.stderr
    return repository


def test_commits_pass_are_refused_and_pass_again_once_fixed(repository: Repository) -> None:
    macros = repository.directory / "two" / "macros.xacro"
    macros.write_text(MACROS.replace("${name}", "${nam}"))
    refused = repository.commit()
    assert refused.returncode == 1
    # Only the macro file changed; it is checked through the robot that includes it.
    assert "two/macros.xacro:3:17: error XAC001" in refused.stderr + refused.stdout
    assert refused.stderr.count("error XAC001") == 1

    macros.write_text(MACROS.replace("${name}", "${name}_arm"))
    mended = repository.commit()
    assert mended.returncode == 0, mended.stdout + mended.stderr


def test_other_files_do_not_start_the_hook(repository: Repository) -> None:
    (repository.directory / "notes.txt").write_text("nothing")
    done = repository.commit()
    assert done.returncode == 0
    assert "(no files to check)Skipped" in done.stderr


def test_files_of_no_robot_pass(repository: Repository) -> None:
    for name in (".github/workflows/ci.yml", "site/settings.yaml"):
        path = repository.directory / name
        path.parent.mkdir(parents=True)
        path.write_text("a: 1\n")
    done = repository.commit()
    assert done.returncode == 0, done.stdout + done.stderr
    assert "urdfkit check............................................................Passed" in (
        done.stderr
    )


def test_the_configuration_of_the_project_counts(repository: Repository) -> None:
    macros = repository.directory / "two" / "macros.xacro"
    macros.write_text(MACROS.replace("<link", "<lnik"))
    (repository.directory / "urdfkit.toml").write_text("")
    refused = repository.commit()
    assert refused.returncode == 1
    assert "URD001" in refused.stderr
    (repository.directory / "urdfkit.toml").write_text(
        '[[per-file-ignores]]\nfiles = ["two"]\ncodes = ["URD", "TRE"]\nreason = "a test"\n'
    )
    passed = repository.commit()
    assert passed.returncode == 0, passed.stdout + passed.stderr


@needs_corpus
def test_real_robots(tmp_path: Path, hooks: Repository, home: Path) -> None:
    """A file that five robots include is broken, and fixed."""
    repository = Repository(tmp_path, home)
    for name in ("linorobot2", "urdf_tutorial"):
        shutil.copytree(CORPUS / name, tmp_path / name)
    repository.use(hooks, "--fail-on, error")
    clean = repository.commit()
    assert clean.returncode == 0, clean.stdout + clean.stderr

    part = tmp_path / "linorobot2/linorobot2_description/urdf/mech/base.urdf.xacro"
    text = part.read_text()
    assert '<mass value="${mass}"/>' in text
    part.write_text(text.replace('<mass value="${mass}"/>', '<mass value="${mas}"/>'))
    refused = repository.commit()
    assert refused.returncode == 1
    place = part.relative_to(tmp_path).as_posix()
    reported = " ".join(refused.stderr.split())
    line = 1 + text[: text.index('<mass value="${mass}"/>')].count("\n")
    assert f"{place}:{line}:22: error XAC001" in reported
    assert "1 error in 5 files" in reported
    assert "urdf_tutorial" not in refused.stderr

    part.write_text(text)
    (tmp_path / "urdf_tutorial" / "urdf" / "notes.yaml").write_text("a: 1\n")
    mended = repository.commit()
    assert mended.returncode == 0, mended.stdout + mended.stderr


#: A robot with an axis on a fixed joint, which has a safe fix; laid out, but for one tag.
AXIS = """<robot name="r">
  <link name="a"/>
  <link  name="b" />
  <joint name="j" type="fixed">
    <parent link="a"/>
    <child link="b"/>
    <axis xyz="0 0 1"/>
  </joint>
</robot>
"""


@pytest.mark.parametrize(
    ("hook", "after"),
    [
        ("urdfkit-check-fix", AXIS.replace('    <axis xyz="0 0 1"/>\n', "")),
        ("urdfkit-format", AXIS.replace('<link  name="b" />', '<link name="b"/>')),
    ],
)
def test_hooks_that_change_files_stop_the_commit_once(
    tmp_path: Path, hooks: Repository, home: Path, hook: str, after: str
) -> None:
    repository = Repository(tmp_path, home)
    options = "--select, JNT020" if hook == "urdfkit-check-fix" else ""
    repository.use(hooks, options, name=hook)
    robot = tmp_path / "robot.urdf"
    robot.write_text(AXIS)
    stopped = repository.commit()
    assert stopped.returncode == 1
    assert "files were modified by this hook" in stopped.stderr
    assert robot.read_text() == after
    done = repository.commit()
    assert done.returncode == 0, done.stdout + done.stderr
