"""The check of a file by the command line: exit codes, and files that are hard to read."""

import os
from pathlib import Path

import pytest

import urdfkit
from tests.cli.command_line import UNIX, run
from tests.shipped import GRIPPER
from urdfkit.cli import main


def test_a_clean_robot_exits_with_0() -> None:
    done = run("check", GRIPPER)
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout.startswith(b"no findings in 1 file")


def test_findings_exit_with_1() -> None:
    done = run("check", "-", stdin=b"<robot")
    assert (done.returncode, done.stderr) == (1, b"")
    assert done.stdout.startswith(b"<stdin>:1:")
    assert b" error XML001 " in done.stdout


def test_the_version_has_one_source() -> None:
    done = run("--version")
    assert (done.returncode, done.stdout.decode().split()) == (0, ["urdfkit", urdfkit.__version__])


@UNIX
@pytest.mark.skipif(getattr(os, "geteuid", lambda: 0)() == 0, reason="root may read everything")
def test_a_file_without_permission(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "robot.urdf"
    file.write_bytes(b"<robot/>")
    file.chmod(0)
    assert main(["check", str(file)]) == 2
    assert "see its permissions" in capsys.readouterr().err


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"   \n",
        bytes(range(256)) * 20,
        b"\x7fELF\x02\x01\x01" + bytes(300),
        "<robot".encode("utf-16"),
        b"\xff\xfe",
        b"\xef\xbb\xbf",
        b'<?xml version="1.0" encoding="no-such"?><robot/>',
        b"<a>" * 50_000,
    ],
    ids=["empty", "blank", "bytes", "elf", "utf-16", "mark-16", "mark-8", "encoding", "deep"],
)
def test_an_invalid_file_is_a_finding(
    data: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "robot.urdf"
    file.write_bytes(data)
    assert main(["check", str(file)]) == 1
    captured = capsys.readouterr()
    assert captured.err == ""
    assert " error XML00" in captured.out


def test_a_robot_in_utf_16_is_read_as_in_utf_8(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = Path(GRIPPER).read_text(encoding="utf-8")
    outputs = []
    for encoding in ("utf-8", "utf-16"):
        file = tmp_path / "robot.urdf"
        file.write_bytes(text.encode(encoding))
        code = main(["check", str(file), "--ignore", "XML002"])
        outputs.append((code, capsys.readouterr().out))
    assert outputs[0] == outputs[1]


def test_an_undecodable_file_name(tmp_path: Path) -> None:
    name = os.fsencode(tmp_path) + b"/\xff.urdf"
    try:
        with open(name, "wb") as file:
            file.write(b"<robot")
    except OSError:
        pytest.skip("this file system wants text")
    done = run("check", os.fsdecode(name), "--format", "json")
    assert (done.returncode, done.stderr) == (1, b"")
    assert b"\\udcff.urdf" in done.stdout
    assert run("check", os.fsdecode(name)).returncode == 1
