"""LAU010: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported

ROS_1 = '<rosparam file="$(find a)/b.yaml"/>\n'
ROS_2 = '<let name="x" value="$(var x)"/>\n'


@pytest.mark.parametrize(
    ("text", "word", "help"),
    [
        (ROS_1 + '<node pkg="a" tpye="b" name="c"/>', "b", "did you mean type?"),
        (ROS_1 + '<node pkg="a" exec="b" name="c"/>', "b", "did you mean type?"),
        (ROS_1 + '<nod pkg="a"/>', '<nod pkg="a"/>', "did you mean <node>?"),
        (ROS_2 + '<node pkg="a" type="b"/>', "b", "did you mean exec?"),
        (ROS_2 + '<node pkg="a" exec="b" ns="c"/>', "c", "did you mean namespace?"),
    ],
)
def test_it_is_told_with_what_was_meant(tmp_path: Path, text: str, word: str, help: str) -> None:
    (found,) = reported(tmp_path, "LAU010", "a.launch", text)
    assert (found.span.line, found.span.text, found.help) == (3, word, help)


@pytest.mark.parametrize(
    "text",
    [
        ROS_1 + '<node pkg="a" type="b" name="c" respawn="true" rosmon-memory-limit="1"/>',
        ROS_2 + '<node pkg="a" exec="b" if="$(var x)" ros_args="--log-level info"/>',
        ROS_2 + '<group scoped="false"><set_env name="A" value="b"/></group>',
        ROS_2 + "<autoware_thing/>",
    ],
)
def test_what_launch_knows_is_calm(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU010", "a.launch", text) == []


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('<rosparam command="loads" file="$(arg f)"/>', "<rosparam>: command is 'loads'"),
        ('<node pkg="a" type="b" name="$(anon c)" output="scren"/>', "<node>: output is 'scren'"),
    ],
)
def test_words_that_an_attribute_cannot_be(tmp_path: Path, text: str, message: str) -> None:
    (found,) = reported(tmp_path, "LAU010", "a.launch", text)
    assert found.message == message
