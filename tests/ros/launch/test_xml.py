"""Launch files in XML: values, conditions, includes, and what each kind of ROS writes."""

from pathlib import Path

import pytest

from tests.conftest import CORPUS, MODELS, needs_corpus
from urdfkit.ros.launch import read_launch
from urdfkit.ros.launch.contents import Launch, StartedProgram, _names_exec
from urdfkit.ros.launch.known_packages import wrong_references
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver


def read(package: Path, text: str, **arguments: str) -> Launch:
    path = package / "launch" / "a.launch"
    path.write_text(f"<launch>\n{text}\n</launch>")
    return read_launch(Source.read(path), Resolver(environment={}), arguments)


ROS_1 = '<param name="{name}" command="{command}"/>'
ROS_2 = (
    """<node pkg="a" exec="b"><param name="robot_description" value="$(command '{}')"/></node>"""
)
ARM = "$(find arm)/urdf/arm.xacro"


def ros_1(command: str, name: str = "robot_description") -> str:
    return ROS_1.format(name=name, command=command)


@pytest.mark.parametrize(
    "text",
    [
        ros_1(f"$(find xacro)/xacro '{ARM}' side:=left"),
        ros_1(f"xacro --inorder {ARM} side:=left"),
        '<arg name="s" default="left"/>'
        + ros_1(f"rosrun xacro xacro {ARM} side:=$(arg s)", "/ns/robot_description"),
        '<let name="s" value="left"/>'
        + ROS_2.format("xacro $(find-pkg-share arm)/urdf/arm.xacro side:=$(var s)"),
        f"<group>{ros_1('xacro $(dirname)/../urdf/arm.xacro side:=left')}</group>",
    ],
)
def test_the_robot_and_its_arguments(package, text):
    (description,) = read(package, text).descriptions
    assert Path(description.path).resolve() == package / "urdf" / "arm.xacro"
    assert description.arguments == {"side": "left"}
    (step,) = description.frame.steps()
    assert (step.kind, step.name, step.span.line) == ("launch", "a.launch", 2)


@pytest.mark.parametrize(
    ("words", "arguments"),
    [
        ("side:=left address:=$(arg address)", {"side": "left"}),
        ("side:=left mesh:=$(find missing)/m.stl", {"side": "left"}),
        ("side:=left $(arg perhaps_the_file)", None),
        ("side:=left $(anon robot).xacro", None),
    ],
)
@pytest.mark.parametrize("form", [ros_1("xacro {}"), ROS_2.replace("{}", "xacro {}")])
def test_arguments_known_only_at_run_time(package, form, words, arguments):
    found = read(package, form.replace("{}", f"{ARM} {words}")).descriptions
    expected = [] if arguments is None else [(arguments, False)]
    assert [(one.arguments, one.is_whole) for one in found] == expected


def test_a_plain_urdf_as_text(package):
    launch = read(
        package, '<param name="robot_description" textfile="$(find arm)/urdf/arm.xacro"/>'
    )
    assert [description.arguments for description in launch.descriptions] == [{}]


def test_passed_arguments_take_precedence(package):
    text = '<arg name="m" default="none"/><rosparam file="$(find arm)/$(arg m).yaml"/>'
    assert [Path(f.path).name for f in read(package, text).files] == ["none.yaml"]
    assert [Path(f.path).name for f in read(package, text, m="a").files] == ["a.yaml"]


@pytest.mark.parametrize(
    ("condition", "count"),
    [
        ('if="false"', 0),
        ('if="0"', 0),
        ('unless="true"', 0),
        ('if="true"', 1),
        ('if="$(arg x)"', 1),
    ],
)
def test_known_conditions_apply(package, condition, count):
    assert len(read(package, f'<rosparam file="a.yaml" {condition}/>').files) == count


def test_includes_are_followed_with_their_arguments(package):
    (package / "launch" / "b.launch").write_text(
        '<launch><arg name="m"/><param name="robot_description" '
        'command="xacro $(find arm)/urdf/$(arg m).xacro"/></launch>'
    )
    launch = read(
        package, '<include file="$(dirname)/b.launch"><arg name="m" value="arm"/></include>'
    )
    (description,) = launch.descriptions
    assert [step.name for step in description.frame.steps()] == ["a.launch", "b.launch"]


