"""RCT007: see the rule."""

from tests.controls import NEXT, ROBOT, control, driven
from tests.naming import naming
from tests.reported import messages, places, reported


def test_two_blocks_for_one_joint() -> None:
    text = ROBOT + control(driven("swing")) + control(driven("swing"), name="sim")
    assert messages("RCT007", text) == [naming("swing", "position", "twice")]
    assert places("RCT007", text) == [(NEXT + 6, '<command_interface name="position"/>')]
    (found,) = reported("RCT007", text)
    assert [(one.span.line, one.message) for one in found.related] == [
        (NEXT + 2, naming("<ros2_control>", "c"))
    ]


def test_two_blocks_for_all_joints_are_one_finding() -> None:
    """As in MOGI's arm: a block for Gazebo, and one of the Setup Assistant."""
    joints = [driven(name) for name in ("swing", "slide", "weld", "follow")]
    text = ROBOT + control(*joints) + control(*joints, name="sim")
    assert messages("RCT007", text) == [
        (
            "<ros2_control> 'sim' declares interfaces of 'swing', 'slide', 'weld' and 1 more that "
            "are already declared"
        )
    ]
    assert places("RCT007", text) == [(NEXT + 7, '<ros2_control name="sim" type="system">')]
    (found,) = reported("RCT007", text)
    assert [(one.span.line, one.message) for one in found.related] == [
        (NEXT, naming("<ros2_control>", "c"))
    ]


def test_duplicate_in_one_block() -> None:
    twice = '<state_interface name="effort"/>' * 2
    assert messages("RCT007", ROBOT + control(driven("swing", more=twice))) == [
        naming("swing", "effort", "twice")
    ]


def test_copied_joint_of_one_block_whose_name_was_not_changed() -> None:
    """As in a quadruped: RR_calf_joint twice, and RL_calf_joint not at all."""
    robot = "".join(f'<link name="{name}"/>' for name in ("base", "fl", "fr", "rl"))
    for name in ("fl", "fr", "rl"):
        robot += f'<joint name="{name}_calf_joint" type="continuous"><parent link="base"/>'
        robot += f'<child link="{name}"/></joint>'
    calves = [driven(f"{name}_calf_joint") for name in ("fl", "fr", "fr")]
    (found,) = reported("RCT007", robot + control(*calves))
    assert found.message == naming("fr_calf_joint", "position", "twice")
    assert "'rl_calf_joint'" in (found.help or "")
    (found,) = reported("RCT007", robot + control(*calves, driven("rl_calf_joint")))
    assert "calf" not in (found.help or "")


def test_different_interfaces_of_one_joint_may_be_in_two_blocks() -> None:
    sensor = '<joint name="swing"><state_interface name="velocity"/></joint>'
    text = control(driven("swing")) + control(sensor, name="s", kind="sensor")
    assert reported("RCT007", ROBOT + text) == [], "and a command is not a state"
    assert reported("RCT007", ROBOT + control(driven("swing"), driven("slide"))) == []


def test_sensor_and_gpio_may_have_the_same_name() -> None:
    """As in the hands of Robotis: the GPIO has the settings of the bus of the sensor."""
    state = '<state_interface name="pressure"/>'
    sensor = f'<sensor name="s">{state}</sensor>'
    assert reported("RCT007", ROBOT + control(sensor, f'<gpio name="s">{state}</gpio>')) == []
    assert len(reported("RCT007", ROBOT + control(sensor, sensor))) == 1


def test_two_blocks_of_one_name() -> None:
    text = ROBOT + control(driven("swing")) + control(driven("slide"))
    assert messages("RCT007", text) == [naming("duplicate", "<ros2_control>", "c")]
    assert places("RCT007", text) == [(NEXT + 4, "c")]
    (found,) = reported("RCT007", text)
    assert [(one.span.line, one.message) for one in found.related] == [(NEXT, "first defined here")]


def test_unique_names() -> None:
    text = ROBOT + control(driven("swing")) + control(driven("slide"), name="d")
    assert reported("RCT007", text) == []
    assert reported("RCT007", text.replace('"c"', '""').replace('"d"', '""')) == [], "RCT017"
    assert reported("RCT007", text.replace('"c"', '"${n}"').replace('"d"', '"${n}"')) == [], (
        "XAC003"
    )
