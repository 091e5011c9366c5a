import pytest

from tests.massive import BALL, link
from tests.naming import naming
from tests.reported import messages, places

GREY = '<material name="grey"><color rgba="0.2 0.2 0.2 0"/></material>\n'


def seen(name: str, material: str) -> str:
    return link(name, f"<visual><geometry>{BALL}</geometry>{material}</visual>")


def test_once_per_colour() -> None:
    robot = GREY + seen("a", '<material name="grey"/>') + seen("b", '<material name="grey"/>')
    assert messages("GEO007", robot) == [naming("a", "grey", "visual", "0")]
    assert places("GEO007", robot) == [(2, "0.2 0.2 0.2 0")]


def test_a_colour_without_a_name() -> None:
    robot = seen("a", '<material><color rgba="1 1 1 0"/></material>')
    assert messages("GEO007", robot) == [naming("a", "visual", "0")]


@pytest.mark.parametrize(
    "robot",
    [
        GREY + link("a"),  # used by nobody
        seen("a", GREY.replace("0.2 0.2 0.2 0", "0.2 0.2 0.2 0.01")),
        seen("a", GREY.replace("0.2 0.2 0.2 0", "0.2 0.2 0")),  # URD005
        seen("a", GREY.replace("grey", "Invisible_body")),
        seen("a", GREY.replace("grey", "glass")),
        seen("a", GREY.replace("</material>", '<texture filename="a.png"/></material>')),
    ],
)
def test_what_is_meant_or_another_rule_s(robot: str) -> None:
    assert messages("GEO007", robot) == []
