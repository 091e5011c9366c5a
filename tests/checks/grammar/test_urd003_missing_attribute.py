from pathlib import Path

import pytest

from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from tests.xacros import NAMESPACE
from urdfkit import check

JOINT = '<link name="a"/><link name="b"/>\n<joint {}>{}</joint>'
ENDS = '<parent link="a"/><child link="b"/>'


@pytest.mark.parametrize(
    ("robot", "message"),
    [
        ("<link/>", naming("<link>", "<link>", "name")),
        (JOINT.format('type="fixed"', ENDS), naming("<joint>", "<joint>", "name")),
        (JOINT.format('name="j"', ENDS), naming("j", "<joint>", "type")),
        (
            JOINT.format('name="j" type="fixed"', '<parent/><child link="b"/>'),
            naming("j", "<parent>", "link"),
        ),
        (
            JOINT.format('name="j" type="continuous"', ENDS + "<dynamics/>"),
            naming("j", "<dynamics>", "damping", "friction"),
        ),
        (
            JOINT.format('name="j" type="continuous"', ENDS + "<mimic/>"),
            naming("j", "<mimic>", "joint"),
        ),
        (
            '<link name="a"><visual><geometry><mesh/></geometry></visual></link>',
            naming("a", "<mesh>", "filename"),
        ),
    ],
)
def test_what_is_missing_is_named(robot: str, message: str) -> None:
    assert messages("URD003", robot) == [message]


@pytest.mark.parametrize(
    ("robot", "help"),
    [
        ("<box><size>1 2 3</size></box>", naming('<box size="1 2 3"/>', "attribute")),
        ("<sphere>0.5</sphere>", naming('<sphere radius="0.5"/>', "attribute")),
        ("<sphere/>", naming("add", "attribute")),
    ],
)
def test_a_value_in_an_element_is_sdf(robot: str, help: str) -> None:
    robot = f'<link name="a"><visual><geometry>{robot}</geometry></visual></link>'
    (found,) = reported("URD003", robot)
    assert found.help == help
    assert reported("URD001", robot) == []


def test_what_bullet_needs() -> None:
    robot = (
        '<link name="a"><contact><damping>1</damping><contact_cfm>0</contact_cfm></contact></link>'
    )
    assert messages("URD003", robot) == [naming("a", "<damping>", "value")]


def test_all_that_is_missing_is_reported() -> None:
    robot = '<link name="a"><inertial><mass/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>'
    assert sorted(messages("URD003", robot)) == [
        naming("a", "<inertia>", "ixy"),
        naming("a", "<inertia>", "ixz"),
        naming("a", "<inertia>", "iyz"),
        naming("a", "<mass>", "value"),
    ]


@pytest.mark.parametrize(
    "complete",
    [
        JOINT.format('name="j" type="continuous"', ENDS + '<axis/><dynamics friction="1"/>'),
        '<link name="a"><visual><origin/><geometry><sphere radius="1"/></geometry></visual></link>',
        '<link name="a"/><gazebo><plugin/></gazebo>',
    ],
)
def test_what_has_a_default_may_be_missing(complete: str) -> None:
    assert messages("URD003", complete) == []


def test_another_name_for_it_is_offered_as_the_fix() -> None:
    robot = '<link name="a"><visual><geometry><mesh file="a.stl"/></geometry></visual></link>'
    assert messages("URD003", robot) == [naming("a", "<mesh>", "filename", "unknown", "file")]
    assert places("URD003", robot) == [(2, "a.stl")]
    assert '<mesh filename="a.stl"/>' in fixed("URD003", robot)


@pytest.mark.parametrize(
    ("shape", "count"),
    [
        ('<cylinder radius="1" height="2"/>', 1),
        ('<cylinder radius="1" height="2" axis="3"/>', 0),
        ('<cylinder height="2"/>', 0),
        ('<cylinder radius="1" note="of steel"/>', 0),
    ],
)
def test_the_only_unknown_number_of_a_shape(shape: str, count: int) -> None:
    robot = f'<link name="a"><visual><geometry>{shape}</geometry></visual></link>'
    named = [message for message in messages("URD003", robot) if "height" in message]
    assert named == [naming("a", "<cylinder>", "length", "unknown", "height")] * count
    assert ('length="2"' in fixed("URD003", robot)) is bool(count)


def test_a_name_whose_value_is_in_a_yaml_file(tmp_path: Path) -> None:
    loaded = "${xacro.load_yaml('a.yaml')}"
    shape = '<cylinder radius="1" height="${a.h}"/>'
    (tmp_path / "a.yaml").write_text("h: 2\n")
    (tmp_path / "r.xacro").write_text(
        f'<robot name="r" {NAMESPACE}><xacro:property name="a" value="{loaded}"/>\n'
        f'<link name="a"><visual><geometry>\n{shape}</geometry></visual></link></robot>'
    )
    (found,) = check(tmp_path / "r.xacro", select=["URD003"]).diagnostics
    assert (found.span.source.path, found.span.line) == (str(tmp_path / "r.xacro"), 3)


def test_the_place_is_the_robot() -> None:
    assert places("URD003", '<?xml version="1.0"?>\n<robot><link name="a"/></robot>') == [
        (2, "<robot>")
    ]


@pytest.mark.parametrize(
    ("robot", "count"),
    [
        (f'<robot {NAMESPACE}><xacro:macro name="m" params=""/></robot>', 0),
        (f'<robot {NAMESPACE}><link name="a"/><xacro:property name="p" value="1"/></robot>', 1),
        ('<robot name=""><link name="a"/></robot>', 0),  # check_urdf accepts it
        ("<robot/>", 1),
    ],
)
def test_only_a_library_of_macros_needs_none(robot: str, count: int) -> None:
    name = "robot.xacro" if NAMESPACE in robot else "robot.urdf"
    assert len(reported("URD003", robot, name)) == count


def test_links_and_joints_without_a_name() -> None:
    robot = '<link name=""/>\n<link name=" "/>\n<joint name="" type="fixed"/>'
    assert messages("URD003", robot) == [
        naming("empty", "name"),
        naming("empty", "name"),
        naming("empty", "name"),
    ]
    assert places("URD003", robot) == [(2, ""), (3, " "), (4, "")]


def test_no_name_at_all_is_the_same_rule() -> None:
    assert messages("URD003", "<link/>") == ["<link>: <link> has no 'name'"]


def test_mujoco_reads_a_material_without_a_name(tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    path = tmp_path / "r.urdf"
    path.write_text(
        '<robot name="r"><mujoco><compiler discardvisual="false"/></mujoco><link name="a"><visual>'
        '<geometry><sphere radius="0.1"/></geometry><material><color rgba="1 0 0 1"/></material>'
        "</visual></link></robot>"
    )
    assert mujoco.MjModel.from_xml_path(str(path)).geom_rgba[0].tolist() == [1, 0, 0, 1]
    for target, severity in (("mujoco", "warning"), ("pinocchio", "error")):
        (found,) = check(path, select=["URD003"], targets=[target]).diagnostics
        assert found.severity.value == severity
