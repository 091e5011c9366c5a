from pathlib import Path

import pytest

from tests.output.formats.made import diagnostic, report, span
from tests.reported import fixed, reported
from urdfkit import Diagnostic, Source, check
from urdfkit.lint.grouping import MAX_NOTES, MAX_SINGLE, grouped
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.output import formats
from urdfkit.text.diagnostic import NOT_CREATED


def shown(code: str, robot: str) -> tuple[Diagnostic, ...]:
    return grouped(reported(code, robot))


def links(number: int, tag: str = "<tint/>") -> str:
    return "".join(f'<link name="l{i}">\n  {tag}\n</link>\n' for i in range(number))


def test_a_few_that_are_alike_are_reported_one_by_one() -> None:
    assert len(shown("URD001", links(MAX_SINGLE))) == MAX_SINGLE


def test_many_that_are_alike_are_reported_as_the_first() -> None:
    (finding,) = shown("URD001", links(MAX_SINGLE + 1))
    assert (
        finding.message
        == "link 'l0': unknown element <tint> in <link> (ignored) (and 2 more like this)"
    )
    assert (finding.span.line, finding.span.text) == (3, "<tint/>")
    assert [(note.span.line, note.message) for note in finding.related] == [
        (3 + 3 * i, f"link 'l{i}': unknown element <tint> in <link> (ignored)") for i in range(1, 3)
    ]


def test_messages_that_differ_in_names_and_numbers_are_alike() -> None:
    """Also those of a rule that says nothing about it."""
    alike = [
        "joint 'a' moves by 3 mm",
        "joint 'b' moves by -2.5e-3 mm",
        "joint 'c d' moves by 4 mm",
    ]
    other = "joint 'e' moves by 5 m"
    found = reported("URD001", links(4))
    told = [
        one._replace(message=text, group_key="")
        for one, text in zip(found, (*alike, other), strict=True)
    ]
    first, second = grouped(told, brief=True)
    assert first.message == f"{alike[0]} (and 2 more like this)"
    assert [note.message for note in first.related] == ["joint 'b'", "joint 'c d'"]
    assert second.message == other


def test_what_is_fixed_in_another_way_is_not_alike() -> None:
    found = reported("URD001", links(4))
    told = [one._replace(message="alike", fix=None, group_key="") for one in found[:3]]
    last = found[3]._replace(message="alike", group_key="")
    assert len(grouped([*told, last])) == 2


def test_a_missing_file_of_visual_and_collision_is_one_finding() -> None:
    mesh = '<geometry><mesh filename="package://arm/meshes/arm.stl"/></geometry>'
    bodies = f"<visual>{mesh}</visual>\n<collision>{mesh}</collision>"
    (finding,) = shown("MSH001", f'<link name="arm">\n{bodies}</link>')
    assert finding.span.line == 3
    assert [note.span.line for note in finding.related] == [4]
    others = bodies.replace("arm.stl", "hull.stl", 1)
    assert len(shown("MSH001", f'<link name="arm">\n{others}</link>')) == 2


def test_the_fixes_of_all_are_one_fix() -> None:
    (finding,) = shown("URD001", links(9))
    assert finding.fix is not None
    assert finding.fix.title == "remove the <tint> (and 8 more like this)"
    assert fixed("URD001", links(9)).count("tint") == 0


def test_without_a_fix_for_each_there_is_none() -> None:
    (finding,) = shown("URD001", links(8) + '<link name="last"><tint>dark</tint></link>')
    assert finding.fix is None


def test_fixes_of_which_one_is_unsafe_are_an_unsafe_fix() -> None:
    def is_safe(*safe: bool) -> bool:
        alike = zip(reported("URD001", links(len(safe))), safe, strict=True)
        (finding,) = grouped([d._replace(fix=d.fix and d.fix._replace(safe=s)) for d, s in alike])
        assert finding.fix is not None
        return finding.fix.safe

    assert is_safe(True, True, True)
    assert not is_safe(True, True, False)


def test_tags_of_one_link_are_moved_once() -> None:
    pairs = "".join(
        f'<link name="l{i}">\n  <mu1>1</mu1>\n  <mu1>1</mu1>\n</link>' for i in range(5)
    )
    (finding,) = shown("URD008", pairs)
    assert finding.fix is not None
    assert fixed("URD008", pairs).count("<mu1>") == 10


def test_the_places_that_are_reported_are_bounded() -> None:
    (finding,) = shown("URD001", links(60))
    assert "and 59 more like this" in finding.message
    assert len(finding.related) == MAX_NOTES


@pytest.mark.parametrize("other", ["<hue/>", "<glow/>"])
def test_other_typos_are_reported_beside_them(other: str) -> None:
    found = shown("URD001", links(5) + links(5, other).replace('"l', '"k'))
    assert [one.message.split(":")[0] for one in found] == ["link 'l0'", "link 'k0'"]


def test_what_a_comment_accepts_is_not_among_them() -> None:
    robot = links(6).replace(
        '<link name="l1">', '<!-- urdfkit: ignore[URD001] our own reader --><link name="l1">'
    )
    (finding,) = shown("URD001", robot)
    assert "more like this" in finding.message
    assert [note.message.split("'")[1] for note in finding.related] == ["l2", "l3", "l4", "l5"]


