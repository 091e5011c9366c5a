"""LAU038: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported


@pytest.mark.parametrize(
    ("plugin", "help"),
    [("image_proc/RectifyNode", "write image_proc::RectifyNode"), ("image_proc::RectifyNode", "")],
)
def test_a_class(tmp_path: Path, plugin: str, help: str) -> None:
    """More of them, and containers: ``tests/ros/launch/test_python_calls.py``."""
    element = f'<composable_node pkg="image_proc" plugin="{plugin}"/>'
    text = f'<node_container pkg="r" exec="c" name="n" namespace="">{element}</node_container>'
    found = reported(tmp_path, "LAU038", "a.launch.xml", text)
    assert [(one.span.text, one.help) for one in found] == [(plugin, help)] * bool(help)
