"""Standard input, output and error that are closed, full, or read by nobody."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.command_line import UNIX
from tests.conftest import ROOT
from tests.shipped import GRIPPER


@UNIX
@pytest.mark.parametrize("words", [["rules"], ["check", "-"], ["check", "-", "--format", "json"]])
def test_a_closed_pipe_is_not_an_error(words: list[str]) -> None:
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

    done = shell(f'"{GRIPPER}" >&-')
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.startswith(b"error: standard output is closed")
    done = shell("- <&-")
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.startswith(b"error: standard input is closed")
    done = shell("no_such.urdf 2>&-")
    assert (done.returncode, done.stdout) == (2, b"")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
def test_a_full_disk() -> None:
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "urdfkit", "check", GRIPPER],
            check=False,
            cwd=ROOT,
            stdout=full,
            stderr=subprocess.PIPE,
            timeout=60,
        )
    assert done.returncode == 2
    assert done.stderr == b"error: standard output: No space left on device\n"


@UNIX
def test_an_error_on_a_closed_stream_has_its_exit_code() -> None:
    reader, writer = os.pipe()
    os.close(reader)
    for words in (["tree", "none.urdf"], ["chek"], ["check", "none.urdf"]):
        command = [sys.executable, "-m", "urdfkit", *words]
        done = subprocess.run(command, check=False, stdout=writer, stderr=writer, timeout=60)
        assert done.returncode == 2, words
    os.close(writer)
