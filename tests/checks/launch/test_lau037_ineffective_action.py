"""LAU037: see the rule."""

from pathlib import Path

import pytest

from tests.checks.launch.actions import HANDLED, LASTING, SPAWNER, described
from tests.launched import reported
from tests.naming import naming
from urdfkit import Severity

SPAWNING = f"def spawn():\n    return {SPAWNER}\n"
ROS_2 = '<let name="x" value="$(var x)"/>\n'


def test_tags_behind_the_last_node(tmp_path: Path) -> None:
    text = ROS_2 + '<node pkg="a" exec="b"/><push_ros_namespace namespace="n"/>'
    (found,) = reported(tmp_path, "LAU037", "a.launch", text)
    assert found.message == naming("<push_ros_namespace>", "after")
    assert found.help == naming("above")


@pytest.mark.parametrize(
    "text",
    [
        ROS_2 + '<push_ros_namespace namespace="n"/><node pkg="a" exec="b"/>',
        ROS_2 + '<push_ros_namespace namespace="n"/>',
    ],
)
def test_tags_with_an_effect(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU037", "a.launch", text) == []


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (described(SPAWNER, HANDLED.format("a, b, ")), "'b' is started twice"),
        (described(LASTING, HANDLED.format("a, ")), "started when robot_state_publisher"),
        (
            described(SPAWNER, HANDLED.replace("[b]", "[a]").format("b, ")),
            "starts when it has",
        ),
        (described(SPAWNER, HANDLED.format("")), "'a' is never started"),
        (SPAWNING + described("spawn()", HANDLED.format("")), "'a' is never started"),
    ],
)
def test_actions_that_launch_does_not_start(tmp_path: Path, text: str, message: str) -> None:
    (found,) = reported(tmp_path, "LAU037", "a.launch.py", text)
    assert found.message.startswith(message)


def test_handlers_of_what_a_function_creates(tmp_path: Path) -> None:
    text = SPAWNING + described("spawn()", HANDLED.format("a, "))
    assert reported(tmp_path, "LAU037", "a.launch.py", text) == []


@pytest.mark.parametrize("target", ["spawn()", SPAWNER])
def test_a_handler_of_an_action_of_its_own(tmp_path: Path, target: str) -> None:
    handled = HANDLED.format("a, ").replace("target_action=a", f"target_action={target}")
    (found,) = reported(tmp_path, "LAU037", "a.launch.py", SPAWNING + described("spawn()", handled))
    assert found.message.startswith("the handler waits for an action that it creates itself")


AFTER = """\
def after(gate, action):
    return RegisterEventHandler(OnProcessExit(target_action=gate, on_exit=[action]))
"""


def test_a_function_with_a_handler(tmp_path: Path) -> None:
    """ZainAlabidinShbani/mobile_manipulator_ws: the node has another name outside of it."""
    text = SPAWNING + AFTER + described("spawn()", "LaunchDescription([a, after(a, b)])")
    assert reported(tmp_path, "LAU037", "a.launch.py", text) == []


@pytest.mark.parametrize(("first", "started"), [(SPAWNER, "[b]"), (LASTING, "[a, b]")])
def test_a_handler_that_is_not_used_either(tmp_path: Path, first: str, started: str) -> None:
    """indy-ros2: the author replaced the handler of RViz with RViz itself, and left it there."""
    text = described(first, f"LaunchDescription({started})")
    handler = "c = RegisterEventHandler(OnProcessExit(target_action=a, on_exit=[b]))\n"
    found = reported(tmp_path, "LAU037", "a.launch.py", text.replace("def ", f"{handler}def "))
    assert [one.message for one in found if one.severity is not Severity.INFO] == []


MADE = """\
from launch import LaunchDescription
from launch_ros.actions import Node
def made(name):
    return Node(package='a', executable='b', name=name)
def text(name):
    return f'{{name}}_text'
def generate_launch_description():
    first = made('first')
    second = {}
    return LaunchDescription([first])
"""


@pytest.mark.parametrize(
    ("second", "count"),
    [("made('second')", 1), ("text('second')", 0), ("GroupAction([made('second')])", 1)],
)
def test_what_a_function_creates_is_not_started(tmp_path: Path, second: str, count: int) -> None:
    found = reported(tmp_path, "LAU037", "a.launch.py", MADE.format(second))
    assert [one.message for one in found] == [naming("second")] * count


@pytest.mark.parametrize(
    ("line", "severity"),
    [
        ("    c = Node(package='a', executable='b')", Severity.WARNING),
        ("    c= Node(package='a', executable='b')", Severity.WARNING),
        ("    c = (\n        Node(package='a', executable='b')\n    )", Severity.WARNING),
        ("    c = Node(package='a', executable='b')\n    # c,", Severity.INFO),
        ("    c = TimerAction(period=1.0, actions=[b])", Severity.INFO),
    ],
)
def test_an_action_that_is_left_out(tmp_path: Path, line: str, severity: Severity) -> None:
    """On purpose, where a comment names it."""
    text = described(SPAWNER, "LaunchDescription([a, b])").replace(
        "    return", f"{line}\n    return"
    )
    (found,) = reported(tmp_path, "LAU037", "a.launch.py", text)
    assert (found.message, found.severity) == (naming("c"), severity)
