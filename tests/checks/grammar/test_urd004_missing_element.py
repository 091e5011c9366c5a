import pytest

from tests.naming import naming
from tests.reported import messages, places, reported


@pytest.mark.parametrize(
    ("robot", "message"),
    [
        ('<link name="a"><visual/></link>', naming("a", "<visual>", "<geometry>")),
        ('<link name="a"><collision/></link>', naming("a", "<collision>", "<geometry>")),
        (
            '<link name="a"><inertial><mass value="1"/></inertial></link>',
            naming("a", "<inertial>", "<inertia>"),
        ),
        (
            '<link name="a"/><joint name="j" type="fixed"><parent link="a"/></joint>',
            naming("j", "<child>"),
        ),
    ],
)
def test_what_is_missing_is_named(robot: str, message: str) -> None:
    assert messages("URD004", robot) == [message]


def test_the_place_is_the_element_that_lacks_it() -> None:
    robot = '<link name="a"/>\n<joint name="j" type="fixed">\n</joint>'
    assert places("URD004", robot) == [(3, '<joint name="j" type="fixed">')] * 2


@pytest.mark.parametrize(
    "robot",
    [
        '<link name="a"/>',
        '<link name="a"/><gazebo><plugin/></gazebo><transmission name="t"/>',
        '<link name="a"><visual><geomtry/></visual></link>',  # URD001
    ],
)
def test_what_is_not_missing_or_reported_by_another_rule(robot: str) -> None:
    assert reported("URD004", robot) == []


VISUAL = '<link name="a"><visual>\n<geometry>{}</geometry></visual></link>'


@pytest.mark.parametrize(
    ("content", "message", "place"),
    [
        ("", naming("a", "<geometry>"), "<geometry>"),
        ("<!-- box -->", naming("a", "<geometry>"), "<geometry>"),
        (
            '<plane normal="0 0 1"/>',
            naming("a", "<geometry>", "<plane>", "Bullet"),
            '<plane normal="0 0 1"/>',
        ),
        (
            '<material name="m"/><box size="1 1 1"/>',
            naming("a", "<geometry>", "<material>"),
            '<material name="m"/>',
        ),
    ],
)
def test_no_shape_where_readers_look(content: str, message: str, place: str) -> None:
    robot = VISUAL.format(content)
    assert messages("URD004", robot) == [message]
    assert places("URD004", robot) == [(3, place)]
    assert reported("URD001", robot) == []


@pytest.mark.parametrize(
    "content",
    [
        '<box size="1 1 1"/><material name="m"/>',  # URD001: read, but without the colour
        '<drake:ellipsoid xmlns:drake="http://drake.mit.edu"/>',
        '<capsule radius="1" length="1"/>',  # URD011
        "<bx/>",  # URD001
    ],
)
def test_a_shape_or_another_finding(content: str) -> None:
    assert reported("URD004", VISUAL.format(content)) == []


def test_pybullet_reads_planes() -> None:
    plane = '<geometry><plane normal="0 0 1"/></geometry>'
    robot = f'<link name="a"><collision>{plane}</collision></link>'
    assert reported("URD004", robot, targets=("pybullet",)) == []
    assert len(reported("URD004", robot, targets=("pybullet", "ros2"))) == 1


@pytest.mark.parametrize(("targets", "severity"), [((), "info"), (("ros2",), "error")])
def test_the_density_of_isaac_gym(targets: tuple[str, ...], severity: str) -> None:
    robot = '<link name="a"><inertial><density value="567"/></inertial></link>'
    (found,) = reported("URD004", robot, targets=targets)
    assert found.severity.value == severity
    assert "density" in found.message
    assert reported("URD001", robot) == []