def test_circular_includes_end(package):
    launch = read(package, '<include file="$(dirname)/a.launch"/>')
    assert launch.problems == ()
    assert len(launch.files) < 20


def test_files_in_a_missing_package_are_not_reported(package):
    launch = read(package, '<rosparam file="$(find no_such_pkg)/a.yaml"/>')
    assert launch.files == ()
    (missing,) = launch.packages
    assert missing.name == "no_such_pkg"
    assert missing.searched


def test_rviz_configuration(package):
    text = '<node pkg="rviz" type="rviz" name="r" args="-f base -d $(find arm)/rviz/a.rviz"/>'
    launch = read(package, text)
    (file,) = launch.files
    assert (file.exists, file.purpose) == (False, "RViz configuration")
    assert file.span.text.startswith("-f base")
    assert "rviz" in [use.name for use in launch.packages]


@pytest.mark.parametrize(
    ("text", "words"),
    [("<launch><node></launch>", "not a launch file"), ("<robot/>", "root"), ("", "empty")],
)
def test_other_files_are_reported(tmp_path, text, words):
    launch = read_launch(Source("a.launch", text.encode()), Resolver(environment={}))
    (problem,) = launch.problems
    assert problem.code == "LAU001"
    assert words in problem.message


def test_substitutions_known_only_at_run_time_are_unknown(package):
    unknown = "$(eval env(1))", "$(env HOME)/a", "$(arg x"
    text = "".join(f'<rosparam file="{file}"/>' for file in unknown)
    assert [file.span.text for file in read(package, text).files] == ["$(arg x"]


def test_the_mission_launch_file():
    path = MODELS / "gazebo_pkg" / "launch" / "view_waking_robot.launch"
    launch = read_launch(Source.read(path), Resolver(environment={}))
    assert [Path(d.path).name for d in launch.descriptions] == ["waking_robot_new.xacro"]
    assert [(Path(f.path).name, f.exists) for f in launch.files] == [
        ("waking_robot_new.xacro", True),
        ("test.rviz", False),
    ]


@needs_corpus
def test_the_launch_files_of_the_corpus():
    described = {}
    for path in sorted(CORPUS.rglob("*.launch")):
        launch = read_launch(Source.read(path), Resolver(environment={}))
        assert [p for p in launch.problems if p.code == "LAU001"] == [], path
        described[path.name] = {Path(d.path).name for d in launch.descriptions}
    assert described["spawn_husky.launch"] == {"husky.urdf.xacro"}
    assert described["rrbot_world.launch"] == {"rrbot.xacro"}
    assert sum(1 for names in described.values() if names) >= 14


def test_files_that_include_themselves_many_times_end(package):
    again = '<include file="$(dirname)/a.launch"/>' * 20
    assert read(package, again).unread


def test_started_programs(package):
    text = """<arg name="more" default="b"/><node pkg="p" type="e" name="n"
      args="a $(arg more) $(env X)/c"/><executable cmd="ros2 run"/>"""
    node, program = read(package, text).started
    assert (node.package, node.executable) == ("p", "e")
    assert [word.text for word in node.words] == ["a", "b", None]
    assert [word.text for word in program.words] == ["ros2", "run"]


def test_composable_nodes(package):
    text = """<node_container pkg="rclcpp_components" exec="component_container" name="c"
      namespace=""><composable_node pkg="nav2_amcl" plugin="nav2_amcl::AmclNode" namespace="r">
      <remap from="scan" to="front"/></composable_node></node_container>
      <load_composable_node target="c" if="$(var x)">
      <composable_node pkg="p" plugin="p::Own"/></load_composable_node>"""
    node, own = read(package, text).started
    assert (node.package, node.executable, node.namespace) == ("nav2_amcl", "amcl", "r")
    assert (node.remappings, node.is_sure) == ({"scan": "front"}, True)
    assert (own.package, own.executable, own.is_sure) == ("p", "", False)


