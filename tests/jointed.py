"""Robots for the tests of the rules about joints."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from urdfkit.examples import whole_robot

CHECK_URDF = shutil.which("check_urdf")
needs_check_urdf = pytest.mark.skipif(CHECK_URDF is None, reason="check_urdf is not installed")


def joint(name: str, kind: str, content: str = "", parent: str = "base") -> str:
    """A joint that holds the link of its name, with that link; on two lines."""
    return (
        f'<link name="{name}_link"/>\n'
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/>'
        f'<child link="{name}_link"/>{content}</joint>\n'
    )


def limit(lower: str, upper: str, effort: str = "10", velocity: str = "1") -> str:
    return f'<limit lower="{lower}" upper="{upper}" effort="{effort}" velocity="{velocity}"/>'


def mimic(leader: str, rest: str = "") -> str:
    return f'<mimic joint="{leader}" {rest}/>'


def robot(*joints: str) -> str:
    """Joints on a base; the joint with the number n from 0 is on line 4 + 2 n."""
    return '<link name="base"/>\n' + "".join(joints)


def of_xacro(content: str) -> str:
    return f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{content}</robot>'


def urdfdom_reads(text: str, folder: Path) -> bool:
    """True if urdfdom takes the robot."""
    assert CHECK_URDF is not None
    (folder / "robot.urdf").write_text(whole_robot(text), encoding="utf-8")
    run = subprocess.run([CHECK_URDF, folder / "robot.urdf"], capture_output=True, check=False)
    return run.returncode == 0
