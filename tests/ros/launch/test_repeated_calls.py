"""Functions that a Python launch file calls several times to create actions."""

import ast
from pathlib import Path

import pytest

from tests.ros.launch.python_files import HEAD, included, read
from urdfkit import check
from urdfkit.ros.launch.repeated_calls import with_copies

SPAWNER = "def spawner(name): return Node(package='p', executable='e', name=name)\n"


@pytest.mark.parametrize(
    ("program", "count"),
    [
        (SPAWNER + "spawner('a')\nspawner('b')", 2),
        (SPAWNER + "spawner('a')", 1),
        (SPAWNER + "spawner('a')\nspawner('b')\nmap(spawner, names)", 1),
        (SPAWNER.replace("Node", "dict") + "spawner('a')\nspawner('b')", 1),
        (SPAWNER + "spawner('a')\n" * 13, 1),
        (SPAWNER + SPAWNER + "spawner('a')\nspawner('b')", 2),
        ("def g():\n    " + SPAWNER + "    return [spawner('a'), spawner('b')]", 2),
    ],
)
def test_copies(program: str, count: int) -> None:
    tree = with_copies(ast.parse(program))
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    assert sum(function.name == "spawner" for function in functions) == count


def test_many_copies_are_not_made() -> None:
    functions = "".join(SPAWNER.replace("spawner", f"f{number}") for number in range(200))
    calls = "".join(f"f{number}(1)\n" * 12 for number in range(200))
    tree = ast.parse(functions + calls)
    assert with_copies(tree) is tree


def test_nodes_and_included_files(package: Path) -> None:
    """A mobile manipulator whose launch file includes three others by one function."""
    for name in ("one.launch.py", "two.launch.py"):
        included(package, name, f"Node(package='p', executable='{name[:3]}')")
    body = """
def node(name, **parameters):
    return Node(package='p', executable='e', name=name, parameters=[parameters])
def part(name, **arguments):
    path = os.path.join(get_package_share_directory('arm'), 'launch', name)
    return IncludeLaunchDescription(path, launch_arguments=arguments.items())
return LaunchDescription([
    node('a', rate=1), node('b', rate=2), part('one.launch.py', x='1'), part('two.launch.py')])
"""
    launch = read(package, body)
    assert [program.executable for program in launch.programs] == ["e", "e", "one", "two"]
    assert {program.name for program in launch.programs[:2]} == {"a", "b"}
    assert launch.unread == ()


def test_a_problem_is_reported_once(package: Path) -> None:
    lines = """    def node(name):
        return Node(pakage='p', executable='e', name=name)
    return LaunchDescription([node('a'), node('b')])
"""
    (package / "launch" / "a.launch.py").write_text(HEAD + lines)
    found = check(package / "launch" / "a.launch.py").diagnostics
    assert [one.span.text for one in found if "pakage" in one.message] == ["'p'"]
