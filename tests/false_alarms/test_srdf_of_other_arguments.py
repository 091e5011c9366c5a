"""SRD001: an SRDF made for one value of an argument, held against the robot with its default."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming
from tests.xacros import xacro
from urdfkit import check
from urdfkit.workspace.launch_files import MAX_FILES

ROBOT = xacro(
    """<xacro:arg name="model" default="short"/><link name="base"/><link name="tool"/>
  <joint name="wrist" type="fixed"><parent link="base"/><child link="tool"/></joint>
  <xacro:if value="${'$(arg model)' == 'long'}"><link name="tip"/>
  <joint name="end" type="fixed"><parent link="tool"/><child link="tip"/></joint></xacro:if>"""
)
SRDF = """<robot name="r">
  <group name="hand"><link name="NAME"/></group>
  <disable_collisions link1="tool" link2="NAME" reason="Adjacent"/>
</robot>
"""
PARAM = '<param name="robot_description" command="xacro $(find arm)/r.urdf.xacro model:=MODEL"/>'


@pytest.mark.parametrize(
    ("model", "name", "count"),
    [("long", "tip", 0), ("long", "tipp", 2), ("short", "tip", 1)],
)
def test_a_launch_file_starts_the_robot_with_the_link(
    tmp_path: Path, model: str, name: str, count: int
) -> None:
    files = {"r.urdf.xacro": ROBOT, "r.srdf": SRDF.replace("NAME", name)}
    reported(tmp_path / "arm", "SRD001", "a.launch", PARAM.replace("MODEL", model), files)
    found = check(tmp_path / "arm" / "r.urdf.xacro", select=["SRD001"]).diagnostics
    assert len(found) == count
    for one in found:
        assert [note.message for note in one.related] == [naming("compared")]
        assert one.related[0].span.source.path.endswith("r.urdf.xacro")


def test_the_note_says_with_which_arguments(tmp_path: Path) -> None:
    (tmp_path / "r.urdf.xacro").write_text(ROBOT)
    (tmp_path / "r.srdf").write_text(SRDF.replace("NAME", "hand"))
    given = {"model": "long"}
    found = check(tmp_path / "r.urdf.xacro", select=["SRD001"], arguments=given).diagnostics
    assert {one.related[0].message for one in found} == {"compared with this robot, model:=long"}


PREFIXED = """<xacro:arg name="tf_prefix" default=""/><link name="$(arg tf_prefix)base"/>
  <link name="$(arg tf_prefix)tool"/>
  <joint name="$(arg tf_prefix)wrist" type="fixed">
  <parent link="$(arg tf_prefix)base"/><child link="$(arg tf_prefix)tool"/></joint>"""
PREFIXED_SRDF = """<xacro:arg name="tf_prefix" default=""/><xacro:arg name="name" default=""/>
  <group name="$(arg name)"><link name="$(arg tf_prefix)tool"/></group>
  <end_effector name="e" group="hand" parent_link="$(arg tf_prefix)base"/>"""
SEMANTIC = """\
Node(package="moveit_ros_move_group", executable="move_group", parameters=[{
    "robot_description_semantic": Command([
        "xacro ", FindPackageShare("arm"), "/r.srdf.xacro", WORDS])}])