@pytest.mark.parametrize(
    "text",
    [
        "<group>" * 5000 + "</group>" * 5000,
        '<node name="n" pkg="p" type="t" args="' + "$(arg " * 3000 + ")" * 3000 + '"/>',
        "<words/><tell_undeclared/><path a='b'/><level/>",
        '<arg name="a" default="$(arg a)"/><param name="$(arg a)" value="b"/>',
        "<nod/>" * 3000,
    ],
    ids=["deep", "nested", "names", "ring", "many"],
)
def test_hostile_files_are_read(package, text):
    assert len(read(package, text).problems) <= 1001


def test_an_included_yaml_file_is_not_parsed_as_xml(package):
    for name in ("b.launch.yml", "b.launch.yaml"):
        (package / "launch" / name).write_text("launch:\n- node: {pkg: a, exec: b}\n")
        launch = read(package, f'<include file="$(dirname)/{name}"/>')
        assert launch.problems == ()
        assert launch.unread == ()
        assert [program.key for program in launch.programs] == ["a/b"]


def test_included_yaml_files_get_arguments(package):
    """In an XML file and in one of YAML; a condition of the include is one of its programs."""
    (package / "launch" / "b.launch.yaml").write_text(
        """launch:
- arg: {name: who, default: nobody}
- node: {pkg: a, exec: b, args: $(var who)}
"""
    )
    (package / "launch" / "c.launch.yaml").write_text(
        """launch:
- include:
    file: $(dirname)/b.launch.yaml
    arg:
    - {name: who, value: robot}
"""
    )
    include = '<arg name="x"/><include file="$(dirname)/{}" {}/>'
    for name, condition, who in (
        ("b.launch.yaml", "", "nobody"),
        ("c.launch.yaml", "", "robot"),
        ("b.launch.yaml", 'if="$(var x)"', "nobody"),
    ):
        (program,) = read(package, include.format(name, condition)).programs
        assert (program.words[0].text, program.is_sure) == (who, not condition)


def test_thousands_of_programs_do_not_search_their_file_again() -> None:
    source = Source("a.launch", b'<node pkg="a" type="b"/>')
    program = StartedProgram("a", "b", (), Span(source, 0, 0), None)
    _names_exec.cache_clear()
    assert list(wrong_references([program] * 3, (), Resolver())) == []
    assert _names_exec.cache_info().misses == 1


@pytest.mark.parametrize(
    ("text", "is_ros_2"),
    [
        ('<node pkg="a" exec="b"/>', True),
        ("launch:\n- node: {pkg: a, exec: b}", True),
        ('<executable cmd="a"/>', True),
        ('<node pkg="a" type="b"/>', False),
        ('<!-- It is executed continuously; exec="b" -->\n<node pkg="a" type="b"/>', False),
        ("<!--" * 200_000, False),
    ],
)
def test_the_ros_version_of_a_program(text: str, is_ros_2: bool) -> None:
    program = StartedProgram("a", "b", (), Span(Source("a.launch", text.encode()), 0, 0), None)
    assert program.is_ros_2 is is_ros_2


OFF = """<arg name="x" default="false"/>
<group if="$(arg x)"><include file="$(dirname)/gone.launch"/></group>
<include file="$(dirname)/b.launch" if="$(arg x)"/>
<node pkg="a" type="b" name="b" if="$(arg x)"><rosparam file="$(dirname)/gone.yaml"/></node>"""


def test_what_is_switched_off_is_read_but_not_sure(package: Path) -> None:
    """Other values of its arguments start it; what it includes may have others, too."""
    (package / "launch" / "b.launch").write_text('<launch><node pkg="c" type="d"/></launch>')
    launch = read(package, OFF)
    found = [(Path(use.path).name, use.exists) for use in launch.files]
    assert found == [("gone.launch", False), ("b.launch", True), ("gone.yaml", False)]
    assert [(node.key, node.is_sure) for node in launch.programs] == [("a/b", False)]


def test_what_an_including_file_switches_off_is_not_read(package: Path) -> None:
    (package / "launch" / "c.launch").write_text(f"<launch>{OFF}</launch>")
    launch = read(package, '<include file="$(dirname)/c.launch"/>')
    assert [Path(use.path).name for use in launch.files] == ["c.launch"]
    assert not launch.programs
