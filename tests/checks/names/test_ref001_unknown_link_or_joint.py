import pytest

from tests.naming import naming
from tests.reported import fixed, messages, places, reported

ROBOT = """\
<link name="base_link"/>
<link name="arm_link"/>
<joint name="j" type="fixed">
  <parent link="{}"/>
  <child link="{}"/>
</joint>"""
from urdfkit.text.diagnostic import Severity


def test_both_ends_are_looked_at() -> None:
    robot = ROBOT.format("wheel", "gripper")
    assert messages("REF001", robot) == [
        naming("j", "wheel"),
        naming("j", "gripper"),
    ]
    assert places("REF001", robot) == [(5, "wheel"), (6, "gripper")]


def test_the_nearest_link_is_offered() -> None:
    robot = ROBOT.format("base_lnk", "arm_link")
    assert messages("REF001", robot) == [naming("j", "base_lnk", "base_link")]
    assert fixed("REF001", robot) == (
        f'<robot name="example">\n{ROBOT.format("base_link", "arm_link")}\n</robot>\n'
    )


def test_of_one_link_and_several_joints_the_link_is_misspelt() -> None:
    robot = (
        '<link name="base_link"/><link name="{}"/><link name="hand"/>'
        '<joint name="a" type="fixed"><parent link="base_link"/><child link="arm_link"/></joint>'
        '<joint name="b" type="fixed"><parent link="arm_link"/><child link="hand"/></joint>'
    )
    after = robot.format("arm_link")
    assert (
        fixed("REF001", robot.format("amr_link")) == f'<robot name="example">\n{after}\n</robot>\n'
    )


@pytest.mark.parametrize(
    ("written", "known"),
    [
        ("base_link", "caster_link"),
        ("wheel_3", "wheel_2"),
        ("left_wheel", "right_wheel"),
        ("fl_leg", "fr_leg"),
    ],
)
def test_a_sibling_is_not_meant(written: str, known: str) -> None:
    robot = f'<link name="{known}"/><joint name="j" type="fixed"><child link="{written}"/></joint>'
    (found,) = reported("REF001", robot)
    assert "did you mean" not in found.message
    assert found.fix is None


def test_the_world_can_be_added() -> None:
    robot = ROBOT.format("world", "arm_link").partition("\n")[2]
    assert fixed("REF001", robot) == (
        '<robot name="example">\n<link name="arm_link"/>\n'
        '<link name="world"/>\n'
        '<joint name="j" type="fixed">\n  <parent link="world"/>\n  <child link="arm_link"/>\n'
        "</joint>\n</robot>\n"
    )


def test_an_expression_is_another_finding() -> None:
    assert messages("REF001", ROBOT.format("${prefix}base_link", "arm_link")) == []
    assert len(messages("XAC003", ROBOT.format("${prefix}base_link", "arm_link"))) == 1


def test_a_computed_name_is_reported_and_not_edited() -> None:
    robot = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="base" value="base_lnk"/>
  <link name="base_link"/>
  <link name="arm"/>
  <joint name="j" type="fixed"><parent link="${base}"/><child link="arm"/></joint>
</robot>
"""
    (found,) = reported("REF001", robot, "robot.xacro")
    assert found.span.text == "${base}"
    assert found.message == naming("j", "base_lnk", "base_link")
    assert found.fix is None


def test_suggestions_have_a_bound() -> None:
    links = "".join(f'<link name="link_{number}_x"/>' for number in range(6000))
    joints = "".join(
        f'<joint name="j{number}" type="fixed"><child link="lnk_{number}_x"/></joint>'
        for number in range(2000)
    )
    found = reported("REF001", f'<robot name="r">{links}{joints}</robot>')
    assert len(found) == 1000
    assert [one for one in found if one.fix] == []


MIMIC = """\
<link name="hand"/>
<link name="finger"/>
<joint name="finger_joint" type="continuous">
  <parent link="hand"/>
  <child link="finger"/>
  <mimic joint="{}"/>
</joint>"""


def test_an_unknown_leader_is_reported() -> None:
    robot = MIMIC.format("thumb")
    assert messages("REF001", robot) == [naming("finger_joint", "thumb")]
    assert places("REF001", robot) == [(7, "thumb")]
    assert reported("REF001", robot)[0].fix is None


def test_a_link_is_no_joint() -> None:
    assert len(reported("REF001", MIMIC.format("hand"))) == 1


def test_the_nearest_joint_is_offered() -> None:
    assert '<mimic joint="finger_joint"/>' in fixed("REF001", MIMIC.format("finger_jiont"))


@pytest.mark.parametrize(("kind", "is_offered"), [("fixed", False), ("continuous", True)])
def test_a_joint_that_cannot_lead_is_not_offered(kind: str, is_offered: bool) -> None:
    robot = MIMIC.format("arm_finger_joint") + '<link name="tip"/>'
    robot += f'<joint name="arm_flange_joint" type="{kind}"><parent link="hand"/>'
    (found,) = messages("REF001", f'{robot}<child link="tip"/></joint>')
    assert ("did you mean 'arm_flange_joint'?" in found) == is_offered


def test_a_joint_that_is_there_is_left_to_other_rules() -> None:
    assert reported("REF001", MIMIC.format("finger_joint")) == []  # itself: JNT015
    assert reported("REF001", MIMIC.replace(' joint="{}"', "")) == []  # URD003


def test_a_gazebo_block_counts_as_well() -> None:
    robot = (
        '<link name="base_link"/><link name="{}"/>'
        '<joint name="a" type="fixed"><parent link="base_link"/><child link="gripper"/></joint>'
        '<gazebo reference="gripper"><mu1>0.2</mu1></gazebo>'
    )
    after = f'<robot name="example">\n{robot.format("gripper")}\n</robot>\n'
    assert fixed("REF001", robot.format("griper")) == after
    assert fixed("GAZ001", robot.format("griper")) == after


@pytest.mark.parametrize(("drives", "right"), [(1, "sholder"), (2, "shoulder")])
def test_what_mimic_joints_agree_on_is_right(drives: int, right: str) -> None:
    robot = '<link name="a"/><joint name="{}" type="fixed"><child link="a"/></joint>'
    robot += "".join(
        f'<joint name="j{n}" type="fixed"><child link="a"/><mimic joint="{{}}"/></joint>'
        for n in range(drives)
    )
    names = [right] * (drives + 1)
    after = f'<robot name="example">\n{robot.format(*names)}\n</robot>\n'
    assert fixed("REF001", robot.format("sholder", *["shoulder"] * drives)) == after


@pytest.mark.parametrize(
    ("adding", "help"),
    [
        (
            '<xacro:if value="$(arg big)"><link name="box"/></xacro:if>',
            "pass the argument that adds the link",
        ),
        (
            '<xacro:macro name="car"><link name="box"/></xacro:macro>',
            "call macro 'car', which defines the link",
        ),
    ],
)
def test_a_link_that_is_in_the_file(adding: str, help: str) -> None:
    """A kit for several vehicles: each has its own base."""
    text = f"""<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="big" default="false"/><link name="imu"/>
{adding}
<joint name="j" type="fixed"><parent link="box"/><child link="imu"/></joint></robot>"""
    (found,) = reported("REF001", text.encode(), "robot.xacro")
    assert (found.severity, found.help) == (Severity.WARNING, help)


def test_the_world_is_not_added_next_to_a_root() -> None:
    """OpenArm's MoveIt package: the robot that it includes has a base of its own by default."""
    (found,) = reported("REF001", ROBOT.format("world", "arm_link"))
    assert found.fix is None
