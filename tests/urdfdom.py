"""What urdfdom says of a robot, by its program check_urdf."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from urdfkit.lint.rule_examples import whole_robot


def _program() -> Path | None:
    """check_urdf; where that is pip's script, the program that it starts."""
    found = shutil.which("check_urdf")
    if found is None:
        return None
    installed = Path(found).resolve().parents[1].glob("lib/python*/site-packages/cmeel.prefix/bin")
    return next((directory / "check_urdf" for directory in installed), Path(found))


CHECK_URDF = _program()
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
            env={**os.environ, "LD_LIBRARY_PATH": str(CHECK_URDF.parents[1] / "lib")},
        )
        answer.seek(0)
        return done.returncode, answer.read()


def urdfdom_reads(text: str, directory: Path) -> bool:
    """True if urdfdom takes the robot."""
    return urdfdom(text, directory)[0] == 0
