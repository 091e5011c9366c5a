"""Which descriptions are whole robots, and which are parts of others."""

from pathlib import Path

import pytest

from tests.lint.directories import include, names, write
from tests.xacros import HEAD
from urdfkit import check
from urdfkit.lint.config import Config
from urdfkit.lint.discovery import discover
from urdfkit.workspace.resolve import Resolver

ARM = '<link name="arm"/><xacro:arg default="1" name="scale"/><joint name="$(arg scale)"/>'


def test_of_files_that_include_each_other_one_is_checked_and_tells_of_the_ring(tmp_path):
    write(tmp_path, "a.xacro", include("b.xacro") + '<link name="a"/>')
    write(tmp_path, "b.xacro", include("c.xacro"))
    write(tmp_path, "c.xacro", include("b.xacro") + include("a.xacro"))
    write(tmp_path, "whole.xacro", '<link name="whole"/>')
    assert names(discover(str(tmp_path), Config(), Resolver())) == ["a.xacro", "whole.xacro"]
    report = check(tmp_path)
    assert [found.code for found in report.diagnostics if found.severity.value == "error"] != []


@pytest.mark.parametrize(
    ("declared", "expected"),
    [
        ("", ["arm.xacro", "sim.xacro"]),
        ('<xacro:arg name="sim"/>', ["arm.xacro", "sim.xacro"]),
        ('<xacro:arg name="sim" default="true"/>', ["sim.xacro"]),
        ('<xacro:arg default="" name="sim"/>', ["sim.xacro"]),
    ],
)
def test_a_whole_robot_in_one_that_needs_arguments(
    tmp_path: Path, declared: str, expected: list[str]
):
    write(tmp_path, "arm.xacro", ARM + include("rod.xacro"))
    write(tmp_path, "rod.xacro", '<xacro:macro name="rod"/>')
    write(tmp_path, "sim.xacro", f'{declared}{include("arm.xacro")}<link name="$(arg sim)"/>')
    assert names(discover(str(tmp_path), Config(), Resolver())) == expected


def test_parts_of_a_robot_that_needs_arguments_stay_parts(tmp_path: Path):
    write(tmp_path, "part.xacro", '<link name="$(arg prefix)_part"/>')
    (tmp_path / "nameless.xacro").write_text('<robot><link name="x"/></robot>')
    body = include("part.xacro") + include("nameless.xacro") + '<link name="$(arg prefix)"/>'
    write(tmp_path, "whole.xacro", body)
    assert names(discover(str(tmp_path), Config(), Resolver())) == ["whole.xacro"]


@pytest.mark.parametrize(
    ("name", "parent", "is_part"),
    [
        ("arm", "base", True),
        ("base", "base", False),
        ("${x}", "base", False),
        ("arm", "${x}", False),
    ],
)
def test_a_xacro_without_a_name_is_a_part_if_a_parent_is_certainly_elsewhere(
    tmp_path: Path, name: str, parent: str, is_part: bool
):
    write(tmp_path, "whole.xacro", '<link name="base"/>')
    ends = f'<parent link="{parent}"/><child link="arm"/>'
    body = f'<link name="{name}"/><joint name="j" type="fixed">{ends}</joint>'
    nameless = f"{HEAD}{body}</robot>".replace(' name="r"', "")
    (tmp_path / "part.xacro").write_text(nameless)
    found = names(discover(str(tmp_path), Config(), Resolver()))
    assert found == (["whole.xacro"] if is_part else ["part.xacro", "whole.xacro"])


@pytest.mark.parametrize("name", ["r.gazebo", "r.xml", "r.model", "r.srdf.xacro"])
def test_a_robot_of_a_macro_call_with_an_unusual_suffix(tmp_path: Path, name: str) -> None:
    """Its links stand in the macro. An SRDF is no robot, a file of tags is a part."""
    write(tmp_path, "m.xacro", '<xacro:macro name="b"><link name="a"/></xacro:macro>')
    write(tmp_path, name, include("m.xacro") + "<xacro:b/>")
    write(tmp_path, "part.gazebo", '<gazebo reference="a"/>')
    write(tmp_path, "whole.urdf", '<link name="whole"/>')
    found = discover(str(tmp_path), Config(), Resolver())
    others = {Path(path).name for path in found.others}
    assert others == ({name, "m.xacro"} if "srdf" not in name else {"m.xacro"})
    (tmp_path / "a.launch").write_text(f'<launch><param textfile="{name}"/></launch>')
    found = discover(str(tmp_path), Config(), Resolver())
    is_robot = "srdf" not in name
    assert names(found) == sorted({"whole.urdf", *([name] if is_robot else [])})
    assert set(found.others) == (set() if is_robot else {str(tmp_path / "m.xacro")})
