"""LAU010: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming

ROS_1 = '<rosparam file="$(find a)/b.yaml"/>\n'
ROS_2 = '<let name="x" value="$(var x)"/>\n'


@pytest.mark.parametrize(
    ("text", "word", "help"),
    [
        (ROS_1 + '<node pkg="a" tpye="b" name="c"/>', "b", naming("type")),
        (ROS_1 + '<node pkg="a" exec="b" name="c"/>', "b", naming("type")),
        (ROS_1 + '<nod pkg="a"/>', '<nod pkg="a"/>', naming("<node>")),
        (ROS_2 + '<node pkg="a" type="b"/>', "b", naming("exec")),
        (ROS_2 + '<node pkg="a" exec="b" ns="c"/>', "c", naming("namespace")),
        (
            ROS_2 + '<node pkg="a" exec="b"><rename from="c"/></node>',
            '<rename from="c"/>',
            naming("<remap>", "<param>", "<env>"),
        ),
        (
            ROS_1 + '<node pkg="a" type="b" name="c"><rename from="c"/></node>',
            '<rename from="c"/>',
            naming("<remap>", "<param>", "<rosparam>", "<env>"),
        ),
        (
            ROS_2 + '<node pkg="a" exec="b" required="true"/>',
            "true",
            naming('on_exit="shutdown"'),
        ),
    ],
)
def test_unknown_tags_and_attributes(tmp_path: Path, text: str, word: str, help: str) -> None:
    (found,) = reported(tmp_path, "LAU010", "a.launch", text)
    assert (found.span.line, found.span.text, found.help) == (3, word, help)


@pytest.mark.parametrize(
    "text",
    [
        ROS_1 + '<node pkg="a" type="b" name="c" respawn="true" rosmon-memory-limit="1"/>',
        ROS_2 + '<node pkg="a" exec="b" if="$(var x)" ros_args="--log-level info"/>',
        ROS_2 + '<group scoped="false"><set_env name="A" value="b"/></group>',
        ROS_2 + "<autoware_thing/>",
        ROS_1 + '<node pkg="a" type="b" name="c" required="True" respawn="$(arg d)"/>',
        ROS_1 + """<group if="$(eval arg('a') == 'b')"/><group unless=" $(arg a) "/>""",
    ],
)
def test_valid_element_is_accepted(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU010", "a.launch", text) == []


@pytest.mark.parametrize(
    ("text", "message", "help"),
    [
        (
            ROS_2 + '<node pkg="a" exec="b"><rosparam file="c"/></node>',
            naming("ROS 2", "<rosparam>"),
            naming('<param from="FILE"/>', "<node>"),
        ),
        (
            ROS_2 + '<remap from="a" to="b"/>',
            naming("<remap>", "<node>", "ROS 2"),
            naming("<set_remap from=... to=.../>"),
        ),
        (
            ROS_2 + '<include file="a"><param name="a" value="b"/></include>',
            naming("<param>", "<node>", "ROS 2"),
            naming("<set_parameter name=... value=.../>"),
        ),
        (
            ROS_2 + '<arg name="a" value="b"/>',
            naming("<arg>", "<include>", "ROS 2"),
            naming("<let>"),
        ),
        (
            ROS_2 + '<group ns="a"/>',
            naming("unknown", "ns", "<group>", "ROS 2"),
            naming("<push_ros_namespace namespace=...>"),
        ),
        (
            ROS_1 + '<let name="a" value="$(arg b)"/><node pkg="a" type="b" name="c"/>',
            naming("ROS 1", "<let>"),
            naming("<arg name=... value=.../>"),
        ),
        (
            ROS_2 + """<group if="$(eval arg('x') == 'y')"/>""",
            naming("ROS 2", "$(eval ...)", "arg()"),
            naming("$(var x)"),
        ),
        (
            ROS_2 + '<node pkg="a" exec="b"><param from="$(find-pkg-share arm/config)/a"/></node>',
            naming("arm/config"),
            naming("arm", "/config", "after"),
        ),
    ],
)
def test_what_this_ros_does_not_have(tmp_path: Path, text: str, message: str, help: str) -> None:
    found = reported(tmp_path, "LAU010", "a.launch", text)
    assert [(one.message, one.help) for one in found] == [(message, help)]


@pytest.mark.parametrize(
    "text",
    [
        ROS_2 + """<group if="$(eval '$(var x) == 1')"/>""",
        ROS_1 + """<group if="$(eval arg('x') == 'y')"/><node pkg="a" type="b" name="c"/>""",
    ],
)
def test_what_this_ros_has(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU010", "a.launch", text) == []


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('<rosparam command="loads" file="$(arg f)"/>', naming("<rosparam>", "loads")),
        ('<node pkg="a" type="b" name="$(anon c)" output="scren"/>', naming("<node>", "scren")),
        ('<node pkg="a" type="b" name="$(anon c)" respawn="flase"/>', naming("<node>", "flase")),
        ('<group if="$(arg a) == b"/>', naming("<group>", "$(arg a) == b", "boolean")),
        (ROS_1 + '<arg name="a" default="b" value="c"/>', naming("a", "value", "default")),
    ],
)
def test_invalid_values_of_an_attribute(tmp_path: Path, text: str, message: str) -> None:
    (found,) = reported(tmp_path, "LAU010", "a.launch", text)
    assert found.message == message


OF_ROS_2 = '<let name="x" value="$(var x)"/><push_ros_namespace namespace="n"/>'


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('<node pkg="a" name="b" ns="$(arg n)"/>', "<node> has no type"),
        ('<node pkg="a" type="b" ns="$(arg n)"/>', "<node> has no name"),
        ('<include ns="$(arg n)"/>', "<include> has no file"),
        (OF_ROS_2 + '<node pkg="a" name="b"/>', "<node> has no exec"),
        (OF_ROS_2 + "<executable/>", "<executable> has no cmd"),
        (
            OF_ROS_2 + '<node_container pkg="a" exec="b" name="c"/>',
            "<node_container> has no namespace",
        ),
    ],
)
def test_missing_requirement(tmp_path: Path, text: str, message: str) -> None:
    (found,) = reported(tmp_path, "LAU010", "a.launch", text)
    assert (found.message, found.span.line) == (message, 2)


@pytest.mark.parametrize(
    "text",
    [
        '<node pkg="a" type="b" name="c" ns="$(arg n)"/>',
        OF_ROS_2 + '<node pkg="a" exec="b"/>',
        '<node pkg="a"/>',  # of either ROS
    ],
)
def test_complete_or_unclear_element_is_accepted(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU010", "a.launch", text) == []


@pytest.mark.parametrize(
    ("text", "help"),
    [
        (ROS_2 + '<node pkg="a" exec="b" args="$(find a)/c"/>', "write $(find-pkg-share ...)"),
        (ROS_2 + '<node pkg="a" exec="b" if="$(arg x)"/>', "write $(var ...)"),
        (ROS_2 + '<node pkg="a" exec="b" args="$(optenv C d)"/>', "write $(env ...)"),
        (ROS_1 + '<node pkg="a" type="b" name="c" args="$(var x)"/>', "write $(arg ...)"),
    ],
)
def test_substitutions_of_the_other_ros(tmp_path: Path, text: str, help: str) -> None:
    (found,) = reported(tmp_path, "LAU010", "a.launch", text)
    assert (found.span.line, found.help) == (3, help)


@pytest.mark.parametrize(
    ("find", "name", "codes"),
    [
        ("find", "demo.launch.py", ["LAU010"]),
        ("find", "demo.launch.yaml", ["LAU010"]),
        ("find", "demo.launch", ["LAU005"]),
        ("find-pkg-share", "demo.launch.py", ["LAU005"]),
    ],
)
def test_a_launch_file_of_ros_2_in_one_of_ros_1(
    tmp_path: Path, find: str, name: str, codes: list[str]
) -> None:
    """The file is not read, so its arguments do not matter."""
    passed = '<arg name="pipeline" value="chomp"/>'
    text = f'<include file="$({find} arm)/launch/{name}">{passed}</include>'
    empty = {"launch": "<launch/>", "yaml": "launch: []\n", "py": "LaunchDescription([])\n"}
    files = {f"launch/{name}": empty[name.rpartition(".")[2]]}
    found = [
        one.code
        for code in ("LAU005", "LAU010")
        for one in reported(tmp_path / "arm", code, "a.launch", text, files)
    ]
    assert found == codes


@pytest.mark.parametrize(("given", "count"), [('default="true"', 1), ('value="true"', 0)])
def test_an_argument_of_an_include(tmp_path: Path, given: str, count: int) -> None:
    text = (
        '<node pkg="p" exec="e"/>\n<include file="$(find-pkg-share arm)/a.launch.xml">\n'
        f'<arg name="gui" {given}/>\n</include>'
    )
    found = reported(tmp_path, "LAU010", "b.launch.xml", text, {"a.launch.xml": "<launch/>"})
    assert ["<include> has no value" in one.message for one in found] == [True] * count
