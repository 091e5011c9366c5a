"""RCT005: see the rule."""

import pytest

from tests.controls import CLASSIC, GZ, MOCK, NEXT, ROBOT, control, driven, plugin
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit import Severity

PLUGIN = "<plugin>mock_components/GenericSystem</plugin>"
GOOD = ROBOT + control(driven("swing"))


@pytest.mark.parametrize(
    ("old", "new", "message", "place"),
    [
        (
            f"<hardware>{PLUGIN}</hardware>",
            "",
            "<ros2_control> 'c' has no <hardware>",
            (NEXT, '<ros2_control name="c" type="system">'),
        ),
        (
            PLUGIN,
            "",
            "<ros2_control> 'c': <hardware> has no <plugin>",
            (NEXT + 1, "<hardware>"),
        ),
        (
            PLUGIN,
            "<plugin> </plugin>",
            "<ros2_control> 'c': <plugin> is empty",
            (NEXT + 1, "<plugin>"),
        ),
        (
            PLUGIN,
            PLUGIN.replace("</", "\n</"),
            (
                "<ros2_control> 'c': white space around hardware 'mock_components/GenericSystem', "
                "which is not removed"
            ),
            (NEXT + 1, "<plugin>"),
        ),
    ],
)
def test_hardware_without_plugin(old: str, new: str, message: str, place: tuple[int, str]) -> None:
    text = GOOD.replace(old, new)
    assert messages("RCT005", text) == [message]
    assert places("RCT005", text) == [place]
    assert reported("RCT005", GOOD) == []


def test_a_transmission_without_plugin() -> None:
    inner = '<transmission name="t">{}<joint name="swing" role="r"/></transmission>'
    assert messages("RCT005", ROBOT + control(driven("swing"), inner.format(""))) == [
        naming("t", "<plugin>")
    ]
    complete = inner.format("<plugin>transmission_interface/SimpleTransmission</plugin>")
    assert reported("RCT005", ROBOT + control(driven("swing"), complete)) == []


@pytest.mark.parametrize(
    ("hardware", "number"),
    [
        (f'<hardware><xacro:if value="0">{PLUGIN}</xacro:if></hardware>', 0),
        (f'<xacro:unless value="1"><hardware>{PLUGIN}</hardware></xacro:unless>', 0),
        ('<hardware><xacro:if value="1"><param name="rate">5</param></xacro:if></hardware>', 1),
    ],
)
def test_plugin_that_depends_on_arguments(hardware: str, number: int) -> None:
    text = GOOD.replace(f"<hardware>{PLUGIN}</hardware>", hardware)
    robot = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{text}</robot>'
    assert len(reported("RCT005", robot)) == number


@pytest.mark.parametrize(
    ("name", "suggested"),
    [
        ("mock_component/GenericSystem", MOCK),
        ("gz_ros2_control/GazeboSimSytem", GZ),
        ("GazeboSimSystem", GZ),
        ("gz_ros2_control/GzSystem", GZ),
    ],
)
def test_a_misspelt_class(name: str, suggested: str) -> None:
    assert messages("RCT005", ROBOT + control(plugin=name)) == [
        f"<ros2_control> 'c': unknown hardware '{name}'; did you mean '{suggested}'?"
    ]
    assert f"<plugin>{suggested}</plugin>" in fixed("RCT005", ROBOT + control(plugin=name))


@pytest.mark.parametrize("name", [MOCK, GZ, "our_hardware/OurSystem"])
def test_unknown_hardware_is_accepted(name: str) -> None:
    assert messages("RCT005", ROBOT + control(plugin=name)) == []


LOADS_CLASSIC = plugin("libgazebo_ros2_control.so")
LOADS_GZ = plugin("libgz_ros2_control-system.so")


def test_classic_hardware_for_gz() -> None:
    text = ROBOT + control(driven("swing"), plugin=CLASSIC) + LOADS_GZ
    assert messages("RCT005", text) == [
        (
            "<ros2_control> 'c': libgz_ros2_control-system.so does not load hardware "
            "gazebo_ros2_control/GazeboSystem"
        )
    ]
    assert places("RCT005", text) == [(NEXT + 1, "<plugin>")]
    (found,) = reported("RCT005", text)
    assert [(one.span.line, one.message) for one in found.related] == [(NEXT + 4, "control plugin")]


def test_gz_hardware_for_classic_and_for_ros1() -> None:
    text = ROBOT + control(driven("swing"), plugin=GZ)
    (found,) = reported("RCT005", text + LOADS_CLASSIC)
    assert found.help == "use gazebo_ros2_control/GazeboSystem"
    (found,) = reported("RCT005", text + plugin("libgazebo_ros_control.so"))
    assert found.help == naming("simulator")


@pytest.mark.parametrize(
    ("hardware", "plugins"),
    [
        (CLASSIC, LOADS_CLASSIC),
        (GZ, LOADS_GZ),
        ("ign_ros2_control/IgnitionSystem", LOADS_GZ),
        (GZ, plugin("ign_ros2_control-system")),
        (GZ, LOADS_CLASSIC + LOADS_GZ),
        (GZ, ""),  # RCT010
        (MOCK, LOADS_GZ),  # the real robot, described with Gazebo's blocks left in
        ("acme/Sim", LOADS_GZ),
    ],
)
def test_matching_or_unknown_hardware(hardware: str, plugins: str) -> None:
    assert reported("RCT005", ROBOT + control(driven("swing"), plugin=hardware) + plugins) == []


def test_the_former_name_of_mock_hardware() -> None:
    (found,) = reported(
        "RCT005", ROBOT + control(driven("swing"), plugin="fake_components/GenericSystem")
    )
    assert found.severity in (Severity.INFO, Severity.WARNING)  # of this directory's own files
    assert found.help.startswith("write mock_components/GenericSystem")


@pytest.mark.parametrize(
    ("hardware", "library", "more", "is_found"),
    [
        (GZ, "libgazebo_ros2_control.so", "", True),
        (CLASSIC, "libgazebo_ros2_control.so", "", False),
        (GZ, "libgazebo_ros2_control.so", '<xacro:include filename="gz.xacro"/>', False),
        (MOCK, "libgazebo_ros2_control.so", "", False),
        (GZ, "libgazebo_ros_p3d.so", "", False),
    ],
)
def test_hardware_that_an_argument_selects(
    hardware: str, library: str, more: str, is_found: bool
) -> None:
    """KUKA's iiwa: the argument use_sim is false by default."""
    choice = (
        f'<xacro:if value="$(arg sim)"><plugin>{hardware}</plugin>{more}</xacro:if>'
        f'<xacro:unless value="$(arg sim)">{PLUGIN}</xacro:unless>'
    )
    text = '<xacro:arg name="sim" default="false"/>' + GOOD.replace(PLUGIN, choice)
    robot = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
    found = reported("RCT005", robot.format(text + plugin(library)).encode(), "robot.xacro")
    expected = [(naming("<ros2_control>", "c", library, GZ), ("sim=true",))] if is_found else []
    assert [(one.message, one.variants) for one in found] == expected