"""


@pytest.mark.parametrize(
    ("words", "count"),
    [
        ('" name:=hand"', 0),
        ('" name:=hand tf_prefix:=left_"', 0),  # the robot itself is checked without a prefix
        ('" name:=arm"', 1),
        ('" tf_prefix:=left_"', 1),
    ],
)
def test_an_srdf_has_the_arguments_that_a_launch_file_gives_it(
    tmp_path: Path, words: str, count: int
) -> None:
    """fanuc_m16ib: moveit.launch.py names the group, and a prefix for the robot and for this."""
    files = {"r.urdf.xacro": xacro(PREFIXED), "r.srdf.xacro": xacro(PREFIXED_SRDF)}
    text = SEMANTIC.replace("WORDS", words)
    reported(tmp_path / "arm", "SRD001", "a.launch.py", text, files)
    report = check(tmp_path / "arm" / "r.urdf.xacro", select=["SRD001", "SRD017"])
    assert len(report.diagnostics) == count


@pytest.mark.parametrize(("name", "count"), [("hand", 0), ("arm", 1)])
def test_an_argument_that_the_srdf_does_not_declare(tmp_path: Path, name: str, count: int) -> None:
    """AR4: the SRDF has the name of the robot from a launch file, and no <xacro:arg> for it."""
    srdf = PREFIXED_SRDF.replace('<xacro:arg name="name" default=""/>', "")
    files = {"r.urdf.xacro": xacro(PREFIXED), "r.srdf.xacro": xacro(srdf)}
    text = SEMANTIC.replace("WORDS", f'" name:={name}"')
    reported(tmp_path / "arm", "SRD001", "a.launch.py", text, files)
    report = check(tmp_path / "arm" / "r.urdf.xacro", select=["SRD001"])
    assert len(report.diagnostics) == count


@pytest.mark.parametrize(("name", "count"), [("$(arg name)", 0), ("", 1)])
def test_a_name_that_whoever_expands_the_srdf_passes(tmp_path: Path, name: str, count: int) -> None:
    group = f'<xacro:arg name="name" default=""/><group name="{name}"><link name="base"/></group>'
    (tmp_path / "r.urdf.xacro").write_text(xacro(PREFIXED))
    (tmp_path / "r.srdf.xacro").write_text(xacro(group))
    report = check(tmp_path / "r.urdf.xacro", select=["SRD017"])
    assert len(report.diagnostics) == count


@pytest.mark.parametrize(("name", "count"), [("tip", 0), ("tipp", 2)])
def test_the_robot_of_moveit_in_a_large_repository(tmp_path: Path, name: str, count: int) -> None:
    """myCobot: MoveIt's launch file names the parameter by an argument, and is one of hundreds."""
    (tmp_path / ".git").mkdir()
    other = tmp_path / "a_demos" / "launch"
    other.mkdir(parents=True)
    for number in range(MAX_FILES):
        (other / f"{number}.launch").write_text("<launch/>")
    launch = '<arg name="robot_description" default="robot_description"/>'
    launch += '<param name="$(arg robot_description)" textfile="$(find arm)/long.urdf"/>'
    base = '<robot name="r"><link name="base"/><link name="tool"/>{}</robot>'
    files = {
        "r.urdf": base.format(""),
        "long.urdf": base.format('<link name="tip"/>'),
        "r.srdf": SRDF.replace("NAME", name),
    }
    reported(tmp_path / "arm", "SRD001", "a.launch", launch, files)
    found = check(tmp_path / "arm" / "r.urdf", select=["SRD001"]).diagnostics
    assert len(found) == count


GRIPPER = xacro(
    """<xacro:arg name="gripper" default=""/><link name="base"/>
  <xacro:property name="gripper" value="$(arg gripper)"/>
  <xacro:if value="${gripper != \'\'}"><xacro:include filename="PATH"/></xacro:if>"""
)
FINGER = """<robot><link name="finger"/><joint name="grip" type="fixed">
<parent link="base"/><child link="finger"/></joint></robot>
"""
BUILDER = """\
from launch import LaunchDescription
from moveit_configs_utils import MoveItConfigsBuilder

def generate_launch_description():
    config = MoveItConfigsBuilder("r", package_name="arm").METHODto_moveit_configs()
    return LaunchDescription([Node(package="moveit_ros_move_group", executable="move_group",
        parameters=[config.to_dict()])])
"""


@pytest.mark.parametrize("path", ["finger.xacro", "$(find fingers)/finger.xacro"])
@pytest.mark.parametrize(
    ("arguments", "method", "is_reported"),
    [
        ("gripper:=two_fingers", "", False),
        ("", "", True),
        ("gripper:=two_fingers", 'robot_description(mappings={"gripper": ""}).', True),
    ],
)
def test_the_arguments_that_the_setup_assistant_was_given(
    tmp_path: Path, arguments: str, method: str, is_reported: bool, path: str
) -> None:
    """Kinova's Link 6: the builder passes them to the xacro in config, too."""
    setup = "moveit_setup_assistant_config:\r\n  urdf:\r\n    package: robots\r\n"
    setup += f"    relative_path: r.urdf.xacro\r\n    xacro_args: {arguments}\r\n"
    files = {
        ".setup_assistant": setup,
        "config/r.urdf.xacro": GRIPPER.replace("PATH", path),
        "config/finger.xacro": FINGER,
        "config/r.srdf": SRDF.replace("NAME", "finger").replace("tool", "base"),
    }
    text = BUILDER.replace("METHOD", method)
    reported(tmp_path / "arm", "SRD001", "a.launch.py", text, files)
    found = check(tmp_path / "arm", select=["SRD001"]).diagnostics
    assert bool(found) is is_reported


