"""An unchanged check repeats its result; whatever it depends on makes it check again."""

import os
import shutil
import subprocess
import sys
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.workspaces import add_files
from urdfkit.checks.gazebo.gaz001_unknown_reference import BAD
from urdfkit.core.cache_directory import VARIABLE
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.output import formats

#: Runs a command line as the command does, and says last whether anything was checked.
PROGRAM = """
import sys
from urdfkit.cli import guarded, _replay_or_run
code = guarded(_replay_or_run, sys.argv[1:])
print("checked" if "urdfkit.lint.engine" in sys.modules else "repeated", file=sys.stderr)
sys.exit(code)
"""

#: Notes every file below the working directory that Python opens or lists.
AUDITED = """
import os, sys
from urdfkit.core import disk
from urdfkit.cli import result_recording
asked, noted = set(), set()
def hook(event, values):
    if event in ("open", "os.listdir", "os.scandir") and isinstance(values[0], str):
        path = os.path.abspath(values[0])
        if path.startswith(os.getcwd()) and not (event == "open" and values[1] != "r" + "b"):
            asked.add(path)
sys.addaudithook(hook)
result_recording.store = lambda entry: noted.update(os.path.abspath(a[1]) for a in entry.answers)
from urdfkit.cli import _replay_or_run
_replay_or_run(sys.argv[1:])
assert noted, "nothing is kept"
assert asked <= noted, asked - noted
assert len(asked) > 5, asked
"""

ROBOT = """<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="prefix" default=""/>
  <xacro:include filename="$(find arm)/urdf/parts.xacro"/>
  <xacro:property name="sizes" value="${xacro.load_yaml('$(find arm)/config/sizes.yaml')}"/>
  <link name="$(arg prefix)base$(optenv ROBOT_NAME)"/>
  <xacro:part name="$(arg prefix)part" length="${sizes['length']}"/>
</robot>
"""
PARTS = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params="name length">
    <link name="${name}">
      <visual><geometry><mesh filename="package://arm/meshes/part.obj"/></geometry></visual>
      <collision><geometry><mesh filename="package://arm/meshes/none.stl"/></geometry></collision>
      <visual><geometry><box size="${length} 1 1"/></geometry></visual>
    </link>
    <joint name="${name}_joint" type="fixed">
      <parent link="$(arg prefix)base$(optenv ROBOT_NAME)"/><child link="${name}"/>
    </joint>
  </xacro:macro>
</robot>
"""
LAUNCH = """<launch>
  <param name="robot_description" command="xacro $(find arm)/urdf/arm.urdf.xacro prefix:=a_"/>
  <rosparam file="$(find arm)/config/none.yaml"/>
</launch>
"""
OBJ = """mtllib part.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
usemtl a
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""
FILES = {
    "urdfkit.toml": "",
    "baseline.json": '{"version": 1, "findings": []}\n',
    "arm/package.xml": "<package format='3'><name>arm</name></package>\n",
    "arm/CMakeLists.txt": "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\n",
    "arm/urdf/arm.urdf.xacro": ROBOT,
    "arm/urdf/parts.xacro": PARTS,
    "arm/config/sizes.yaml": "length: 1\n",
    "arm/config/arm.srdf": "<robot name='arm'><group name='g'/></robot>\n",
    "arm/launch/arm.launch": LAUNCH,
    "arm/meshes/part.obj": OBJ,
    "arm/meshes/part.mtl": "newmtl a\nmap_Kd part.png\n",
}

#: What is changed, by name: a file and what is added to it; None makes it new.
CHANGES = {
    "xacro": ("arm/urdf/arm.urdf.xacro", "<!-- -->"),
    "include": ("arm/urdf/parts.xacro", "<!-- -->"),
    "yaml": ("arm/config/sizes.yaml", "width: 2\n"),
    "package.xml": ("arm/package.xml", "<!-- -->"),
    "build file": ("arm/CMakeLists.txt", "# more\n"),
    "launch file": ("arm/launch/arm.launch", "<!-- -->"),
    "SRDF": ("arm/config/arm.srdf", "<!-- -->"),
    "mesh": ("arm/meshes/part.obj", "# more\n"),
    "mtl": ("arm/meshes/part.mtl", "# more\n"),
    "texture that appears": ("arm/meshes/part.png", ""),
    "mesh that appears": ("arm/meshes/none.stl", "solid\n"),
    "parameters that appear": ("arm/config/none.yaml", "a: 1\n"),
    "configuration": ("urdfkit.toml", "ignore = ['MSH001']\n"),
    "configuration that appears": ("arm/urdfkit.toml", ""),
    "baseline": ("baseline.json", " "),
    "robot that appears": ("arm/urdf/other.urdf", "<robot name='other'><link name='a'/></robot>"),
    "directory that appears": ("arm/urdf/more/empty", ""),
}


