"""LAU044: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.launched import reported

NODE = """from launch_ros.actions import Node

nodes = [Node(package="joy", executable="joy_node", name="joy_node", parameters=["../a.yaml"])]
"""
GOOD = "joy_node:\n  ros__parameters:\n    deadzone: 0.1\n"


def rejected(directory: Path, yaml: str, text: str = NODE) -> list[tuple[int, str]]:
    found = reported(directory / "arm", "LAU044", "a.launch.py", text, {"a.yaml": yaml})
    return [(one.span.line, one.message.partition(": ")[2]) for one in found if one.span]


@pytest.mark.parametrize(
    ("yaml", "line", "words"),
    [
        ("deadzone: 0.1\n", 1, "'deadzone' is not below"),
        (f"{GOOD}   rate: 1.0\n", 4, ""),
        ("joy_node:\n  deadzone: 0.1\n", 2, "'deadzone' is not below"),
        ("joy_node:\n  ros_parameters:\n    deadzone: 0.1\n", 2, "but 'ros_parameters'"),
        ("joy_node:\n  ros__parameters:\n  deadzone: 0.1\n", 2, "has no values"),
        ("ros__parameters:\n  deadzone: 0.1\n", 1, "not below the name of a node"),
        (f"{GOOD}other:\n  rate: 1.0\n", 5, "'rate' is not below"),
        (f"{GOOD}    own:\n", 4, "'own' has no value"),
        (f"{GOOD}    own: [1, 0.5]\n", 4, "1 is an integer"),
        (f"{GOOD}    own: [0.5, 1]\n", 4, "1 is an integer"),
        (f"{GOOD}    own: [a, yes]\n", 4, "mixes types"),
        (f"{GOOD}    own: [0.1, map]\n", 4, "map is a string"),
        (f"{GOOD}    own: [{{name: a}}]\n", 4, ""),
        (f"{GOOD}    own: [[1, 2], [3, 4]]\n", 4, "list of lists"),
        (f"{GOOD}    own: [{{names: [a]}}, {{names: [b]}}]\n", 4, ""),
        (f"{GOOD}    own: [{{names: [a], rate: [1, 0.5]}}]\n", 4, "'rate' mixes types"),
    ],
)
def test_the_place(tmp_path: Path, yaml: str, line: int, words: str) -> None:
    ((place, message),) = rejected(tmp_path, yaml)
    assert place == line
    assert words in message


@pytest.mark.parametrize(
    "own",
    [
        'own: ""',
        "own: null",
        "own: []",
        "own: [1, 2]",
        "own: [[1, 2]]",  # read as a flat list
        "own: [0.5, 1.0]",
        'own: ["1", a]',
        "own: [$(var a), 1]",
        "own: {inner: [1]}",
        "own: [{names: [a], rate: 1}]",  # so the documentation of gpio_controllers writes it
    ],
)
def test_sound_values(tmp_path: Path, own: str) -> None:
    assert rejected(tmp_path, f"{GOOD}    {own}\n") == []


def test_files_that_are_written_anew(tmp_path: Path) -> None:
    """RewrittenYaml of Nav2 writes null for an empty value, but keeps lists as they are."""
    text = f"from nav2_common.launch import RewrittenYaml\n{NODE}"
    yaml = f"{GOOD}    own:\n    other: [1, 0.5]\n"
    assert [line for line, _ in rejected(tmp_path, yaml, text)] == [5]
