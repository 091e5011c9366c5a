"""Names that a Python launch file does not define, and imports from the wrong module."""

from pathlib import Path

import pytest

from tests.growth import executed_lines
from tests.launched import reported
from urdfkit import Severity

HEAD = "from launch import LaunchDescription\n"
END = "def generate_launch_description():\n    {}\n"
DONE = END.format("return LaunchDescription([])")


@pytest.mark.parametrize(
    ("text", "line", "message", "help"),
    [
        (
            HEAD + END.format("return LaunchDescription([Node()])"),
            3,
            "name 'Node' is not defined",
            "write from launch_ros.actions import Node",
        ),
        (HEAD + "a = os.path\n" + DONE, 2, "name 'os' is not defined", "write import os"),
        (
            HEAD + "share = 1\nb = shere\n" + DONE,
            3,
            "name 'shere' is not defined",
            "did you mean 'share'?",
        ),
        (
            "from launch.actions import Node\n" + HEAD + DONE,
            1,
            "module launch.actions has no Node",
            "write from launch_ros.actions import Node",
        ),
        (
            "from launch_ros.action import Node\n" + HEAD + DONE,
            1,
            "module launch_ros.action has no Node",
            "write from launch_ros.actions import Node",
        ),
        (
            "from launch.actions import TimeAction\n" + HEAD + DONE,
            1,
            "module launch.actions has no TimeAction",
            "write TimerAction",
        ),
        (
            "from launch_ros.actions import Nodes\n" + HEAD + DONE,
            1,
            "module launch_ros.actions has no Nodes",
            "write Node",
        ),
        (
            "from launch.substitutions import LaunchSubstitution\n" + HEAD + DONE,
            1,
            "module launch.substitutions has no LaunchSubstitution",
            "import a class that launch.substitutions has",
        ),
    ],
)
def test_wrong_names(tmp_path: Path, text: str, line: int, message: str, help: str) -> None:
    (found,) = reported(tmp_path, "LAU035", "a.launch.py", text)
    assert (found.span.line, found.message, found.help) == (line, message, help)
    assert found.severity is Severity.ERROR


def test_the_first_use_of_a_name(tmp_path: Path) -> None:
    """omni_mobile_robot: a variable that nothing defines, on two lines."""
    text = HEAD + END.format("return LaunchDescription([f(a=size),\n        {1: size}])")
    text = text.replace("def gen", "f = LaunchDescription\ndef gen")
    (found,) = reported(tmp_path, "LAU035", "a.launch.py", text)
    assert (found.span.line, found.span.text) == (4, "size")


def test_a_function_that_a_called_function_calls(tmp_path: Path) -> None:
    functions = "def load():\n    return yaml\ndef use():\n    return load()\n"
    text = HEAD + functions + END.format("return LaunchDescription([OpaqueFunction(function=use)])")
    text = "from launch.actions import OpaqueFunction\n" + text
    (found,) = reported(tmp_path, "LAU035", "a.launch.py", text)
    assert found.message == "name 'yaml' is not defined"


def test_a_name_under_a_condition_is_a_warning(tmp_path: Path) -> None:
    text = HEAD + END.format("b = c if d() else None\n    return LaunchDescription([])")
    found = reported(tmp_path, "LAU035", "a.launch.py", text.replace("d()", "print()"))
    assert [one.severity for one in found] == [Severity.WARNING]


@pytest.mark.parametrize(
    "text",
    [
        HEAD + DONE,
        # OrbbecSDK_ROS2: a function without its import, which only an unused function calls
        HEAD + "def load():\n    return yaml\ndef use():\n    return load()\n" + DONE,
        HEAD + "from os import *\nprint(path)\n" + DONE,
        HEAD + "def unused():\n    return missing\n" + DONE,
        HEAD + "def f(a: Missing) -> Missing:\n    return a\nf(1)\n" + DONE,
        HEAD + "print(__file__, [a for a in 'ab'], (lambda b: b)(1))\n" + DONE,
        HEAD + "try:\n    pass\nexcept OSError as error:\n    print(error)\n" + DONE,
        HEAD + "with open('a') as b, open('c') as d:\n    print(b, d)\n" + DONE,
        HEAD + "import os.path as p\nprint(p)\nfor a, (b, *c) in ():\n    print(a, b, c)\n" + DONE,
        HEAD + "try:\n    a\nexcept NameError:\n    a = 1\n" + DONE,
        HEAD + "if (a := 1):\n    print(a)\n" + DONE,
        "from launch.actions.execute_local import LaunchConfiguration\n" + HEAD + DONE,
        "from launch.events import Shutdown\n" + HEAD + DONE,
        "from mine.actions import Node\n" + HEAD + DONE,
        "try:\n    from launch.actions import Node\nexcept ImportError:\n    pass\n" + HEAD + DONE,
        "print(undefined)\n" + DONE,  # a part of a launch file
    ],
)
def test_defined_names(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU035", "a.launch.py", text) == []


def test_the_work_grows_like_the_names(tmp_path: Path) -> None:
    def work(count: int) -> int:
        text = HEAD + "".join(f"name_{n} = nane_{n}\n" for n in range(count)) + DONE
        return executed_lines(lambda: reported(tmp_path, "LAU035", "a.launch.py", text))

    work(1)  # imports
    assert work(800) < 3 * work(400)