def test_a_help_of_its_own_stands_in_the_note() -> None:
    mistakes = (
        "robotBaseFrme odometryFrme commandTopc odometryTopc publishOdmTF odometryRte".split()
    )
    tags = "".join(f"<{tag}>x</{tag}>" for tag in mistakes)
    plugin = f'<plugin name="p" filename="libgazebo_ros_planar_move.so">{tags}</plugin>'
    found = shown("GAZ016", f'<link name="a"/><gazebo>{plugin}</gazebo>')
    (finding,) = [one for one in found if one.fix]
    assert finding.help == "did you mean <robotBaseFrame>?"
    assert finding.related[0].message.endswith(
        "unknown element <odometryFrme> (ignored): did you mean <odometryFrame>?"
    )


def test_people_are_shown_one_and_programs_get_each() -> None:
    robot = whole_robot(links(9)).encode()
    report = check(Source("robot.urdf", robot), select=["URD001"])
    assert len(report.diagnostics) == 9
    assert formats.get("json")(report).count('"code": "URD001"') == 9
    assert formats.get("text")(report).count(": warning URD001") == 1
    assert formats.get("markdown")(report).count("**URD001**") == 1
    for rendered in (formats.get(name)(report) for name in ("text", "markdown")):
        assert "9 warnings in 1 file" in rendered


def test_what_is_alike_in_two_files_is_shown_for_each() -> None:
    robot = whole_robot(links(5)).encode()
    report = check(Source("a.urdf", robot), Source("b.urdf", robot), select=["URD001"])
    assert [one.span.source.path for one in grouped(report.diagnostics)] == ["a.urdf", "b.urdf"]


MASS = (
    '<inertial><mass value="1"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
)
#: Something on each of three links that are fixed to a base.
ON_LINKS = {
    "GAZ007": "<material>Gazebo/Silver</material>",
    "GAZ003": '<sensor name="s{0}" type="imu"><imu><topic_name>t</topic_name></imu></sensor>',
    "GAZ067": "<turnGravityOff>true</turnGravityOff>",
}


@pytest.mark.parametrize(("code", "what"), ON_LINKS.items(), ids=list(ON_LINKS))
def test_what_an_exporter_writes_on_every_link_is_one_finding(code: str, what: str) -> None:
    """Such as the 33 switches for collisions in a robot from Fusion."""
    robot = f'<link name="base">{MASS}</link>'
    for number in range(3):
        robot += (
            f'<link name="l{number}">{MASS}</link><joint name="j{number}" type="fixed">'
            f'<parent link="base"/><child link="l{number}"/></joint>'
            f'<gazebo reference="l{number}">{what.format(number)}</gazebo>'
        )
    assert len(reported(code, robot)) == 3
    assert len(shown(code, robot)) == 1


def test_joints_that_a_whole_block_lacks_are_one_finding() -> None:
    joints = "".join(f'<joint name="{name}"/>' for name in ("shoulder", "elbow", "wrist"))
    robot = (
        '<link name="a"/><link name="b"/><joint name="slide" type="fixed"><parent link="a"/>'
        f'<child link="b"/></joint><ros2_control name="arm" type="system">{joints}</ros2_control>'
    )
    (finding,) = shown("RCT001", robot)
    assert finding.message.endswith("unknown joint 'shoulder' (and 2 more like this)")


def test_controllers_of_a_robot_with_other_names_are_one_finding(tmp_path: Path) -> None:
    """All twenty joints of one robot's controllers were those of its namesake."""
    names = ("neck", "hip", "knee")
    text = "".join(
        f"{n}_control:\n  type: position_controllers/JointPositionController\n  joint: {n}\n"
        for n in names
    )
    (tmp_path / "c.yaml").write_text(text)
    (tmp_path / "r.urdf").write_text(
        '<robot name="r"><link name="a"/><link name="b"/><joint name="j_pan" type="fixed">'
        '<parent link="a"/><child link="b"/></joint></robot>'
    )
    (tmp_path / "r.launch").write_text(
        '<launch>\n<rosparam command="load" file="$(dirname)/c.yaml"/>\n'
        '<param name="robot_description" textfile="$(dirname)/r.urdf"/>\n</launch>\n'
    )
    found = check(tmp_path / "r.launch", select=["RCT001"]).diagnostics
    assert len(found) == 3
    assert len(grouped(found)) == 1


def test_an_argument_that_is_passed_to_many_files_is_one_finding(tmp_path: Path) -> None:
    include = '<include file="$(dirname)/{}.launch"><arg name="sim" value="1"/></include>'
    for name in ("arm", "base", "view"):
        (tmp_path / f"{name}.launch").write_text("<launch/>")
    includes = "\n".join(map(include.format, ("arm", "base", "view")))
    (tmp_path / "all.launch").write_text(f"<launch>\n{includes}\n</launch>")
    found = check(tmp_path / "all.launch", select=["LAU005"]).diagnostics
    assert len(found) == 3
    (seen,) = grouped(found)
    assert seen.message == "'arm.launch': unknown argument 'sim' (and 2 more like this)"


@pytest.mark.parametrize(
    ("code", "key", "is_one"),
    [
        ("XAC011", "arm_description", True),
        ("XAC001", NOT_CREATED, True),
        ("XAC001", "other", False),
        ("URD001", "other", False),
    ],
)
@pytest.mark.parametrize("name", ["text", "full", "markdown"])
def test_what_one_missing_package_causes_in_two_files_is_one_finding(
    name: str, code: str, key: str, is_one: bool
) -> None:
    robots = [Source(path, b"<robot/>\n") for path in ("a.urdf", "b.urdf")]
    found = [diagnostic(span(robot, "robot"), code=code, group_key=key) for robot in robots]
    page = formats.get(name)(report(*found))
    assert ("1 more like this" in page) == is_one
    assert "b.urdf:1:2" in page or name == "markdown"
