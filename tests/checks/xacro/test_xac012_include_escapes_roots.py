from __future__ import annotations

from pathlib import Path

import pytest

from tests.xacros import reported, told_of, write
from urdfkit.lint import engine


def package(folder: Path, name: str) -> Path:
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(f"<package><name>{name}</name></package>")
    return folder


@pytest.mark.parametrize(
    "body",
    [
        '<xacro:include filename="/etc/hostname"/>',
        "<link name=\"${xacro.load_yaml('/etc/hostname')}\"/>",
    ],
)
def test_a_file_of_the_machine(body: str) -> None:
    (found,) = reported("XAC012", body)
    assert found.message.endswith("is outside the workspace and the packages of this model")
    assert "/etc/hostname" in found.span.text


def test_a_device() -> None:
    (found,) = reported("XAC012", '<xacro:include filename="/dev/zero"/>')
    assert found.message == "/dev/zero is no file but a device or a pipe"


def test_a_link_that_leads_outside(tmp_path: Path) -> None:
    folder = package(tmp_path / "ws" / "arm", "arm")
    (folder / "inner.xacro").symlink_to("/etc/hostname")
    write(folder, robot='<xacro:include filename="inner.xacro"/><link name="a"/>')
    (found,) = told_of("XAC012", folder / "robot.xacro")
    assert found.span.text == "inner.xacro"


def test_a_file_that_does_not_exist_is_missing_wherever_it_is() -> None:
    assert reported("XAC012", '<xacro:include filename="/home/bob/ws/arm.xacro"/>') == []
    (found,) = reported("XAC001", '<xacro:include filename="/home/bob/ws/arm.xacro"/>')
    assert found.message == "file not found: /home/bob/ws/arm.xacro"


def test_trusted(tmp_path: Path) -> None:
    outside = tmp_path / "outside.xacro"
    write(tmp_path, outside='<link name="a"/>')
    folder = package(tmp_path / "a" / "b" / "c" / "d" / "arm", "arm")
    write(folder, robot=f'<xacro:include filename="{outside}"/>')
    assert len(told_of("XAC012", folder / "robot.xacro")) == 1
    assert engine.check(folder / "robot.xacro", select=["XAC"], trust=True).diagnostics == ()


def test_a_neighbour_of_the_package(tmp_path: Path) -> None:
    folder = package(tmp_path / "ws" / "arm", "arm")
    write(package(tmp_path / "ws" / "common", "common"), part='<link name="a"/>')
    write(folder, robot='<xacro:include filename="../common/part.xacro"/>')
    assert told_of("XAC012", folder / "robot.xacro") == []
