import pytest

from tests.massive import BALL, MESH, inertial, joint, link, part, shape
from tests.naming import naming
from tests.reported import messages, places, reported

MOMENTS = (0.004, 0.004, 0.004)


def test_an_origin_of_another_link() -> None:
    robot = part("caster", 1, MOMENTS, BALL, xyz="-0.957 0 0.2")
    assert messages("INE011", robot) == [
        naming("caster", "-0.957 0 0.2 m", "0.857 m", "outside", "0.2 m", "0 0 0")
    ]
    assert places("INE011", robot) == [(2, '<origin xyz="-0.957 0 0.2" rpy="0 0 0"/>')]


def test_without_an_origin_the_inertial_is_the_place() -> None:
    far = shape("collision", BALL, xyz="0 0 1")
    assert places("INE011", link("cart", far, inertial(1, MOMENTS))) == [(2, "<inertial>")]


@pytest.mark.parametrize(("x", "found"), [(0.0, 0), (0.25, 0), (0.29, 0), (0.31, 1), (-0.31, 1)])
def test_by_more_than_their_length(x: float, found: int) -> None:
    assert len(messages("INE011", part("a", 1, MOMENTS, BALL, xyz=f"{x} 0 0"))) == found


@pytest.mark.parametrize(
    "robot",
    [
        link("a", shape("visual", MESH), shape("collision", BALL), inertial(1, MOMENTS, "9 0 0")),
        link("world") + part("a", 1, MOMENTS, BALL, xyz="9 0 0") + joint("world", "a"),
        part("base", 100, (0.4,) * 3, BALL)
        + part("imu", 0.5, MOMENTS, BALL, xyz="9 0 0")
        + joint("base", "imu"),
    ],
)
def test_what_does_not_matter_or_is_not_measured(robot: str) -> None:
    assert messages("INE011", robot) == []


def test_of_the_calls_of_a_macro_the_one_farthest_out_for_its_size_comes_first() -> None:
    ball = '<geometry><sphere radius="${r}"/></geometry>'
    rolling = joint("world", "${name}", "continuous")
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="world"/>'
        f'<xacro:macro name="part" params="name r x"><link name="${{name}}"><collision>{ball}'
        f"</collision>{inertial(1, MOMENTS, '${x} 0 0')}</link>{rolling}"
        '</xacro:macro><xacro:part name="large" r="1" x="3.5"/>'
        '<xacro:part name="small" r="0.1" x="0.5"/></robot>'
    )
    (found,) = reported("INE011", text, "robot.xacro")
    assert [call.message.split("'")[1] for call in found.calls] == ["small", "large"]


BEAM = '<box size="0.04 0.5 0.06"/>'


@pytest.mark.parametrize(
    ("xyz", "mistake"),
    [
        ("0 -0.13 0", "sign of y"),
        ("0.2 0 0", "x and y swapped"),
        ("0 0.03 0.2", "y and z swapped"),
        ("0 0 0", ""),  # at its end
        ("0 -0.07 0", ""),
        ("0.2 0.2 0.2", ""),
        ("0 0.4 0", ""),
    ],
)
def test_closer_ones_where_a_mistake_explains_them(xyz: str, mistake: str) -> None:
    beam = link("a", shape("collision", BEAM, "0 0.25 0"), inertial(1, MOMENTS, xyz))
    found = messages("INE011", beam)
    assert len(found) == bool(mistake)
    assert all(message.endswith(mistake) for message in found)


@pytest.mark.parametrize(("y", "reported"), [(0.4, 0), (0.49, 0), (0.55, 1)])
def test_left_at_the_origin(y: float, reported: int) -> None:
    beam = link("a", shape("collision", BEAM, f"0 {y} 0"), inertial(1, MOMENTS))
    found = messages("INE011", beam)
    assert len(found) == reported
    assert all(
        message == naming("a", "0 0 0 m", "0.3 m", "outside", "0.5 m", "0 0.55 0", "left")
        for message in found
    )


@pytest.mark.parametrize(
    ("xyz", "found"),
    [("0.1 -0.04 0", 1), ("0.1 0.04 0", 0), ("0.1 -0.03 0", 0)],
)
def test_that_of_the_solid_with_another_sign(xyz: str, found: int) -> None:
    """A JetCobot: the centre stays inside the part."""
    box = shape("collision", '<box size="0.3 0.2 0.1"/>', xyz="0.1 0.04 0")
    messages_of_it = messages("INE011", link("arm", box, inertial(1, MOMENTS, xyz)))
    assert messages_of_it == [naming("arm", "0.3 x 0.2 x 0.1 m", "sign of y")] * found
