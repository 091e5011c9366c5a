"""The result of Pinocchio's own URDF parser, for comparison."""

from __future__ import annotations

import json
import os
import subprocess
import sys

from urdfkit.core import disk
from urdfkit.core.record import Record

#: Seconds, including the start of Python and the import of Pinocchio.
TIMEOUT = 60


class PinocchioReading(Record):
    """Pinocchio's model of a URDF, or the reason for none."""

    refusal: str  # reason why there is no model; otherwise empty
    #: Messages on standard error, a sentence each, the first cause first.
    complaints: tuple[str, ...]
    #: nq and nv: size of a configuration and a velocity, with a fixed root, including followers.
    nq: int = 0
    nv: int = 0
    mass: float = 0.0  # of all links, in kg
    #: Centre of mass with all joints at zero, in the root frame, in m.
    center: tuple[float, ...] = (0.0, 0.0, 0.0)


def parse_urdf(text: bytes) -> PinocchioReading:
    """Parse a URDF with Pinocchio in a separate process, as the parser may crash on bad text.

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
        return PinocchioReading(f"it takes longer than {TIMEOUT} s", ())
    complaints = _sentences(done.stderr.decode("utf-8", "replace"))
    lines = done.stdout.decode("utf-8", "replace").splitlines()
    if done.returncode or not lines:
        return PinocchioReading(_end(done.returncode), complaints)
    facts = json.loads(lines[-1])
    if "error" in facts:
        return PinocchioReading(complaints[0] if complaints else facts["error"], complaints)
    return PinocchioReading(
        "", complaints, facts["nq"], facts["nv"], facts["mass"], tuple(facts["center"])
    )


def _end(code: int) -> str:
    return f"it crashes (signal {-code})" if code < 0 else f"it ends with exit code {code}"


def _sentences(text: str) -> tuple[str, ...]:
    """The error messages of urdfdom: ``Error:   ...``, each followed by its location in C++."""
    found = (line.partition("Error:")[2].strip() for line in text.splitlines())
    return tuple(dict.fromkeys(line for line in found if line))
