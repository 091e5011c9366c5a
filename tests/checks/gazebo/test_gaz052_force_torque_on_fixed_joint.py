"""GAZ052: see the rule."""

import pytest

from tests.sensing import findings

KEEP = "<{0}>true</{0}>"


def test_a_merged_joint_has_no_sensor():
    (finding,) = findings("GAZ052", "force_torque", reference="wrist")
    assert finding.message == "sensor 's' is on joint 'wrist', which Gazebo merges"


@pytest.mark.parametrize("tag", ["preserveFixedJoint", "disableFixedJointLumping"])
def test_a_joint_that_is_kept_has_one(tag):
    assert findings("GAZ052", "force_torque", reference="wrist", beside=KEEP.format(tag)) == []


@pytest.mark.parametrize(("text", "count"), [("true", 1), ("yes", 1), ("false", 0)])
def test_feedback_of_a_merged_joint(text, count):
    wish = f"<provideFeedback>{text}</provideFeedback>"
    found = findings("GAZ052", "imu", reference="wrist", beside=wish)
    assert [finding.span.text for finding in found] == ["<provideFeedback>"] * count


def test_one_joint_is_told_once():
    wish = "<provideFeedback>true</provideFeedback>"
    assert len(findings("GAZ052", "force_torque", reference="wrist", beside=wish)) == 1


def test_the_old_form_keeps_a_joint():
    keep = '<preserveFixedJoint value="true"/>'
    assert findings("GAZ052", "force_torque", reference="wrist", beside=keep) == []


def test_other_sensors_are_others_business():
    assert findings("GAZ052", "imu", reference="wrist") == []
