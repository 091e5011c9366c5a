from pathlib import Path

import pytest

from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit import check
from urdfkit.text.diagnostic import Severity

JOINT = """\
<link name="a"/>
<link name="b"/>
<joint name="j" type="continuous">
  <parent link="a"/>
  <child link="b"/>
  {}
</joint>"""


def test_an_unknown_element_is_named_with_its_owner() -> None:
    robot = JOINT.format("<anchor/>")
    assert messages("URD001", robot) == [naming("j", "unknown", "<anchor>", "<joint>", "ignored")]
    assert places("URD001", robot) == [(7, "<anchor/>")]
    without = robot.replace("  <anchor/>\n", "")
    assert fixed("URD001", robot) == f'<robot name="example">\n{without}\n</robot>\n'


@pytest.mark.parametrize(
    ("written", "suggested"),
    [
        ('<orign xyz="0 0 1"/>', '<origin xyz="0 0 1"/>'),
        ("<Axis xyz='0 0 1'></Axis>", "<axis xyz='0 0 1'></axis>"),
        ('<dynamic damping="1" >\n </dynamic >', '<dynamics damping="1" >\n </dynamics >'),
    ],
)
def test_a_typo_is_corrected_at_both_ends(written: str, suggested: str) -> None:
    assert fixed("URD001", JOINT.format(written)) == (
        f'<robot name="example">\n{JOINT.format(suggested)}\n</robot>\n'
    )


@pytest.mark.parametrize("inside", ["<text/>", "12", "<!-- 12 -->"])
def test_only_what_holds_nothing_is_removed(inside: str) -> None:
    (found,) = reported("URD001", JOINT.format(f"<anchor>{inside}</anchor>"))
    assert (found.fix is None) == (inside != "<!-- 12 -->")


def test_what_somebody_wrote_is_not_removed() -> None:
    """dVRK: <joint_properties> was the <dynamics> of early versions."""
    (found,) = reported("URD001", JOINT.format('<joint_properties damping="1" friction="0"/>'))
    assert found.fix is None
    assert "<dynamics>" in found.help
    both = '<joint_properties friction="1"/><dynamics friction="1"/>'
    (found,) = reported("URD001", JOINT.format(both))
    assert "<dynamics>" not in found.help


def test_what_is_there_already_is_not_meant_again() -> None:
    robot = JOINT.format('<origin xyz="0 0 1"/><orign xyz="0 0 1"/>')
    assert messages("URD001", robot) == [naming("j", "unknown", "<orign>", "<joint>", "ignored")]


@pytest.mark.parametrize(
    "known",
    [
        '<drake:damping xmlns:drake="http://drake.mit.edu" d="1"/>',
        '<calibration rising="0"/>',
        '<safety_controller k_velocity="1"/>',
    ],
)
def test_extensions_with_a_prefix_and_rare_elements_are_known(known: str) -> None:
    assert reported("URD001", JOINT.format(known)) == []


@pytest.mark.parametrize(
    "robot",
    [
        '<link name="a"><contact><lateral_friction value="1"/></contact></link>',  # PyBullet
        '<robot name="r"><mujoco><compiler/></mujoco><link name="a"/></robot>',
        '<robot name="r"><link name="a"/><frame name="f" link="a"/></robot>',  # Drake
        '<robot name="r"><link name="a"/><gazebo><what/></gazebo></robot>',
        '<robot name="r"><link name="a"/><transmission><what/></transmission></robot>',
    ],
)
def test_dialects_of_other_readers_are_known(robot: str) -> None:
    assert reported("URD001", robot) == []


def test_a_macro_body_is_one_finding_with_its_calls_and_can_be_fixed() -> None:
    robot = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params="name">
    <link name="${name}"><visua><geometry><box size="1 1 1"/></geometry></visua></link>
  </xacro:macro>
  <xacro:part name="a"/>
  <xacro:part name="b"/>
</robot>
"""
    (found,) = reported("URD001", robot, "robot.xacro")
    assert [call.message.partition(":")[0] for call in found.calls] == ["link 'a'", "link 'b'"]
    assert fixed("URD001", robot, "robot.xacro") == robot.replace("visua>", "visual>")


def test_a_macro_without_its_prefix_is_another_finding() -> None:
    robot = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params=""><link name="part"/></xacro:macro>
  <link name="base"/>
  <part/>
</robot>
"""
    assert reported("URD001", robot, "robot.xacro") == []
    assert len(reported("XAC002", robot, "robot.xacro")) == 1


