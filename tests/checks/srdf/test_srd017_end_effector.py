"""SRD017: the groups of an end effector."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.srdfs import findings, message_of
from urdfkit.text.diagnostic import Severity

BAD = [
    (
        (
            '<group name="a"><link name="base"/><link name="arm"/></group><group name="h">'
            '<link name="arm"/></group>'
            '<end_effector name="e" group="h" parent_link="base" parent_group="a"/>'
        ),
        naming("e", "a", "arm"),
    ),
    (
        (
            '<group name="h"><link name="arm"/></group>'
            '<end_effector name="e" group="h" parent_link="arm"/>'
        ),
        naming("e", "arm", "own"),
    ),
    (  # OpenArm: a frame behind the flange
        (
            '<group name="a"><link name="hand"/></group><group name="h"><link name="arm"/></group>'
            '<end_effector name="e" group="h" parent_link="base" parent_group="a"/>'
        ),
        naming("e", "base", "a"),
    ),
    (  # Kawasaki's arms: one finding for the shared link, to which the effector is attached
        (
            '<group name="a"><link name="base"/><link name="arm"/></group><group name="h">'
            '<link name="arm"/></group>'
            '<end_effector name="e" group="h" parent_link="arm" parent_group="a"/>'
        ),
        naming("e", "a", "arm"),
    ),
]
GOOD = [
    (
        '<group name="a"><chain base_link="base" tip_link="arm"/></group>'
        '<group name="h"><link name="hand"/></group>'
        '<end_effector name="e" group="h" parent_link="arm" parent_group="a"/>'
    ),
    (  # MoveIt finds the parent group itself
        '<group name="a"><link name="hand"/></group><group name="h"><link name="arm"/></group>'
        '<end_effector name="e" group="h" parent_link="base"/>'
    ),
    (  # KUKA's iiwa: a group of the tip for moveit_visual_tools
        '<group name="a"><chain base_link="base" tip_link="hand"/></group>'
        '<group name="h"><link name="hand"/></group>'
        '<end_effector name="e" group="h" parent_link="hand" parent_group="a"/>'
    ),
]


@pytest.mark.parametrize(("text", "message"), BAD)
def test_it_is_reported_in_the_srdf(tmp_path: Path, text: str, message: str) -> None:
    (found,) = findings(tmp_path, text, "SRD017")
    assert found.severity is Severity.WARNING  # MoveIt loads the robot
    assert message_of(tmp_path, text, "SRD017") == message


@pytest.mark.parametrize("text", GOOD)
def test_valid_configuration_is_accepted(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD017") == []
