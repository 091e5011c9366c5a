"""What ends a command early: bugs, Ctrl-C, and a machine that is full."""

import errno
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.conftest import MOBILE_BASE, ROOT
from tests.shipped import GRIPPER
from urdfkit.cli import checking, main
from urdfkit.lint import rule_index


def test_an_internal_error_asks_for_a_report(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise ValueError("boom")

    monkeypatch.setattr(checking, "check_with", fail)
    monkeypatch.delenv("URDFKIT_DEBUG", raising=False)
    assert main(["check", GRIPPER]) == 3
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "ValueError: boom" in captured.err
    assert "bug in urdfkit" in captured.err
    assert "Traceback" not in captured.err
    monkeypatch.setenv("URDFKIT_DEBUG", "1")
    assert main(["check", GRIPPER]) == 3
    assert "Traceback" in capsys.readouterr().err


@pytest.mark.skipif(os.name == "nt", reason="Windows keeps the current directory of a process")
def test_a_removed_current_directory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    directory = tmp_path / "removed"
    directory.mkdir()
    monkeypatch.chdir(directory)
    directory.rmdir()
    assert main(["check", "."]) == 2
    assert capsys.readouterr() == ("", "error: the current directory has been removed\n")


@pytest.mark.parametrize("words", [["check", GRIPPER], ["check", GRIPPER, "--", GRIPPER]])
def test_ctrl_c_exits_with_130(
    words: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """On the quick way, and on the way through click."""

    def stop(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(checking, "check_with", stop)
    assert main(words) == 130
    captured = capsys.readouterr()
    assert (captured.out, captured.err.strip()) == ("", "")


def busy(children: Path) -> list[str]:
    """The processes in a file of Linux that have been working for a while."""
    stats = {pid: Path(f"/proc/{pid}/stat").read_text() for pid in children.read_text().split()}
    return [pid for pid, stat in stats.items() if int(stat.rpartition(")")[2].split()[11]) >= 5]


def is_gone(group: int) -> bool:
    """True as soon as a group has no process; on a busy machine the last one takes its time."""
    deadline = time.monotonic() + 30
    while time.monotonic() < deadline:
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.01)
    return False


@pytest.mark.skipif(not os.path.exists("/proc/self/task"), reason="needs Linux's /proc")
def test_ctrl_c_ends_all_processes_without_a_word(tmp_path: Path) -> None:
    """In whatever order they hear of it."""
    robot = (MOBILE_BASE).read_bytes()
    for number in range(1000):
        (tmp_path / f"{number}.xacro").write_bytes(robot)
    command = [sys.executable, "-m", "urdfkit", "check", str(tmp_path), "--jobs", "2"]
    # A shell ignores the signal in what it starts in the background, as this test may be.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    with subprocess.Popen(
        command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
    ) as process:
        signal.signal(signal.SIGINT, before)
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
        while len(busy(children)) < 2:
            time.sleep(0.01)
        for pid in busy(children):
            os.kill(int(pid), signal.SIGINT)
        time.sleep(0.05)
        os.killpg(process.pid, signal.SIGINT)  # processes that are new by now hear it, too
        try:
            said = process.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            raise
    assert (process.returncode, *said) == (130, b"", b"")
    assert is_gone(process.pid)


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (OSError(errno.ENOSPC, "No space left on device"), "error: No space left on device\n"),
        (MemoryError(), "error: not enough memory\n"),
        (OSError(errno.ENOMEM, "Cannot allocate memory"), "error: not enough memory\n"),
    ],
    ids=["disk", "memory", "system"],
)
def test_lack_of_memory_is_not_a_bug(
    error: Exception,
    message: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr(checking, "check_with", fail)
    assert main(["check", GRIPPER]) == 2
    assert capsys.readouterr().err == message


def test_lack_of_memory_in_a_rule_is_not_a_bug(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(*_: object) -> None:
        try:
            raise MemoryError
        except MemoryError:
            raise SystemError("error return without exception set") from None

    monkeypatch.setattr(rule_index, "applicable", fail)
    assert main(["check", GRIPPER, "--no-cache"]) == 2
    assert re.fullmatch(r"error: \S+: not enough memory\n", capsys.readouterr().err)


#: Programs in which the xacro on PYTHONPATH is the only one, and in which that of urdfkit follows.
ALONE = """
import sys
from urdfkit.core import libraries
libraries.find_all = lambda name: iter([libraries.find(name)])
from urdfkit.cli import main
sys.exit(main(sys.argv[1:]))
"""
IN_FRONT = "import sys; from urdfkit.cli import main; sys.exit(main(sys.argv[1:]))"


def with_old_xacro(
    directory: Path, program: str, *words: str | Path
) -> subprocess.CompletedProcess[str]:
    """A run of the command line with a foreign xacro on PYTHONPATH, as that of an older ROS."""
    package = directory / "ros" / "xacro"
    package.mkdir(parents=True, exist_ok=True)
    (package / "__init__.py").write_text("from . import color\n__version__ = '1.13'\n")
    (package / "color.py").write_text("def error(text): print('old')\n")
    return subprocess.run(
        [sys.executable, "-c", program, *map(str, words)],
        check=False,
        capture_output=True,
        text=True,
        cwd=directory,
        env={
            **os.environ,
            "PYTHONPATH": os.pathsep.join([str(directory / "ros"), str(ROOT)]),
            "URDFKIT_CACHE_DIR": "",
        },
        timeout=60,
    )


def test_the_xacro_of_an_older_ros_is_passed_over(tmp_path: Path) -> None:
    ran = with_old_xacro(tmp_path, IN_FRONT, "expand", MOBILE_BASE)
    assert ran.returncode == 0, ran.stderr
    assert "<link name=" in ran.stdout


def test_a_missing_xacro_is_no_fault_of_the_robot(tmp_path: Path) -> None:
    for command in ("check", "info", "expand"):
        ran = with_old_xacro(tmp_path, ALONE, command, MOBILE_BASE)
        assert (ran.returncode, ran.stdout) == (2, "")
        assert ran.stderr.startswith("error: the xacro at ros/xacro/__init__.py is not version")
        assert "and 24 more" in ran.stderr


def test_a_plain_robot_needs_no_xacro_but_for_its_srdf(tmp_path: Path) -> None:
    robot = tmp_path / "gripper.urdf"
    robot.write_text(Path(GRIPPER).read_text(encoding="utf-8"), encoding="utf-8")
    name = 'name="gripper" xmlns:xacro="http://ros.org/wiki/xacro"'
    srdf = f'<robot {name}><xacro:property name="a" value="1"/><group name="g"/></robot>'
    (tmp_path / "gripper.srdf.xacro").write_text(srdf)
    ran = with_old_xacro(tmp_path, ALONE, "check", robot)
    assert ran.returncode == 0, ran.stderr
    assert "rules skipped: the xacro at" in " ".join(ran.stdout.split())