def run(
    directory: Path, *words: str, variables: Mapping[str, str] | None = None
) -> subprocess.CompletedProcess[bytes]:
    cache = directory.parent / "cache"
    # What lies in the directory of temporary files and above is no part of a workspace.
    environment = os.environ | {VARIABLE: str(cache), "TMPDIR": str(directory.parent)}
    return subprocess.run(
        [sys.executable, "-c", PROGRAM, *words],
        check=False,
        cwd=directory,
        capture_output=True,
        env=environment | dict(variables or {}),
    )


def is_repeated(done: subprocess.CompletedProcess[bytes]) -> bool:
    assert done.returncode in (0, 1), done.stderr
    return done.stderr.rstrip().endswith(b"repeated")


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A workspace whose robots have been checked; each test leaves its result behind."""
    directory = tmp_path_factory.mktemp("cached") / "ws"
    add_files(directory, FILES)
    (directory / "arm/meshes/deep").mkdir()
    assert not is_repeated(run(directory, *CHECK))
    return directory


CHECK = ("check", ".", "--baseline", "baseline.json")


@pytest.mark.parametrize("change", CHANGES)
def test_a_change_is_seen(workspace: Path, change: str) -> None:
    run(workspace, *CHECK)
    assert is_repeated(run(workspace, *CHECK))
    name, added = CHANGES[change]
    path = workspace / name
    path.parent.mkdir(exist_ok=True)
    with path.open("a") as file:
        file.write(added)
    assert not is_repeated(run(workspace, *CHECK))
    assert is_repeated(run(workspace, *CHECK))


@pytest.mark.parametrize(
    ("name", "value"),
    [("AMENT_PREFIX_PATH", "/none"), ("ROS_PACKAGE_PATH", "/none"), ("ROBOT_NAME", "_a"),
     ("HOME", "/none"), ("NO_COLOR", "1"), ("COLUMNS", "100")],
)  # fmt: skip
def test_a_variable_is_seen(workspace: Path, name: str, value: str) -> None:
    run(workspace, *CHECK)
    assert is_repeated(run(workspace, *CHECK))
    assert not is_repeated(run(workspace, *CHECK, variables={name: value}))
    run(workspace, *CHECK)
    assert is_repeated(run(workspace, *CHECK, variables={"UNRELATED": "1"}))


def test_a_file_that_becomes_read_only_is_seen(workspace: Path) -> None:
    run(workspace, *CHECK)
    robot = workspace / "arm/urdf/arm.urdf.xacro"
    robot.chmod(0o444)
    assert not is_repeated(run(workspace, *CHECK))
    robot.chmod(0o644)


def test_a_file_that_becomes_a_directory_is_seen(workspace: Path) -> None:
    place = workspace / "arm/README.md"
    place.touch()
    run(workspace, *CHECK)
    assert is_repeated(run(workspace, *CHECK))
    place.unlink()
    place.mkdir()
    (place / "other.urdf").write_text("<robot name='other'><link name='a'/></robot>")
    assert not is_repeated(run(workspace, *CHECK))
    shutil.rmtree(place)


@pytest.mark.parametrize(
    "variables",
    [
        {"PATH": "/none"},
        {"GIT_CEILING_DIRECTORIES": "/none"},
        {"GIT_CONFIG_COUNT": "1", "GIT_CONFIG_KEY_0": "a.b", "GIT_CONFIG_VALUE_0": "c"},
    ],
)
def test_files_of_git_are_seen(tmp_path: Path, variables: dict[str, str]) -> None:
    workspace = tmp_path / "ws"
    workspace.mkdir()
    subprocess.run(["git", "init", "-q", str(workspace)], check=True)
    (workspace / ".gitignore").write_text("arm.urdf\n")
    (workspace / "arm.urdf").write_text(whole_robot(BAD))
    assert b"git ignores the file" in run(workspace, "check", ".").stdout
    assert is_repeated(run(workspace, "check", "."))
    assert not is_repeated(run(workspace, "check", ".", variables=variables))


@pytest.mark.parametrize(
    "more", [["prefix:=b_"], ["--target", "ros1"], ["--select", "MSH"], ["--format", "json"]]
)
def test_the_command_line_is_seen(workspace: Path, more: list[str]) -> None:
    run(workspace, *CHECK)
    assert not is_repeated(run(workspace, *CHECK, *more))
    assert is_repeated(run(workspace, *CHECK, *more))


def test_the_working_directory_is_seen(workspace: Path) -> None:
    run(workspace, "check", ".")
    assert not is_repeated(run(workspace / "arm", "check", "."))


def test_a_change_in_another_process_is_seen(workspace: Path) -> None:
    words = (*CHECK, "--jobs", "2")
    assert not is_repeated(run(workspace, *words))
    assert is_repeated(run(workspace, *words))
    with (workspace / "arm/urdf/parts.xacro").open("a") as file:
        file.write("<!-- jobs -->")
    assert not is_repeated(run(workspace, *words))


def test_a_new_time_alone_changes_nothing(workspace: Path) -> None:
    first = run(workspace, *CHECK)
    for path in workspace.rglob("*"):
        os.utime(path, (1, 1))
    again = run(workspace, *CHECK)
    assert is_repeated(again)
    assert again.stdout == first.stdout


@pytest.mark.parametrize(
    "more", [["--no-cache"], ["--trust"], ["--show-files"], ["--rules", "own_rules"], ["-"]]
)
def test_what_is_not_kept(workspace: Path, more: list[str]) -> None:
    package = workspace / "own_rules"
    shutil.rmtree(package, ignore_errors=True)
    shutil.copytree(ROOT / "examples/own_rule/acme_rules", package)
    for _ in range(2):
        assert not is_repeated(run(workspace, *CHECK, *more))
    shutil.rmtree(package)


def test_checks_with_external_rules_are_not_cached(workspace: Path) -> None:
    package = workspace / "own_rules"
    shutil.copytree(ROOT / "examples/own_rule/acme_rules", package)
    (workspace / "rules.toml").write_text("rule-packages = ['own_rules']\n")
    for _ in range(2):
        assert not is_repeated(run(workspace, *CHECK, "--config", "rules.toml"))
    shutil.rmtree(package)
    (workspace / "rules.toml").unlink()


def test_an_error_is_not_cached(workspace: Path) -> None:
    for _ in range(2):
        done = run(workspace, "check", "none.urdf")
        assert done.returncode == 2
        assert done.stderr.rstrip().endswith(b"checked")


@pytest.mark.parametrize("words", [["arm/urdf/arm.urdf.xacro"], ["."], ["--jobs", "2", "."]])
def test_all_opened_files_are_logged(workspace: Path, words: list[str]) -> None:
    done = subprocess.run(
        [sys.executable, "-c", AUDITED, "check", *words],
        check=False,
        cwd=workspace,
        env=os.environ | {VARIABLE: str(workspace.parent / "other")},
        capture_output=True,
    )
    assert done.returncode == 0, done.stderr


def test_every_format_is_repeated_byte_for_byte(workspace: Path, tmp_path: Path) -> None:
    outputs = [tmp_path / name for name in formats.names()]
    words = [word for path in outputs for word in ("--format", f"{path.name}:{path}")]
    line = ("check", ".", *words, "--format", "text", "--color", "always", "--fail-on", "info")
    first = run(workspace, *line)
    contents = [path.read_bytes() for path in outputs]
    for path in outputs:
        path.unlink()
    again = run(workspace, *line)
    assert not is_repeated(first)
    assert is_repeated(again)
    assert (again.returncode, again.stdout) == (first.returncode, first.stdout)
    assert [path.read_bytes() for path in outputs] == contents
    assert b"\x1b[" in first.stdout


def test_many_at_the_same_time(workspace: Path) -> None:
    shutil.rmtree(workspace.parent / "cache")
    with ThreadPoolExecutor(4) as pool:
        done = list(pool.map(lambda _: run(workspace, *CHECK), range(4)))
    assert len({one.stdout for one in done}) == 1
    assert is_repeated(run(workspace, *CHECK))
