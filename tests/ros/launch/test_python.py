"""Launch files in Python: constants are followed, nothing is run."""

import ast
from pathlib import Path

import pytest

from tests.growth import executed_lines
from tests.ros.launch.python_files import read
from tests.workspaces import add_file
from urdfkit.ros.launch import read_launch
from urdfkit.ros.launch.scopes import Scopes
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver


@pytest.mark.parametrize(
    "body",
    [
        """
share = get_package_share_directory('arm')
path = os.path.join(share, 'urdf', 'arm.xacro')
description = xacro.process_file(path, mappings={'side': 'left'}).toxml()
""",
        """
description = Command([
    PathJoinSubstitution([FindExecutable(name='xacro')]), ' ',
    PathJoinSubstitution([FindPackageShare('arm'), 'urdf', 'arm.xacro']),
    ' side:=', LaunchConfiguration('side'),
])
DeclareLaunchArgument('side', default_value='left')
""",
        """
path = get_package_share_directory('arm') + '/urdf/arm.xacro'
description = Command(['xacro ', path, ' side:=left'])
""",
        """
DeclareLaunchArgument('robot', default_value='arm')
def describe(context):
    robot = context.launch_configurations['robot']
    path = os.path.join(get_package_share_directory('arm'), 'urdf', robot + '.xacro')
    xacro.process_file(path, mappings={'side': context.launch_configurations.get('side')})
DeclareLaunchArgument('side', default_value='left')
""",
        """
DeclareLaunchArgument('file', default_value='arm')
def describe(context):
    path = get_package_share_directory('arm') + '/urdf/'
    return SetLaunchConfiguration('file', path + context.launch_configurations['file'] + '.xacro')
OpaqueFunction(function=describe)
description = Command(['xacro ', LaunchConfiguration('file'), ' side:=left'])
""",
        """
name = 'arm'
description = Command(f"xacro {get_package_share_directory(name)}/urdf/{name}.xacro side:=left")
""",
        """
path = get_package_share_directory('arm')
path = os.path.join(path, 'urdf', 'arm.xacro')
description = Command(['xacro ', path, ' side:=left'])
path = 'elsewhere'
""",
    ],
)
def test_the_robot_and_its_arguments(package, body):
    (description,) = read(package, body).descriptions
    assert Path(description.path) == package / "urdf" / "arm.xacro"
    assert description.arguments == {"side": "left"}


@pytest.mark.parametrize(
    "body",
    [
        "path = 'a.xacro'\nif unknown():\n    path = ARM\nCommand(['xacro ', path])",
        "path = 'a.xacro'\nfor path in (ARM,):\n    pass\nCommand(['xacro ', path])",
        "path = ARM\nload = lambda: Command(['xacro ', path])\npath = 'a.xacro'",
        "Command(['xacro ', path])\npath = ARM\npath = 'a.xacro'",
    ],
)
def test_names_whose_last_value_is_unknown(package, body):
    arm = "get_package_share_directory('arm') + '/urdf/arm.xacro'"
    assert read(package, body.replace("ARM", arm)).descriptions == ()


@pytest.mark.parametrize(
    ("words", "arguments"),
    [
        ("' side:=left address:=', LaunchConfiguration('address')", {"side": "left"}),
        ("' side:=left', ' meshes:=', FindPackageShare('missing')", {"side": "left"}),
        ("' side:=left meshes:=', FindPackageShare('missing'), '/meshes'", {"side": "left"}),
        ("' side:=left ', unknown()", None),  # perhaps the file
        ("'.', unknown()", None),
    ],
)
def test_arguments_known_only_at_run_time(package, words, arguments):
    path = "FindPackageShare('arm'), '/urdf/arm.xacro'"
    found = read(package, f"Command(['xacro ', {path}, {words}])").descriptions
    if arguments is None:
        assert found == ()
    else:
        assert [(one.arguments, one.is_whole) for one in found] == [(arguments, False)]


