from __future__ import annotations

import pytest

from tests.gazebos import BASE, plugin
from tests.reported import messages, reported

DRIVE = "libgazebo_ros_diff_drive.so"
IMU = "libgazebo_ros_imu.so"


@pytest.mark.parametrize(
    ("file", "tag", "message"),
    [
        (DRIVE, "<wheelDiameter>0,2</wheelDiameter>", "<wheelDiameter> is '0,2', which reads as 0"),
        (DRIVE, "<wheelDiameter>big</wheelDiameter>", "<wheelDiameter> is 'big', and no number"),
        (DRIVE, "<wheelDiameter/>", "<wheelDiameter> is empty, and no number"),
        (DRIVE, "<publishTf>yes</publishTf>", "<publishTf> is 'yes', which reads as false"),
        (DRIVE, "<publishTf>1.0</publishTf>", "<publishTf> is '1.0', which reads as false"),
        (
            DRIVE,
            "<wheelDiameter>20 cm</wheelDiameter>",
            "<wheelDiameter> is '20 cm', which reads as 20",
        ),
        (
            DRIVE,
            "<odometrySource>encoders</odometrySource>",
            "<odometrySource> is 'encoders', and must be encoder or world; did you mean 'encoder'?",
        ),
        (IMU, "<xyzOffset>0 x 1</xyzOffset>", "<xyzOffset> is '0 x 1', not 3 numbers"),
        (IMU, "<xyzOffset>0,0,0</xyzOffset>", "<xyzOffset> is '0,0,0', not 3 numbers"),
        (IMU, "<xyzOffset>0 0</xyzOffset>", "<xyzOffset> is '0 0', not 3 numbers"),
    ],
)
def test_what_is_read(file: str, tag: str, message: str) -> None:
    assert messages("GAZ019", BASE + plugin(file, tag)) == [f"plugin 'p' ({file}): {message}"]


@pytest.mark.parametrize(("text", "count"), [("cmd_vel=robot/cmd_vel", 1), ("a:=b", 0)])
def test_a_remapping_has_two_names(text: str, count: int) -> None:
    tags = f"<ros><remapping>{text}</remapping></ros><left_joint>a</left_joint>"
    assert len(reported("GAZ019", BASE + plugin(DRIVE, tags))) == count


@pytest.mark.parametrize(
    ("file", "tag"),
    [
        (DRIVE, "<wheelDiameter> 2e-1 </wheelDiameter>"),
        (DRIVE, "<wheelDiameter>.2</wheelDiameter>"),
        (DRIVE, "<wheelDiameter>-2.</wheelDiameter>"),
        (DRIVE, "<wheelDiameter>0.2 m</wheelDiameter>"),  # reads as 0.2
        (DRIVE, "<publishTf>True</publishTf>"),
        (DRIVE, "<publishTf>0</publishTf>"),
        (DRIVE, "<publishTf>no</publishTf>"),
        (IMU, "<xyzOffset>0 0.5 -1e-3</xyzOffset>"),
        # A quaternion is read from roll, pitch and yaw.
        ("libhector_gazebo_ros_imu.so", "<rpyOffset>0 0 -0.7</rpyOffset>"),
        (DRIVE, "<unknown>big</unknown>"),
        ("libvendor.so", "<wheelDiameter>big</wheelDiameter>"),
    ],
)
def test_good_values(file: str, tag: str) -> None:
    assert reported("GAZ019", BASE + plugin(file, tag)) == []
