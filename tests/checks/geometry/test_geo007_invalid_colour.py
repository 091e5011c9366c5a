from pathlib import Path

import pytest

from tests.massive import link
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from tests.urdfdom import needs_check_urdf, urdfdom


def paint(rgba: str) -> str:
    return f'<material name="paint"><color rgba="{rgba}"/></material>\n'


@pytest.mark.parametrize(
    ("rgba", "wrong", "mended"),
    [
        ("255 140 0 1", "255, 140", "1 0.549 0 1"),
        ("255 140 0 255", "255, 140, 255", "1 0.549 0 1"),
        ("51 51 51 0.5", "51, 51, 51", "0.2 0.2 0.2 0.5"),
        ("1.2 0.5 0 1", "1.2", "1 0.5 0 1"),
        ("255 255 1 1", "255, 255", "1 1 1 1"),  # 'white', which RViz cuts off at 1
        ("1 1 0 255", "255", "1 1 0 1"),
        ("90 50 10 100", "90, 50, 10, 100", "0.9 0.5 0.1 1"),
        ("90 50 10 80", "90, 50, 10, 80", None),
        ("1 1 0 10", "10", None),
        ("-0.1 0 0 1", "-0.1", None),
        ("300 0 0 1", "300", None),
    ],
)
def test_what_was_meant(rgba: str, wrong: str, mended: str | None) -> None:
    robot = paint(rgba) + link("a")
    (found,) = reported("GEO007", robot)
    assert found.message == naming("paint", wrong, "0", "1")
    assert places("GEO007", robot) == [(2, rgba)]
    if mended is None:
        assert found.fix is None
        assert found.help == naming("0", "1")
    else:
        assert found.help == f'write rgba="{mended}"'
        assert f'rgba="{mended}"' in fixed("GEO007", robot)
        assert messages("GEO007", fixed("GEO007", robot)) == []


@pytest.mark.parametrize("rgba", ["0 0 0 0", "1 1 1 1", "x 300 0 1", ""])
def test_what_is_all_right_or_another_rule_s(rgba: str) -> None:
    assert messages("GEO007", paint(rgba) + link("a")) == []


def test_materials_in_visuals() -> None:
    ball = '<geometry><sphere radius="1"/></geometry>'
    color = '<color rgba="0 9 0 1"/>'
    robot = link("a", f"<visual>{ball}<material>{color}</material></visual>")
    assert messages("GEO007", robot) == [naming("9", "0", "1")]


@needs_check_urdf
@pytest.mark.parametrize(("rgba", "refused"), [("1 0 0 1", False), ("255 0 0 1", True)])
def test_urdfdom_refuses_the_colour(rgba: str, refused: bool, tmp_path: Path) -> None:
    robot = paint(rgba) + link("a")
    assert ("malformed color" in urdfdom(robot, tmp_path)[1]) is refused
    assert bool(messages("GEO007", robot)) is refused
