import pytest

from tests.massive import link, shape
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.lint.grouping import grouped


def mesh(name: str, scale: str, tag: str = "visual") -> str:
    return link(name, shape(tag, f'<mesh filename="a.stl" scale="{scale}"/>'))


@pytest.mark.parametrize("scale", ["-1 1 1", "0.001 -0.001 0.001", "-1 -1 -1"])
def test_a_mirrored_mesh(scale: str) -> None:
    assert messages("GEO001", mesh("arm", scale)) == [naming("arm", "visual", "mirrored", scale)]
    assert places("GEO001", mesh("arm", scale)) == [(2, scale)]


@pytest.mark.parametrize("scale", ["1 1 1", "-1 -1 1"])
def test_what_is_all_right_or_another_rule_s(scale: str) -> None:
    assert messages("GEO001", mesh("arm", scale)) == []


def test_a_whole_side_is_one_finding_for_people() -> None:
    robot = "".join(
        mesh(f"{name}", "1 -1 1", tag) for name in "abc" for tag in ("visual", "collision")
    )
    (found,) = grouped(reported("GEO001", robot))
    assert found.message == naming("a", "visual", "mirrored", "1 -1 1", "5")
    assert [note.span.line for note in found.related] == [3, 4, 5, 6, 7]