def test_files_and_packages(package):
    launch = read(
        package,
        """
config = os.path.join(get_package_share_directory('arm'), 'rviz', 'a.rviz')
Node(package='rviz2', executable='rviz2', arguments=['-d', config])
IncludeLaunchDescription(PythonLaunchDescriptionSource(
    [FindPackageShare('no_such_pkg'), '/launch/x.launch.py']))
""",
    )
    assert [(f.purpose, f.exists, f.span.text) for f in launch.files] == [
        ("RViz configuration", False, "config")
    ]
    assert {use.name: use.searched is None for use in launch.packages} == {
        "arm": True,
        "rviz2": False,
        "no_such_pkg": False,
    }


def test_values_known_only_at_run_time_are_ignored(package):
    launch = read(package, "path = open('x').read()\nCommand(['xacro ', path])")
    assert launch.descriptions == ()
    assert launch.files == ()


def test_recursive_names_end(package):
    assert read(package, "a = a + 'x'\nCommand(['xacro ', a])").descriptions == ()


def test_nothing_is_run(package):
    marker = package / "ran"
    read(package, f"open({str(marker)!r}, 'w')")
    assert not marker.exists()


@pytest.mark.parametrize("data", [b"def (:\n", b"\x00", b"x = " + b"(" * 5000])
def test_a_syntax_error_is_reported_at_its_location(data):
    launch = read_launch(Source("a.launch.py", data), Resolver(environment={}))
    (problem,) = launch.problems
    assert problem.code == "LAU001"
    assert problem.span.line == 1


def test_started_programs(package):
    launch = read(
        package,
        """
names = ['a', 'b']
Node(package='p', executable='e', arguments=names + ['-x', unknown(), *more],
     parameters=[{'rate': 1}])
Node(package='p', executable='f', parameters=[config])
ExecuteProcess(cmd=['ros2', 'run'])
""",
    )
    given, unknown, program = launch.started
    assert (given.package, given.executable) == ("p", "e")
    assert given.parameters.every == {"rate": "1"}
    assert [word.text for word in given.words] == ["a", "b", "-x", None, None]
    assert unknown.parameters.every is None
    assert [word.text for word in program.words] == ["ros2", "run"]


def test_composable_nodes(package):
    launch = read(
        package,
        """
ComposableNodeContainer(name='c', namespace='', composable_node_descriptions=[
    ComposableNode(package='nav2_amcl', plugin='nav2_amcl::AmclNode', name='amcl',
                   namespace='r', remappings=[('scan', 'front')], parameters=[{'rate': 1}]),
    ComposableNode(package='p', plugin='p::Own')])
LoadComposableNodes(target_container='c', composable_node_descriptions=more(),
                    condition=IfCondition(LaunchConfiguration('x')))
LoadComposableNodes(target_container='c', composable_node_descriptions=[one],
                    condition=IfCondition(LaunchConfiguration('x')))
LifecycleNode(package='q', executable='e', name='n', namespace='')
""",
    )
    node, own, *unknown, lifecycle = launch.started
    assert (node.package, node.executable, node.name) == ("nav2_amcl", "amcl", "amcl")
    assert (node.namespace, node.remappings) == ("r", {"scan": "front"})
    assert (node.parameters.every, node.is_sure) == ({"rate": "1"}, True)
    assert (own.package, own.executable) == ("p", "")
    assert [(one.package, one.is_sure) for one in unknown] == [("", False)] * 2
    assert (lifecycle.package, lifecycle.executable) == ("q", "e")


@pytest.mark.parametrize(
    ("body", "found"),
    [
        ("if x:\n    f = 'a'\nelse:\n    f = 'b'\nCommand(['xacro ', f])", 0),
        ("for f in ['a']:\n    Command(['xacro ', f])", 0),
        ("with open('a') as f:\n    Command(['xacro ', f])", 0),
        ("def g(f):\n    Command(['xacro ', f])\nf = 'a'", 0),
        ("f = 'a'\ndef g():\n    Command(['xacro ', f])", 1),
        ("f = 'a'\ndef g():\n    f = 'b'", 0),
        ("f = 'a'\nf = 'a'\nCommand(['xacro ', f])", 1),
    ],
)
def test_a_name_with_a_unique_value_is_resolved(package, body, found):
    assert len(read(package, body).files) == found


