"""Launch files in Python that include others: arguments are passed on."""

import pytest

from tests.ros.launch.python_files import ARM, include, included, read


@pytest.mark.parametrize(
    ("body", "side"),
    [
        (include("rsp.launch.py"), "none"),
        (include("rsp.launch.py", ", launch_arguments={'side': 'left'}.items()"), "left"),
        (include("rsp.launch.py", ", launch_arguments=[('side', 'left')]"), "left"),
        (
            "DeclareLaunchArgument('side', default_value='right')\n" + include("rsp.launch.py"),
            "right",
        ),
        ("yes = 'true'\n" + include("rsp.launch.py", ", condition=IfCondition(yes)"), "none"),
    ],
)
def test_the_robot_of_an_included_file(package, body, side):
    included(package)
    (description,) = read(package, body).descriptions
    assert description.arguments == {"side": side}
    assert [step.name for step in description.frame.steps()] == ["a.launch.py", "rsp.launch.py"]


@pytest.mark.parametrize(
    ("side", "value"),
    [
        ("PythonExpression([\"'left' if \", lefty, \" else 'right'\"])", "left"),
        ("IfElseSubstitution(lefty, if_value='left', else_value='right')", "left"),
        ("IfElseSubstitution(NotSubstitution(lefty), else_value='right')", "right"),
        ("IfElseSubstitution(EqualsSubstitution(lefty, 'true'), 'left', 'right')", "left"),
    ],
)
def test_a_computed_argument(package, side, value):
    included(package)
    body = "lefty = LaunchConfiguration('lefty', default='True')\n"
    body += include("rsp.launch.py", f", launch_arguments={{'side': {side}}}.items()")
    (description,) = read(package, body).descriptions
    assert description.arguments == {"side": value}


@pytest.mark.parametrize(
    "side",
    [
        "os.environ.get('SIDE', 'left')",
        "os.getenv('SIDE', default='left')",
        "EnvironmentVariable('SIDE', default_value='left')",
        "TextSubstitution(text='left')",
        "context.perform_substitution(LaunchConfiguration('s', default='left'))",
    ],
)
def test_a_value_that_is_passed_on(package, side):
    included(package)
    body = include("rsp.launch.py", f", launch_arguments={{'side': {side}}}.items()")
    (description,) = read(package, body).descriptions
    assert description.arguments == {"side": "left"}


@pytest.mark.parametrize(
    ("distribution", "test", "value"),
    [
        ("os.environ.get('ROS_DISTRO')", "== 'humble'", "right"),
        ("os.environ['ROS_DISTRO']", "!= 'humble'", "left"),
        ("os.getenv('ROS_DISTRO', 'humble')", "== 'humble'", "left"),
        ("EnvironmentVariable('ROS_DISTRO')", "== 'jazzy'", "left"),
        ("os.environ.get('GAZEBO')", "== 'humble'", None),
        ("os.environ['ROS_DISTRO']", "in ('humble', 'jazzy')", "left"),
        ("os.environ['ROS_DISTRO']", "not in ('humble', other)", None),
        ("os.environ['ROS_DISTRO']", "in 'humble, jazzy'", None),
        ("os.environ['ROS_DISTRO'].lower()", "== 'jazzy'", "left"),
    ],
)
def test_an_argument_for_a_distribution(package, distribution, test, value):
    """Of a launch file for several, the branch for current ones, wherever it is checked."""
    included(package)
    body = f"distribution = {distribution}\n"
    body += f"side = 'left' if distribution {test} else 'right'\n"
    body += include("rsp.launch.py", ", launch_arguments={'side': side}.items()")
    (description,) = read(package, body).descriptions
    assert description.arguments == ({} if value is None else {"side": value})


@pytest.mark.parametrize(
    "directory",
    [
        "os.path.dirname(os.path.realpath(__file__))",
        "str(Path(__file__).parent.resolve())",
        "os.path.join(os.path.dirname(os.path.dirname(__file__)), 'launch')",
    ],
)
def test_a_path_from_the_launch_file(package, directory):
    included(package)
    source = f"PythonLaunchDescriptionSource(os.path.join({directory}, 'rsp.launch.py'))"
    (description,) = read(package, f"IncludeLaunchDescription({source})").descriptions
    assert description.arguments == {"side": "none"}


@pytest.mark.parametrize(
    "rest",
    [
        ", launch_arguments=unknown()",
        ", condition=IfCondition('false')",
        ", condition=UnlessCondition('True')",
    ],
)
def test_unknown_contents_of_an_included_file_are_ignored(package, rest):
    included(package)
    assert read(package, include("rsp.launch.py", rest)).descriptions == ()


def test_files_that_include_each_other_end(package):
    included(package, body=f"{ARM}\n{include('a.launch.py')}\n{include('rsp.launch.py')}")
    assert len(read(package, include("rsp.launch.py")).descriptions) == 1


def test_xml_and_python_include_each_other(package):
    included(package)
    (package / "launch" / "m.launch.xml").write_text(
        "<launch><include file='$(find-pkg-share arm)/launch/rsp.launch.py'>"
        "<arg name='side' value='left'/></include></launch>"
    )
    (description,) = read(package, include("m.launch.xml")).descriptions
    assert description.arguments == {"side": "left"}
    steps = [step.name for step in description.frame.steps()]
    assert steps == ["a.launch.py", "m.launch.xml", "rsp.launch.py"]


@pytest.mark.parametrize(
    "value",
    [
        "os" + "[0]" * 500,
        "os.environ" + ".get" * 500 + "('ROS_DISTRO')",
        "'a' if distribution == 'b' else " * 90 + "'c'",
    ],
)
def test_a_long_chain_is_unknown(package, value):
    """Python parses what its own functions for syntax trees are too deep for."""
    text = f"import os\nside = {value}\n" + include("rsp.launch.py", ", launch_arguments=side")
    text += "\nNode(package='joy', executable=side)"
    assert [program.executable for program in read(package, text).programs][-1:] == [""]


@pytest.mark.parametrize(
    ("passed", "count"),
    [
        ("'false'", 0),
        ("'true'", 1),
        ("LaunchConfiguration('spawn', default='false')", 1),  # the user may choose
    ],
)
def test_a_literal_that_switches_a_node_off(package, passed, count):
    """Moth-Balls/husky_kinova_sim: another file spawns the controllers."""
    included(
        package,
        body="""
spawn = LaunchConfiguration('spawn')
node = Node(package='controller_manager', executable='spawner', condition=IfCondition(spawn))
return LaunchDescription([DeclareLaunchArgument('spawn', default_value='true'), node])
""",
    )
    arguments = f", launch_arguments={{'spawn': {passed}}}.items()"
    assert len(read(package, include("rsp.launch.py", arguments)).programs) == count
