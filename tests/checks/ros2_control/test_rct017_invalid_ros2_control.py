"""RCT017: see the rule."""

import pytest

from tests.controls import CLASSIC, GZ, MOCK, NEXT, ROBOT, control, driven, plugin, transmission
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit import Severity
from urdfkit.robot.samples import xacro_xml

GPIO = '<gpio name="lamp"><param name="p">1</param><command_interface name="on"/></gpio>'
GOOD = ROBOT + control(driven("swing", more='<param name="p">1</param>'), GPIO)


def test_a_tag_that_stops_the_parser() -> None:
    text = ROBOT + control(driven("swing"), '<sensr name="imu"/>')
    assert messages("RCT017", text) == [
        "<ros2_control>: unknown element <sensr>; did you mean 'sensor'?"
    ]
    assert places("RCT017", text) == [(NEXT + 3, '<sensr name="imu"/>')]


@pytest.mark.parametrize(
    ("old", "new", "tag"),
    [
        ('<joint name="swing">', "<joint>", "joint"),
        ('<gpio name="lamp">', '<gpio name="">', "gpio"),
        ('<command_interface name="on"/>', "<command_interface/>", "command_interface"),
        ('<param name="p">', "<param>", "param"),
        ('<ros2_control name="c"', "<ros2_control", "ros2_control"),
    ],
)
def test_missing_name(old: str, new: str, tag: str) -> None:
    assert old in GOOD
    found = messages("RCT017", GOOD.replace(old, new))
    assert set(found) == {f"<{tag}> has no name"}


def test_valid_names() -> None:
    more = '<properties/><transmission name="t"><plugin>p/C</plugin></transmission>'
    assert reported("RCT017", GOOD) == []
    assert reported("RCT017", ROBOT + control(driven("swing"), more)) == []
    assert reported("RCT017", ROBOT + control(driven("swing", more="<limits/>"))) == []
    assert reported("RCT017", ROBOT + control(driven("swing"), "<xacro:more/>")) == []


def test_an_actuator_has_one_joint() -> None:
    text = ROBOT + control(driven("swing"), driven("slide"), kind="actuator")
    assert messages("RCT017", text) == ["<ros2_control> 'c': type actuator with 2 joints, not 1"]
    assert places("RCT017", text) == [(NEXT, "actuator")]
    assert reported("RCT017", ROBOT + control(driven("swing"), kind="actuator")) == []


def test_the_parts_of_a_transmission_have_roles() -> None:
    inside = '<plugin>p/C</plugin><joint name="swing"{}/><actuator name="m" role="a"/>'
    block = f'<transmission name="t">{inside}</transmission>'
    assert (
        reported("RCT017", ROBOT + control(driven("swing"), block.format(' role="joint1"'))) == []
    )
    assert messages("RCT017", ROBOT + control(driven("swing"), block.format(""))) == [
        "<joint> of a transmission has no role"
    ]


def test_a_misspelt_interface() -> None:
    text = ROBOT + control(driven("swing", "velocty", "efort"))
    assert messages("RCT017", text) == [
        naming("swing", "velocty", "unknown", "velocity"),
        naming("swing", "efort", "unknown", "effort"),
    ]
    assert places("RCT017", text) == [(NEXT + 2, "velocty"), (NEXT + 2, "efort")]


@pytest.mark.parametrize(
    "name",
    "position velocity effort acceleration torque pid_gain position_pid velocity_scaling x".split(),
)
def test_names_that_hardware_and_controller_agree_on(name: str) -> None:
    assert reported("RCT017", ROBOT + control(driven("swing", name, name))) == []


