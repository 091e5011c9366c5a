"""Pinocchio's own URDF parser, in a separate process, as it may crash on bad text."""

import json
import os
import subprocess
import sys

from urdfkit.core import disk

#: Seconds, including the start of Python and the import of Pinocchio.
TIMEOUT = 60


def why_rejected(text: bytes) -> str:
    """The reason why Pinocchio rejects a URDF; empty if it accepts the URDF.

    Args:
        text: an expanded URDF.
    """
    child = os.path.join(os.path.dirname(os.path.abspath(__file__)), "pinocchio_process.py")
    try:
        done = subprocess.run(
            [sys.executable, child], input=text, capture_output=True, check=False, timeout=TIMEOUT
        )
    except subprocess.TimeoutExpired:
        disk.depends_on_more()  # a faster machine may finish in time
        return f"it takes longer than {TIMEOUT} s"
    lines = done.stdout.decode("utf-8", "replace").splitlines()
    if done.returncode or not lines:
        code = done.returncode
        return f"it crashes (signal {-code})" if code < 0 else f"it ends with exit code {code}"
    error: str = json.loads(lines[-1])["error"]
    return error and (_first_error(done.stderr.decode("utf-8", "replace")) or error)


def _first_error(text: str) -> str:
    """The first error message of urdfdom: ``Error:   ...``, followed by its location in C++."""
    messages = (line.partition("Error:")[2].strip() for line in text.splitlines())
    return next(filter(None, messages), "")
