from __future__ import annotations

from tests.reported import fixed, messages, places, reported

ROBOT = """\
<link name="hand"/>
<link name="finger"/>
<joint name="finger_joint" type="continuous">
  <parent link="hand"/>
  <child link="finger"/>
  <mimic joint="{}"/>
</joint>"""


def test_an_unknown_leader_is_told() -> None:
    robot = ROBOT.format("thumb")
    assert messages("REF004", robot) == [
        "joint 'finger_joint' mimics 'thumb', which is not in the model"
    ]
    assert places("REF004", robot) == [(7, "thumb")]
    assert reported("REF004", robot)[0].fix is None


def test_a_link_is_no_joint() -> None:
    assert len(reported("REF004", ROBOT.format("hand"))) == 1


def test_the_nearest_joint_is_offered() -> None:
    assert '<mimic joint="finger_joint"/>' in fixed("REF004", ROBOT.format("finger_jiont"))


def test_a_joint_that_is_there_is_left_to_other_rules() -> None:
    assert reported("REF004", ROBOT.format("finger_joint")) == []  # itself: JNT015
    assert reported("REF004", ROBOT.replace(' joint="{}"', "")) == []  # URD003
