"""Calls of launch with arguments that a class does not have, and objects that are no actions."""

from pathlib import Path

import pytest

from tests.launched import PYTHON, reported
from urdfkit import Severity

HEAD = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, RegisterEventHandler
from launch.conditions import IfCondition
from launch.event_handlers import OnProcessExit
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushRosNamespace, SetParameter
def generate_launch_description():
    a = LaunchConfiguration("a", default="b")
    node = Node(package="c", executable="d")
"""

OPAQUE = "node, OpaqueFunction(function=setup)"
SETUP = "from launch.actions import OpaqueFunction\ndef setup(context):\n    {}\n"


def program(entities: str, before: str = "") -> str:
    return f"{HEAD}{before}    return LaunchDescription([{entities}])\n"


@pytest.mark.parametrize(
    ("text", "message", "help"),
    [
        (
            program("node, DeclareLaunchArgument('a', default='b')"),
            "DeclareLaunchArgument has no argument 'default'",
            "write default_value",
        ),
        (
            program("node, Node(package='c', exectuable='d')"),
            "Node has no argument 'exectuable'",
            "write executable",
        ),
        (
            program("node, Node(package='c', executable='d', required=True)"),
            "Node has no argument 'required'",
            "write on_exit=Shutdown() if it is True",
        ),
        (
            program("node, Node(package='c', executable='d', output='console')"),
            "output is 'console', which launch does not know",
            "write screen or log or both or own_log or full",
        ),
        (
            program("node, Node(package='c', executable='d', extra_arguments=[])"),
            "Node has no argument 'extra_arguments'",
            "remove it: it is an argument of ComposableNode",
        ),
        (
            program("node, Node(package='c')"),
            "Node has no executable",
            "write executable=...",
        ),
        (
            program("node, RegisterEventHandler()"),
            "RegisterEventHandler has no event_handler",
            "write event_handler=...",
        ),
        (
            program("node, Node('c', 'd')"),
            "Node takes 0 positional arguments, and 2 are given",
            "write executable=...",
        ),
        (
            program("node, DeclareLaunchArgument('c', 'd', description='e')"),
            "DeclareLaunchArgument takes 1 positional argument, and 2 are given",
            "write default_value=..., choices=...",
        ),
        (
            "from launch.substitutions import PathJoinSubstitution\n"
            + program("node", "    print(PathJoinSubstitution('a', 'b'))\n"),
            "PathJoinSubstitution takes 1 positional argument, and 2 are given",
            "write them in [ ]",
        ),
        (
            SETUP.format("return Node(executable='c')") + program(OPAQUE),
            "setup() returns a Node, but launch expects a list of actions",
            "write it in [ ]",
        ),
        (
            program("node, OnProcessExit(target_action=node, on_exit=[])"),
            "OnProcessExit is not an action",
            "write RegisterEventHandler(OnProcessExit(...))",
        ),
        (
            program("node", "    LaunchDescription().add_action(OnProcessExit(on_exit=[]))\n"),
            "OnProcessExit is not an action",
            "write RegisterEventHandler(OnProcessExit(...))",
        ),
        (
            program("node, Node(executable='d', condition=LaunchConfiguration('c'))"),
            "LaunchConfiguration is no condition, but a substitution",
            "write IfCondition(LaunchConfiguration(...))",
        ),
        (
            "from launch.substitutions import NotSubstitution\n"
            + program("node", "    print(NotSubstitution(IfCondition(a)))\n"),
            "NotSubstitution takes a substitution, but IfCondition is a condition",
            "write what the condition asks",
        ),
    ],
)
def test_calls_that_launch_rejects(tmp_path: Path, text: str, message: str, help: str) -> None:
    (found,) = reported(tmp_path, "LAU033", "a.launch.py", text)
    assert (found.message, found.help, found.severity) == (message, help, Severity.ERROR)


@pytest.mark.parametrize(
    ("text", "start"),
    [
        (program("node, PushRosNamespace('n')"), "PushRosNamespace has no effect"),
        (program("node, SetParameter('x', 1), PushRosNamespace('n')"), "SetParameter has no"),
        (program("GroupAction([node, SetParameter('x', 1)])"), "SetParameter has no effect"),
        (
            program("node, Node(package='c', executable='d', condition=IfCondition(a == 'b'))"),
            "LaunchConfiguration is compared",
        ),
        (program("node", "    if not a:\n        node.x = 1\n"), "a LaunchConfiguration is always"),
    ],
)
def test_what_has_no_effect(tmp_path: Path, text: str, start: str) -> None:
    found = reported(tmp_path, "LAU034 LAU037", "a.launch.py", text)
    assert found[0].message.startswith(start)
    assert {one.severity for one in found} == {Severity.WARNING}


@pytest.mark.parametrize(
    "text",
    [
        program("PushRosNamespace('n'), node"),
        SETUP.format("return [Node(executable='c')]") + program(OPAQUE),
        SETUP.format("def f():\n        return Node(executable='c')\n    return [f()]")
        + program(OPAQUE),
        program("node, Node(package='c', **more)", "    more = {}\n"),
        program("node, TimerAction(*more)", "    more = ()\n").replace(
            "GroupAct", "TimerAction, GroupAct"
        ),
        program("PushRosNamespace('n')", "    print(node)\n"),  # for the files that include it
        program("node, PushRosNamespace('n'), GroupAction([node])"),
        program("node, SetParameter('x', 1), *more", "    more = []\n    more.append(node)\n"),
        program(
            "node, SetParameter('x', 1), node, DeclareLaunchArgument(*more)", "    more = ['e']\n"
        ),
        program("node, RegisterEventHandler(OnProcessExit(target_action=node, on_exit=[]))"),
        program("node, Node(package='c', executable='d', **more)", "    more = {}\n"),
        program("node", "    if a.perform(None) == 'b':\n        node.x = 1\n"),
        program("node", "    if a is None:\n        node.x = 1\n"),
        program("node, Node(executable='d', condition=IfCondition(LaunchConfiguration('c')))"),
        program("node, Node(executable='d', condition=print(a))"),
        "class Node:\n    pass\n"
        + program("node").replace("actions import Node, ", "actions import ")
        + "Node(mine=1, output='mine')\n",
    ],
)
def test_calls_that_launch_accepts(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, PYTHON, "a.launch.py", text) == []


@pytest.mark.parametrize(
    ("call", "function"),
    [
        ("open(a)", "open"),
        ("int(LaunchConfiguration('c'))", "int"),
        ("os.path.exists(a)", "os.path.exists"),
        ("get_package_share_directory(a)", "get_package_share_directory"),
        ("os.path.join('c', a)", "os.path.join"),
        ("int(a.perform(context))", ""),
        ("open('c', a)", ""),
        ("mine.open(a)", ""),
    ],
)
def test_functions_of_python_that_expect_a_text(tmp_path: Path, call: str, function: str) -> None:
    imports = "import os\nimport mine\nfrom ament_index_python.packages import *\ncontext = 1\n"
    text = imports + program("node", f"    print({call})\n")
    found = reported(tmp_path, "LAU034", "a.launch.py", text)
    message = f"{function} rejects LaunchConfiguration: its value is known only at run time"
    assert [(one.message, one.severity) for one in found] == (
        [(message, Severity.ERROR)] if function else []
    )


COMPONENT = "from launch_ros.descriptions import ComposableNode\n"


@pytest.mark.parametrize(
    ("package", "plugin", "help"),
    [
        ("image_proc", "image_proc/RectifyNode", "write image_proc::RectifyNode"),
        ("image_proc", "image_proc::RectifyNod", "write image_proc::RectifyNode"),
        ("image_proc", "image::RectifyNode", "write image_proc::RectifyNode"),
        ("image_proc", "image_proc::RectifyNode", ""),
        ("usb_cam", "usb_cam::Other", ""),
        ("mine", "mine::Node", ""),
    ],
)
def test_classes_of_composable_nodes(tmp_path: Path, package: str, plugin: str, help: str) -> None:
    call = f"ComposableNode(package='{package}', plugin='{plugin}')"
    text = COMPONENT + program("node", f"    print({call})\n")
    found = reported(tmp_path, "LAU038", "a.launch.py", text)
    assert [one.help for one in found] == ([help] if help else [])
    (tmp_path / "xml").mkdir()
    element = f'<composable_node pkg="{package}" plugin="{plugin}"/>'
    container = f'<node_container pkg="r" exec="c" name="n" namespace="">{element}</node_container>'
    found = reported(tmp_path / "xml", "LAU038", "a.launch.xml", container)
    assert [one.help for one in found] == ([help] if help else [])


EXPRESSION = "from launch.substitutions import PythonExpression\n"
ARGUMENT = "    x = LaunchConfiguration('x')\n    DeclareLaunchArgument('x', default_value='{}')\n"


@pytest.mark.parametrize(
    ("parts", "default", "count"),
    [
        ("x, ' and True'", "true", 1),
        ("'not ', x", "false", 1),
        ("\"'\", x, \"' == 'true'\"", "true", 0),
        ("'not ', x", "True", 0),
        ("'not ', unknown(), x", "true", 0),
        ("x, ' > 1'", "2", 0),
    ],
)
def test_expressions_with_a_text_of_yaml(
    tmp_path: Path, parts: str, default: str, count: int
) -> None:
    before = ARGUMENT.format(default) + f"    print(PythonExpression([{parts}]))\n"
    before += "    unknown = len\n"
    found = reported(tmp_path, "LAU034", "a.launch.py", EXPRESSION + program("node", before))
    message = f"the expression contains {default}, which is no name of Python"
    assert [one.message for one in found] == [message] * count


@pytest.mark.parametrize(
    ("test", "default", "count"),
    [
        ("x.perform(context)", "false", 1),
        ("not x.perform(context)", "True", 1),
        ("x.perform(context) == 'true'", "true", 0),
        ("x.perform(context)", "", 0),
        ("x.perform(context)", "name", 0),
    ],
)
def test_texts_of_arguments_as_conditions(
    tmp_path: Path, test: str, default: str, count: int
) -> None:
    before = ARGUMENT.format(default) + f"    context = 1\n    if {test}:\n        print()\n"
    found = reported(tmp_path, "LAU034", "a.launch.py", program("node", before))
    message = f"the text '{default}' is true in Python, and 'false' is, too"
    assert [one.message for one in found] == [message] * count


LOADED = """\
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes
def generate_launch_description():
    ComposableNodeContainer(name="images", namespace=NAMESPACE, executable="component_container")
    LoadComposableNodes(target_container="TARGET", composable_node_descriptions=[])
