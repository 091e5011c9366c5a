"""GEO018: see the rule."""

from __future__ import annotations

from math import pi
from pathlib import Path

import pytest

from tests.reported import messages, places
from urdfkit import check
from urdfkit.mesh.samples import box, stl

BASE = '<link name="base"><visual><geometry><box size="0.4 0.3 0.2"/></geometry></visual></link>\n'
SENSOR = """\
<gazebo reference="NAME"><sensor name="eye" type="TYPE">
  <camera><clip><near>NEAR</near></clip></camera>
  <ray><range><min>NEAR</min></range></ray>
</sensor></gazebo>"""


def mounted(xyz: str, name: str = "laser", rpy: str = "0 0 0", kind: str = "fixed") -> str:
    return (
        f'{BASE}<link name="{name}"/>\n<joint name="mount" type="{kind}"><parent link="base"/>'
        f'<child link="{name}"/><origin xyz="{xyz}" rpy="{rpy}"/></joint>\n'
    )


def simulated(xyz: str, kind: str, near: float = 0.01) -> str:
    block = SENSOR.replace("NAME", "eye_link").replace("TYPE", kind).replace("NEAR", str(near))
    return mounted(xyz, "eye_link") + block


def test_a_lidar_in_the_chassis() -> None:
    message = "link 'laser' is inside link 'base', 0.2 m behind the walls of its visual"
    assert messages("GEO018", mounted("0 0 0")) == [message]
    assert places("GEO018", mounted("0 0 0")) == [(4, '<origin xyz="0 0 0" rpy="0 0 0"/>')]


@pytest.mark.parametrize(
    ("robot", "found"),
    [
        (mounted("0 0 0.12"), 0),  # above it
        (mounted("0 0 0.1"), 0),  # on it
        (mounted("0 0 0.099"), 0),  # as if on it
        (mounted("0 0 0.08"), 1),
        (mounted("0.25 0 0"), 0),  # before it
        (mounted("0 0 0", "front_camera"), 1),
        (mounted("0.18 0 0", "front_camera"), 0),  # its housing is a part of the chassis
        (mounted("0.18 0 0", "front_camera", f"0 0 {pi}"), 0),
        (mounted("0 0 0", "camera_optical_frame"), 0),
        (mounted("0 0 0", "laser_mount"), 0),
        (mounted("0 0 0", "imu_link"), 0),
        (mounted("0 0 0", kind="continuous"), 0),
        (simulated("0 0 0", "gpu_ray"), 1),
        (simulated("0 0 0", "depth_camera"), 1),
        (simulated("0.15 0 0", "camera"), 1),  # 5 cm of wall before its eye
        (simulated("0.15 0 0", "camera", 0.1), 0),  # which it does not see
        (simulated("0 0 0", "gpu_ray", 0.3), 0),
        (simulated("0 0 0", "imu"), 0),
        (mounted("0 0 0").replace("visual", "collision"), 0),
        (simulated("0 0 0", "ray").replace("visual", "collision"), 1),
        (simulated("0 0 0", "camera").replace("visual", "collision"), 0),
    ],
)
def test_where_it_is(robot: str, found: int) -> None:
    assert len(messages("GEO018", robot)) == found


def test_the_joint_that_holds_the_whole_sensor_is_told() -> None:
    robot = mounted("0 0 0", "camera_link") + (
        '<link name="camera_color_frame"/><joint name="c" type="fixed">'
        '<parent link="camera_link"/><child link="camera_color_frame"/></joint>'
    )
    assert places("GEO018", robot) == [(4, '<origin xyz="0 0 0" rpy="0 0 0"/>')]


@pytest.mark.parametrize(("z", "found"), [(0.0, 1), (0.12, 0)])
def test_a_mesh_as_a_chassis(z: float, found: int, tmp_path: Path) -> None:
    (tmp_path / "base.stl").write_bytes(stl(box((-200, -150, -100), (200, 150, 100))))
    mesh = '<mesh filename="base.stl" scale="0.001 0.001 0.001"/>'
    text = f'<robot name="r">{mounted(f"0 0 {z}")}</robot>'
    (tmp_path / "r.urdf").write_text(text.replace('<box size="0.4 0.3 0.2"/>', mesh))
    report = check(tmp_path / "r.urdf", select=["GEO018"])
    assert (len(report.diagnostics), report.crashed) == (found, ())


def test_a_chassis_that_is_open_above(tmp_path: Path) -> None:
    """A lidar stands in a tub, below its rim, and sees its walls; above it is nothing."""
    from urdfkit.mesh.samples import BOX

    sides = [face for face in BOX if not all(number & 1 for number in face)]
    (tmp_path / "base.stl").write_bytes(stl(box((-0.2, -0.15, -0.1), (0.2, 0.15, 0.1), sides)))
    text = f'<robot name="r">{mounted("0 0 0")}</robot>'
    mesh = '<mesh filename="base.stl"/>'
    (tmp_path / "r.urdf").write_text(text.replace('<box size="0.4 0.3 0.2"/>', mesh))
    assert check(tmp_path / "r.urdf", select=["GEO018"]).diagnostics == ()
