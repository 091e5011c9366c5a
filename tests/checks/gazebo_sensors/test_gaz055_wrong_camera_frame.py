"""GAZ055: see the rule."""

import pytest

from tests.sensing import findings
from urdfkit import check
from urdfkit.text.source import Source

PLUGIN = '<plugin name="p" filename="libgazebo_ros_camera.so"><{0}>{1}</{0}></plugin>'


@pytest.mark.parametrize(
    ("inner", "count"),
    [
        (PLUGIN.format("frameName", "base"), 1),
        (PLUGIN.format("frame_name", "base"), 1),
        (PLUGIN.format("frame_name", "camera_optical_frame"), 0),
        ("<gz_frame_id>base</gz_frame_id>", 1),
        ("<gz_frame_id>tip</gz_frame_id>", 0),
        ("", 0),
    ],
)
def test_a_frame_that_is_the_cameras_own_link_looks_along_x(inner, count):
    assert len(findings("GAZ055", "camera", inner)) == count
    assert findings("GAZ055", "imu", inner) == []


def test_a_link_that_is_called_optical_is_meant():
    inner = PLUGIN.format("frameName", "base_optical")
    assert findings("GAZ055", "camera", inner, reference="base_optical") == []


ROBOT = """<robot name="r"><link name="eye"/><link name="{link}"/>
<joint name="j" type="fixed"><origin rpy="{rpy}"/><parent link="eye"/><child link="{link}"/></joint>
<gazebo reference="{reference}"><sensor name="s" type="camera"><pose>{pose}</pose></sensor></gazebo>
</robot>"""


@pytest.mark.parametrize(
    ("link", "rpy", "reference", "pose", "count"),
    [
        ("eye_optical", "-1.5708 0 -1.5708", "eye_optical", "0 0 0 0 0 0", 1),
        ("eye_optical", "-1.5708 0 -1.5708", "eye_optical", "0 0 0 0 -1.57 1.57", 0),
        ("eye_optical", "-1.5708 0 -1.5708", "eye", "0 0 0 0 0 0", 0),
        ("eye_optical", "0 0 0", "eye_optical", "0 0 0 0 0 0", 0),
        ("eye_frame", "-1.5708 0 -1.5708", "eye_frame", "0 0 0 0 0 0", 0),
    ],
)
def test_a_camera_looks_along_x(link, rpy, reference, pose, count):
    text = ROBOT.format(link=link, rpy=rpy, reference=reference, pose=pose)
    report = check(Source("r.urdf", text.encode()), select=["GAZ055"])
    assert len(report.diagnostics) == count