@pytest.mark.parametrize(
    ("arguments", "name", "count"),
    [("model:=long", "tip", 0), ("model:=long", "tipp", 2), ("", "tip", 1)],
)
def test_the_robot_of_the_setup_assistant(
    tmp_path: Path, arguments: str, name: str, count: int
) -> None:
    """OpenArm: the MoveIt package is in another repository, and has no xacro of its own."""
    known = '<passive_joint name="wrist"/><end_effector name="e" group="hand" parent_link="base"/>'
    setup = "config:\n  urdf:\n    package: robots\n    relative_path: r.urdf.xacro\n"
    files = {
        ".setup_assistant": f"{setup}    xacro_args: {arguments}\n",
        "config/r.srdf": SRDF.replace("NAME", name).replace("</robot>", known + "</robot>"),
    }
    (tmp_path / ".git").mkdir()
    robots = tmp_path / "robots"
    robots.mkdir()
    (robots / "package.xml").write_text("<package><name>robots</name></package>")
    (robots / "r.urdf.xacro").write_text(ROBOT)
    stack = tmp_path / "stack" / "arm_moveit_config"
    text = BUILDER.replace("METHOD", "")
    reported(stack, "SRD001", "a.launch.py", text, files)
    assert len(check(robots, select=["SRD001"]).diagnostics) == count


NAMED = """\
Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[{
    "robot_description": Command(["xacro ", FindPackageShare("arm"), "/r.urdf.xacro name:=r2"])}])
Node(package="moveit_ros_move_group", executable="move_group", parameters=[{
    "robot_description_semantic": Command([
        "xacro ", FindPackageShare("arm"), "/r.srdf.xacro WORDS"])}])
"""


@pytest.mark.parametrize(("words", "count"), [("name:=r", 0), ("name:=q", 1)])
def test_the_name_of_the_srdf_is_not_that_of_the_variant(
    tmp_path: Path, words: str, count: int
) -> None:
    """Elite Robots: the driver calls the robot by its model, MoveIt's launch file always `cs`."""
    urdf = '<xacro:arg name="name" default="r"/><link name="base"/>'
    srdf = '<xacro:arg name="name" default="r"/><group name="$(arg name)_arm"><link name="base"/>'
    named = 'name="r"', 'name="$(arg name)"'
    files = {
        "r.urdf.xacro": xacro(urdf).replace(*named, 1),
        "r.srdf.xacro": xacro(srdf + "</group>").replace(*named, 1),
        "ompl_planning.yaml": "r_arm:\n  planner_configs: []\n",
    }
    text = NAMED.replace("WORDS", words)
    reported(tmp_path / "arm", "SRD001", "a.launch.py", text, files)
    path = tmp_path / "arm" / "r.urdf.xacro"
    report = check(path, select=["SRD026", "SRD011"], arguments={"name": "r2"})
    assert report.crashed == ()
    assert len(report.diagnostics) == count


@pytest.mark.parametrize(("name", "count"), [("tip", 0), ("tipp", 2)])
def test_the_urdf_is_an_older_output_of_the_xacro(tmp_path: Path, name: str, count: int) -> None:
    """Keio's catch robot: MoveIt reads the xacro, whose arguments its launch file computes."""
    (tmp_path / "r.urdf").write_text(
        '<robot name="r"><link name="base"/><link name="tool"/></robot>'
    )
    (tmp_path / "r.urdf.xacro").write_text(
        xacro('<xacro:arg name="offset"/><link name="base"/><link name="tool"/><link name="tip"/>')
    )
    (tmp_path / "r.srdf").write_text(SRDF.replace("NAME", name))
    report = check(tmp_path / "r.urdf", select=["SRD001"])
    assert report.crashed == ()
    assert len(report.diagnostics) == count


