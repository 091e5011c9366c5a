"""SRD010: see the rule."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("coal")

from tests.physics.collision.robots import joint, link, revolute, sphere
from urdfkit import Diagnostic, check
from urdfkit.lint.rule_examples import whole_robot


def reported(folder: Path, matrix: str, *, near: float = 0.15) -> list[Diagnostic]:
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
    (folder / "r.urdf").write_text(robot)
    (folder / "r.srdf").write_text(f'<robot name="example">\n{matrix}\n</robot>\n')
    return list(check(folder / "r.urdf", select=["SRD010"]).diagnostics)


SOME = '<disable_collisions link1="base" link2="arm" reason="Adjacent"/>'
ALL = f'{SOME}<disable_collisions link1="hand" link2="arm" reason="Adjacent"/>'


def test_the_pair_and_the_depth(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, SOME)
    assert found.message == (
        "'arm' and 'hand' are held together and overlap by 50 mm, but their collisions are not "
        "disabled"
    )
    assert found.span.source.path == str(tmp_path / "r.srdf")


@pytest.mark.parametrize("matrix", [ALL, "", f'{SOME}<disable_default_collisions link="arm"/>'])
def test_a_pair_that_is_disabled_and_no_matrix_at_all(tmp_path: Path, matrix: str) -> None:
    assert reported(tmp_path, matrix) == []


def test_what_does_not_overlap_is_no_matter(tmp_path: Path) -> None:
    assert reported(tmp_path, SOME, near=0.21) == []
