"""SRD020: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings

GROUPS = (
    '<group name="arm"><link name="arm"/></group><group name="hand"><link name="hand"/></group>'
)
SOLVER = "{}:\n  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n"


@pytest.mark.parametrize("place", [".", "config"])
def test_a_solver_for_no_group(tmp_path: Path, place: str) -> None:
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "srdf").mkdir()
    folder = tmp_path / place
    folder.mkdir(exist_ok=True)
    (folder / "kinematics.yaml").write_text(SOLVER.format("arm") + SOLVER.format("hnad"))
    robot = tmp_path if place == "." else tmp_path / "srdf"
    (found,) = findings(robot, GROUPS, "SRD020")
    assert found.message == "the SRDF has no group 'hnad'; did you mean 'hand'?"
    assert (found.span.line, found.span.text) == (3, "hnad")


@pytest.mark.parametrize(
    "text",
    [
        "planner_configs:\n  RRT: {type: geometric::RRT}\nmanipulator:\n  planner_configs: [RRT]",
        "manipulator:\n  default_planner_config: RRT",
    ],
)
def test_planners_for_no_group(tmp_path: Path, text: str) -> None:
    (tmp_path / "ompl_planning.yaml").write_text(text)
    (found,) = findings(tmp_path, GROUPS, "SRD020")
    assert found.span.text == "manipulator"


@pytest.mark.parametrize(
    "text",
    [
        SOLVER.format("arm"),
        SOLVER.format("$(arg arm)"),
        SOLVER.format("left") + SOLVER.format("right"),  # of another robot
        "other: 3",
        "arm: [",
    ],
)
def test_what_is_known_or_of_others_is_calm(tmp_path: Path, text: str) -> None:
    (tmp_path / "kinematics.yaml").write_text(text)
    assert findings(tmp_path, GROUPS, "SRD020") == []
