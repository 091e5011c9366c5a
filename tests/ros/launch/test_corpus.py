"""The launch files of real robots: what is reported of each, all read by hand."""

from collections import Counter
from pathlib import Path

import pytest

from tests.conftest import CORPUS, needs_corpus
from urdfkit import check

pytestmark = needs_corpus

FILES = sorted(
    file for ending in ("*.launch", "*.launch.py", "*.launch.xml") for file in CORPUS.rglob(ending)
)
#: Configurations of RViz and worlds that the corpus leaves out, an argument that husky's launch
#: file has lost, and the executable ``state_publisher``, which ROS Noetic no longer has.
FOUND: dict[str, dict[str, int]] = {
    "anymal_c_simple_description/launch/standalone.launch": {"LAU003": 1},
    "gazebo_ros_demos/rrbot_description/launch/rrbot_rviz.launch": {"LAU003": 2},
    "gazebo_ros_demos/rrbot_gazebo/launch/rrbot_world.launch": {"LAU003": 1},
    "husky/husky_gazebo/launch/playpen.launch": {"LAU003": 1},
    "husky/husky_gazebo/launch/multi_husky_playpen.launch": {"LAU005": 3},
    "nao_robot/nao_description/launch/display.launch": {"LAU003": 1},
    "nao_robot/nao_description/launch/robot_state_publisher.launch": {"LAU003": 1},
    "urdf_tutorial/launch/display.launch": {"LAU003": 1},
}


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.relative_to(CORPUS).as_posix())
def test_findings(file: Path) -> None:
    report = check(file, select=["LAU"])
    assert report.crashed == ()
    found = Counter(diagnostic.code for diagnostic in report.diagnostics)
    assert found == FOUND.get(file.relative_to(CORPUS).as_posix(), {})
