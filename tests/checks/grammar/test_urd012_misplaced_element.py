from __future__ import annotations

import pytest

from tests.reported import fixed, messages, reported


@pytest.mark.parametrize(
    ("robot", "message"),
    [
        (
            '<link name="a"><origin xyz="0 0 1"/></link>',
            (
                "link 'a': URDF parsers ignore <origin> inside <link>; it belongs in "
                "<collision> or <inertial> or <joint> or <visual>"
            ),
        ),
        (
            '<link name="a"><mass value="1"/></link>',
            "link 'a': URDF parsers ignore <mass> inside <link>; it belongs in <inertial>",
        ),
        (
            '<link name="a"/><inertial/>',
            "robot 'example': URDF parsers ignore <inertial> inside <robot>; it belongs in <link>",
        ),
        (
            '<link name="a"><gazebo><plugin/></gazebo></link>',
            "link 'a': URDF parsers ignore <gazebo> inside <link>; it belongs in <robot>",
        ),
    ],
)
def test_where_it_belongs_is_told(robot: str, message: str) -> None:
    assert messages("URD012", robot) == [message]
    assert reported("URD001", robot) == []


INLINE = '<link name="a"><visual><geometry><box size="1 1 1"/>{}</geometry>{}</visual></link>'
MATERIAL = '<material name="m"><color rgba="1 0 0 1"/></material>'


def test_a_material_moves_behind_the_geometry() -> None:
    assert fixed("URD012", INLINE.format(MATERIAL, "")) == (
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
    assert fixed("URD012", robot.format(inside, "")) == robot.format("", outside)


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
    found = reported("URD012", robot)
    assert found
    assert [one.fix for one in found] == [None] * len(found)


def test_elements_of_one_tag_in_the_same_wrong_place_are_one_finding() -> None:
    body = f"<collision><geometry><sphere radius='1'/></geometry>{MATERIAL}</collision>"
    robot = "".join(f'<link name="{name}">{body}</link>' for name in "abcdefg")
    (found,) = reported("URD012", robot)
    assert found.message == (
        "link 'a': URDF parsers ignore <material> inside <collision>; it belongs in <robot> or "
        "<visual> (and 6 more like this)"
    )
    assert [related.message for related in found.related] == [f"link '{name}'" for name in "bcdef"]
