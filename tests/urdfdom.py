"""What urdfdom says of a robot, by its program check_urdf."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from urdfkit.lint.rule_examples import whole_robot

CHECK_URDF = shutil.which("check_urdf")
needs_check_urdf = pytest.mark.skipif(CHECK_URDF is None, reason="check_urdf is not installed")

#: Bytes of an answer: it prints some loops for ever.
ENOUGH = 100_000


def urdfdom(text: str, directory: Path) -> tuple[int, str]:
    """Exit code and words about a robot, or the inside of one; what does not end is refused."""
    import resource  # there is none on Windows, nor a check_urdf

    assert CHECK_URDF is not None
    (directory / "robot.urdf").write_bytes(whole_robot(text).encode())
    with open(directory / "answer.txt", "w+", encoding="utf-8") as answer:
        done = subprocess.run(
            [CHECK_URDF, directory / "robot.urdf"],
            check=False,
            stdout=answer,
            stderr=subprocess.STDOUT,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (ENOUGH, ENOUGH)),
            timeout=60,
            # pip's check_urdf is a script: the limit would cut the bytecode of modules.
            env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
        )
        answer.seek(0)
        return done.returncode, answer.read()


def urdfdom_reads(text: str, directory: Path) -> bool:
    """True if urdfdom takes the robot."""
    return urdfdom(text, directory)[0] == 0