@pytest.mark.parametrize(
    ("robot", "message"),
    [
        (
            '<link name="a"><origin xyz="0 0 1"/></link>',
            naming(
                "a",
                "<origin>",
                "inside",
                "<link>",
                "<collision>",
                "<inertial>",
                "<joint>",
                "<visual>",
            ),
        ),
        (
            '<link name="a"><mass value="1"/></link>',
            naming("a", "<mass>", "inside", "<link>", "<inertial>"),
        ),
        (
            '<link name="a"/><inertial/>',
            naming("<inertial>", "inside", "<robot>", "<link>"),
        ),
        (
            '<link name="a"><gazebo><plugin/></gazebo></link>',
            naming("a", "<gazebo>", "inside", "<link>", "<robot>"),
        ),
    ],
)
def test_where_it_belongs_is_reported(robot: str, message: str) -> None:
    assert messages("URD001", robot) == [message]


INLINE = '<link name="a"><visual><geometry><box size="1 1 1"/>{}</geometry>{}</visual></link>'
MATERIAL = '<material name="m"><color rgba="1 0 0 1"/></material>'


def test_a_material_moves_behind_the_geometry() -> None:
    assert fixed("URD001", INLINE.format(MATERIAL, "")) == (
        f'<robot name="example">\n{INLINE.format("", MATERIAL)}\n</robot>\n'
    )


def test_lines_and_their_ends_move_along() -> None:
    robot = (
        '<robot name="r">\r\n\t<link name="a">\r\n\t\t<visual>\r\n\t\t\t<geometry>\r\n'
        '\t\t\t\t<box size="1 1 1"/>\r\n{}\t\t\t</geometry>\r\n{}\t\t</visual>\r\n'
        "\t</link>\r\n</robot>\r\n"
    )
    lines = ('<material name="m">', '\t<texture filename="a.png"/>', "</material>")
    inside = "".join(f"\t\t\t\t{line}\r\n" for line in lines)
    outside = inside.replace("\t\t\t\t", "\t\t\t")
    assert fixed("URD001", robot.format(inside, "")) == robot.format("", outside)


@pytest.mark.parametrize(
    "robot",
    [
        INLINE.format(MATERIAL, '<material name="other"/>'),
        INLINE.format(MATERIAL * 2, ""),
        INLINE.format(MATERIAL, "").replace("visual>", "collision>"),
        INLINE.format('<origin xyz="1 0 0"/>', ""),  # before the visual's own, or instead of it
        f'<link name="a">{MATERIAL}</link>',  # of which visual
    ],
)
def test_what_is_not_sure_is_left_to_a_person(robot: str) -> None:
    found = reported("URD001", robot)
    assert found
    assert [one.fix for one in found] == [None] * len(found)


def test_elements_of_one_tag_in_the_same_wrong_place_are_one_finding() -> None:
    body = f"<collision><geometry><sphere radius='1'/></geometry>{MATERIAL}</collision>"
    robot = "".join(f'<link name="{name}">{body}</link>' for name in "abcdefg")
    (found,) = reported("URD001", robot)
    assert found.message == naming(
        "a", "<material>", "inside", "<collision>", "<robot>", "<visual>", "6"
    )
    assert [related.message for related in found.related] == [f"link '{name}'" for name in "bcdef"]


@pytest.mark.parametrize(
    ("robot", "wrong", "right"),
    [
        ('<link name="a"><Inertial/></link>', "Inertial", "inertial"),
        ('<link name="a"><visual><geometri></geometri></visual></link>', "geometri", "geometry"),
        (
            (
                '<link name="a"><visual><geometry><cylindr radius="1" length="1"/></geometry>'
                "</visual></link>"
            ),
            "cylindr",
            "cylinder",
        ),
        (
            (
                '<link name="a"><inertial><mas value="1"/>'
                '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
            ),
            "mas ",
            "mass ",
        ),
        (
            (
                '<link name="a"/><link name="b"/><joint name="j" type="fixed">'
                '<parent link="a"/><chlid link="b"/></joint>'
            ),
            "chlid",
            "child",
        ),
    ],
)
def test_needed_elements_get_their_name_back(robot: str, wrong: str, right: str) -> None:
    (found,) = reported("URD001", robot)
    assert found.severity is Severity.ERROR
    assert fixed("URD001", robot) == (
        f'<robot name="example">\n{robot.replace(wrong, right)}\n</robot>\n'
    )
    assert reported("URD004", robot) == [], "what is misspelt is not missing as well"


def test_who_and_what() -> None:
    assert messages("URD001", '<link name="a"><inertal/></link>') == [
        naming("a", "unknown", "<inertal>", "<inertial>", "missing")
    ]