@pytest.mark.parametrize(
    "body",
    [
        "doc = xacro.parse(open(FindPackageShare('arm').find('arm') + '/urdf/arm.xacro'))",
        "xacro.process_file(FindPackageShare(package='arm').find('arm') + '/urdf/arm.xacro')",
        "load_xacro(Path(FindPackageShare(package='arm').find('arm') + '/urdf/arm.xacro'))",
    ],
)
def test_other_ways_to_the_robot(package, body):
    (description,) = read(package, body).descriptions
    assert Path(description.path) == package / "urdf" / "arm.xacro"


@pytest.mark.parametrize(
    "body",
    [
        "open(path / 'arm.URDF').read()",
        "(path / 'arm.URDF').read_text()",
        "Node(package='robot_state_publisher', arguments=[path / 'arm.URDF'])",
    ],
)
def test_a_plain_urdf(package, body):
    path = add_file(package / "urdf" / "arm.URDF", b"<robot name='r'/>")
    directory = "path = Path(FindPackageShare('arm').find('arm')) / 'urdf'"
    (description,) = read(package, f"{directory}\n{body}").descriptions
    assert (Path(description.path), description.is_expanded) == (path, False)


@pytest.mark.parametrize("rest", ["", ", arguments=[]", ", arguments=['-p', x]", ", arguments=x"])
def test_a_publisher_that_names_no_urdf(package, rest):
    assert read(package, f"Node(package='robot_state_publisher'{rest})").descriptions == ()


@pytest.mark.parametrize(
    ("body", "arguments"),
    [
        ("subprocess.run(['xacro', path, 'side:=left'], text=True).stdout", {"side": "left"}),
        ("subprocess.check_output(args=['xacro', path, 'side:=' + 'left'])", {"side": "left"}),
        ("os.popen('xacro ' + path + ' side:=left').read()", {"side": "left"}),
        ("subprocess.run(['xacro', path, f'side:={unknown()}', 'up:=' + unknown()])", {}),
    ],
)
def test_a_process_expands_the_robot(package, body, arguments):
    path = "path = FindPackageShare('arm').find('arm') + '/urdf/arm.xacro'"
    (description,) = read(package, f"{path}\n{body}").descriptions
    assert Path(description.path) == package / "urdf" / "arm.xacro"
    assert description.arguments == arguments
    assert description.is_whole == bool(arguments)


@pytest.mark.parametrize(
    "text",
    [
        f"x = {'+'.join(['a'] * 990)}\nx = {'+'.join(['b'] * 990)}\nCommand(['xacro ', x])",
        f"x = {'[' * 150}{']' * 150}\nCommand(x)\nNode(arguments=x, parameters=x)",
        "a = b\nb = a\nNode(package=a, arguments=b, parameters=[a])",
        "Node()\nNode(*x, **y)\nIncludeLaunchDescription()\nCommand()\nopen()\nx.parse()",
    ],
    ids=["sum", "deep", "ring", "bare"],
)
def test_hostile_programs_are_read(text):
    read_launch(Source("a.launch.py", text.encode()), Resolver(environment={}))


GROUPS = """\
DeclareLaunchArgument('gui', default_value='true')
gui = LaunchConfiguration('gui')
inner = Node(package='inner', executable='inner')
nodes = [inner]
Node(package='outer', executable='outer')
GroupAction({}, condition={})
"""


@pytest.mark.parametrize(
    ("actions", "condition", "sure"),
    [
        ("[inner]", "IfCondition(gui)", {"inner", "outer"}),
        ("[inner]", "IfCondition(PythonExpression(['not ', gui]))", {"outer"}),
        ("[inner]", "UnlessCondition(gui)", {"outer"}),
        ("nodes", "IfCondition(unknown)", {"outer"}),
        ("[GroupAction(nodes)]", "IfCondition(unknown)", {"outer"}),
        ("[GroupAction(nodes, condition=IfCondition(unknown))]", "IfCondition(gui)", {"outer"}),
        ("actions=unknown()", "IfCondition(unknown)", set()),
        ("[inner, *more]", "IfCondition(unknown)", set()),
    ],
)
def test_what_certainly_runs_with_groups(package, actions, condition, sure):
    started = read(package, GROUPS.format(actions, condition)).started
    assert {program.package for program in started} == {"inner", "outer"}
    assert {program.package for program in started if program.is_sure} == sure


