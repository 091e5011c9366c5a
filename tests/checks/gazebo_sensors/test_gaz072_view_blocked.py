"""GAZ072: a planar lidar or a camera sees little but the robot itself."""

from pathlib import Path

import numpy as np
import pytest

from tests.naming import naming
from tests.reported import messages, reported
from urdfkit import Severity, check
from urdfkit.core.spatial import Transform, from_rpy
from urdfkit.robot.ray_casting import Scan, beams_on, intervals
from urdfkit.robot.shapes import Primitive

INERTIAL = """<inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>"""
LIDAR = """<sensor name="s" type="{}"><update_rate>10</update_rate>
<ray><scan><horizontal><samples>{}</samples><min_angle>-3.14159</min_angle>
<max_angle>3.14159</max_angle></horizontal></scan><range><min>0.1</min><max>10</max></range></ray>
</sensor>"""
CAMERA = """<sensor name="s" type="camera"><update_rate>10</update_rate>{}
<camera><horizontal_fov>1</horizontal_fov><clip><near>0.02</near><far>9</far></clip></camera>
</sensor>"""


def robot(sensor: str, shape: str, at: str, tag: str = "visual", own: str = "") -> str:
    """A body with a shape at a place, and a sensor at its origin."""
    body = f"<{tag}><origin {at}/><geometry>{shape}</geometry></{tag}>"
    return f"""<link name="base">{INERTIAL}{body}</link><link name="eye">{own}</link>
<joint name="mount" type="fixed"><parent link="base"/><child link="eye"/></joint>
<gazebo reference="eye">{sensor}</gazebo>"""


WALL = '<box size="0.1 4 0.2"/>'


@pytest.mark.parametrize(
    ("shape", "at", "percent"),
    [
        (WALL, 'xyz="0.5 0 0"', 42),
        (WALL, 'xyz="-0.5 0 0.05"', 42),
        ('<cylinder radius="0.4" length="1"/>', 'xyz="0.5 0 0"', 30),
        ('<sphere radius="0.4"/>', 'xyz="0 -0.5 0"', 30),
        ('<cylinder radius="0.1" length="4"/>', 'xyz="0 0.5 0" rpy="0 1.5708 0"', 43),
    ],
)
@pytest.mark.parametrize(("kind", "tag"), [("gpu_lidar", "visual"), ("ray", "collision")])
def test_beams_end_at_the_robot(shape: str, at: str, percent: int, kind: str, tag: str) -> None:
    (one,) = reported("GAZ072", robot(LIDAR.format(kind, 360), shape, at, tag))
    assert one.message.endswith("the robot itself: at base")
    assert abs(int(one.message.split()[2]) - percent) <= 2
    assert one.severity is (Severity.WARNING if percent > 30 else Severity.INFO)


def test_a_post_is_an_info() -> None:
    post = '<box size="0.2 0.2 1"/>'
    (one,) = reported("GAZ072", robot(LIDAR.format("gpu_lidar", 360), post, 'xyz="0.4 0 0"'))
    assert one.severity is Severity.INFO


@pytest.mark.parametrize(
    ("kind", "tag", "shape", "at"),
    [
        ("gpu_lidar", "visual", WALL, 'xyz="0.5 0 0.2"'),  # below the scan
        ("gpu_lidar", "visual", WALL, 'xyz="20 0 0"'),  # out of range
        ("gpu_lidar", "collision", WALL, 'xyz="0.5 0 0"'),  # not rendered
        ("ray", "visual", WALL, 'xyz="0.5 0 0"'),  # not touched
        ("gpu_lidar", "visual", '<box size="1 1 1"/>', ""),  # seen from inside
        ("gpu_lidar", "visual", '<cylinder radius="0.05" length="1"/>', ""),  # too near
        ("gpu_lidar", "visual", '<box size="0.02 0.02 1"/>', 'xyz="0.5 0 0"'),  # thin
    ],
)
def test_it_sees_past(kind: str, tag: str, shape: str, at: str) -> None:
    assert messages("GAZ072", robot(LIDAR.format(kind, 360), shape, at, tag)) == []


def test_the_rays_of_classic_meet_a_shape_from_inside() -> None:
    text = robot(LIDAR.format("ray", 360), '<box size="1 1 1"/>', "", "collision")
    (one,) = messages("GAZ072", text)
    assert "100 % of its beams" in one


