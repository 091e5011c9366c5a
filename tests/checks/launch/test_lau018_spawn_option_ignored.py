"""LAU018: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported

CREATE = "Node(package='ros_gz_sim', executable='create', arguments=['-topic', 't', {}])"


@pytest.mark.parametrize(
    ("words", "message", "help"),
    [
        ("'-entity', 'r'", "create passes over '-entity'", "write -name"),
        ("'-nam', 'r'", "create passes over '-nam'; did you mean 'name'?", "remove it"),
    ],
)
def test_an_option_that_it_lacks(tmp_path: Path, words: str, message: str, help: str) -> None:
    (found,) = reported(tmp_path, "LAU018", "a.launch.py", CREATE.format(words))
    assert (found.message, found.help) == (message, help)


@pytest.mark.parametrize(
    "node",
    [
        CREATE.format("'-name', 'r', '-allow-renaming', 'true', '-z', '-1'"),
        CREATE.format("*more"),
        CREATE.format("'-entity', 'r'").replace("ros_gz_sim", "acme"),
        "Node(package='gazebo_ros', executable='spawn_entity.py', arguments=['-name', 'r'])",
    ],
)
def test_known_or_of_others_is_calm(tmp_path: Path, node: str) -> None:
    assert reported(tmp_path, "LAU018", "a.launch.py", node) == []