@pytest.mark.parametrize(
    ("condition", "is_sure"),
    [
        ("LaunchConfigurationEquals('sim', 'gz')", True),
        ("IfCondition(PythonExpression([\"'\", LaunchConfiguration('sim'), \"' == 'gz'\"]))", True),
        # The node of another choice: it is started with another value of the argument.
        ("LaunchConfigurationNotEquals('sim', 'gz')", False),
        ("IfCondition(EqualsSubstitution(LaunchConfiguration('sim'), 'classic'))", False),
    ],
)
def test_a_compared_condition(package, condition, is_sure):
    body = "DeclareLaunchArgument('sim', default_value='gz')\n"
    body += f"Node(package='joy', executable='joy_node', condition={condition})"
    (program,) = read(package, body).programs
    assert program.is_sure is is_sure


@pytest.mark.parametrize(
    "step", ["[v{0}, v{0}]", "IfElseSubstitution(v{0}, v{0}, v{0})", "v{0} + v{0}"]
)
def test_values_that_double_at_each_level_end(package, step):
    """A text of 2 to the power of 36 letters, or as many evaluations."""
    names = "".join(f"v{n} = {step.format(n + 1)}\n" for n in reversed(range(36)))
    body = f"v36 = 'true'\n{names}Node(package='joy', executable=v0)"
    (program,) = read(package, body).programs
    assert program.executable in ("", None)


@pytest.mark.parametrize(
    ("number", "text"),
    [
        ("0.13 / 2", "0.065"),
        ("-(2 + 3) * 2", "-10"),
        ("1 / 0", None),
        ("1e308 * 10", None),
        ("9" * 4000, None),  # Python has no text for an integer of more than 4,300 digits
        ("9" * 4000 + " * 2", None),
    ],
)
def test_numbers(package: Path, number: str, text: str | None) -> None:
    words = f"Node(package='joy', executable='joy_node', arguments=[str({number})])"
    (program,) = read(package, words).programs
    assert [word.text for word in program.words] == [text]


def test_numbers_that_double_their_digits_end(package: Path) -> None:
    """2 to the power of 30 times 4,000 digits; the product of two such takes minutes."""
    names = "".join(f"v{n + 1} = v{n} * v{n}\n" for n in range(30))
    body = f"v0 = {'9' * 4000}\n{names}Node(package='joy', executable='e', arguments=[v30])"
    (program,) = read(package, body).programs
    assert [word.text for word in program.words] == [None]


@pytest.mark.parametrize("mappings", ["{'side': unknown(), 'up': 'z'}", "unknown()"])
def test_unknown_arguments(package, mappings):
    path = "FindPackageShare('arm').find('arm') + '/urdf/arm.xacro'"
    (description,) = read(package, f"xacro.process_file({path}, mappings={mappings})").descriptions
    assert not description.is_whole
    assert "side" not in description.arguments


def test_a_name_is_compared_once_for_each_assignment() -> None:
    """5,000 lines ``x = x + 'a'`` took more than a minute."""

    def lines(number: int) -> int:
        tree = ast.parse("x = ''\n" + "x = x + 'a'\n" * number)
        names = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]

        def values() -> None:
            found = Scopes(tree)
            assert {found.value(name) for name in names} == {None}

        return executed_lines(values)

    assert lines(400) < 6 * lines(100)


@pytest.mark.parametrize(("statement", "is_known"), [("pass", True), ("global name", False)])
def test_a_global_name_is_known_at_run_time(statement: str, is_known: bool) -> None:
    """ic120: an OpaqueFunction stores the namespace for the others."""
    tree = ast.parse(
        "name = ''\n"
        f"def store(context):\n    {statement}\n    name = context.launch_configurations['name']\n"
        "def nodes():\n    return name\n"
    )
    read = [node for node in ast.walk(tree) if isinstance(node, ast.Name) and node.id == "name"]
    value = Scopes(tree).value(read[-1])
    assert (value is not None) is is_known
