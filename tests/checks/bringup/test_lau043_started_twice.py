"""LAU043: see the rule; servers and models: ``test_topics_of_programs.py``."""

from pathlib import Path

import pytest

from tests.checks.bringup.test_lau021_published_twice import CONTROLLERS, ROBOT, SPAWNER
from tests.launched import reported
from tests.naming import naming


@pytest.mark.parametrize(
    ("text", "claimed"),
    [
        (SPAWNER.format("['a', 'c']", ""), "'a' and 'c'"),
        (SPAWNER.format("['a']", "") + SPAWNER.format("['c']", ""), "'a' and 'c'"),
        (SPAWNER.format("['a', 'b']", ""), ""),  # position and velocity
        (SPAWNER.format("['a']", "") + SPAWNER.format("['c', '-c', '/other/manager']", ""), ""),
        (SPAWNER.format("['a']", "") + SPAWNER.format("['c', '--inactive']", ""), ""),
        (
            SPAWNER.format("['a']", "")
            + SPAWNER.format("['c']", ", condition=IfCondition(LaunchConfiguration('x'))"),
            "",
        ),
    ],
)
def test_claims(tmp_path: Path, text: str, claimed: str) -> None:
    robot = f"open('{tmp_path}/r.urdf')\n"
    manager = "Node(package='controller_manager', executable='ros2_control_node', "
    manager += f"parameters=['{tmp_path}/c.yaml'])\n"
    files = {"r.urdf": ROBOT, "c.yaml": CONTROLLERS}
    found = reported(tmp_path, "LAU043", "a.launch.py", robot + manager + text, files)
    messages = [one.message for one in found]
    assert [claimed in one and "'position' of joint 'j2'" in one for one in messages] == (
        [True] if claimed else []
    )


def test_claims_in_ros_1(tmp_path: Path) -> None:
    """Each joint has a controller, and one of them was copied."""
    text = "a: {type: position_controllers/JointPositionController, joint: j1}\n"
    files = {"r.urdf": ROBOT, "c.yaml": text + text.replace("a:", "b:")}
    launch = (
        '<rosparam file="{0}/c.yaml" command="load"/>\n<node name="s" pkg="controller_manager" '
    )
    launch += 'type="spawner" args="a b"/>'
    (found,) = reported(tmp_path, "LAU043", "a.launch", launch.format(tmp_path), files)
    assert found.message == naming("a", "b", "both", "position", "j1")
    assert [(note.span.line, note.span.text) for note in found.related] == [(1, "j1"), (2, "j1")]
