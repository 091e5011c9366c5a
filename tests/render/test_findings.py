"""Findings in an image: the links that they concern stand out."""

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

from tests.conftest import GRIPPER, MISSION
from urdfkit.lint.engine import check
from urdfkit.lint.loading import read
from urdfkit.render import build, labels, marked
from urdfkit.render.camera import place_camera
from urdfkit.render.findings import COLOURS, QUIET, by_link
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source


def test_links_have_the_colour_of_their_worst_finding_and_its_codes() -> None:
    robot = read(MISSION)
    report = check(robot.source, select=["INE006", "URD001", "MSH001", "GEO004", "JNT020"])
    scene = marked(build(robot), robot, report.diagnostics)
    colour = {
        item.link: item.material.rgba for item in scene.items if item.material.texture is None
    }
    assert colour["wheel_1"] == colour["base_link"] == COLOURS[Severity.WARNING]
    assert colour["imu_link"] == QUIET  # its JNT020 is an info
    labels = {label.link: label.text for label in scene.labels}
    assert labels["laser_frame"] == "MSH001"
    assert labels["wheel_2"] == "INE006 URD001"  # of its joint
    assert labels["base_link"] == "GEO004"
    assert "imu_link" not in labels
    assert [word for _, word in scene.legend] == ["error", "warning"]
    (missing,) = (item for item in scene.items if item.material.texture is not None)
    assert missing.link == "laser_frame"
    assert missing.material.rgba == COLOURS[Severity.ERROR]  # and keeps its stripes


def test_an_error_wins_over_a_warning() -> None:
    robot = read(MISSION)
    report = check(robot.source, select=["MSH001", "GAZ045"])
    reported = by_link(robot, report.diagnostics)["laser_frame"]
    assert [one.code for one in reported] == ["MSH001"]  # GAZ045 is an info


def test_a_sound_robot_is_quiet() -> None:
    robot = read(GRIPPER)
    scene = marked(build(robot), robot, check(robot.source).diagnostics)
    assert {item.material.rgba for item in scene.items} == {QUIET}
    assert scene.labels == ()


def test_a_label_stands_where_its_link_is_seen() -> None:
    """From the left, the wheels of the right side cannot be seen, nor a speck in the box."""
    robot = read(MISSION)
    scene = marked(build(robot), robot, check(robot.source, select=["INE006"]).diagnostics)
    camera = place_camera(scene.points(), "left", size=(640, 360), orthographic=True)
    seen = labels._links_of_pixels(scene, camera)
    assert {"wheel_1", "wheel_2", "base_link"} <= set(seen)
    assert not {"wheel_3", "wheel_4", "base_footprint"} & set(seen)
    x, y, text = labels._where_seen(0, 0, "INE006", seen["wheel_1"])
    assert [x, y] in seen["wheel_1"].tolist()
    assert text == "INE006"
    assert labels._where_seen(1, 2, "INE006", None) == (1, 2, "INE006 (hidden)")


SENSORS = """<robot name="r">
<link name="base"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
{}</robot>"""
SENSOR = """<link name="{0}"><inertial><mass value="{1}"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="{0}_joint" type="fixed"><parent link="base"/><child link="{0}"/>
<origin xyz="{2} 0 0"/></joint>"""


def test_links_without_geometry_are_balls_with_one_label_for_each_text() -> None:
    sensors = "".join(SENSOR.format(f"s{n}", -1 if n < 3 else 0, n / 10) for n in range(5))
    robot = read(Source("r.urdf", SENSORS.format(sensors).encode()))
    report = check(robot.source, select=["INE001"])
    assert len(report.diagnostics) == 3
    scene = marked(build(robot), robot, report.diagnostics)
    assert [label.text for label in scene.labels] == ["INE001 (3 links, no geometry)"]
    balls = [item for item in scene.items if item.role == "findings"]
    assert [item.link for item in balls] == ["s0", "s1", "s2"]
    assert {item.material.rgba for item in balls} == {COLOURS[Severity.ERROR]}
    assert all(item.material.overlay for item in balls)
    assert max(abs(scene.points()).max(axis=0)) == pytest.approx(0.5)  # they do not move the camera


def test_a_link_without_geometry_is_not_called_hidden() -> None:
    source = Source("r.urdf", b'<robot name="r"><link name="a"/><link name="b"/></robot>')
    robot = read(source)
    report = check(source, select=["TRE002"])
    (label,) = marked(build(robot), robot, report.diagnostics).labels
    assert not label.of_link
    assert label.text == "TRE002 (no geometry)"
