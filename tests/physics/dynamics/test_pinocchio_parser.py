"""Pinocchio's own URDF parser in a process of its own: reasons are captured, crashes contained."""

import pytest

pytest.importorskip("pinocchio")

from tests.conftest import MISSION
from urdfkit.lint.loading import read
from urdfkit.physics.dynamics import pinocchio_parser, pinocchio_process
from urdfkit.physics.dynamics.pinocchio_parser import why_rejected


def test_the_mission_s_model() -> None:
    robot = read(MISSION)
    assert why_rejected(robot.text) == ""


def test_the_reason_is_that_of_the_first_error_message() -> None:
    joint = '<joint name="j" type="revolute"><parent link="a"/><child link="b"/>{}</joint>'
    text = '<robot name="r"><link name="a"/><link name="b"/>' + joint + "</robot>"
    limit = '<limit lower="0" upper="1" velocity="1"/>'
    assert why_rejected(text.format(limit).encode()) == "joint [j]: limit has no effort"


@pytest.mark.parametrize(
    "text", [b"", b"<robot", b"\xff\xfe\x00", b"<robot name='r'/>", b"<sdf/>", b"[" * 100_000]
)
def test_what_is_no_robot_is_rejected(text: bytes) -> None:
    assert why_rejected(text)


def test_an_error_message_alone_is_no_rejection() -> None:
    """Of an inertial whose mass is no number urdfdom complains, and drops it."""
    inertia = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
    inertial = f'<inertial><mass value="nan"/>{inertia}</inertial>'
    assert why_rejected(f'<robot name="r"><link name="a">{inertial}</link></robot>'.encode()) == ""


def test_a_crash_is_contained() -> None:
    """Its parser recurses over the depth of the tree."""
    links = "".join(f'<link name="l{number}"/>' for number in range(30_001))
    joints = "".join(
        f'<joint name="j{n}" type="fixed"><parent link="l{n}"/><child link="l{n + 1}"/></joint>'
        for n in range(30_000)
    )
    text = f'<robot name="r">{links}{joints}</robot>'.encode()
    assert why_rejected(text).startswith("it crashes (signal ")


def test_what_takes_too_long_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pinocchio_parser, "TIMEOUT", 0.05)
    assert why_rejected(b"<robot/>") == "it takes longer than 0.05 s"
    assert pinocchio_process.SECONDS < 60
