import pytest

from tests.naming import naming
from tests.reported import fixed, messages, places, reported

BLUE = '<material name="blue"><color rgba="0 0 1 1"/></material>'
BARE = '<material name="blue"/>'


def link(name: str, *materials: str) -> str:
    shape = '<geometry><sphere radius="1"/></geometry>'
    visuals = "".join(f"<visual>{shape}{material}</visual>" for material in materials)
    return f'<link name="{name}">{visuals}</link>\n'


def test_every_name_is_reported_once_with_all_its_uses() -> None:
    robot = link("a", BARE, BARE) + link("b", BARE, '<material name="red"/>')
    assert messages("REF003", robot) == [
        naming("a", "blue", "3"),
        naming("b", "red", "visual"),
    ]
    first, second = reported("REF003", robot)
    assert first.span.text == "blue"
    assert [(one.span.line, one.span.text) for one in first.related] == [(2, "blue"), (3, "blue")]
    assert second.related == ()


@pytest.mark.parametrize(
    "robot",
    [
        BLUE + link("a", BARE),
        link("a", BARE) + BLUE,  # below <robot> the order does not matter
        link("a", BLUE) + link("b", BARE),
        link("a", BLUE, BARE),
        '<material name="blue"><texture filename="a.png"/></material>' + link("a", BARE),
        link("a", '<material name=""/>', ""),  # SolidWorks writes empty names
        link("a", '<material name="${colour}"/>'),  # XAC003
        link("a", '<material name="blue"><color/></material>'),  # URD003
    ],
)
def test_what_has_a_colour_or_another_finding(robot: str) -> None:
    assert messages("REF003", robot) == []


def test_in_a_visual_the_order_matters() -> None:
    (found,) = reported("REF003", link("a", BARE) + link("b", BLUE))
    assert found.message == naming("a", "blue", "visual")
    assert [one.span.line for one in found.related] == [3]


def test_a_definition_without_a_colour_gives_none() -> None:
    assert messages("REF003", BARE + link("a", BARE)) == [naming("a", "blue", "visual", "none")]


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("bleu_grey", ["blue_grey"]),
        ("Gazebo/Blue", ["<gazebo reference>"]),
    ],
)
def test_hints(name: str, hint: list[str]) -> None:
    robot = BLUE.replace("blue", "blue_grey") + link("a", f'<material name="{name}"/>')
    assert messages("REF003", robot) == [naming("a", name, "visual", *hint)]
    assert places("REF003", robot) == [(2, name)]


@pytest.mark.parametrize(("uses", "right"), [(1, "orangge"), (2, "orange")])
def test_of_one_definition_and_several_uses_the_definition_is_misspelt(
    uses: int, right: str
) -> None:
    robot = '<material name="{}"><color rgba="1 0 0 1"/></material>'
    for number in range(uses):
        visual = '<visual><material name="{}"/><geometry><sphere radius="1"/></geometry></visual>'
        robot += f'<link name="l{number}">{visual}</link>'
    after = f'<robot name="example">\n{robot.format(*[right] * (uses + 1))}\n</robot>\n'
    assert fixed("REF003", robot.format("orangge", *["orange"] * uses)) == after
