"""LAU009: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported

OF_ROS_2 = '<let name="x" value="$(var x)"/><push_ros_namespace namespace="n"/>'


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('<node pkg="a" name="b" ns="$(arg n)"/>', "<node> has no type"),
        ('<node pkg="a" type="b" ns="$(arg n)"/>', "<node> has no name"),
        ('<include ns="$(arg n)"/>', "<include> has no file"),
        (OF_ROS_2 + '<node pkg="a" name="b"/>', "<node> has no exec"),
        (OF_ROS_2 + "<executable/>", "<executable> has no cmd"),
    ],
)
def test_what_launch_needs(tmp_path: Path, text: str, message: str) -> None:
    (found,) = reported(tmp_path, "LAU009", "a.launch", text)
    assert (found.message, found.span.line) == (message, 2)


@pytest.mark.parametrize(
    "text",
    [
        '<node pkg="a" type="b" name="c" ns="$(arg n)"/>',
        '<node pkg="a" tpye="b" name="c" ns="$(arg n)"/>',  # which LAU010 tells
        OF_ROS_2 + '<node pkg="a" exec="b"/>',
        '<node pkg="a"/>',  # of either ROS
    ],
)
def test_whole_or_unclear_is_calm(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU009", "a.launch", text) == []
