from __future__ import annotations

import pytest

from tests.gazebos import BASE, block
from tests.reported import fixed, messages, reported
from urdfkit.ros.catalog.extensions import extensions, suggested


@pytest.mark.parametrize(("wrong", "right"), [*suggested().items(), ("selfcollide", "selfCollide")])
def test_slips_are_mended(wrong: str, right: str) -> None:
    text = BASE + block(f"<{wrong}>1</{wrong}>")
    assert messages("GAZ003", text) == [f"Gazebo knows no <{wrong}>, and ignores it"]
    assert f"<{right}>1</{right}>" in fixed("GAZ003", text)


def test_one_finding_for_a_name_that_nothing_is_like() -> None:
    assert messages("GAZ003", BASE + block("<stopKp>1</stopKp>")) == [
        "Gazebo knows no <stopKp>, and ignores it"
    ]
    text = BASE + block("<stopKp>1</stopKp>") + block("<stopKp>2</stopKp>")
    (found,) = reported("GAZ003", text)
    assert found.message == "Gazebo knows no <stopKp>, and ignores it (2 times)"
    assert [note.span.text for note in found.related] == ["<stopKp>"]
    assert found.fix is None
    (found,) = reported("GAZ003", BASE + 9 * block("<stopKp>1</stopKp>"))
    assert found.message.endswith("(9 times)")
    assert len(found.related) == 4


@pytest.mark.parametrize("tag", [*extensions(), "gravity", "sensor", "plugin", "vendor:tag"])
def test_known_tags(tag: str) -> None:
    assert reported("GAZ003", BASE + block(f"<{tag}>1</{tag}>")) == []


def test_what_belongs_into_the_robot_is_told_so() -> None:
    hardware = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    control = block(f'<ros2_control name="c" type="system">{hardware}</ros2_control>', "")
    (found,) = reported("GAZ003", BASE + control)
    assert found.help == "move <ros2_control> out of the <gazebo>, into <robot>"
    assert messages("GAZ010", BASE + control) == []
