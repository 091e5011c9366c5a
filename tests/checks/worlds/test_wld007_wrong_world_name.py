"""WLD007: see the rule."""

from pathlib import Path

import pytest

from tests.checks.worlds.started import (
    INCLUDE,
    findings,
    messages,
    only_finding,
)
from tests.workspaces import add_file
from urdfkit import Severity

CODE = "WLD007"
SPAWN = '\nNode(package="ros_gz_sim", executable="create", arguments=["-topic", "r", {}])\n'


@pytest.mark.parametrize(
    "argument", ['"-world", "halle"', '"-world=default"', '"--world", "empty"']
)
def test_spawned_into_another_world(argument: str, tmp_path: Path) -> None:
    reported = only_finding(tmp_path, CODE, world="", launch=INCLUDE + SPAWN.format(argument))
    assert "'hall' is started" in reported.message
    same = SPAWN.format('"-world", "hall"')
    assert messages(tmp_path, CODE, world="", launch=INCLUDE + same) == []
    assert messages(tmp_path, CODE, world="", launch=INCLUDE + SPAWN.format("")) == []


@pytest.mark.parametrize(("name", "count"), [("hall", 0), ("empty", 1)])
def test_topics_of_another_world(tmp_path: Path, name: str, count: int) -> None:
    topic = f"/world/{name}/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"
    bridge = (
        f'\nNode(package="ros_gz_bridge", executable="parameter_bridge", arguments=["{topic}"])'
    )
    found = findings(tmp_path, CODE, world="", launch=INCLUDE + bridge)
    assert ["'empty', but world 'hall'" in each.message for each in found] == [True] * count
    assert [each.severity for each in found] == [Severity.WARNING] * count  # another may be given


@pytest.mark.parametrize(("is_file", "help"), [(True, "name the started"), (False, "write /world")])
def test_a_file_of_topics_that_launch_files_share(tmp_path: Path, is_file: bool, help: str) -> None:
    """OriginBot: one launch file starts the world that the topics name, two start others."""
    entry = "- {ros_topic_name: a, gz_topic_name: /world/empty/clock, "
    entry += "ros_type_name: rosgraph_msgs/msg/Clock, gz_type_name: gz.msgs.Clock}\n"
    add_file(tmp_path / "b.yaml", entry)
    words = "'/world/empty/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock'"
    given = (
        f"parameters=[{{'config_file': '{tmp_path}/b.yaml'}}]"
        if is_file
        else f"arguments=[{words}]"
    )
    bridge = f'\nNode(package="ros_gz_bridge", executable="parameter_bridge", {given})'
    (found,) = findings(tmp_path, CODE, world="", launch=INCLUDE + bridge)
    assert found.help.startswith(help)
