"""A second opinion: what Pinocchio itself makes of a URDF."""

from __future__ import annotations

import json
import os
import subprocess
import sys

from urdfkit.core import disk
from urdfkit.core.record import Record

#: Seconds, with the start of Python and the import of Pinocchio.
TIMEOUT = 60


class PinocchioReading(Record):
    """What Pinocchio says of a text."""

    refusal: str  # why it makes no model; empty if it does
    #: What it wrote to standard error, a sentence each, the first cause first.
    complaints: tuple[str, ...]
    #: nq and nv: numbers of a configuration and a velocity, the root fixed, followers counted.
    nq: int = 0
    nv: int = 0
    mass: float = 0.0  # of all links, in kg
    #: Of mass, all joints at zero, in the frame of the root, in m.
    center: tuple[float, ...] = (0.0, 0.0, 0.0)


def opinion(text: bytes) -> PinocchioReading:
    """Ask Pinocchio in a process of its own, since its parser may crash on hostile text.

    Args:
        text: a URDF, expanded.
    """
    child = os.path.join(os.path.dirname(os.path.abspath(__file__)), "pinocchio_process.py")
    try:
        done = subprocess.run(
            [sys.executable, child], input=text, capture_output=True, check=False, timeout=TIMEOUT
        )
    except subprocess.TimeoutExpired:
        disk.depends_on_more()  # on a faster machine it may be done in time
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
    """The reasons that urdfdom writes: ``Error:   ...``, each followed by its place in C++."""
    found = (line.partition("Error:")[2].strip() for line in text.splitlines())
    return tuple(dict.fromkeys(line for line in found if line))
