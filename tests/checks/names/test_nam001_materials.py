import pytest

from tests.naming import naming
from tests.reported import messages, reported

WHITE, RED = "1 1 1 1", "1 0 0 1"


def material(rgba: str, name: str = "m") -> str:
    return f'<material name="{name}"><color rgba="{rgba}"/></material>'


def link(*materials: str) -> str:
    shape = '<geometry><sphere radius="1"/></geometry>'
    visuals = "\n".join(f"<visual>{shape}{one}</visual>" for one in materials)
    return f'<link name="a">{visuals}</link>'


def test_the_colour_that_is_lost_is_reported_with_the_one_that_wins() -> None:
    (found,) = reported("NAM001", link(material(WHITE), material(RED)))
    assert found.message == naming("a", "m", "1 0 0 1", "1 1 1 1", "before")
    assert (found.span.line, found.span.text) == (3, RED)
    assert [one.span.line for one in found.related] == [2]


def test_the_one_below_the_robot_wins_wherever_it_stands() -> None:
    robot = f"{link(material(RED), material(WHITE))}\n{material(WHITE)}"
    assert [one.partition(" is ")[2] for one in messages("NAM001", robot)] == [
        naming("1 0 0 1", "1 1 1 1", "before")
    ]


@pytest.mark.parametrize(
    "robot",
    [
        link(material(RED), material("1.0 0 0 1")),
        link(material(RED), material(WHITE, "n")),
        link(material(RED), '<material name="m"/>'),
        link(material(RED, ""), material(WHITE, "")),  # nameless: each has its own
        link(material(RED), material("red")),  # URD005
    ],
)
def test_one_colour_for_each_name(robot: str) -> None:
    assert reported("NAM001", robot) == []


def test_textures_count_as_well() -> None:
    robot = link(material(RED), '<material name="m"><texture filename="a.png"/></material>')
    assert messages("NAM001", robot) == [naming("a", "m", "a.png", "1 0 0 1", "before")]