@pytest.mark.parametrize(("name", "count"), [("r_with_tip", 0), ("other", 2)])
def test_the_srdf_has_the_name_of_another_robot(tmp_path: Path, name: str, count: int) -> None:
    """A UR3 of students: the SRDF is for the arm with a gripper, and the arm alone is beside it."""
    base = '<robot name="{}"><link name="base"/><link name="tool"/>{}</robot>'
    (tmp_path / "r.urdf").write_text(base.format("r", ""))
    (tmp_path / "r_with_tip.urdf").write_text(base.format(name, '<link name="tip"/>'))
    arm = '<group name="arm"><link name="base"/><link name="tool"/></group></robot>'
    srdf = SRDF.replace('"r"', '"r_with_tip"').replace("NAME", "tip").replace("</robot>", arm)
    (tmp_path / "config.srdf").write_text(srdf)
    report = check(tmp_path / "r.urdf", select=["SRD001"])
    assert report.crashed == ()
    assert len(report.diagnostics) == count


@pytest.mark.parametrize(("name", "count"), [("r", 0), ("other", 1)])
def test_a_robot_next_to_it_has_the_name_of_the_srdf(tmp_path: Path, name: str, count: int) -> None:
    """An Aubo on a base: the SRDF is for the xacro, next to which is a URDF for each arm."""
    robot = '<robot name="r5"><link name="base"/><link name="tool"/></robot>'
    (tmp_path / "r5.urdf").write_text(robot)
    (tmp_path / "r.urdf").write_text(robot.replace("r5", name))
    (tmp_path / "config.srdf").write_text(SRDF.replace("NAME", "tool"))
    report = check(tmp_path / "r5.urdf", select=["SRD011"])
    assert report.crashed == ()
    assert len(report.diagnostics) == count


@pytest.mark.parametrize(("package", "count"), [("nowhere", 0), ("arm", 2)])
def test_a_xacro_of_the_name_that_lacks_a_package(tmp_path: Path, package: str, count: int) -> None:
    """RoBorregos: TIAGo with a hand as a URDF, the SRDF and the xacro of that with a gripper."""
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "tip.xacro").write_text(xacro(""))
    (tmp_path / "with_hand.urdf").write_text('<robot name="r"><link name="base"/></robot>')
    include = f'<xacro:include filename="$(find {package})/tip.xacro"/><link name="base"/>'
    (tmp_path / "a.urdf.xacro").write_text(xacro(include))
    (tmp_path / "r.srdf").write_text(SRDF.replace("NAME", "tip").replace("tool", "base"))
    report = check(tmp_path / "with_hand.urdf", select=["SRD001"])
    assert report.crashed == ()
    assert len(report.diagnostics) == count


GRIPPERS = xacro(
    '<xacro:arg name="gripper" default="none"/><xacro:property name="prefix" value="left_"/>'
    '<xacro:macro name="suction"><link name="${prefix}gripper_base"/></xacro:macro>'
    "<link name=\"${prefix}base\"/><xacro:if value=\"${'$(arg gripper)' != 'none'}\">"
    "<xacro:suction/></xacro:if>"
)


@pytest.mark.parametrize(("link", "count"), [("left_gripper_base", 0), ("right_base", 1)])
def test_links_of_a_gripper_that_this_robot_lacks(tmp_path: Path, link: str, count: int) -> None:
    """iRC: the collision matrix is for all grippers, and a gripper has its own macro."""
    (tmp_path / "r.urdf.xacro").write_text(GRIPPERS)
    pair = f'<disable_collisions link1="left_base" link2="{link}" reason="Never"/>'
    (tmp_path / "r.srdf").write_text(f'<robot name="r">{pair}</robot>')
    found = check(tmp_path / "r.urdf.xacro", select=["SRD001"]).diagnostics
    assert len(found) == count


@pytest.mark.parametrize(
    ("call", "help"),
    [
        ("", "call the macro, or generate the SRDF for this robot"),
        (
            '<xacro:if value="false"><xacro:hand/></xacro:if>',
            "write a .srdf.xacro with the same argument, or pass it to the robot",
        ),
        ('<xacro:call macro="hand"/>', None),
    ],
)
def test_a_link_in_a_macro_that_is_not_called(tmp_path: Path, call: str, help: str | None) -> None:
    """An arm of Aubo, reset to the xacro without the gripper."""
    macro = '<link name="tool"/><xacro:macro name="hand"><link name="tip"/></xacro:macro>'
    (tmp_path / "r.urdf.xacro").write_text(xacro(macro + call))
    (tmp_path / "r.srdf").write_text(SRDF.replace("NAME", "tip"))
    found = check(tmp_path / "r.urdf.xacro", select=["SRD001"]).diagnostics
    assert [one.help for one in found] == ([help] if help else [])
