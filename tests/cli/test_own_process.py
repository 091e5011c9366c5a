"""Commands that compute: a library may crash them, a limit may end them, and they leave nothing."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.conftest import MODELS

pytestmark = pytest.mark.skipif(os.name == "nt", reason="Windows cannot fork")

pytest.importorskip("manifold3d")

MESH = MODELS / "good" / "two_link_arm" / "meshes" / "forearm.stl"
#: A command line whose work is done by something else.
WITH = """
import signal, sys, time
import urdfkit.cli.mesh.hull as command
from urdfkit.cli import main
from urdfkit.core import atomic, limits
from urdfkit.errors import MissingLibrary
def work(mesh):
    {}
command.hull = work
signal.signal(signal.SIGINT, signal.default_int_handler)  # jobs of a shell ignore it
sys.argv = ["urdfkit", "mesh", "hull", *sys.argv[1:]]
main()
"""


def start(work: str, *words: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-c", WITH.format(work), str(MESH), *words]
    return subprocess.Popen(
        command, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
    )


def end(work: str, *words: str) -> tuple[int, str, str]:
    process = start(work, *words)
    out, error = process.communicate(timeout=60)
    return process.returncode, out, error


def test_a_library_that_crashes_is_one_line() -> None:
    code, out, error = end("import ctypes; ctypes.string_at(0)")
    assert (code, out) == (2, "")
    assert error == "error: a library crashed (SIGSEGV), in urdfkit.cli.mesh.hull.command\n"


@pytest.mark.parametrize("work", ["sum(range(10**15))", "time.sleep(1000)"])
def test_neither_native_code_nor_sleep_outlasts_the_limit(work: str) -> None:
    code, out, error = end(work, "--timeout", "1.5")
    assert (code, out) == (2, "")
    where = "in urdfkit.cli.mesh.hull.command"
    assert error == f"error: not finished after 1.5 s, {where}; --timeout raises the limit\n"


def test_progress_is_reported() -> None:
    work = "limits.noting(None)(3, 12); time.sleep(1000)"
    assert ": 3 of 12 done, in urdfkit.cli.mesh.hull" in end(work, "--timeout", "1.5")[2]


#: What follows when no more memory can be had.
FULL = """import mmap; taken = []
    try:
        while True:
            taken.append(mmap.mmap(-1, 2**26))
    except OSError:
        pass
    """


@pytest.mark.parametrize(
    "work",
    [
        "bytearray(3 * 2**30)",
        FULL + "raise ImportError('failed to map segment from shared object')",
        FULL + "raise RuntimeError('cannot start new thread')",
        FULL + "raise MissingLibrary('Pinocchio is not installed') from ImportError('no room')",
    ],
    ids=["itself", "import", "thread", "library"],
)
@pytest.mark.skipif(sys.platform != "linux", reason="the others have no such limit")
def test_memory_beyond_the_limit_is_one_line(work: str) -> None:
    code, out, error = end(work, "--memory", "2")
    assert (code, out) == (2, "")
    assert error == "error: not enough memory; --memory raises the limit\n"


@pytest.mark.skipif(sys.platform != "linux", reason="the others have no such limit")
@pytest.mark.parametrize("gigabytes", ["0.365", "0.37", "0.375"])
def test_a_low_memory_limit_does_not_block_a_command(gigabytes: str, tmp_path: Path) -> None:
    """Of so much, OpenBLAS would ask for more for ever, for its threads."""
    words = ["hull", MESH, "-o", tmp_path / "hull.stl", "--memory", gigabytes, "--timeout", "60"]
    command = [sys.executable, "-m", "urdfkit", "mesh", *map(str, words)]
    environment = {name: v for name, v in os.environ.items() if name != "OPENBLAS_NUM_THREADS"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert "not finished after" not in done.stderr


def test_a_missing_library_is_named_despite_a_memory_limit() -> None:
    _, _, error = end("raise MissingLibrary('it is not there') from ImportError('none')")
    assert error == "error: it is not there\n"


def test_a_library_that_ends_the_process_is_one_line() -> None:
    code, out, error = end("import os; os._exit(1)")
    assert (code, out) == (2, "")
    assert error == "error: a library ended the process; perhaps memory ran out\n"


#: Writes a file in two parts, with something between them.
WRITE = """def parts():
        yield b"begin"
        {}
        yield b"end"
    atomic.write({!r}, parts())
    raise KeyboardInterrupt"""


def test_output_is_not_truncated(tmp_path: Path) -> None:
    path = tmp_path / "out"
    code, _, _ = end(WRITE.format("time.sleep(3)", str(path)), "--timeout", "2")
    assert (code, path.read_bytes()) == (130, b"beginend")


@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGKILL, -9)]
)
def test_stopping_the_command_stops_its_process(
    number: signal.Signals, code: int, tmp_path: Path
) -> None:
    pause = 'print("begun", file=sys.stderr, flush=True); time.sleep(1000)'
    work = WRITE.format(pause, str(tmp_path / "out"))
    process = start(work)
    assert process.stderr is not None
    assert process.stderr.readline() == "begun\n"
    process.send_signal(number)
    assert process.wait(timeout=60) == code
    deadline = time.monotonic() + 30
    while time.monotonic() < deadline:
        try:
            os.killpg(process.pid, 0)
        except ProcessLookupError:
            break
        time.sleep(0.02)
    else:
        os.killpg(process.pid, signal.SIGKILL)
        pytest.fail("its process goes on")
    assert list(tmp_path.iterdir()) == []
    process.communicate()


def test_a_signal_to_the_process_group_stops_it_silently() -> None:
    """`timeout` sends SIGTERM to the command, and then to its group."""
    process = start('print("begun", file=sys.stderr, flush=True); time.sleep(1000)')
    assert process.stderr is not None
    assert process.stderr.readline() == "begun\n"
    process.send_signal(signal.SIGTERM)
    os.killpg(process.pid, signal.SIGTERM)
    out, error = process.communicate(timeout=60)
    assert (process.returncode, out, error.strip()) == (143, "", "")


@pytest.mark.parametrize("option", ["--timeout", "--memory"])
def test_limits_have_defaults(option: str) -> None:
    command = [sys.executable, "-m", "urdfkit", "mesh", "hull", "--help"]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert re.search(rf"{option} .*?\[default:\s+[\d.]+;", text, re.DOTALL)
