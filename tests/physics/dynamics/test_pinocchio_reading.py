"""Pinocchio's own reading in a process of its own: reasons are captured, crashes contained."""

import pytest

pytest.importorskip("pinocchio")

from tests.conftest import MODELS
from urdfkit.lint.loading import read
from urdfkit.physics.dynamics import pinocchio_process, pinocchio_reading
from urdfkit.physics.dynamics.pinocchio_reading import PinocchioReading


def test_the_mission_s_model() -> None:
    """Pinocchio accepts it, and says nothing."""
    robot = read(MODELS / "gazebo_pkg" / "urdf" / "waking_robot_new.xacro")
    found = pinocchio_reading.parse_urdf(robot.text)
    assert (found.refusal, found.complaints, found.nq, found.nv) == ("", (), 8, 4)
    assert found.mass == pytest.approx(10.2301, rel=1e-9)
    center = robot.dynamics.mass_properties().center
    assert found.center == pytest.approx(center, rel=1e-9, abs=1e-12)


def test_the_reason_is_that_of_the_first_complaint() -> None:
    joint = '<joint name="j" type="revolute"><parent link="a"/><child link="b"/>{}</joint>'
    text = '<robot name="r"><link name="a"/><link name="b"/>' + joint + "</robot>"
    limit = '<limit lower="0" upper="1" velocity="1"/>'
    found = pinocchio_reading.parse_urdf(text.format(limit).encode())
    assert found.refusal == "joint [j]: limit has no effort"
    assert len(found.complaints) > 1


@pytest.mark.parametrize(
    "text", [b"", b"<robot", b"\xff\xfe\x00", b"<robot name='r'/>", b"<sdf/>", b"[" * 100_000]
)
def test_what_is_no_robot_is_refused(text: bytes) -> None:
    assert pinocchio_reading.parse_urdf(text).refusal


def test_a_mass_that_is_no_number_drops_the_inertial_and_is_reported() -> None:
    inertia = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
    text = (
        f'<robot name="r"><link name="a"><inertial><mass value="nan"/>{inertia}</inertial></link>'
        "</robot>"
    )
    found = pinocchio_reading.parse_urdf(text.encode())
    assert (found.refusal, found.mass) == ("", 0.0)
    assert found.complaints[0] == "Inertial: mass [nan] is not a float"


def test_a_tensor_without_an_entry_is_dropped_and_its_mass_kept() -> None:
    """So that the link weighs and does not resist turning; the complaint tells it."""
    inertia = '<inertia ixx="1" ixz="0" iyy="1" iyz="0" izz="1"/>'
    text = (
        f'<robot name="r"><link name="a"><inertial><mass value="2"/>{inertia}</inertial></link>'
        "</robot>"
    )
    found = pinocchio_reading.parse_urdf(text.encode())
    assert (found.refusal, found.mass) == ("", 2.0)
    assert found.complaints[0] == "Inertial: inertia element missing ixy attribute"


def test_a_crash_is_contained() -> None:
    """Its parser recurses over the depth of the tree."""
    links = "".join(f'<link name="l{number}"/>' for number in range(30_001))
    joints = "".join(
        f'<joint name="j{n}" type="fixed"><parent link="l{n}"/><child link="l{n + 1}"/></joint>'
        for n in range(30_000)
    )
    found = pinocchio_reading.parse_urdf(f'<robot name="r">{links}{joints}</robot>'.encode())
    assert found.refusal.startswith("it crashes (signal ")


def test_what_takes_too_long_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pinocchio_reading, "TIMEOUT", 0.05)
    assert pinocchio_reading.parse_urdf(b"<robot/>") == PinocchioReading(
        "it takes longer than 0.05 s", ()
    )
    assert pinocchio_process.SECONDS < 60
