"""What a check of the mission's model finds: every finding by code and place, and nothing else."""

import os
from importlib.util import find_spec

import pytest

from tests.conftest import MODELS
from urdfkit import Diagnostic, Report, check
from urdfkit.lint import rule_index

PACKAGE = MODELS / "gazebo_pkg"
MODEL = PACKAGE / "urdf" / "waking_robot_new.xacro"
LAUNCH = PACKAGE / "launch" / "view_waking_robot.launch"

#: Code, severity, line, column, number of calls.
FINDINGS = [
    ("XAC004", "warning", 8, 3, 1),
    ("XAC007", "info", 9, 3, 1),
    ("XAC014", "warning", 12, 3, 1),
    ("INE006", "warning", 15, 7, 5),
    ("INE008", "info", 15, 7, 1),
    ("GEO002", "info", 25, 5, 1),
    ("TRE008", "warning", 46, 3, 1),
    ("GEO004", "warning", 63, 5, 1),
    ("URD008", "warning", 88, 5, 1),
    ("URD008", "warning", 89, 5, 1),
    ("URD008", "warning", 109, 5, 1),
    ("URD008", "warning", 110, 5, 1),
    ("URD008", "warning", 130, 5, 1),
    ("URD008", "warning", 131, 5, 1),
    ("URD008", "warning", 151, 5, 1),
    ("URD008", "warning", 152, 5, 1),
    ("GAZ029", "info", 158, 3, 1),
    ("JNT002", "info", 158, 3, 1),
    ("URD001", "warning", 167, 5, 1),
    ("JNT002", "info", 174, 3, 1),
    ("JNT002", "info", 181, 3, 1),
    ("JNT020", "info", 190, 5, 1),
    ("INE008", "info", 215, 7, 1),
    ("JNT020", "info", 220, 5, 1),
    ("INE008", "info", 245, 7, 1),
    ("JNT020", "info", 252, 5, 1),
    ("MSH001", "error", 266, 25, 1),
    ("INE008", "info", 272, 7, 1),
    ("GEO009", "info", 278, 5, 1),
    ("GEO009", "info", 281, 5, 1),
    ("GEO009", "info", 287, 5, 1),
    ("GAZ045", "info", 320, 13, 1),
    ("GAZ030", "info", 337, 9, 1),
    ("GAZ030", "info", 369, 9, 1),
    ("JNT030", "info", 371, 9, 1),
    ("GAZ016", "info", 385, 7, 1),
    ("GAZ030", "info", 386, 7, 1),
    ("GAZ030", "info", 387, 7, 1),
    ("RCT029", "warning", 390, 7, 1),
    ("GEO009", "info", 396, 5, 1),
    ("GAZ030", "info", 404, 9, 1),
    ("GAZ016", "info", 405, 9, 1),
]
#: Found where coal is installed, else skipped.
HAS_COAL = find_spec("coal") is not None
if HAS_COAL:
    FINDINGS = sorted(
        [*FINDINGS, *(("COL001", "info", line, 5, 1) for line in (83, 104, 125, 146))],
        key=lambda row: (row[2], row[3], row[0]),
    )


@pytest.fixture(scope="module")
def report() -> Report:
    return check(MODEL)


def found(report: Report, code: str) -> list[Diagnostic]:
    return [diagnostic for diagnostic in report.diagnostics if diagnostic.code == code]


def placed(report: Report) -> list[tuple[str, str, int, int, int]]:
    return [
        (d.code, d.severity.value, d.span.line, d.span.column, len(d.calls))
        for d in report.diagnostics
    ]


def test_every_finding_is_at_its_place_and_there_is_no_other(report: Report) -> None:
    assert placed(report) == FINDINGS
    skipped = set() if HAS_COAL else rule_index.of_family("collision")
    assert {skip.code for skip in report.skipped} == skipped
    assert report.crashed == ()
    assert {d.span.source.path for d in report.diagnostics} == {str(MODEL)}