def test_interfaces_of_simulators() -> None:
    found = messages("RCT017", ROBOT + control(driven("swing", "position_pid"), plugin=GZ))
    assert found == [
        naming("swing", "position_pid", "gz_ros2_control/GazeboSimSystem", "velocity", "effort")
    ]
    assert (
        reported("RCT017", ROBOT + control(driven("swing", "position_pid"), plugin=CLASSIC)) == []
    )
    assert messages("RCT017", ROBOT + control(driven("swing", state="torque"), plugin=CLASSIC)) == [
        naming("swing", "torque", "gazebo_ros2_control/GazeboSystem", "velocity", "effort")
    ]


def test_sensors_and_gpios() -> None:
    sensor = '<sensor name="imu"><state_interface name="{}"/></sensor>'
    assert messages("RCT017", ROBOT + control(sensor.format("orientation_x"), plugin=GZ)) == [
        naming("imu", "orientation_x", "unknown", "orientation.x")
    ]
    assert messages("RCT017", ROBOT + control(sensor.format("linear_accel.x"), plugin=GZ)) == [
        naming("imu", "linear_accel.x", "gz_ros2_control/GazeboSimSystem", "orientation.x")
    ]
    for name in ("orientation.x", "force.z", "ft.torque.x", "temperature", "positon"):
        assert reported("RCT017", ROBOT + control(sensor.format(name))) == []
    gpio = '<gpio name="g"><command_interface name="positon"/></gpio>'
    assert reported("RCT017", ROBOT + control(gpio)) == []


def test_hardware_interfaces_of_ros1() -> None:
    mistake = ROBOT + transmission("swing", "hardware_interface/EffortJointInterfce")
    assert messages("RCT017", mistake) == [
        naming(
            "swing",
            "hardware_interface/EffortJointInterfce",
            "unknown",
            "hardware_interface/EffortJointInterface",
        )
    ]
    assert reported("RCT017", mistake, targets=("ros2",)) == []
    for name in ("VelocityJointInterface", "hardware_interface/PosVelJointInterface", "my/Own"):
        assert reported("RCT017", ROBOT + transmission("swing", name)) == []


def test_interfaces_of_gazebo_in_ros1() -> None:
    text = ROBOT + transmission("swing", "hardware_interface/PosVelJointInterface")
    (message,) = messages("RCT017", text + plugin("libgazebo_ros_control.so"))
    assert "one of gazebo_ros_control (hardware_interface/Effort" in message
    own = plugin("libgazebo_ros_control.so", "<robotSimType>acme/Sim</robotSimType>")
    assert reported("RCT017", text + own) == []


@pytest.mark.parametrize(
    ("kind", "hint"),
    [
        ("System", ["system"]),
        ("sensors", ["sensor"]),
        ("robot", []),
    ],
)
def test_unknown_type(kind: str, hint: list[str]) -> None:
    text = ROBOT + control(driven("swing"), kind=kind)
    assert messages("RCT017", text) == [
        naming("<ros2_control>", "c", kind, "system, actuator, sensor", *hint)
    ]
    assert places("RCT017", text) == [(NEXT, kind)]


@pytest.mark.parametrize(
    ("kind", "hardware", "severity"),
    [
        ("own/Driver", "own/Driver", Severity.WARNING),
        ("own/Driver", GZ, Severity.WARNING),
        ("own/Driver", MOCK, Severity.ERROR),
        ("sensors", "own/Driver", Severity.ERROR),
    ],
)
def test_a_type_for_which_nothing_is_loaded(kind: str, hardware: str, severity: Severity) -> None:
    """A robot with a battery, whose driver is named in another block and exports its state."""
    battery = f'<ros2_control name="battery" type="{kind}"/>'
    text = ROBOT + control(driven("swing"), plugin=hardware) + battery
    assert [one.severity for one in reported("RCT017", text)] == [severity]
    assert reported("RCT005", text) == []


def test_no_type() -> None:
    text = ROBOT + control(driven("swing")).replace(' type="system"', "")
    assert messages("RCT017", text) == ["<ros2_control> 'c' has no type"]


