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
        (SPAWNER.replace("return Node", "yield dict") + "spawner('a')\nspawner('b')", 1),
        (SPAWNER.replace("Node", "dict") + "spawner('a')\nspawner('b')", 2),
        (SPAWNER.replace("Node", "dict").replace("(name)", "(*name)") + "spawner('a')\n" * 2, 2),
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


HELPERS = """
def share(*parts):
    return PathJoinSubstitution([FindPackageShare('arm'), *parts])
def prefix():
    return 'left_'
def spawner(controllers, *files, condition=None):
    arguments = [*controllers, '--controller-manager', '/controller_manager']
    for file in files:
        arguments += ['--param-file', share('config', file)]
    return Node(package='controller_manager', executable='spawner', arguments=arguments,
                condition=condition)
NODES = {'amcl': 1, 'map_server': 2}
return LaunchDescription([
    spawner(['states']), spawner([prefix() + 'arm', 'hand'], 'a.yaml', 'b.yaml'),
    Node(package='p', executable='e', parameters=[share('config', 'a.yaml')]),
    Node(package='p', executable='e', parameters=[
        {'names': list(NODES), 'keys': list(NODES.keys())}]),
])
"""


def test_functions_for_paths_and_words(package: Path) -> None:
    """A bring-up with helpers for paths, and spawners with any number of files."""
    (package / "config").mkdir()
    for name in ("a.yaml", "b.yaml"):
        (package / "config" / name).write_text("{}")
    launch = read(package, HELPERS)
    states, arm, with_file, with_names = launch.programs
    files = [str(package / "config" / name) for name in ("a.yaml", "b.yaml")]
    manager = ["--controller-manager", "/controller_manager"]
    assert [word.text for word in states.words] == ["states", *manager]
    words = ["left_arm", "hand", *manager, "--param-file", files[0], "--param-file", files[1]]
    assert [word.text for word in arm.words] == words
    assert arm.is_sure
    assert with_file.parameters.files == (files[0],)
    assert with_names.parameters.lists == dict.fromkeys(("names", "keys"), ("amcl", "map_server"))


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        ("words += ['b']", ["a", "b"]),
        ("words += more", ["a", None]),
        ("if more: words += ['b']", [None]),
        ("for one in more: words += [one]", [None]),
        ("for one in ('b', 'c'): words += [one]", ["a", "b", "c"]),
        ("for one in ('b', 'c'): words += one", [None]),
        ("words -= ['b']", [None]),
    ],
)
def test_a_list_that_grows(package: Path, statement: str, words: list[str | None]) -> None:
    node = "Node(package='p', executable='e', arguments=words)"
    launch = read(package, f"words = ['a']\n{statement}\nreturn LaunchDescription([{node}])\n")
    assert [word.text for word in launch.programs[0].words] == words


@pytest.mark.parametrize(
    ("test", "world"),
    [
        ("headless", "b"),
        ("not headless", "a"),
        ("LaunchConfiguration('gui').perform(context) in ('true', '1')", "a"),
        ("LaunchConfiguration('gui').perform(context).lower() not in ['true']", "b"),
        ("LaunchConfiguration('gui').perform(context) in others", None),
    ],
)
def test_a_choice_in_an_opaque_function(package: Path, test: str, world: str | None) -> None:
    body = f"""
def actions(context):
    headless = LaunchConfiguration('gui').perform(context) == 'false'
    world = 'a' if {test} else 'b'
    return [Node(package='p', executable='e', arguments=[f'{{world}}'])]
return LaunchDescription([
    DeclareLaunchArgument('gui', default_value='true'), OpaqueFunction(function=actions)])
"""
    assert read(package, body).programs[0].words[0].text == world
