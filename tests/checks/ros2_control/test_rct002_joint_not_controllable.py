"""RCT002: see the rule."""

import pytest

from tests.controls import CLASSIC, GZ, MOCK, NEXT, ROBOT, control, driven, transmission
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity


def test_a_fixed_joint_in_ros2_control() -> None:
    text = ROBOT + control('<joint name="weld"><state_interface name="position"/></joint>')
    assert messages("RCT002", text) == ["<ros2_control> 'c' has joint 'weld', which is fixed"]
    assert places("RCT002", text) == [(NEXT + 2, "weld")]


def test_a_fixed_joint_in_a_transmission() -> None:
    text = ROBOT + transmission("weld")
    assert messages("RCT002", text) == [naming("t", "weld", "fixed")]
    assert reported("RCT002", text, targets=("gz-harmonic",)) == []


@pytest.mark.parametrize("name", ["swing", "slide", "nobody", ""])
def test_joints_that_move_or_are_unknown(name: str) -> None:
    assert reported("RCT002", ROBOT + control(driven(name))) == []
    assert reported("RCT002", ROBOT + transmission(name)) == []


@pytest.mark.parametrize(
    ("targets", "severity"), [(("ros1",), Severity.WARNING), (("classic-ros1",), Severity.ERROR)]
)
def test_a_fixed_wheel_matters_in_gazebo(targets: tuple[str, ...], severity: Severity) -> None:
    """SMB: the wheels of the real robot are fixed in its model."""
    (found,) = reported("RCT002", ROBOT + transmission("weld"), targets=targets)
    assert found.severity is severity


def test_a_transmission_of_the_pr2_is_not_read() -> None:
    """Atlas: its fixed lidar has one."""
    kind = "<type>transmission_interface/SimpleTransmission</type>"
    text = transmission("weld").replace(kind, "")
    text = text.replace('name="t"', 'name="t" type="pr2_mechanism_model/SimpleTransmission"')
    assert reported("RCT002", ROBOT + text, targets=("classic-ros1",)) == []


def test_interface_of_a_vendor_is_ignored() -> None:
    joint = (
        '<transmission name="model"><type>franka_hw/FrankaModelInterface</type>'
        '<joint name="weld"><hardwareInterface>franka_hw/FrankaModelInterface'
        "</hardwareInterface></joint></transmission>"
    )
    assert reported("RCT002", ROBOT + joint) == []


BAD = ROBOT + control(driven("swing"), driven("follow", "velocity"))


def test_a_follower_with_a_command() -> None:
    assert messages("RCT002", BAD) == [naming("follow", "swing", "velocity")]
    assert places("RCT002", BAD) == [(NEXT + 3, '<command_interface name="velocity"/>')]


@pytest.mark.parametrize(
    ("targets", "severity"),
    [
        (("ros2",), Severity.ERROR),
        (("gz-harmonic",), Severity.ERROR),
        (("gz-jetty", "ros2"), Severity.ERROR),
        (("gz-fortress",), Severity.WARNING),
        (("classic-ros2", "ros2"), Severity.WARNING),
    ],
)
def test_severity_by_target(targets: tuple[str, ...], severity: Severity) -> None:
    (found,) = reported("RCT002", BAD, targets=targets)
    assert found.severity is severity


def test_a_follower_without_command() -> None:
    state = '<joint name="follow"><state_interface name="position"/></joint>'
    assert reported("RCT002", ROBOT + control(driven("swing"), state)) == []


def test_follower_with_its_own_motor() -> None:
    own = driven("follow").replace("<joint ", '<joint mimic="False" ')
    assert reported("RCT002", ROBOT + control(driven("swing"), own)) == []
    same = driven("follow").replace("<joint ", '<joint mimic="true" ')
    assert len(reported("RCT002", ROBOT + control(driven("swing"), same))) == 1


def test_mimic_parameter_of_humble() -> None:
    old = driven("follow", more='<param name="mimic">swing</param>')
    assert reported("RCT002", ROBOT + control(driven("swing"), old)) == []


FOLLOWS = '<param name="mimic">swing</param><param name="multiplier">1</param>'


def test_a_parameter_of_humble_for_jazzy() -> None:
    text = ROBOT + control(driven("slide", more=FOLLOWS), plugin=GZ)
    assert messages("RCT002", text) == [naming("slide", "swing", "ros2_control", "Jazzy")]


@pytest.mark.parametrize(
    ("joint", "hardware"),
    [("slide", CLASSIC), ("slide", "ign_ros2_control/IgnitionSystem"), ("slide", MOCK)],
)
def test_parameter_that_is_read_or_unknown_joint(joint: str, hardware: str) -> None:
    assert reported("RCT002", ROBOT + control(driven(joint, more=FOLLOWS), plugin=hardware)) == []


def test_a_joint_that_mimics_needs_no_parameter() -> None:
    state = f'<joint name="follow">{FOLLOWS}<state_interface name="position"/></joint>'
    assert reported("RCT002", ROBOT + control(state, plugin=GZ)) == []
    assert reported("RCT002", ROBOT + control(driven("slide"), plugin=GZ)) == []


@pytest.mark.parametrize(
    ("targets", "count"), [(("gz-harmonic",), 1), (("gz-harmonic", "gz-fortress"), 0)]
)
def test_a_follower_with_a_command_and_the_parameter_of_humble(
    targets: tuple[str, ...], count: int
) -> None:
    """Robotiq's gripper, whose controller manager stops on Jazzy."""
    text = ROBOT + control(driven("swing"), driven("follow", more=FOLLOWS))
    assert len(reported("RCT002", text, targets=targets)) == count