@pytest.mark.parametrize("kind", ["system", "actuator", "sensor", "${kind}"])
def test_valid_types(kind: str) -> None:
    assert reported("RCT017", ROBOT + control(driven("swing"), kind=kind)) == []


@pytest.mark.parametrize(
    ("part", "message"),
    [
        (
            '<joint name="swing"><comand_interface name="position"/></joint>',
            naming("swing", "<ros2_control>", "unknown", "<comand_interface>", "command_interface"),
        ),
        (
            (
                '<joint name="swing"><state_interface name="position"><parm name="min">0</parm>'
                "</state_interface></joint>"
            ),
            naming("state_interface", "position", "<ros2_control>", "unknown", "<parm>", "param"),
        ),
        (
            '<sensor name="imu"><command_interface name="x"/></sensor>',
            naming("imu", "<ros2_control>", "unknown", "<command_interface>", "state_interface"),
        ),
    ],
)
def test_unknown_elements(part: str, message: str) -> None:
    assert messages("RCT017", ROBOT + control(part)) == [message]
    ((line, _),) = places("RCT017", ROBOT + control(part))
    assert line == NEXT + 2


def test_known_elements() -> None:
    part = (
        '<joint name="swing"><command_interface name="position"><param name="min">0</param>'
        '<limits enable="false"/></command_interface><param name="gain">1</param></joint>'
    )
    transmission = (
        '<transmission name="t"><plugin>t/T</plugin><joint name="swing" role="r">'
        "<mechanical_reduction>2</mechanical_reduction></joint></transmission>"
    )
    assert messages("RCT017", ROBOT + control(part, transmission)) == []


def with_parameter(name: str, value: str) -> str:
    parameter = f'<param name="{name}">{value}</param>'
    interface = f'<command_interface name="position">{parameter}</command_interface>'
    return ROBOT + control(f'<joint name="swing">{interface}</joint>')


@pytest.mark.parametrize("value", ["1,5", "", "3.14 rad", "nan?"])
@pytest.mark.parametrize("name", ["min", "max", "initial_value"])
def test_text_for_a_number(name: str, value: str) -> None:
    assert messages("RCT017", with_parameter(name, value)) == [
        naming("swing", name, value or "empty", "number")
    ]


@pytest.mark.parametrize(
    ("value", "help"),
    [
        ("{-pi/2}", naming("${-pi/2}", "dollar")),
        ("{-*pi}", naming("number")),
        ("{pi", naming("number")),
    ],
)
def test_missing_dollar_of_an_expression(value: str, help: str) -> None:
    (found,) = reported("RCT017", with_parameter("min", value))
    assert found.help == help


@pytest.mark.parametrize(
    ("name", "help"),
    [
        ("SO-ARM100", "SO_ARM100"),
        ("my arm", "my_arm"),
        ("3d/arm", "_3d_arm"),
        ("left/arm", ""),
        ("$(arg name)-x", ""),
    ],
)
def test_a_name_that_no_node_has(name: str, help: str) -> None:
    found = reported("RCT017", ROBOT + control(driven("swing"), name=name))
    assert [one.help for one in found] == [naming(help, "digits")] * bool(help)


def test_a_second_plugin() -> None:
    text = ROBOT + control(driven("swing"), plugin=f"{GZ}</plugin><plugin>{MOCK}")
    assert messages("RCT017", text) == [naming("<ros2_control>", "c", "<plugin>", GZ)]
    assert places("RCT017", text) == [(NEXT + 1, "<plugin>")]


@pytest.mark.parametrize(
    ("plugin", "state", "count"),
    [(GZ, "", 1), (CLASSIC, "", 1), (MOCK, "", 0), ("own/Hardware", "", 0), (GZ, "0.5", 0)],
)
def test_an_initial_value_of_a_command(plugin: str, state: str, count: int) -> None:
    value = '<param name="initial_value">{}</param>'
    state = value.format(state) if state else ""
    joint = (
        f'<joint name="swing"><command_interface name="position">{value.format(1)}'
        f'</command_interface><state_interface name="position">{state}</state_interface></joint>'
    )
    assert len(reported("RCT017", ROBOT + control(joint, plugin=plugin))) == count


