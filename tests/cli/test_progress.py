"""The progress line: late, on terminals only, and gone in the end."""

import io
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.conftest import GRIPPER, MODELS, ROOT
from urdfkit.cli import main, progress
from urdfkit.cli.progress import ProgressBar, on_terminal
from urdfkit.mesh.samples import box, stl

UNIX = pytest.mark.skipif(os.name == "nt", reason="no pseudo-terminal on Windows")


class Clock:
    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 100.0
        monkeypatch.setattr(time, "monotonic", lambda: self.now)


def test_it_appears_after_a_second_and_is_cleared(monkeypatch: pytest.MonkeyPatch) -> None:
    clock, stream = Clock(monkeypatch), io.StringIO()
    bar = ProgressBar(stream)
    clock.now += 0.9
    bar(1, 4)
    bar.clear()
    assert stream.getvalue() == ""
    clock.now += 0.2
    bar(2, 4)
    bar(4, 4)
    bar.clear()
    bar.clear()
    assert stream.getvalue() == (f"\r[{'#' * 15}{' ' * 15}] 2 of 4\r[{'#' * 30}] 4 of 4\r\x1b[K")


def test_a_job_of_unknown_length_shows_that_it_runs(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    clock, stream = Clock(monkeypatch), io.StringIO()
    bar = ProgressBar(stream)
    monkeypatch.setattr(progress, "on_terminal", lambda: bar)
    clock.now += 2
    with progress.working():
        assert stream.getvalue() == "\rworking ..."
    assert stream.getvalue() == "\rworking ...\r\x1b[K"
    monkeypatch.setattr(progress, "on_terminal", lambda: None)
    with progress.working():
        pass


def test_a_closed_terminal_does_not_stop_the_check(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock(monkeypatch)

    class Gone(io.StringIO):
        def write(self, text: str) -> int:
            raise OSError(5, "Input/output error")

    bar = ProgressBar(Gone())
    clock.now += 2
    bar(1, 2)
    bar.clear()


@pytest.mark.parametrize(
    ("is_terminal", "term", "shown"),
    [(True, "xterm", True), (True, "dumb", False), (False, "xterm", False)],
)
def test_only_terminals_show_it(
    is_terminal: bool, term: str, shown: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TERM", term)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: is_terminal, raising=False)
    assert (on_terminal() is not None) is shown


def test_without_standard_error_there_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", None)
    assert on_terminal() is None


PROGRAM = """
import sys
from urdfkit.cli import main, progress
progress.DELAY = 0.0
sys.exit(main(sys.argv[1:]))
"""


def on_a_terminal(*words: str | Path, command: str = "check") -> tuple[str, str]:
    """Standard output, and what a terminal as standard error is sent."""
    import pty  # not on Windows

    ours, theirs = pty.openpty()
    process = subprocess.Popen(
        [sys.executable, "-c", PROGRAM, command, *map(str, words)],
        cwd=ROOT,
        env={**os.environ, "TERM": "xterm", "URDFKIT_CACHE_DIR": ""},
        stdout=subprocess.PIPE,
        stderr=theirs,
        text=True,
    )
    out, _ = process.communicate(timeout=60)
    os.close(theirs)
    time.sleep(0.05)
    os.set_blocking(ours, False)
    try:
        reported = os.read(ours, 10_000).decode()
    except OSError:  # nothing was written
        reported = ""
    os.close(ours)
    return out, reported


@UNIX
def test_a_directory_on_a_terminal() -> None:
    out, reported = on_a_terminal(MODELS / "good", "--exit-zero")
    assert reported.startswith("\rworking ...\r["), "before the first robot is found"
    assert "] 3 of 3" in reported
    assert reported.endswith("\r\x1b[K")
    assert "\x1b" not in out
    assert "[#" not in out


@UNIX
def test_one_file_without_meshes_has_no_bar() -> None:
    assert on_a_terminal(GRIPPER)[1] == "\rworking ...\r\x1b[K"


@UNIX
@pytest.mark.parametrize("command", ["check", "info", "inertia"])
def test_one_file_shows_its_meshes(command: str, tmp_path: Path) -> None:
    pytest.importorskip("trimesh")
    for name in ("a", "b"):
        (tmp_path / f"{name}.stl").write_bytes(stl(box((0, 0, 0), (1, 1, 1))))
    file = tmp_path / "r.urdf"
    file.write_text(
        '<robot name="r"><link name="l"><inertial><mass value="1"/><inertia ixx="1" ixy="0" '
        'ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
        '<visual><geometry><mesh filename="a.stl"/></geometry></visual>'
        '<collision><geometry><mesh filename="b.stl"/></geometry></collision></link></robot>'
    )
    _, reported = on_a_terminal(file, command=command)
    assert reported.startswith(f"\rworking ...\r[{' ' * 30}] 0 of 2 mesh files")
    assert reported.endswith("\r\x1b[K")


def test_it_appears_during_a_long_first_step(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress, "DELAY", 0.05)
    stream = io.StringIO()
    bar = ProgressBar(stream, "things")
    bar(0, 2)  # nobody calls it again
    deadline = time.monotonic() + 5
    while not stream.getvalue() and time.monotonic() < deadline:
        time.sleep(0.01)
    bar.clear()
    assert stream.getvalue() == f"\r[{' ' * 30}] 0 of 2 things\r\x1b[K"


def test_no_line_is_drawn_after_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress, "DELAY", 0.05)
    stream = io.StringIO()
    bar = ProgressBar(stream)
    bar(1, 2)
    bar.clear()
    time.sleep(0.1)
    assert stream.getvalue() == ""


def test_on_a_pipe_there_is_none() -> None:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, "check", str(MODELS / "good")],
        check=False,
        cwd=ROOT,
        capture_output=True,
    )
    assert done.stderr == b""


@pytest.mark.parametrize(
    "words",
    [
        "tree {robot}",
        "kinematics {robot}",
        "gazebo {robot}",
        "importers {robot} --for drake",
        "expand {robot}",
        "trace {robot} /robot",
        "migrate {robot} --to gz-harmonic",
        "doctor {robot}",
        "init {directory} --print",
        "format {directory} --check",
        "check {directory} --show-files",
    ],
)
def test_commands_that_may_take_long_show_that_they_run(
    words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    robot = tmp_path / "robot.urdf.xacro"
    robot.write_bytes((GRIPPER).read_bytes())
    monkeypatch.setattr(progress, "DELAY", 0)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("TERM", "xterm")
    assert main([part.format(robot=robot, directory=tmp_path) for part in words.split()]) in (0, 1)
    shown = capsys.readouterr().err
    assert shown.startswith(("\rworking ...", "\r[")), words
    assert "\r\x1b[K" in shown
