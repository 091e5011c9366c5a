"""The command line as a whole: exit codes, errors, and where what is written."""

import errno
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import urdfkit
from tests.conftest import MODELS, ROOT
from urdfkit.cli import checking, main, output
from urdfkit.core.libraries import missing_for_meshes
from urdfkit.lint import rule_index
from urdfkit.text.source import shown

GOOD = str(MODELS / "good" / "gripper.urdf")
SHOWN = shown(GOOD)
UNIX = pytest.mark.skipif(os.name == "nt", reason="no such thing on Windows")


def run(*words: str, stdin: bytes = b"") -> subprocess.CompletedProcess[bytes]:
    """``python -m urdfkit`` as its own process."""
    command = [sys.executable, "-m", "urdfkit", *words]
    return subprocess.run(
        command, check=False, cwd=ROOT, input=stdin, capture_output=True, timeout=60
    )


def test_a_clean_robot_exits_with_0() -> None:
    done = run("check", GOOD)
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


@pytest.mark.parametrize(
    ("word", "suggested"),
    [("lint", "check"), ("chek", "check"), ("xacro", "expand"), ("help", "--help")],
)
def test_a_command_of_another_tool(
    word: str, suggested: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([word]) == 2
    assert f"unknown command '{word}'; did you mean '{suggested}'?" in capsys.readouterr().err


needs_meshes = pytest.mark.skipif(bool(missing_for_meshes()), reason="it needs the extra meshes")
MESH = pytest.param(["mesh"], marks=needs_meshes)


@pytest.mark.parametrize(
    "words", [[], ["check"], MESH, pytest.param(["mesh", "hull"], marks=needs_meshes)]
)
def test_the_short_option_for_help(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*words, "-h"]) == 0
    assert capsys.readouterr().out.startswith(" ".join(["Usage: urdfkit", *words]))


def test_without_a_command_there_is_help(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 0
    captured = capsys.readouterr()
    assert all(name in captured.out for name in ("check", "explain", "rules", "--version"))
    assert captured.err == ""


@pytest.mark.parametrize("group", [[], MESH])
def test_what_each_command_does_is_told_on_one_line_of_80_columns(
    group: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert main([*group, "--help"]) == 0
    _, *lines = capsys.readouterr().out.splitlines()
    assert [line for line in lines if line.endswith("...")] == []
    assert max(map(len, lines)) <= 80


@pytest.mark.parametrize("command", [[], ["check"], ["explain"], ["rules"]])
def test_help_of_every_command(command: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*command, "--help"]) == 0
    assert capsys.readouterr().out.startswith(" ".join(["Usage: urdfkit", *command]) + " ")


def test_to_ignore_a_rule_that_is_none_is_warned_of(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", GOOD, "--ignore", "QQQ,XLM001"]) == 0
    assert capsys.readouterr().err.splitlines() == [
        "warning: --ignore: no rule 'QQQ'; 'urdfkit rules' lists them",
        "warning: --ignore: no rule 'XLM001'; did you mean 'XML001'?",
    ]


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["chek", "a"], "'chek'"),
        (["--verbose"], "--verbose"),
        (["check"], "no file to check"),
        (["check", "a", "--slect", "MSH"], "--select"),
        (["check", "a", "--fail-on", "fatal"], "'error', 'warning', 'info'"),
        (["check", "a", "--select"], "--select"),
        (["check", GOOD, "--select", "XLM001"], "did you mean 'XML001'?"),
        (["check", GOOD, "--target", "movit"], "did you mean 'moveit'?"),
        (["check", "no_such.urdf"], "no_such.urdf: file not found"),
        (["check", ""], "'': file not found"),
        (["check", GOOD, "no_such.urdf"], "no_such.urdf: file not found"),
        (["check", GOOD.replace("gripper", "griper")], "did you mean 'gripper.urdf'?"),
        (["check", "/no/such/directory/robot.urdf"], "no such directory '/no/such/directory'"),
        (["check", GOOD, "--format", "json:/no/such/r.json"], "no such directory '/no/such'"),
        (["explain"], "RULE"),
        (["explain", "XML0001"], "did you mean 'XML001'?"),
        (["rules", "--format", "yaml"], "'text', 'json'"),
    ],
)
def test_what_cannot_be_done_is_one_line_and_exit_2(
    words: list[str], reason: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("error: ")
    assert captured.err.count("\n") == 1
    assert reason in captured.err


def test_an_error_does_not_steer_the_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "no\x1b[2J\n.urdf"]) == 2
    assert capsys.readouterr().err == "error: no\\x1b[2J .urdf: file not found\n"


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
def test_rubbish_is_a_finding(
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
    text = Path(GOOD).read_text(encoding="utf-8")
    outputs = []
    for encoding in ("utf-8", "utf-16"):
        file = tmp_path / "robot.urdf"
        file.write_bytes(text.encode(encoding))
        code = main(["check", str(file), "--ignore", "XML002"])
        outputs.append((code, capsys.readouterr().out))
    assert outputs[0] == outputs[1]


def test_an_exception_of_ours_asks_to_report_it(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise ValueError("boom")

    monkeypatch.setattr(checking, "check_with", fail)
    monkeypatch.delenv("URDFKIT_DEBUG", raising=False)
    assert main(["check", GOOD]) == 3
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "ValueError: boom" in captured.err
    assert "bug in urdfkit" in captured.err
    assert "Traceback" not in captured.err
    monkeypatch.setenv("URDFKIT_DEBUG", "1")
    assert main(["check", GOOD]) == 3
    assert "Traceback" in capsys.readouterr().err


@pytest.mark.parametrize("words", [["check", GOOD], ["check", GOOD, "--", GOOD]])
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
    """On a busy machine the first of them is, at times, the last to hear of it."""
    robot = (MODELS / "good" / "mobile_base" / "urdf" / "mobile_base.urdf.xacro").read_bytes()
    for number in range(1500):
        (tmp_path / f"{number}.xacro").write_bytes(robot)
    command = [sys.executable, "-m", "urdfkit", "check", str(tmp_path), "--jobs", "2"]
    with subprocess.Popen(
        command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
    ) as process:
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


@UNIX
@pytest.mark.parametrize("words", [["rules"], ["check", "-"], ["check", "-", "--format", "json"]])
def test_a_reader_that_goes_away_is_no_error(words: list[str]) -> None:
    """The exit code is still that of the check."""
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, "-m", "urdfkit", *words]
    try:
        done = subprocess.run(
            command,
            check=False,
            cwd=ROOT,
            input=b"<robot",
            stdout=writer,
            stderr=subprocess.PIPE,
            timeout=60,
        )
    finally:
        os.close(writer)
    assert (done.returncode, done.stderr) == (int(words[0] == "check"), b"")


@UNIX
def test_closed_standard_streams() -> None:
    def shell(redirection: str) -> subprocess.CompletedProcess[bytes]:
        line = f'"{sys.executable}" -m urdfkit check {redirection}'
        return subprocess.run(
            ["sh", "-c", line], check=False, cwd=ROOT, capture_output=True, timeout=60
        )

    done = shell(f'"{GOOD}" >&-')
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.startswith(b"error: standard output is closed")
    done = shell("- <&-")
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.startswith(b"error: standard input is closed")
    done = shell("no_such.urdf 2>&-")
    assert (done.returncode, done.stdout) == (2, b"")


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


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
def test_a_full_disk() -> None:
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "urdfkit", "check", GOOD],
            check=False,
            cwd=ROOT,
            stdout=full,
            stderr=subprocess.PIPE,
            timeout=60,
        )
    assert done.returncode == 2
    assert done.stderr == b"error: standard output: No space left on device\n"


