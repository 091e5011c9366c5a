"""The info command: one page, or JSON."""

import json
import os
from pathlib import Path

import pytest

from tests.conftest import MODELS
from tests.shipped import ARM, MISSION
from tests.xacros import write
from urdfkit.cli import main


def test_the_page_fits_a_terminal_and_has_the_facts(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", MISSION]) == 0
    page = capsys.readouterr().out
    assert "(nq 8, nv 4)" in page
    assert "10.2301 kg in 9 of 10 links" in page
    assert max(map(len, page.splitlines())) <= 80
    assert "reach" not in page  # of wheels


def test_a_pose_moves_the_centre(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", ARM, "--format", "json", "--joint", "shoulder=90deg"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["mass"]["center"][0] == pytest.approx((1.5 * 0.15 + 0.7 * 0.485) / 5.2)
    assert document["pose"] == {"shoulder": pytest.approx(1.5707963267948966)}


def test_a_pose_beyond_the_limits_is_used_and_reported(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", ARM, "--joint", "elbow=2"]) == 0
    captured = capsys.readouterr()
    assert captured.err == "note: joint 'elbow' at 2 rad is outside its limits -1.9 to 1.9 rad\n"
    assert "at the given pose" in captured.out


def test_many_sensors_and_plugins_are_counted_by_type(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sensors = "".join(
        f'<gazebo reference="a"><sensor name="s{n}" type="contact">'
        f'<plugin name="p{n}" filename="libx.so"/></sensor></gazebo>'
        for n in range(12)
    )
    loop = (
        '<link name="b"/><joint name="ab" type="fixed"><parent link="a"/><child link="b"/></joint>'
        '<joint name="ba" type="fixed"><parent link="b"/><child link="a"/></joint>'
    )
    file = tmp_path / "r.urdf"
    file.write_text(f'<robot name="r"><link name="a"/>{sensors}{loop}</robot>')
    assert main(["info", str(file)]) == 0
    page = capsys.readouterr().out
    assert "sensors     12 contact: s0, s1, s2, s3, s4, s5, s6, s7 and 4 more\n" in page
    assert "plugin      libx.so: p0, p1, p2, p3, p4, p5, p6, p7 and 4 more\n" in page
    assert "links       2, 0 roots\n" in page


def test_a_repeated_name_is_listed_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plugins = '<plugin name="same" filename="libx.so"/><plugin name="other" filename="libx.so"/>'
    text = f'<robot name="r"><link name="a"/><gazebo>{plugins * 4}</gazebo></robot>'
    (tmp_path / "r.urdf").write_text(text, encoding="utf-8")
    assert main(["info", str(tmp_path / "r.urdf")]) == 0
    assert "plugin      libx.so: same (4x), other (4x)\n" in capsys.readouterr().out


def test_a_corner_within_rounding_is_zero(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    box = '<origin xyz="0.1 0.1 0.0500000000001"/><geometry><box size="0.2 0.2 0.1"/></geometry>'
    text = f'<robot name="r"><link name="a"><visual>{box}</visual></link></robot>'
    (tmp_path / "r.urdf").write_text(text, encoding="utf-8")
    assert main(["info", str(tmp_path / "r.urdf")]) == 0
    assert "0.2 x 0.2 x 0.1 m, from 0 0 0 to 0.2 0.2 0.1\n" in capsys.readouterr().out


def test_a_number_is_in_the_line_of_its_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """walkman's masses had 'LHipMot' at the end of a line and '3.796' in the next."""
    inertial = '<inertial><mass value="1.25"/><inertia ixx="1" iyy="1" izz="1"/></inertial>'
    links = "".join(f'<link name="{"n" * number}">{inertial}</link>' for number in range(5, 13))
    joints = "".join(
        f'<joint name="j{number}" type="fixed"><parent link="nnnnn"/>'
        f'<child link="{"n" * number}"/></joint>'
        for number in range(6, 13)
    )
    file = tmp_path / "r.urdf"
    file.write_text(f'<robot name="r">{links}{joints}</robot>')
    assert main(["info", str(file)]) == 0
    lines = capsys.readouterr().out.split("\n")
    rows = [line.strip() for line in lines if "nnn" in line and "1.25" in line]
    assert len(rows) > 1
    assert all(row.rstrip(",").endswith(" 1.25") for row in rows)


def test_an_unreadable_robot_is_reported_with_the_reason(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "r.xacro"
    file.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<link name="${nothing}"/><link name="${less}"/></robot>',
        encoding="utf-8",
    )
    assert main(["info", str(file)]) == 2
    reported = capsys.readouterr().err
    assert reported.startswith(f"error: {file}:1:")
    assert "'nothing'" in reported
    assert reported.endswith(f"; see 'urdfkit check {file}', which reports 1 finding more\n")


def test_of_a_part_only_the_robot_is_suggested(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write(tmp_path, robot='<xacro:include filename="part.xacro"/>', part='<link name="${side}"/>')
    assert main(["info", str(tmp_path / "part.xacro")]) == 2
    reported = capsys.readouterr().err
    assert reported.endswith(f"urdfkit check {tmp_path / 'robot.xacro'}\n")
    assert reported.count("urdfkit check") == 1


@pytest.mark.parametrize(
    ("words", "reported"),
    [
        (["no.urdf"], "no.urdf"),
        ([ARM, ARM], "expected one file"),
        (
            [ARM, "--joint", "elbow"],
            "--joint elbow: expected NAME=VALUE: the joint and its position",
        ),
        ([ARM, "--joint", "elbwo=1"], "did you mean 'elbow'?"),
        ([ARM, "--pose", "ready"], "no pose file 'ready'"),
    ],
)
def test_usage_errors(words: list[str], reported: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", *words]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert reported in captured.err


def test_the_first_error_is_reported_not_an_earlier_warning(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "robot.xacro"
    file.write_text(
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">\n'
        '<xacro:property name="pi" value="3"/><link name="${x}"/></robot>'
    )
    assert main(["info", str(file)]) == 2
    reported = capsys.readouterr().err
    assert "name 'x' is not defined" in reported
    assert "more" not in reported


def test_robots_of_a_directory_are_suggested(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["info", str(MODELS / "good" / "two_link_arm")]) == 2
    reported = capsys.readouterr().err
    assert f"is a directory; pass one of its robots: {os.path.relpath(ARM)}\n" in reported
    assert main(["info", str(tmp_path)]) == 2
    assert capsys.readouterr().err.endswith("is a directory; pass a robot file\n")


@pytest.mark.parametrize(
    ("given", "note"),
    [
        ("prefx:=a_", "argument 'prefx'; did you mean 'prefix'?"),
        ("colour:=red", "argument 'colour'\n"),
        ("prefix:=a_", ""),
        ("side:=left", ""),
    ],
)
def test_an_unknown_argument_is_reported(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], given: str, note: str
) -> None:
    robot = tmp_path / "r.xacro"
    robot.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:arg name="prefix" default=""/><link name="$(arg prefix)a"/>'
        '<xacro:if value="0"><link name="$(arg side)"/></xacro:if></robot>'
    )
    assert main(["info", str(robot), given]) == 0
    reported = capsys.readouterr().err
    assert note in reported
    assert bool(note) == bool(reported)
    assert main(["check", str(robot), given, "--select", "XML"]) == 0
    out = capsys.readouterr().out
    assert note in out
    assert bool(note) == ("No robot here has an argument" in out)


def test_another_format_is_not_a_robot(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "world.sdf").write_text('<sdf version="1.8"><world name="w"/></sdf>')
    assert main(["info", str(tmp_path / "world.sdf")]) == 2
    assert "the root element is <sdf>, not <robot>" in capsys.readouterr().err
