"""Findings in a picture: the links that they concern stand out."""

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

from tests.conftest import MODELS
from urdfkit.lint.engine import check
from urdfkit.lint.loading import read
from urdfkit.render import build, marked
from urdfkit.render.findings import COLOURS, QUIET, by_link
from urdfkit.text.diagnostic import Severity

MODEL = MODELS / "gazebo_pkg" / "urdf" / "waking_robot_new.xacro"


def test_links_have_the_colour_of_their_worst_finding_and_its_codes() -> None:
    robot = read(MODEL)
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
    robot = read(MODEL)
    report = check(robot.source, select=["MSH001", "GAZ045"])
    reported = by_link(robot, report.diagnostics)["laser_frame"]
    assert [one.code for one in reported] == ["MSH001"]  # GAZ045 is an info


def test_a_sound_robot_is_quiet() -> None:
    robot = read(MODELS / "good" / "gripper.urdf")
    scene = marked(build(robot), robot, check(robot.source).diagnostics)
    assert {item.material.rgba for item in scene.items} == {QUIET}
    assert scene.labels == ()
