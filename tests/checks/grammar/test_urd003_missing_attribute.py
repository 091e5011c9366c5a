from __future__ import annotations

import pytest

from tests.reported import fixed, messages, places

JOINT = '<link name="a"/><link name="b"/>\n<joint {}>{}</joint>'
ENDS = '<parent link="a"/><child link="b"/>'


@pytest.mark.parametrize(
    ("robot", "message"),
    [
        ("<link/>", "<link>: <link> has no 'name'"),
        (JOINT.format('type="fixed"', ENDS), "<joint>: <joint> has no 'name'"),
        (JOINT.format('name="j"', ENDS), "joint 'j': <joint> has no 'type'"),
        (
            JOINT.format('name="j" type="fixed"', '<parent/><child link="b"/>'),
            "joint 'j': <parent> has no 'link'",
        ),
        (
            JOINT.format('name="j" type="continuous"', ENDS + "<dynamics/>"),
            "joint 'j': <dynamics> has no 'damping' or 'friction'",
        ),
        (
            JOINT.format('name="j" type="continuous"', ENDS + "<mimic/>"),
            "joint 'j': <mimic> has no 'joint'",
        ),
        (
            '<link name="a"><visual><geometry><mesh/></geometry></visual></link>',
            "link 'a': <mesh> has no 'filename'",
        ),
    ],
)
def test_what_is_missing_is_named(robot: str, message: str) -> None:
    assert messages("URD003", robot) == [message]


def test_all_that_is_missing_is_told() -> None:
    robot = '<link name="a"><inertial><mass/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>'
    assert sorted(messages("URD003", robot)) == [
        "link 'a': <inertia> has no 'ixy'",
        "link 'a': <inertia> has no 'ixz'",
        "link 'a': <inertia> has no 'iyz'",
        "link 'a': <mass> has no 'value'",
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


def test_another_name_for_it_is_offered_as_the_remedy() -> None:
    robot = '<link name="a"><visual><geometry><mesh file="a.stl"/></geometry></visual></link>'
    assert messages("URD003", robot) == [
        "link 'a': <mesh> has no 'filename', but 'file', which URDF does not know"
    ]
    assert places("URD003", robot) == [(2, "a.stl")]
    assert '<mesh filename="a.stl"/>' in fixed("URD003", robot)
