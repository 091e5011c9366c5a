import pytest

from tests.conftest import MISSION
from tests.controls import CLASSIC, ROBOT, control, driven, plugin, transmission
from urdfkit.lint import engine, rule_index
from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.ros.ros_control import (
    components,
    control_plugins,
    driven_joints,
    is_of_pr2,
    parameter,
    reads_transmissions,
)
from urdfkit.ros.targets import parse
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

PR2 = '<transmission name="t" type="pr2_mechanism_model/SimpleTransmission"/>'


def context(text: str) -> Context:
    return Context(Source("robot.urdf", whole_robot(text).encode()), Resolver(environment={}))


def test_a_component_and_its_parts() -> None:
    sensor = '<sensor name="imu"><state_interface name="orientation.x"/></sensor>'
    block = control(driven("swing", more='<param name="p">1</param>'), sensor, plugin=CLASSIC)
    (component,) = components(context(ROBOT + block).model)
    assert (component.name, component.hardware) == ("c", CLASSIC)
    assert component.called == "<ros2_control> 'c'"
    assert [(part.kind, part.name) for part in component.parts] == [
        ("joint", "swing"),
        ("sensor", "imu"),
    ]
    (joint,) = component.joints
    assert [(one.direction, one.name) for one in joint.interfaces] == [
        ("command", "position"),
        ("state", "position"),
    ]
    assert [one.name for one in joint.of("state")] == ["position"]
    found = parameter(joint.at, "p")
    assert found is not None
    assert found.text == "1"
    assert parameter(joint.at, "q") is None


@pytest.mark.parametrize(("text", "value"), [("-1.5", -1.5), (" 2 ", 2.0), ("", None), ("x", None)])
def test_the_bounds_of_an_interface(text: str, value: float | None) -> None:
    joint = f'<joint name="j"><command_interface name="v"><param name="min">{text}</param>'
    block = control(f"{joint}</command_interface></joint>")
    interface = components(context(block).model)[0].joints[0].interfaces[0]
    assert interface.bound("min") == value
    assert interface.bound("max") is None


def test_an_empty_block_is_read() -> None:
    (component,) = components(context(ROBOT + "<ros2_control/>").model)
    assert component.plugin is None
    assert component.parts == ()
    assert (component.hardware, component.called) == ("", "<ros2_control>")


def test_control_plugins_among_others() -> None:
    text = plugin("libgazebo_ros_control.so") + plugin("libgazebo_ros_joint_pose_trajectory.so")
    text += plugin("libacme_control.so") + plugin("gz_ros2_control-system")
    found = control_plugins(context(ROBOT + text).model)
    assert [(one.kind, one.filename) for one in found] == [
        ("gazebo_ros_control", "libgazebo_ros_control.so"),
        ("gz_ros2_control", "gz_ros2_control-system"),
    ]


def test_transmissions() -> None:
    model = context(ROBOT + transmission("swing") + PR2).model
    ((joint, of),) = driven_joints(model.transmissions)
    assert (joint.get("name"), of) == ("swing", model.transmissions[0])
    assert [is_of_pr2(one) for one in model.transmissions] == [False, True]
    mistake = '<transmission type="SimpleTransmission"><joint name="swing"/>{}</transmission>'
    for content, older in (("", False), ("<mechanicalReduction/>", True), ("<type/>", False)):
        (one,) = context(ROBOT + mistake.format(content)).model.transmissions
        assert is_of_pr2(one) is older


@pytest.mark.parametrize(
    ("targets", "read"),
    [
        ([], True),
        (["ros1"], True),
        (["ros2"], False),
        (["gz-harmonic", "ros2"], False),
        (["classic-ros1", "ros2"], True),
        (["kdl"], True),
    ],
)
def test_who_reads_the_transmissions_of_ros1(targets: list[str], read: bool) -> None:
    assert reads_transmissions(parse(targets)) is read


def is_about_control(text: str) -> bool:
    return any(
        rule_index.applicable(family, ["RCT001"], context(text))
        for family in ("ros2_control", "controllers", "transmissions")
    )


def test_without_control_its_rules_do_not_apply() -> None:
    assert not is_about_control(ROBOT)
    assert not is_about_control(ROBOT + plugin("libgazebo_ros_imu_sensor.so"))
    for piece in (transmission("swing"), control(), plugin("libgazebo_ros_control.so")):
        assert is_about_control(ROBOT + piece)


def test_the_robot_of_the_mission_has_nothing_to_do_with_control() -> None:
    report = engine.check(MISSION, select=["RCT"])
    assert report.crashed == ()
    assert [found.code for found in report.diagnostics] == ["RCT029"], "its drive plugin"
