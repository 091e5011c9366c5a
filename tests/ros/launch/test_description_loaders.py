"""Classes of a workspace that load a robot description for launch files."""

import ast
from pathlib import Path

import pytest

from tests.ros.launch.python_files import read
from tests.workspaces import add_file
from urdfkit.ros.launch.description_loaders import with_loaders

LOADER = """
import os
from launch.substitutions import Command

class Loader():
    def __init__(self):
        self.path = os.path.join('urdf', 'arm.xacro')
        self.camera = 'false'
        self.gazebo = 'false'

    def load(self):
        return Command(['xacro ', self.path, ' camera:=', self.camera, ' gazebo:=', self.gazebo])

    def load_of(self, path):
        return Command(['xacro ', path])

    def twice(self):
        if self.camera:
            return 1
        return 2
"""
COMMAND = "Command(['xacro ', os.path.join('urdf', 'arm.xacro'), ' camera:=', {}, ' gazebo:=', {}])"


def unparsed(body: str, head: str = "from arm.loader import Loader") -> str:
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    tree = ast.parse(f"{head}\n\ndef generate():\n{lines}")
    modules = {"arm.loader": ast.parse(LOADER)}
    found = with_loaders(tree, modules.get)
    *_, function = found.body
    assert isinstance(function, ast.FunctionDef)
    return "\n".join(map(ast.unparse, function.body))


@pytest.mark.parametrize(
    ("body", "camera", "gazebo"),
    [
        ("a = Loader()\nreturn a.load()", "'false'", "'false'"),
        ("a = Loader()\na.gazebo = 'true'\nreturn a.load()", "'false'", "'true'"),
        (
            "a = Loader()\na.camera = LaunchConfiguration('camera')\nreturn a.load()",
            "LaunchConfiguration('camera')",
            "'false'",
        ),
        ("a = Loader()\na.camera = 'x'\na.camera = 'y'\nreturn a.load()", "'y'", "'false'"),
        ("a = Loader()\nreturn a.load()\na.camera = 'x'", "'false'", "'false'"),
    ],
)
def test_a_call_is_what_the_method_returns(body: str, camera: str, gazebo: str) -> None:
    assert f"return {COMMAND.format(camera, gazebo)}" in unparsed(body)


@pytest.mark.parametrize(
    "body",
    [
        "a = Loader()\nif b:\n    a.camera = 'true'\nreturn a.load()",  # known only at run time
        "a = Loader(1)\nreturn a.load()",
        "a = Loader()\na = other()\nreturn a.load()",
        "a = Loader()\nreturn a.load_of('x')",
        "a = Loader()\nreturn a.twice()",
        "a = Loader()\nreturn a.save()",
        "return a.load()",
    ],
)
def test_other_calls_stay(body: str) -> None:
    assert unparsed(body) == ast.unparse(ast.parse(body))


@pytest.mark.parametrize(
    "head",
    ["from .loader import Loader", "from loader import Loader", "from other.loader import Loader"],
)
def test_modules_that_are_not_found(head: str) -> None:
    body = "a = Loader()\nreturn a.load()"
    assert unparsed(body, head) == body


def test_many_copies() -> None:
    body = "a = Loader()\n" + "a.load()\n" * 5000
    text = unparsed(body)
    assert "Command(" in text
    assert "a.load()" in text


def test_a_robot_is_read_with_the_values_of_its_launch_file(package: Path) -> None:
    """RT's CRANE+: crane_plus_description has the class, crane_plus_gazebo the launch file."""
    path = "os.path.join(get_package_share_directory('arm'), 'urdf', 'arm.xacro')"
    module = LOADER.replace("os.path.join('urdf', 'arm.xacro')", path)
    add_file(package / "arm" / "loader.py", module)
    body = "from arm.loader import Loader\na = Loader()\na.gazebo = 'true'\n"
    node = "Node(package='p', executable='e', parameters=[{'robot_description': a.load()}])"
    file = package / "launch" / "a.launch.py"
    launch = read(package, f"{body}return LaunchDescription([{node}])")
    assert launch.descriptions == ()  # imported in a function
    text = file.read_text().replace("    from arm.loader import Loader\n", "")
    file.write_text("from arm.loader import Loader\n" + text)
    from urdfkit.ros.launch import read_launch
    from urdfkit.text.source import Source
    from urdfkit.workspace.resolve import Resolver

    launch = read_launch(Source.read(file), Resolver(environment={}))
    (robot,) = launch.descriptions
    assert robot.path == str(package / "urdf" / "arm.xacro")
    assert robot.arguments == {"camera": "false", "gazebo": "true"}
    assert launch.problems == ()


def test_a_command_line_of_any_length(package: Path) -> None:
    """A name stands for a long text, thousands of times; the command line is not read."""
    name = "x" * 1000
    for count, files in ((10, 1), (200, 0)):
        names = ", ".join(["name"] * count)
        launch = read(package, f"name = '{name}'\nCommand(['xacro /', {names}])")
        assert len(launch.files) == files
