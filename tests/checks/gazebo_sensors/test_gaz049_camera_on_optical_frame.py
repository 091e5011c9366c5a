"""GAZ049: see the rule."""

import pytest

from urdfkit import check
from urdfkit.text.source import Source

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
    report = check(Source("r.urdf", text.encode()), select=["GAZ049"])
    assert len(report.diagnostics) == count