@pytest.mark.parametrize(
    "robot",
    [
        # The needed one is there: an unknown element like any other.
        (
            '<link name="a"><inertial><mass value="1"/>'
            '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial><inertal/></link>'
        ),
        '<link name="a"><initial_pose/></link>',
    ],
)
def test_no_error_where_nothing_is_missing(robot: str) -> None:
    (found,) = reported("URD001", robot)
    assert found.severity is Severity.WARNING


@pytest.mark.parametrize(
    ("robot", "message"),
    [
        ('<compiler meshdir="m"/>', "<compiler> inside <robot>; it belongs in <mujoco>"),
        (
            '<link name="a"><mujoco><compiler/></mujoco></link>',
            "<mujoco> inside <link>; it belongs in <robot>",
        ),
        ("<loop_join/>", "<loop_join> in <robot> (ignored); did you mean <loop_joint>?"),
        (  # of SDF
            '<link name="a"><collision><geometry/><contact><ode/></contact></collision></link>',
            "<contact> in <collision> (ignored)",
        ),
        (  # of another program than <collision_checking>
            '<link name="a"><self_collision_checking/></link>',
            "<self_collision_checking> in <link> (ignored)",
        ),
    ],
)
def test_what_one_program_reads_elsewhere(robot: str, message: str) -> None:
    found = messages("URD001", f'<robot name="r">{robot}</robot>')
    assert [one[-len(message) :] for one in found] == [message]


PROPERTIES = (
    '<link name="a"><collision><geometry><sphere radius="1"/></geometry>'
    '<drake:proximity_properties xmlns:drake="http://drake.mit.edu">{}'
    "</drake:proximity_properties></collision></link>"
)


@pytest.mark.parametrize(
    ("written", "intended"),
    [
        ('<drake:mu_static value="1"/>', ""),
        ('<drake:mu_statc value="1"/>', "mu_static"),
        ("<drake:soft_hydroelastic/>", "compliant_hydroelastic"),
        ("<drake:of_my_own/>", ""),
        ("<other:mu_statc/>", ""),
    ],
)
def test_elements_of_drake(written: str, intended: str) -> None:
    written = written.replace("<other:mu_statc", '<other:mu_statc xmlns:other="o"')
    found = messages("URD001", PROPERTIES.format(written))
    assert [one.endswith(f"mean <drake:{intended}>?") for one in found] == [True] * bool(intended)


@pytest.mark.parametrize(
    ("root", "count"),
    [("robot", 2), ("link", 1), ("!-- <robot> --><joint", 1)],
)
def test_the_root_of_an_included_file(tmp_path: Path, root: str, count: int) -> None:
    end = root.rpartition("<")[2]
    part = f'<{root} name="arm"><visual/><inertial/></{end}>'
    (tmp_path / "arm.xacro").write_text(part)
    robot = tmp_path / "robot.urdf.xacro"
    robot.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:include filename="arm.xacro"/><link name="base"/></robot>'
    )
    found = check(robot, select=["URD001"]).diagnostics
    assert len(found) == count
    assert ("wrap the" in found[0].help) is (root != "robot")


@pytest.mark.parametrize(("count", "severity"), [(3, Severity.WARNING), (4, Severity.INFO)])
def test_an_element_of_all_joints_is_for_another_program(count: int, severity: Severity) -> None:
    """AUBO's arms: every joint has the constants of its motor."""
    joints = "".join(
        f'<link name="l{n}"/><joint name="j{n}" type="fixed"><parent link="base"/>'
        f'<child link="l{n}"/><motor_constants k="1"/></joint>'
        for n in range(count)
    )
    found = reported("URD001", f'<link name="base"/>{joints}')
    assert {one.severity for one in found} == {severity}


@pytest.mark.parametrize(
    ("count", "other", "severity"),
    [
        (4, '<dh_type type="1"/>', Severity.INFO),
        (3, '<dh_type type="1"/>', Severity.WARNING),
        (4, "", Severity.WARNING),
    ],
)
def test_an_element_of_all_robots_is_for_another_program(
    tmp_path: Path, count: int, other: str, severity: Severity
) -> None:
    """AUBO's arms: each has the kind of its kinematics."""
    robot = '<robot name="r"><link name="base"/>{}</robot>'
    for number in range(count):
        text = robot.format(other if number else '<dh_type type="1"/>')
        (tmp_path / f"arm{number}.urdf").write_text(text)
    (found,) = check(tmp_path / "arm0.urdf", select=["URD001"]).diagnostics
    assert found.severity is severity
