"""LAU040: see the rule."""

from pathlib import Path

import pytest

from tests.checks.bringup import nav2
from tests.launched import reported

NODE = """import os
from ament_index_python.packages import get_package_share_directory
from launch_ros.actions import Node

tree = {"default_nav_to_pose_bt_xml": os.path.join(get_package_share_directory("arm"), "a.xml")}
nodes = [
    Node(package="nav2_bt_navigator", executable="bt_navigator", parameters=["../a.yaml", tree]),
]
"""
GOOD = """\
<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <RecoveryNode number_of_retries="6" name="Recover">
      <RateController hz="1.0">
        <ComputePathToPose goal="{goal}" path="{path}" _skipIf="x"/>
      </RateController>
      <SubTree ID="Back"/>
    </RecoveryNode>
  </BehaviorTree>
  <BehaviorTree ID="Back"><Action ID="Spin" spin_dist="1.57"/></BehaviorTree>
</root>
"""


MODEL = '<TreeNodesModel><Action ID="ComputeIt"/></TreeNodesModel>'
#: A tree of another program.
OTHER = GOOD.replace("PathToPose", "It").replace("RateController", "Inverter")
OTHER = OTHER.replace("RecoveryNode", "Sequence").replace("Spin", "Go")


def of_tree(directory: Path, tree: str, libraries: str = "[]") -> list[tuple[int, str]]:
    yaml = f"bt_navigator: {{ros__parameters: {{plugin_lib_names: {libraries}}}}}\n"
    files = {"a.yaml": yaml, "a.xml": tree}
    found = reported(directory / "arm", "LAU040", "a.launch.py", NODE, files)
    return [(one.span.line, one.message) for one in found]


@pytest.mark.parametrize(
    ("old", "new", "line", "words"),
    [
        ("ComputePathToPose goal", "ComputePathToPos goal", 5, "'ComputePathToPose'?"),
        ("ComputePathToPose goal", "PlanSomething goal", 5, "unknown node 'PlanSomething'"),
        ("spin_dist", "spin_distance", 10, "no port 'spin_distance'; did you mean 'spin_dist'?"),
        ('="Main">\n', '="Mein">\n', 1, "'Mein'; did you mean 'Main'?"),
        ('<SubTree ID="Back"/>', "", 3, "RecoveryNode has 1 children, must have 2"),
        ("</RateController>", "<Wait/></RateController>", 4, "2 children, must have 1"),
        ("</RateController>", "", 4, "does not read the tree"),
    ],
)
def test_a_tree_that_is_not_loaded(
    tmp_path: Path, old: str, new: str, line: int, words: str
) -> None:
    tree = GOOD.replace(old, new, 1)
    ((place, message),) = of_tree(tmp_path, tree)
    assert words in message
    assert place == line


@pytest.mark.parametrize(
    ("tree", "libraries"),
    [
        (GOOD, "[]"),
        (GOOD.replace("ComputePathToPose", "PlanSomething"), "[my_bt_node]"),
        (GOOD.replace("PathToPose", "It").replace("</root>", f"{MODEL}</root>"), "[]"),
        (OTHER, "[]"),
    ],
)
def test_a_tree_that_may_be_loaded(tmp_path: Path, tree: str, libraries: str) -> None:
    assert of_tree(tmp_path, tree, libraries) == []


def test_a_tree_in_the_parameters(tmp_path: Path) -> None:
    path = "$(find-pkg-share arm)/trees/b.xml"
    text = NODE.replace(", tree]", "]").replace("a.xml", "b")
    yaml = f"bt_navigator: {{ros__parameters: {{default_nav_to_pose_bt_xml: '{path}'}}}}\n"
    files = {"a.yaml": yaml, "trees/b.xml": GOOD.replace("spin_dist", "angle")}
    (found,) = reported(tmp_path / "arm", "LAU040", "a.launch.py", text, files)
    assert "no port 'angle'" in found.message


@pytest.mark.parametrize(("node", "count"), [("Wait", 1), ("DriveOnHeadng", 1), ("GraspTheCup", 0)])
def test_a_tree_without_a_navigator(tmp_path: Path, node: str, count: int) -> None:
    """A mission has nodes of its own, and another NavigateToPose than Nav2's."""
    text = NODE.replace("nav2_bt_navigator", "arm").replace("bt_navigator", "mission")
    tree = GOOD.replace("Spin", node).replace("spin_dist", "phase")
    found = reported(tmp_path / "arm", "LAU040", "a.launch.py", text, {"a.xml": tree})
    assert len(found) == count


NAVIGATOR = "bt_navigator: {{ros__parameters: {{default_nav_to_pose_bt_xml: {}}}}}\n"


@pytest.mark.parametrize(
    ("yaml", "words"),
    [
        (NAVIGATOR.format("tree.xml"), "find 'tree.xml'"),
        (NAVIGATOR.format("/opt/tree.xml"), ""),
        (NAVIGATOR.format("$(find-pkg-share a)/tree.xml"), ""),
        (NAVIGATOR.format("REPLACED"), ""),
    ],
)
def test_paths_of_trees(tmp_path: Path, yaml: str, words: str) -> None:
    found = nav2.messages("LAU040", tmp_path, yaml)
    assert [words in one for one in found] == [True] * bool(words)
