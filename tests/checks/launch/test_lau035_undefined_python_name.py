"""LAU035: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming


@pytest.mark.parametrize(("imported", "count"), [("TimerAction", 0), ("TimeAction", 1)])
def test_an_import(tmp_path: Path, imported: str, count: int) -> None:
    """More of them: ``tests/ros/launch/test_python_names.py``."""
    text = f"from launch.actions import {imported}\n"
    text += "from launch import LaunchDescription\nLaunchDescription([])\n"
    found = reported(tmp_path, "LAU035", "a.launch.py", text)
    message = naming("launch.actions", "TimeAction")
    assert [(one.message, one.help) for one in found] == [(message, "write TimerAction")] * count
