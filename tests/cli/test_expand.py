"""The expand command: what it reads, where it stops, and where it writes."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.command_line import UNIX, run
from tests.conftest import ROOT
from tests.shipped import GRIPPER
from urdfkit.cli import main


@UNIX
def test_expand_with_standard_input() -> None:
    text = b'<robot name="r"><link name="a"/></robot>'
    done = run("expand", "-", stdin=text)
    assert (done.returncode, done.stderr) == (0, b"")
    assert b'<link name="a"/>' in done.stdout
    line = f'"{sys.executable}" -m urdfkit expand - <&-'
    done = subprocess.run(["sh", "-c", line], check=False, cwd=ROOT, capture_output=True)
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.startswith(b"error: standard input is closed")
    done = run("expand", "-")
    assert done.returncode == 2
    assert b"Traceback" not in done.stderr


def test_expand_stops_where_xacro_stops(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A check goes on with a default that comes too late (XAC020); an expansion may not."""
    robot = tmp_path / "r.xacro"
    robot.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="$(arg p)a"/>'
        '<xacro:arg name="p" default=""/></robot>'
    )
    assert main(["expand", str(robot)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("error: Undefined substitution argument p\n")
    assert main(["expand", str(robot), "p:=b_"]) == 0


def test_expand_stops_at_a_byte_that_is_no_text(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """BipedRobot: a check reads on in its file of transmissions, in Latin-1."""
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    robot = tmp_path / "r.xacro"
    robot.write_text(f'{head}<xacro:include filename="robot.trans"/></robot>')
    included = f'{head}<transmission name="Revoluci\xf3n"/></robot>'
    (tmp_path / "robot.trans").write_bytes(included.encode("latin-1"))
    assert main(["expand", str(robot)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("error: this byte is not utf-8")
    (tmp_path / "robot.trans").write_text(included, encoding="utf-8")
    assert main(["expand", str(robot)]) == 0


def test_expand_creates_the_output_directory_unless_a_file_exists_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["expand", GRIPPER, "-o", str(tmp_path / "new" / "r.urdf")]) == 0
    assert (tmp_path / "new" / "r.urdf").exists()
    (tmp_path / "file").touch()
    assert main(["expand", GRIPPER, "-o", str(tmp_path / "file" / "r.urdf")]) == 2
    assert (
        f"{tmp_path / 'file'}: cannot create this directory: File exists" in capsys.readouterr().err
    )
