from __future__ import annotations

import pytest

from tests.reported import fixed, messages, reported


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
    assert len(reported("URD013", robot)) == 1
    assert fixed("URD013", robot) == (
        f'<robot name="example">\n{robot.replace(wrong, right)}\n</robot>\n'
    )
    assert reported("URD001", robot) == []
    assert reported("URD004", robot) == [], "what is misspelt is not missing as well"


def test_who_and_what() -> None:
    assert messages("URD013", '<link name="a"><inertal/></link>') == [
        "link 'a': URDF has no <inertal>, and the <inertial> that it seems to be is missing"
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
    assert reported("URD013", robot) == []
    assert len(reported("URD001", robot)) == 1