@pytest.mark.parametrize("sides", ["outside", "inside"])
def test_a_mesh(sides: str, tmp_path: Path) -> None:
    """A wall of two triangles in front of the lidar, whose fronts look at it or away."""
    corners = [(0.5, -2, -1), (0.5, -2, 1), (0.5, 2, 1), (0.5, 2, -1)]
    faces = ["1 2 3", "1 3 4"] if sides == "outside" else ["3 2 1", "4 3 1"]
    lines = ["v {} {} {}".format(*corner) for corner in corners] + [f"f {face}" for face in faces]
    (tmp_path / "wall.obj").write_text("\n".join(lines))
    text = robot(LIDAR.format("gpu_lidar", 360), '<mesh filename="wall.obj"/>', "")
    (tmp_path / "r.urdf").write_text(f'<robot name="r">{text}</robot>')
    found = check(tmp_path / "r.urdf", select=["GAZ072"]).diagnostics
    assert [one.message.split()[2] for one in found] == (["42"] if sides == "outside" else [])


@pytest.mark.parametrize(
    ("shape", "at", "pose"),
    [
        ('<box size="0.02 1 1"/>', 'xyz="0.1 0 0"', ""),
        ('<box size="1 1 0.6"/>', 'xyz="-0.6 0 0"', "<pose>0 0 0 0 0 3.14159</pose>"),
        ('<cylinder radius="1" length="0.1"/>', 'xyz="0.2 0 0" rpy="0 1.5708 0"', ""),
    ],
)
def test_a_camera_that_sees_the_robot_alone(shape: str, at: str, pose: str) -> None:
    text = robot(CAMERA.format(pose), shape, at)
    assert messages("GAZ072", text) == [naming("s", "nothing")]


@pytest.mark.parametrize(
    ("shape", "at"),
    [
        ('<box size="0.05 0.05 0.05"/>', ""),  # its housing, from inside
        ('<box size="0.02 0.05 0.05"/>', 'xyz="0.2 0 0"'),  # a part of the image
        ('<box size="0.02 4 4"/>', 'xyz="1 0 0"'),  # farther away
        ('<box size="0.02 1 1"/>', 'xyz="-0.1 0 0"'),  # behind it
    ],
)
def test_a_camera_that_sees_more(shape: str, at: str) -> None:
    assert messages("GAZ072", robot(CAMERA.format(""), shape, at)) == []


def test_a_fisheye_camera_is_not_checked(tmp_path: Path) -> None:
    """As the camera of 183 degrees on a TurtleBot3, in front of the mesh of the base."""
    corners = [(0.1, -1, -1), (0.1, -1, 1), (0.1, 1, 1), (0.1, 1, -1)]
    lines = ["v {} {} {}".format(*corner) for corner in corners]
    (tmp_path / "wall.obj").write_text("\n".join([*lines, "f 3 2 1", "f 4 3 1"]))
    camera = CAMERA.format("").replace("<horizontal_fov>1<", "<horizontal_fov>3.183<")
    text = robot(camera, '<mesh filename="wall.obj"/>', "")
    (tmp_path / "r.urdf").write_text(f'<robot name="r">{text}</robot>')
    report = check(tmp_path / "r.urdf", select=["GAZ072"])
    assert (report.diagnostics, report.crashed) == ((), ())


def test_primitives_agree_with_points_on_their_surfaces() -> None:
    """A ray enters and leaves a shape where points along it begin and end to lie in it."""
    at = Transform(from_rpy(0.3, -0.4, 1.0), (0.6, 0.1, -0.2))
    for shape, inside in (
        (
            Primitive("box", (0.4, 0.6, 0.8), 0.0, 0.0, at),
            lambda x, y, z: abs(x) <= 0.2 and abs(y) <= 0.3 and abs(z) <= 0.4,
        ),
        (
            Primitive("sphere", (0.0, 0.0, 0.0), 0.5, 0.0, at),
            lambda x, y, z: x * x + y * y + z * z <= 0.25,
        ),
        (
            Primitive("cylinder", (0.0, 0.0, 0.0), 0.3, 0.8, at),
            lambda x, y, z: x * x + y * y <= 0.09 and abs(z) <= 0.4,
        ),
    ):
        scan = Scan(-3.0, 3.0, 61, 0.0, 10.0)
        met = set(beams_on(shape, scan, scan.directions, sees_inside=True))
        for number, direction in enumerate(scan.directions):
            places = np.linspace(0, 2, 2001)
            within = [
                t for t in places if inside(*at.inverse.apply(tuple(t * d for d in direction)))
            ]
            (found,) = intervals(shape, [direction])
            if within:
                assert found is not None
                assert max(found[0], 0) == pytest.approx(within[0], abs=2e-3)
                assert found[1] == pytest.approx(within[-1], abs=2e-3)
                assert number in met