def test_the_missing_mesh_is_reported_with_the_directories_searched(report: Report) -> None:
    (mesh,) = found(report, "MSH001")
    assert "package://gazebo_pkg/meshes/hokuyo.dae" in mesh.message
    assert os.path.relpath(PACKAGE / "meshes" / "hokuyo.dae") in mesh.message
    assert mesh.span.text == "package://gazebo_pkg/meshes/hokuyo.dae"
    assert mesh.element == "link/laser_frame/visual/geometry/mesh@filename"


def test_one_macro_is_one_finding_with_five_calls_worst_first(report: Report) -> None:
    (inertia,) = found(report, "INE006")
    assert [call.element.split("/")[1] for call in inertia.calls] == [
        "base_footprint", "wheel_1", "wheel_2", "wheel_3", "wheel_4",
    ]  # fmt: skip
    assert [call.via[-1].span.line for call in inertia.calls] == [31, 91, 112, 133, 154]
    assert all(call.via[-1].name == "default_inertial" for call in inertia.calls)
    assert "31.6 m" in inertia.calls[0].message  # the radius of gyration
    assert "47.3 times" in inertia.calls[1].message


@pytest.mark.skipif(not HAS_COAL, reason="coal is not installed")
def test_the_wheels_are_deep_in_the_chassis(report: Report) -> None:
    wheels = found(report, "COL001")
    assert [wheel.element for wheel in wheels] == [
        f"link/wheel_{number}/collision" for number in (1, 2, 3, 4)
    ]
    assert all("'base_link' by 45 mm" in wheel.message for wheel in wheels)


def test_the_macro_behind_it_is_reported_with_the_links(report: Report) -> None:
    (macro,) = found(report, "XAC014")
    assert "6 links of 0.0001 to 8.2 kg" in macro.message
    assert [related.span.line for related in macro.related] == [31, 68, 91, 112, 133, 154]


def test_the_collision_box_has_a_fifth_in_common_with_the_visual(report: Report) -> None:
    (box,) = found(report, "GEO004")
    assert "20%" in box.message
    assert box.element == "link/base_link/collision"


def test_the_footprint_is_six_centimetres_above_the_ground(report: Report) -> None:
    (footprint,) = found(report, "TRE008")
    assert "0.06 m below" in footprint.message
    assert footprint.element == "joint/base_footprint_joint"


def test_the_generation_of_gazebo_is_inferred_and_said_once(report: Report) -> None:
    ((path, targets),) = report.targets
    assert path == str(MODEL)
    assert targets.names == ("ros1", "classic-ros1")
    assert any("libgazebo_ros" in evidence for evidence in targets.evidence)


def test_other_generations_miss_their_plugins() -> None:
    ros2 = check(MODEL, targets=["classic-ros2"], select=["GAZ012", "GAZ016", "GAZ040"])
    (laser,) = found(ros2, "GAZ012")
    assert laser.severity.value == "error"
    assert "libgazebo_ros_laser.so" in laser.message
    assert "libgazebo_ros_ray_sensor.so" in laser.help
    assert {d.severity.value for d in found(ros2, "GAZ016")} == {"warning", "info"}
    assert found(ros2, "GAZ040") == []
    gz = check(MODEL, targets=["gz-harmonic"], select=["GAZ012", "GAZ040"])
    assert [d.severity.value for d in found(gz, "GAZ012")] == ["error"] * 4
    assert [d.span.text for d in found(gz, "GAZ040")] == ["ray"]


def test_the_launch_file_misses_its_rviz_configuration() -> None:
    report = check(LAUNCH)
    (missing,) = [d for d in report.diagnostics if d.span.source.path == str(LAUNCH)]
    assert missing.code == "LAU003"
    assert "test.rviz" in missing.message
    assert "-d $(find gazebo_pkg)/rviz/test.rviz" in missing.span.text
    others = [d for d in report.diagnostics if d is not missing]
    assert [(d.code, d.span.line) for d in others] == [(row[0], row[2]) for row in FINDINGS]
    assert {d.calls[0].via[0].kind for d in others if d.calls[0].via} == {"launch"}
