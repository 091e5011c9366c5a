"""Remappings of a node in its command line."""

from collections.abc import Mapping

import pytest

from urdfkit.ros.launch.contents import with_words


@pytest.mark.parametrize(
    ("words", "is_ros_2", "remapped"),
    [
        (
            ["--ros-args", "-r", "a:=b", "--remap", "node:c:=d"],
            True,
            {"x": "y", "a": "b", "c": "d"},
        ),
        (["--ros-args", "-p", "a:=b", "-r", "__ns:=/n"], True, {"x": "y"}),
        (["-r", "a:=b"], True, {"x": "y"}),
        (["--ros-args", "-r", None], True, None),
        (["a:=b", "_rate:=5", "__name:=n", "-x", None], False, {"x": "y", "a": "b"}),
    ],
)
def test_a_command_line(
    words: list[str | None], is_ros_2: bool, remapped: Mapping[str, str] | None
) -> None:
    assert with_words({"x": "y"}, words, is_ros_2=is_ros_2) == remapped
    assert with_words(None, words, is_ros_2=is_ros_2) is None
