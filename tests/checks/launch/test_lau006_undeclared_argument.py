"""LAU006: see the rule."""

from pathlib import Path

import pytest

from tests.launched import launch, reported
from tests.naming import naming

NODE = '<node pkg="a" type="b" name="c" args="$(arg {})"/>'
PYTHON = """from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
DeclareLaunchArgument({declared!r}, default_value="1")
LaunchConfiguration({used!r}{more})
"""


def test_a_typo_in_xml(tmp_path: Path) -> None:
    text = '<arg name="speed" default="1"/>\n' + NODE.format("sped")
    (found,) = reported(tmp_path, "LAU006", "a.launch", text)
    assert found.message == naming("sped", "speed")
    assert (found.span.line, found.span.text) == (3, "$(arg sped)")


def test_a_declaration_that_comes_too_late(tmp_path: Path) -> None:
    text = NODE.format("speed") + '\n<arg name="speed" default="1"/>'
    (found,) = reported(tmp_path, "LAU006", "a.launch", text)
    assert found.message == naming("speed", "before")


@pytest.mark.parametrize(
    "text",
    [
        '<arg name="speed"/>' + NODE.format("speed"),
        '<arg name="on" default="false"/><arg name="speed" value="1" if="$(arg on)"/>'
        + NODE.format("speed"),
        '<arg name="on" default="false"/><group if="$(arg on)">' + NODE.format("x") + "</group>",
        "<!-- $(arg x) -->",
    ],
)
def test_declared_or_disabled_argument_is_accepted(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU006", "a.launch", text) == []


def test_included_file_gets_passed_arguments(tmp_path: Path) -> None:
    inner = {"launch/b.launch": launch(NODE.format("x"))}
    text = '<include file="$(dirname)/b.launch">{}</include>'
    (found,) = reported(tmp_path, "LAU006", "a.launch", text.format(""), inner)
    assert Path(found.span.source.path).name == "b.launch"
    outer = text.format('<arg name="x" value="1"/>')
    assert reported(tmp_path, "LAU006", "a.launch", outer, inner) == []


def test_included_file_may_get_the_argument(tmp_path: Path) -> None:
    outer = {"launch/b.launch": launch('<include file="$(dirname)/a.launch"/>')}
    assert reported(tmp_path, "LAU006", "a.launch", NODE.format("x"), outer) == []


def test_a_typo_in_python(tmp_path: Path) -> None:
    text = PYTHON.format(declared="use_sim_time", used="use_simtime", more="")
    (found,) = reported(tmp_path, "LAU006", "a.launch.py", text)
    assert found.message == naming("use_simtime", "use_sim_time")
    assert (found.span.line, found.span.text) == (4, "LaunchConfiguration('use_simtime')")


@pytest.mark.parametrize(
    ("head", "used", "more"),
    [
        ("", "gui", ""),
        ("", "guy", ", default='x'"),
        ("DeclareLaunchArgument('guy')\n", "guy", ""),
    ],
)
def test_argument_that_may_be_declared_is_accepted(
    tmp_path: Path, head: str, used: str, more: str
) -> None:
    text = head + PYTHON.format(declared="gui", used=used, more=more)
    assert reported(tmp_path, "LAU006", "a.launch.py", text) == []


@pytest.mark.parametrize(("used", "count"), [("depth_image_height", 0), ("image_heigth", 1)])
def test_argument_of_an_including_file_may_have_a_longer_name(
    tmp_path: Path, used: str, count: int
) -> None:
    """As in NVIDIA's isaac_manipulator, where both names are arguments of the outer file."""
    outer = {"launch/outer.launch": launch('<include file="$(dirname)/a.launch.py"/>')}
    text = PYTHON.format(declared="image_height", used=used, more="")
    assert len(reported(tmp_path, "LAU006", "a.launch.py", text, outer)) == count


USE = "LaunchConfiguration('model')\n"


def test_in_python(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "LAU006", "a.launch.py", USE)
    assert found.message == naming("model", "caller")
    assert found.span.text == "LaunchConfiguration('model')"


def test_in_xml(tmp_path: Path) -> None:
    text = '<let name="x" value="1"/><log message="$(var model)"/>'
    (found,) = reported(tmp_path, "LAU006", "a.launch", text)
    assert (found.message, found.span.line) == (
        naming("model", "caller"),
        2,
    )


@pytest.mark.parametrize(
    "head",
    [
        "DeclareLaunchArgument('model')\n",
        "SetLaunchConfiguration('model', 'x')\n",
        "from arm_bringup.helpers import declare\n",
        "for n in names: DeclareLaunchArgument(n)\n",
        "IncludeLaunchDescription(somewhere())\n",
    ],
)
def test_configuration_that_may_be_declared_is_accepted(tmp_path: Path, head: str) -> None:
    assert reported(tmp_path, "LAU006", "a.launch.py", head + USE) == []


def test_launch_files_of_ros_without_declarations(tmp_path: Path) -> None:
    head = "IncludeLaunchDescription([FindPackageShare('{}'), '/launch/x.launch.py'])\n"
    assert len(reported(tmp_path, "LAU006", "a.launch.py", head.format("ros_gz_sim") + USE)) == 1
    assert reported(tmp_path, "LAU006", "a.launch.py", head.format("some_arm") + USE) == []


def test_included_file_may_get_the_argument_configuration(tmp_path: Path) -> None:
    outer = {"launch/b.launch": launch('<include file="$(dirname)/a.launch.py"/>')}
    assert reported(tmp_path, "LAU006", "a.launch.py", USE, outer) == []


def test_file_with_a_computed_name_may_get_the_argument(tmp_path: Path) -> None:
    includes = "IncludeLaunchDescription([directory, '/launch/gz_', name, '{}'])\n"
    for end, count in ((".launch.py", 0), ("_arm.launch.py", 0), ("_base.launch.py", 1)):
        outer = {"launch/b.launch.py": includes.format(end)}
        assert len(reported(tmp_path, "LAU006", "gz_arm.launch.py", USE, outer)) == count


def test_unread_configuration_is_accepted(tmp_path: Path) -> None:
    assert reported(tmp_path, "LAU006", "a.launch.py", "model = " + USE) == []
    assert (
        len(reported(tmp_path, "LAU006", "a.launch.py", "model = " + USE + "print(model)\n")) == 1
    )


@pytest.mark.parametrize(
    ("name", "declaration", "use"),
    [
        ("a.launch", '<arg name="speed_{}" default="1"/>', NODE.format("spead_{}")),
        (
            "a.launch.py",
            "DeclareLaunchArgument('speed_{}', default_value='1')",
            "LaunchConfiguration('spead_{}')",
        ),
    ],
)
def test_few_of_many_get_a_suggestion(
    tmp_path: Path, name: str, declaration: str, use: str
) -> None:
    """Each was compared with all before it: 5,000 of each took minutes and 3 GB."""
    text = "\n".join(line.format(number) for line in (declaration, use) for number in range(100))
    found = reported(tmp_path, "LAU006", name, text)
    assert len(found) == 100
    assert ["did you mean" in one.message for one in found] == [True] * 50 + [False] * 50


@pytest.mark.parametrize(("items", "count"), [("arguments + nodes", 0), ("nodes", 1)])
def test_arguments_that_are_in_no_launch_description(
    tmp_path: Path, items: str, count: int
) -> None:
    text = (
        "arguments = [DeclareLaunchArgument('x', default_value='1')]\n"
        "nodes = [Node(package='p', executable='e', arguments=[LaunchConfiguration('x')])]\n"
        f"d = LaunchDescription({items})\nprint(d)\n"
    )
    found = reported(tmp_path, "LAU006", "a.launch.py", text)
    assert ["'x'" in one.message for one in found] == [True] * count


LATE = """\
def generate_launch_description():
    model = LaunchConfiguration("model")
    node = Node(package="p", executable="e", arguments=[model])
    declare = DeclareLaunchArgument("model", default_value="x")
    {}
"""
NODE_IF = 'Node(package="p", executable="e", condition=IfCondition(model))'


@pytest.mark.parametrize(
    ("body", "count"),
    [
        ("return LaunchDescription([node, declare])", 1),
        ("return LaunchDescription([declare, node])", 0),
        ("d = LaunchDescription(); d.add_action(node); d.add_action(declare); return d", 1),
        ("d = LaunchDescription(); d.add_action(declare); d.add_action(node); return d", 0),
        (f"return LaunchDescription([{NODE_IF}, declare])", 1),
        ('return LaunchDescription([Node(arguments=[model], condition=c("x")), declare])', 0),
        ("return LaunchDescription([TimerAction(period=1.0, actions=[node]), declare])", 0),
        ("return LaunchDescription([OpaqueFunction(function=f), node, declare])", 0),
        ("return LaunchDescription([IncludeLaunchDescription(x()), node, declare])", 0),
        ('return LaunchDescription([SetLaunchConfiguration("model", "y"), node, declare])', 0),
        ("return LaunchDescription(others() + [node, declare])", 0),
    ],
)
def test_a_declaration_in_python_that_comes_too_late(tmp_path: Path, body: str, count: int) -> None:
    found = reported(tmp_path, "LAU006", "a.launch.py", LATE.format(body))
    message = naming("model", "before")
    assert [one.message for one in found] == [message] * count


def test_an_include_may_declare_what_is_used_before(tmp_path: Path) -> None:
    include = "IncludeLaunchDescription('b.launch'{})"
    given = ", launch_arguments={'model': 'y'}.items()"
    inner = {"launch/b.launch": launch('<arg name="other" default="1"/>')}
    for more, count in (("", 1), (given, 0)):
        body = f"return LaunchDescription([{include.format(more)}, node, declare])"
        found = reported(tmp_path, "LAU006", "a.launch.py", LATE.format(body), inner)
        assert len(found) == count


def test_a_file_that_includes_it_may_set_what_is_declared_late(tmp_path: Path) -> None:
    outer = {"launch/b.launch": launch('<include file="$(dirname)/a.launch.py"/>')}
    text = LATE.format("return LaunchDescription([node, declare])")
    assert reported(tmp_path, "LAU006", "a.launch.py", text, outer) == []