"""


@pytest.mark.parametrize(
    ("namespace", "target", "help"),
    [
        ("''", "images", ""),
        ("'camera'", "/camera/images", ""),
        ("'camera'", "images", "write /camera/images"),
        ("'camera'", "/camera/image", "write /camera/images"),
        ("'camera'", "other", ""),  # of another launch file
        ("where()", "images", ""),
    ],
)
def test_the_container_of_composable_nodes(
    tmp_path: Path, namespace: str, target: str, help: str
) -> None:
    text = LOADED.replace("NAMESPACE", namespace).replace("TARGET", target)
    found = reported(tmp_path, "LAU038", "a.launch.py", text)
    assert [one.help for one in found if "container" in one.message] == [help] * bool(help)


@pytest.mark.parametrize(
    ("handler", "count"),
    [
        ("OnProcessExit(on_exit=[node])", 1),
        ("OnProcessStart(on_start=node)", 1),
        ("OnProcessExit(target_action=other, on_exit=[node])", 0),
        ("OnProcessExit(on_exit=[node], handle_once=True)", 0),
        ("OnProcessExit(on_exit=[EmitEvent(event=Shutdown())])", 0),
        ("OnProcessExit(on_exit=[node], **more)", 0),
    ],
)
def test_handlers_of_any_process(tmp_path: Path, handler: str, count: int) -> None:
    text = program(f"RegisterEventHandler({handler})", "    more = {}\n")
    text = text.replace("OnProcessExit\n", "OnProcessExit, OnProcessStart\n", 1)
    text = text.replace("DeclareLaunchArgument,", "DeclareLaunchArgument, EmitEvent, Shutdown,", 1)
    found = reported(tmp_path, "LAU037", "a.launch.py", text)
    assert sum("no target_action" in one.message for one in found) == count


@pytest.mark.parametrize(
    ("plugin", "known"), [("image_proc::Other", False), ("image_proc::ResizeNode", True)]
)
def test_a_package_all_of_whose_components_are_known(
    tmp_path: Path, plugin: str, known: bool
) -> None:
    call = f"ComposableNode(package='image_proc', plugin='{plugin}')"
    text = COMPONENT + program("node", f"    print({call})\n")
    found = reported(tmp_path, "LAU038", "a.launch.py", text)
    assert ["image_proc::RectifyNode" in one.help for one in found] == [True] * (not known)


@pytest.mark.parametrize(
    ("value", "count"),
    [("None", 1), ("[{'a': 1}]", 1), ("{'a': 1}", 0), ("[1, 2]", 0), ("''", 0)],
)
def test_values_that_launch_rejects(tmp_path: Path, value: str, count: int) -> None:
    node = f"Node(package='p', executable='e', parameters=[{{'own': {value}}}])"
    text = program("node", f"    print({node})\n")
    found = reported(tmp_path, "LAU033", "a.launch.py", text)
    assert ["own is" in one.message for one in found] == [True] * count


MOVEIT = """from launch_ros.actions import Node
from moveit_configs_utils import MoveItConfigsBuilder
config = MoveItConfigsBuilder("arm", package_name="arm"){}.to_moveit_configs()
node = Node(package="own", executable="own", parameters=[config.{}])
"""


@pytest.mark.parametrize(
    ("method", "attribute", "words"),
    [
        ('.joint_limits(file_path="a")', "joint_limits", []),
        ('.joint_limits(file="a")', "joint_limits", ["has no argument 'file'"]),
        ('.joint_limit("a")', "joint_limits", ["has no method 'joint_limit'; did you mean"]),
        (".own()", "to_dict()", []),
        ("", "joint_limit", ["has no 'joint_limit'; did you mean 'joint_limits'"]),
    ],
)
def test_the_builder_of_moveit(
    tmp_path: Path, method: str, attribute: str, words: list[str]
) -> None:
    text = MOVEIT.format(method, attribute)
    found = [one.message for one in reported(tmp_path / "arm", "LAU033", "a.launch.py", text)]
    assert len(found) == len(words)
    assert all(word in one for word, one in zip(words, found, strict=True))


def test_a_builder_that_builds_nothing(tmp_path: Path) -> None:
    text = MOVEIT.replace(".to_moveit_configs()", "").format(".joint_limits()", "to_dict()")
    (found,) = reported(tmp_path / "arm", "LAU033", "a.launch.py", text)
    assert found.message == "MoveItConfigsBuilder has no 'to_dict', unlike what it builds"


@pytest.mark.parametrize(
    "source", ["uf_ros_lib.moveit_configs_builder import ", "uf_ros_lib import (\n    a,\n    "]
)
def test_the_builder_of_another_package(tmp_path: Path, source: str) -> None:
    """xarm_ros2: its planning_pipelines has the argument config_folder."""
    text = MOVEIT.format('.planning_pipelines(config_folder="a")', "own")
    text = text.replace("moveit_configs_utils import ", source, 1)
    if "(" in source:
        text = text.replace("    MoveItConfigsBuilder\n", "    MoveItConfigsBuilder)\n")
    assert reported(tmp_path / "arm", "LAU033", "a.launch.py", text) == []


@pytest.mark.parametrize(("kind", "count"), [("Node", 1), ("ComposableNode", 0)])
def test_components(tmp_path: Path, kind: str, count: int) -> None:
    text = "from launch_ros.actions import ComposableNodeContainer, Node\n"
    text += "from launch_ros.descriptions import ComposableNode\n"
    text += 'ComposableNodeContainer(name="a", namespace="", package="rclcpp_components", '
    text += 'executable="component_container", composable_node_descriptions='
    text += f'[{kind}(package="own", {"executable" if kind == "Node" else "plugin"}="own")])\n'
    found = [one.message for one in reported(tmp_path / "arm", "LAU038", "a.launch.py", text)]
    assert ["a program of its own" in one for one in found] == [True] * count