def test_a_file_name_that_is_no_text(tmp_path: Path) -> None:
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


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (OSError(errno.ENOSPC, "No space left on device"), "error: No space left on device\n"),
        (MemoryError(), "error: not enough memory\n"),
        (OSError(errno.ENOMEM, "Cannot allocate memory"), "error: not enough memory\n"),
    ],
    ids=["disk", "memory", "system"],
)
def test_a_machine_that_is_full_is_no_bug(
    error: Exception,
    message: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr(checking, "check_with", fail)
    assert main(["check", GOOD]) == 2
    assert capsys.readouterr().err == message


def test_a_rule_that_lacks_memory_is_no_bug(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(*_: object) -> None:
        try:
            raise MemoryError
        except MemoryError:
            raise SystemError("error return without exception set") from None

    monkeypatch.setattr(rule_index, "applicable", fail)
    assert main(["check", GOOD, "--no-cache"]) == 2
    assert re.fullmatch(r"error: \S+: not enough memory\n", capsys.readouterr().err)


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


def test_expand_makes_the_directory_of_its_output_unless_a_file_is_in_the_way(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["expand", GOOD, "-o", str(tmp_path / "new" / "r.urdf")]) == 0
    assert (tmp_path / "new" / "r.urdf").exists()
    (tmp_path / "file").touch()
    assert main(["expand", GOOD, "-o", str(tmp_path / "file" / "r.urdf")]) == 2
    assert (
        f"{tmp_path / 'file'}: cannot create this directory: File exists" in capsys.readouterr().err
    )


@pytest.mark.parametrize(("columns", "expected"), [("40", 40), ("200", 200), ("0", 80), ("x", 80)])
def test_the_width_is_that_of_the_variable(
    columns: str, expected: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    assert output.width() == expected


@pytest.mark.parametrize(
    ("word", "message"),
    [
        ("chekc", "unknown command 'chekc'; did you mean 'check'?"),
        (GOOD, f"unknown command '{SHOWN}'; to check that file: urdfkit check {SHOWN}"),
        ("nothing", "unknown command 'nothing'"),
    ],
)
def test_a_slip_in_the_name_of_a_command(
    word: str, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([word]) == 2
    assert capsys.readouterr().err == f"error: {message} (see 'urdfkit --help')\n"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["tree"], "missing argument 'FILE [NAME:=VALUE]...'"),
        (["inertia", GOOD, "--mass", "heavy"], "invalid value for '--mass': 'heavy' is not a "),
        (["inertia", GOOD, "--mass", "1", "--density", "1"], "--mass, --density and --material"),
    ],
)
def test_usage_errors_begin_like_all_others(
    words: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 2
    assert capsys.readouterr().err.startswith(f"error: {message}")


@UNIX
def test_an_error_that_nobody_reads_is_an_error_still() -> None:
    reader, writer = os.pipe()
    os.close(reader)
    for words in (["tree", "none.urdf"], ["chek"], ["check", "none.urdf"]):
        command = [sys.executable, "-m", "urdfkit", *words]
        done = subprocess.run(command, check=False, stdout=writer, stderr=writer, timeout=60)
        assert done.returncode == 2, words
    os.close(writer)
