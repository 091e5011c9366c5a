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


def test_other_sensors_are_others_business():
    assert findings("GAZ052", "imu", reference="wrist") == []