def test_a_misspelt_parameter_is_fixed() -> None:
    assert messages("RCT017", with_parameter("inital_value", "1")) == [
        naming("swing", "unknown", "inital_value", "initial_value")
    ]
    assert 'name="initial_value"' in fixed("RCT017", with_parameter("inital_value", "1"))


@pytest.mark.parametrize(
    ("name", "value"), [("min", "-1.5"), ("max", "${pi}"), ("initial_value", " 1e-3 "), ("p", "x")]
)
def test_numbers_and_other_parameters(name: str, value: str) -> None:
    assert messages("RCT017", with_parameter(name, value)) == []


@pytest.mark.parametrize(
    ("old", "new", "severity"),
    [
        ('<ros2_control name="c"', '<ros2_control rw_rate="-50" name="c"', "error"),
        ('<ros2_control name="c"', '<ros2_control rw_rate="50" name="c"', ""),
        ('<command_interface name="on"', '<command_interface size="-4" name="on"', "error"),
        ('<command_interface name="on"', '<command_interface size="4" name="on"', ""),
        (
            '<state_interface name="position"',
            '<state_interface size="0" name="position"',
            "warning",
        ),
        ('<ros2_control name="c"', '<ros2_control is_async="maybe" name="c"', "warning"),
        ('<ros2_control name="c"', '<ros2_control is_async="True" name="c"', ""),
        ('<command_interface name="on"', '<command_interface data_type="boll" name="on"', ""),
        (
            '<command_interface name="on"',
            '<command_interface data_type="booll" name="on"',
            "warning",
        ),
        ('<command_interface name="on"', '<command_interface data_type="int64" name="on"', ""),
    ],
)
def test_attributes_with_invalid_values(old: str, new: str, severity: str) -> None:
    assert old in GOOD
    found = reported("RCT017", GOOD.replace(old, new, 1))
    assert [one.severity.value for one in found] == [severity][: bool(severity)]


def test_an_empty_name_from_an_argument() -> None:
    """Doosan's arms are named by the launch file."""
    block = '<ros2_control name="{}" type="system"/>'
    (found,) = reported("RCT017", block.format(""))  # Humble accepts it
    assert (found.message, found.severity.value) == ("<ros2_control> has no name", "warning")
    text = xacro_xml('<xacro:arg name="model" default=""/>', block.format("$(arg model)"))
    assert reported("RCT017", text.encode(), "robot.xacro") == []


@pytest.mark.parametrize(
    ("attribute", "severity"),
    [
        ('data_typ="double"', Severity.WARNING),
        ('tf_prefix="a"', Severity.WARNING),
        ('initial_value="0.0"', Severity.INFO),
    ],
)
def test_an_attribute_that_is_not_read(attribute: str, severity: Severity) -> None:
    text = control(f'<joint name="swing"><state_interface name="position" {attribute}/></joint>')
    (found,) = reported("RCT017", ROBOT + text)
    assert found.severity is severity
    assert attribute.partition("=")[0] in found.message


@pytest.mark.parametrize(
    ("hardware", "name", "count"),
    [
        ("mock_components/GenericSystem", "calculate_dynamic", 1),
        ("mock_components/GenericSystem", "calculate_dynamics", 0),
        ("mock_components/GenericSystem", "robot_ip", 0),
        ("acme/Driver", "calculate_dynamic", 0),
    ],
)
def test_parameters_of_mock_hardware(hardware: str, name: str, count: int) -> None:
    text = control(driven("swing"), plugin=hardware)
    text = text.replace("</hardware>", f'<param name="{name}">true</param></hardware>')
    assert len(reported("RCT017", ROBOT + text)) == count
