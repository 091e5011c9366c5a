import pytest

from tests.naming import naming
from tests.reported import messages, places, reported

SPHERE = '<geometry><sphere radius="1"/></geometry>'


def test_the_second_is_reported_and_the_first_is_shown() -> None:
    robot = (
        '<link name="a">\n<visual><origin xyz="0 0 1"/>'
        f'<origin xyz="0 0 2"/>{SPHERE}</visual></link>'
    )
    (found,) = reported("URD007", robot)
    assert found.message == naming("a", "<origin>", "<visual>")
    assert found.span.text == '<origin xyz="0 0 2"/>'
    assert [(one.span.text, one.message) for one in found.related] == [
        ('<origin xyz="0 0 1"/>', "the first")
    ]


def test_every_surplus_element_is_reported() -> None:
    limit = '<limit lower="0" upper="1" effort="1" velocity="1"/>\n'
    robot = f'<link name="a"/><joint name="j" type="revolute">\n{limit * 3}</joint>'
    assert [line for line, _ in places("URD007", robot)] == [4, 5]


@pytest.mark.parametrize(
    ("shapes", "surplus"),
    [
        (
            '<box size="1 1 1"/><sphere radius="1"/>',
            [naming("<sphere>", "after", "<box>", "<geometry>")],
        ),
        ('<sphere radius="1"/><sphere radius="2"/>', [naming("<sphere>", "<geometry>")]),
        ('<plane/><box size="1 1 1"/>', []),  # URD004 tells that the box is never read
    ],
)
def test_a_geometry_holds_one_shape(shapes: str, surplus: list[str]) -> None:
    robot = f'<link name="a"><visual><geometry>{shapes}</geometry></visual></link>'
    found = [message.split(": ")[1].split("; ")[0] for message in messages("URD007", robot)]
    assert found == surplus


@pytest.mark.parametrize(
    "robot",
    [
        f'<link name="a"><visual>{SPHERE}</visual><visual>{SPHERE}</visual></link>',
        f'<link name="a"><collision>{SPHERE}</collision><collision>{SPHERE}</collision></link>',
        '<link name="a"/><gazebo/><gazebo/><transmission/><transmission/>',
        '<link name="a"><audio_source/><audio_source/></link>',
    ],
)
def test_what_may_stand_often(robot: str) -> None:
    assert reported("URD007", robot) == []
