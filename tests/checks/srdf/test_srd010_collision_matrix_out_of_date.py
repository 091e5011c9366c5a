"""SRD010: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.physics.collision.robots import joint, link, revolute, sphere
from tests.srdfs import findings, message_of
from urdfkit import Diagnostic, check
from urdfkit.lint.rule_examples import whole_robot


def reported(directory: Path, matrix: str, *, near: float = 0.15) -> list[Diagnostic]:
    """A hand that is held near the arm."""
    robot = whole_robot(
        "\n".join(
            (
                link("base", sphere(0.1)),
                link("arm", sphere(0.1)),
                link("hand", sphere(0.1)),
                joint("base", "arm", "revolute", "0 0 0.5", revolute(-1, 1)),
                joint("arm", "hand", origin=f"0 0 {near}"),
            )
        )
    )
    (directory / "r.urdf").write_text(robot)
    (directory / "r.srdf").write_text(f'<robot name="example">\n{matrix}\n</robot>\n')
    return list(check(directory / "r.urdf", select=["SRD010"]).diagnostics)


SOME = '<disable_collisions link1="base" link2="arm" reason="Adjacent"/>'
ALL = f'{SOME}<disable_collisions link1="hand" link2="arm" reason="Adjacent"/>'


def test_the_pair_and_the_depth(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, SOME)
    assert found.message == naming("arm", "hand", "50 mm")
    assert found.span.source.path == str(tmp_path / "r.srdf")


@pytest.mark.parametrize(
    "matrix",
    [
        ALL,
        "",
        f'{SOME}<disable_default_collisions link="arm"/>',
        ALL.replace('"hand"', '"hand  "'),  # srdfdom trims names
        f'{SOME}<disable_default_collisions link=" arm"/>',
    ],
)
def test_disabled_pair_or_no_matrix(tmp_path: Path, matrix: str) -> None:
    assert reported(tmp_path, matrix) == []


@pytest.mark.parametrize(("near", "severity"), [(0.198, "warning"), (0.1995, "info")])
def test_an_overlap_by_rounding_is_an_info(tmp_path: Path, near: float, severity: str) -> None:
    (found,) = reported(tmp_path, SOME, near=near)
    assert found.severity.value == severity


def test_a_matrix_for_a_program_that_never_checks_connected_links(tmp_path: Path) -> None:
    """personalrobotics/herb_description: OpenRAVE."""
    found = reported(tmp_path, SOME.replace("arm", "hand"))
    assert {one.severity.value for one in found if "overlap" in one.message} == {"info"}


def test_separate_links_are_accepted(tmp_path: Path) -> None:
    assert reported(tmp_path, SOME, near=0.21) == []


BAD = [
    (
        '<disable_collisions link1="base" link2="hand" reason="Adjacent"/>',
        naming("base", "hand", "adjacent"),
    ),
]
GOOD = [
    '<disable_collisions link1="base" link2="arm" reason="Adjacent"/>',
    '<disable_collisions link1="arm" link2="finger" reason="Adjacent"/>',
    '<disable_collisions link1="base" link2="hand" reason="Never"/>',
]


@pytest.mark.parametrize(("text", "message"), BAD)
def test_it_is_reported_in_the_srdf(tmp_path: Path, text: str, message: str) -> None:
    assert message_of(tmp_path, text, "SRD010") == message


@pytest.mark.parametrize("text", GOOD)
def test_valid_configuration_is_accepted(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD010") == []


def test_links_around_a_link_without_geometry_are_adjacent(tmp_path: Path) -> None:
    """The Setup Assistant removes such links, and connects their neighbours."""
    body = '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
    links = "".join(f'<link name="leg{number}">{body}</link>' for number in (1, 2))
    joints = "".join(
        f'<joint name="j{number}" type="continuous"><parent link="base"/>'
        f'<child link="leg{number}"/></joint>'
        for number in (1, 2)
    )
    (tmp_path / "r.urdf").write_text(f'<robot name="r"><link name="base"/>{links}{joints}</robot>')
    pair = '<disable_collisions link1="leg1" link2="leg2" reason="Adjacent"/>'
    (tmp_path / "r.srdf").write_text(f'<robot name="r">{pair}</robot>')
    assert check(tmp_path / "r.urdf", select=["SRD010"]).diagnostics == ()
