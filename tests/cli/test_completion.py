"""What a shell completes: values that exist, and file names everywhere else."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.shipped import ARM
from urdfkit.cli import main
from urdfkit.cli.completion import VARIABLE, completed


def values(line: str, incomplete: str = "") -> list[str]:
    return [item.value for item in completed(line.split(), incomplete)]


def test_values_of_options() -> None:
    assert values("check r.urdf --target", "gz-") == ["gz-fortress", "gz-harmonic", "gz-jetty"]
    assert values("check --select", "TRE001,XML00")[0] == "TRE001,XML001"
    assert values("explain", "MSH00") == values("check --ignore", "MSH00")
    assert "sarif" in values("check --format")
    assert values("mass --link") == []


def test_links_and_joints_of_the_robot() -> None:
    joints = values(f"render {ARM} -o a.gif --sweep")
    assert "elbow" in joints
    gripper = "models/good/gripper.urdf"  # a fixed joint, and one that follows the other
    assert values(f"info {gripper} --joint") == ["left_finger_joint="]
    assert values(f"info {ARM} --joint", "elb") == ["elbow="]
    assert "mount" in values(f"kinematics {ARM} --jacobian", "mou")
    assert values("kinematics /no/such.urdf --jacobian") == []
    assert "joint/elbow" in values(f"trace {ARM}", "joint/")


def test_xacro_arguments_apply_to_the_robot(tmp_path: Path) -> None:
    file = tmp_path / "r.xacro"
    file.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:arg name="prefix" default=""/><link name="$(arg prefix)base"/></robot>'
    )
    assert values(f"inertia {file} prefix:=left_ --link") == ["left_base"]


def test_views_and_layers() -> None:
    pytest.importorskip("PIL")
    assert values("render r.urdf --view", "fr") == ["front"]
    assert "collision" in values("render r.urdf --layers")


@pytest.mark.parametrize("line", ["check", "check r.urdf", "check --config", "view", "trace"])
def test_file_names_are_completed(line: str) -> None:
    (item,) = completed(line.split(), "mod")
    assert (item.type, item.value) == ("file", "mod")


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("urdfkit che", "plain,check"),
        ("urdfkit check --fail-on e", "plain,error"),
        ("urdfkit check --target yourd", "plain,yourdfpy"),
        ("urdfkit check x", "file,x"),
    ],
)
def test_completion_request_of_a_shell(line: str, expected: str) -> None:
    last = str(len(line.split()) - 1)
    asked = {VARIABLE: "bash_complete", "COMP_WORDS": line, "COMP_CWORD": last}
    done = subprocess.run(
        [sys.executable, "-m", "urdfkit"],
        check=True,
        capture_output=True,
        cwd=ROOT,
        env={**os.environ, **asked},
        text=True,
    )
    assert (done.stdout.strip(), done.stderr) == (expected, "")


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_script_of_a_shell(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    assert f"{VARIABLE}={shell}_complete" in script
