"""JNT016: multipliers of mimic plugins."""

import pytest

from tests.gazebos import plugin
from tests.jointed import joint, limit, mimic, robot
from tests.naming import naming
from tests.reported import messages, places
from urdfkit.lint.rule_examples import whole_robot

LIBRARY = "libroboticsgroup_gazebo_mimic_joint_plugin.so"


def hand(tags: str) -> str:
    return robot(
        joint("index", "revolute", limit("0", "1")),
        joint("tip", "revolute", limit("0", "1.5") + mimic("index", 'multiplier="1.5"')),
    ) + plugin(LIBRARY, tags)


TAGS = "<joint>index</joint>\n<mimicJoint>tip</mimicJoint>\n<multiplier>{}</multiplier>"


def test_another_multiplier_in_gazebo() -> None:
    text = hand(TAGS.format("1.2"))
    assert messages("JNT016", text) == [naming("p", "tip", "1.2", "index", "<mimic>", "1.5")]
    ((line, _),) = places("JNT016", text)
    assert "<multiplier>1.2<" in whole_robot(text).splitlines()[line - 1]


@pytest.mark.parametrize(
    "tags",
    [
        TAGS.format("1.5"),
        TAGS.format("1.501"),
        TAGS.format("x"),
        TAGS.format("1.2").replace(">index<", ">other<"),
        TAGS.format("1.2").replace(">tip<", ">index<"),
        "<joint>index</joint><mimicJoint>tip</mimicJoint>",
        TAGS.format("-0.8") + "<offset>0.8</offset>",  # a NAO's fingers: another function
    ],
)
def test_no_finding(tags: str) -> None:
    assert messages("JNT016", hand(tags)) == []
