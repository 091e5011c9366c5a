"""What lies next to a repository decides nothing: no finding, no fix, no package."""

from pathlib import Path

import pytest

from tests.workspaces import add_file
from urdfkit.cli import main

ROBOT = b"""<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find parts)/urdf/parts.xacro"/>
  <link name="base_link">
    <visual><geometry><mesh filename="package://arm_description/meshes/base.stl"/></geometry></visual>
    <visual><geometry><mesh filename="package://hand/meshes/palm.stl"/></geometry></visual>
  </link>
</robot>
"""
PLAIN = b"""<robot name="p">
  <link name="base_link">
    <visual><geometry><mesh filename="package://hand/meshes/Palm.stl"/></geometry></visual>
    <visual><geometry><mesh filename="package://arm_description/meshes/base.stl"/></geometry></visual>
    <visual><geometry><mesh filename="package://hnad/meshes/base.stl"/></geometry></visual>
  </link>
  <gazebo><plugin name="x" filename="libgazebo_ros_p3d.so"/></gazebo>
</robot>
"""
#: Three files that start Gazebo without a word about its model path, for PKG004.
LAUNCH = b'<launch><include file="$(find gazebo_ros)/launch/empty_world.launch"/></launch>'


def _package(directory: Path, name: str, more: str = "") -> Path:
    text = f'<package format="2"><name>{name}</name>{more}</package>'
    add_file(directory / "package.xml", text.encode())
    return directory


def _repository(directory: Path, mark: str) -> None:
    package = directory if mark == "package" else directory / "arm_description"
    _package(package, "arm_description")
    add_file(package / "urdf" / "r.urdf.xacro", ROBOT)
    add_file(package / "urdf" / "p.urdf", PLAIN)
    add_file(package / "launch" / "gazebo.launch", LAUNCH)
    if mark != "package":
        add_file(directory / mark)


def _neighbours(around: Path) -> None:
    export = '<export><gazebo_ros gazebo_model_path="${prefix}/.."/></export>'
    hand = _package(around / "hands" / "hand", "hand", export)
    add_file(hand / "meshes" / "palm.stl", b"solid x\nendsolid x\n")
    _package(around / "hands" / "foot", "foot")
    _package(around / "arm_description", "arm_description")
    _package(around / "parts", "parts")
    add_file(around / "parts" / "urdf" / "parts.xacro", b"<robot><link name='part'/></robot>")
    moveit = _package(around / "arm_moveit_config", "arm_moveit_config")
    add_file(moveit / "config" / "p.srdf", b"<robot name='p'><group name='g'/></robot>")
    add_file(around / "hand" / "meshes" / "palm.stl")


@pytest.mark.parametrize("mark", [".git/HEAD", "LICENSE", "package"])
def test_alone_and_beside_four_others(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    mark: str,
) -> None:
    clones = tmp_path / "clones"
    _repository(clones / "arm", mark)
    monkeypatch.chdir(clones / "arm")

    def reports() -> list[str]:
        """All that is printed, with the exit code."""
        runs = []
        for command in ("check .", "check . --format json", "fix . --diff --unsafe-fixes"):
            code = main(command.split())
            runs.append(f"{code} {capsys.readouterr().out}")
        return runs

    alone = reports()
    assert "hand" in alone[0]
    _neighbours(clones)
    assert reports() == alone
