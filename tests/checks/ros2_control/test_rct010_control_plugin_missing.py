import pytest

from tests.controls import CLASSIC, GZ, MOCK, NEXT, ROBOT, control, driven, plugin, transmission
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity

LOADS = "libgazebo_ros2_control.so"
NAMESPACE = "<ros><namespace>{}</namespace></ros>"


@pytest.mark.parametrize(
    ("hardware", "simulator", "file"),
    [
        (CLASSIC, "Gazebo Classic", LOADS),
        (GZ, "gz-sim", "gz_ros2_control-system"),
        ("ign_ros2_control/IgnitionSystem", "Gazebo Fortress", "gz_ros2_control-system"),
    ],
)
def test_hardware_that_nothing_loads(hardware: str, simulator: str, file: str) -> None:
    text = ROBOT + control(driven("swing"), plugin=hardware)
    assert messages("RCT010", text) == [
        f"<ros2_control> 'c' is for {simulator}, but no plugin in <gazebo> loads it ({file})"
    ]
    assert places("RCT010", text) == [(NEXT + 1, "<plugin>")]
    assert reported("RCT010", text + plugin(file)) == []


def test_one_plugin_loads_all_blocks() -> None:
    blocks = [control(driven(name), plugin=GZ, name=name) for name in ("swing", "slide")]
    assert len(reported("RCT010", ROBOT + "".join(blocks))) == 1


def test_hardware_without_a_simulator() -> None:
    assert reported("RCT010", ROBOT + control(driven("swing"), plugin=MOCK)) == []
    assert reported("RCT010", ROBOT + control(driven("swing"), plugin="acme/Arm")) == []


def test_two_plugins_in_one_namespace() -> None:
    block = ROBOT + control(driven("swing"), plugin=CLASSIC)
    text = block + plugin(LOADS) * 2
    assert messages("RCT010", text) == [naming(LOADS, "twice")]
    assert [line for line, _ in places("RCT010", text)] == [NEXT + 5]
    left, right = (plugin(LOADS, NAMESPACE.format(side)) for side in ("left", "right"))
    assert reported("RCT010", block + left + right) == []
    assert len(reported("RCT010", block + left + left)) == 1


def test_plugin_of_ros1_requires_transmissions() -> None:
    assert messages("RCT010", ROBOT + plugin("libgazebo_ros_control.so")) == [
        naming("libgazebo_ros_control.so", "transmissions")
    ]
    assert (
        reported("RCT010", ROBOT + plugin("libgazebo_ros_control.so") + transmission("swing")) == []
    )
    own = plugin("libgazebo_ros_control.so", "<robotSimType>acme/Sim</robotSimType>")
    assert reported("RCT010", ROBOT + own) == []


def test_transmissions_for_gazebo_that_nothing_loads() -> None:
    drive = plugin("libgazebo_ros_planar_move.so", "<commandTopic>cmd_vel</commandTopic>")
    assert messages("RCT010", ROBOT + transmission("swing") + drive) == [
        naming("Gazebo", "Classic", "<gazebo>", "libgazebo_ros_control.so")
    ]
    assert reported("RCT010", ROBOT + transmission("swing")) == []


@pytest.mark.parametrize(
    ("kind", "severity"),
    [
        ("robot_transmission_interface::TorsoPushrodTransmissionLoader", Severity.INFO),
        ("transmission_interface/FourBarLinkageTransmission", Severity.WARNING),
        ("SimpleTransmission", Severity.WARNING),
    ],
)
def test_transmissions_that_the_real_robot_loads(kind: str, severity: Severity) -> None:
    """Valkyrie's files for its hardware also have sensors for Gazebo."""
    drive = plugin("libgazebo_ros_planar_move.so", "<commandTopic>cmd_vel</commandTopic>")
    text = transmission("swing").replace("transmission_interface/SimpleTransmission", kind)
    assert kind in text
    (found,) = reported("RCT010", ROBOT + text + drive)
    assert found.severity is severity
