"""Fixes that copy, lift, keep or delete elements: GEO004, TRE008, URD007, URD003, XAC004."""

import pytest

from tests.reported import fixed, reported

SHAPE = '<geometry><box size="0.4 0.1 0.1"/></geometry>'


def body(visual: str, collision: str) -> str:
    return (
        f'<link name="a">\n<visual>\n  {visual}\n  {SHAPE}\n</visual>\n'
        f"<collision>{collision}{SHAPE}</collision>\n</link>"
    )


@pytest.mark.parametrize(
    ("visual", "collision", "after"),
    [
        ('<origin xyz="0 0 1"/>', "", '<origin xyz="0 0 1"/>'),
        (
            "<origin rpy='0 0 1.57'/>",
            '<origin xyz="0 0 0" rpy="0 0 0"/>',
            "<origin rpy='0 0 1.57'/>",
        ),
        ("", '<origin xyz="0 0 1"/>', ""),
    ],
)
def test_a_collision_gets_the_origin_of_the_same_shape(
    visual: str, collision: str, after: str
) -> None:
    expected = f'<robot name="example">\n{body(visual, after)}\n</robot>\n'
    assert fixed("GEO004", body(visual, collision)) == expected


def test_a_collision_of_another_shape_keeps_its_origin() -> None:
    robot = body('<origin xyz="0 0 1"/>', "").replace("0.4 0.1 0.1", "0.4 0.2 0.1", 1)
    assert [one.fix for one in reported("GEO004", robot)] == [None]


FOOTPRINT = """\
<link name="base_footprint"/>
<link name="base_link">
  <collision><geometry><box size="0.4 0.3 0.2"/></geometry></collision>
</link>
<joint name="j" type="fixed">
  {}<parent link="base_footprint"/>
  <child link="base_link"/>
</joint>"""


@pytest.mark.parametrize(
    ("origin", "lifted"),
    [
        ("", '<origin xyz="0 0 0.1"/>\n  '),
        ('<origin rpy="0 0 1"/>', '<origin xyz="0 0 0.1" rpy="0 0 1"/>'),
        ("<origin xyz='0.5 0  -0.2'/>", "<origin xyz='0.5 0 0.1'/>"),
        ('<origin xyz="0 0 1"/>', '<origin xyz="0 0 0.1"/>'),
    ],
)
def test_the_robot_is_lifted_to_the_ground(origin: str, lifted: str) -> None:
    robot = f'<robot name="example">\n{FOOTPRINT.format(lifted)}\n</robot>\n'
    assert fixed("TRE008", FOOTPRINT.format(origin)) == robot
    assert reported("TRE008", FOOTPRINT.format(lifted)) == []


def test_a_computed_height_is_not_edited() -> None:
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    robot = FOOTPRINT.format('<origin xyz="0 0 ${0.05*4}"/>')
    assert [one.fix for one in reported("TRE008", f"{head}{robot}</robot>", "r.xacro")] == [None]


@pytest.mark.parametrize(
    ("first", "second", "same"),
    [
        ('<origin xyz="0 0 1"/>', "<origin xyz='0  0 1' />", True),
        ('<origin xyz="0 0 1"/>', '<origin xyz="0 0 1.0"/>', False),
        ('<origin xyz="0 0 1"/>', '<origin xyz="0 0 1" rpy="0 0 0"/>', False),
    ],
)
def test_only_a_copy_is_removed(first: str, second: str, same: bool) -> None:
    robot = f'<link name="a"><visual>{first}{second}{SHAPE}</visual></link>'
    (found,) = reported("URD007", robot)
    assert (found.fix is not None) is same
    if found.fix:
        assert found.fix.safe
        assert fixed("URD007", robot) == (
            f'<robot name="example">\n<link name="a"><visual>{first}{SHAPE}</visual></link>\n'
            "</robot>\n"
        )


@pytest.mark.parametrize(
    ("path", "name"), [("arm/panda.urdf.xacro", "panda"), ("7 of 9.urdf", None), ("é.urdf", None)]
)
def test_a_robot_gets_the_name_of_its_file(path: str, name: str | None) -> None:
    text = '<robot\n>\n  <link name="a"/></robot>'
    expected = text.replace("<robot", f'<robot name="{name}"') if name else text
    assert fixed("URD003", text, path) == expected
