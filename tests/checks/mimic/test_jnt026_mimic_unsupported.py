import pytest

from tests.jointed import joint, mimic, robot
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.ros.targets import GAZEBO, TARGETS
from urdfkit.text.diagnostic import Diagnostic, Severity

HAND = robot(
    joint("a", "continuous"),
    joint("b", "continuous", mimic("a")),
    joint("c", "prismatic", mimic("a")),
)


def told_to(target: str, text: str) -> list[Diagnostic]:
    return reported("JNT026", text, targets=(target,))


@pytest.mark.parametrize("target", TARGETS)
def test_every_gazebo_and_nobody_else(target: str) -> None:
    found = told_to(target, HAND)
    assert [(one.severity, one.targets) for one in found] == (
        [(Severity.WARNING, (target,))] if target in GAZEBO else []
    )


def test_gazebo_is_inferred_from_a_plugin() -> None:
    plugin = '<gazebo><plugin name="p" filename="libgazebo_ros_control.so"/></gazebo>'
    assert messages("JNT026", HAND + plugin) == [naming("b", "c", "Gazebo", "<mimic>")]
    assert places("JNT026", HAND + plugin) == [(6, mimic("a"))]
    assert reported("JNT026", HAND) == []


PLUGIN = '<plugin name="{0}" filename="libmimic_joint.so"><mimicJoint> {0} </mimicJoint></plugin>'


@pytest.mark.parametrize(
    "coupling",
    [
        '<ros2_control name="c" type="system"><joint name="b"/><joint name="{}"/></ros2_control>',
        '<transmission name="c"><joint name="b"/><passive_joint name="{}"/></transmission>',
        f"<gazebo>{PLUGIN.format('b')}{PLUGIN}</gazebo>",
    ],
)
def test_joints_that_something_else_couples(coupling: str) -> None:
    assert told_to("classic-ros1", HAND + coupling.format("c")) == []
    (found,) = told_to("classic-ros1", HAND + coupling.format("z"))
    assert found.message == naming("c", "Gazebo", "<mimic>")


def test_a_fixed_joint_need_not_be_coupled() -> None:
    text = robot(joint("a", "continuous"), joint("b", "fixed", mimic("a")))
    assert told_to("gz-harmonic", text) == []


@pytest.mark.parametrize(
    ("target", "help"),
    [
        ("classic-ros1", naming("mimic")),
        ("classic-ros2", naming("list", "<ros2_control>")),
        (
            "gz-harmonic",
            naming("list", "<ros2_control>"),
        ),
    ],
)
def test_the_help_is_for_the_target(target: str, help: str) -> None:
    assert [one.help for one in told_to(target, HAND)] == [help]
