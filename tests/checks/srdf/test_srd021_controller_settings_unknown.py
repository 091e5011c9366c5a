"""SRD021: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings

TWO = """\
moveit_simple_controller_manager:
  controller_names: [arm_controller]
  arm_controller:
    type: FollowJointTrajectory
    joints: [shoulder, wrist, knuckle]
"""
ONE = "controller_list:\n  - name: arm_controller\n    joints: [shoulder, wrist, knuckle]\n"


@pytest.mark.parametrize(
    ("file", "text", "old", "new", "line"),
    [
        ("moveit_controllers.yaml", TWO, "wrist", "wrsit", 5),
        ("simple_moveit_controllers.yaml", ONE, "wrist", "wrsit", 3),
        ("moveit_controllers.yaml", TWO, "[arm_controller]", "[arm_controler]", 2),
        ("initial_positions.yaml", "initial_positions:\n  shoulder: 0\n", "should", "shuold", 2),
    ],
)
def test_names_that_nobody_has(
    tmp_path: Path, file: str, text: str, old: str, new: str, line: int
) -> None:
    (tmp_path / file).write_text(text)
    assert findings(tmp_path, "", "SRD021") == []
    (tmp_path / file).write_text(text.replace(old, new))
    (found,) = findings(tmp_path, "", "SRD021")
    assert (Path(found.span.source.path).name, found.span.line) == (file, line)
    assert "did you mean" in found.message


@pytest.mark.parametrize(
    ("old", "new"),
    [("shoulder, wrist", "a, b"), ("wrist", "$(arg wrist)"), ("joints: [", "joints: 3 # ")],
)
def test_what_is_of_others_or_open_is_calm(tmp_path: Path, old: str, new: str) -> None:
    (tmp_path / "moveit_controllers.yaml").write_text(TWO.replace(old, new))
    assert findings(tmp_path, "", "SRD021") == []
