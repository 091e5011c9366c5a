"""What URDF does not have, and what does no harm."""

import pytest

from tests.reported import reported
from urdfkit.text.diagnostic import Severity

BOX = '<geometry><box size="1 1 1"/></geometry>'
JOINT = (
    '<link name="a"/><link name="b"/><joint name="j" type="fixed"{}><parent link="a"/>{}</joint>'
)


@pytest.mark.parametrize(
    "robot",
    [
        '<link name="a"><collision_checking><capsule name="a_0"/></collision_checking></link>',
        '<link name="a"><self_filter><shape><sphere radius="1"/></shape></self_filter></link>',
        # Isaac Gym: a soft body
        '<link name="a"><fem><youngs value="1e5"/><tetmesh filename="a.tet"/></fem></link>',
        '<link name="a"><contact><inertia_scaling value="3"/></contact></link>',
        '<link name="a"><audio_source><filename value="a.wav"/></audio_source></link>',
        f'<link name="a"><collision concave="yes">{BOX}<verbose value="0"/></collision></link>',
        '<link name="a"/><deformable name="d"><inertial><mass value="1"/></inertial></deformable>',
        '<link name="a"/><mujoco><compiler fusestatic="false"/></mujoco>',
        '<link name="a"/><klampt package_root="../.."/>',
        JOINT.format("", '<child link="b"/><position_based_velocity_limits velocity_offset="1"/>'),
        '<link name="a"/><frame name="f" link="a" xyz="0 0 0" rpy="0 0 0"/>',
        '<link name="a"/><webots><device reference="camera"/></webots>',
        '<link name="a"/><drake:collision_filter_group name="g"/>',
        '<material name="m"><color rgba="1 0 0 1"/><specular rgb="1 1 1"/></material>',
        JOINT.format(' dont_collapse="true"', '<child link="b"/>'),
        JOINT.format("", '<child link="b"/><safety_controller k_velocity="1"/>'),
    ],
)
def test_what_a_known_program_reads_is_no_unknown_element(robot: str) -> None:
    assert [
        found for code in ("URD001", "URD002", "URD004") for found in reported(code, robot)
    ] == []


@pytest.mark.parametrize(
    ("shape", "severity"),
    [
        ('<plane normal="0 0 1"/>', Severity.INFO),
        ('<cdf filename="a.cdf"/>', Severity.INFO),
        ("<grid/>", Severity.ERROR),
    ],
)
def test_a_shape_that_bullet_reads_is_no_error(shape: str, severity: Severity) -> None:
    """Bullet's `plane_implicit.urdf`."""
    robot = f'<link name="a"><collision><geometry>{shape}</geometry></collision></link>'
    (found,) = reported("URD004", robot)
    assert found.severity is severity


def test_the_same_words_elsewhere_are_unknown() -> None:
    (found,) = reported("URD001", '<link name="a"/><collision_checking/>')
    assert found.severity is Severity.WARNING


@pytest.mark.parametrize(
    ("code", "robot", "severity"),
    [
        # Franka's panda: numbers of a controller beside those of URDF
        ("URD002", JOINT.format("", '<child link="b"/><dynamics damping="1" D="1" K="7000"/>'), 0),
        # the tutorials of ROS
        ("URD002", JOINT.format("", '<child link="b"/><axis rpy="0 0 0" xyz="1 0 0"/>'), 0),
        ("URD002", JOINT.format("", '<child link="b"/><axis rpy="0 0 1" xyz="1 0 0"/>'), 1),
        ("URD002", '<link name="a"><inertial xyz="0 0 1"/></link>', 1),
        ("URD001", f'<link name="a"><collision>{BOX}<material name="m"/></collision></link>', 0),
        ("URD001", '<link name="a"><origin xyz="0 0 1"/></link>', 1),
        # onshape-to-robot
        ("URD001", '<link name="a"><origin xyz="0 0 0" rpy="0 -0 0"/></link>', 0),
        ("URD008", '<link name="a"><pose>0 0 0 0 0 0</pose></link>', 0),
        ("URD008", '<link name="a"><pose>0 0 0.1 0 0 0</pose></link>', 1),
        ("NAM004", JOINT.format("", '<child link="b"/>').replace('"j"', '"to base"'), 0),
        ("NAM004", '<link name="to base"/>', 1),
    ],
)
def test_what_loses_nothing_is_an_info(code: str, robot: str, severity: int) -> None:
    (found,) = reported(code, robot)
    assert found.severity is (Severity.INFO, Severity.WARNING)[severity]


@pytest.mark.parametrize(
    ("inside", "severity"),
    [
        ('<joint_properties friction="0.0"/>', Severity.INFO),  # Onshape's export
        ('<joint_properties friction="0.1"/>', Severity.WARNING),
        ("<axis><xyz>0 0 1</xyz></axis>", Severity.INFO),
    ],
)
def test_what_would_change_nothing(inside: str, severity: Severity) -> None:
    (found,) = reported("URD001", JOINT.format("", f'<child link="b"/>{inside}'))
    assert found.severity is severity


def test_an_element_whose_name_is_computed() -> None:
    """robotnik_sensors: the name of a macro that a launch file passes."""
    inside = "<link name=\"a\"/><xacro:element xacro:name=\"${'sen' + 'sr'}\"/>"
    robot = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{inside}</robot>'
    found = [one for one in reported("URD001", robot.encode()) if one.code == "URD001"]
    assert [(one.severity, one.fix) for one in found] == [(Severity.INFO, None)]


@pytest.mark.parametrize(
    ("geometry", "count"),
    [
        ('<mesh filename="a.stl"/><mesh filename="a.stl" scale=""/>', 0),
        ('<box size="1 1 1"/><cylinder radius="1,5"/>', 0),
        ('<mesh filename="a.stl" scale=""/><mesh filename="a.stl"/>', 1),
    ],
)
def test_values_that_no_parser_reads(geometry: str, count: int) -> None:
    """DiffBot's wheels: a second <mesh> with an empty scale, which URD007 tells."""
    robot = f'<link name="a"><visual><geometry>{geometry}</geometry></visual></link>'
    assert len(reported("URD005", robot) + reported("URD003", robot)) == count
    assert len(reported("URD007", robot)) == 1
