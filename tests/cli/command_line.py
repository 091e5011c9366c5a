"""The command line in a process of its own."""

import os
import subprocess
import sys

import pytest

from tests.conftest import ROOT

UNIX = pytest.mark.skipif(os.name == "nt", reason="no such thing on Windows")


def run(*words: str, stdin: bytes = b"") -> subprocess.CompletedProcess[bytes]:
    """``python -m urdfkit`` as its own process."""
    command = [sys.executable, "-m", "urdfkit", *words]
    return subprocess.run(
        command, check=False, cwd=ROOT, input=stdin, capture_output=True, timeout=60
    )
