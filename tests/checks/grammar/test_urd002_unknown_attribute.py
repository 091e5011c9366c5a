import pytest

from tests.naming import naming
from tests.reported import fixed, messages, places, reported

LIMIT = """\
<link name="a"/>
<link name="b"/>
<joint name="j" type="revolute">
  <parent link="a"/>
  <child link="b"/>
  <limit lower="0" upper="1" effort="5" {}/>
</joint>"""


def test_the_nearest_attribute_is_offered() -> None:
    robot = LIMIT.format('velocty="2"')
    assert messages("URD002", robot) == [
        naming("j", "unknown", "velocty", "<limit>", "ignored", "velocity")
    ]
    assert places("URD002", robot) == [(7, "2")]
    assert 'effort="5" velocity="2"/>' in fixed("URD002", robot)


@pytest.mark.parametrize(
    ("written", "suggested"),
    [("velocty = '2'", "velocity = '2'"), ('velocty\n="2"', 'velocity\n="2"')],
)
def test_the_name_alone_is_changed(written: str, suggested: str) -> None:
    assert fixed("URD002", LIMIT.format(written)) == (
        f'<robot name="example">\n{LIMIT.format(suggested)}\n</robot>\n'
    )


def test_an_attribute_that_is_like_none_is_reported_without_a_guess() -> None:
    robot = LIMIT.format('velocity="2" colour="red"')
    assert messages("URD002", robot) == [naming("j", "unknown", "colour", "<limit>", "ignored")]
    assert reported("URD002", robot)[0].fix is None


@pytest.mark.parametrize(
    "robot",
    [
        '<robot name="r" xmlns="x" xmlns:xacro="y" xml:lang="en"><link name="a"/></robot>',
        '<robot name="r" xmlns:d="y"><link name="a" d:tag="1"/></robot>',
        (
            '<link name="a"><collision group="1" mask="2" concave="yes">'
            '<geometry><sphere radius="1"/></geometry></collision></link>'
        ),  # PyBullet
        (
            '<link name="a"/><link name="b"/><joint name="j" type="fixed" dont_collapse="true">'
            '<parent link="a"/><child link="b"/></joint>'
        ),  # Isaac Gym
    ],
)
def test_namespaces_and_other_readers_attributes_are_known(robot: str) -> None:
    assert reported("URD002", robot) == []


def test_the_attribute_that_was_needed_is_not_reported_twice() -> None:
    robot = '<link name="a"><visual><geometry><sphere radiu="1"/></geometry></visual></link>'
    assert reported("URD002", robot) == []
    assert len(reported("URD003", robot)) == 1


def test_an_attribute_of_another_program_is_reported_once_for_all_that_have_it() -> None:
    robot = "".join(
        f'<joint name="j{i}" type="fixed"><parent link="a"/><child link="b{i}"/>'
        f'<dynamics stiff="1"/></joint>\n<link name="b{i}"/>\n'
        for i in range(8)
    )
    (finding,) = reported("URD002", f'<link name="a"/>\n{robot}')
    assert finding.message == naming("j0", "unknown", "stiff", "<dynamics>", "ignored", "7")
    assert [related.message for related in finding.related] == [
        f"joint 'j{i}'" for i in range(1, 6)
    ]


def test_all_foreign_attributes_of_a_tag_are_one_finding() -> None:
    robot = "".join(
        f'<joint name="j{i}" type="fixed"><parent link="a"/><child link="b{i}"/>'
        f'<dynamics K="1" D="2" mu="3"/></joint>\n<link name="b{i}"/>\n'
        for i in range(2)
    )
    (finding,) = reported("URD002", f'<link name="a"/>\n{robot}')
    assert finding.message == naming("j0", "unknown", "K", "D", "mu", "<dynamics>", "ignored", "1")


def test_a_long_list_of_attributes_is_cut() -> None:
    foreign = " ".join(f'{letter}="1"' for letter in "ABCDEFGH")
    (finding,) = reported("URD002", f'<link name="a" {foreign}/>')
    assert finding.message == naming(
        "a", "unknown", "A", "B", "C", "D", "E", "3", "<link>", "ignored"
    )


@pytest.mark.parametrize(
    ("name", "count"), [("drake:acceleration", 0), ("drake:aceleration", 1), ("drake:own", 0)]
)
def test_attributes_of_drake(name: str, count: int) -> None:
    joint = (
        '<link name="a"/><link name="b"/><joint name="j" type="revolute"><parent link="a"/>'
        '<child link="b"/><limit xmlns:drake="http://drake.mit.edu" lower="0" upper="1" '
        f'effort="1" velocity="1" {name}="2"/></joint>'
    )
    assert ["mean 'drake:acceleration'" in one for one in messages("URD002", joint)] == [
        True
    ] * count
