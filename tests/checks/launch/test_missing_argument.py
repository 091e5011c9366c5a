"""LAU005: see the rule."""

from pathlib import Path

import pytest

from tests.launched import launch, reported
from tests.naming import naming

NEEDS = launch('<arg name="world"/><param name="w" value="$(arg world)"/>')
XML = '<include file="$(find arm)/launch/b.launch"{}>{}</include>'
PYTHON = 'IncludeLaunchDescription("b.launch.py"{})\n'


def test_an_argument_without_a_default(tmp_path: Path) -> None:
    (found,) = reported(
        tmp_path, "LAU005", "a.launch", XML.format("", ""), {"launch/b.launch": NEEDS}
    )
    assert found.message == naming("b.launch", "world")
    assert found.span.line == 2


@pytest.mark.parametrize(
    ("attribute", "content", "needs"),
    [
        ("", '<arg name="world" value="empty"/>', NEEDS),
        (' pass_all_args="true"', "", NEEDS),
        ("", "", NEEDS.replace("/>", ' default="empty"/>', 1)),
        ("", "", launch('<arg name="world"/>')),
        ("", "", NEEDS.replace("<param", '<param if="$(env W)"')),
    ],
)
def test_passed_or_optional_argument_is_accepted(
    tmp_path: Path, attribute: str, content: str, needs: str
) -> None:
    text = XML.format(attribute, content)
    assert reported(tmp_path, "LAU005", "a.launch", text, {"launch/b.launch": needs}) == []


def test_in_python(tmp_path: Path) -> None:
    files = {"launch/b.launch.py": 'DeclareLaunchArgument("world")'}
    (found,) = reported(tmp_path, "LAU005", "a.launch.py", PYTHON.format(""), files)
    assert found.message == naming("b.launch.py", "world")


@pytest.mark.parametrize(
    "text",
    [
        PYTHON.format(", launch_arguments={'world': 'empty'}.items()"),
        PYTHON.format(", launch_arguments=[('world', 'empty')]"),
        PYTHON.format(", launch_arguments=anything"),
        PYTHON.format("") + "DeclareLaunchArgument('world')",
    ],
)
def test_argument_passed_in_python_is_accepted(tmp_path: Path, text: str) -> None:
    files = {"launch/b.launch.py": 'DeclareLaunchArgument("world")'}
    assert reported(tmp_path, "LAU005", "a.launch.py", text, files) == []
