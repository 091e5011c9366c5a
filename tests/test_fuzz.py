"""A short run of every fuzzing harness, and the inputs that once brought a defect to light."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import ROOT

pytest.importorskip("resource", reason="memory is limited on Unix only")
pytest.importorskip("numpy")
pytest.importorskip("pygls")

from fuzz.execution import _scratch, execute
from fuzz.harnesses import HARNESSES

CRASHERS = sorted(path for path in (ROOT / "fuzz" / "crashers").rglob("*") if path.is_file())


@pytest.mark.parametrize("name", HARNESSES)
def test_a_short_run(name: str, pytestconfig: pytest.Config):
    """Apart from this process, which a defect may end."""
    count = 2000 if pytestconfig.getoption("thorough") else 100
    done = subprocess.run(
        [sys.executable, "-m", "fuzz", name, "--executions", str(count)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.startswith(f"{name}: {count} executions, ")


@pytest.mark.parametrize("path", CRASHERS, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_a_crasher(path: Path):
    with _scratch():
        assert execute(HARNESSES[path.parent.name], path.read_bytes()) is None


def test_a_defect_is_seen(tmp_path: Path):
    """Errors, hangs and deaths of the process: a harness that finds none must not be blind."""
    program = """
import os, sys
from fuzz import execution
from fuzz.harnesses import HARNESSES, Harness

def run(data):
    if len(data) % 3 == 0:
        raise ValueError("planted")
    if len(data) % 3 == 1:
        while True:
            pass
    os.abort()

execution.SECONDS = 0.2
HARNESSES["planted"] = Harness(lambda: [b"a", b"bb", b"ccc"], run)
print(sorted(defect.title for defect in execution.fuzz("planted", 10)))
"""
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert done.stdout == (
        "['Hang at outside of urdfkit', 'ValueError at outside of urdfkit', "
        "'the process ended with -6']\n"
    )
