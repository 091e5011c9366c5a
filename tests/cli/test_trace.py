"""The trace command: from a value back to the number that somebody wrote."""

from pathlib import Path

import pytest

from urdfkit.cli import main

ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="half" value="0.5"/>
  <xacro:macro name="ball" params="name mass colour:=red note:=''">
    <link name="${name}"><inertial><mass value="${2*mass}"/></inertial></link>
  </xacro:macro>
  <xacro:ball name="a" mass="${half}" note="%s"/>
</robot>
"""


def trace(
    directory: Path, capsys: pytest.CaptureFixture[str], address: str, note: str = ""
) -> list[str]:
    file = directory / "r.xacro"
    file.write_text(ROBOT % note, encoding="utf-8")
    assert main(["trace", str(file), address]) == 0
    return capsys.readouterr().out.replace(str(file), "FILE").splitlines()


def test_a_value_is_traced_through_arguments_to_a_property(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert trace(tmp_path, capsys, "link/a/inertial/mass@value") == [
        "link/a/inertial/mass@value = 1.0",
        '  FILE:4:49  value="${2*mass}"',
        "    mass = 0.5  (argument)  FILE:6:30",
        "        ${half}",
        "      half = 0.5  (property)  FILE:2:38",
        '  called at FILE:6:3  <xacro:ball name="a" mass="${half}" note=""/>',
    ]


def test_a_parameter_from_outside_of_the_macro(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The hand of qbrobotics, whose macros pass values on by their names alone."""
    (tmp_path / "hand.yaml").write_text("thumb:\n  mass: 3\n")
    file = tmp_path / "r.xacro"
    file.write_text(
        """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="hand" value="${xacro.load_yaml('hand.yaml')}"/>
  <xacro:macro name="body" params="mass:=^ name:=^|none">
    <link name="${name}"><inertial><mass value="${mass}"/></inertial></link>
  </xacro:macro>
  <xacro:macro name="part" params="name mass:=^|5">
    <xacro:body/>
  </xacro:macro>
  <xacro:part name="thumb" mass="${hand['thumb']['mass']}"/>
  <xacro:part name="palm"/>
</robot>
"""
    )
    for name, source in (("thumb", "hand.yaml:2:9"), ("palm", "r.xacro:10:3")):
        assert main(["trace", str(file), f"link/{name}/inertial/mass@value"]) == 0
        assert source in capsys.readouterr().out


def test_a_call_with_many_arguments_is_cut(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (*_, last) = trace(tmp_path, capsys, "link/a", note="long " * 100)
    assert last.startswith('  called at FILE:6:3  <xacro:ball name="a" mass="${half}" note="long ')
    assert last.endswith("...")
    assert len(last) < 130


@pytest.mark.parametrize("address", ["link/b", "link/a@nothing"])
def test_an_unknown_element_is_reported(
    address: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "r.xacro"
    file.write_text(ROBOT % "", encoding="utf-8")
    assert main(["trace", str(file), address]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("error: ")


def test_the_name_of_a_link_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "r.xacro"
    file.write_text(ROBOT % "", encoding="utf-8")
    assert main(["trace", str(file), "a"]) == 2
    assert "did you mean 'link/a'?" in capsys.readouterr().err


def test_another_format_lacks_no_element(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "m.sdf"
    file.write_text('<sdf version="1.9"><model name="m"/></sdf>')
    assert main(["trace", str(file), "link/base"]) == 2
    assert "m.sdf: the root element is <sdf>, not <robot>" in capsys.readouterr().err
    assert main(["trace", str(file), "model/m"]) == 0
